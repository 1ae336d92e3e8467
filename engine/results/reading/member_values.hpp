// Section forces, states and deformations of the members of frames in one frame of a results file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// A section force: its columns in /frames/member_force, and how a diagram shows it.
struct MemberQuantity {
  std::string name;                ///< "moment", in space "moment_z", ...
  std::string label, unit;         ///< in a legend
  std::size_t at_a = 0, at_b = 0;  ///< columns at the start and at the end of a beam
  double side = 1;                 ///< 1: a value above 0 is drawn towards the axis below, -1: away from it
  bool across = false;             ///< that axis is z of the section, not y (up)
};

/// All section forces in a model of this dimension; bending moments first. Moments are drawn on the side in tension.
const std::vector<MemberQuantity>& member_quantities(int dim);

/// The one with this name; in space "moment" and "shear" mean bending up and down. Throws InputError with all names.
const MemberQuantity& member_quantity(int dim, std::string_view name);

/// State of an end of a beam. `lost`: its hinge carries no moment.
enum class MemberState { elastic = 0, yielded = 1, lost = 2, removed = 3 };

/// Keeps references to its arguments. The values are empty for a file without members.
class MemberValues {
 public:
  /// Throws ResultsError if the file has members but no forces of them.
  MemberValues(const Header& header, const Frame& frame);
  /// At end 0 or 1 of a beam [N], [N m].
  [[nodiscard]] double force(std::size_t beam, int end, const MemberQuantity& quantity) const;
  [[nodiscard]] MemberState state(std::size_t beam, int end) const;
  /// Plastic rotation of a hinge [rad], or curvature of fibres [1/m]; 0 for an elastic member.
  [[nodiscard]] double deformation(std::size_t beam, int end) const;

 private:
  const std::vector<double>*force_ = nullptr, *state_ = nullptr, *deformation_ = nullptr;
  std::size_t width_ = 4;
};

}  // namespace trilith::results
