#include "geometry/plane/edge_overlap.hpp"

#include <bit>

#include "base/simd/lane_bits.hpp"

namespace trilith {
namespace {

constexpr int room_of_faces = few_faces;
/// Offset of unused planes [m].
constexpr double far_plane = 1e100;

TRILITH_INLINE Lanes first_half(const DepthRow& row) {
  Lanes v;
  __builtin_memcpy(&v, row.below.data(), sizeof v);
  return v;
}
TRILITH_INLINE Lanes second_half(const DepthRow& row) {
  Lanes v;
  __builtin_memcpy(&v, row.below.data() + lane_count, sizeof v);
  return v;
}

/// The planes of a solid in lanes: n . x = c, x measured from the origin.
struct Planes {
  std::array<Triple<Lanes>, 2> normal;
  std::array<Lanes, 2> offset;

  TRILITH_INLINE Planes(const PlacedSolid& solid, const Vec3& origin) {
    const FaceLoops& faces = solid.solid->shape.faces;
    std::array<DepthRow, 4> rows{};  // x, y, z and c
    rows[3].below.fill(far_plane);
    for (std::size_t f = 0; f < solid.normals.size(); ++f) {
      const Vec3 &n = solid.normals[f],
                 &x = solid.corners[static_cast<std::size_t>(faces.corner[static_cast<std::size_t>(faces.start[f])])];
      rows[0].below[f] = n.x(), rows[1].below[f] = n.y(), rows[2].below[f] = n.z();
      rows[3].below[f] = n.x() * (x.x() - origin.x()) + n.y() * (x.y() - origin.y()) + n.z() * (x.z() - origin.z());
    }
    normal[0] = {first_half(rows[0]), first_half(rows[1]), first_half(rows[2])}, offset[0] = first_half(rows[3]);
    normal[1] = {second_half(rows[0]), second_half(rows[1]), second_half(rows[2])}, offset[1] = second_half(rows[3]);
  }
  TRILITH_INLINE void depths(double x, double y, double z, DepthRow& row) const {
    for (std::size_t half = 0; half < 2; ++half) {
      const Triple<Lanes>& n = normal[half];
      const Lanes below = offset[half] - (n.x * x + n.y * y + n.z * z);
      __builtin_memcpy(row.below.data() + half * lane_count, &below, sizeof below);
    }
  }
};

/// Bit f: the point lies outside of face f.
TRILITH_INLINE unsigned outside(const DepthRow& row) {
  return lane_bits(first_half(row) < 0.0, second_half(row) < 0.0);
}

TRILITH_INLINE double largest(const Lanes& v) {
  return larger(larger(v[0], v[1]), larger(v[2], v[3]));
}

/// The part of an edge inside the other solid, and the faces through which it enters and leaves (-1: at an end of the
/// edge). All faces are tested at once: few edges cross a face, and a branch would be unpredictable.
struct EdgePart {
  double from, to;
  int enters, leaves;

  TRILITH_INLINE EdgePart(const DepthRow& p, const DepthRow& q) {
    std::array<Lanes, 2> in, out;  // where the edge enters through each face; how far before its end it leaves
    for (std::size_t half = 0; half < 2; ++half) {
      const Lanes dp = half == 0 ? first_half(p) : second_half(p), dq = half == 0 ? first_half(q) : second_half(q);
      const Lanes t = dp / (dp - dq);
      in[half] = select(dp < 0.0, t, Lanes{}), out[half] = select(dq < 0.0, -t, Lanes{} - 1.0);
    }
    from = largest(larger<Lanes>(in[0], in[1]));
    const double last = largest(larger<Lanes>(out[0], out[1]));
    to = -last;
    enters = from > 0 ? std::countr_zero(lane_bits(in[0] == from, in[1] == from)) : -1;
    leaves = to < 1 ? std::countr_zero(lane_bits(out[0] == last, out[1] == last)) : -1;
  }
};

/// Builds the shared solid.
class FromEdges {
 public:
  TRILITH_INLINE FromEdges(const PlacedSolid& a, const PlacedSolid& b, EdgeOverlap& to)
      : solid_{&a, &b}, origin_(a.corners[0]), planes_{Planes(a, origin_), Planes(b, origin_)}, out_(to) {
    out_.points = 0;
    for (auto& ends : meeting_)
      for (auto& of : ends) of = {-1, -1};
  }

  TRILITH_INLINE bool find() {
    if (!take_corners(0) || !take_corners(1)) return false;
    take_edges(0), take_edges(1);
    if (!closed_ || out_.points < 4) return false;
    take_meetings();
    return closed_ && take_loops() && is_sure();
  }

