#include "model/builder/node_support.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace trilith {

void refuse_idle_holds(std::span<const SpaceNodeSupport> holds, std::span<const Vec3> nodes, const std::string& owner) {
  for (std::size_t i = 0; i < holds.size(); ++i) {
    const SpaceNodeSupport& hold = holds[i];
    if (std::any_of(nodes.begin(), nodes.end(), [&](const Vec3& x) { return is_supported_at(hold, x); })) continue;
    Vec3 low = nodes[0], high = low;
    for (const Vec3& x : nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
    const auto text = [](const Vec3& x) { return fmt::format("({:g}, {:g}, {:g})", x.x(), x.y(), x.z()); };
    throw InputError(fmt::format(
        "{}: hold {} holds no node: its box reaches from {} to {} m, the body's nodes from {} to "
        "{} m",
        owner, i + 1, text(hold.low.cwiseMin(hold.high)), text(hold.low.cwiseMax(hold.high)), text(low), text(high)));
  }
}

}  // namespace trilith
