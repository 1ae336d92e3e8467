// The page of `man trilith`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace trilith::program {

/// The page in roff (man(7)), made from the verbs and options of `app`.
std::string man_page(const CLI::App& app);

}  // namespace trilith::program
