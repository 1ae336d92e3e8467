// Section forces of the members of frames.
#pragma once

#include <array>
#include <vector>

#include "element/beam/end_hinge.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Forces at a section, in the axes of the beam that begins or ends there, without damping.
struct SectionForces {
  double along = 0;           ///< initial distance from the member's start [m]
  Vec2 place = Vec2::Zero();  ///< present position [m]
  double normal = 0;          ///< tension above 0 [N]
  double shear = 0;           ///< positive if the part before the section pushes the part behind it up, to the left [N]
  double moment = 0;          ///< positive with tension at the bottom, the right side [N m]
};

/// Two rows for each beam of the member, one after the other: its start and its end.
std::vector<SectionForces> member_forces(const Model<2>& model, const State<2>& state, int member);

/// Section forces in space, in the axes of the section: y up, z across.
struct SectionForces3 {
  double along = 0;                ///< initial distance from the member's start [m]
  Vec3 place = Vec3::Zero();       ///< present position [m]
  double normal = 0;               ///< tension above 0 [N]
  std::array<double, 2> shear{};   ///< positive if the part before the section pushes the part behind it along y, along
                                   ///< z [N]
  double torque = 0;               ///< positive if the part behind the section is twisted about the axis [N m]
  std::array<double, 2> moment{};  ///< about y, positive with tension on the side towards z; about z, at the bottom [N
                                   ///< m]
};
std::vector<SectionForces3> member_forces(const Model<3>& model, const State<3>& state, int member);

/// A plastic hinge of a member.
struct HingeReading {
  int end = 0;                ///< 0: at the member's start
  Vec2 place = Vec2::Zero();  ///< present position [m]
  HingeStatus status{};
  double rotation = 0;    ///< plastic, positive if the bottom has lengthened [rad]
  double stretch = 0;     ///< plastic, of the beam with the hinge [m]
  double moment = 0;      ///< positive with tension at the bottom [N m]
  double normal = 0;      ///< tension above 0 [N]
  double dissipated = 0;  ///< energy [J]
};

/// The hinges of a member, at most two.
std::vector<HingeReading> member_hinges(const Model<2>& model, const State<2>& state, int member);

/// A plastic hinge in space, about y and z of the section: positive if the side towards z, and the bottom, has
/// lengthened or is in tension.
struct HingeReading3 {
  int end = 0;
  Vec3 place = Vec3::Zero();
  HingeStatus status{};
  std::array<double, 2> rotation{};  ///< plastic [rad]
  double stretch = 0;                ///< plastic, of the beam with the hinge [m]
  std::array<double, 2> moment{};    ///< [N m]
  double normal = 0;                 ///< tension above 0 [N]
  double dissipated = 0;             ///< energy [J]
};
std::vector<HingeReading3> member_hinges(const Model<3>& model, const State<3>& state, int member);

/// A section of a fibre member, at a station along one of its beams.
struct FibreReading {
  double along = 0;      ///< initial distance from the member's start [m]
  double axial = 0;      ///< strain of the centroid, tension above 0 [1]
  double curvature = 0;  ///< positive with tension at the bottom [1/m]
  double normal = 0;     ///< tension above 0 [N]
  double moment = 0;     ///< positive with tension at the bottom [N m]
  struct Fibre {
    double height, area, strain, stress;  ///< above the centroid [m], [m2], [1], [Pa]
  };
  std::vector<Fibre> fibres;
};

/// The sections of a member, beam by beam from its start; none if it has no fibres.
std::vector<FibreReading> member_fibres(const Model<2>& model, const State<2>& state, int member);

/// A section of a fibre member in space.
struct FibreReading3 {
  double along = 0;                   ///< initial distance from the member's start [m]
  double axial = 0;                   ///< strain of the centroid, tension above 0 [1]
  std::array<double, 2> curvature{};  ///< about y, positive with tension on the side towards z; about z, at the bottom
                                      ///< [1/m]
  double normal = 0;                  ///< tension above 0 [N]
  std::array<double, 2> moment{};     ///< same signs as the curvatures [N m]
  struct Fibre {
    double up, across, area, strain, stress;  ///< from the centroid [m], [m2], [1], [Pa]
  };
  std::vector<Fibre> fibres;
};
std::vector<FibreReading3> member_fibres(const Model<3>& model, const State<3>& state, int member);

}  // namespace trilith
