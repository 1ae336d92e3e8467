// trilith resume RESULTS
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <sstream>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "bindings/restart/restart_book.hpp"
#include "program/script/run_options.hpp"
#include "program/verbs.hpp"
#include "results/file/part_path.hpp"

namespace trilith::program {
namespace {

struct ResumeOptions {
  std::string results;
  bool accept = false, quiet = false;
  double checkpoint = -1;
};

/// "run.h5" of "run.h5", "run.h5.part" and "run.h5.restart".
std::filesystem::path results_of(std::filesystem::path given) {
  if (given.filename().empty()) given = given.parent_path();  // "run.h5.restart/"
  for (const char* const ending : {".part", ".restart"})
    if (given.extension() == ending) given.replace_extension();
  return std::filesystem::absolute(given);
}

/// True if the results are complete and no rows of an interrupted run exist.
bool is_finished(const std::filesystem::path& results, const script::RestartFiles& files) {
  std::error_code error;
  for (const auto& rows : {results::part_path(results), results::replaced_part_path(results), script::kept_rows(files)})
    if (std::filesystem::exists(rows, error)) return false;
  return std::filesystem::exists(results, error);
}

void require_broken_off(const std::filesystem::path& results, const script::RestartFiles& files) {
  const std::filesystem::path part = results::part_path(results);
  // The file is not read: a run may have been killed before it had rows.
  if (results::is_being_written(part))
    throw InputError(fmt::format("resume: the run of '{}' is still running", results.string()));
  // Its checkpoints remain if it was killed just before it removed them.
  if (is_finished(results, files))
    throw InputError(fmt::format("resume: '{}' is finished; there is nothing to resume", results.string()));
  if (!script::resume_point(files).empty()) return;
  throw InputError(
      fmt::format("resume: there is no checkpoint in '{}'; a run writes the first one after {:g} s of wall clock, or "
                  "as trilith run --checkpoint SECONDS states; run the script again",
                  files.folder().string(), usual_checkpoint));
}

/// The first difference of two texts: "line 12 was 'a', and is 'b'".
std::string difference(const std::string& before, const std::string& now) {
  std::istringstream a(before), b(now);
  std::string was, is;
  for (int line = 1;; ++line) {
    const bool has_a = static_cast<bool>(std::getline(a, was)), has_b = static_cast<bool>(std::getline(b, is));
    if (!has_a && !has_b) return "only its last line break differs";
    if (!has_a) return fmt::format("line {} was added: '{}'", line, is);
    if (!has_b) return fmt::format("line {} was removed: '{}'", line, was);
    if (was != is) return fmt::format("line {} was '{}' and is now '{}'", line, was, is);
  }
}

/// The script names the results file again, so a copy would continue the original and stay as it is.
void require_original(const std::filesystem::path& results, const script::RestartFiles& files,
                      const script::RestartCall& call) {
  if (call.own_folder.empty() || std::filesystem::weakly_canonical(files.folder()) == call.own_folder) return;
  std::filesystem::path original = call.own_folder;
  original.replace_extension();
  throw InputError(fmt::format(
      "resume: '{}' was copied or moved: its run wrote to '{}', and would go on writing there; resume '{}', "
      "or move the results with their .part and .restart back there first",
      results.string(), original.string(), original.string()));
}

int resume(const ResumeOptions& o) {
  const std::filesystem::path results = results_of(o.results);
  const script::RestartFiles files(script::restart_folder(results));
  require_broken_off(results, files);
  const std::string bytes = files.get("call");
  ByteReader in(bytes, "restart file 'call'");
  const auto call = in.get<script::RestartCall>();
  require_original(results, files, call);
  std::error_code error;
  std::filesystem::current_path(call.folder, error);
  if (error) throw InputError(fmt::format("resume: folder '{}' of the run: {}", call.folder, error.message()));
  if (!o.accept) require_same(call);
  RunOptions run;
  run.script = call.script, run.given = call.given, run.results = call.named_results, run.folder = call.case_folder;
  run.only = call.number, run.threads = call.threads, run.quiet = o.quiet, run.resumes = true;
  run.checkpoint = o.checkpoint >= 0 ? o.checkpoint : call.every;
  ByteReader room(call.room, "restart file 'call'");
  room.item(run.room);
  return run_as_asked(run);
}

}  // namespace

void require_same(const script::RestartCall& call) {
  if (call.build != script::this_build())
    throw InputError(
        fmt::format("resume: the checkpoints were written by Trilith {}, and this is Trilith {}, whose results may "
                    "differ in the last bits; resume with the program that wrote them, or give --accept-changes",
                    call.build, script::this_build()));
  const std::string now = text_of_file(call.script, "script", script::largest_script);
  if (now != call.text)
    throw InputError(
        fmt::format("resume: the script '{}' has changed: {}; undo that, or give --accept-changes if the "
                    "change affects output or later stages only",
                    call.script, difference(call.text, now)));
}

void add_resume(CLI::App& app, int& code) {
  auto o = std::make_shared<ResumeOptions>();
  CLI::App* verb = app.add_subcommand("resume", "Continue an interrupted run from its last checkpoint");
  verb->add_option("results", o->results, "the results file of the run")->required()->type_name("RESULTS");
  verb->add_flag("--accept-changes", o->accept,
                 "continue although the script or the program has changed; the model must still be the same");
  add_checkpoint_option(*verb, o->checkpoint, "default: as in the run");
  verb->add_flag("--quiet,-q", o->quiet, "show neither events nor status");
  verb->callback([o, &code] { code = resume(*o); });
}

}  // namespace trilith::program
