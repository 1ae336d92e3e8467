// Folder of the pictures that tests draw, for inspection after a run, and checks of each picture.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>

#include "draw/canvas.hpp"

namespace trilith::testing {

/// A file in the folder `pictures` next to the test program in the build tree, whatever the working directory.
inline std::filesystem::path picture_path(const char* name) {
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "pictures";
  std::filesystem::create_directories(folder);
  return folder / name;
}

/// Checks that no text leaves the page or covers another.
inline void check_texts(const draw::Canvas& canvas) {
  const auto& boxes = canvas.text_boxes();
  for (const draw::PageBox& box : boxes) {
    CHECK(box.x0 >= 0);
    CHECK(box.y0 >= 0);
    CHECK(box.x1 <= canvas.width());
    CHECK(box.y1 <= canvas.height());
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j) CHECK_FALSE(boxes[i].overlaps(boxes[j]));
}

}  // namespace trilith::testing
