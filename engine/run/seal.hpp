// Seal of a run: checks against physics that are made while it runs, from samples some steps apart and at the end of
// each stage. A check that fails makes the run invalid from the start of that stage (model/verdict.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "model/check/energy_check.hpp"
#include "model/model.hpp"
#include "model/seal_row.hpp"
#include "model/state.hpp"
#include "model/verdict.hpp"
#include "model/work.hpp"

namespace trilith {

template <int D>
struct Instant;
struct StageReport;
struct Travel;

/// Limits of the checks; docs/scripting/validity.md lists them.
struct SealLimit {
  static constexpr double energy = 0.2;  ///< residual of the ledger over the energy supplied
  static constexpr double base_shear =
      1e-6;                               ///< sum of the inner forces of all bodies over the sum of their magnitudes
  static constexpr double motion = 1e-2;  ///< distance of a driven node from its record over the largest displacement
  static constexpr double penetration = 0.5;  ///< overlap over the thickness of the thinner piece
  static constexpr double rest = 0.05;        ///< unbalanced force over the largest one carried
  static constexpr double travel = 1;         ///< displacement in a search for rest over the size of the body
};

/// Steps between two samples: a sample costs about as much as one explicit step. The depth of contacts alone costs a
/// tenth of it and is sampled more often, because an impact lasts about ten steps.
inline constexpr std::int64_t seal_interval = 256, seal_interval_implicit = 16, depth_interval = 16;

/// Largest overlap of any contact as a share of the thickness of the thinner piece.
double deepest_share(const Model<2>& model, const Work<2>& work);
double deepest_share(const Model<3>& model, const Work<3>& work);

class Seal {
 public:
  enum Check { energy, base_shear, motion, penetration, softening, steps, rest, travel, checks };

  /// True if a sample is due after this number of steps.
  [[nodiscard]] static bool due(std::int64_t step, bool implicit) {
    return step % (implicit ? seal_interval_implicit : seal_interval) == 0;
  }
  /// An evaluated instant with its ledger. The residual counts at the end of a stage only: within an impact a leapfrog
  /// step has an error that vanishes with it.
  template <int D>
  void sample(const Instant<D>& now, const Energy& ledger, bool ends);
  /// Between two samples: the depth of contacts.
  template <int D>
  void sample_depth(const Model<D>& model, const Work<D>& work) {
    deepest_ = std::max(deepest_, deepest_share(model, work));
  }
  /// Ends a stage; `farthest`: the largest displacement in a search for rest, of `body`. Reports checks that failed now
  /// for the first time to the verdict.
  void end_stage(const StageReport& report, bool sought_rest, const Travel& farthest, const std::string& body,
                 Verdict& verdict);
  /// Adds a check that is made once, after a stage that began at `begun` [s].
  void add(const SealRow& row, double begun, Verdict& verdict);
  /// All checks; `verdict`: of the run, `notes`: number of warnings.
  [[nodiscard]] std::vector<SealRow> rows(const Verdict& verdict, std::size_t notes) const;

  /// Calls each(member) for all members.
  template <class Each>
  void each_number(Each&& each) {
    energy_.each_number(each);
    each(has_balance_), each(first_balance_), each(base_shear_), each(carries_), each(motion_off_), each(motion_peak_);
    each(deepest_), each(shortest_), each(longest_), each(step_count_);
    each(rests_), each(rest_ratio_), each(travel_), each(travelled_);
    for (double& until : valid_until_) each(until);
    for (bool& is : failed_) each(is);
  }

 private:
  [[nodiscard]] std::array<SealRow, checks> judged() const;

  EnergyCheck energy_;
  bool has_balance_ = false;
  double first_balance_ = 0;                 // [J]
  double base_shear_ = 0;                    // share
  bool carries_ = false;                     // any inner force was met
  double motion_off_ = 0, motion_peak_ = 0;  // [m]
  double deepest_ = 0;                       // share of the thickness
  double shortest_ = 0, longest_ = 0;        // [s]
  std::int64_t step_count_ = 0, rests_ = 0;
  double rest_ratio_ = 0, travel_ = 0;
  std::string travelled_;  // body of travel_
  std::array<double, checks> valid_until_{};
  std::array<bool, checks> failed_{};
  std::vector<SealRow> added_;
};

/// Sum of all inner forces (contacts, bearings, elements) over the sum of their magnitudes. By action and reaction it
/// is 0 up to rounding: the forces at the supports equal the inertia of the bodies less the loads. -1 without forces.
template <int D>
double unbalanced_share(const Model<D>& model, const State<D>& state, const Work<D>& work);

}  // namespace trilith
