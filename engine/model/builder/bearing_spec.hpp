// Bearings and seats to be, and what is checked of bearings whatever the dimension.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace trilith {

/// Points in world coordinates where the bodies stand at the start. In space `horizontal` is a law of along and across
/// at once, which then have none of their own.
template <int D>
struct BearingSpecOf : std::conditional_t<D == 3, HorizontalPart, NoHorizontalPart> {
  std::string name;
  std::string body_a, body_b;
  Vec<D> point_a = Vec<D>::Zero(), point_b = Vec<D>::Zero();  ///< [m]
  Rotation<D> angle{};  ///< of direction `along` to the x axis [rad]; in space of the bearing's axes
  std::array<DirectionLaw, Space<D>::dofs> law;  ///< see Directions
  std::array<double, Space<D>::dofs> limit = no_limits<Space<D>::dofs>();
  bool replaces_contact = false;  ///< while live, stands for the flat contact of the pieces whose faces are nearest
                                  ///< to its points; their corners still touch
  std::string contact_after;      ///< name of the contact law after failure; "": the one of the surfaces
  std::string becomes_bearing;    ///< name of the bearing that follows; "": none
  std::array<bool, Space<D>::dofs> next_from_here{};  ///< directions in which it counts from where it takes over
  bool starts_waiting = false;
  double arm = 0;  ///< farthest that a point may lie from its body, which holds it by a rigid arm without mass; 0: no
                   ///< farther than the body is large [m]
};
using BearingSpec = BearingSpecOf<2>;

/// A seat to be; points in world coordinates at the start.
template <int D>
struct SeatSpecOf {
  std::string name;
  std::string body, support;
  Vec<D> end = Vec<D>::Zero(), edge = Vec<D>::Zero();  ///< [m]
  Vec<D> inward = Vec<D>::UnitX();                     ///< from the edge over the seat; made a unit vector
};
using SeatSpec = SeatSpecOf<2>;

/// Throws InputError: points that are not finite, numbers of laws out of range, no law at all, a law of both horizontal
/// directions beside one of along or across, limits that are not above 0, a successor without a limit,
/// or none of which it is said where it counts from.
template <int D>
void check_bearing(const BearingSpecOf<D>& spec, const std::string& owner);
/// Throws InputError where one of a bearing's laws slides under the compression of its axial law, which is none or
/// slides itself: it would never hold anything.
void require_compression(std::span<const DirectionLaw> laws, const DirectionLaw& axial, const std::string& owner);
/// Adds to `notes` what is allowed but not usual.
template <int D>
void add_bearing_plausibility_notes(const BearingSpecOf<D>& spec, const std::string& owner,
                                    std::vector<std::string>& notes);

/// All of it that has nothing to do with bodies. Throws InputError where a successor is not there.
template <int D>
Bearing<D> bearing_of(const BearingSpecOf<D>& spec, const std::vector<std::string>& law_names,
                      const std::vector<BearingSpecOf<D>>& all);

/// Throws InputError for a point that is farther from a body than the body is large: it was meant for another place.
template <int D>
void require_near(const Vec<D>& point, double distance, double size, const std::string& body, const std::string& owner);
/// The same of a point that a rigid arm of up to `arm` [m] may hold; 0: there is none.
template <int D>
void require_in_reach(const Vec<D>& point, double distance, double size, double arm, const std::string& body,
                      const std::string& owner);

/// Throws InputError where what follows bearing `row` of `bearings` can never begin to carry: itself, one that carries
/// from the start, or one that leads back to it.
template <int D>
void check_successor(const std::vector<Bearing<D>>& bearings, std::size_t row);

}  // namespace trilith
