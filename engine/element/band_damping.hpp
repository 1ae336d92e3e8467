// Damping of a beam with a constant damping ratio over a frequency band, by a few relaxing branches.
//
// In addition to its stress S a beam carries a share g_j of the memory h_j of each branch:
//
//   h_j' = S' - h_j / tau_j,        damping = sum of g_j h_j.
//
// At a constant frequency w its stiffness is K (1 + sum g_j i w tau_j / (1 + i w tau_j)): springs and dashpots in
// series, parallel to the beam. This is a generalised Maxwell body (Emmerich and Korn, "Incorporation of attenuation
// into time-domain computations of seismic wave fields", Geophysics 52, 1987, also with least squares). A mode at w of
// such beams alone has the damping ratio
//
//     Im / (2 Re) = [sum g_j x_j / (1 + x_j^2)] / (2 [1 + sum g_j x_j^2 / (1 + x_j^2)]),     x_j = w tau_j.
//
// It equals the requested ratio where sum g_j (x_j - 2 ratio x_j^2) / (1 + x_j^2) = 2 ratio, which is linear in g_j.
// The tau_j are evenly spaced in the logarithm over the band; g_j follow by least squares. The memory follows the
// stress, so a yielding end has no damping moment beyond its remaining memory. Above the band the stiffness is 1 + sum
// g_j times K, which the stability limit must include. Damping over a band always stiffens above it (Kramers and
// Kronig).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/schema.hpp"
#include "element/beam/beam_element.hpp"

namespace trilith {

/// The requested damping.
struct BandDamping {
  double ratio = 0;  ///< [1]
  double from = 0;   ///< [Hz]
  double to = 0;     ///< [Hz]

  static constexpr std::string_view name = "band_damping";
  static constexpr std::string_view sentence = "constant damping ratio over a band of frequencies";
  static constexpr auto parameters() {
    using P = Parameter<BandDamping>;
    return std::array{
        P{&BandDamping::ratio, "ratio", "1", no_default, 0, 0.2, false, "damping ratio"},
        P{&BandDamping::from, "from", "Hz", no_default, 0, unbounded, false, "lower frequency of the band"},
        P{&BandDamping::to, "to", "Hz", no_default, 0, unbounded, false, "upper frequency of the band"}};
  }
  /// Throws InputError where the band has no width, or is wider than the largest number of branches can cover.
  void check() const;
};

/// The branches that provide it.
struct DampingBranches {
  static constexpr int most = 10;
  BandDamping band;
  int count = 0;
  std::array<double, most> share{};  ///< g_j [1]
  std::array<double, most> time{};   ///< tau_j [s]

  /// Size of the memory of a beam with this many stresses: the last stresses, and h_j of each branch.
  [[nodiscard]] int memory_size(int stresses = 3) const { return stresses * (1 + count); }
  /// Stiffness far above the band over K: 1 + sum of g_j.
  [[nodiscard]] double stiffening() const;
  /// Im K over K at w [rad/s], for a mode of these beams alone, and Re K over K.
  [[nodiscard]] double loss(double w) const;
  [[nodiscard]] double stiffness(double w) const;
};

/// Throws InputError as BandDamping::check, and for numbers out of range.
DampingBranches damping_branches(const BandDamping& band);

/// Index of this band in `bands`, appended where it is missing; -1 without a band. Throws as damping_branches.
int band_row(const std::optional<BandDamping>& band, std::vector<DampingBranches>& bands);

/// Factors of one step: the kept share of a branch's memory, and its share of a change of stress that is linear over
/// the step.
struct BranchStep {
  std::array<double, DampingBranches::most> kept{}, taken{};
  double sum = 0;  ///< of g_j taken_j: damping per change of stress within the step

  BranchStep() = default;
  BranchStep(const DampingBranches& branches, double dt);
};

/// The damping stress for the present stress of the beam, with three numbers in the plane or six in space. `before` and
/// `after` have memory_size numbers.
BeamStress relax(const DampingBranches& branches, const BranchStep& step, const BeamStress& stress,
                 std::span<const double> before, std::span<double> after);
std::array<double, 6> relax(const DampingBranches& branches, const BranchStep& step,
                            const std::array<double, 6>& stress, std::span<const double> before,
                            std::span<double> after);

}  // namespace trilith
