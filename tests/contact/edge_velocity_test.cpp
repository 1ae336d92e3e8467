#include <array>

#include "contact/plane/overlap_pair.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("an edge of a piece whose corners move as one has the velocity of the rigid piece, on it and off it") {
  const std::array<Vec2, 3> corner{Vec2(0.2, 0.1), Vec2(2, 0.5), Vec2(0.7, 1.6)};
  const std::array<std::uint8_t, 3> is_face{1, 1, 1};
  const PlacedPiece rigid{corner, is_face, Vec2(0.9, 0.7), Vec2(0.3, -0.4), 1.7};
  std::array<Vec2, 3> velocity;
  for (std::size_t i = 0; i < 3; ++i) velocity[i] = rigid.velocity_at(corner[i]);
  PlacedPiece deforming = rigid;
  deforming.corner_velocity = velocity;
  for (const Vec2& x : {Vec2(0.2, 0.1), Vec2(1.1, 0.3), Vec2(0.9, 0.9), Vec2(-1, 3)})
    for (const int edge : {0, 1, 2})
      CHECK(near_zero((deforming.velocity_at(edge, x) - rigid.velocity_at(x)).norm(), 1e-12));
}
