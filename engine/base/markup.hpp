// Text in HTML and XML.
#pragma once

#include <string>
#include <string_view>

namespace trilith {

/// `text` as the content of an element or of an attribute in quotes: & < > " and ' become entities.
std::string markup_text(std::string_view text);

}  // namespace trilith
