// The single list of verbs and options, from which help, shell completion and the page for `man` are made.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace trilith::program {

/// Adds the name, the verbs and their options to `app`. A verb sets `code` after it has run.
void describe_command_line(CLI::App& app, int& code);

/// The verbs that help lists, in its order.
std::vector<const CLI::App*> listed_verbs(const CLI::App& app);

/// The words of the command line with a verb in front. Without words, or with -i, the verb is the console; a script in
/// place of a verb is run. Throws CLI::ParseError, with the most likely verb, if the first word is neither.
std::vector<std::string> words_with_verb(const CLI::App& app, std::vector<std::string> words);

/// Options with a name (--out), in the order of help, except --help itself.
std::vector<const CLI::Option*> named_options(const CLI::App& verb);
/// Positional options.
std::vector<const CLI::Option*> placed_options(const CLI::App& verb);
/// "-o", "--output", as written on the command line.
std::vector<std::string> spellings(const CLI::Option& option);
/// Placeholder of its value: "FILE", "N"; "" for a flag.
std::string value_word(const CLI::Option& option);
/// Its possible values, if they can be listed: "si", "us".
std::vector<std::string> listed_values(const CLI::Option& option);

}  // namespace trilith::program
