#include "geometry/plane/convex_parts.hpp"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "geometry/plane/polygon.hpp"

namespace trilith {
namespace {

using Corners = std::vector<int>;

struct Cut {
  int a, b;  ///< indices into the outline
  double length;
};

/// Every piece with a reflex corner is cut there, starting with the whole outline. Then unnecessary cuts are removed
/// (Hertel and Mehlhorn 1983).
///
///       w----------+
///       | `.       |     v is reflex: the cut from v to w makes two pieces.
///       |   `v-----+
///       |    |
///       +----+
///
/// Good cuts leave v without a right turn on either side, and w too if w was reflex. Among equally good cuts the
/// shortest one is used. Both pieces are then treated alike.
class Partition {
 public:
  explicit Partition(std::span<const Vec2> outline) : outline_(outline) {}

  std::vector<Corners> run() {
    Corners whole(outline_.size());
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = static_cast<int>(i);
    std::vector<Corners> open{whole};
    while (!open.empty()) {
      const Corners piece = std::move(open.back());
      open.pop_back();
      const std::size_t v = first_reflex(piece);
      if (v == piece.size()) {
        pieces_.push_back(piece);
        continue;
      }
      const std::size_t w = best_partner(piece, v);
      cuts_.push_back({piece[v], piece[w], distance(piece[v], piece[w])});
      open.push_back(stretch(piece, v, w));
      open.push_back(stretch(piece, w, v));
    }
    join_needless();
    return std::move(pieces_);
  }

 private:
  const Vec2& at(int corner) const { return outline_[static_cast<std::size_t>(corner)]; }
  double distance(int a, int b) const { return (at(a) - at(b)).norm(); }
  bool is_reflex(int before, int corner, int after) const {
    return turn_sine(at(before), at(corner), at(after)) < -kStraightAngle;
  }
  static std::size_t next(const Corners& piece, std::size_t k) { return k + 1 == piece.size() ? 0 : k + 1; }
  static std::size_t previous(const Corners& piece, std::size_t k) { return k == 0 ? piece.size() - 1 : k - 1; }
  bool is_reflex(const Corners& piece, std::size_t k) const {
    return is_reflex(piece[previous(piece, k)], piece[k], piece[next(piece, k)]);
  }

  std::size_t first_reflex(const Corners& piece) const {
    std::size_t k = 0;
    while (k < piece.size() && !is_reflex(piece, k)) ++k;
    return k;
  }

  /// Corners from position `from` around to `to`, both included.
  static Corners stretch(const Corners& piece, std::size_t from, std::size_t to) {
    Corners part{piece[from]};
    for (std::size_t k = from; k != to;) part.push_back(piece[k = next(piece, k)]);
    return part;
  }

  /// True if `target` lies inside the piece's angle at `v`, off both edges. At a reflex corner the angle exceeds 180
  /// degrees, so it is enough to be left of one edge.
  bool in_angle(const Corners& piece, std::size_t v, std::size_t target) const {
    const Vec2 out = at(piece[next(piece, v)]) - at(piece[v]), in = at(piece[previous(piece, v)]) - at(piece[v]);
    const Vec2 ray = at(piece[target]) - at(piece[v]);
    const double least = kStraightAngle * ray.norm();
    const bool left_of_out = cross(out, ray) > least * out.norm(), right_of_in = cross(ray, in) > least * in.norm();
    if (is_reflex(piece, v)) return left_of_out || right_of_in;
    return left_of_out && right_of_in;
  }

  /// True if the segment from v to w runs inside the piece and meets its outline at the two ends alone. Edges that
  /// begin or end at v or w are left to in_angle.
  bool sees(const Corners& piece, std::size_t v, std::size_t w) const {
    if (!in_angle(piece, v, w) || !in_angle(piece, w, v)) return false;
    const Vec2 &a = at(piece[v]), &b = at(piece[w]);
    const double clear = kSamePoint * (b - a).norm();
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::size_t m = next(piece, k);
      if (k == v || k == w || m == v || m == w) continue;
      if (meeting_point(a, b, at(piece[k]), at(piece[m]), clear)) return false;
    }
    return true;
  }

