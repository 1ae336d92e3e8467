// Checkpoints of a model in its restart folder, and the continuation of a run from them.
#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "bindings/model/simulated_model.hpp"
#include "bindings/restart/restart_book.hpp"
#include "model/io/fingerprint.hpp"
#include "model/io/state_words.hpp"
#include "results/file/part_path.hpp"
#include "run/load_way.hpp"
#include "run/process_time.hpp"
#include "run/restart/stage_fields.hpp"

namespace trilith::script {

template <class File>
void each_field(File& file, Timer& t) {
  file.item(t.start), file.item(t.interval), file.item(t.next);
}
template <class File>
void each_field(File& file, HandlerCall& c) {
  file.item(c.function), file.item(c.has_event), file.item(c.event), file.item(c.index);
  file.item(c.kept);
}

namespace {

/// The options of a stage that its results depend on.
std::string asked_text(const StageOptions& o) {
  return fmt::format(
      "stage '{}' of {:.17g} s to {:.17g} s, dt {:.17g}, safety {:.17g}, local_damping {:.17g}, {}, "
      "tolerance {:.17g}, accuracy {:.17g} and {:.17g}{}{}{}",
      o.name, o.duration, o.end_time, o.dt, o.safety, o.rest_share, o.may_change ? "auto" : name_of(o.integrator),
      o.tolerance, o.accuracy, o.impact_accuracy,
      o.until_rest ? fmt::format(", until rest: {:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.9g}", o.still_from,
                                 o.still_speed, o.still_ratio, o.still_hold, o.within)
                   : "",
      o.mass_scaling ? fmt::format(", masses scaled for {:.17g}", o.mass_scaling->step) : "",
      o.watched ? "" : ", not watched");
}

void require_same_stage(const MomentHead& saved, const MomentHead& now, const std::string& owner) {
  if (saved.mark.asked != now.mark.asked)
    throw InputError(fmt::format("{}: stage {} has other options: they were {}, and are {}", owner, now.stage,
                                 saved.mark.asked, now.mark.asked));
  if (saved.mark.structure != now.mark.structure)
    throw InputError(
        fmt::format("{}: the script has built another model: bodies, laws or bearings differ at the start of stage {}; "
                    "it must read the same files, and neither the clock nor math.randomseed without a number",
                    owner, now.stage));
  if (saved.mark.conditions != now.mark.conditions)
    throw InputError(fmt::format("{}: supports, motions, gravity, damping or loads differ at the start of stage {}",
                                 owner, now.stage));
  if (saved.mark.state != now.mark.state)
    throw InputError(fmt::format("{}: the model has another state at the start of stage {}", owner, now.stage));
}

/// Gives the file with the rows of an interrupted run the name of its part file. Rows in the restart folder come first:
/// a continuation was interrupted before it had copied them, so its own files have none. A file that was being replaced
/// by one with more bodies comes next.
void gather_rows(const RestartFiles& files, const std::filesystem::path& results) {
  const std::filesystem::path kept = kept_rows(files), part = results::part_path(results),
                              replaced = results::replaced_part_path(results);
  std::error_code error;
  if (std::filesystem::exists(kept, error)) {
    std::filesystem::remove(replaced,
                            error);  // first, so that a kill between both calls leaves the rows in their place
    std::filesystem::rename(kept, part, error);
  } else if (std::filesystem::exists(replaced, error)) {
    std::filesystem::rename(replaced, part, error);
  }
}

/// Moves the rows of the interrupted run to the restart folder.
void take_rows(const RestartFiles& files, const std::filesystem::path& results) {
  gather_rows(files, results);
  std::error_code error;
  std::filesystem::rename(results::part_path(results), kept_rows(files), error);
}

/// Removes the checkpoints of an earlier run; its rows get another name when the file is opened. A run that still
/// writes keeps both, and the file cannot be opened.
void set_aside(const std::filesystem::path& results) {
  if (results::is_being_written(results::part_path(results))) return;
  RestartFiles files(restart_folder(results));
  gather_rows(files, results);
  files.remove_all();
}

/// True if a signal ends the run; with a console it only pauses.
bool is_signalled(const Host& host) {
  return host.interrupted != nullptr && host.console == nullptr && host.interrupted();
}

template <class T>
std::vector<T> tail(const std::vector<T>& all, std::size_t from) {
  return {all.begin() + static_cast<std::ptrdiff_t>(std::min(from, all.size())), all.end()};
}
template <class T>
void replace_tail(std::vector<T>& all, std::size_t from, std::vector<T> tail) {
  all.resize(std::min(from, all.size()));
  all.insert(all.end(), std::make_move_iterator(tail.begin()), std::make_move_iterator(tail.end()));
}

}  // namespace

template <int D>
void SimulatedModel<D>::open_restart(Host& host) {
  const RestartChoice& choice = host.restart;
  if (results && !choice.resumes) set_aside(std::filesystem::absolute(results->file));
  if (restart || (!(choice.every > 0) && !choice.resumes && !choice.in_memory)) return;
  restart = std::make_unique<RestartBook>();
  RestartBook& book = *restart;
  if (!choice.in_memory) book.files = RestartFiles(restart_folder(std::filesystem::absolute(results->file)));
  if (choice.from) book.files = *choice.from;
  book.every = choice.every;
  book.stored_at = coarse_clock();
  if (choice.resumes && !resume_point(book.files).empty()) {
    if (!choice.from) take_rows(book.files, std::filesystem::absolute(results->file));
    book.restoring = true;
    book.head.sequence = latest_checkpoint(book.files).second.sequence;
  }
  RestartCall call = choice.call;
  if (!choice.in_memory) call.own_folder = std::filesystem::weakly_canonical(book.files.folder()).string();
  ByteWriter out;
  out.item(call);
  book.files.put("call", out.take());
}

template <int D>
void SimulatedModel<D>::begin_kept_stage(const StageOptions& options, bool by_steps, bool typed) {
  RestartBook& book = *restart;
  const State<D>& state = simulation_->state();
  const Fingerprint print = model_fingerprint(simulation_->model(), state);
  ++book.head.stage;
  book.head.mark = {asked_text(options), print.structure, print.conditions, state_hash(state)};
  book.first_event = events.size(), book.first_sample = history_times.size(), book.first_note = notes().size();
  book.at_work = true, book.by_steps = by_steps;
  if (watch && book.off.empty()) book.off = "a pushover in time is computed again";
  if (typed && book.off.empty()) book.off = "a stage was started at the console";
}

template <int D>
std::string SimulatedModel<D>::moment(const StageReport* ended, const ScriptListener& listener) {
  RestartBook& book = *restart;
  book.head.ended = ended != nullptr, book.head.time = time();
  ++book.head.sequence;
  ByteWriter out;
  out.item(book.head);
  if (ended != nullptr) out.item(*ended);
  out.item(tail(events, book.first_event));
  simulation_->write(out);
  out.item(tail(history_times, book.first_sample));
  for (const History& h : histories) out.item(tail(h.values, book.first_sample));
  out.item(tail(notes(), book.first_note));
  out.item(timers), out.item(wake_at), out.item(has_step_handler);
  out.item(listener.kept());
  out.item(recording_ != nullptr);
  if (recording_) recording_->write(out);
  return out.take();
}

/// A failure does not end the run: the last checkpoint remains.
template <int D>
void SimulatedModel<D>::store_restart(Host& host) {
  RestartBook& book = *restart;
  if (recording_) recording_->flush();  // the rows that the checkpoint counts
  try {
    book.files.store();
    book.failure.clear();
  } catch (const InputError& error) {
    if (book.failure.empty()) tell_restart(host, fmt::format("a checkpoint cannot be written: {}", error.what()));
    book.failure = error.what();
  }
  book.stored_at = coarse_clock();
}

template <int D>
void SimulatedModel<D>::tell_restart(Host& host, const std::string& text) {
  if (host.observer != nullptr) host.observer->note(text);
}

template <int D>
void SimulatedModel<D>::end_kept_stage(const StageReport& report, const ScriptListener& listener, Host& host) {
  RestartBook& book = *restart;
  // A signal ends a search for equilibrium before its end, so that stage is repeated.
  const bool broken_off = book.signalled || is_signalled(host);
  if (book.keeps() && !broken_off) {
    std::string bytes = moment(&report, listener);
    book.stage_bytes += bytes.size();
    if (book.stage_bytes > most_of_changes) book.off = fmt::format("{} stages have ended", book.head.stage);
    book.files.put(stage_name(book.head.stage), std::move(bytes));
    if (book.due(coarse_clock())) store_restart(host);
  }
  book.at_work = false;
  book.effects_at_pause = effects;
}

/// At a step border: writes a checkpoint if one is due or a signal ends the run.
template <int D>
void SimulatedModel<D>::keep_checkpoint(const ScriptListener& listener, Host& host) {
  RestartBook& book = *restart;
  if (book.change_bytes > most_of_changes && !std::exchange(book.told, true))
    tell_restart(host, fmt::format("no further checkpoints: {}, and each change stores a state", book.off));
  if (!book.keeps() || simulation_->stopping()) return;
  const bool ends = is_signalled(host);
  if (!ends && !book.due(coarse_clock())) return;
  if (!std::exchange(book.looked, true))
    if (const std::string lost = listener.unkept(); !lost.empty()) tell_restart(host, lost);
  book.files.put(fmt::format("at-{}", book.head.sequence % 2), moment(nullptr, listener));
  store_restart(host);
  if (!ends) return;
  book.signalled = true;
  stop("by a signal, after a checkpoint");
}

template <int D>
void SimulatedModel<D>::keep_change(const HandlerCall* call) {
  if (!restart || !restart->keeps()) return;
  RestartBook& book = *restart;
  ByteWriter out;
  out.item(call != nullptr);
  if (call != nullptr) out.item(*call);
  if (call == nullptr) out.item(kept_cracks_);
  out.item(state_words(simulation_->state()));
  out.item(static_cast<std::uint64_t>(events.size() - book.first_event));
  out.item(static_cast<std::uint64_t>(history_times.size() - book.first_sample));
  std::string bytes = out.take();
  book.change_bytes += bytes.size();
  if (book.change_bytes > most_of_changes) {
    book.off = fmt::format("handlers changed the model {} times", book.head.changes);
    return;
  }
  book.files.put(change_name(++book.head.changes), std::move(bytes));
}

/// Repeats the changes by handlers up to number `last`, each in the state that it saw.
template <int D>
void SimulatedModel<D>::replay_changes(int last, const std::vector<Event>& all, const ScriptListener& listener) {
  RestartBook& book = *restart;
  const std::vector<Event> before = events;
  book.replaying = true;
  while (book.head.changes < last) {
    const std::string name = change_name(++book.head.changes), bytes = book.files.get(name);
    book.change_bytes += bytes.size();
    ByteReader in(bytes, "restart file '" + name + "'");
    std::optional<HandlerCall> call;
    in.item(call);
    if (!call) in.item(kept_cracks_);
    const auto words = in.get<std::vector<std::uint64_t>>();
    simulation_->put_state(state_from_words(simulation_->model(), words, in.owner()));
    events = before;
    const auto known = std::min<std::size_t>(all.size(), in.get<std::uint64_t>());
    events.insert(events.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(known));
    if (call)
      listener.replay(*call);
    else
      simulation_->apply([&](Model<D>& model) { return apply_changes(model); });
  }
  events = before;
  book.replaying = false;
}

/// Returns the model to the instant of the file `name`.
template <int D>
std::optional<StageReport> SimulatedModel<D>::go_to_moment(const std::string& name, const StageOptions& options,
                                                           const LoadWay<D>* way, const ScriptListener& listener,
                                                           bool is_last) {
  RestartBook& book = *restart;
  const std::string bytes = book.files.get(name), owner = fmt::format("restart file '{}'", name);
  ByteReader in(bytes, owner);
  const auto head = in.get<MomentHead>();
  require_same_stage(head, book.head, owner);
  std::optional<StageReport> ended;
  if (head.ended) in.item(ended.emplace());
  if (!head.ended) simulation_->keep_places(options);
  const auto happened = in.get<std::vector<Event>>();
  replay_changes(head.changes, happened, listener);
  if (ended && options.process)
    simulation_->apply([&](Model<D>& model) {
      postpone_by_process(model, *options.process, *ended);
      return true;
    });
  if (ended && way != nullptr)
    simulation_->apply([&](Model<D>& model) {
      postpone_by_way(model, *way);
      return true;
    });
  simulation_->read(in, head.ended ? nullptr : &options);
  replace_tail(events, book.first_event, happened);
  replace_tail(history_times, book.first_sample, in.get<std::vector<double>>());
  for (History& h : histories) replace_tail(h.values, book.first_sample, in.get<std::vector<double>>());
  for (const std::string& line : in.get<std::vector<std::string>>()) add_note(line);
  const auto known = timers.size();
  in.item(timers), in.item(wake_at), in.item(has_step_handler);
  if (timers.size() != known) in.fail("has other timers than the script");
  listener.keep_again(in.get<std::string>());
  stages_run_.push_back(options);
  *verdict_ = simulation_->verdict();
  if (is_last && in.get<bool>() && !book.files.folder().empty()) recording_->read(in, kept_rows(book.files));
  return ended;
}

/// The report of a stage that was completed before, or is continued now; nothing if the stage is new.
template <int D>
std::optional<StageReport> SimulatedModel<D>::restored_stage(const StageOptions& options,
                                                             const ScriptListener& listener, const LoadWay<D>* way,
                                                             const RunListener<D>& all, Host& host) {
  RestartBook& book = *restart;
  if (!book.looked) listener.watch_state();
  if (!book.restoring) return std::nullopt;
  const auto [latest, head] = latest_checkpoint(book.files);
  const bool is_done = book.files.has(stage_name(book.head.stage));
  const bool goes_on = !is_done && !latest.empty() && head.stage == book.head.stage;
  if (!is_done && !goes_on)
    throw InputError(fmt::format("restart: there is no checkpoint of stage {}", book.head.stage));
  const bool is_last =
      goes_on || (!book.files.has(stage_name(book.head.stage + 1)) && !(head.stage == book.head.stage + 1));
  const std::uint64_t sequence = book.head.sequence;
  const std::optional<StageReport> ended =
      go_to_moment(is_done ? stage_name(book.head.stage) : latest, options, way, listener, is_last);
  book.head.sequence = sequence;
  if (is_last) {
    std::error_code error;
    if (!book.files.folder().empty()) std::filesystem::remove(kept_rows(book.files), error);
    book.restoring = false;
    if (recording_ && host.restart.from) replay(*recording_);
    if (host.restart.from && !ended) pause_reason = "the saved instant";
    tell_restart(host, fmt::format("continues at {:.6g} s from the checkpoint", time()));
  }
  if (ended) {
    book.at_work = false;
    book.effects_at_pause = effects;
    return ended;
  }
  resumed_steps = simulation_->stage()->report.steps;
  return simulation_->resume(all);
}

template <int D>
void SimulatedModel<D>::end_by_signal() {
  if (!restart || restart->restoring || !restart->off.empty()) return;
  try {
    if (recording_) recording_->flush();
    restart->files.store();
  } catch (const std::runtime_error&) {  // earlier checkpoints remain
    return;
  }
}

template <int D>
std::string SimulatedModel<D>::close_restart(bool whole) {
  if (!restart) return "";
  if (whole) {
    restart->files.remove_all();
    return "";
  }
  const RestartFiles on_disk(restart->files.folder());
  const std::string point = on_disk.folder().empty() ? "" : resume_point(on_disk);
  return point.empty() ? "" : fmt::format("; `trilith resume {}` continues {}", results->file, point);
}

template <int D>
void SimulatedModel<D>::save_instant(const std::filesystem::path& file, const ScriptListener& listener) {
  const auto refuse = [](const std::string& why) {
    throw InputError("save: " + why + "; only an instant that the script reaches without the console can be saved");
  };
  if (!restart) refuse("no stage has run");
  RestartBook& book = *restart;
  if (!book.off.empty()) refuse(book.off);
  if (effects != book.effects_at_pause) refuse("the model was changed at the console");
  std::vector<std::string> names{"call"};
  const int done = paused_ ? book.head.stage - 1 : book.head.stage;
  for (int stage = 1; stage <= done; ++stage) names.push_back(stage_name(stage));
  for (int change = 1; change <= book.head.changes; ++change) names.push_back(change_name(change));
  if (paused_) {
    book.files.put("at-0", moment(nullptr, listener));
    names.emplace_back("at-0");
  }
  book.files.save_as(file, names);
}

#define TRILITH_RESTART(D)                                                                            \
  template void SimulatedModel<D>::open_restart(Host&);                                               \
  template void SimulatedModel<D>::begin_kept_stage(const StageOptions&, bool, bool);                 \
  template void SimulatedModel<D>::end_kept_stage(const StageReport&, const ScriptListener&, Host&);  \
  template void SimulatedModel<D>::keep_checkpoint(const ScriptListener&, Host&);                     \
  template void SimulatedModel<D>::keep_change(const HandlerCall*);                                   \
  template void SimulatedModel<D>::save_instant(const std::filesystem::path&, const ScriptListener&); \
  template void SimulatedModel<D>::end_by_signal();                                                   \
  template std::string SimulatedModel<D>::close_restart(bool);                                        \
  template std::optional<StageReport> SimulatedModel<D>::restored_stage(                              \
      const StageOptions&, const ScriptListener&, const LoadWay<D>*, const RunListener<D>&, Host&);
TRILITH_RESTART(2)
TRILITH_RESTART(3)
#undef TRILITH_RESTART

}  // namespace trilith::script
