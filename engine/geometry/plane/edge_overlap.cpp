#include "geometry/plane/edge_overlap.hpp"

#include <bit>

#include "base/simd/lane_bits.hpp"
#include "geometry/plane/shared_points.hpp"

namespace trilith {
namespace {

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

/// Finds the shared solid.
class FromEdges : SharedPoints {
 public:
  /// `record`: receives the topology, or nullptr.
  TRILITH_INLINE FromEdges(const PlacedSolid& a, const PlacedSolid& b, EdgeOverlap& to, OverlapTopology* record)
      : SharedPoints(a, b, to), record_(record) {
    for (auto& ends : meeting_)
      for (auto& of : ends) of = {-1, -1};
  }

  TRILITH_INLINE bool find() {
    if (!take_corners(0) || !take_corners(1)) return false;
    take_edges(0), take_edges(1);
    if (!closed_ || out_.points < 4) return false;
    take_meetings();
    if (!closed_ || !take_loops() || !is_sure()) return false;
    if (record_ != nullptr) keep_record();
    return true;
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
      const auto edge = static_cast<std::size_t>(std::countr_zero(may_enter));
      const SolidEdge& e = edges[edge];
      const EdgePart part(corner_depth_[s][e.from], corner_depth_[s][e.to]);
      if (!(part.from < part.to)) continue;
      if (out_.points + 2 > most_points || meetings_ + 4 > most_meetings) {
        closed_ = false;
        return;
      }
      const int from = end_of(s, e, e.from, part.from, part.enters), to = end_of(s, e, e.to, part.to, part.leaves);
      note_part(s, edge, part, from, to);
      step(e.left + few_faces * s, from, to), step(e.right + few_faces * s, to, from);
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
      step(static_cast<std::size_t>(b + few_faces), of.end, of.start);
    }
  }

  /// Follows each face once around; false where a face does not close.
  TRILITH_INLINE bool take_loops() {
    out_.faces = 0;
    for (std::size_t l = 0; l < out_.loop.size(); ++l) {
      const Steps& steps = steps_[l];
      EdgeOverlap::Loop& loop = out_.loop[l];
      if (steps.count == 0) continue;
      out_.faces |= 1U << l, loop.count = 0;
      if (steps.from != steps.to || std::popcount(steps.from) != steps.count || steps.count < 3) return false;
      const int first = std::countr_zero(steps.from);
      for (int at = first; loop.count == 0 || at != first; at = steps.next[static_cast<std::size_t>(at)])
        loop.point[static_cast<std::size_t>(loop.count++)] = static_cast<std::uint8_t>(at);
      if (loop.count != steps.count) return false;
    }
    return true;
  }

  /// Notes part of an edge, in the order in which they make points.
  TRILITH_INLINE void note_part(std::size_t s, std::size_t edge, const EdgePart& part, int from, int to) {
    if (record_ == nullptr || ++parts_ > OverlapTopology::most_parts) return;
    const SolidEdge& e = solid_[s]->solid->edges[edge];
    const auto byte = [](auto v) { return static_cast<std::uint8_t>(v); };
    record_->part[parts_ - 1] = {{byte(e.from), byte(e.to), byte(e.left), byte(e.right)},
                                 byte(s),
                                 byte(edge),
                                 static_cast<std::int8_t>(part.enters),
                                 static_cast<std::int8_t>(part.leaves),
                                 byte(from),
                                 byte(to)};
  }

  /// Notes the faces on which each point lies: see end_of.
  TRILITH_INLINE void note_faces() {
    record_->on_faces.fill(0);
    const auto bit = [](int s, int face) { return face < 0 ? 0U : 1U << (few_faces * s + face); };
    for (std::size_t k = 0; k < parts_; ++k) {
      const OverlapTopology::Part& part = record_->part[k];
      const int s = part.solid;
      const unsigned own = bit(s, part.joins[2]) | bit(s, part.joins[3]);
      const auto put = [&](std::uint8_t point, int face) {
        record_->on_faces[point] = static_cast<std::uint16_t>(record_->on_faces[point] | own | bit(1 - s, face));
      };
      put(part.from, part.enters), put(part.to, part.leaves);
    }
  }

  /// Completes the record, unless the shared solid has too many parts for it.
  TRILITH_INLINE void keep_record() {
    record_->a = nullptr;
    const auto points = static_cast<std::size_t>(out_.points);
    if (parts_ > OverlapTopology::most_parts || points > OverlapTopology::most_points) return;
    record_->rims = 0;
    for (unsigned left = out_.faces; left != 0; left &= left - 1) {
      const auto l = static_cast<std::size_t>(std::countr_zero(left));
      const EdgeOverlap::Loop& loop = out_.loop[l];
      if (record_->rims == OverlapTopology::most_rims || loop.count > static_cast<int>(OverlapTopology::most_on_rim))
        return;
      OverlapTopology::Rim& rim = record_->rim[record_->rims++];
      rim.loop = static_cast<std::uint8_t>(l), rim.count = static_cast<std::uint8_t>(loop.count);
      __builtin_memcpy(rim.point.data(), loop.point.data(), sizeof rim.point);
    }
    note_faces();
    record_->parts = parts_, record_->points = points;
    record_->a = solid_[0], record_->b = solid_[1];
  }

  static constexpr int most_meetings = few_faces * few_faces;
  OverlapTopology* record_;
  std::size_t parts_ = 0;
  std::array<std::array<DepthRow, few_faces>, 2>
      corner_depth_;  // depths of one solid's corners below the other's faces
  std::array<std::array<unsigned, few_faces>, 2> code_;
  std::array<std::array<std::int16_t, few_faces>, 2> corner_point_;
  std::array<std::array<Meeting, few_faces>, few_faces> meeting_;
  std::array<std::array<std::int16_t, 2>, most_meetings> met_;
  std::array<Steps, EdgeOverlap::most_loops> steps_;
  int meetings_ = 0;
  bool closed_ = true;
};

[[gnu::target_clones("avx2", "default")]] bool overlap_anew(const PlacedSolid& a, const PlacedSolid& b,
                                                            EdgeOverlap& out, OverlapTopology* record) {
  return FromEdges(a, b, out, record).find();
}

}  // namespace

bool edge_overlap(const PlacedSolid& a, const PlacedSolid& b, EdgeOverlap& out, OverlapTopology* known) {
  if (known != nullptr && known->a == &a && known->b == &b && overlap_as_before(a, b, *known, out)) return true;
  if (known != nullptr) known->a = nullptr;
  return overlap_anew(a, b, out, known);
}

}  // namespace trilith
