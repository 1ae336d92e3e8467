// Text as a picture can show it: valid UTF-8, no control characters.
#pragma once

#include <string>
#include <string_view>

namespace trilith::draw {

/// `text` with every byte that is not part of valid UTF-8 (RFC 3629) as '?', and every control character as a blank.
std::string printable_utf8(std::string_view text);

}  // namespace trilith::draw
