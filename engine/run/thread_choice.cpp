#include "run/thread_choice.hpp"

#include <algorithm>

#include "base/team.hpp"

namespace trilith {

ThreadChoice ThreadChoice::always(int threads) {
  ThreadChoice c;
  c.counts_[0] = std::clamp(threads, 1, most_threads);
  return c;
}

/// Starts with all threads, which suits large models.
ThreadChoice ThreadChoice::up_to(int most) {
  ThreadChoice c;
  c.most_ = std::clamp(most, 1, most_threads);
  while (c.counts_[c.last_] < c.most_) {
    const int next = std::min(2 * c.counts_[c.last_], c.most_);
    c.counts_[++c.last_] = next;
  }
  c.at_ = c.last_;
  return c;
}

int ThreadChoice::threads() const {
  return counts_[tries_ && order[step_ / stretch] == 1 ? other_ : at_];
}

void ThreadChoice::took(double seconds) {
  if (!is_open()) return;
  if (!tries_) {
    if (--wait_ <= 0) begin_trial();
    return;
  }
  const auto of = static_cast<std::size_t>(order[step_ / stretch]);
  if (step_ % stretch >= uncounted) seconds_[of][timed_[of]++] = seconds;
  if (++step_ == stretch * order.size()) end_trial();
}

/// Tries more and fewer threads in turn, if both exist.
void ThreadChoice::begin_trial() {
  upwards_ = at_ == 0 || (at_ < last_ && !upwards_);
  other_ = upwards_ ? at_ + 1 : at_ - 1;
  step_ = 0, timed_ = {}, tries_ = true;
}

/// Compares the medians of both times; more threads are used only if they are faster. A confirmed choice is tested less
/// and less often; a changed one is tested again soon.
void ThreadChoice::end_trial() {
  const auto middle = [](std::array<double, counted>& of) {
    std::nth_element(of.begin(), of.begin() + counted / 2, of.end());
    return of[counted / 2];
  };
  const double now = middle(seconds_[0]), other = middle(seconds_[1]);
  const int fewer = std::min(at_, other_), more = std::max(at_, other_);
  const double of_fewer = upwards_ ? now : other, of_more = upwards_ ? other : now;
  gain_[fewer] = of_more > 0 ? of_fewer / of_more : 1;
  const int best = gain_[fewer] >= least_gain ? more : fewer;
  const bool changed = best != at_;
  at_ = best, tries_ = false;
  next_wait_ = changed ? least_wait : std::min(2 * next_wait_, longest_wait);
  wait_ = changed ? first_wait : next_wait_;
}

double ThreadChoice::gain() const {
  double gain = counts_[0] == 1 ? 1 : 0;
  for (int i = 0; i < at_; ++i) gain *= gain_[i];
  return gain;
}

}  // namespace trilith
