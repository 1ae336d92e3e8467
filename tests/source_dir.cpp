#include "source_dir.hpp"

namespace trilith::testing {

const std::string& source_dir() {
  static const std::string folder = TRILITH_SOURCE_DIR;
  return folder;
}

}  // namespace trilith::testing
