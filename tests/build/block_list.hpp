// Block lists of published tests (tests/build/blocks), and comparison of parts with these blocks.
#pragma once

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "base/whole_file.hpp"
#include "build/space/solid_part.hpp"
#include "source_dir.hpp"

namespace trilith::testing {

/// Corners of one block.
using BlockCorners = std::vector<Vec3>;

/// All numbers from `at` to the end of the list that is open at `at`.
inline std::vector<double> numbers_of_list(const std::string& text, std::size_t at) {
  std::vector<double> numbers;
  for (int depth = 0; at < text.size();) {
    const char c = text[at];
    if (c == '[') ++depth;
    if (c == ']' && --depth == 0) break;
    if (c == '-' || (c >= '0' && c <= '9')) {
      char* end = nullptr;
      numbers.push_back(std::strtod(text.c_str() + at, &end));
      at = static_cast<std::size_t>(end - text.c_str());
    } else {
      ++at;
    }
  }
  return numbers;
}

/// The text of a file of tests/build/blocks.
inline std::string text_of_blocks(const std::string& name) {
  return text_of_file(fmt::format("{}/tests/build/blocks/{}", source_dir(), name), "blocks", 1U << 20);
}

/// Corners from numbers, three each [m].
inline BlockCorners corners_of(const std::vector<double>& n) {
  BlockCorners corners;
  for (std::size_t k = 0; k + 2 < n.size(); k += 3) corners.emplace_back(n[k], n[k + 1], n[k + 2]);
  return corners;
}

/// Reads a file of blocks as boxes (low corner, high corner) or as lists of corners [m].
inline std::vector<BlockCorners> block_list(const std::string& name) {
  const std::string text = text_of_blocks(name);
  std::vector<BlockCorners> blocks;
  for (const bool is_box : {true, false}) {
    const std::string key = is_box ? "\"box\":" : "\"verts\":";
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
      const std::vector<double> n = numbers_of_list(text, at + key.size());
      if (!is_box) {
        blocks.push_back(corners_of(n));
        continue;
      }
      blocks.emplace_back();
      for (int i = 0; i < 8; ++i)
        blocks.back().emplace_back(n[(i & 1) == 0 ? 0U : 3U], n[(i & 2) == 0 ? 1U : 4U], n[(i & 4) == 0 ? 2U : 5U]);
    }
  }
  return blocks;
}

/// A block with an initial velocity.
struct FlyingBlock {
  BlockCorners corners;  ///< [m]
  Vec3 velocity, spin;   ///< of its centre of mass [m/s], of it [rad/s]
  double mass = 0;       ///< as given in the file [kg]
};

/// Reads a file of blocks with initial velocities.
inline std::vector<FlyingBlock> flying_blocks(const std::string& name) {
  const std::string text = text_of_blocks(name);
  std::vector<FlyingBlock> blocks;
  const auto after = [&](const char* key, std::size_t from) { return text.find(key, from) + std::string(key).size(); };
  for (std::size_t at = text.find("\"verts\":"); at != std::string::npos; at = text.find("\"verts\":", at + 1)) {
    FlyingBlock block;
    block.corners = corners_of(numbers_of_list(text, after("\"verts\":", at)));
    block.velocity = corners_of(numbers_of_list(text, after("\"v\":", at))).at(0);
    block.spin = corners_of(numbers_of_list(text, after("\"w\":", at))).at(0);
    block.mass = std::strtod(text.c_str() + after("\"mass\":", at), nullptr);
    blocks.push_back(block);
  }
  return blocks;
}

/// Whether a part of one piece has these corners, each within `within` [m].
inline bool is_block(const SolidPart& part, const BlockCorners& block, double within) {
  if (part.pieces.size() != 1 || part.pieces[0].corners.size() != block.size()) return false;
  for (const Vec3& p : part.pieces[0].corners) {
    bool there = false;
    for (const Vec3& q : block) there = there || (p - q).cwiseAbs().maxCoeff() <= within;
    if (!there) return false;
  }
  return true;
}

/// Checks that every part is one block of the list and every block one part.
inline void check_same_blocks(const std::vector<SolidPart>& parts, std::vector<BlockCorners> blocks, double within) {
  REQUIRE(parts.size() == blocks.size());
  for (const SolidPart& part : parts) {
    std::size_t found = 0;
    while (found < blocks.size() && !is_block(part, blocks[found], within)) ++found;
    CAPTURE(part.name);
    REQUIRE(found < blocks.size());
    blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(found));
  }
}

}  // namespace trilith::testing
