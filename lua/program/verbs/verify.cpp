// trilith verify [NAME ...]
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/terminal_text.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/guard.hpp"
#include "bindings/core/open.hpp"
#include "draw/chart/chart.hpp"
#include "program/interrupt.hpp"
#include "program/live.hpp"
#include "program/positive.hpp"
#include "program/screen.hpp"
#include "program/script/room_options.hpp"
#include "program/script/run.hpp"
#include "program/script/state.hpp"
#include "program/verbs.hpp"
#include "run/study/processes.hpp"

namespace trilith::program {
namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
  std::vector<std::string> names;
  std::string scripts, pages, compare;
  std::string file;    ///< of the cases that this process runs itself; "" in the process that starts the others
  std::string output;  ///< folder for the output of the processes
  int jobs = 0;
  bool list = false, quick = false;
  bool experiments = false;  ///< scripts/experiments instead of scripts/verification
};

/// Folders that may hold the scripts of the cases, as record_folders.
fs::path cases_folder(const VerifyOptions& options) {
  std::vector<fs::path> places;
  if (!options.scripts.empty()) {
    places.emplace_back(options.scripts);
  } else {
    const char* name = options.experiments ? "experiments" : "verification";
    if (const fs::path prefix = script::installed_under(); !prefix.empty())
      places.push_back(prefix / TRILITH_DATA / "trilith/examples" / name);
    places.push_back(fs::path(TRILITH_INSTALLED_CASES).parent_path() / name);
    places.push_back(fs::path(TRILITH_SOURCE_CASES).parent_path() / name);
  }
  std::error_code error;
  for (const fs::path& place : places)
    if (fs::is_directory(place, error)) return place;
  throw InputError(fmt::format("verify: there is no folder {}; give the folder of the cases with --scripts",
                               places.back().string()));
}

/// Scripts in the folder, without the modules that they share, which lie in folders `shared`.
std::vector<std::string> case_files(const fs::path& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".lua" && entry.path().parent_path().filename() != "shared")
      files.push_back(entry.path().string());
  std::ranges::sort(files);
  if (files.empty()) throw InputError(fmt::format("verify: {} has no cases", folder.string()));
  return files;
}

// Functions for Lua, all guarded.

std::vector<std::string> texts_at(lua_State* L, int index) {
  std::vector<std::string> texts;
  index = lua_absindex(L, index);
  for (lua_Integer i = 1; lua_rawgeti(L, index, i) != LUA_TNIL; ++i, lua_pop(L, 1))
    texts.push_back(script::text_at(L, -1));
  lua_pop(L, 1);
  return texts;
}

