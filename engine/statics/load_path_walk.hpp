// One path of equilibria (statics/load_path.hpp): its steps (load_path_steps.cpp) and their sequence (load_path.cpp).
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "statics/load_path.hpp"
#include "statics/static_trial.hpp"

namespace trilith {

/// Limits of the change of the step size from one step to the next.
inline constexpr double least_path_change = 0.5, most_path_change = 2;
/// Tolerance of the condition of a step, as a share.
inline constexpr double condition_share = 1e-7;

/// One path, with the unknowns x and factor. One step from the last equilibrium:
///
///     factor |        _.-o  correct: dx = dx_r + dfactor dx_q, until F = 0 and the condition are both satisfied
///            |     .'  /    predict: along the tangent, dx_q = A^-1 q
///            |   o'---x
///            +------------ x
///
/// All intermediate states are states of the trial. The factor is applied by scaling the loads of `loaded_`, which the
/// trial evaluates.
template <int D>
class LoadPathWalk {
 public:
  LoadPathWalk(const Model<D>& model, const State<D>& state, const LoadPathOptions<D>& options, LoadPath& out);

  void follow();
  /// Rest at the same followed displacement, for a state that is not at rest any more. False if there is none.
  bool find_again();
  State<D> finish() {
    out_.events.insert(out_.events.end(), trial_.events().begin(), trial_.events().end());
    return trial_.finish();
  }

 private:
  bool step(double size, bool reversed = false);
  bool arc(double size);
  bool dissipate(double size);
  bool approach();
  bool jump();
  bool leap(double size);
  bool detour(double size);
  bool search(double size);
  [[nodiscard]] bool is_search_due(int failed, double size) const;
  bool search_rest(double push, bool snaps);
  [[nodiscard]] bool is_even() const;
  bool slide_on();
  bool end_search(const State<D>& begin, bool snaps);
  bool pseudo_step(double h, double push);
  [[nodiscard]] bool goes_far(const Eigen::VectorXd& way, double share, double rotation) const;
  [[nodiscard]] double least_energy() const { return 1e-7 * std::abs(last_factor_ * followed_place()); }
  [[nodiscard]] double energy_rounding() const;
  [[nodiscard]] bool resists() const;
  bool fractures();
  double missed_work();
  bool misses_work();
  [[nodiscard]] bool is_judged() const;
  double mean_error();
  bool strays();
  bool overshoots();
  void take_strength();
  [[nodiscard]] bool is_cracking() const { return used_ > share_at_crack; }
  bool predict(double size, bool reversed);
  bool predict_dissipation(double energy);
  double reach(const Eigen::VectorXd& direction, double factor, double energy);
  void try_at(const Eigen::VectorXd& direction, double factor, double share);
  double dissipation_along(const Eigen::VectorXd& by);
  bool correct(double size);
  void move(const Eigen::VectorXd& by, double factor);
  void set_factor(double factor);
  void find_loads();
  bool solve_loads();
  [[nodiscard]] double condition(double size) const;
  [[nodiscard]] double change(const Eigen::VectorXd& by);
  [[nodiscard]] double turned() const;
  [[nodiscard]] bool unloads() const;
  [[nodiscard]] bool stopped() const { return options_.is_stopped && options_.is_stopped(); }
  [[nodiscard]] double length_of(const Eigen::VectorXd& way) const { return std::sqrt(inner(way, way)); }
  [[nodiscard]] double inner(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return (a.array() * share_ * b.array()).sum();
  }
  bool add_point(int iterations);
  double growth();
  void look_for_limit();
  [[nodiscard]] double followed_place() const;
  [[nodiscard]] double size_to_go(double size) const;

  const LoadPathOptions<D>& options_;
  LoadPath& out_;
  Model<D> loaded_;           // with present loads
  const Model<D> full_;       // with its loads at factor 1
  const Model<D> reference_;  // with the scaled loads alone
  StaticTrial<D> trial_;
  double factor_, last_factor_;
  PathControl control_;  // of the present step
  double origin_ = 0, longest_ = 0;
  double last_rise_ = 0, last_energy_ = 0;  // of the last step: change of the factor, dissipation [J]
  bool may_leap_ = false;                   // see fractures()
  bool strict_ = false, missed_ = false;    // see misses_work()
  double most_work_ = 0;                    // largest force times displacement so far [J]
  bool lenient_ = false;                    // a search is not shortened any further
  bool strayed_ = false;                    // the present step is refused by strays()
  double accurate_ = std::numeric_limits<double>::infinity();    // longest next step by strays() [m]
  double last_error_ = std::numeric_limits<double>::infinity();  // of the longer try for the same point
  double used_ = 0;        // largest share of a strength at the last point, see overshoots()
  bool overshot_ = false;  // the present step is refused by overshoots()
  double to_strength_ = std::numeric_limits<double>::infinity();  // longest next step by overshoots() [m]
  double snap_ = 0;                                               // displacement of the next snap [m]; 0: none
  bool even_only_ = false;                                        // a search is refused where the factor changes
  double budget_ = 0;                                             // points taken; shortened ones by their share
  bool refused_ = false;                                          // the present arc, for its fracture
  int next_search_ = 0, failed_searches_ = 0;         // number of points before the next search; failed ones in a row
  bool searched_ = false;                             // the last point was found by search()
  double energy_ = 0;                                 // of the next step under dissipation control [J]; 0: none yet
  int taken_ = 0;                                     // iterations of the last step
  int last_taken_ = std::numeric_limits<int>::max();  // and of the one before
  Eigen::ArrayXd share_;                              // of the mass, by unknown
  Eigen::VectorXd followed_;                          // weights, by unknown
  Eigen::VectorXd loads_, per_factor_;  // by unknown: at factor 1, and displacement by them at the present tangent
  Eigen::VectorXd last_way_;            // of the last step
};

}  // namespace trilith
