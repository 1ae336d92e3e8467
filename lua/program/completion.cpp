// trilith completion SHELL
#include "completion.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>

#include "command_line.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

/// The extension of files for a placeholder; "" for any file or none.
std::string ending_of(const std::string& word) {
  static const std::map<std::string, std::string> endings{{"SCRIPT", "lua"}, {"RESULT", "h5"}};
  const auto found = endings.find(word);
  return found == endings.end() ? "" : found->second;
}

/// The extension of the files after a verb; "" for any.
std::string ending_behind(const CLI::App& verb) {
  for (const CLI::Option* o : placed_options(verb))
    if (const std::string ending = ending_of(value_word(*o)); !ending.empty()) return ending;
  return "";
}

std::string words_of(const CLI::App& verb) {
  std::vector<std::string> words{"--help"};
  for (const CLI::Option* o : named_options(verb))
    for (const std::string& name : spellings(*o)) words.push_back(name);
  return CLI::detail::join(words, " ");
}

/// "draw:--units" for each spelling of an option with listed values.
std::string listed_cases(const CLI::App& verb) {
  std::string text;
  for (const CLI::Option* o : named_options(verb)) {
    const std::vector<std::string> values = listed_values(*o);
    if (values.empty()) continue;
    for (const std::string& name : spellings(*o))
      text += fmt::format("    {}:{}) values='{}' ;;\n", verb.get_name(), name, CLI::detail::join(values, " "));
  }
  return text;
}

/// Text in single quotes of zsh, within a specification of _arguments, in which brackets and colons are special.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

/// zsh specification of a value: ":FILE:_files", or ":TEXT:(si us)"; "" for a flag.
std::string zsh_value(const CLI::Option& o) {
  const std::string word = value_word(o), ending = ending_of(word);
  if (word.empty()) return "";
  const std::vector<std::string> values = listed_values(o);
  if (!values.empty()) return fmt::format(":value:({})", CLI::detail::join(values, " "));
  return fmt::format(":{}:_files{}", zsh_text(word), ending.empty() ? "" : fmt::format(" -g \"*.{}\"", ending));
}

std::string zsh_verb(const CLI::App& verb) {
  std::string text = fmt::format("    {})\n      _arguments", verb.get_name());
  for (const CLI::Option* o : named_options(verb))
    for (const std::string& name : spellings(*o))
      text += fmt::format(" \\\n        '*{}[{}]{}'", name, zsh_text(o->get_description()), zsh_value(*o));
  const std::vector<const CLI::Option*> placed = placed_options(verb);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const bool is_rest = placed[i]->get_items_expected_max() > 1;
    text += fmt::format(" \\\n        '{}{}'", is_rest ? "*" : std::to_string(i + 1), zsh_value(*placed[i]));
  }
  return text + " ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string verbs, words, listed, endings;
  for (const CLI::App* verb : listed_verbs(app)) {
    verbs += verb->get_name() + " ";
    words += fmt::format("    {}) words='{}' ;;\n", verb->get_name(), words_of(*verb));
    listed += listed_cases(*verb);
    for (const CLI::Option* o : placed_options(*verb))
      if (const auto values = listed_values(*o); !values.empty())
        endings += fmt::format("    {}) values='{}' ;;\n", verb->get_name(), CLI::detail::join(values, " "));
    const std::string ending = ending_behind(*verb);
    if (!ending.empty()) endings += fmt::format("    {}) ending={} ;;\n", verb->get_name(), ending);
  }
  return fmt::format(R"(# Completion of {0} in bash; made by `{0} completion bash`.
_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} verb=${{COMP_WORDS[1]}}
  local words='{1} -i' values='' ending='' file
  COMPREPLY=()
  case $verb in *.lua) verb=run ;; -i | --interactive) verb=console ;; esac
  if [ "$COMP_CWORD" -le 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '{2}' -- "$word")
    verb='' ending=lua
  fi
  case $verb in
{3}  esac
  case $verb in
{5}  esac
  case $verb:$before in
{4}  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  elif [ -n "$values" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word")
  else
    [[ $before != -* ]] || ending=''
    compopt -o filenames 2>/dev/null
    while IFS= read -r file; do
      if [ -d "$file" ] || [ -z "$ending" ] || [[ $file == *."$ending" ]]; then COMPREPLY+=("$file"); fi
    done < <(compgen -f -- "$word")
  fi
}}
complete -F _{0} {0}
)",
                     app.get_name(), words_of(app), verbs, words, listed, endings);
}

std::string zsh_completion(const CLI::App& app) {
  std::string verbs, cases;
  for (const CLI::App* verb : listed_verbs(app)) {
    verbs += fmt::format("    '{}:{}'\n", verb->get_name(), zsh_text(verb->get_description()));
    cases += zsh_verb(*verb);
  }
  return fmt::format(R"(#compdef {0}
# Completion of {0} in zsh; made by `{0} completion zsh`.
_{0}() {{
  local -a verbs
  verbs=(
{1}  )
  if (( CURRENT == 2 )); then
    _describe verb verbs
    _files -g '*.lua'
    return
  fi
  local verb=$words[2]
  case $verb in
    *.lua) verb=run ;;
    -i|--interactive) verb=console ;;
  esac
  (( CURRENT-- ))
  shift words
  case $verb in
{2}  esac
}}
_{0} "$@"
)",
                     app.get_name(), verbs, cases);
}

void add_completion(CLI::App& app, int& code) {
  auto shell = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("completion", "Print the completion of commands, options and files for a shell");
  verb->add_option("shell", *shell, "bash or zsh; as in: source <(trilith completion bash)")
      ->required()
      ->type_name("SHELL")
      ->check(CLI::IsMember({"bash", "zsh"}));
  verb->callback([&app, shell, &code] {
    fmt::print("{}", *shell == "bash" ? bash_completion(app) : zsh_completion(app));
    code = ended_well;
  });
}

}  // namespace trilith::program
