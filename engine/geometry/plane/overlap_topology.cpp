#include <cstdint>

#include "geometry/plane/shared_points.hpp"

namespace trilith {
namespace {

/// Puts the shared solid together as before, with the coordinates of now.
class FromTopology : SharedPoints {
 public:
  TRILITH_INLINE FromTopology(const PlacedSolid& a, const PlacedSolid& b, const OverlapTopology& known, EdgeOverlap& to)
      : SharedPoints(a, b, to), known_(known), enough_(Lanes{} + least_depth()) {}

  TRILITH_INLINE bool find() {
    for (std::size_t k = 0; k < known_.parts; ++k)
      if (!take_part(known_.part[k])) return false;
    if (any(is_outside_)) return false;
    take_rims();
    return is_sure();
  }

 private:
  TRILITH_INLINE bool take_part(const OverlapTopology::Part& part) {
    const std::vector<SolidEdge>& edges = solid_[part.solid]->solid->edges;
    if (part.edge >= edges.size()) return false;
    const SolidEdge& e = edges[part.edge];
    if (e.from != part.joins[0] || e.to != part.joins[1] || e.left != part.joins[2] || e.right != part.joins[3])
      return false;
    if (part.from == out_.points) add_point(end_of(part.solid, e, e.from, part.enters));
    if (part.to == out_.points) add_point(end_of(part.solid, e, e.to, part.leaves));
    return true;
  }

  /// The operations of EdgePart and FromEdges::end_of.
  [[nodiscard]] TRILITH_INLINE Lanes end_of(std::size_t s, const SolidEdge& e, int corner, int face) const {
    if (face < 0) return corner_arm(s, static_cast<std::size_t>(corner));
    const Triple<double> p = arm_of(s, int{e.from}), q = arm_of(s, int{e.to}), side = q - p;
    const double dp = depth(1 - s, face, p), dq = depth(1 - s, face, q), t = dp / (dp - dq);
    return Lanes{p.x + t * side.x, p.y + t * side.y, p.z + t * side.z, 0};
  }
  [[nodiscard]] TRILITH_INLINE double depth(std::size_t s, int face, const Triple<double>& at) const {
    const auto half = static_cast<std::size_t>(face / lane_count);
    const int lane = face % lane_count;
    const Triple<Lanes>& n = planes_[s].normal[half];
    return planes_[s].offset[half][lane] - (n.x[lane] * at.x + n.y[lane] * at.y + n.z[lane] * at.z);
  }
  [[nodiscard]] TRILITH_INLINE Triple<double> arm_of(std::size_t s, int corner) const {
    return triple_of(solid_[s]->corners[static_cast<std::size_t>(corner)]) - triple_of(origin_);
  }

  TRILITH_INLINE void add_point(const Lanes& at) {
    const auto i = static_cast<std::size_t>(out_.points++);
    out_.arm[i] = at;
    const LaneMask bits = LaneMask{} + static_cast<std::int64_t>(known_.on_faces[i]);
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t half = 0; half < 2; ++half) {
        const Triple<Lanes>& n = planes_[s].normal[half];
        const Lanes below = planes_[s].offset[half] - (n.x * at[0] + n.y * at[1] + n.z * at[2]);
        const std::int64_t first = std::int64_t{1} << (few_faces * s + lane_count * half);
        const LaneMask is_off = (bits & LaneMask{first, 2 * first, 4 * first, 8 * first}) == 0;
        const Lanes row = select(is_off, below, Lanes{});
        __builtin_memcpy(out_.depth[s][i].below.data() + half * lane_count, &row, sizeof row);
        is_outside_ |= is_off & ~(below > enough_);  // true where an edge parallel to a face gives no number
      }
  }

  TRILITH_INLINE void take_rims() {
    out_.faces = 0;
    for (std::size_t k = 0; k < known_.rims; ++k) {
      const OverlapTopology::Rim& rim = known_.rim[k];
      EdgeOverlap::Loop& loop = out_.loop[rim.loop];
      out_.faces |= 1U << rim.loop;
      loop.count = rim.count;
      __builtin_memcpy(loop.point.data(), rim.point.data(), sizeof rim.point);
    }
  }

  const OverlapTopology& known_;
  const Lanes enough_;
  LaneMask is_outside_{};  // some point does not lie inside of a face that it is not on
};

}  // namespace

[[gnu::target_clones("avx2", "default")]] bool overlap_as_before(const PlacedSolid& a, const PlacedSolid& b,
                                                                 const OverlapTopology& known, EdgeOverlap& out) {
  return FromTopology(a, b, known, out).find();
}

void OverlapMemory::begin(std::size_t size) {
  entry_.assign(2 * size, {});
  topology_.resize(size);
  used_ = asked_ = 0;
}

OverlapTopology& OverlapMemory::of(const PlacedSolid& a, const PlacedSolid& b) {
  constexpr std::size_t many_calls = 8;  // for each topology: most of them are out of use
  if (used_ == topology_.size())
    begin(used_ == 0 ? least : asked_ > many_calls * used_ || 2 * used_ > most ? used_ : 2 * used_);
  ++asked_;
  constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio: spreads neighbours
  const auto number = [](const PlacedSolid& of) {
    return static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(&of));
  };
  const std::uint64_t spread = (number(a) * golden + number(b)) * golden;
  const std::size_t last = entry_.size() - 1;
  for (std::size_t i = static_cast<std::size_t>(spread >> 32) & last;; i = (i + 1) & last) {
    Entry& entry = entry_[i];
    if (entry.a == &a && entry.b == &b) return topology_[entry.place];
    if (entry.a != nullptr) continue;
    entry = {&a, &b, used_++};
    topology_[entry.place].a = nullptr;
    return topology_[entry.place];
  }
}

}  // namespace trilith
