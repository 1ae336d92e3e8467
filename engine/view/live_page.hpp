// The page of `trilith live`: the page of a run that asks its server for newer results.
#pragma once

#include <string>

namespace trilith::view {

/// `page` from view_page, with code that asks for the text at `state` each second, and loads the page again when that
/// differs from `stamp`.
std::string live_page(std::string page, const std::string& stamp);

/// A page without results that says `text` and asks likewise.
std::string waiting_page(const std::string& text, const std::string& stamp);

}  // namespace trilith::view
