// The one list of verbs and options: help, completion in shells and the page for `man` are made from it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace trilith::program {

/// Gives `app` its name, its verbs and their options. A verb sets `code` when it has run.
void describe_command_line(CLI::App& app, int& code);

/// The verbs that help lists, in its order.
std::vector<const CLI::App*> listed_verbs(const CLI::App& app);

/// The words of the command line with a verb in front: alone, or with -i, they open the console, and a script in the
/// place of a verb is run. Throws CLI::ParseError, with the verb most likely meant, where the first word is neither.
std::vector<std::string> words_with_verb(const CLI::App& app, std::vector<std::string> words);

/// An option that stands by its name (--out), in the order of help but for --help itself.
std::vector<const CLI::Option*> named_options(const CLI::App& verb);
/// Those that stand by their place.
std::vector<const CLI::Option*> placed_options(const CLI::App& verb);
/// "-o", "--output", as one writes them.
std::vector<std::string> spellings(const CLI::Option& option);
/// What stands for its value: "FILE", "N"; "" for a flag.
std::string value_word(const CLI::Option& option);
/// The values it takes, where they can be listed: "si", "us".
std::vector<std::string> listed_values(const CLI::Option& option);

}  // namespace trilith::program
