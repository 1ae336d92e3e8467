#include "element/section/fibre_section_3d.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "element/section/fibre_lanes.hpp"
#include "element/section/fibre_outline.hpp"
#include "geometry/plane/half_plane.hpp"
#include "geometry/plane/outline_moments.hpp"

namespace trilith {
namespace {

/// Default number of levels; coordinates across have about the same spacing.
constexpr int default_levels = 8, most_across = 64;
/// Largest number of cells along either direction.
constexpr int most_cells = 100;

using Region = std::vector<SectionPart>;

/// `count` equal intervals from `low` to `high`, cut further at `borders`.
std::vector<double> grid_lines(double low, double high, int count, std::vector<double> borders) {
  const double same = 1e-9 * (high - low);
  for (int i = 0; i <= count; ++i) borders.push_back(low + (high - low) * i / count);
  std::sort(borders.begin(), borders.end());
  std::vector<double> out;
  for (const double at : borders)
    if (at >= low - same && at <= high + same && (out.empty() || at - out.back() > same)) out.push_back(at);
  return out;
}

/// The part of a region between two values of a coordinate (0: across, 1: up).
Region between(const Region& region, int coordinate, double low, double high, double same) {
  const Vec2 along = coordinate == 0 ? Vec2::UnitX() : Vec2::UnitY();
  Region out;
  for (const SectionPart& part : region)
    for (const Polygon& above : cut_by(part.outline, {-along, -low}, same))
      for (Polygon& inside : cut_by(above, {along, high}, same)) out.push_back({std::move(inside), part.sign});
  return out;
}

OutlineMoments moments_of(const Region& region) {
  OutlineMoments sum;
  for (const SectionPart& part : region) {
    const OutlineMoments own(part.outline);
    if (sum.area > 0)
      sum.add(own, part.sign);
    else if (part.sign > 0)
      sum = own;
  }
  return sum;
}

/// The lines that cut a section, and the area below which a cell is ignored.
struct CellGrid {
  std::vector<double> across, up;
  double same;        // [m]
  double least_area;  // [m2]

