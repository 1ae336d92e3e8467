#include "command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/nearest.hpp"
#include "base/terminal_text.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

constexpr const char* run_verb = "run";
constexpr const char* console_verb = "console";
constexpr const char* results_ending = ".h5";

/// A script is recognised by its extension, or by an existing file; results are not scripts.
bool is_script(const std::string& word) {
  const std::string ending = std::filesystem::path(word).extension().string();
  std::error_code error;
  return ending == ".lua" || (ending != results_ending && std::filesystem::is_regular_file(word, error));
}

[[noreturn]] void refuse_word(fmt::format_string<const std::string&, const std::string&> text, const std::string& word,
                              const std::string& hint) {
  throw CLI::ParseError(fmt::format(text, word, hint), CLI::ExitCodes::ExtrasError);
}

/// "; did you mean '--events'?" for the first unknown option of the verb; otherwise "".
std::string hint_of_extras(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (parsed.empty()) return "";
  for (const std::string& word : parsed.front()->remaining()) {
    if (!word.starts_with("--")) continue;
    std::vector<std::string> known;
    for (const CLI::Option* o : named_options(*parsed.front()))
      for (const std::string& name : o->get_lnames()) known.push_back("--" + name);
    const std::string near = nearest_name(word, known);
    return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
  }
  return "";
}

/// The error in one line, and the help command with details.
std::string failure_text(const CLI::App* app, const CLI::Error& error) {
  const bool is_extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const std::vector<CLI::App*> parsed = app->get_subcommands();
  const std::string verb = parsed.empty() ? "" : parsed.front()->get_name() + " ";
  return terminal_text(error.what()) + (is_extra ? hint_of_extras(*app) : "") +
         fmt::format("\nRun trilith {}--help for more information.\n", verb);
}

/// `trilith help`, `trilith help draw`, and `trilith help trilith.wall`, which is a page of the manual.
std::vector<std::string> words_of_help(const CLI::App& app, std::vector<std::string> words) {
  const bool is_verb = !words.empty() && std::ranges::any_of(listed_verbs(app), [&](const CLI::App* verb) {
    return verb->get_name() == words[0];
  });
  if (words.empty() || is_verb)
    words.emplace_back("--help");
  else
    words.insert(words.begin(), "manual");
  return words;
}

}  // namespace

void describe_command_line(CLI::App& app, int& code) {
  app.name("trilith");
  app.description("Simulates structures of separate bodies, through an earthquake to collapse");
  app.set_version_flag("--version", "trilith " TRILITH_VERSION);
  app.footer(
      "Without arguments, trilith opens a console. trilith SCRIPT runs a script, and trilith -i SCRIPT\n"
      "opens a console after it. A script runs in a sandbox: it starts no programs, and uses files\n"
      "only below its own folder, the current folder and the paths on the command line. The option\n"
      "--trust lifts these limits. trilith doctor prints where the program, its Lua module and its\n"
      "records are, and whether they work.\n"
      "Exit code 0 is success, 1 wrong input or an error in a script or case, 2 a wrong command line.\n"
      "Exit code 3 is a run that is not reliable or a model without solution; a message gives the\n"
      "reason. Exit code 130 is an interrupt.");
  app.require_subcommand(1);
  app.failure_message(failure_text);
  add_console(app, code);
  add_new(app, code);
  add_run(app, code);
  add_resume(app, code);
  add_study(app, code);
  add_verify(app, code);
  add_draw(app, code);
  add_movie(app, code);
  add_plot(app, code);
  add_view(app, code);
  add_live(app, code);
  add_report(app, code);
  add_export(app, code);
  add_motion(app, code);
  add_manual(app, code);
  add_info(app, code);
  add_repair(app, code);
  add_doctor(app, code);
  add_completion(app, code);
}

std::vector<const CLI::App*> listed_verbs(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::vector<std::string> words_with_verb(const CLI::App& app, std::vector<std::string> words) {
  if (words.empty()) return {console_verb};
  if (words[0] == "help") words = words_of_help(app, {words.begin() + 1, words.end()});
  if (words[0] == "-i" || words[0] == "--interactive") words[0] = console_verb;
  const std::string& first = words[0];
  const bool is_option = first.starts_with("-");
  std::vector<std::string> known;
  if (is_option)
    for (const CLI::Option* o : app.get_options())
      for (const std::string& name : spellings(*o)) known.push_back(name);
  else
    for (const CLI::App* verb : listed_verbs(app)) known.push_back(verb->get_name());
  if (std::ranges::find(known, first) != known.end()) return words;
  if (!is_option && is_script(first)) {
    words.insert(words.begin(), run_verb);
    return words;
  }
  // Two letters resemble all other options of two letters.
  if (is_option) refuse_word("there is no option '{}'{}", first, first.size() > 2 ? name_hint(first, known) : "");
  if (std::filesystem::path(first).extension() == results_ending)
    refuse_word("a results file is not a script; try trilith info {}{}", first, "");
  refuse_word("there is no command '{}', and no script of that name{}", first, name_hint(first, known));
}

std::vector<const CLI::Option*> named_options(const CLI::App& verb) {
  return verb.get_options([&](const CLI::Option* o) { return o->nonpositional() && o != verb.get_help_ptr(); });
}

std::vector<const CLI::Option*> placed_options(const CLI::App& verb) {
  return verb.get_options([](const CLI::Option* o) { return o->get_positional(); });
}

std::vector<std::string> spellings(const CLI::Option& option) {
  std::vector<std::string> out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

std::string value_word(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  // CLI11 appends the condition of a check after a colon: "TEXT:{si,us}", "INT:INT in [1 - 20]".
  const std::string word = option.get_type_name();
  return word.substr(0, word.find(':'));
}

std::vector<std::string> listed_values(const CLI::Option& option) {
  const std::string word = option.get_type_name();
  const std::size_t open = word.find('{'), close = word.rfind('}');
  // "all|important|none", or CLI11's format of a list: "TEXT:{si,us}"
  const bool braced = open != std::string::npos && close != std::string::npos;
  if (!braced && word.find('|') == std::string::npos) return {};
  return CLI::detail::split(braced ? word.substr(open + 1, close - open - 1) : word, braced ? ',' : '|');
}

}  // namespace trilith::program
