// "1,2.5,end" on the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trilith::program {

/// The parts between commas, including empty ones.
std::vector<std::string> comma_list(std::string_view text);

/// `text` as a finite number; throws InputError that begins with `what` for other text.
double number_of(const std::string& text, std::string_view what);

}  // namespace trilith::program
