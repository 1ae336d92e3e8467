// Specifications of bearings and seats, and the checks of bearings common to plane and space.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// Points in world coordinates at the start. In space `horizontal` is a law for along and across together, which then
/// have no single laws.
template <int D>
struct BearingSpecOf : std::conditional_t<D == 3, HorizontalPart, NoHorizontalPart> {
  std::string name;
  std::string body_a, body_b;
  Vec<D> point_a = Vec<D>::Zero(), point_b = Vec<D>::Zero();  ///< [m]
  Rotation<D> angle{};  ///< from the x axis to direction `along` [rad]; in space rotation of the bearing's axes
  std::array<DirectionLaw, Space<D>::dofs> law;  ///< see Directions
  std::array<double, Space<D>::dofs> limit = no_limits<Space<D>::dofs>();
  bool replaces_contact = false;  ///< while live, replaces the flat contact of the pieces whose faces are nearest to
                                  ///< its points; their corners still touch
  std::string contact_after;      ///< name of the contact law after failure; "": the law of the surfaces
  std::string becomes_bearing;    ///< name of the successor; "": none
  std::array<bool, Space<D>::dofs> next_from_here{};  ///< directions whose displacement restarts at its activation
  bool starts_waiting = false;
  double arm = 0;  ///< largest distance of a point from its body, which holds it by a massless rigid arm [m]; 0: the
                   ///< size of the body
};
using BearingSpec = BearingSpecOf<2>;

/// Specification of a seat; points in world coordinates at the start.
template <int D>
struct SeatSpecOf {
  std::string name;
  std::string body, support;
  Vec<D> end = Vec<D>::Zero(), edge = Vec<D>::Zero();  ///< [m]
  Vec<D> inward = Vec<D>::UnitX();                     ///< from the edge onto the seat; normalised
};
using SeatSpec = SeatSpecOf<2>;

/// Throws InputError for: points that are not finite, law parameters out of range, no law at all, limits that are not
/// above 0. Also for a law of both horizontal directions together with one of along or across, a successor without a
/// limit, and a successor whose origin of displacement is not given.
template <int D>
void check_bearing(const BearingSpecOf<D>& spec, const std::string& owner);
/// Throws InputError if one of a bearing's laws slides under the compression of its axial law, and there is no axial
/// law or it slides itself: the slider would never carry load.
void require_compression(std::span<const DirectionLaw> laws, const DirectionLaw& axial, const std::string& owner);
/// Adds unusual but allowed values to `notes`.
template <int D>
void add_bearing_plausibility_notes(const BearingSpecOf<D>& spec, const std::string& owner,
                                    std::vector<std::string>& notes);

/// The part that is independent of bodies. Throws InputError if a successor does not exist.
template <int D>
Bearing<D> bearing_of(const BearingSpecOf<D>& spec, const std::vector<std::string>& law_names,
                      const std::vector<BearingSpecOf<D>>& all);

/// Throws InputError for a point farther from a body than its size: another position was probably intended.
template <int D>
void require_near(const Vec<D>& point, double distance, double size, const std::string& body, const std::string& owner);
/// For a point that a rigid arm of up to `arm` [m] may hold; 0: no arm.
template <int D>
void require_in_reach(const Vec<D>& point, double distance, double size, double arm, const std::string& body,
                      const std::string& owner);

/// Throws InputError if the successor of bearing `row` of `bearings` can never become live: itself, a bearing that is
/// live from the start, or one that leads back to it.
template <int D>
void check_successor(const std::vector<Bearing<D>>& bearings, std::size_t row);

}  // namespace trilith
