#include "bindings/model/simulated_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/check/missing_laws.hpp"
#include "model/event/event_text.hpp"
#include "model/io/motion_hash.hpp"
#include "model/pose.hpp"
#include "run/missed_bonds.hpp"

namespace trilith::script {
namespace {

/// Note on faces that a law leaves unbonded because of the gap between them.
template <int D>
std::string missed_text(const Model<D>& model, const MissedBonds& missed) {
  return fmt::format(
      "law '{}' leaves {} without a bond, because '{}' and '{}' are {} apart. Faces are bonded at a gap of at most "
      "1e-5 "
      "of the smaller body's size, and 1e-3 for fresh mortar (m:consolidate{{ fresh = true }}); close the gap, or give "
      "another law there",
      model.law_names[missed.law],
      missed.count == 1 ? "a pair of faces" : fmt::format("{} pairs of faces", missed.count),
      model.bodies[missed.body_a].name, model.bodies[missed.body_b].name, quantity_text(missed.gap, "m"));
}

/// The first bearing that waits without a predecessor, or -1.
template <int D>
int idle_bearing(const Model<D>& model) {
  const auto& all = model.bearings;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].starts_waiting && std::none_of(all.begin(), all.end(), [i](const Bearing<D>& b) {
          return b.becomes_bearing == static_cast<int>(i);
        }))
      return static_cast<int>(i);
  return -1;
}

}  // namespace

template <int D>
Simulation<D>& SimulatedModel<D>::simulation() {
  if (!simulation_) {
    simulation_ = std::make_unique<Simulation<D>>(built_model());
    simulation_->set_cracking(cracking_bodies(simulation_->model()));
    caught_up_ = additions_;
    const MissedBonds missed = missed_bonds(simulation_->model(), simulation_->state());
    if (missed.count > 0) add_note(missed_text(simulation_->model(), missed));
    if (const int idle = idle_bearing(simulation_->model()); idle >= 0)
      add_note(
          fmt::format("bearing '{}' waits, but it is the successor of no bearing, so it never acts; name it in "
                      "`becomes` of another one, or leave out waiting",
                      simulation_->model().bearings[static_cast<std::size_t>(idle)].name));
  }
  return *simulation_;
}

template <int D>
const Simulation<D>& SimulatedModel<D>::evaluated() {
  Simulation<D>& s = simulation();
  s.refresh();
  return s;
}

template <int D>
const Findings<D>& SimulatedModel<D>::findings() {
  const Model<D>& model = simulation().model();
  if (!findings_) findings_.emplace(model);
  return *findings_;
}

/// Initial kinetic energy and initial contact energy are supplied without work and are not an error.
template <int D>
double SimulatedModel<D>::residual() {
  const double balance = energy().balance();
  return balance - balance_at_start_.value_or(balance);
}

template <int D>
void SimulatedModel<D>::change(std::function<void(Model<D>&)> what) {
  ++effects;
  if (running_ && !paused_) {
    changes_.push_back(std::move(what));
    return;
  }
  simulation().edit(what);
}

template <int D>
StepNumbers SimulatedModel<D>::step_numbers() {
  if (!simulation_) return {};
  const Simulation<D>& s = evaluated();
  const Work<D>& w = s.work();
  return {s.state().last_dt, s.state().step, w.fastest_moving, w.carried > 0 ? w.unbalanced / w.carried : 0};
}

template <int D>
std::uint64_t SimulatedModel<D>::hash() {
  return motion_hash(simulation().state());
}

template <int D>
std::string SimulatedModel<D>::step_text() {
  const Simulation<D>& s = evaluated();
  return explain_step(s.model(), s.state(), s.work());
}

template <int D>
std::string SimulatedModel<D>::text_of(const Event& event) const {
  return event_text(event, simulation_->model());
}

template <int D>
double SimulatedModel<D>::mass_of(int body) {
  return has_body(body) ? body_mass(simulation_->model(), body) : body_mass(lone_body(body), 0);
}

template <int D>
void SimulatedModel<D>::grow_weight(double end) {
  change([end](Model<D>& model) { model.gravity.grow_end = end; });
}

namespace {

/// A script may name its results "out/run.h5" in any working directory. If the folder cannot be created, the writer of
/// the results reports it.
void make_folder_of(const std::filesystem::path& file) {
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
}

}  // namespace

namespace {

/// Extends a state to the nodes of the model; added nodes are in their initial position.
template <int D>
State<D> begun_as(const Model<D>& model, State<D> state) {
  const std::size_t known = std::min(state.position.size(), model.mass.size());
  state.position.resize(model.mass.size()), state.rotation.resize(model.mass.size());
  for (std::size_t n = known; n < model.mass.size(); ++n)
    state.position[n] = model.start_position[n], state.rotation[n] = model.start_rotation[n];
  return state;
}

}  // namespace

