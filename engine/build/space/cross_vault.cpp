#include "build/space/cross_vault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "geometry/space/cut_solid.hpp"

namespace trilith {
namespace {

/// The stones of one course of the north web: whole ones from its end on, and the pieces that extend to the diagonals.
struct WebCourse {
  std::vector<std::vector<Polyhedron>> stones;
  std::vector<Polyhedron> to_diagonal;
};

/// Rotated by quarter turns about z, exactly.
Polyhedron quarter_turned(Polyhedron solid, int quarters) {
  for (Vec3& p : solid.corners)
    for (int q = 0; q < quarters; ++q) p = Vec3(-p.y(), p.x(), p.z());
  return solid;
}

class CrossVaultLayout {
 public:
  explicit CrossVaultLayout(const CrossVault& vault) : vault_(vault), owner_(builder_title("cross vault", vault.name)) {
    require_positive(vault.stone_length, owner_ + ": stone length", "m");
    require_place(vault.at, owner_);
    rotation_ = checked_turn({.axis = {0, 0, 1}, .angle = vault.angle}, owner_);
    Arch arch = vault.arch;
    arch.abutments = false, arch.centre.x() = 0;
    profile_ = build_profile(arch, owner_);
    for (const Part& part : profile_)
      for (const Vec2& p : part.outline) outer_ = std::max(outer_, std::abs(p.x()));
    half_bay_ = require_not_negative(vault.half_bay, owner_ + ": half bay", "m");
    if (half_bay_ == 0) half_bay_ = outer_;
    if (half_bay_ < outer_)
      throw InputError(fmt::format("{}: half bay is {:g} m, must be at least {:g} m, the outer edge of the arch",
                                   owner_, half_bay_, outer_));
    require_buildable(4 * half_bay_ / vault.stone_length * static_cast<double>(profile_.size()), owner_);
    for (std::size_t i = 0; i < profile_.size(); ++i) courses_.push_back(course(profile_[i].outline, i % 2 == 1));
  }

  std::vector<SolidPart> run() {
    constexpr std::array<const char*, 4> webs{"north", "west", "south", "east"};
    for (int w = 0; w < 4; ++w) web(webs[static_cast<std::size_t>(w)], w);
    for (int w = 0; w < 4; ++w) groin(w);
    if (courses_.size() % 2 == 1) key();
    for (SolidPart& part : parts_) place_part(part, rotation_, vault_.at);
    return std::move(parts_);
  }

 private:
  /// Joints keep a quarter of a stone distance from the point where the course meets the diagonal.
  [[nodiscard]] WebCourse course(const Polygon& outline, bool shifted) const {
    double reach = 0;
    for (const Vec2& p : outline) reach = std::max(reach, std::abs(p.x()));
    const double length = vault_.stone_length;
    WebCourse made;
    double end = half_bay_;
    for (double step = vault_.bond && shifted ? length / 2 : length; end - step >= reach + length / 4; step = length) {
      made.stones.push_back(prisms_between(outline, OutlinePlane::upright, end - step, end));
      end -= step;
    }
    for (const Polyhedron& piece : prisms_between(outline, OutlinePlane::upright, 0, end))
      if (auto left = between_diagonals(piece)) made.to_diagonal.push_back(std::move(*left));
    return made;
  }

  /// The part with y >= x and y >= -x; corners on the diagonal planes satisfy the equality exactly.
  [[nodiscard]] std::optional<Polyhedron> between_diagonals(const Polyhedron& piece) const {
    const double half = std::sqrt(0.5), same = 1e-12 * half_bay_;
    const std::array<CuttingPlane, 2> planes{CuttingPlane{Vec3(half, -half, 0), 0},
                                             CuttingPlane{Vec3(-half, -half, 0), 0}};
    auto left = cut_solid(piece, planes, same);
    if (left)
      for (Vec3& p : left->corners)
        if (std::abs(p.y() - std::abs(p.x())) <= 4 * same) p.y() = std::abs(p.x());
    return left;
  }

  void add(const std::string& piece, std::vector<Polyhedron> pieces, std::vector<std::string> groups) {
    if (!vault_.name.empty()) groups.push_back(vault_.name);
    parts_.push_back({part_name(vault_.name, piece), std::move(pieces), std::move(groups)});
  }

  void web(const char* name, int quarters) {
    for (std::size_t c = 0; c < courses_.size(); ++c)
      for (std::size_t s = 0; s < courses_[c].stones.size(); ++s) {
        std::vector<Polyhedron> pieces;
        for (const Polyhedron& piece : courses_[c].stones[s]) pieces.push_back(quarter_turned(piece, quarters));
        add(fmt::format("{}.c{}.s{}", name, c + 1, s + 1), std::move(pieces),
            {"voussoirs", name, fmt::format("course {}", c + 1)});
      }
  }

  /// At the left of the north web, in its rotated position, the right courses of the next web meet its own.
  void groin(int quarters) {
    for (std::size_t c = 0; c < courses_.size() / 2; ++c) {
      std::vector<Polyhedron> pieces;
      for (const Polyhedron& piece : courses_[c].to_diagonal) pieces.push_back(quarter_turned(piece, quarters));
      for (const Polyhedron& piece : courses_[courses_.size() - 1 - c].to_diagonal)
        pieces.push_back(quarter_turned(piece, quarters + 1));
      add(fmt::format("groin{}.c{}", quarters + 1, c + 1), std::move(pieces),
          {"groins", fmt::format("groin {}", quarters + 1), fmt::format("course {}", c + 1)});
    }
  }

  void key() {
    std::vector<Polyhedron> pieces;
    for (int quarters = 0; quarters < 4; ++quarters)
      for (const Polyhedron& piece : courses_[courses_.size() / 2].to_diagonal)
        pieces.push_back(quarter_turned(piece, quarters));
    add("key", std::move(pieces), {"key"});
  }

  const CrossVault& vault_;
  std::string owner_;
  UnitQuaternion rotation_;
  std::vector<Part> profile_;
  double outer_ = 0, half_bay_ = 0;
  std::vector<WebCourse> courses_;  ///< of the north web, from the west
  std::vector<SolidPart> parts_;
};

}  // namespace

std::vector<SolidPart> build_cross_vault(const CrossVault& vault) {
  return CrossVaultLayout(vault).run();
}

SolidParts CrossVault::parts() const {
  check_keys(*this, builder_title("cross vault", name));
  CrossVault vault = *this;
  vault.arch = with_span_and_rise(arch);
  return {build_cross_vault(vault), {}};
}

}  // namespace trilith
