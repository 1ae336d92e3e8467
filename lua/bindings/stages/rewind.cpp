// Rewinding: restored parts of a model, and its results file.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "bindings/model/simulated_model.hpp"

namespace trilith::script {
namespace {

/// "bridge.h5" -> "bridge.branch2.h5"
std::string branch_file(const std::string& file, int branch) {
  const std::filesystem::path path = file;
  return (path.parent_path() / fmt::format("{}.branch{}{}", path.stem().string(), branch, path.extension().string()))
      .string();
}

const Checkpoint& require_checkpoint(const ScriptModel& model, double time) {
  const Checkpoints& kept = model.checkpoints;
  if (time > model.time() + 1e-9)
    throw InputError(
        fmt::format("rewind: the present time is {:.4f} s, and {:.6g} s is later; run on instead", model.time(), time));
  if (kept.list().empty())
    throw InputError("rewind: there is no checkpoint; they are taken while a stage runs, see checkpoints");
  const double oldest = kept.list().front().time();
  if (time < oldest - kept.options.every)
    throw InputError(
        fmt::format("rewind: the oldest checkpoint is at {:.4f} s, {:.4f} s back; to go back further, keep more "
                    "checkpoints, see checkpoints",
                    oldest, model.time() - oldest));
  return *kept.nearest(time);
}

/// During a pause only the running stage can be rewound.
void require_same_stage(double begun, const Checkpoint& checkpoint) {
  if (checkpoint.stage_begun() != begun)
    throw InputError(fmt::format(
        "rewind: the stage that pauses here began at {:.4f} s; to go back before that, end it first with stop", begun));
}

}  // namespace

template <int D>
Checkpoint SimulatedModel<D>::checkpoint() {
  return {simulation_->snapshot(), events.size(), history_times.size(), timers, wake_at, 0};
}

template <int D>
double SimulatedModel<D>::rewind(double time, Host& host) {
  if (!simulation_) throw InputError("rewind: the model has not run yet");
  if (running_ && !paused_) throw InputError("rewind: a stage runs; pause it first");
  const Checkpoint& found = require_checkpoint(*this, time);
  if (paused_) require_same_stage(simulation_->stage()->report.begun, found);
  if (paused_ && watch)
    throw InputError("rewind: a pushover samples its curve as it goes and cannot go back; end it first with stop");
  if (restart) restart->off = "the run went back in time";
  const double left = simulation_->state().time, to = found.time();
  Branch branch;
  branch.from = to;
  branch.events = events;
  branch.times = history_times;
  for (const History& h : histories) branch.samples.push_back(h.values);
  Checkpoint end = checkpoint();
  simulation_->restore(found.snapshot_in<D>());
  forget_added();
  *verdict_ = simulation_->verdict();
  events.resize(found.events);
  history_times.resize(found.samples);
  for (History& h : histories) h.values.resize(std::min(h.values.size(), found.samples));
  timers = found.timers;
  wake_at = found.wake_at;
  const auto begun = static_cast<std::size_t>(
      std::count_if(events.begin(), events.end(), [](const Event& e) { return e.type == EventType::stage_begun; }));
  stages_run_.resize(begun);
  branch.checkpoints = checkpoints.take_after(to);
  branch.checkpoints.push_back(std::move(end));
  undone = std::move(branch);
  broken_.clear();
  pause_reason.clear();
  if (recording_) {
    const std::unique_ptr<Recording<D>> before = std::move(recording_);
    continue_recording(host, left, *before);
    before->abandon(
        fmt::format("went back from {:.6g} s to {:.6g} s; continues in {}", left, to, recording_->path().string()));
  }
  return to;
}

template <int D>
void SimulatedModel<D>::continue_recording(Host& host, double left, const Recording<D>& before) {
  const std::string first = results->file;
  static_cast<void>(host.room.writable(branch_file(first, branches_ + 1), "results"));
  results->file = branch_file(first, ++branches_);
  open_recording(host);
  results->file = first;
  replay(*recording_);
  recording_->continue_ledger(before);
  const double now = simulation_->state().time;
  recording_->note(
      fmt::format("branch {}: the run went back from {:.6g} s to {:.6g} s; frames and energy before that are in {}",
                  branches_, left, now, before.part().string()));
}

/// Writes events, stages and samples up to now, so that causes and histories are complete.
template <int D>
void SimulatedModel<D>::replay(Recording<D>& recording) {
  std::size_t stage = 0;
  double begun = 0;
  for (const Event& e : events) {
    if (e.type == EventType::stage_begun) ++stage, begun = e.time;
    if (stage == 0) continue;
    const Instant<D> then{
        simulation_->model(), simulation_->state(), simulation_->work(), stages_run_[stage - 1], begun, 0, 0, 0};
    recording.event(e, then);
  }
  std::vector<double> row(histories.size());
  for (std::size_t i = 0; i < history_times.size(); ++i) {
    for (std::size_t k = 0; k < histories.size(); ++k) row[k] = histories[k].values[i];
    recording.history(history_times[i], row);
  }
}

template <int D>
StageReport SimulatedModel<D>::resume(const ScriptListener& listener, Host& host) {
  if (running_) throw InputError("continue: a stage runs already");
  if (!simulation_ || simulation_->stage() == nullptr)
    throw InputError("continue: no stage is paused; begin one with run, consolidate or shake");
  return guarded_run([&] { return simulation_->resume(listen_with(listener, host)); }, host);
}

template <int D>
void SimulatedModel<D>::note(const std::string& text) {
  if (recording_ && !restoring()) recording_->note(text);
}

template Checkpoint SimulatedModel<2>::checkpoint();
template double SimulatedModel<2>::rewind(double, Host&);
template void SimulatedModel<2>::continue_recording(Host&, double, const Recording<2>&);
template void SimulatedModel<2>::replay(Recording<2>&);
template StageReport SimulatedModel<2>::resume(const ScriptListener&, Host&);
template void SimulatedModel<2>::note(const std::string&);
template Checkpoint SimulatedModel<3>::checkpoint();
template double SimulatedModel<3>::rewind(double, Host&);
template void SimulatedModel<3>::continue_recording(Host&, double, const Recording<3>&);
template void SimulatedModel<3>::replay(Recording<3>&);
template StageReport SimulatedModel<3>::resume(const ScriptListener&, Host&);
template void SimulatedModel<3>::note(const std::string&);

}  // namespace trilith::script