  /// Rank of the cut from reflex corner v to w; lower is better. First criterion: it resolves v; second: it also
  /// resolves a reflex corner w; third: it is short.
  std::tuple<int, int, double, std::size_t> rank(const Corners& piece, std::size_t v, std::size_t w) const {
    return {settles(piece, v, w) ? 0 : 1, is_reflex(piece, w) ? (settles(piece, w, v) ? 0 : 1) : 2,
            distance(piece[v], piece[w]), w};
  }
  bool settles(const Corners& piece, std::size_t v, std::size_t w) const {
    return !is_reflex(piece[previous(piece, v)], piece[v], piece[w]) &&
           !is_reflex(piece[w], piece[v], piece[next(piece, v)]);
  }

  std::size_t best_partner(const Corners& piece, std::size_t v) const {
    std::vector<std::tuple<int, int, double, std::size_t>> ranked;
    for (std::size_t w = 0; w < piece.size(); ++w)
      if (w != v && w != next(piece, v) && w != previous(piece, v)) ranked.push_back(rank(piece, v, w));
    std::sort(ranked.begin(), ranked.end());
    for (const auto& candidate : ranked)
      if (sees(piece, v, std::get<3>(candidate))) return std::get<3>(candidate);
    assert(false && "a right-turning corner of a simple polygon sees another corner");
    return std::get<3>(ranked.front());
  }

  /// Removes each cut whose two pieces form a convex union. Starting with the longest cut leaves rounder pieces.
  void join_needless() {
    std::stable_sort(cuts_.begin(), cuts_.end(), [](const Cut& x, const Cut& y) { return x.length > y.length; });
    for (const Cut& cut : cuts_) {
      const auto [left, k] = piece_with_edge(cut.a, cut.b);
      const auto [right, m] = piece_with_edge(cut.b, cut.a);
      const Corners &p = pieces_[left], &q = pieces_[right];
      // p runs ... x, a, b, y ... and q runs ... z, b, a, u ...
      const int x = p[previous(p, k)], y = p[next(p, next(p, k))];
      const int z = q[previous(q, m)], u = q[next(q, next(q, m))];
      if (is_reflex(x, cut.a, u) || is_reflex(z, cut.b, y)) continue;
      Corners joined = stretch(p, next(p, k), k);
      const Corners other = stretch(q, next(q, m), m);
      joined.insert(joined.end(), other.begin() + 1, other.end() - 1);
      pieces_[left] = joined;
      pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(right));
    }
  }

  std::pair<std::size_t, std::size_t> piece_with_edge(int a, int b) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (std::size_t k = 0; k < pieces_[i].size(); ++k)
        if (pieces_[i][k] == a && pieces_[i][next(pieces_[i], k)] == b) return {i, k};
    assert(false && "every cut borders two pieces");
    return {0, 0};
  }

  std::span<const Vec2> outline_;
  std::vector<Corners> pieces_;
  std::vector<Cut> cuts_;
};

}  // namespace

/// Sorted by corners, so that the order is independent of the search. An edge between neighbouring corners of the
/// outline is surface; any other edge is a cut (-1).
std::vector<ConvexPiece> convex_parts(std::span<const Vec2> outline) {
  std::vector<Corners> parts = Partition(outline).run();
  for (Corners& part : parts) std::rotate(part.begin(), std::min_element(part.begin(), part.end()), part.end());
  std::sort(parts.begin(), parts.end());
  std::vector<ConvexPiece> pieces;
  const int count = static_cast<int>(outline.size());
  for (const Corners& part : parts) {
    ConvexPiece piece{part, {}};
    for (std::size_t k = 0; k < part.size(); ++k) {
      const int to = part[k + 1 == part.size() ? 0 : k + 1];
      piece.faces.push_back(to == (part[k] + 1) % count ? part[k] : -1);
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace trilith
