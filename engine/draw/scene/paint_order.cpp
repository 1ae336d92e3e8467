#include "draw/scene/paint_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace trilith::draw {
namespace {

/// Overlaps in the picture below this share of the smaller piece are due to neighbours in contact.
constexpr double grazing = 1e-3;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A piece with the data that determine its order.
struct Silhouette {
  SolidPiece piece;
  std::vector<Vec3> corners;     ///< of all its faces, each once
  std::vector<Vec3> directions;  ///< of its edges, each once
  std::vector<Vec2> outline;     ///< as seen, anticlockwise
  Vec2 low, high;                ///< box around the outline
  double near = -infinite, far = infinite, size = 0;
  bool is_done = false;
};

void add_once(std::vector<Vec3>& to, const Vec3& v, double slack) {
  for (const Vec3& known : to)
    if ((known - v).squaredNorm() <= slack * slack) return;
  to.push_back(v);
}

Silhouette silhouette_of(SolidPiece piece, const ViewAxes& view) {
  Silhouette out;
  out.size = piece_size(piece);
  std::vector<Vec2> flat;
  for (const PieceFace& face : piece.faces)
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      add_once(out.corners, face.corners[i], 1e-9 * out.size);
      const Vec3 along = face.corners[(i + 1) % face.corners.size()] - face.corners[i];
      if (along.norm() <= 1e-9 * out.size) continue;
      const Vec3 unit = along.normalized();
      // One of both senses of an edge is kept.
      const bool turn =
          unit.x() < -1e-9 || (unit.x() < 1e-9 && (unit.y() < -1e-9 || (unit.y() < 1e-9 && unit.z() < 0)));
      add_once(out.directions, turn ? Vec3(-unit) : unit, 1e-6);
    }
  for (const Vec3& p : out.corners) {
    flat.push_back(view.flat(p));
    const double depth = view.toward.dot(p);
    out.near = std::max(out.near, depth);
    out.far = std::min(out.far, depth);
  }
  out.outline = hull_of(flat);
  out.low = out.high = flat[0];
  for (const Vec2& p : flat) out.low = out.low.cwiseMin(p), out.high = out.high.cwiseMax(p);
  out.piece = std::move(piece);
  return out;
}

/// Largest distance of the other outline across one of the sides of `outline`; negative if no side separates them.
double parting(const std::vector<Vec2>& outline, const std::vector<Vec2>& other) {
  double best = -infinite;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
    const Vec2 outward = Vec2(side.y(), -side.x()).normalized();
    double least = infinite;
    for (const Vec2& p : other) least = std::min(least, outward.dot(p - outline[i]));
    best = std::max(best, least);
  }
  return best;
}

bool cover_each_other(const Silhouette& a, const Silhouette& b) {
  const double slack = grazing * std::min(a.size, b.size);
  if ((a.low.array() > b.high.array() - slack).any() || (b.low.array() > a.high.array() - slack).any()) return false;
  return parting(a.outline, b.outline) < -slack && parting(b.outline, a.outline) < -slack;
}

struct Span {
  double low = infinite, high = -infinite;
};

Span span_of(const std::vector<Vec3>& corners, const Vec3& along) {
  Span out;
  for (const Vec3& p : corners) {
    const double d = along.dot(p);
    out.low = std::min(out.low, d), out.high = std::max(out.high, d);
  }
  return out;
}

/// The best separating plane of two pieces among those tried so far: `gap` is negative if they overlap across it. Its
/// normal points from the first to the second.
struct Parting {
  double gap = -infinite;
  CutPlane plane;
  void look(const Silhouette& a, const Silhouette& b, const Vec3& normal) {
    const Span in_a = span_of(a.corners, normal), in_b = span_of(b.corners, normal);
    if (in_b.low - in_a.high > gap) gap = in_b.low - in_a.high, plane = {normal, 0.5 * (in_b.low + in_a.high)};
    if (in_a.low - in_b.high > gap) gap = in_a.low - in_b.high, plane = {-normal, -0.5 * (in_a.low + in_b.high)};
  }
};

/// Convex pieces that do not overlap are separated by a face of one of them or by a plane parallel to two edges, one of
/// each.
Parting parting_plane(const Silhouette& a, const Silhouette& b, const ViewAxes& view) {
  Parting out;
  out.look(a, b, view.toward);
  if (out.gap >= 0) return out;
  const double enough = -1e-6 * std::min(a.size, b.size);
  for (const Silhouette* s : {&a, &b}) {
    for (const PieceFace& face : s->piece.faces) out.look(a, b, face.normal);
    for (const Vec3& normal : s->piece.borders) out.look(a, b, normal);
  }
  if (out.gap >= enough) return out;
  for (const Vec3& u : a.directions)
    for (const Vec3& v : b.directions) {
      const Vec3 normal = cross(u, v);
      if (normal.norm() > 1e-3) out.look(a, b, normal.normalized());
    }
  return out;
}

class Painter {
 public:
  Painter(std::vector<SolidPiece> pieces, const ViewAxes& view) : view_(view) {
    for (SolidPiece& piece : pieces) add(std::move(piece));
    most_cuts_ = 200 + items_.size();
    relate_all();
  }

