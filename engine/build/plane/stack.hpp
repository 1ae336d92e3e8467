// Stacked blocks: columns of any blocks, and the harmonic stack that projects over an edge.
#pragma once

#include <string>
#include <vector>

#include "build/builder_keys.hpp"
#include "build/plane/part.hpp"

namespace trilith {

/// One block of a stack.
struct StackBlock {
  double width = 0;   ///< [m], above 0
  double height = 0;  ///< [m], above 0
  double offset = 0;  ///< of its middle from the middle of the block below (for the lowest: from `Stack::at`) [m]

  static constexpr auto keys() {
    using K = KeysOf<StackBlock>;
    return std::tuple(K::Number{&StackBlock::width, "width", "m", "its width", above_zero, must_be_given},
                      K::Number{&StackBlock::height, "height", "m", "its height", above_zero, must_be_given},
                      K::Number{&StackBlock::offset, "offset", "m", "its middle from the middle of the block below"});
  }
};

/// Blocks from the bottom up, each on the one below without gap.
struct Stack {
  std::string name = {};
  Vec2 at = Vec2::Zero();  ///< bottom middle of the stack [m]
  std::vector<StackBlock> blocks = {};

  static constexpr std::string_view kind = "stack";
  static constexpr std::string_view sentence = "blocks on top of each other";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<Stack>;
    return std::tuple(K::Point{&Stack::at, "at", "middle of the foot"},
                      K::List<StackBlock>{&Stack::blocks, "blocks", "block",
                                          "{ { width = , height = , offset = 0 }, ... }, from the foot up"});
  }
  /// build_stack.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// Parts "b1" (lowest), "b2", ... in group "stack". Faces in contact are at the same height to the bit. Throws
/// InputError for no blocks, sizes not above 0, or a block without overlap with the one below.
std::vector<Part> build_stack(const Stack& stack);

/// n equal blocks on a table; block k from the top projects over the one below (the lowest: over the table's right
/// edge) by factor * length / (2 k). With factor 1 the centre of mass of all blocks above an edge lies exactly over it.
struct HarmonicStack {
  std::string name = {};
  int count = 5;            ///< 1 to 1000
  double length = 1;        ///< of a block [m]
  double height = 0.2;      ///< of a block [m]
  double factor = 1;        ///< of all offsets, not below 0; below 1 the stack stands, above 1 it collapses
  Vec2 at = Vec2::Zero();   ///< upper right corner of the table [m]
  double table_height = 0;  ///< height of the table [m]; 0: no table

  static constexpr std::string_view kind = "harmonic_stack";
  static constexpr std::string_view sentence = "equal blocks that overhang an edge";
  static constexpr bool is_single = false;
  static constexpr auto keys() {
    using K = KeysOf<HarmonicStack>;
    using S = HarmonicStack;
    return std::tuple(
        K::Count{&S::count, "count", "number of blocks", 1, 1000},
        K::Number{&S::length, "length", "m", "length of a block", above_zero},
        K::Number{&S::height, "height", "m", "height of a block", above_zero},
        K::Number{&S::factor, "factor", "1", "overhang over the largest stable overhang", not_below_zero},
        K::Point{&S::at, "at", "position of the edge"},
        K::Number{&S::table_height, "table_height", "m", "height of the table under the blocks", not_below_zero});
  }
  /// build_harmonic_stack.
  [[nodiscard]] std::vector<Part> parts() const;
};

/// Parts "table" (group "table", twice a block's length, if it has a height) and "b1" (lowest) to "bn" (group "stack").
/// The top block projects by factor * length / 2 * (1 + 1/2 + ... + 1/n) beyond the table. Throws InputError for
/// numbers out of range or a factor that leaves no overlap between the two topmost blocks.
std::vector<Part> build_harmonic_stack(const HarmonicStack& stack);

}  // namespace trilith
