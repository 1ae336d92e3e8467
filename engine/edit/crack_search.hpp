// Search for rigid bodies that crack, at the border of a step.
//
// The forces in a section (readings/section_forces.hpp) give a linear normal stress over its length and a mean shear
// stress. They are compared with the strengths of a contact law with a bond. The edges have its tensile strength and
// its compressive strength, if it has one. The mean shear stress has its shear strength at the mean normal stress.
//
// Sections far from their strength are not computed at every step: see CrackWatch. A body is computed again when the
// forces on its surface have grown by a quarter, or by more far from its strength. It is computed at the latest after a
// number of steps that falls with the share of its strength used. The watch is saved with a run, so that a restarted
// run computes the same bodies.
#pragma once

#include <vector>

#include "model/crack_planes.hpp"
#include "model/event.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// The largest share of a strength that a section uses.
struct SectionUse {
  double share = 0;  ///< 1 at the strength
  JointMode mode{};
  double stress = 0;  ///< of this mode [Pa]
  double at = 0;      ///< place of this stress from the middle of the section, to the left of its normal [m]
};

/// Normal force and moment give a linear stress over `length` [m] times `depth` [m].
SectionUse section_use(const ContactLaw& law, double normal, double shear, double moment, double length, double depth);

/// A body that cracks now.
template <int D>
struct Crack {
  int body = -1, section = -1;  ///< the section is an index into CrackingBody::sections
  JointMode mode{};
  double stress = 0;                         ///< [Pa]
  Vec<D> place = Vec<D>::Zero();             ///< where it begins [m]
  double normal = 0, shear = 0, moment = 0;  ///< in the plane: its PlaneForces [N], [N], [N m]
};

/// For restart files, see base/bytes.hpp.
template <class File>
void each_field(File& file, Crack<2>& c) {
  file.item(c.body), file.item(c.section), file.item(c.mode), file.item(c.stress);
  file.item(c.place.x()), file.item(c.place.y()), file.item(c.normal), file.item(c.shear), file.item(c.moment);
}
/// No body in space has planes yet.
template <class File>
void each_field(File& /*file*/, Crack<3>& /*c*/) {}

template <int D>
struct CrackSearch {
  std::vector<Crack<D>> cracks;   ///< at most one for each body, in the order of bodies
  std::vector<CrackWatch> watch;  ///< the new Cracking::watch
};

/// `work` must be evaluated at the present instant. Changes nothing.
CrackSearch<2> search_cracks(const Model<2>& model, const State<2>& state, const Work<2>& work,
                             const Cracking<2>& cracking);
CrackSearch<3> search_cracks(const Model<3>& model, const State<3>& state, const Work<3>& work,
                             const Cracking<3>& cracking);

}  // namespace trilith