  std::vector<SolidPiece> order() {
    std::vector<SolidPiece> out;
    for (std::size_t i = 0; i < items_.size(); ++i) offer(i);
    while (left_ > 0) {
      if (ready_.empty() && !break_ring()) offer_farthest();
      while (!ready_.empty()) {
        const std::size_t i = ready_.top().second;
        ready_.pop();
        if (items_[i].is_done || waits_for_[i] > 0) continue;  // a part of a divided piece may lie behind it
        finish(i);
        out.push_back(std::move(items_[i].piece));
      }
    }
    return out;
  }

 private:
  void add(SolidPiece piece) {
    items_.push_back(silhouette_of(std::move(piece), view_));
    behind_.emplace_back();
    before_.emplace_back();
    waits_for_.push_back(0);
    ++left_;
  }

  void relate(std::size_t a, std::size_t b) {
    if (!cover_each_other(items_[a], items_[b])) return;
    const Vec3 normal = parting_plane(items_[a], items_[b], view_).plane.normal;
    const bool b_is_nearer = normal.dot(view_.toward) > 0;
    const std::size_t far = b_is_nearer ? a : b, near = b_is_nearer ? b : a;
    behind_[near].push_back(far);
    before_[far].push_back(near);
    ++waits_for_[near];
  }

  /// Pairs whose boxes meet in the picture, from left to right.
  void relate_all() {
    std::vector<std::size_t> by_left(items_.size()), open;
    std::iota(by_left.begin(), by_left.end(), std::size_t{0});
    std::sort(by_left.begin(), by_left.end(),
              [&](std::size_t a, std::size_t b) { return items_[a].low.x() < items_[b].low.x(); });
    for (const std::size_t i : by_left) {
      std::erase_if(open, [&](std::size_t k) { return items_[k].high.x() < items_[i].low.x(); });
      for (const std::size_t k : open) relate(std::min(i, k), std::max(i, k));
      open.push_back(i);
    }
  }

  /// A piece is ready if no unpainted piece is behind it; the farthest comes first.
  void offer(std::size_t i) {
    if (!items_[i].is_done && waits_for_[i] == 0) ready_.emplace(-items_[i].near - items_[i].far, i);
  }

  void finish(std::size_t i) {
    items_[i].is_done = true;
    --left_;
    for (const std::size_t next : before_[i])
      if (!items_[next].is_done && --waits_for_[next] == 0) offer(next);
  }

  /// A cycle of pieces: each has the next behind it, and the last one the first.
  std::vector<std::size_t> ring() const {
    std::vector<std::size_t> path;
    std::vector<int> place(items_.size(), -1);
    std::size_t at = 0;
    while (items_[at].is_done) ++at;
    while (place[at] < 0) {
      place[at] = static_cast<int>(path.size());
      path.push_back(at);
      at = *std::find_if(behind_[at].begin(), behind_[at].end(), [&](std::size_t k) { return !items_[k].is_done; });
    }
    path.erase(path.begin(), path.begin() + place[at]);
    return path;
  }

  /// Breaks a cycle. If A has B behind it, some other piece of the cycle extends from B's side of the plane between the
  /// two to A's side, otherwise there would be no cycle. That piece is divided by the plane, so that none of its parts
  /// has both.
  bool break_ring() {
    if (cuts_ >= most_cuts_) return false;
    const std::vector<std::size_t> around = ring();
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::size_t a = around[i], b = around[(i + 1) % around.size()];
      const CutPlane plane = parting_plane(items_[a], items_[b], view_).plane;
      for (const std::size_t c : around)
        if (c != a && c != b && divide(c, plane)) return true;
    }
    return false;
  }

  bool divide(std::size_t i, const CutPlane& plane) {
    const Span span = span_of(items_[i].corners, plane.normal);
    const double least = 1e-4 * items_[i].size;
    if (span.low > plane.offset - least || span.high < plane.offset + least) return false;
    auto [below, above] = divided(items_[i].piece, plane, 1e-9 * items_[i].size, FaceKind::border);
    if (!below || !above) return false;
    ++cuts_;
    finish(i);
    for (std::optional<SolidPiece>* part : {&below, &above}) {
      const std::size_t made = items_.size();
      add(std::move(**part));
      for (std::size_t k = 0; k < made; ++k)
        if (!items_[k].is_done) relate(k, made);
    }
    for (std::size_t k = items_.size() - 2; k < items_.size(); ++k) offer(k);
    return true;
  }

  /// Fallback: a wrong edge is better than no picture.
  void offer_farthest() {
    std::size_t farthest = items_.size();
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (!items_[i].is_done && (farthest == items_.size() || items_[i].far < items_[farthest].far)) farthest = i;
    waits_for_[farthest] = 0;
    offer(farthest);
  }

  const ViewAxes& view_;
  std::vector<Silhouette> items_;
  std::vector<std::vector<std::size_t>> behind_, before_;
  std::vector<int> waits_for_;
  std::priority_queue<std::pair<double, std::size_t>> ready_;
  std::size_t left_ = 0, cuts_ = 0, most_cuts_ = 0;
};

}  // namespace

std::vector<Vec2> hull_of(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Vec2> hull;
  for (const int round : {0, 1}) {
    const std::size_t first = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= first + 2 &&
             cross(Vec2(hull.back() - hull[hull.size() - 2]), Vec2(p - hull[hull.size() - 2])) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
    if (round == 0) std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<SolidPiece> paint_order(std::vector<SolidPiece> pieces, const ViewAxes& view) {
  return Painter(std::move(pieces), view).order();
}

}  // namespace trilith::draw
