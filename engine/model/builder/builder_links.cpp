// Links between a builder's bodies: bearings, seats, and contacts between names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/nearest.hpp"
#include "geometry/plane/overlap.hpp"
#include "model/builder/builder.hpp"
#include "model/names.hpp"
#include "model/plausible_ranges.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// The piece of a body whose surface faces are nearest to a point at the start.
int piece_at(const Model<2>& model, int body, const Vec2& point) {
  const Body& b = model.bodies[body];
  int best = b.first_piece;
  double least = unbounded;
  for (int piece = b.first_piece; piece < b.first_piece + b.pieces; ++piece)
    for (int c = 0, count = model.corners_of(piece), first = model.piece_first[piece]; c < count; ++c) {
      if (model.edge_is_face[first + c] == 0) continue;
      const auto place = [&](int corner) {
        const int skin = model.corner_skin[first + corner % count];
        return Vec2(model.start_position[model.skin_node[skin]] + model.skin_place[skin]);
      };
      const std::array face{place(c), place(c + 1)};
      const double distance = boundary_point(face, point).distance;
      if (distance < least) least = distance, best = piece;
    }
  return best;
}

}  // namespace

void ModelBuilder::add_bearing(const BearingSpec& spec) {
  require_name(spec.name, "bearing");
  require_new(bearings_, spec.name, "bearing", [](const BearingSpec& b) { return b.name; });
  const std::string owner = fmt::format("bearing '{}'", spec.name);
  if (require_body(spec.body_a, owner) == require_body(spec.body_b, owner))
    throw InputError(fmt::format("{}: connects body '{}' with itself; name two bodies", owner, spec.body_a));
  check_bearing(spec, owner);
  require_near(spec.body_a, spec.point_a, owner, spec.arm);
  require_near(spec.body_b, spec.point_b, owner, spec.arm);
  add_bearing_plausibility_notes(spec, owner, notes_);
  bearings_.push_back(spec);
}

/// A point far from its body is probably an input error.
void ModelBuilder::require_near(const std::string& body, const Vec2& point, const std::string& what, double arm) const {
  const Polygon& outline = bodies_[require_body(body, what)].outline;
  const double distance = boundary_point(outline, point).distance, size = polygon_size(outline);
  if (arm < 0) return trilith::require_near<2>(point, distance, size, body, what);
  require_in_reach<2>(point, distance, size, arm, body, what);
}

void ModelBuilder::add_seat(const SeatSpec& spec) {
  const std::string owner = fmt::format("seat '{}'", spec.name);
  require_name(spec.name, "seat");
  require_body(spec.body, owner);
  require_body(spec.support, owner);
  for (const double v : {spec.end.x(), spec.end.y(), spec.edge.x(), spec.edge.y()})
    require_finite(v, owner + ": end or edge");
  require_positive(spec.inward.norm(), owner + ": length of the inward direction", "");
  require_near(spec.body, spec.end, owner);
  require_near(spec.support, spec.edge, owner);
  seats_.push_back(spec);
}

/// Both ends are attached to the nodes of their bodies. The laws' displacement starts at the initial displacement in
/// the axes of the bearing.
void ModelBuilder::append_bearing(const BearingSpec& spec, Model<2>& model) const {
  Bearing<2> b = bearing_of(spec, law_names(), bearings_);
  b.body_a = require_body(spec.body_a, spec.name);
  b.body_b = require_body(spec.body_b, spec.name);
  const std::string owner = fmt::format("bearing '{}'", spec.name);
  b.end_a = tie_point(model, b.body_a, spec.point_a, owner);
  b.end_b = tie_point(model, b.body_b, spec.point_b, owner);
  const bool deforms = !b.end_a.is_rigid() || !b.end_b.is_rigid();
  const State<2> start = deforms ? initial_state(model) : State<2>{};
  b.rest = Turn(spec.angle)
               .undo(deforms ? Vec2(pose_at(model, start, b.end_b).place - pose_at(model, start, b.end_a).place)
                             : Vec2(spec.point_b - spec.point_a));
  b.piece_a = piece_at(model, b.body_a, spec.point_a);
  b.piece_b = piece_at(model, b.body_b, spec.point_b);
  model.bearings.push_back(std::move(b));
}

void ModelBuilder::append_seat(const SeatSpec& spec, Model<2>& model) const {
  Seat<2> seat;
  seat.name = spec.name;
  seat.body = require_body(spec.body, spec.name);
  seat.support = require_body(spec.support, spec.name);
  const std::string owner = fmt::format("seat '{}'", spec.name);
  seat.end = tie_point(model, seat.body, spec.end, owner);
  seat.edge = tie_point(model, seat.support, spec.edge, owner);
  seat.inward = spec.inward.normalized();
  model.seats.push_back(std::move(seat));
}

}  // namespace trilith
