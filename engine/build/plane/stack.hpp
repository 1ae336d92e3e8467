// Stacked blocks: columns of any blocks, and the harmonic stack that projects over an edge.
#pragma once

#include <string>
#include <vector>

#include "build/plane/part.hpp"

namespace trilith {

/// One block of a stack.
struct StackBlock {
  double width = 0;   ///< [m], above 0
  double height = 0;  ///< [m], above 0
  double offset = 0;  ///< of its middle from the middle of the block below (for the lowest: from `Stack::at`) [m]
};

/// Blocks from the bottom up, each on the one below without gap.
struct Stack {
  std::string name = {};
  Vec2 at = Vec2::Zero();  ///< bottom middle of the stack [m]
  std::vector<StackBlock> blocks = {};
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
};

/// Parts "table" (group "table", twice a block's length, if it has a height) and "b1" (lowest) to "bn" (group "stack").
/// The top block projects by factor * length / 2 * (1 + 1/2 + ... + 1/n) beyond the table. Throws InputError for
/// numbers out of range or a factor that leaves no overlap between the two topmost blocks.
std::vector<Part> build_harmonic_stack(const HarmonicStack& stack);

}  // namespace trilith
