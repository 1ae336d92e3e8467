#include "build/space/drum.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

constexpr int most_sides = 1000;

/// Radius of the corners of a regular polygon whose `radius` refers to `of`.
double corner_radius(double radius, int sides, DrumRadius of) {
  const double half = std::numbers::pi / sides;
  switch (of) {
    case DrumRadius::sides:
      return radius / portable::cos(half);
    case DrumRadius::area:
      return radius * std::sqrt(2 * half / portable::sin(2 * half));
    default:
      return radius;
  }
}

/// Corners of a regular polygon at a height, about an upright axis through (x, y).
std::vector<Vec3> ring(const Vec2& middle, int sides, double radius, double phase, double z) {
  std::vector<Vec3> corners;
  for (int i = 0; i < sides; ++i) {
    const auto [sine, cosine] = portable::sine_cosine(phase + 2 * std::numbers::pi * i / sides);
    corners.emplace_back(middle.x() + radius * cosine, middle.y() + radius * sine, z);
  }
  return corners;
}

void check_round(int sides, double radius, double phase, const std::string& owner) {
  require_count(sides, 3, most_sides, owner + ": number of sides");
  require_positive(radius, owner + ": radius", "m");
  require_finite(phase, owner + ": phase");
}

double top_or_foot(double top, double foot, const std::string& owner) {
  return require_not_negative(top, owner + ": top radius", "m") == 0 ? foot : top;
}

SolidPart drum_between(const Drum& drum, double foot_radius, double top_radius, const std::string& owner) {
  require_positive(drum.height, owner + ": height", "m");
  require_place(drum.at, owner);
  const UnitQuaternion rotation = checked_turn(drum.turn, owner);
  const Vec2 axis = Vec2::Zero();
  SolidPart part{drum.name,
                 lofted(ring(axis, drum.sides, foot_radius, drum.phase, 0),
                        ring(axis, drum.sides, top_radius, drum.phase, drum.height)),
                 drum.groups};
  place_part(part, rotation, drum.at);
  return part;
}

}  // namespace

SolidPart build_prism(const RegularPrism& prism) {
  const std::string owner = builder_title("prism", prism.name);
  check_round(prism.sides, prism.radius, prism.phase, owner);
  const Drum drum{.name = prism.name,
                  .sides = prism.sides,
                  .height = prism.height,
                  .phase = prism.phase,
                  .at = prism.at,
                  .turn = prism.turn,
                  .groups = prism.groups};
  return drum_between(drum, prism.radius, prism.radius, owner);
}

SolidPart build_cylinder_drum(const Drum& drum) {
  const std::string owner = builder_title("drum", drum.name);
  check_round(drum.sides, drum.radius, drum.phase, owner);
  const double top = top_or_foot(drum.top_radius, drum.radius, owner);
  return drum_between(drum, corner_radius(drum.radius, drum.sides, drum.of), corner_radius(top, drum.sides, drum.of),
                      owner);
}

namespace {

/// Stacks the parts of a column.
class ColumnLayers {
 public:
  explicit ColumnLayers(const Column& column) : column_(column), owner_(builder_title("column", column.name)) {
    check_round(column.sides, column.radius, column.phase, owner_);
    require_place(column.at, owner_);
    heights_ = column.heights;
    if (heights_.empty()) {
      const int drums = require_count(column.drums, 1, 10000, owner_ + ": number of drums");
      heights_.assign(static_cast<std::size_t>(drums),
                      require_positive(column.height, owner_ + ": height", "m") / drums);
    }
    for (std::size_t i = 0; i < heights_.size(); ++i)
      require_positive(heights_[i], fmt::format("{}: height of drum {}", owner_, i + 1), "m");
    z_ = column.at.z();
  }

  std::vector<SolidPart> run() {
    block(column_.base, "base");
    drums();
    block(column_.capital, "capital");
    return std::move(parts_);
  }

 private:
  void add(const std::string& piece, const char* group, std::vector<Polyhedron> pieces) {
    parts_.push_back({part_name(column_.name, piece), std::move(pieces), {group}});
    if (!column_.name.empty()) parts_.back().groups.push_back(column_.name);
  }

  void block(const ColumnBlock& of, const char* what) {
    if (require_not_negative(of.width, fmt::format("{}: width of its {}", owner_, what), "m") == 0) return;
    require_positive(of.height, fmt::format("{}: height of its {}", owner_, what), "m");
    const Vec3& at = column_.at;
    const double half = of.width / 2, top = z_ + of.height;
    add(what, what, {box_between({at.x() - half, at.y() - half, z_}, {at.x() + half, at.y() + half, top})});
    z_ = top;
  }

  void drums() {
    const double foot = corner_radius(column_.radius, column_.sides, column_.of);
    const double head =
        corner_radius(top_or_foot(column_.top_radius, column_.radius, owner_), column_.sides, column_.of);
    double all = 0, below = 0;
    for (const double height : heights_) all += height;
    const Vec2 axis = column_.at.head<2>();
    std::vector<Vec3> low = ring(axis, column_.sides, foot, column_.phase, z_);
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      below += heights_[i], z_ += heights_[i];
      const std::vector<Vec3> high = ring(axis, column_.sides, foot + (head - foot) * (below / all), column_.phase, z_);
      add(fmt::format("d{}", i + 1), "drums", lofted(low, high));
      low = high;
    }
  }

  const Column& column_;
  std::string owner_;
  std::vector<double> heights_;
  double z_ = 0;
  std::vector<SolidPart> parts_;
};

}  // namespace

std::vector<SolidPart> build_column(const Column& column) {
  return ColumnLayers(column).run();
}

SolidParts RegularPrism::parts() const {
  check_keys(*this, builder_title(kind, name));
  return one_part(build_prism(*this));
}

SolidParts Column::parts() const {
  check_keys(*this, builder_title(kind, name));
  return {build_column(*this), {}};
}

}  // namespace trilith
