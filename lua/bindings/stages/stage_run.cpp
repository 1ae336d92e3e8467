#include "bindings/stages/stage_run.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "base/nearest.hpp"
#include "bindings/core/bindings.hpp"
#include "bindings/core/interrupt_watch.hpp"
#include "bindings/restart/random_state.hpp"
#include "statics/equilibrium.hpp"

namespace trilith::script {
namespace {

/// The library's functions in the model's own table, at fixed stack positions during the stage.
class Handlers {
 public:
  Handlers(lua_State* L, ScriptModel& model, Host& h)
      : L_(L), model_(model), host_(h), watch_(L, h), first_(lua_gettop(L) + 1) {
    lua_checkstack(L, 40);
    push_own_table(L, 1);
    const int own = lua_gettop(L);
    for (const char* name :
         {"dispatch", "tick", "wake", "stepped", "sample", "kept", "keep_again", "unkept", "watch_state"}) {
      lua_pushstring(L, name);
      lua_rawget(L, own);
    }
    lua_remove(L, own);
  }
  Handlers(const Handlers&) = delete;
  Handlers& operator=(const Handlers&) = delete;
  ~Handlers() { lua_settop(L_, first_ - 1); }

  [[nodiscard]] bool interrupted() const { return watch_.pressed(); }
  /// After the stage: an interrupt leaves the results unfinished, and its error is raised again.
  void end() {
    if (host_.console == nullptr && interrupted()) model_.break_off("interrupted");
    if (broken_off_) std::rethrow_exception(broken_off_);
    if (model_.restart && model_.restart->signalled) throw ScriptError("interrupted");
  }

  void event(const Event& e) {
    if ((model_.wanted_events >> static_cast<unsigned>(e.type) & 1U) == 0) return;
    if (leaves()) return;
    call_function({dispatch, true, e, 0, {}});
  }

  void step(double time, double dt) {
    if (leaves()) return;
    for (std::size_t i = 0; i < model_.timers.size(); ++i) {
      if (model_.timers[i].due() > time + 0.5 * dt) continue;
      model_.timers[i].next =
          static_cast<std::int64_t>((time + 0.5 * dt - model_.timers[i].start) / model_.timers[i].interval) + 1;
      call_function({tick, false, {}, static_cast<std::int64_t>(i) + 1, {}});
    }
    if (model_.wake_at <= time + 1e-12) call_function({wake, false, {}, 0, {}});
    if (model_.has_step_handler) call_function({stepped, false, {}, 0, {}});
  }

  /// Opens the console if requested; in a nested run it is open already, so the run only pauses.
  void border(bool nested) {
    if (host_.console->was_interrupted()) model_.pause_reason = "interrupted";
    if (nested || model_.pause_reason.empty()) return;
    const std::string why = std::exchange(model_.pause_reason, "");
    const std::uint64_t before = model_.effects;
    if (model_.restart) model_.restart->effects_at_pause = before;
    model_.pause([&] {
      lua_pushvalue(L_, 1);
      host_.console->open(L_, why);
    });
    if (model_.restart && model_.effects != before) model_.restart->off = "the model was changed at the console";
  }

  /// The handlers as a listener, which refers to this object.
  ScriptListener listener(bool nested) {
    ScriptListener l;
    l.on_event = [this](const Event& e) { event(e); };
    l.on_step = [this](double time, double dt) { step(time, dt); };
    l.on_history = [this] { sample_functions(); };
    l.is_stopped = [this] { return leaves_step(); };
    l.replay = [this](const HandlerCall& c) {
      host_.silent = true;
      restore_script(c.kept);
      call_function(c);
      lua_settop(L_, first_ + functions - 1);
      host_.silent = false;
    };
    l.kept = [this] { return packed(random_state(L_), tables_kept()); };
    l.unkept = [this] { return text_of(unkept); };
    l.watch_state = [this] { static_cast<void>(text_of(watch_state)); };
    l.keep_again = [this](const std::string& bytes) { restore_script(bytes); };
    if (host_.console != nullptr) l.at_border = [this, nested] { border(nested); };
    return l;
  }

  /// Result of the function at a stack index, given the model.
  bool holds(int function) {
    if (leaves()) return false;
    const int top = lua_gettop(L_);
    lua_pushvalue(L_, function);
    lua_pushvalue(L_, 1);
    const bool is = run(1, 1) && lua_toboolean(L_, -1) != 0;
    lua_settop(L_, top);
    return is;
  }

  /// Hands a new sample to the function of the script, if there is one.
  void give(const StageSamples& samples) {
    if (samples.function == 0 || !samples.due() || leaves()) return;
    const int top = lua_gettop(L_);
    lua_pushvalue(L_, samples.function);
    lua_pushvalue(L_, 1);
    samples.push();
    run(2);
    lua_settop(L_, top);
  }

  /// Values of the histories from Lua functions; an interrupt omits some.
  void sample_functions() {
    for (std::size_t i = 0; i < model_.histories.size(); ++i) {
      History& h = model_.histories[i];
      if (h.sample) continue;
      if (leaves()) return;
      const int top = lua_gettop(L_);
      if (call_function({sample, false, {}, static_cast<std::int64_t>(i) + 1, {}})) h.values.push_back(number_of(h));
      lua_settop(L_, top);
    }
  }

