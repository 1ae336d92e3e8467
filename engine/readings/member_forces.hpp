// Inner forces of the members of frames: what an engineer reads off a beam.
#pragma once

#include <array>
#include <vector>

#include "element/beam/end_hinge.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// At a section, in the axes of the beam that begins or ends there. Damping is not part of them.
struct SectionForces {
  double along = 0;           ///< from the member's start, as it was at the start of the run [m]
  Vec2 place = Vec2::Zero();  ///< now [m]
  double normal = 0;          ///< tension above 0 [N]
  double shear = 0;           ///< above 0 where the part before pushes the part behind up, to the left [N]
  double moment = 0;          ///< above 0 where the bottom, the right side, is in tension [N m]
};

/// At both ends of each of its beams, one after the other: two rows for each.
std::vector<SectionForces> member_forces(const Model<2>& model, const State<2>& state, int member);

/// The same in space, in the axes of the section: y up, z across.
struct SectionForces3 {
  double along = 0;                ///< from the member's start, as it was at the start of the run [m]
  Vec3 place = Vec3::Zero();       ///< now [m]
  double normal = 0;               ///< tension above 0 [N]
  std::array<double, 2> shear{};   ///< above 0 where the part before pushes the part behind along y, along z [N]
  double torque = 0;               ///< above 0 where the part behind is twisted about the axis [N m]
  std::array<double, 2> moment{};  ///< about y, above 0 where the side to z is in tension; about z, the bottom [N m]
};
std::vector<SectionForces3> member_forces(const Model<3>& model, const State<3>& state, int member);

/// A plastic hinge of a member.
struct HingeReading {
  int end = 0;                ///< 0: at the member's start
  Vec2 place = Vec2::Zero();  ///< now [m]
  HingeStatus status{};
  double rotation = 0;    ///< plastic, above 0 where the bottom has lengthened [rad]
  double stretch = 0;     ///< plastic, of the beam that has the hinge [m]
  double moment = 0;      ///< above 0 where the bottom is in tension [N m]
  double normal = 0;      ///< tension above 0 [N]
  double dissipated = 0;  ///< energy [J]
};

/// Those that a member has, at most two.
std::vector<HingeReading> member_hinges(const Model<2>& model, const State<2>& state, int member);

/// The same in space, about y and z of the section: above 0 where the side to z, and the bottom, has lengthened or is
/// in tension.
struct HingeReading3 {
  int end = 0;
  Vec3 place = Vec3::Zero();
  HingeStatus status{};
  std::array<double, 2> rotation{};  ///< plastic [rad]
  double stretch = 0;                ///< plastic, of the beam that has the hinge [m]
  std::array<double, 2> moment{};    ///< [N m]
  double normal = 0;                 ///< tension above 0 [N]
  double dissipated = 0;             ///< energy [J]
};
std::vector<HingeReading3> member_hinges(const Model<3>& model, const State<3>& state, int member);

/// A section of a member of fibres, at a station along one of its beams.
struct FibreReading {
  double along = 0;      ///< from the member's start, as it was at the start of the run [m]
  double axial = 0;      ///< strain of the centroid, tension above 0 [1]
  double curvature = 0;  ///< above 0 where the bottom is in tension [1/m]
  double normal = 0;     ///< tension above 0 [N]
  double moment = 0;     ///< above 0 where the bottom is in tension [N m]
  struct Fibre {
    double height, area, strain, stress;  ///< above the centroid [m], [m2], [1], [Pa]
  };
  std::vector<Fibre> fibres;
};

/// Those of a member, beam by beam from its start; none where it is not of fibres.
std::vector<FibreReading> member_fibres(const Model<2>& model, const State<2>& state, int member);

/// The same in space.
struct FibreReading3 {
  double along = 0;                   ///< from the member's start, as it was at the start of the run [m]
  double axial = 0;                   ///< strain of the centroid, tension above 0 [1]
  std::array<double, 2> curvature{};  ///< about y, above 0 where the side to z is in tension; about z, the bottom [1/m]
  double normal = 0;                  ///< tension above 0 [N]
  std::array<double, 2> moment{};     ///< with the signs of the curvatures [N m]
  struct Fibre {
    double up, across, area, strain, stress;  ///< from the centroid [m], [m2], [1], [Pa]
  };
  std::vector<Fibre> fibres;
};
std::vector<FibreReading3> member_fibres(const Model<3>& model, const State<3>& state, int member);

}  // namespace trilith
