// Private to record/: the page of `trilith view`, made from engine/record/page at build time (cmake/embed_page.cmake).
#pragma once

namespace trilith::record {

const char* view_page_html();   ///< with marks where title, style, code and data go
const char* view_page_style();  ///< CSS
const char* view_page_code();   ///< JavaScript: all modules as one

}  // namespace trilith::record
