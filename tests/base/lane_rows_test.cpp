#include "base/simd/lane_rows.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace trilith;

TEST_CASE("four rows of numbers are read as columns and written back as they were") {
  std::array<std::array<double, 6>, 4> rows, written{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 6; ++k) rows[i][k] = 10.0 * static_cast<double>(i) + static_cast<double>(k);
  const FourRowsOf<const double> from({rows[0].data(), rows[1].data(), rows[2].data(), rows[3].data()});
  const FourRowsOf<double> to({written[0].data(), written[1].data(), written[2].data(), written[3].data()});
  Lanes a, b, c, d, last;
  from.load(1, a, b, c, d), from.load(5, last);
  const std::array columns{a, b, c, d, last};
  for (int i = 0; i < lane_count; ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double number = columns[k][i];
      CHECK(number == rows[static_cast<std::size_t>(i)][k + 1]);
    }
  to.store(1, a, b, c, d), to.store(5, last);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(written[i][0] == 0);
    for (std::size_t k = 1; k < 6; ++k) CHECK(written[i][k] == rows[i][k]);
  }
}

TEST_CASE("four neighbouring vectors are read a lane each and written back as they were") {
  std::array<Vec3, 6> vectors, written;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const auto n = static_cast<double>(i);
    vectors[i] = {n + 0.25, n + 0.5, n + 0.75}, written[i] = Vec3::Zero();
  }
  const Triple<Lanes> four = load_neighbours(&vectors[1]);
  for (int i = 0; i < lane_count; ++i) CHECK(lane_of(four, i) == vectors[static_cast<std::size_t>(i) + 1]);
  store_neighbours(four, &written[1]);
  for (const std::size_t outside : {std::size_t{0}, std::size_t{5}}) CHECK(written[outside] == Vec3::Zero());
  for (std::size_t i = 1; i < 5; ++i) CHECK(written[i] == vectors[i]);
}
