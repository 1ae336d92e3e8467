// Shell completions at Tab.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace trilith::program {

/// A completion for bash, made from the verbs and options of `app`.
std::string bash_completion(const CLI::App& app);
/// The same for zsh.
std::string zsh_completion(const CLI::App& app);

}  // namespace trilith::program
