#include "build/space/cross_vault.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "build/sound_parts.hpp"
#include "build/sound_solids.hpp"
#include "build/space/check_solids.hpp"
#include "geometry/plane/half_plane.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Volume of four webs, each the profile times the length between the diagonal and the end of the web: half bay minus
/// |x|.
double vault_volume(Arch arch, double half_bay) {
  arch.abutments = false;
  double volume = 0;
  for (const Part& part : build_arch(arch))
    for (const double side : {1.0, -1.0})
      for (const Polygon& half : cut_by(part.outline, HalfPlane{Vec2(side, 0), 0}, 1e-12)) {
        const PolygonMoments m = polygon_moments(half);
        volume += 4 * m.area * (half_bay - std::abs(m.centroid.x()));
      }
  return volume;
}

/// Whether one of the parts equals the mirrored or rotated `part`.
template <class Image>
bool has_image(const std::vector<SolidPart>& parts, const SolidPart& part, Image image) {
  const auto middle = [](const SolidPart& p) {
    Vec3 first = Vec3::Zero();
    for (const Polyhedron& piece : p.pieces) first += solid_moments(piece).volume * solid_moments(piece).centroid;
    return Vec3(first / volume_of(p));
  };
  const Vec3 wanted = image(middle(part));
  return std::any_of(parts.begin(), parts.end(), [&](const SolidPart& other) {
    return (middle(other) - wanted).norm() < 1e-12 && near(volume_of(other), volume_of(part), 1e-12);
  });
}

}  // namespace

TEST_CASE("a cross vault has the volume of its webs, is sound and its own mirror image") {
  for (const int n : {9, 12})
    for (const double half_bay : {0.0, 2.7}) {
      CAPTURE(n);
      CAPTURE(half_bay);
      const Arch arch{.voussoirs = n, .radius = 2, .thickness = 0.3};
      const std::vector<SolidPart> parts =
          build_cross_vault({.name = "V", .arch = arch, .half_bay = half_bay, .stone_length = 0.5});
      CHECK(near(total_volume(parts), vault_volume(arch, half_bay == 0 ? 2.15 : half_bay), 1e-12));
      check_sound(parts);
      CHECK(count_in_group(parts, "groins") == 4 * (n / 2));
      CHECK(count_in_group(parts, "key") == n % 2);
      for (const SolidPart& part : parts) {
        CHECK(has_image(parts, part, [](const Vec3& p) { return Vec3(-p.y(), p.x(), p.z()); }));
        // an even number of courses is in bond over the crown too, so that left and right differ
        if (n % 2 == 1) CHECK(has_image(parts, part, [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); }));
      }
    }
}

TEST_CASE("pieces of groin stones and of the key share their faces in the diagonal planes") {
  const std::vector<SolidPart> parts = build_cross_vault(
      {.arch = {.voussoirs = 7, .radius = 2, .thickness = 0.3}, .half_bay = 2.5, .stone_length = 0.6});
  for (const SolidPart& part : parts) {
    if (part.groups[0] == "voussoirs") continue;
    REQUIRE(part.pieces.size() == (part.groups[0] == "key" ? 4U : 2U));
    for (std::size_t i = 0; i < part.pieces.size(); ++i) {
      const Polyhedron &a = part.pieces[i], &b = part.pieces[(i + 1) % part.pieces.size()];
      int shared = 0;
      for (const Vec3& p : a.corners) shared += static_cast<int>(std::count(b.corners.begin(), b.corners.end(), p));
      CHECK(shared >= 4);
    }
  }
  std::vector<SolidPart> all = parts;
  CHECK(check_solids(all).empty());
}

TEST_CASE("cross vaults may be pointed or segmental, turned, and without bond") {
  const Arch pointed{.voussoirs = 10, .radius = 2, .thickness = 0.25, .offset = 0.5};
  const Arch segmental{.voussoirs = 9, .radius = 3, .thickness = 0.2, .half_angle = 0.9};
  for (const Arch& arch : {pointed, segmental}) {
    const CrossVault vault{
        .arch = arch, .half_bay = 3, .stone_length = 0.4, .bond = false, .at = {1, 2, 3}, .angle = 0.3};
    const std::vector<SolidPart> parts = build_cross_vault(vault);
    CHECK(near(total_volume(parts), vault_volume(arch, 3), 1e-12));
    check_sound(parts);
  }
}

TEST_CASE("impossible cross vaults are rejected") {
  CHECK(mentions(refusal_of([] { build_cross_vault({.name = "V"}); }), "cross vault 'V': stone length is 0 m"));
  CHECK(mentions(refusal_of([] { build_cross_vault({.half_bay = 1, .stone_length = 1}); }),
                 "half bay is 1 m, must be at least 1.075 m"));
  CHECK(mentions(refusal_of([] { build_cross_vault({.arch = {.voussoirs = 0}, .stone_length = 1}); }),
                 "arch: voussoirs is 0"));
}
