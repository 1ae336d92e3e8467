// trilith doctor
#include <fmt/format.h>
#include <lua.h>
#include <stdlib.h>
#include <unistd.h>

#include <Eigen/Core>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/terminal_text.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/host.hpp"
#include "bindings/core/open.hpp"
#include "draw/picture_font.hpp"
#include "program/script/run.hpp"
#include "program/verbs.hpp"
#include "results/file/provenance.hpp"
#include "results/reading/reader.hpp"
#include "run/study/processes.hpp"

namespace trilith::program {
namespace {

namespace fs = std::filesystem;

/// A checked item, its error, and advice.
struct Finding {
  std::string what, wrong, remedy;  ///< wrong: "" if it is in order
};

/// A separate folder in the temporary one, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "trilith-doctor-XXXXXX").string();
    if (!error && ::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code error;
    if (!path_.empty()) fs::remove_all(path_, error);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }  ///< "" if it could not be created

 private:
  fs::path path_;
};

/// Output of a command and its end.
struct Answer {
  std::map<std::string, std::string> said;  ///< lines "motion 0123", by their first word
  std::string trouble;                      ///< "" if it ended without error
};

/// Runs a command and reads its lines. `name`: name of its files in `folder`.
Answer ask(const fs::path& folder, const std::string& name, const std::vector<std::string>& command) {
  const std::vector<ProcessOrder> orders{{command, folder / (name + ".out"), folder / (name + ".err")}};
  Answer answer;
  ProcessWatch watch;
  watch.begun = [](std::size_t) {};
  watch.ended = [&](std::size_t, const ProcessEnd& end) { answer.trouble = end.trouble(); };
  watch.goes_on = [] { return true; };
  run_processes(orders, 1, watch);
  std::ifstream out(orders[0].out), errors(orders[0].errors);
  for (std::string word, rest; out >> word && std::getline(out >> std::ws, rest);) answer.said[word] = rest;
  std::string first;
  if (!answer.trouble.empty() && std::getline(errors, first)) answer.trouble += ": " + first;
  return answer;
}

/// A program in the search path of the shell; "" if there is none.
fs::path in_search_path(const std::string& name) {
  const char* const folders = std::getenv("PATH");
  const std::string all = folders == nullptr ? "" : folders;
  for (std::size_t from = 0; from <= all.size();) {
    const std::size_t colon = std::min(all.find(':', from), all.size());
    const fs::path found = fs::path(all.substr(from, colon - from)) / name;
    if (found.is_absolute() && ::access(found.c_str(), X_OK) == 0) return found;
    from = colon + 1;
  }
  return {};
}

/// The module of this program: from its build tree, or installed with it; "" if there is none.
fs::path module_beside() {
  std::vector<fs::path> places{fs::path(program_path()).parent_path() / "module/trilith.so"};
  if (const fs::path prefix = script::installed_under(); !prefix.empty()) {
    places.push_back(prefix / "lib/lua/5.4/trilith.so");
    std::error_code error;  // lib/x86_64-linux-gnu, lib64
    for (const auto& entry : fs::directory_iterator(prefix / "lib", error))
      places.push_back(entry.path() / "lua/5.4/trilith.so");
    places.push_back(prefix / "lib64/lua/5.4/trilith.so");
  }
  for (const fs::path& place : places)
    if (fs::exists(place)) return place;
  return {};
}

Finding program_finding() {
  const results::Provenance here = results::provenance_here();
  const std::string commit = here.git_commit.empty() ? "" : fmt::format(" ({})", here.git_commit);
  return {fmt::format("trilith {}{}: {}", TRILITH_VERSION, commit, program_path()), "", ""};
}

Finding libraries_finding() {
  return {
      fmt::format("built by {} with {}, Eigen {}.{}.{}; runs with HDF5 {}", results::provenance_here().compiler,
                  LUA_RELEASE, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, results::hdf5_version()),
      "", ""};
}

/// Results do not depend on these instructions (docs/decisions/code/0011-same-bits.md), but runs take longer without
/// them.
Finding processor_finding() {
#if defined(__x86_64__)
  const bool wide = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return {wide ? "processor: AVX2 and FMA" : "processor: without AVX2 or FMA: the same results, more slowly", "", ""};
#else
  return {"processor: not x86-64: the results are reproducible, but differ from x86-64 in the last bits", "", ""};
#endif
}

Finding font_finding() {
  if (draw::has_picture_font()) return {"pictures have a font", "", ""};
  return {"", "there is no font for pictures", "apt install fonts-dejavu-core"};
}

Finding records_finding() {
  const std::vector<fs::path> folders = script::record_folders();
  for (const fs::path& folder : folders) {
    std::error_code error;
    if (fs::is_directory(folder, error)) return {"records: " + folder.string(), "", ""};
  }
  return {"", "the ground motion records are not at " + folders.front().string(),
          "a new installation, or records next to the script"};
}

/// Result of a run of the self-test, compared with the known hash of this platform.
Finding motion_finding(const std::string& who, const Answer& answer) {
  const std::string known = TRILITH_SELF_TEST_MOTION;
  if (!answer.trouble.empty())
    return {"", fmt::format("{}: the self-test {}", who, answer.trouble), "a new installation"};
  const auto found = answer.said.find("motion");
  if (found == answer.said.end()) return {"", who + ": the self-test prints nothing", "a new installation"};
  if (known.empty())
    return {fmt::format("{}: the self-test runs ({}); its expected result is not known for " TRILITH_PLATFORM, who,
                        found->second),
            "", ""};
  if (found->second == known)
    return {fmt::format("{}: the self-test gives the expected result, bit by bit", who), "", ""};
  return {"", fmt::format("{}: the self-test gives {}, expected is {}", who, found->second, known),
          "building with the standard options (no fast-math, no -march), or a test of the machine's memory"};
}

Finding file_finding(const fs::path& file) {
  try {
    const results::ResultsReader reader(file);
    if (reader.finished() && reader.frame_count() > 1)
      return {fmt::format("HDF5 writes and reads a file of {} frames in {}", reader.frame_count(),
                          file.parent_path().parent_path().string()),
              "", ""};
    return {"", "the results of the self-test are incomplete", "more space for temporary files (TMPDIR)"};
  } catch (const std::exception& e) {
    return {"", fmt::format("HDF5: {}", e.what()), "more space for temporary files (TMPDIR)"};
  }
}

/// Script for lua5.4: prints the path and version of the module, then runs the self-test.
constexpr const char* module_script = R"lua(local path = package.searchpath("trilith", package.cpath)
if not path then os.exit(4) end
print("path " .. path)
print("version " .. require "trilith".version)
dofile(arg[0]:gsub("[^/]*$", "self_test.lua"), nil)
)lua";

