# Turns Lua files into one C++ file of texts: cmake -DOUT=... -DFILES=a.lua,b.lua -P embed.cmake
string(REPLACE "," ";" FILES "${FILES}")
set(rows "")
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME_WE)
  if(file MATCHES "/manual/")
    set(name "manual/${name}")
  endif()
  file(READ "${file}" text)
  string(APPEND rows "    {\"${name}\", R\"lua(${text})lua\"},\n")
endforeach()
file(WRITE "${OUT}.new" "// Made from lua/lib by lua/embed.cmake.
#include \"bindings/core/open.hpp\"

namespace trilith::script {

const LibraryFile* library_files() {
  static const LibraryFile files[] = {
${rows}    {nullptr, nullptr}};
  return files;
}

}  // namespace trilith::script
")
execute_process(COMMAND ${CMAKE_COMMAND} -E copy_if_different "${OUT}.new" "${OUT}")