 private:
  enum Function { dispatch, tick, wake, stepped, sample, kept, keep_again, unkept, watch_state, functions };
  void begin(int f) { lua_pushvalue(L_, first_ + f); }

  /// Calls a function of the library. If it has a lasting effect, the call is stored for a restart. The value of
  /// `sample` remains on the stack. Returns false after an interrupt.
  bool call_function(const HandlerCall& c) {
    if (c.function == wake) model_.wake_at = unbounded;
    const std::uint64_t before = model_.effects;
    HandlerCall kept_call = c;
    const RandomState random = random_state(L_);
    const std::string tables = model_.finishes_step() ? tables_kept() : "";
    begin(c.function);
    if (c.has_event) push_event(L_, 1, c.event);
    if (c.function == tick || c.function == sample) lua_pushinteger(L_, c.index);
    const bool good = run(arguments(c), c.function == sample ? 1 : 0);
    if (good && model_.effects != before) {
      kept_call.kept = packed(random, tables);
      model_.keep_change(&kept_call);
    }
    return good;
  }
  static int arguments(const HandlerCall& c) {
    return c.has_event || c.function == tick || c.function == sample ? 1 : 0;
  }

  /// The bytes of the tables of m:keep.
  std::string tables_kept() { return model_.keeps_tables ? text_of(kept) : ""; }

  /// Restores the random numbers and the tables of m:keep.
  void restore_script(const std::string& all) {
    const std::string bytes = unpacked(L_, all);
    begin(keep_again);
    lua_pushlstring(L_, bytes.data(), bytes.size());
    call(L_, 1, 0);
  }

  /// Calls a function that returns a text.
  std::string text_of(Function f) {
    begin(f);
    call(L_, 0, 1);
    std::string text = lua_type(L_, -1) == LUA_TSTRING ? text_at(L_, -1) : "";
    lua_pop(L_, 1);
    return text;
  }

  /// True if an interrupt or a signal ends the stage: at its next border, as stopped, and without further Lua code.
  bool leaves() {
    if (model_.finishes_step()) return false;
    if (host_.console != nullptr || !interrupted()) return false;
    model_.stop("by a signal or an interruption");
    return true;
  }

  /// True if an interrupt or a signal ends the step itself, whose result is then dropped. A console waits for the end
  /// of the step. So does a checkpoint, for a few seconds; then the one before counts.
  bool leaves_step() {
    if (host_.console != nullptr || !interrupted()) return false;
    if (model_.finishes_step()) {
      const auto now = std::chrono::steady_clock::now();
      if (!heard_) heard_ = now;
      if (now - *heard_ < wait_for_checkpoint) return false;
      model_.restart->signalled = true;
    }
    return true;
  }

  /// Calls the function that begin() and the arguments have put on the stack. False if an interrupt ended it, which is
  /// not a failure.
  bool run(int arguments, int results = 0) {
    try {
      call(L_, arguments, results);
      return true;
    } catch (const ScriptError& e) {
      // With a console the run is not lost: it continues without that call. An interrupt is not a failure, and ends a
      // handler that hangs.
      if (host_.console != nullptr && !interrupted()) {
        const std::string said = e.what(), first = said.substr(0, said.find('\n'));
        model_.pause_reason += fmt::format("{}a handler failed: {}", model_.pause_reason.empty() ? "" : "; ", first);
        return false;
      }
      if (!leaves()) throw;
      broken_off_ = std::current_exception();
      return false;
    }
  }

  /// The number on top of the stack, from the function of a history. Throws InputError for anything else.
  [[nodiscard]] double number_of(const History& h) const {
    const double value = lua_type(L_, -1) == LUA_TNUMBER ? lua_tonumber(L_, -1) : unbounded;
    if (std::isfinite(value)) return value;
    throw InputError(
        fmt::format("history '{}': its function gave {}, must give a finite number", h.name, what_is(L_, -1)));
  }