/// Advice to make an existing module available.
std::string way_to(const fs::path& module) {
  if (module.empty()) return "./dev build in the source tree, or installing the package";
  return fmt::format("export LUA_CPATH='{}/?.so;;'", module.parent_path().string());
}

std::vector<Finding> module_findings(const fs::path& folder) {
  const fs::path lua = in_search_path("lua5.4"), beside = module_beside();
  if (lua.empty())
    return {
        {"lua5.4 is not installed: only trilith runs scripts" + (beside.empty() ? "" : "; module: " + beside.string()),
         "", ""}};
  write_whole_file(folder / "module.lua", module_script);
  const Answer answer =
      ask(folder, "module", {lua.string(), (folder / "module.lua").string(), "out=" + (folder / "module.h5").string()});
  const auto path = answer.said.find("path"), version = answer.said.find("version");
  if (path == answer.said.end())
    return {{"", "lua5.4 does not find the module trilith" + (beside.empty() ? "" : ", which is " + beside.string()),
             way_to(beside)}};
  if (version == answer.said.end())
    return {{"", fmt::format("lua5.4 cannot load {}: {}", path->second, answer.trouble), way_to(beside)}};
  if (version->second != TRILITH_VERSION)
    return {
        {"",
         fmt::format("lua5.4 finds {}, which is version {}, not {}", path->second, version->second, TRILITH_VERSION),
         way_to(beside)}};
  return {{fmt::format("lua5.4 finds the module of this version: {}", path->second), "", ""},
          motion_finding("module", answer)};
}

/// The self-test by this program, then by lua5.4.
std::vector<Finding> test_findings() {
  const ScratchFolder scratch;
  const fs::path& folder = scratch.path();
  if (folder.empty()) return {{"", "no folder can be made for temporary files", "export TMPDIR=FOLDER"}};
  write_whole_file(folder / "self_test.lua", script::library_text("self_test"));
  const fs::path file = folder / "program.h5";
  const Answer answer =
      ask(folder, "program",
          {program_path(), "run", "--quiet", (folder / "self_test.lua").string(), "out=" + file.string()});
  std::vector<Finding> findings{file_finding(file), motion_finding("program", answer)};
  for (Finding& f : module_findings(folder)) findings.push_back(std::move(f));
  return findings;
}

int examine() {
  std::vector<Finding> findings{program_finding(), libraries_finding(), processor_finding(), font_finding(),
                                records_finding()};
  for (Finding& f : test_findings()) findings.push_back(std::move(f));
  bool all_well = true;
  for (const Finding& f : findings) {
    all_well = all_well && f.wrong.empty();
    fmt::print("{}\n",
               terminal_text(f.wrong.empty() ? "ok: " + f.what : fmt::format("wrong: {}; try {}", f.wrong, f.remedy)));
  }
  return all_well ? ended_well : wrong_input;
}

}  // namespace

void add_doctor(CLI::App& app, int& code) {
  CLI::App* verb = app.add_subcommand(
      "doctor", "Check this installation: versions, the Lua module, files, a run with a known result");
  verb->callback([&code] { code = examine(); });
}

}  // namespace trilith::program
