// Text and terminals: control characters move the cursor, set colours and titles, and are no part of a name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace trilith {

/// Where the first control character of UTF-8 text begins (below a blank, delete, or U+0080 to U+009F); npos where
/// there is none.
std::size_t find_control(std::string_view text, std::size_t from = 0);

/// `text` with control characters as Lua writes them: "\27". Line ends and tabs stay. Whatever comes from a script or a
/// file goes through it on its way to a terminal.
std::string terminal_text(std::string_view text);
/// The same of what has to stay on one line, such as a name in a message: line ends and tabs too.
std::string one_line(std::string_view text);

inline constexpr std::size_t longest_name = 255;   ///< [bytes] of a name
inline constexpr std::size_t longest_text = 4096;  ///< [bytes] of any other text, such as a path

/// Throws InputError, begun with `what`, where `name` holds a control character or is longer than `longest` [bytes]:
/// names are printed everywhere.
void require_printable(std::string_view name, std::string_view what, std::size_t longest = longest_text);

}  // namespace trilith
