// Text for terminals. Control characters move the cursor and set colours and titles; they do not belong in a name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace trilith {

/// Position of the first control character of UTF-8 text (below a blank, delete, or U+0080 to U+009F); npos if none.
std::size_t find_control(std::string_view text, std::size_t from = 0);

/// `text` with control characters escaped as in Lua: "\27". Line ends and tabs stay. All text from scripts or files
/// passes through this function before it is printed.
std::string terminal_text(std::string_view text);
/// Like terminal_text(), for text on one line such as a name in a message: line ends and tabs are escaped too.
std::string one_line(std::string_view text);

inline constexpr std::size_t longest_name = 255;   ///< [bytes] of a name
inline constexpr std::size_t longest_text = 4096;  ///< [bytes] of any other text, such as a path

/// Throws InputError, which begins with `what`, if `name` has a control character or is longer than `longest` [bytes].
/// Names are printed in many places.
void require_printable(std::string_view name, std::string_view what, std::size_t longest = longest_text);

}  // namespace trilith