template <int D>
void SimulatedModel<D>::begin_recording(Host& host) {
  if (recording_begun_) return;
  if (!host.results_file.empty()) {
    if (!results) results.emplace();
    results->file = std::exchange(host.results_file, "");
  }
  if (!results) return;
  if (host.restart.from) {  // keeps the results of the run that saved the instant
    const std::filesystem::path path = results->file;
    results->file = (path.parent_path() / (path.stem().string() + ".from" + path.extension().string())).string();
  }
  if (!host.case_folder.empty())
    results->file = (host.case_folder / std::filesystem::path(results->file).filename()).string();
  make_folder_of(host.room.writable(results->file, "results"));
  recording_begun_ = true;
  open_restart(host);
  open_recording(host);
  for (const std::string& text : notes()) note(text);
  for (auto& found : std::exchange(waiting_modes_, {}))
    if (!restoring()) recording_->modes(std::move(found));
  keep_until_finish(host);
}

template <int D>
void SimulatedModel<D>::keep_until_finish(Host& host) {
  const auto self = this->shared_from_this();
  if (std::find(host.recorded.begin(), host.recorded.end(), self) == host.recorded.end()) host.recorded.push_back(self);
}

template <int D>
void SimulatedModel<D>::record_modes(std::vector<results::ModeRow> found, Host& host) {
  if (restoring()) return;
  if (recording_) return recording_->modes(std::move(found));
  if (recording_begun_ || (!results && host.results_file.empty())) return;
  waiting_modes_.push_back(std::move(found));
  modes_host_ = &host;
  keep_until_finish(host);
}

template <int D>
void SimulatedModel<D>::open_recording(Host& host) {
  RecordingOptions<D> options;
  options.provenance = host.provenance(motions);
  options.provenance.model = name;
  options.materials = materials;
  options.histories = recorded_histories();
  options.with_velocity = results->with_velocity;
  options.with_joints = results->with_joints;
  if (!recorded_from_) recorded_from_ = simulation_->state();
  recording_ = std::make_unique<Recording<D>>(results->file, simulation_->model(),
                                              begun_as(simulation_->model(), *recorded_from_), std::move(options));
  const std::string kept = recording_->kept_from_before();
  if (kept.empty()) return;
  if (host.observer != nullptr) host.observer->clear();
  fmt::print(stderr, "note: {}\n", kept);
}

template <int D>
RunListener<D> SimulatedModel<D>::listen_with(const ScriptListener& script, Host& host) {
  RunObserver* const observer = host.observer;
  RunListener<D> all;
  if (recording_) {  // replaced after a rewind
    all.on_frame = [this](const Instant<D>& now) { recording_->frame(now); };
    all.on_energy = [this](const Instant<D>& now, const Energy& e) { recording_->energy(now, e); };
  }
  if (!histories.empty()) {
    all.on_history = [this, &script](const Instant<D>& now) {
      script.on_history();  // values of Lua functions come first
      take_histories(now.state.time);
    };
  }
  all.on_event = [this, observer, &script](const Event& e, const Instant<D>& now) {
    events.push_back(e);
    if (e.type == EventType::stage_begun) stages_run_.push_back(now.stage);
    if (recording_) recording_->event(e, now);
    if (observer != nullptr) observer->event(e, now);
    script.on_event(e);
  };
  all.on_step = [this, observer, &script](const Instant<D>& now) {
    if (recording_) recording_->step();
    if (observer != nullptr) observer->step(now);
    if (watch) watch(now);
    script.on_step(now.state.time, now.state.last_dt);
  };
  all.change_model = [this](Model<D>& model) { return apply_changes(model); };
  all.crack_bodies = [this](const std::vector<Crack<D>>& cracks) {
    kept_cracks_ = cracks;
    simulation_->apply([this](Model<D>& model) { return make_changes(model); });
  };
  all.is_stopped = script.is_stopped;
  if (script.at_border || checkpoints.on || restart || step_check_)
    all.at_border = [this, &script, &host] {
      if (step_check_) step_check_->look(*simulation_);
      if (restart) keep_checkpoint(script, host);
      // At the end of the removed run this one is compared with it: this checkpoint is stored with it, before its own,
      // because checkpoints of this run may be dropped.
      const bool meets = undone && !undone->passed && time() >= undone->checkpoints.back().time();
      if (meets) undone->checkpoints.insert(undone->checkpoints.begin(), checkpoint()), undone->passed = true;
      if (meets || checkpoints.due(*simulation_)) checkpoints.add(checkpoint());
      if (script.at_border) script.at_border();
    };
  return all;
}

