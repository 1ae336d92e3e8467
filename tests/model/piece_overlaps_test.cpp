#include "model/check/piece_overlaps.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"

using namespace trilith;

namespace {

std::string overlap_of(const std::vector<Polyhedron>& pieces, double allowed) {
  try {
    refuse_overlapping_pieces(pieces, allowed, "body 'b'");
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

}  // namespace

TEST_CASE("pieces of a body may share faces only") {
  const auto box_at = [](double x) { return box_solid({x, 0, 0}, {x + 1, 1, 1}); };
  CHECK(overlap_of({box_at(0), box_at(1), box_at(2)}, 1e-6).empty());
  CHECK(overlap_of({box_at(0), box_at(3)}, 1e-6).empty());
  CHECK(overlap_of({box_at(0)}, 1e-6).empty());
  // 1e-6 of a diagonal of 1.73 m
  CHECK(overlap_of({box_at(0), box_at(1 - 1.7e-6)}, 1e-6).empty());
  CHECK(overlap_of({box_at(0), box_at(1 - 1.8e-6)}, 1e-6).find("pieces 1 and 2 overlap by 1.8e-06 m") !=
        std::string::npos);
  CHECK(overlap_of({box_at(0), box_at(2.9), box_at(1.5), box_at(0.75)}, 1e-6) ==
        "body 'b': its pieces 1 and 4 overlap by 0.25 m (0.14 of the smaller one's size, at most 1e-06 is allowed), so "
        "their common part would count twice. Move one of them, or make them separate bodies");
  // one within another, such as a hollow given as a piece
  CHECK(overlap_of({box_at(0), box_solid({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6})}, 1e-6).find("overlap by 0.6 m") !=
        std::string::npos);
}
