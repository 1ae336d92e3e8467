#include "base/units.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "base/error.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

TEST_CASE("units have their defined values in SI") {
  CHECK(parse_unit("ft").factor == 0.3048);
  CHECK(near(parse_unit("kip").factor, 4448.2216152605, 1e-14));
  CHECK(near(parse_unit("psi").factor, 6894.757293168361, 1e-14));
  CHECK(near(parse_unit("psf").factor, 47.88025898033584, 1e-14));
  CHECK(near(parse_unit("pcf").factor, 157.08746384624618, 1e-14));
  CHECK(near(parse_unit("slug").factor, 14.593902937206365, 1e-14));
  CHECK(near(parse_unit("deg").factor, std::numbers::pi / 180, 1e-15));
}

TEST_CASE("units multiply and divide") {
  CHECK(near(parse_unit("kip/ft").factor, 4448.2216152605 / 0.3048, 1e-14));
  CHECK(parse_unit("kip/ft").dimension == Dimension{0, -2, 1});
  CHECK(parse_unit("m/s2").dimension == parse_unit("g").dimension);
  CHECK(parse_unit("m/s^2").dimension == parse_unit("m/s/s").dimension);
  CHECK(parse_unit("N s/m").dimension == Dimension{0, -1, 1});
  CHECK(parse_unit("kip*inch").dimension == parse_unit("J").dimension);
  CHECK(parse_unit("1").factor == 1);
  CHECK(parse_unit("1/s").dimension == parse_unit("Hz").dimension);
  CHECK(si_unit(parse_unit("pcf").dimension) == "kg/m2 s2");
  CHECK(si_unit(parse_unit("ksi").dimension) == "Pa");
  CHECK(si_unit({}) == "1");
}

TEST_CASE("no unit is twice in the table, and each one parses to itself") {
  for (const Unit& a : unit_table()) {
    int count = 0;
    for (const Unit& b : unit_table()) count += a.name == b.name ? 1 : 0;
    CHECK(count == 1);
    CHECK(parse_unit(a.name).factor == a.factor);
    CHECK(parse_unit(a.name).dimension == a.dimension);
    CHECK(!a.sentence.empty());
  }
}

TEST_CASE("a wrong unit is rejected with the nearest name") {
  CHECK_THROWS_WITH_AS(parse_unit("kips"), "there is no unit 'kips'; did you mean 'kip'?", InputError);
  CHECK_THROWS_WITH_AS(parse_unit("lb"), "there is no unit 'lb'; write lbf for a force, lbm for a mass", InputError);
  CHECK_THROWS_WITH_AS(parse_unit("kip/feet"), doctest::Contains("there is no unit 'feet' in 'kip/feet'"), InputError);
  CHECK_THROWS_WITH_AS(parse_unit("in"),
                       "there is no unit 'in'; did you mean 'inch'? Other units of this kind: m, mm, cm, km, ft, yd",
                       InputError);
  CHECK_THROWS_WITH_AS(parse_unit("KN"),
                       "there is no unit 'KN'; did you mean 'kN'? Other units of this kind: N, MN, lbf, kip",
                       InputError);
  CHECK_THROWS_WITH_AS(parse_unit("sec"), "there is no unit 'sec'; did you mean 's'?", InputError);
  CHECK_THROWS_WITH_AS(parse_unit("xy"), doctest::Contains("there is no unit 'xy'; known: m, mm, cm"), InputError);
  CHECK_THROWS_AS(parse_unit(""), InputError);
  CHECK_THROWS_AS(parse_unit("m+s"), InputError);
}

TEST_CASE("a quantity is read in its declared unit or in the unit given with it") {
  CHECK(near(parse_quantity("0.6", "g", "pga"), 0.6 * 9.80665, 1e-12));
  CHECK(near(parse_quantity("0.6g", "g", "pga"), 0.6 * 9.80665, 1e-12));
  CHECK(parse_quantity(" 5.9 m/s2 ", "g", "pga") == 5.9);
  CHECK(near(parse_quantity("-1e3", "kip/ft", "k"), -1e3 * 4448.2216152605 / 0.3048, 1e-12));
  CHECK(parse_quantity("+2", "1", "n") == 2);
  CHECK(near(parse_quantity("30deg", "1", "angle"), std::numbers::pi / 6, 1e-12));
  CHECK_THROWS_WITH_AS(parse_quantity("3ft", "g", "pga"),
                       "pga is '3ft', which is in m; must be in g or another unit of m/s2", InputError);
  CHECK_THROWS_WITH_AS(parse_quantity("0.8g", "1", "pga"),
                       "pga is '0.8g', which is in m/s2; must be a number without a unit, as declared", InputError);
  for (const char* bad : {"", "x", "nan", "inf", "1e999", "0.6 0.7", "0.6gg"})
    CHECK_THROWS_AS(parse_quantity(bad, "g", "pga"), InputError);
}