template <int D>
void SimulatedModel<D>::take_histories(double time) {
  // A row that an interrupt left incomplete is omitted.
  const std::size_t rows = history_times.size();
  const bool whole =
      std::ranges::all_of(histories, [&](const History& h) { return h.sample || h.values.size() > rows; });
  if (!whole) {
    for (History& h : histories) h.values.resize(rows);
    return;
  }
  std::vector<double> row;
  row.reserve(histories.size());
  for (History& h : histories) {
    if (h.sample) h.values.push_back(h.sample());
    row.push_back(h.values.back());
  }
  history_times.push_back(time);
  if (recording_) recording_->history(time, row);
}

/// Cracks belong to the forces of the step that ends here, before other changes. A change that is repeated has its own.
template <int D>
void SimulatedModel<D>::find_cracks() {
  if (simulation_->cracking().bodies.empty() || (restart && restart->replaying)) return;
  CrackSearch<D> found = simulation_->search_cracks();
  simulation_->keep_crack_watch(std::move(found.watch));
  kept_cracks_ = std::move(found.cracks);
}

template <int D>
bool SimulatedModel<D>::apply_changes(Model<D>& model) {
  find_cracks();
  return make_changes(model);
}

/// Makes the waiting changes, and divides the bodies in `kept_cracks_`.
template <int D>
bool SimulatedModel<D>::make_changes(Model<D>& model) {
  if (changes_.empty() && caught_up_ == additions_ && kept_cracks_.empty()) return false;
  keep_change(nullptr);
  const int free_before = model.free_dofs();
  if (caught_up_ != additions_) extend();
  std::vector<std::function<void(Model<D>&)>> now;
  now.swap(changes_);
  for (const auto& what : now) what(model);
  if (!kept_cracks_.empty()) split(std::exchange(kept_cracks_, {}));
  if (model.free_dofs() > free_before) simulation_->drop_step();
  return true;
}

template <int D>
StageReport SimulatedModel<D>::run(const StageOptions& asked, const ScriptListener& listener, Host& host,
                                   const EquilibriumOptions* statics, AnyLoadWay way) {
  if (running_)
    throw InputError(fmt::format("{}: a stage runs already; begin the next one when it has ended", title()));
  Simulation<D>& s = simulation();
  catch_up();
  if (const std::vector<std::string> faults = standing_faults(); !faults.empty()) throw InputError(faults.front());
  require_laws(s.model());
  judge_standing();
  if (!balance_at_start_) balance_at_start_ = evaluated().energy().balance();
  for (; host.observer != nullptr && notes_shown_ < notes().size(); ++notes_shown_)
    host.observer->note(notes()[notes_shown_]);
  begin_recording(host);
  if (host.restart.in_memory) open_restart(host);
  StageOptions options = asked;
  if (!histories.empty()) options.history_interval = results ? results->histories : history_interval;
  if (recording_) {
    options.frame_interval = results->frames;
    options.energy_interval = results->energy;
  }
  if (host.console != nullptr && !checkpoints_chosen) checkpoints.on = true;
  if (!options.watched) {
    const std::string said = fmt::format("speeds and energies of the stage '{}' are not checked", options.name);
    note(said);
    if (host.observer != nullptr) host.observer->note(said);
  }
  s.choose_threads(host.threads_for(threads));
  if (host.profile.wanted) {
    s.measure(&host.profile.times);
    host.profile.laws = s.model().law_names;
  }
  step_check_.reset();
  if (host.check_step && statics == nullptr) step_check_.emplace(*host.check_step, options, s);
  const auto go = [&] {
    const RunListener<D> all = listen_with(listener, host);
    if (restart) begin_kept_stage(options, statics == nullptr, host.restart.script_ended);
    std::optional<StageReport> report;
    const auto* const found = std::get_if<const LoadWay<D>*>(&way);
    const LoadWay<D>* const own = found == nullptr ? nullptr : *found;
    if (restart) report = restored_stage(options, listener, own, all, host);
    if (!report) report = statics == nullptr ? s.run(options, all) : s.settle(options, *statics, all, own);
    if (restart) end_kept_stage(*report, listener, host);
    if (step_check_)
      if (const auto row = step_check_->repeat(s)) checked_step_.emplace(*row, report->begun);
    return *report;
  };
  return guarded_run(go, host);
}

template <int D>
void SimulatedModel<D>::run_on(const RunLimit& limit, const ScriptListener& listener, Host& host) {
  catch_up();
  paused_ = false;
  struct Scope {
    SimulatedModel& model;
    ~Scope() { model.paused_ = true; }
  } scope{*this};
  simulation_->run_on(listen_with(listener, host), limit);
}

template class SimulatedModel<2>;
template class SimulatedModel<3>;

}  // namespace trilith::script
