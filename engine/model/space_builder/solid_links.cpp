// Links between the solids of a builder in space: bearings and seats.
#include <fmt/format.h>

#include <algorithm>

#include "base/nearest.hpp"
#include "geometry/space/face_distance.hpp"
#include "model/builder/extend.hpp"
#include "model/names.hpp"
#include "model/pose.hpp"
#include "model/space_builder/solid_model_builder.hpp"

namespace trilith {
namespace {

/// The piece of a body whose surface faces are nearest to an attached point, given in the axes of its node; for a
/// deformable body the piece whose face carries the point.
int piece_near(const Model<3>& model, int body, const Attachment<3>& attachment) {
  const Vec3& point = attachment.arm[0];
  const Body& b = model.bodies[body];
  if (attachment.node[0] < 0) {
    int piece = b.first_piece;
    while (model.piece_fit[piece] + model.piece_solid[piece].shape.faces.count() < -1 - attachment.node[0]) ++piece;
    return piece;
  }
  int best = b.first_piece;
  double least = unbounded;
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p) {
    const ConvexSolid& solid = model.piece_solid[p];
    if (model.node_of_piece(p) != attachment.node[0]) continue;
    for (int f = 0; f < solid.shape.faces.count(); ++f) {
      if (!solid.is_surface(f)) continue;
      const double distance = face_distance(solid.shape.corners, solid.shape.faces[f], point);
      if (distance < least) least = distance, best = p;
    }
  }
  return best;
}

}  // namespace

int SolidModelBuilder::require_body(const std::string& name, const std::string& owner) const {
  std::vector<std::string> known;
  for (const SolidSpec& b : bodies_) known.push_back(b.name);
  const auto it = std::find(known.begin(), known.end(), name);
  if (it == known.end())
    throw InputError(fmt::format("{}: there is no body '{}'{}", owner, name, name_hint(name, known)));
  return static_cast<int>(it - known.begin());
}

void SolidModelBuilder::require_near(const std::string& body, const Vec3& point, const std::string& owner,
                                     double arm) const {
  double distance = unbounded;
  Vec3 low = Vec3::Constant(unbounded), high = -low;
  const SolidSpec& spec = bodies_[static_cast<std::size_t>(require_body(body, owner))];
  for (const Sphere& s : spec.spheres) {
    const Vec3 radius = Vec3::Constant(s.radius);
    low = low.cwiseMin(s.centre - radius), high = high.cwiseMax(s.centre + radius);
    distance = std::min(distance, std::abs((point - s.centre).norm() - s.radius));
  }
  for (const Polyhedron& piece : spec.pieces) {
    for (const Vec3& x : piece.corners) low = low.cwiseMin(x), high = high.cwiseMax(x);
    for (int f = 0; f < piece.faces.count(); ++f)
      distance = std::min(distance, face_distance(piece.corners, piece.faces[f], point));
  }
  if (arm < 0) return trilith::require_near<3>(point, distance, (high - low).norm(), body, owner);
  require_in_reach<3>(point, distance, (high - low).norm(), arm, body, owner);
}

void SolidModelBuilder::add_bearing(const BearingSpecOf<3>& spec) {
  require_name(spec.name, "bearing");
  require_new(bearings_, spec.name, "bearing", [](const BearingSpecOf<3>& b) { return b.name; });
  const std::string owner = fmt::format("bearing '{}'", spec.name);
  if (require_body(spec.body_a, owner) == require_body(spec.body_b, owner))
    throw InputError(fmt::format("{}: connects body '{}' with itself; name two bodies", owner, spec.body_a));
  check_bearing(spec, owner);
  require_near(spec.body_a, spec.point_a, owner, spec.arm);
  require_near(spec.body_b, spec.point_b, owner, spec.arm);
  add_bearing_plausibility_notes(spec, owner, notes_);
  bearings_.push_back(spec);
}

/// From spec.angle, which rotates world axes to the bearing's axes, each body keeps its own axes.
void SolidModelBuilder::append_bearing(const BearingSpecOf<3>& spec, Model<3>& model) const {
  Bearing<3> b = bearing_of(spec, law_names(), bearings_);
  b.body_a = require_body(spec.body_a, spec.name);
  b.body_b = require_body(spec.body_b, spec.name);
  b.end_a = tie_point(model, b.body_a, spec.point_a);
  b.end_b = tie_point(model, b.body_b, spec.point_b);
  b.angle = inverse(start_of(model, b.end_a.node[0]).rotation) * spec.angle;
  b.rest_angle = inverse(start_of(model, b.end_b.node[0]).rotation) * spec.angle;
  b.rest = turn_of(spec.angle).undo(Vec3(spec.point_b - spec.point_a));
  b.piece_a = piece_near(model, b.body_a, b.end_a);
  b.piece_b = piece_near(model, b.body_b, b.end_b);
  model.bearings.push_back(std::move(b));
}

/// Later bearings and seats are attached to bodies in their present positions; a new bearing is unstressed.
void SolidModelBuilder::append_links(const Model<3>& model, const State<3>& state, Model<3>& grown) const {
  if (bearings_.size() == model.bearings.size() && seats_.size() == model.seats.size()) return;
  Model<3> standing = as_it_stands(grown, state);
  for (std::size_t i = model.bearings.size(); i < bearings_.size(); ++i) append_bearing(bearings_[i], standing);
  for (std::size_t i = model.bearings.size(); i < bearings_.size(); ++i) check_successor(standing.bearings, i);
  for (std::size_t i = model.seats.size(); i < seats_.size(); ++i) append_seat(seats_[i], standing);
  grown.bearings = standing.bearings;
  grown.seats = standing.seats;
}

void SolidModelBuilder::add_seat(const SeatSpecOf<3>& spec) {
  const std::string owner = fmt::format("seat '{}'", spec.name);
  require_name(spec.name, "seat");
  (void)require_body(spec.body, owner), (void)require_body(spec.support, owner);
  if (!spec.end.allFinite() || !spec.edge.allFinite() || !spec.inward.allFinite())
    throw InputError(owner + ": end, edge or inward is not finite");
  require_positive(spec.inward.norm(), owner + ": length of the inward direction", "");
  require_near(spec.body, spec.end, owner);
  require_near(spec.support, spec.edge, owner);
  seats_.push_back(spec);
}

void SolidModelBuilder::append_seat(const SeatSpecOf<3>& spec, Model<3>& model) const {
  Seat<3> seat;
  seat.name = spec.name;
  seat.body = require_body(spec.body, spec.name), seat.support = require_body(spec.support, spec.name);
  seat.end = tie_point(model, seat.body, spec.end), seat.edge = tie_point(model, seat.support, spec.edge);
  seat.inward = turn_of(start_of(model, seat.edge.node[0]).rotation).undo(Vec3(spec.inward.normalized()));
  model.seats.push_back(std::move(seat));
}

}  // namespace trilith
