#include "model/bounds.hpp"

#include "near.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

TEST_CASE("the default bounds are ten sizes of a large model away, and 100 m of a small one") {
  for (const auto& [size, margin] : {std::pair(1.0, 100.0), std::pair(9.0, 100.0), std::pair(20.0, 200.0)}) {
    CAPTURE(size);
    Scene scene(Frictional{1e8, 4e7, 0.6, 0});
    scene.fixed("block", box(0, 0, size, 0.5 * size));
    const Bounds<2> bounds = default_bounds(scene.builder.build());
    CHECK(near(bounds.low.x(), -margin, 1e-12));
    CHECK(near(bounds.low.y(), -margin, 1e-12));
    CHECK(near(bounds.high.x(), size + margin, 1e-12));
    CHECK(near(bounds.high.y(), 0.5 * size + margin, 1e-12));
  }
}
