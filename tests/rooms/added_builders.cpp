// The builders that docs/architecture.md adds, tested in the plane and in space by their rows of the lists.
// tests/rooms/ add_a_law compiles this file in a copy of the tree that has them.
#include <doctest/doctest.h>

#include <vector>

#include "build/list.hpp"
#include "near.hpp"

namespace trilith::testing {
namespace {

/// The names of the builders of a list in scripts.
template <class Builders>
std::vector<std::string_view> kinds_in() {
  std::vector<std::string_view> kinds;
  Builders::for_each([&]<class B>() { kinds.push_back(B::kind); });
  return kinds;
}

template <class F>
std::string builder_refusal(F&& f) {
  try {
    f();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("wedge is the last row of the plane's builders, a triangle, and rejects a base of no length by name") {
  CHECK(kinds_in<PlaneBuilders>().back() == "wedge");
  Wedge wedge;
  wedge.x = 1, wedge.base = 2, wedge.height = 3;
  const std::vector<Part> parts = wedge.parts();
  REQUIRE(parts.size() == 1);
  CHECK(near(polygon_moments(parts[0].outline).area, 3, 1e-15));
  wedge.base = 0;
  const std::string message = builder_refusal([&] { (void)wedge.parts(); });
  for (const char* word : {"wedge", "base is 0 m", "above 0"}) CHECK(message.find(word) != std::string::npos);
}

TEST_CASE("pyramid is the last row of the builders in space, has a third of its box, and rejects a negative height") {
  CHECK(kinds_in<SpaceBuilders>().back() == "pyramid");
  Pyramid pyramid{.name = "tip", .side = 2, .height = 3, .at = {1, 2, 3}};
  const SolidParts made = pyramid.parts();
  REQUIRE(made.parts.size() == 1);
  CHECK(near(volume_of(made.parts[0]), 4, 1e-12));
  CHECK(made.notes.empty());
  pyramid.height = -1;
  const std::string message = builder_refusal([&] { (void)pyramid.parts(); });
  for (const char* word : {"pyramid 'tip'", "height is -1 m", "above 0"})
    CHECK(message.find(word) != std::string::npos);
}

}  // namespace trilith::testing
