# Turns the page of `trilith view` into C++. Usage: cmake -DOUT=... -DPAGE=engine/view/page -DMODULES=a,b -P embed_page.cmake
# The modules become one script: imports go (each module follows the modules that it imports), exports lose their word.
string(REPLACE "," ";" MODULES "${MODULES}")
set(code "")
foreach(module IN LISTS MODULES)
  file(READ "${PAGE}/${module}.js" text)
  string(REGEX REPLACE "\nimport [^\n]*" "" text "\n${text}")
  string(REPLACE "\nexport " "\n" text "${text}")
  string(APPEND code "${text}")
endforeach()
file(READ "${PAGE}/page.html" html)
file(READ "${PAGE}/page.css" style)
file(READ "${PAGE}/live.js" live)
file(WRITE "${OUT}.new" "// Made from engine/view/page by cmake/embed_page.cmake.
#include \"view/page_text.hpp\"

namespace trilith::view {
const char* view_page_html() { return R\"page(${html})page\"; }
const char* view_page_style() { return R\"page(${style})page\"; }
const char* view_page_code() { return R\"page(${code})page\"; }
const char* view_page_live() { return R\"page(${live})page\"; }
}  // namespace trilith::view
")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different "${OUT}.new" "${OUT}")
