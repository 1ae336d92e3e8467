#include "build/plane/stack.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace trilith {

std::vector<Part> Stack::parts() const {
  return build_stack(*this);
}

std::vector<Part> HarmonicStack::parts() const {
  return build_harmonic_stack(*this);
}

std::vector<Part> build_stack(const Stack& stack) {
  const std::string owner = builder_title("stack", stack.name);
  if (stack.blocks.empty()) throw InputError(owner + ": has no blocks, needs at least 1");
  check_keys(stack, owner);
  double middle = stack.at.x(), bottom = stack.at.y();
  double below = 0;
  std::vector<Part> parts;
  for (const StackBlock& block : stack.blocks) {
    const std::string piece = fmt::format("b{}", parts.size() + 1), what = fmt::format("{}, block {}", owner, piece);
    const double reach = (block.width + below) / 2;
    if (!parts.empty() && std::abs(block.offset) >= reach)
      throw InputError(
          fmt::format("{}: offset is {:g} m, must be within {:g} m; otherwise it does not stand on the block below",
                      what, block.offset, reach));
    middle += block.offset;
    const double top = bottom + block.height;
    parts.push_back({part_name(stack.name, piece),
                     rectangle({middle - block.width / 2, bottom}, {middle + block.width / 2, top}),
                     {"stack"}});
    bottom = top;
    below = block.width;
  }
  return parts;
}

std::vector<Part> build_harmonic_stack(const HarmonicStack& stack) {
  const std::string owner = builder_title("harmonic stack", stack.name);
  check_keys(stack, owner);
  if (stack.factor >= 2)
    throw InputError(fmt::format("{}: factor is {:g}, must be below 2; otherwise the top block has no support", owner,
                                 stack.factor));
  Stack blocks{stack.name, stack.at, {}};
  blocks.at.x() -= stack.length / 2;  // a block whose right end is aligned with the end of the table
  // From below: block k from the top projects by length / 2k beyond the next, times `factor`. At this distance all
  // blocks above it just balance on the edge.
  for (int k = stack.count; k >= 1; --k)
    blocks.blocks.push_back({stack.length, stack.height, stack.factor * stack.length / (2 * k)});
  std::vector<Part> parts = build_stack(blocks);
  if (stack.table_height > 0) {
    const Vec2 low(stack.at.x() - 2 * stack.length, stack.at.y() - stack.table_height);
    parts.insert(parts.begin(), Part{part_name(stack.name, "table"), rectangle(low, stack.at), {"table"}});
  }
  return parts;
}

}  // namespace trilith
