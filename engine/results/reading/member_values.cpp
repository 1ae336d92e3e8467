#include "results/reading/member_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "results/reading/frame_values.hpp"

namespace trilith::results {

const std::vector<MemberQuantity>& member_quantities(int dim) {
  static const std::vector<MemberQuantity> plane{
      {"moment", "bending moment, on the side in tension", "N*m", 2, 3, -1, false},
      {"shear", "shear force", "N", 1, 1, 1, false},
      {"normal", "normal force, tension above 0", "N", 0, 0, 1, false}};
  static const std::vector<MemberQuantity> space{
      {"moment_z", "bending moment about z, on the side in tension", "N*m", 5, 7, -1, false},
      {"moment_y", "bending moment about y, on the side in tension", "N*m", 4, 6, 1, true},
      {"shear_y", "shear force along y", "N", 1, 1, 1, false},
      {"shear_z", "shear force along z", "N", 2, 2, 1, true},
      {"torque", "torque", "N*m", 3, 3, 1, false},
      {"normal", "normal force, tension above 0", "N", 0, 0, 1, false}};
  return dim == 2 ? plane : space;
}

const MemberQuantity& member_quantity(int dim, std::string_view name) {
  std::string_view wanted = name;
  if (dim == 3 && name == "moment") wanted = "moment_z";
  if (dim == 3 && name == "shear") wanted = "shear_y";
  std::vector<std::string> known;
  for (const MemberQuantity& q : member_quantities(dim)) {
    if (q.name == wanted) return q;
    known.push_back(q.name);
  }
  throw InputError(
      fmt::format("there is no diagram '{}' in {}{}", name, dim == 2 ? "the plane" : "space", name_hint(name, known)));
}

MemberValues::MemberValues(const Header& header, const Frame& frame) : width_(header.dim == 2 ? 4 : 8) {
  if (header.members.empty()) return;
  force_ = values_of(header, frame, "member_force");
  state_ = values_of(header, frame, "member_state");
  deformation_ = values_of(header, frame, "member_deformation");
  if (force_ == nullptr || force_->size() != width_ * header.beams.size())
    throw ResultsError("the file has members but no forces of them in its frames");
}

double MemberValues::force(std::size_t beam, int end, const MemberQuantity& quantity) const {
  return force_ == nullptr ? 0 : (*force_)[width_ * beam + (end == 0 ? quantity.at_a : quantity.at_b)];
}

MemberState MemberValues::state(std::size_t beam, int end) const {
  if (state_ == nullptr) return MemberState::elastic;
  const double number = (*state_)[2 * beam + static_cast<std::size_t>(end)];
  return static_cast<MemberState>(std::clamp(static_cast<int>(std::lround(number)), 0, 3));
}

double MemberValues::deformation(std::size_t beam, int end) const {
  return deformation_ == nullptr ? 0 : (*deformation_)[2 * beam + static_cast<std::size_t>(end)];
}

}  // namespace trilith::results