  lua_State* L_;
  ScriptModel& model_;
  Host& host_;
  InterruptWatch watch_;
  int first_;
  static constexpr std::chrono::seconds wait_for_checkpoint{5};
  std::optional<std::chrono::steady_clock::time_point> heard_;  ///< first request to end a step
  std::exception_ptr broken_off_;  ///< error that an interrupt raised in a handler; raised again after the stage
};

/// Calls go(handlers, listener) with the script's handlers listening.
template <class Go>
StageReport listen(lua_State* L, ScriptModel& model, Host& h, Go&& go) {
  struct Running {
    int& count;
    explicit Running(int& c) : count(c) { ++count; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running() { --count; }
  } running(h.running);
  Handlers handlers(L, model, h);
  const StageReport report = go(handlers, handlers.listener(false));
  handlers.end();
  return report;
}

/// A stage begins before the command line was read: parameters are declared later, or never. Under a stock interpreter
/// words of another form may belong to the script.
void refuse_unread_arguments(const Host& h) {
  if (h.list_parameters && !h.script.empty()) throw InputError(parameters_listed);
  if (h.given_used) return;
  if (h.list_parameters) throw InputError("no parameters are declared before the first stage; see trilith.params");
  for (const std::string& word : h.given)
    if (word.find('=', 1) != std::string::npos && word.front() != '-')
      throw InputError(
          fmt::format("the script declares no parameters, so '{}' cannot be set; see trilith.params", word));
}

/// Checks from time to time whether bodies have fallen during a stage.
class Fallen {
 public:
  Fallen(const ScriptModel& model, const StageUntil& until) : model_(model), until_(until), start_(model.heights()) {}
  [[nodiscard]] bool look() {
    if (until_.drop <= 0 || (++steps_ + model_.resumed_steps) % steps_between_looks != 0) return false;
    const std::vector<double> now = model_.heights();
    int down = 0;
    for (std::size_t b = 0; b < start_.size(); ++b) down += start_[b] - now[b] > until_.drop ? 1 : 0;
    return down >= until_.bodies;
  }

 private:
  static constexpr std::int64_t steps_between_looks = 20;
  const ScriptModel& model_;
  StageUntil until_;
  std::vector<double> start_;  // [body] [m]; NaN for a fixed or absent body
  std::int64_t steps_ = 0;
};

}  // namespace

StageReport run_stage(lua_State* L, ScriptModel& model, const StageOptions& options, const StageUntil& until,
                      const StageSamples& samples) {
  Host& h = host(L);
  refuse_unread_arguments(h);
  return listen(L, model, h, [&](Handlers& handlers, ScriptListener listener) {
    model.build();
    Fallen fallen(model, until);
    std::string met;
    std::int64_t taken = 0;  // after an interruption
    if (until.steps > 0 || until.function != 0 || until.drop > 0 || samples.function != 0)
      listener.on_step = [&, inner = std::move(listener.on_step)](double time, double dt) {
        inner(time, dt);
        handlers.give(samples);
        if (until.function != 0 && met.empty() && handlers.holds(until.function)) met = "until_true became true";
        if (met.empty() && fallen.look()) met = collapse_reason;
        if (!met.empty() || (until.steps > 0 && ++taken + model.resumed_steps >= until.steps))
          model.stop(met.empty() ? "after the given number of steps" : met);
      };
    StageReport report = model.run(options, listener, h);
    return report;
  });
}

namespace {

/// Loads that are zero at this instant and non-zero later, each once: "'a', 'b'".
template <int D>
std::string loads_to_come(const SimulatedModel<D>& model) {
  if (model.if_built() == nullptr) return "";
  const double now = model.if_built()->state().time;
  std::vector<std::string> names;
  model.if_built()->model().loads.for_each([&]<class L>(const L& load) {
    if (!has_level<L> && load.curve.at(now) == 0 && !load.curve.spent(now) &&
        std::find(names.begin(), names.end(), load.name) == names.end())
      names.push_back(load.name);
  });
  return names.empty() ? "" : fmt::format("'{}'", fmt::join(names, "', '"));
}

/// A load curve depends on time, which does not advance in statics.
void tell_loads_to_come(lua_State* L, ScriptModel& model, const std::string& stage) {
  const PlaneModel* plane = as_plane(model);
  const std::string names = plane != nullptr ? loads_to_come(*plane) : loads_to_come(*as_space(model));
  if (names.empty()) return;
  tell_note(
      L, model,
      fmt::format("{}: no share of {} acts at {:g} s of its load curve, and statics takes no time; for the whole load "
                  "leave out load_curve, or run for some time first",
                  stage, names, model.time()));
}

}  // namespace

StageReport settle_stage(lua_State* L, ScriptModel& model, const StageOptions& options, const EquilibriumOptions& how,
                         AnyLoadWay way, const StageSamples& samples) {
  Host& h = host(L);
  refuse_unread_arguments(h);
  tell_loads_to_come(L, model, options.name);
  return listen(L, model, h, [&](Handlers& handlers, ScriptListener listener) {
    EquilibriumOptions asked = how;
    asked.is_stopped = [&handlers] { return handlers.interrupted(); };
    if (samples.function != 0)
      listener.on_step = [&, inner = std::move(listener.on_step)](double time, double dt) {
        inner(time, dt);
        handlers.give(samples);
      };
    return model.run(options, listener, h, &asked, way);
  });
}

StageReport resume_stage(lua_State* L, ScriptModel& model) {
  Host& h = host(L);
  return listen(L, model, h,
                [&](Handlers& /*handlers*/, const ScriptListener& listener) { return model.resume(listener, h); });
}

void save_instant(lua_State* L, ScriptModel& model, const std::filesystem::path& file) {
  Host& h = host(L);
  Handlers handlers(L, model, h);
  model.save_instant(h.room.writable(file, "save"), handlers.listener(true));
}

void run_on(lua_State* L, ScriptModel& model, RunLimit limit) {
  Host& h = host(L);
  limit.leave = [&model] { return !model.pause_reason.empty(); };
  Handlers handlers(L, model, h);
  model.run_on(limit, handlers.listener(true), h);
}

}  // namespace trilith::script
