// How many threads share the steps of a run where nobody said: as many as pay, which is found by timing steps.
//
// What a further thread brings depends on the model, on what happens in it, and on how far apart the machine's
// processors are just then: from half as fast to nearly twice. So a run tries, for some steps in turn, as many threads
// as it has and the next count of 1, 2, 4, ..., and keeps those that pay. Any number gives the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trilith {

class ThreadChoice {
 public:
  /// Always so many.
  static ThreadChoice always(int threads);
  /// Up to `most`, as many as pay.
  static ThreadChoice up_to(int most);

  /// True of what begins as the other did, whatever was found since.
  [[nodiscard]] bool asks_as(const ThreadChoice& other) const { return counts_ == other.counts_; }
  /// True where steps are to be timed.
  [[nodiscard]] bool is_open() const { return most_ > 1; }
  /// For the step to come.
  [[nodiscard]] int threads() const;
  /// The step took so long [s].
  void took(double seconds);

  /// Those that pay, as far as is known.
  [[nodiscard]] int chosen() const { return counts_[at_]; }
  /// How many times as fast these are as one, as was timed last; 1 for one thread, 0 where it is not known.
  [[nodiscard]] double gain() const;

 private:
  // A trial times stretches of steps by as many threads as now (0) and by others (1), in this order. The first steps of
  // each are not counted: what they work on lies in the caches of other processors.
  static constexpr std::array<int, 6> order{0, 1, 1, 0, 0, 1};
  static constexpr int stretch = 8, uncounted = 2, counted = (stretch - uncounted) * 3;
  static constexpr std::int64_t first_wait = 16, least_wait = 2000, longest_wait = 16000;  ///< between trials [steps]
  static constexpr double least_gain = 1.05;  ///< for which a further thread is taken

  int most_ = 1;
  std::array<int, 8> counts_{1};  ///< 1, 2, 4, ..., most_
  int last_ = 0, at_ = 0;         ///< of counts_: the last there is, and the one chosen
  std::array<double, 8> gain_{};  ///< [i] of counts_[i + 1] over counts_[i]; 0: not known

  bool tries_ = false;
  int other_ = 0;                                         ///< of counts_, in a trial
  std::size_t step_ = 0;                                  ///< ... of which so many steps are over
  bool upwards_ = false;                                  ///< ... of more threads
  std::array<std::array<double, counted>, 2> seconds_{};  ///< by order
  std::array<std::size_t, 2> timed_{};                    ///< how many of these there are
  std::int64_t wait_ = first_wait, next_wait_ = least_wait;

  void begin_trial();
  void end_trial();
};

}  // namespace trilith