 private:
  static constexpr int most_points = EdgeOverlap::most_points;
  /// Directed edges of a face of the shared solid: the successor of each point.
  struct Steps {
    std::uint64_t from = 0, to = 0;  // bit sets of points
    int count = 0;
    std::array<std::uint8_t, most_points> next;
  };
  struct Meeting {
    std::int16_t start, end;  // points, along the face of a; -1: not yet known
  };

  /// Arms and depths of the corners of one solid; false where all lie outside of one face of the other.
  TRILITH_INLINE bool take_corners(std::size_t s) {
    const PlacedSolid& solid = *solid_[s];
    unsigned all = 255;
    for (std::size_t i = 0; i < solid.corners.size(); ++i) {
      const Vec3& x = solid.corners[i];
      planes_[1 - s].depths(x.x() - origin_.x(), x.y() - origin_.y(), x.z() - origin_.z(), corner_depth_[s][i]);
      code_[s][i] = outside(corner_depth_[s][i]);
      all &= code_[s][i];
      corner_point_[s][i] = -1;
    }
    return all == 0;
  }

  [[nodiscard]] TRILITH_INLINE Lanes corner_arm(std::size_t s, std::size_t corner) const {
    const Vec3& x = solid_[s]->corners[corner];
    return Lanes{x.x() - origin_.x(), x.y() - origin_.y(), x.z() - origin_.z(), 0};
  }

  TRILITH_INLINE int add_point(const Lanes& at) {
    const auto i = static_cast<std::size_t>(out_.points++);
    out_.arm[i] = at;
    for (std::size_t s = 0; s < 2; ++s) planes_[s].depths(at[0], at[1], at[2], out_.depth[s][i]);
    return static_cast<int>(i);
  }

  /// The depth of a point below the faces that it lies on is exactly 0, regardless of rounding.
  TRILITH_INLINE void put_on(int point, std::size_t s, int face) {
    out_.depth[s][static_cast<std::size_t>(point)].below[static_cast<std::size_t>(face)] = 0;
  }

  /// The corner of the shared solid at an end of an edge: the edge's own corner, or a point in a face of the other
  /// solid.
  TRILITH_INLINE int end_of(std::size_t s, const SolidEdge& e, std::size_t corner, double t, int face) {
    int point;
    if (face < 0) {
      std::int16_t& known = corner_point_[s][corner];
      if (known < 0) known = static_cast<std::int16_t>(add_point(corner_arm(s, corner)));
      point = known;
    } else {
      const Lanes p = corner_arm(s, e.from), q = corner_arm(s, e.to);
      point = add_point(p + t * (q - p));
      put_on(point, 1 - s, face);
    }
    put_on(point, s, e.left), put_on(point, s, e.right);
    return point;
  }

  TRILITH_INLINE void step(std::size_t loop, int from, int to) {
    Steps& steps = steps_[loop];
    steps.next[static_cast<std::size_t>(from)] = static_cast<std::uint8_t>(to);
    steps.from |= std::uint64_t{1} << from, steps.to |= std::uint64_t{1} << to;
    ++steps.count;
  }

  TRILITH_INLINE void set_end(int face_a, int face_b, bool is_start, int point) {
    Meeting& of = meeting_[static_cast<std::size_t>(face_a)][static_cast<std::size_t>(face_b)];
    std::int16_t& end = is_start ? of.start : of.end;
    if (end >= 0) closed_ = false;
    end = static_cast<std::int16_t>(point);
    if ((is_start ? of.end : of.start) < 0)
      met_[static_cast<std::size_t>(meetings_++)] = {static_cast<std::int16_t>(face_a),
                                                     static_cast<std::int16_t>(face_b)};
  }

  /// At a point where an edge of solid s passes through a face of the other, two face intersections end. Intersections
  /// are directed along the face of a. The left face of an edge of a continues along the other's face from the point
  /// where the edge leaves. For an edge of b it is the reverse.
  TRILITH_INLINE void end_meetings(std::size_t s, const SolidEdge& e, int face, bool leaves, int point) {
    if (s == 0)
      set_end(e.left, face, leaves, point), set_end(e.right, face, !leaves, point);
    else
      set_end(face, e.left, !leaves, point), set_end(face, e.right, leaves, point);
  }