/// processes(list of lists of words after this program's name, how many at a time, f(number, output, errors, trouble),
/// folder for their output). Runs them. f is called with the output of each, and how it ended. False where a signal
/// ended them.
int run_all(lua_State* L) {
  std::vector<ProcessOrder> orders;
  const fs::path folder = script::text_at(L, 4);
  for (lua_Integer i = 1; lua_rawgeti(L, 1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
    std::vector<std::string> words = texts_at(L, -1);
    words.insert(words.begin(), program_path());
    orders.push_back({words, folder / fmt::format("{}.out", i), folder / fmt::format("{}.err", i)});
  }
  lua_pop(L, 1);
  ProcessWatch watch;
  watch.begun = [](std::size_t) {};
  watch.goes_on = [] { return signal_code() == 0; };
  watch.ended = [&](std::size_t i, const ProcessEnd& end) {
    lua_pushvalue(L, 3);
    lua_pushinteger(L, static_cast<lua_Integer>(i) + 1);
    for (const std::string& text : {text_of_file(orders[i].out, "output", script::largest_script),
                                    text_of_file(orders[i].errors, "errors", script::largest_script), end.trouble()})
      lua_pushlstring(L, text.data(), text.size());
    script::call(L, 4, 0);
  };
  const int jobs = static_cast<int>(lua_tointeger(L, 2));
  lua_pushboolean(L, run_processes(orders, jobs > 0 ? jobs : processors(), watch) ? 1 : 0);
  return 1;
}

/// The text of the field of the table at `index`.
std::string field(lua_State* L, int index, const char* name) {
  lua_pushstring(L, name);
  lua_rawget(L, index < 0 ? index - 1 : index);
  std::string text = script::text_at(L, -1);
  lua_pop(L, 1);
  return text;
}

std::vector<double> numbers_at(lua_State* L, int index, const char* name) {
  std::vector<double> numbers;
  lua_pushstring(L, name);
  lua_rawget(L, index - 1);
  for (lua_Integer i = 1; lua_istable(L, -1) && lua_rawgeti(L, -1, i) == LUA_TNUMBER; ++i, lua_pop(L, 1))
    numbers.push_back(lua_tonumber(L, -1));
  lua_pop(L, lua_istable(L, -1) ? 1 : 2);
  return numbers;
}

/// The axis "x" or "y" of the chart at stack index 1.
draw::ChartAxis axis_of(lua_State* L, const std::string& name) {
  draw::ChartAxis axis{field(L, 1, (name + "_label").c_str()), field(L, 1, (name + "_unit").c_str())};
  if (field(L, 1, "scale") == "logarithmic") axis.scale = draw::AxisScale::logarithmic;
  return axis;
}

/// chart({ title =, x_label =, x_unit =, y_label =, y_unit =, scale =, [1..] = { name =, x =, y =, kind = } }, file)
int draw_plot(lua_State* L) {
  draw::Chart chart;
  chart.title = field(L, 1, "title");
  chart.x = axis_of(L, "x");
  draw::ChartPanel panel{axis_of(L, "y"), {}};
  for (lua_Integer i = 1; lua_rawgeti(L, 1, i) == LUA_TTABLE; ++i, lua_pop(L, 1)) {
    draw::ChartSeries series{field(L, -1, "name"), numbers_at(L, -1, "x"), numbers_at(L, -1, "y")};
    const std::string kind = field(L, -1, "kind");
    series.points = kind == "points";
    series.joined = kind != "points";
    if (kind == "dashed") series.dash = draw::Dash::dashed;
    panel.series.push_back(std::move(series));
  }
  chart.panels.push_back(std::move(panel));
  const fs::path file = script::text_at(L, 2);
  if (file.has_parent_path()) fs::create_directories(file.parent_path());
  draw::draw_chart(chart, file, {.width = 380, .panel_height = 190});
  return 0;
}

/// status(text), a line that is redrawn; without a text it is cleared
int show_status(lua_State* L) {
  auto& screen = *static_cast<Screen*>(lua_touserdata(L, lua_upvalueindex(1)));
  if (lua_isnoneornil(L, 1))
    screen.clear();
  else
    screen.status(script::text_at(L, 1));
  return 0;
}

void set_texts(lua_State* L, const char* name, const std::vector<std::string>& texts) {
  lua_newtable(L);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    lua_pushlstring(L, texts[i].data(), texts[i].size());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, name);
}

void set_text(lua_State* L, const char* name, const std::string& text) {
  if (text.empty()) return;
  lua_pushlstring(L, text.data(), text.size());
  lua_setfield(L, -2, name);
}

/// (options, screen): pushes the table that the library gets.
int push_order(lua_State* L) {
  const auto& options = *static_cast<const VerifyOptions*>(lua_touserdata(L, 1));
  lua_newtable(L);
  set_texts(L, "names", options.names);
  set_text(L, "pages", options.pages);
  set_text(L, "compare", options.compare);
  set_text(L, "file", options.file);
  set_text(L, "output", options.output);
  if (options.file.empty()) {
    const fs::path folder = cases_folder(options);
    set_texts(L, "files", case_files(folder));
    set_text(L, "folder", folder.string());
  }
  for (const auto& [name, value] : {std::pair("list", options.list), std::pair("quick", options.quick),
                                    std::pair("experiments", options.experiments)}) {
    lua_pushboolean(L, value ? 1 : 0);
    lua_setfield(L, -2, name);
  }
  lua_pushinteger(L, options.jobs);
  lua_setfield(L, -2, "jobs");
  lua_pushcfunction(L, script::guarded<run_all>);
  lua_setfield(L, -2, "processes");
  lua_pushcfunction(L, script::guarded<draw_plot>);
  lua_setfield(L, -2, "chart");
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, script::guarded<show_status>, 1);
  lua_setfield(L, -2, "status");
  return 1;
}

