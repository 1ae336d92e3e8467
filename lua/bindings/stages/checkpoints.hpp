// Checkpoints of a model in memory, and the branch that a rewind has removed. No Lua here.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "run/simulation.hpp"

namespace trilith::script {

/// A periodic call, counted from its start so that rounding errors do not accumulate.
struct Timer {
  double start = 0, interval = 0;
  std::int64_t next = 1;
  [[nodiscard]] double due() const { return start + static_cast<double>(next) * interval; }
};

struct CheckpointOptions {
  double every = 0.1;    ///< simulated time between them [s]
  int count = 400;       ///< largest number kept
  double bytes = 256e6;  ///< largest memory [bytes]
};

/// A snapshot, and the number of the script's rows at that time.
struct Checkpoint {
  std::variant<Snapshot<2>, Snapshot<3>> snapshot;
  std::size_t events = 0, samples = 0;
  std::vector<Timer> timers;
  double wake_at = unbounded;
  std::size_t bytes = 0;
  template <int D>
  [[nodiscard]] const Snapshot<D>& snapshot_in() const {
    return std::get<Snapshot<D>>(snapshot);
  }
  [[nodiscard]] double time() const {
    return std::visit([](const auto& s) { return s.state.time; }, snapshot);
  }
  /// Begin of its stage [s].
  [[nodiscard]] double stage_begun() const {
    return std::visit([](const auto& s) { return s.stage->report.begun; }, snapshot);
  }
};

/// The latest checkpoints; the oldest is dropped beyond the limits.
class Checkpoints {
 public:
  CheckpointOptions options;
  bool on = false;

  /// True if a checkpoint is due: the first of a stage, and then one every `every`.
  template <int D>
  [[nodiscard]] bool due(const Simulation<D>& now) const {
    return on &&
           (list_.empty() || now.state().time >= next_ || now.stage()->report.begun != list_.back().stage_begun());
  }
  void add(Checkpoint checkpoint);
  /// The nearest one to `time`, nullptr if there is none.
  [[nodiscard]] const Checkpoint* nearest(double time) const;
  /// Removes and returns all after `time`, oldest first.
  std::vector<Checkpoint> take_after(double time);
  /// Drops the oldest until the limits are satisfied.
  void drop_oldest();
  [[nodiscard]] const std::deque<Checkpoint>& list() const { return list_; }
  /// Memory size [bytes]; a model shared by several counts once.
  [[nodiscard]] std::size_t bytes() const;

 private:
  std::deque<Checkpoint> list_;
  double next_ = 0;
};

/// Results of a run before it was removed by a rewind.
struct Branch {
  std::vector<Checkpoint> checkpoints;       ///< after the checkpoint of the rewind; the last one is at its end
  std::vector<Event> events;                 ///< all of them
  std::vector<double> times;                 ///< of the samples [s]
  std::vector<std::vector<double>> samples;  ///< [history]
  bool passed = false;                       ///< the present run has reached its end time
  double from = 0;                           ///< time at which the branches separate [s]
};

/// Memory of a state and of a model [bytes].
template <int D>
std::size_t bytes_of(const State<D>& state);
template <int D>
std::size_t bytes_of(const Model<D>& model);

}  // namespace trilith::script
