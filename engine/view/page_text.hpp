// Private to view/: the page of `trilith view`, made from engine/view/page at build time (cmake/embed_page.cmake).
#pragma once

namespace trilith::view {

const char* view_page_html();   ///< with marks for title, style, code and data
const char* view_page_style();  ///< CSS
const char* view_page_code();   ///< JavaScript: all modules as one
const char* view_page_live();   ///< JavaScript that follows a run, for the page of `trilith live`

}  // namespace trilith::view
