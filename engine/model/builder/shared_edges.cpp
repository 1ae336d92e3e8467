#include "model/builder/shared_edges.hpp"

#include <algorithm>
#include <span>
#include <tuple>

#include "model/contact/skin_places.hpp"

namespace trilith {
namespace {

/// Sine of the angle up to which a hollow counts as flat.
constexpr double flat_hollow = 0.17;
/// Corners coincide if their distance is within this share of their body's size.
constexpr double same_place = 1e-9;

/// A corner of a piece.
struct PieceCorner {
  int piece, corner;
};

/// A face of a piece's surface: its corners in the piece, and its outward unit normal.
template <int D>
struct SurfaceFace {
  std::vector<int> corner;
  Vec<D> normal;
};

/// Initial positions of one body's corners; coincident corners have one number.
template <int D>
class BodyCorners {
 public:
  BodyCorners(const Model<D>& model, const Body& body) : model_(model) {
    first_ = static_cast<std::size_t>(model.piece_first[body.first_piece]);
    const auto end = static_cast<std::size_t>(model.piece_first[body.first_piece + body.pieces]);
    for (std::size_t c = first_; c < end; ++c) place_.push_back(skin_start(model, model.corner_skin[c]));
    number_all();
  }
  [[nodiscard]] const Vec<D>& place(const PieceCorner& c) const { return place_[row(c)]; }
  [[nodiscard]] int number(const PieceCorner& c) const { return number_[row(c)]; }
  [[nodiscard]] std::vector<SurfaceFace<D>> surface(int piece) const;

 private:
  [[nodiscard]] std::size_t row(const PieceCorner& c) const {
    return static_cast<std::size_t>(model_.piece_first[c.piece] + c.corner) - first_;
  }
  /// Sorted by x; each is compared with its predecessors within the tolerance.
  void number_all() {
    Vec<D> low = place_[0], high = place_[0];
    for (const Vec<D>& x : place_) low = low.cwiseMin(x), high = high.cwiseMax(x);
    const double near = same_place * (high - low).norm();
    std::vector<int> order(place_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return place_[i].x() != place_[j].x() ? place_[i].x() < place_[j].x() : i < j; });
    number_.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const int at = order[k];
      number_[at] = at;
      for (std::size_t j = k; j-- > 0 && place_[at].x() - place_[order[j]].x() <= near;)
        if ((place_[at] - place_[order[j]]).norm() <= near) {
          number_[at] = number_[order[j]];
          break;
        }
    }
  }

  const Model<D>& model_;
  std::size_t first_ = 0;
  std::vector<Vec<D>> place_;
  std::vector<int> number_;
};

template <>
std::vector<SurfaceFace<2>> BodyCorners<2>::surface(int piece) const {
  std::vector<SurfaceFace<2>> faces;
  const int count = model_.corners_of(piece);
  for (int e = 0; e < count; ++e) {
    if (model_.edge_is_face[model_.piece_first[piece] + e] == 0) continue;
    const int next = e + 1 < count ? e + 1 : 0;
    const Vec2 along = place({piece, next}) - place({piece, e});
    faces.push_back({{e, next}, Vec2(along.y(), -along.x()).normalized()});
  }
  return faces;
}

template <>
std::vector<SurfaceFace<3>> BodyCorners<3>::surface(int piece) const {
  const ConvexSolid& solid = model_.piece_solid[piece];
  std::vector<SurfaceFace<3>> faces;
  for (int f = 0; f < solid.shape.faces.count(); ++f) {
    if (!solid.is_surface(f)) continue;
    const std::span<const int> loop = solid.shape.faces[f];
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 2; i < loop.size(); ++i)
      area += cross(Vec3(place({piece, loop[i - 1]}) - place({piece, loop[0]})),
                    Vec3(place({piece, loop[i]}) - place({piece, loop[0]})));
    faces.push_back({{loop.begin(), loop.end()}, area.normalized()});
  }
  return faces;
}

/// A piece with a corner or an edge between the positions with these numbers, and its corners there.
struct Sharing {
  int low, high, piece, from, to;
};

