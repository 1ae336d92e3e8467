// Checkpoints of a model in memory, and the branch that going back to one has undone. No Lua here.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "run/simulation.hpp"

namespace trilith::script {

/// A call that falls due again and again, counted from its start so that no rounding adds up.
struct Timer {
  double start = 0, interval = 0;
  std::int64_t next = 1;
  [[nodiscard]] double due() const { return start + static_cast<double>(next) * interval; }
};

struct CheckpointOptions {
  double every = 0.1;    ///< simulated time between them [s]
  int count = 400;       ///< at most so many are kept
  double bytes = 256e6;  ///< in at most so many bytes
};

/// A snapshot, and how far the script's own rows had come.
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
  /// When its stage began [s].
  [[nodiscard]] double stage_begun() const {
    return std::visit([](const auto& s) { return s.stage->report.begun; }, snapshot);
  }
};

/// The latest checkpoints; the oldest goes where there are too many.
class Checkpoints {
 public:
  CheckpointOptions options;
  bool on = false;

  /// True where one is to be taken: the first of a stage, and then one each `every`.
  template <int D>
  [[nodiscard]] bool due(const Simulation<D>& now) const {
    return on &&
           (list_.empty() || now.state().time >= next_ || now.stage()->report.begun != list_.back().stage_begun());
  }
  void add(Checkpoint checkpoint);
  /// The nearest one to `time`, nullptr where there is none.
  [[nodiscard]] const Checkpoint* nearest(double time) const;
  /// Takes out all after `time`, oldest first.
  std::vector<Checkpoint> take_after(double time);
  /// Drops the oldest until options are kept to.
  void drop_oldest();
  [[nodiscard]] const std::deque<Checkpoint>& list() const { return list_; }
  /// Memory they take [bytes]; a model that several share counts once.
  [[nodiscard]] std::size_t bytes() const;

 private:
  std::deque<Checkpoint> list_;
  double next_ = 0;
};

/// What a run came to before it was taken back.
struct Branch {
  std::vector<Checkpoint> checkpoints;       ///< after the one gone back to; the last is where it ended
  std::vector<Event> events;                 ///< all of them
  std::vector<double> times;                 ///< of the samples [s]
  std::vector<std::vector<double>> samples;  ///< [history]
  bool passed = false;                       ///< the present run has come to where it ended
  double from = 0;                           ///< where the branches part [s]
};

/// Memory of a state and of a model [bytes].
template <int D>
std::size_t bytes_of(const State<D>& state);
template <int D>
std::size_t bytes_of(const Model<D>& model);

}  // namespace trilith::script
