// Damping of a beam that is the same share of critical over a band of frequencies, by a few branches that relax.
//
// Beside its stress S a beam carries a share g_j of what each branch still remembers of the changes of S,
//
//   h_j' = S' - h_j / tau_j,        damping = sum of g_j h_j
//
// so that at an even frequency w its stiffness is K (1 + sum g_j i w tau_j / (1 + i w tau_j)): springs and dashpots in
// series beside the beam (a generalised Maxwell body; Emmerich and Korn, "Incorporation of attenuation into time-domain
// computations of seismic wave fields", Geophysics 52, 1987, who fit the shares by least squares as here). A mode that
// swings at w by such beams alone has the ratio to critical
//
//   Im / (2 Re) = [sum g_j x_j / (1 + x_j^2)] / (2 [1 + sum g_j x_j^2 / (1 + x_j^2)]),     x_j = w tau_j
//
// which is that asked for where sum g_j (x_j - 2 ratio x_j^2) / (1 + x_j^2) = 2 ratio, linear in g_j. tau_j lie evenly
// in the logarithm over the band, g_j follow by least squares there. Memory goes with the stress, so an end that flows
// has no damping moment beyond what it still remembers. Above the band K is 1 + sum g_j times as stiff, which the
// longest step has to know; no damping of a band is without that (Kramers and Kronig).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/schema.hpp"
#include "element/beam/beam_element.hpp"

namespace trilith {

/// What is asked for.
struct BandDamping {
  double ratio = 0;  ///< [1]
  double from = 0;   ///< [Hz]
  double to = 0;     ///< [Hz]

  static constexpr std::string_view name = "band_damping";
  static constexpr std::string_view sentence = "the same ratio to critical damping over a band of frequencies";
  static constexpr auto parameters() {
    using P = Parameter<BandDamping>;
    return std::array{P{&BandDamping::ratio, "ratio", "1", no_default, 0, 0.2, false, "share of critical damping"},
                      P{&BandDamping::from, "from", "Hz", no_default, 0, unbounded, false, "where the band begins"},
                      P{&BandDamping::to, "to", "Hz", no_default, 0, unbounded, false, "where it ends"}};
  }
  /// Throws InputError where the band has no width, or is wider than the branches there may be can span.
  void check() const;
};

/// Branches that do it.
struct DampingBranches {
  static constexpr int most = 10;
  BandDamping band;
  int count = 0;
  std::array<double, most> share{};  ///< g_j [1]
  std::array<double, most> time{};   ///< tau_j [s]

  /// Numbers that a beam of so many stresses remembers: the last ones, and h_j of each branch.
  [[nodiscard]] int memory_size(int stresses = 3) const { return stresses * (1 + count); }
  /// Of the stiffness far above the band: 1 + sum of g_j.
  [[nodiscard]] double stiffening() const;
  /// Im K over K at w [rad/s], as of a mode that swings by these beams alone, and Re K over K.
  [[nodiscard]] double loss(double w) const;
  [[nodiscard]] double stiffness(double w) const;
};

/// Throws InputError as BandDamping::check, and for numbers out of range.
DampingBranches damping_branches(const BandDamping& band);

/// The row of `bands` that is this band, made where there is none; -1 without one. Throws as damping_branches.
int band_row(const std::optional<BandDamping>& band, std::vector<DampingBranches>& bands);

/// Over a step: what a branch keeps of its memory, and what it takes of a change of stress that goes evenly over it.
struct BranchStep {
  std::array<double, DampingBranches::most> kept{}, taken{};
  double sum = 0;  ///< of g_j taken_j: damping per change of stress within the step

  BranchStep() = default;
  BranchStep(const DampingBranches& branches, double dt);
};

/// The damping stress with the beam's stress now, of the plane's three numbers or of the six of space. `before` and
/// `after` have memory_size numbers.
BeamStress relax(const DampingBranches& branches, const BranchStep& step, const BeamStress& stress,
                 std::span<const double> before, std::span<double> after);
std::array<double, 6> relax(const DampingBranches& branches, const BranchStep& step,
                            const std::array<double, 6>& stress, std::span<const double> before,
                            std::span<double> after);

}  // namespace trilith