/// (options, screen): runs the files of the library, each of which adds to one table; the last gives the exit code.
int run_library(lua_State* L) {
  lua_pushcfunction(L, script::guarded<push_order>);
  lua_insert(L, 1);
  lua_call(L, 2, 1);
  for (const char* name : {"verification_cases", "verification_judge", "verification_pages", "verification"}) {
    script::load_library_file(L, name);
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
  }
  return 1;
}

/// A folder for the output of the processes, removed at the end.
class OutputFolder {
 public:
  OutputFolder() : path_((fs::temp_directory_path() / "trilith-verify-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr) throw InputError("verify: no folder can be made at " + path_);
  }
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

void on_signal(lua_State* L, lua_Debug* at) {
  raise_interrupt(L, at);
}

int verify(VerifyOptions options) {
  std::optional<OutputFolder> folder;
  if (options.file.empty()) options.output = folder.emplace().path();
  Screen screen(stderr);
  script::Host host;
  host.script = options.file.empty() ? (cases_folder(options) / "case.lua").string() : options.file;
  host.records = script::record_folders();
  host.threads = 1;
  set_room(host, {});
  Live cautions(stdout, EventLines(), true);  // the process that starts this one prints them below the subject
  if (!options.file.empty()) host.observer = &cautions;
  const ScriptState state = new_script_state(host);
  lua_State* L = state.get();
  const InterruptScope scope(L, on_signal);
  host.interrupted = is_interrupted;
  lua_pushcfunction(L, run_library);
  lua_pushlightuserdata(L, &options);
  lua_pushlightuserdata(L, &screen);
  if (lua_pcall(L, 2, 1, 1) == LUA_OK) return static_cast<int>(lua_tointeger(L, -1));
  screen.clear();
  if (signal_code() != 0) return signal_code();
  const std::string message = message_at_top(L);  // names the file; without the traceback of the library
  fmt::print(stderr, "{}\n", terminal_text(message.substr(0, message.find("\nstack traceback:"))));
  return wrong_input;
}

}  // namespace

void add_verify(CLI::App& app, int& code) {
  auto o = std::make_shared<VerifyOptions>();
  CLI::App* verb = app.add_subcommand(
      "verify",
      "Run the cases of the verification manual and print exact value, computed value and error of each; it ends with "
      "3 where a case fails");
  verb->add_option("names", o->names, "subjects, files or cases, as --list shows them; * matches any letters")
      ->type_name("NAME");
  verb->add_flag("--list", o->list, "list the cases and exit");
  verb->add_flag("--quick", o->quick, "leave out the slow cases; run experiments with coarse settings");
  verb->add_flag("--experiments", o->experiments,
                 "run models of measured structures instead, and compare with the measured values");
  verb->add_option("-j,--jobs", o->jobs, "files of cases at a time; as many as there are processors where not given")
      ->type_name("N")
      ->check(CLI::Validator(is_count, "", ""));
  verb->add_option("--scripts", o->scripts, "folder of the cases, instead of those installed with the program")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--pages", o->pages, "write a Markdown page for each subject, and its plots, into DIR")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--compare", o->compare, "check that the pages in DIR agree with the cases that ran")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--file", o->file)->group("");
  verb->callback([o, &code] { code = verify(*o); });
}

}  // namespace trilith::program
