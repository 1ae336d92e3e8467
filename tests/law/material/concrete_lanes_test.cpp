// Four concrete fibres in SIMD lanes against the scalar law, bit by bit.
#include "law/fibre/concrete_lanes.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <random>
#include <vector>

#include "geometry/plane/random_convex.hpp"

namespace trilith {
namespace {

/// Laws with every branch: with and without tension, a crack that softens, residual stress, confinement.
std::vector<KentPark> concretes_for_lanes() {
  return {{30e6, 0.002, 0.006, 0.2, 1, 0, 0},
          {30e6, 0.002, 0.004, 0, 1.2, 2e6, 4e-4},
          {45e6, 0.0022, 0.02, 0.5, 1.6, 3e6, 0},
          {20e6, 0.002, 0.003, 1, 1, 1.5e6, 3e-3}};
}

using FourMemories = std::array<KentPark::Memory, lane_count>;

ConcreteFour lanes_of(const FourMemories& m) {
  ConcreteFour out{};
  for (std::size_t i = 0; i < m.size(); ++i) {
    const auto lane = static_cast<int>(i);
    out.strain[lane] = m[i][0], out.stress[lane] = m[i][1], out.squeezed[lane] = m[i][2], out.opened[lane] = m[i][3];
  }
  return out;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool lane_equals(const ConcreteFourResponse& four, int lane, const UniaxialResponse<concrete_memory>& one) {
  return same_bits(four.memory.strain[lane], one.memory[0]) && same_bits(four.memory.stress[lane], one.memory[1]) &&
         same_bits(four.memory.squeezed[lane], one.memory[2]) && same_bits(four.memory.opened[lane], one.memory[3]) &&
         same_bits(four.tangent[lane], one.tangent) && same_bits(four.stored[lane], one.stored) &&
         same_bits(four.dissipated[lane], one.dissipated) && (four.yielding[lane] != 0) == one.yielding;
}

}  // namespace

TEST_CASE("concrete in lanes has the bits of the scalar law: loading, crushing, reversals, cracks, strains repeated") {
  std::mt19937_64 bits(11);
  int crushed = 0, open = 0;
  for (const KentPark& law : concretes_for_lanes()) {
    law.check();
    const ConcreteLanes lanes{KentParkEnvelope(law)};
    for (int round = 0; round < 20; ++round) {
      FourMemories memory{};
      std::array<double, lane_count> at{};
      for (int i = 0; i < 300; ++i) {
        Lanes strain{};
        for (std::size_t k = 0; k < at.size(); ++k) {
          const double size = std::pow(10, random_between(bits, -6, -2.5));
          if (i % 7 != 0) at[k] = std::clamp(at[k] + random_between(bits, -size, size), -0.03, 0.01);
          strain[static_cast<int>(k)] = at[k];
        }
        ConcreteFourResponse four;
        lanes.respond(strain, lanes_of(memory), four);
        for (std::size_t k = 0; k < at.size(); ++k) {
          const auto one = law.respond(at[k], memory[k]);
          REQUIRE(lane_equals(four, static_cast<int>(k), one));
          crushed += one.yielding ? 1 : 0, open += one.memory[3] > 0 ? 1 : 0;
          memory[k] = one.memory;
        }
      }
    }
  }
  // Every branch was taken many times.
  CHECK(crushed > 1000);
  CHECK(open > 1000);
}

}  // namespace trilith
