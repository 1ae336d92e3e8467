// Search for bodies that crack, at the border of a step.
//
// The forces in a section (readings/section_forces.hpp) give a linear normal stress over its length and a mean shear
// stress. They are compared with the strengths of a contact law with a bond. The edges, in space the corners, have its
// tensile strength and its compressive strength, if it has one. The mean shear stress has its shear strength at the
// mean normal stress.
//
// Sections far from their strength are not computed at every step: see CrackWatch. A body is computed again when the
// sum of the forces on its surface has risen or fallen by a limit. The limit is half of the force that can use up the
// rest of the strength of its weakest section, pulled or bent. So a body in compression is computed again before it is
// pulled. It is computed at the latest after a number of steps that falls with the share of its strength used. The
// watch is saved with a run, so that a restarted run computes the same bodies.
//
// A mesh is compared at every step: its section needs the elements next to it alone (edit/mesh_section.hpp).
//
// A load path looks for a share of the strength below 1, because it divides a body before a section softens: see
// run/crack_path.hpp.
#pragma once

#include <vector>

#include "model/crack_planes.hpp"
#include "model/event/event.hpp"
#include "model/state.hpp"
#include "model/work.hpp"
#include "readings/section_forces_space.hpp"

namespace trilith {

/// The largest share of a strength that a section uses.
struct SectionUse {
  double share = 0;  ///< 1 at the strength
  JointMode mode{};
  double stress = 0;             ///< of this mode [Pa]
  double at = 0;                 ///< place of this stress from the middle of the section, to the left of its normal [m]
  Vec2 in_space = Vec2::Zero();  ///< the same in a section in space, along its axes [m]
};

/// Normal force and moment give a linear stress over `length` [m] times `depth` [m].
SectionUse section_use(const ContactLaw& law, double normal, double shear, double moment, double length, double depth);

/// In space the stress is linear over the polygon of the section, and shear stress is the sum of its mean and the
/// stress of torsion, as in an intact joint of mortar. The place is `in_space`, along the axes of the section.
SectionUse section_use(const ContactLaw& law, const CrackSection<3>& section, const SpaceForces& forces);

/// A body that cracks now.
template <int D>
struct Crack;
template <>
struct Crack<2> {
  int body = -1, section = -1;  ///< the section is an index into CrackingBody::sections
  JointMode mode{};
  double stress = 0;                         ///< [Pa]
  Vec2 place = Vec2::Zero();                 ///< where it begins [m]
  double normal = 0, shear = 0, moment = 0;  ///< its PlaneForces [N], [N], [N m]
  /// [node of the cut] of a mesh: stress on the part behind at the thickness of the model's contacts, turned back to
  /// the initial position of the body [Pa]
  std::vector<Vec2> traction = {};
};
template <>
struct Crack<3> {
  int body = -1, section = -1;
  JointMode mode{};
  double stress = 0;          ///< [Pa]
  Vec3 place = Vec3::Zero();  ///< [m]
  SpaceForces forces;         ///< of its section
  /// Of a mesh, for each face of the cut: force (along its x, y and normal) and moment on the part behind [N], [N m]
  std::vector<Vec3> traction = {};
};

/// The vectors of a list, as their coordinates in a row.
template <class File, int D>
void each_vector(File& file, std::vector<Eigen::Matrix<double, D, 1>>& vectors) {
  std::vector<double> numbers;
  for (const auto& v : vectors) numbers.insert(numbers.end(), v.data(), v.data() + D);
  file.item(numbers);
  vectors.resize(numbers.size() / D);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (int k = 0; k < D; ++k) vectors[i][k] = numbers[D * i + static_cast<std::size_t>(k)];
}

/// For restart files, see base/bytes.hpp.
template <class File>
void each_field(File& file, Crack<2>& c) {
  file.item(c.body), file.item(c.section), file.item(c.mode), file.item(c.stress);
  file.item(c.place.x()), file.item(c.place.y()), file.item(c.normal), file.item(c.shear), file.item(c.moment);
  each_vector<File, 2>(file, c.traction);
}
template <class File>
void each_field(File& file, Crack<3>& c) {
  file.item(c.body), file.item(c.section), file.item(c.mode), file.item(c.stress);
  for (int k = 0; k < 3; ++k) file.item(c.place[k]);
  SpaceForces& f = c.forces;
  file.item(f.normal), file.item(f.shear.x()), file.item(f.shear.y());
  file.item(f.bending.x()), file.item(f.bending.y()), file.item(f.torsion);
  each_vector<File, 3>(file, c.traction);
}

template <int D>
struct CrackSearch {
  std::vector<Crack<D>> cracks;   ///< at most one for each body, in the order of bodies
  std::vector<CrackWatch> watch;  ///< the new Cracking::watch
  double share = 0;               ///< largest share of a strength that a computed section uses
};

template <int D>
struct CrackScratch;  // edit/crack_scratch.hpp

/// Bodies with a section that uses more than the share `limit` of a strength. `work` must be evaluated at the present
/// instant. Changes nothing but `scratch`.
CrackSearch<2> search_cracks(const Model<2>& model, const State<2>& state, const Work<2>& work,
                             const Cracking<2>& cracking, CrackScratch<2>& scratch, double limit = 1);
CrackSearch<3> search_cracks(const Model<3>& model, const State<3>& state, const Work<3>& work,
                             const Cracking<3>& cracking, CrackScratch<3>& scratch, double limit = 1);

}  // namespace trilith
