// Automatic choice of the number of threads that share the steps of a run, by timing steps.
//
// The gain of a further thread depends on the model, on its state, and on the distance of the processors in use: from
// half as fast to nearly twice as fast. So a run alternates for some steps between its number of threads and the next
// count of 1, 2, 4, ..., and keeps the faster one. Any number gives the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trilith {

class ThreadChoice {
 public:
  /// Fixed number of threads.
  static ThreadChoice always(int threads);
  /// Up to `most`, as many as make the run faster.
  static ThreadChoice up_to(int most);

  /// True if both began with the same request, whatever was found by timing.
  [[nodiscard]] bool asks_as(const ThreadChoice& other) const { return counts_ == other.counts_; }
  /// True if steps need to be timed.
  [[nodiscard]] bool is_open() const { return most_ > 1; }
  /// Number for the next step.
  [[nodiscard]] int threads() const;
  /// Adds the run time of a step [s].
  void took(double seconds);

  /// Best number known so far.
  [[nodiscard]] int chosen() const { return counts_[at_]; }
  /// Speed-up of this number over one thread, as last timed; 1 for one thread, 0 if not known.
  [[nodiscard]] double gain() const;

 private:
  // A trial times runs of steps with the present number of threads (0) and with another one (1), in this order. The
  // first steps of each run are not counted, because their data are in the caches of other processors.
  static constexpr std::array<int, 6> order{0, 1, 1, 0, 0, 1};
  static constexpr int stretch = 8, uncounted = 2, counted = (stretch - uncounted) * 3;
  static constexpr std::int64_t first_wait = 16, least_wait = 2000, longest_wait = 16000;  ///< between trials [steps]
  static constexpr double least_gain = 1.05;  ///< speed-up that justifies a further thread

  int most_ = 1;
  std::array<int, 8> counts_{1};  ///< 1, 2, 4, ..., most_
  int last_ = 0, at_ = 0;         ///< indices of counts_: the last one, and the chosen one
  std::array<double, 8> gain_{};  ///< [i] speed of counts_[i + 1] over counts_[i]; 0: not known

  bool tries_ = false;
  int other_ = 0;                                         ///< index of counts_, in a trial
  std::size_t step_ = 0;                                  ///< ... steps of the trial that are over
  bool upwards_ = false;                                  ///< ... with more threads
  std::array<std::array<double, counted>, 2> seconds_{};  ///< by order
  std::array<std::size_t, 2> timed_{};                    ///< number of these
  std::int64_t wait_ = first_wait, next_wait_ = least_wait;

  void begin_trial();
  void end_trial();
};

}  // namespace trilith
