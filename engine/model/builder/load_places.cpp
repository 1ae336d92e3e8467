// Positions of loads: named points, faces of a side, parts of an outline.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "model/contact/skin_places.hpp"
#include "model/loads.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

constexpr std::array<std::pair<std::string_view, std::array<int, 2>>, 8> sides{{{"top", {0, 1}},
                                                                                {"bottom", {0, -1}},
                                                                                {"left", {-1, 0}},
                                                                                {"right", {1, 0}},
                                                                                {"top left", {-1, 1}},
                                                                                {"top right", {1, 1}},
                                                                                {"bottom left", {-1, -1}},
                                                                                {"bottom right", {1, -1}}}};

Vec2 middle_of(const Model<2>& model, const std::vector<FacePart>& faces) {
  Vec2 sum = Vec2::Zero();
  double length = 0;
  for (const FacePart& f : faces) {
    const Vec2 a = skin_start(model, f.skin_a), b = skin_start(model, f.skin_b);
    sum += 0.5 * (b - a).norm() * (a + b);
    length += (b - a).norm();
  }
  return sum / length;
}

/// Among equally far corners the first one, regardless of rounding.
Vec2 farthest(const Model<2>& model, int body, const Vec2& way) {
  const Body& b = model.bodies[body];
  Vec2 best = skin_start(model, b.first_skin);
  for (int s = b.first_skin; s < b.first_skin + b.outline; ++s)
    if (way.dot(skin_start(model, s)) > way.dot(best) + 1e-9 * model.body_radius[body]) best = skin_start(model, s);
  return best;
}

/// A point of the outline: its face and its relative position along it.
struct OnOutline {
  std::size_t face = 0;
  double share = 0, distance = unbounded;
};

OnOutline nearest_on(const Model<2>& model, const std::vector<FacePart>& faces, const Vec2& p) {
  OnOutline best;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Vec2 a = skin_start(model, faces[i].skin_a), along = skin_start(model, faces[i].skin_b) - a;
    const double share = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (a + share * along - p).norm();
    if (distance < best.distance) best = {i, share, distance};
  }
  return best;
}

}  // namespace

/// A side is the centre of its faces, a corner the outermost point in both directions.
std::optional<Vec2> named_place(const Model<2>& model, int body, std::string_view name) {
  if (name == "centroid") return body_start(model, body);
  for (const auto& [side, way] : sides) {
    if (side != name) continue;
    const Vec2 v(way[0], way[1]);
    if (way[0] != 0 && way[1] != 0) return farthest(model, body, v);
    const std::vector<FacePart> faces = faces_towards(model, body, v);
    return faces.empty() ? farthest(model, body, v) : middle_of(model, faces);
  }
  return std::nullopt;
}

std::vector<FacePart> outline_faces(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  std::vector<FacePart> faces;
  for (int i = 0; i < b.outline; ++i) faces.push_back({b.first_skin + i, b.first_skin + (i + 1) % b.outline});
  return faces;
}

/// Faces whose outward normal is within 45 degrees of `side`.
std::vector<FacePart> faces_towards(const Model<2>& model, int body, const Vec2& side) {
  const double least = std::sqrt(0.5) - 1e-9;
  std::vector<FacePart> faces;
  for (const FacePart& f : outline_faces(model, body)) {
    const Vec2 along = skin_start(model, f.skin_b) - skin_start(model, f.skin_a);
    if (-left_of(along).dot(side) >= least * along.norm() * side.norm()) faces.push_back(f);
  }
  return faces;
}

std::vector<FacePart> faces_between(const Model<2>& model, int body, const Vec2& from, const Vec2& to,
                                    const std::string& owner) {
  const std::vector<FacePart> faces = outline_faces(model, body);
  const OnOutline first = nearest_on(model, faces, from), last = nearest_on(model, faces, to);
  for (const auto& [point, found] : {std::pair{from, first}, std::pair{to, last}})
    if (found.distance > 0.02 * model.body_radius[body])
      throw InputError(
          fmt::format("{}: the point ({:g}, {:g}) is {:.3g} m away from the outline of '{}'; give points on the "
                      "outline at the start",
                      owner, point.x(), point.y(), found.distance, model.bodies[body].name));
  // Counter-clockwise from `from` to `to`: all the way around if both lie on one face and `to` comes first.
  const bool round = first.face == last.face && first.share >= last.share;
  if (round && first.share == last.share)
    throw InputError(
        fmt::format("{}: 'from' and 'to' are the same point of the outline of '{}'", owner, model.bodies[body].name));
  std::vector<FacePart> parts;
  for (std::size_t i = first.face, done = 0;; i = (i + 1) % faces.size(), ++done) {
    FacePart part = faces[i];
    if (done == 0) part.from = first.share;
    // All the way around, the common face is visited twice: first from `from` on, then up to `to`.
    const bool ends = i == last.face && (done > 0 || !round);
    if (ends) part.to = last.share;
    if (part.to > part.from) parts.push_back(part);
    if (ends) return parts;
  }
}

}  // namespace trilith