/// Corners and, in space, edges of all pieces of a body, sorted so that coincident ones are adjacent.
template <int D>
std::vector<Sharing> sharing_of(const Model<D>& model, const Body& body, const BodyCorners<D>& corners) {
  std::vector<Sharing> all;
  const auto add = [&](int p, int from, int to) {
    const auto [low, high] = std::minmax({corners.number({p, from}), corners.number({p, to})});
    all.push_back({low, high, p, from, to});
  };
  for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p) {
    for (int c = 0; c < model.corners_of(p); ++c) add(p, c, c);
    if constexpr (D == 3)
      for (const SolidEdge& e : model.piece_solid[p].edges) add(p, e.from, e.to);
  }
  std::sort(all.begin(), all.end(), [](const Sharing& s, const Sharing& t) {
    return std::tie(s.low, s.high, s.piece) < std::tie(t.low, t.high, t.piece);
  });
  return all;
}

/// Whether some surface contains the shared feature, and none of the pieces extends outside of such a face there.
template <int D>
bool stands_out(const Model<D>& model, const BodyCorners<D>& corners,
                const std::vector<std::vector<SurfaceFace<D>>>& surface, int first_piece,
                std::span<const Sharing> sharing) {
  bool any = false;
  for (const Sharing& s : sharing)
    for (const SurfaceFace<D>& face : surface[static_cast<std::size_t>(s.piece - first_piece)]) {
      const auto has = [&](int c) { return std::find(face.corner.begin(), face.corner.end(), c) != face.corner.end(); };
      if (!has(s.from) || !has(s.to)) continue;
      any = true;
      for (const Sharing& t : sharing)
        for (int c = 0; c < model.corners_of(t.piece); ++c) {
          const Vec<D> way = corners.place({t.piece, c}) - corners.place({s.piece, s.from});
          if (face.normal.dot(way) > flat_hollow * way.norm()) return false;
        }
    }
  return any;
}

/// Appends the shared edges of a body: for each the pieces that share it.
template <int D>
void add_ridges(const Model<D>& model, const Body& body, std::vector<std::vector<Sharing>>& ridges) {
  const BodyCorners<D> corners(model, body);
  std::vector<std::vector<SurfaceFace<D>>> surface;
  for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p) surface.push_back(corners.surface(p));
  const std::vector<Sharing> all = sharing_of(model, body, corners);
  for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
    while (end < all.size() && all[end].low == all[first].low && all[end].high == all[first].high) ++end;
    const std::span<const Sharing> sharing(all.data() + first, end - first);
    if (sharing.size() > 1 && stands_out(model, corners, surface, body.first_piece, sharing))
      ridges.emplace_back(sharing.begin(), sharing.end());
  }
}

}  // namespace

template <int D>
SharedEdges shared_edges(const Model<D>& model) {
  std::vector<std::vector<Sharing>> ridges;
  for (const Body& body : model.bodies)
    if (body.pieces > 1) add_ridges(model, body, ridges);
  SharedEdges all;
  if (ridges.empty()) return all;
  all.part_first.assign(static_cast<std::size_t>(model.pieces()) + 1, 0);
  all.piece_first.push_back(0);
  for (const std::vector<Sharing>& sharing : ridges) {
    for (const Sharing& s : sharing) {
      all.piece.push_back(s.piece);
      ++all.part_first[static_cast<std::size_t>(s.piece) + 1];
    }
    all.piece_first.push_back(static_cast<int>(all.piece.size()));
  }
  for (std::size_t p = 1; p < all.part_first.size(); ++p) all.part_first[p] += all.part_first[p - 1];
  std::vector<int> next(all.part_first.begin(), all.part_first.end() - 1);
  all.part.resize(all.piece.size());
  for (std::size_t r = 0; r < ridges.size(); ++r)
    for (const Sharing& s : ridges[r])
      all.part[static_cast<std::size_t>(next[static_cast<std::size_t>(s.piece)]++)] = {static_cast<int>(r), s.from,
                                                                                       s.to};
  return all;
}

template SharedEdges shared_edges(const Model<2>& model);
template SharedEdges shared_edges(const Model<3>& model);

}  // namespace trilith