  TRILITH_INLINE void take_edges(std::size_t s) {
    const std::vector<SolidEdge>& edges = solid_[s]->solid->edges;
    unsigned may_enter = 0;  // edges for which no face has both ends outside
    for (std::size_t i = 0; i < edges.size(); ++i)
      may_enter |= static_cast<unsigned>((code_[s][edges[i].from] & code_[s][edges[i].to]) == 0) << i;
    for (; may_enter != 0; may_enter &= may_enter - 1) {
      const SolidEdge& e = edges[static_cast<std::size_t>(std::countr_zero(may_enter))];
      const EdgePart part(corner_depth_[s][e.from], corner_depth_[s][e.to]);
      if (!(part.from < part.to)) continue;
      if (out_.points + 2 > most_points || meetings_ + 4 > most_meetings) {
        closed_ = false;
        return;
      }
      const int from = end_of(s, e, e.from, part.from, part.enters), to = end_of(s, e, e.to, part.to, part.leaves);
      step(e.left + room_of_faces * s, from, to), step(e.right + room_of_faces * s, to, from);
      if (part.enters >= 0) end_meetings(s, e, part.enters, false, from);
      if (part.leaves >= 0) end_meetings(s, e, part.leaves, true, to);
    }
  }

  TRILITH_INLINE void take_meetings() {
    for (int i = 0; i < meetings_; ++i) {
      const auto [a, b] = met_[static_cast<std::size_t>(i)];
      const Meeting& of = meeting_[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      if (of.start < 0 || of.end < 0) {
        closed_ = false;
        return;
      }
      step(static_cast<std::size_t>(a), of.start, of.end);
      step(static_cast<std::size_t>(b + room_of_faces), of.end, of.start);
    }
  }

  /// Follows each face once around; false where a face does not close.
  TRILITH_INLINE bool take_loops() {
    for (std::size_t l = 0; l < out_.loop.size(); ++l) {
      const Steps& steps = steps_[l];
      EdgeOverlap::Loop& loop = out_.loop[l];
      loop.count = 0;
      if (steps.count == 0) continue;
      if (steps.from != steps.to || std::popcount(steps.from) != steps.count || steps.count < 3) return false;
      const int first = std::countr_zero(steps.from);
      for (int at = first; loop.count == 0 || at != first; at = steps.next[static_cast<std::size_t>(at)])
        loop.point[static_cast<std::size_t>(loop.count++)] = static_cast<std::uint8_t>(at);
      if (loop.count != steps.count) return false;
    }
    return true;
  }

  /// Whether the mean of all points is so deep in both solids that no axis can separate them, whatever the rounding.
  /// The normal of two edges a millionth off parallel may be wrong by 1e-10. Moves the origin to a point of the shared
  /// solid.
  TRILITH_INLINE bool is_sure() {
    const double size = solid_[0]->solid->size + solid_[1]->solid->size;
    const double enough = 1e-9 * size + 1e-13 * (origin_.cwiseAbs().maxCoeff() + size), n = out_.points;
    for (std::size_t s = 0; s < 2; ++s) {
      Lanes sum{}, rest{};
      for (std::size_t i = 0; i < static_cast<std::size_t>(out_.points); ++i)
        sum += first_half(out_.depth[s][i]), rest += second_half(out_.depth[s][i]);
      if (any(flip(smaller<Lanes>(sum, rest) > n * enough))) return false;
    }
    const Lanes first = out_.arm[0];
    for (std::size_t i = 0; i < static_cast<std::size_t>(out_.points); ++i) out_.arm[i] -= first;
    out_.origin = origin_ + Vec3(first[0], first[1], first[2]);
    return true;
  }

  static constexpr int most_meetings = room_of_faces * room_of_faces;
  std::array<const PlacedSolid*, 2> solid_;
  Vec3 origin_;
  std::array<Planes, 2> planes_;
  EdgeOverlap& out_;
  std::array<std::array<DepthRow, room_of_faces>, 2>
      corner_depth_;  // depths of one solid's corners below the other's faces
  std::array<std::array<unsigned, room_of_faces>, 2> code_;
  std::array<std::array<std::int16_t, room_of_faces>, 2> corner_point_;
  std::array<std::array<Meeting, room_of_faces>, room_of_faces> meeting_;
  std::array<std::array<std::int16_t, 2>, most_meetings> met_;
  std::array<Steps, EdgeOverlap::most_loops> steps_;
  int meetings_ = 0;
  bool closed_ = true;
};

}  // namespace

[[gnu::target_clones("avx2", "default")]] bool edge_overlap(const PlacedSolid& a, const PlacedSolid& b,
                                                            EdgeOverlap& out) {
  return FromEdges(a, b, out).find();
}

}  // namespace trilith
