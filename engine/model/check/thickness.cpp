#include "model/check/thickness.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/plane/polygon.hpp"

namespace trilith {
namespace {

Vec2 start_of(const Model<2>& model, int skin) {
  const int node = model.skin_node[skin];
  return model.start_position[node] + Turn(model.start_rotation[node]).apply(model.skin_place[skin]);
}

/// A surface edge of a body, counter-clockwise.
struct SurfaceEdge {
  int piece;
  Vec2 from, to;
};

std::vector<SurfaceEdge> surface_of(const Model<2>& model, const Body& body) {
  std::vector<SurfaceEdge> edges;
  for (int piece = body.first_piece; piece < body.first_piece + body.pieces; ++piece)
    for (int c = 0, first = model.piece_first[piece], count = model.corners_of(piece); c < count; ++c)
      if (model.edge_is_face[first + c] != 0)
        edges.push_back({piece, start_of(model, model.corner_skin[first + c]),
                         start_of(model, model.corner_skin[first + (c + 1) % count])});
  return edges;
}

/// Distance from the middle of an edge inwards along its normal to the end of the body [m].
double thickness_behind(const SurfaceEdge& edge, const std::vector<SurfaceEdge>& surface) {
  const Vec2 along = (edge.to - edge.from).normalized(), inwards = left_of(along), middle = 0.5 * (edge.from + edge.to);
  double least = unbounded;
  for (const SurfaceEdge& other : surface) {
    // A ray from the middle inwards crosses `other` if its ends are on either side.
    const double from = along.dot(other.from - middle), to = along.dot(other.to - middle);
    if (!(to <= 0 && from >= 0 && from > to)) continue;  // the far side runs in the opposite direction
    const Vec2 at = other.from + from / (from - to) * (other.to - other.from);
    const double distance = inwards.dot(at - middle);
    if (distance > 0) least = std::min(least, distance);
  }
  return least;
}

double width_of(const Model<2>& model, int piece) {
  Polygon outline;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c)
    outline.push_back(start_of(model, model.corner_skin[c]));
  return least_width(outline);
}

/// A body without any contact law limits no step.
bool touches_something(const Model<2>& model, const Body& body) {
  const auto first = model.law_of.begin() + std::ptrdiff_t{body.surface} * model.surfaces;
  return std::any_of(first, first + model.surfaces, [](int law) { return law >= 0; });
}

}  // namespace

/// For a single-piece body the least width. For several pieces, whose cuts are not part of the surface, the least
/// distance from the middle of a surface edge through the body, because a thin piece may have others behind it. It is
/// at least the piece's own width.
void find_thickness(Model<2>& model) {
  model.piece_thickness.assign(static_cast<std::size_t>(model.pieces()), 0);
  model.least_thickness = unbounded;
  for (const Body& body : model.bodies) {
    if (body.pieces > 1)
      for (const std::vector<SurfaceEdge> surface = surface_of(model, body); const SurfaceEdge& edge : surface) {
        double& behind = model.piece_thickness[edge.piece];
        const double here = thickness_behind(edge, surface);
        if (std::isfinite(here)) behind = behind > 0 ? std::min(behind, here) : here;
      }
    for (int piece = body.first_piece; piece < body.first_piece + body.pieces; ++piece) {
      model.piece_thickness[piece] = std::max(model.piece_thickness[piece], width_of(model, piece));
      if (touches_something(model, body))
        model.least_thickness = std::min(model.least_thickness, model.piece_thickness[piece]);
    }
  }
}

}  // namespace trilith
