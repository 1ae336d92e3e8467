#include <doctest/doctest.h>
#include <fmt/format.h>

#include <numbers>

#include "build/block_list.hpp"
#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"
#include "build/space/barrel_vault.hpp"
#include "build/space/dome.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Rounding of lists with six digits: half of the last digit.
constexpr double six_digits = 0.51e-6;

BarrelVault published_vault() {
  return {.name = "V",
          .arch = {.voussoirs = 15, .radius = 1, .thickness = 0.2, .abutments = false},
          .stone_length = 0.5,
          .stones = 3};
}

/// Volume of all rings of a dome, between regular polygons of corner radius r sin(colatitude) at height r
/// cos(colatitude).
double volume_within(const Dome& dome, double r) {
  const int n = dome.sectors;
  const double unit = n / 2.0 * std::sin(2 * std::numbers::pi / n);
  double volume = 0;
  for (int k = 0; k < dome.rings; ++k) {
    const double step = (dome.crown - dome.springing) / dome.rings;
    const double low = dome.springing + k * step, high = low + step;
    const double a = r * std::sin(low), b = r * std::sin(high);
    volume += unit * (a * a + a * b + b * b) / 3 * r * (std::cos(high) - std::cos(low));
  }
  return volume;
}

/// Within a cone from the centre to the bed at a colatitude, for a corner radius r.
double cone_within(const Dome& dome, double r, double colatitude) {
  const int n = dome.sectors;
  const double a = r * std::sin(colatitude);
  return n / 2.0 * std::sin(2 * std::numbers::pi / n) * a * a * r * std::cos(colatitude) / 3;
}

}  // namespace

TEST_CASE("the barrel vault of the published test comes out block by block") {
  check_same_blocks(build_barrel_vault(published_vault()), block_list("vault_n15_t20.json"), six_digits);
}

TEST_CASE("a barrel vault in bond has the arch's volume and lies flat on itself") {
  BarrelVault vault = published_vault();
  vault.arch.abutments = true;
  const std::vector<SolidPart> parts = build_barrel_vault(vault);
  CHECK(count_in_group(parts, "voussoirs") == 52);
  CHECK(count_in_group(parts, "key") == 4);
  CHECK(count_in_group(parts, "course 2") == 4);
  CHECK(named(parts, "V.c2.s1").groups == std::vector<std::string>{"voussoirs", "course 2", "V"});
  const double d = std::numbers::pi / 15, area = 15 * std::sin(d) / 2 * (1.1 * 1.1 - 0.9 * 0.9);
  double volume = 0;
  for (const SolidPart& part : parts)
    if (part.groups[0] == "voussoirs" || part.groups[0] == "key") volume += volume_of(part);
  CHECK(near(volume, 1.5 * area, 1e-12));
  // bed joints, joints within the courses, and both springings
  const double beds = 14 * 0.2 * 1.5, heads = (8 * 2 + 7 * 3) * area / 15, springings = 2 * 0.2 * 1.5;
  CHECK(near(check_sound(parts), beds + heads + springings, 1e-9));
}

TEST_CASE("a vault may be pointed, without bond, with curved stones, and stand anywhere") {
  BarrelVault vault = published_vault();
  vault.arch.offset = 0.4, vault.arch.sub_edges = 3;
  vault.bond = false, vault.from = -0.7, vault.at = {1, 2, 3}, vault.turn.angle = 0.3;
  const std::vector<SolidPart> parts = build_barrel_vault(vault);
  CHECK(parts.size() == 45);
  double area = 0;
  vault.arch.abutments = false;
  for (const Part& part : build_arch(vault.arch)) area += signed_area(part.outline);
  CHECK(near(total_volume(parts), 1.5 * area, 1e-12));
  check_sound(parts);
  vault = published_vault();
  vault.half_first = true;
  CHECK(build_barrel_vault(vault).size() == 53);
}

TEST_CASE("impossible vaults are rejected") {
  BarrelVault vault = published_vault();
  vault.stones = 0;
  CHECK(mentions(refusal_of([&] { build_barrel_vault(vault); }), "vault 'V': number of stones in a course is 0"));
  vault = published_vault();
  vault.stone_length = 0;
  CHECK(mentions(refusal_of([&] { build_barrel_vault(vault); }), "vault 'V': stone length is 0 m"));
  vault = published_vault();
  vault.arch.thickness = 3;
  CHECK(mentions(refusal_of([&] { build_barrel_vault(vault); }), "thickness is 3 m"));
}

TEST_CASE("the dome of the published test comes out block by block") {
  check_same_blocks(build_dome({.radius = 1, .thickness = 0.12, .rings = 8, .sectors = 16}),
                    block_list("dome_r8_s16_t12.json"), six_digits);
}

TEST_CASE("a dome has the volume between its two polyhedra and shares all its beds and sides") {
  for (const int sectors : {5, 16, 40})
    for (const double springing : {std::numbers::pi / 2, 1.1}) {
      const Dome dome{.name = "D",
                      .radius = 2,
                      .thickness = 0.3,
                      .rings = 6,
                      .sectors = sectors,
                      .springing = springing,
                      .crown = 0.2,
                      .phase = 0.1,
                      .centre = {0.5, -1, 2}};
      const std::vector<SolidPart> parts = build_dome(dome);
      REQUIRE(static_cast<int>(parts.size()) == 6 * sectors + 1);
      CHECK(parts.back().name == "D.key");
      double expected = 0;
      for (const double sign : {1.0, -1.0}) {
        const double r = dome.radius + sign * dome.thickness / 2;
        expected +=
            sign * (volume_within(dome, r) + cone_within(dome, r, springing) - cone_within(dome, r, dome.crown));
      }
      const double key = volume_of(parts.back());
      CHECK(near(total_volume(parts) - key, expected, 1e-12));
      for (const SolidPart& part : parts)
        for (const Polyhedron& piece : part.pieces) check_convex(piece, part.name, 1e-14);
      check_sound(parts);
      for (int k = 0; k < 6; ++k) {
        const double first = volume_of(named(parts, fmt::format("D.r{}.s1", k + 1)));
        for (int j = 2; j <= sectors; ++j)
          CHECK(near(volume_of(named(parts, fmt::format("D.r{}.s{}", k + 1, j))), first, 1e-12));
      }
    }
}

TEST_CASE("a dome with an oculus has no key") {
  const std::vector<SolidPart> parts = build_dome({.rings = 2, .sectors = 8, .top = DomeTop::oculus});
  CHECK(parts.size() == 16);
  CHECK(count_in_group(parts, "ring 2") == 8);
}

TEST_CASE("impossible domes are rejected") {
  CHECK(mentions(refusal_of([] { build_dome({.name = "D", .rings = 0}); }), "dome 'D': number of rings is 0"));
  CHECK(mentions(refusal_of([] { build_dome({.sectors = 2}); }), "number of sectors is 2"));
  CHECK(
      mentions(refusal_of([] { build_dome({.radius = 1, .thickness = 2}); }), "thickness is 2 m, must be below twice"));
  CHECK(mentions(refusal_of([] { build_dome({.springing = 90}); }), "colatitude of the springing is 90 rad"));
  CHECK(mentions(refusal_of([] { build_dome({.springing = 0.1, .crown = 0.2}); }),
                 "must be below the colatitude of the springing"));
}