  /// Calls f(part of each region within the cell) for each cell, with all regions at once.
  template <class F>
  void for_cells(const Region& shape, const Region& core, F&& f) const {
    for (std::size_t j = 0; j + 1 < up.size(); ++j) {
      const Region row = between(shape, 1, up[j], up[j + 1], same), own = between(core, 1, up[j], up[j + 1], same);
      for (std::size_t i = 0; i + 1 < across.size(); ++i)
        f(moments_of(between(row, 0, across[i], across[i + 1], same)),
          moments_of(between(own, 0, across[i], across[i + 1], same)));
    }
  }
};

CellGrid grid_of(const FibreSpec& spec, const Section& whole, const Region& shape, const Region& core,
                 const FibreShape* core_shape) {
  const std::vector<double> ends = borders_across(shape);
  const double width = ends.back() - ends.front(), depth = whole.depth();
  const int levels = spec.cells[0] > 0 ? spec.cells[0] : default_levels;
  const int columns = spec.cells[1] > 0
                          ? spec.cells[1]
                          : std::clamp(static_cast<int>(std::lround(levels * width / depth)), 1, most_across);
  std::vector<double> level = borders_of(spec.shape), place = ends;
  if (core_shape != nullptr)
    for (const double at : borders_of(*core_shape)) level.push_back(spec.cover + at);
  if (!core.empty())
    for (const double at : borders_across(core)) place.push_back(at);
  return {grid_lines(ends.front(), ends.back(), columns, place), grid_lines(0, depth, levels, level),
          1e-12 * std::max(width, depth), 1e-9 * whole.area};
}

void add_cell(const OutlineMoments& cell, double below, double least_area, std::vector<Fibre3>& out) {
  if (!(cell.area > least_area)) return;
  for (const Vec2& arm : cell.arms())
    out.push_back({cell.area / 4, cell.middle.y() + arm.y() - below, cell.middle.x() + arm.x()});
}

void add_part(const UniaxialLaw& law, const std::vector<Fibre3>& fibres, FibreSection3& section) {
  if (fibres.empty()) return;
  section.parts.push_back({law, static_cast<int>(section.fibres.size()), static_cast<int>(fibres.size())});
  section.fibres.insert(section.fibres.end(), fibres.begin(), fibres.end());
}

/// Bars of one height, evenly distributed from one side to the other of their spread.
std::vector<Fibre3> bars_of(const FibreSpec& spec, double below, double width) {
  std::vector<Fibre3> out;
  for (const FibreBars& bars : spec.bars) {
    if (std::abs(bars.across) + 0.5 * bars.spread > 0.5 * width)
      throw InputError(fmt::format(
          "fibres: bars at {:g} m across, spread over {:g} m, stand outside of the section, which is {:g} m wide",
          bars.across, bars.spread, width));
    for (int i = 0; i < bars.count; ++i) {
      const double share = bars.count > 1 ? static_cast<double>(i) / (bars.count - 1) - 0.5 : 0;
      out.push_back({bars.area / bars.count, bars.height - below, bars.across + share * bars.spread});
    }
  }
  return out;
}

/// Adds the response of the fibres with one law to `out`. With a = (1, z, -y): e = a . strain, stress += s A a, tangent
/// += E A a a'.
template <UniaxialLawType L>
void respond_one_by_one(const L& given, std::span<const Fibre3> fibres, const Eigen::Vector3d& strain,
                        const double* before, double* after, SectionResponse3& out) {
  const L law = given;  // `after` cannot point into a copy, so its constants leave the loop
  SectionResponse3 sum = out;
  for (const Fibre3& f : fibres) {
    typename L::Memory memory;
    for (double& m : memory) m = *before++;
    const Eigen::Vector3d arm(1, f.across, -f.up);
    const UniaxialResponse<L::memory_size> r = law.respond(arm.dot(strain), memory);
    for (const double m : r.memory) *after++ = m;
    sum.stress += r.stress() * f.area * arm;
    sum.tangent += r.tangent * f.area * (arm * arm.transpose());
    sum.stored += r.stored * f.area, sum.dissipated += r.dissipated * f.area;
    sum.yielding = sum.yielding || r.yielding;
  }
  out = sum;
}

/// The sums of respond_one_by_one over four fibres at a time.
struct SpaceSums {
  const Eigen::Vector3d& given;
  FourSums stresses, tangents, rest;
  LaneMask yielding;

