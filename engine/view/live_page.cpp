#include "view/live_page.hpp"

#include <string_view>

#include "base/markup.hpp"
#include "view/page_text.hpp"

namespace trilith::view {

std::string live_page(std::string page, const std::string& stamp) {
  constexpr std::string_view root = "<html ", end = "</body>";
  const std::size_t last = page.rfind(end);
  if (last != std::string::npos) page.insert(last, std::string("<script>\n") + view_page_live() + "</script>\n");
  const std::size_t first = page.find(root);
  if (first != std::string::npos) page.insert(first + root.size(), "data-stamp=\"" + markup_text(stamp) + "\" ");
  return page;
}

std::string waiting_page(const std::string& text, const std::string& stamp) {
  return live_page(
      "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>Trilith</title>\n"
      "<meta name=\"color-scheme\" content=\"light dark\"><link rel=\"icon\" href=\"data:,\">\n"
      "<style>body { font: 1rem system-ui, sans-serif; margin: 3rem; }</style></head>\n<body>\n<p id=\"state\">" +
          markup_text(text) + "</p>\n</body>\n</html>\n",
      stamp);
}

}  // namespace trilith::view
