#include <string_view>

#include "base/markup.hpp"
#include "view/bytes.hpp"
#include "view/data.hpp"
#include "view/page_text.hpp"

namespace trilith::view {
namespace {

/// `text` with the first `mark` in it replaced.
void put(std::string& text, std::string_view mark, std::string_view by) {
  if (const std::size_t at = text.find(mark); at != std::string::npos) text.replace(at, mark.size(), by);
}

}  // namespace

std::string view_page(const std::string& data, const std::string& title) {
  std::string page = view_page_html();
  put(page, "%TITLE%", markup_text(title));
  put(page, "%STYLE%", view_page_style());
  put(page, "%CODE%", view_page_code());
  put(page, "%DATA%", base64(gzipped(data)));
  return page;
}

}  // namespace trilith::view