  TRILITH_INLINE SpaceSums(const Eigen::Vector3d& strain, const SectionResponse3& out)
      : given(strain),
        stresses{Lanes{out.stress[0], out.stress[1], out.stress[2], out.tangent(0, 0)}},
        tangents{Lanes{out.tangent(0, 1), out.tangent(0, 2), out.tangent(1, 1), out.tangent(1, 2)}},
        rest{Lanes{out.tangent(2, 2), out.tangent(2, 1), out.stored, out.dissipated}},
        yielding{} {}
  TRILITH_INLINE static Lanes across(const Fibre3* f) {
    return Lanes{f[0].across, f[1].across, f[2].across, f[3].across};
  }
  TRILITH_INLINE static Lanes down(const Fibre3* f) { return Lanes{-f[0].up, -f[1].up, -f[2].up, -f[3].up}; }
  /// The sum in the order of Eigen's dot product.
  TRILITH_INLINE Lanes strain(const Fibre3* f) const { return given[0] + across(f) * given[1] + down(f) * given[2]; }
  TRILITH_INLINE void add(const Fibre3* f, const ConcreteFourResponse& r) {
    const Lanes area{f[0].area, f[1].area, f[2].area, f[3].area}, z = across(f), y = down(f);
    const Lanes force = r.memory.stress * area, stiffness = r.tangent * area;
    stresses.add(force, force * z, force * y, stiffness);
    // Eigen multiplies in this order, so the two entries of a pair may differ in the last bit.
    const Lanes by_z = stiffness * z, by_y = stiffness * y;
    tangents.add(by_z, by_y, by_z * z, by_z * y);
    rest.add(by_y * y, by_y * z, r.stored * area, r.dissipated * area);
    yielding |= r.yielding;
  }
  TRILITH_INLINE void take(SectionResponse3& out) const {
    out.stress = Eigen::Vector3d(stresses.sum[0], stresses.sum[1], stresses.sum[2]);
    const Lanes& t = tangents.sum;
    out.tangent << stresses.sum[3], t[0], t[1], t[0], t[2], t[3], t[1], rest.sum[1], rest.sum[0];
    out.stored = rest.sum[2], out.dissipated = rest.sum[3];
    out.yielding = out.yielding || any(yielding);
  }
};

template <UniaxialLawType L>
void respond_part(const L& law, std::span<const Fibre3> fibres, const Eigen::Vector3d& strain, const double* before,
                  double* after, SectionResponse3& out) {
  const std::size_t done = respond_in_lanes<SpaceSums>(law, fibres, strain, before, after, out);
  const std::size_t place = done * L::memory_size;
  respond_one_by_one(law, fibres.subspan(done), strain, before + place, after + place, out);
}

}  // namespace

int FibreSection3::memory_size() const {
  int size = 0;
  for (const FibrePart& p : parts) size += p.count * trilith::memory_size(p.law);
  return size;
}

Eigen::Matrix3d FibreSection3::stiffest() const {
  Eigen::Matrix3d out = Eigen::Matrix3d::Zero();
  for (const FibrePart& p : parts) {
    const double young = trilith::stiffest(p.law);
    for (const Fibre3& f :
         std::span(fibres).subspan(static_cast<std::size_t>(p.first), static_cast<std::size_t>(p.count))) {
      const Eigen::Vector3d arm(1, f.across, -f.up);
      out += young * f.area * arm * arm.transpose();
    }
  }
  return out;
}

/// For each cell the core part, and the rest as cover.
FibreSection3 make_fibres_in_space(const FibreSpec& spec) {
  make_fibres(spec);  // validates the specification as in the plane
  for (const int cells : spec.cells)
    if (cells < 0 || cells > most_cells)
      throw InputError(
          fmt::format("fibres: {} layers over the depth or the width, must be 1 to {} in space", cells, most_cells));
  const Section whole = section_of(spec.shape);
  std::optional<FibreShape> core_shape = spec.core;
  if (!core_shape && spec.cover > 0) core_shape = core_of(spec.shape, spec.cover);
  const Region shape = parts_of(spec.shape);
  Region core;
  if (core_shape) core = parts_of(*core_shape);
  for (SectionPart& part : core)
    for (Vec2& p : part.outline) p.y() += spec.cover;
  const CellGrid grid = grid_of(spec, whole, shape, core, core_shape ? &*core_shape : nullptr);
  std::vector<Fibre3> inside, outside;
  grid.for_cells(shape, core, [&](OutlineMoments cell, const OutlineMoments& held) {
    if (core_shape && held.area > grid.least_area) {
      if (held.area > cell.area + 1e-6 * whole.area) throw InputError("fibres: the core reaches beyond the shape");
      add_cell(held, whole.below, grid.least_area, inside);
      cell.add(held, -1);
    }
    add_cell(cell, whole.below, grid.least_area, core_shape ? outside : inside);
  });
  FibreSection3 out;
  add_part(spec.law, inside, out);
  add_part(spec.cover_law, outside, out);
  add_part(spec.bar_law, bars_of(spec, whole.below, grid.across.back() - grid.across.front()), out);
  return out;
}

SectionResponse3 respond(const FibreSection3& section, const Eigen::Vector3d& strain, std::span<const double> before,
                         std::span<double> after) {
  assert(before.size() == after.size() && static_cast<int>(after.size()) == section.memory_size());
  SectionResponse3 out;
  std::size_t place = 0;
  for (const FibrePart& p : section.parts)
    std::visit(
        [&](const auto& law) {
          const auto count = static_cast<std::size_t>(p.count);
          respond_part(law, std::span(section.fibres).subspan(static_cast<std::size_t>(p.first), count), strain,
                       before.data() + place, after.data() + place, out);
          place += count * std::decay_t<decltype(law)>::memory_size;
        },
        p.law);
  return out;
}

}  // namespace trilith
