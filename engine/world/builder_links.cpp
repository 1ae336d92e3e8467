// Bearings, seats, and contacts between names: what a builder's bodies have to do with each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/nearest.hpp"
#include "shape/overlap.hpp"
#include "world/builder.hpp"
#include "world/names.hpp"
#include "world/pose.hpp"
#include "world/usual.hpp"

namespace trilith {
namespace {

/// The piece of a body whose surface faces come nearest to a point at the start.
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
    throw InputError(fmt::format("{}: links body '{}' to itself; name two bodies", owner, spec.body_a));
  for (const double v : {spec.point_a.x(), spec.point_a.y(), spec.point_b.x(), spec.point_b.y(), spec.angle})
    require_finite(v, owner + ": point or angle");
  for (const double limit : spec.limit)
    if (!(limit > 0)) throw InputError(fmt::format("{}: limit displacement is {:g}, must be above 0", owner, limit));
  for (const DirectionLaw& law : spec.law)
    std::visit(
        [](const auto& l) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(l)>, std::monostate>) check_parameters(l);
          if constexpr (requires { l.check(); }) l.check();
        },
        law);
  check_links(spec, owner);
  for (const DirectionLaw& law : spec.law)
    std::visit(
        [&](const auto& l) {
          if constexpr (Declared<std::decay_t<decltype(l)>>) add_doubts(notes_, owner, l);
        },
        law);
  bearings_.push_back(spec);
}

/// Whether a bearing does anything, and is where its bodies are.
void ModelBuilder::check_links(const BearingSpec& spec, const std::string& owner) const {
  const auto is_none = [](const DirectionLaw& law) { return std::holds_alternative<std::monostate>(law); };
  if (std::all_of(spec.law.begin(), spec.law.end(), is_none))
    throw InputError(
        fmt::format("{}: has no law, so it carries nothing; give along, axial or turning a law such as "
                    "trilith.linear{{...}}",
                    owner));
  const std::string& next = spec.contact_after.empty() ? spec.becomes_bearing : spec.contact_after;
  const auto is_endless = [](double limit) { return limit == unbounded; };
  if (!next.empty() && std::all_of(spec.limit.begin(), spec.limit.end(), is_endless))
    throw InputError(fmt::format(
        "{}: becomes '{}' at its limit, but has none; give limit = {{ along = }}, axial or turning", owner, next));
  require_near(spec.body_a, spec.point_a, owner);
  require_near(spec.body_b, spec.point_b, owner);
}

/// A point that is farther from a body than the body is large was meant for another place.
void ModelBuilder::require_near(const std::string& body, const Vec2& point, const std::string& what) const {
  const Polygon& outline = bodies_[require_body(body, what)].outline;
  const double size = polygon_size(outline), distance = boundary_point(outline, point).distance;
  if (distance <= size) return;
  throw InputError(
      fmt::format("{}: its point ({:g}, {:g}) is {:.3g} m away from body '{}', which is {:.3g} m large; give "
                  "a point in it or near it, in m",
                  what, point.x(), point.y(), distance, body, size));
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

void ModelBuilder::append_bearing(const BearingSpec& spec, Model<2>& model) const {
  Bearing<2> b;
  b.name = spec.name;
  b.body_a = require_body(spec.body_a, spec.name);
  b.body_b = require_body(spec.body_b, spec.name);
  const std::string owner = fmt::format("bearing '{}'", spec.name);
  b.end_a = tie_point(model, b.body_a, spec.point_a, owner);
  b.end_b = tie_point(model, b.body_b, spec.point_b, owner);
  b.angle = spec.angle;
  b.law = spec.law;
  b.limit = spec.limit;
  const bool deforms = !b.end_a.is_rigid() || !b.end_b.is_rigid();
  const State<2> start = deforms ? initial_state(model) : State<2>{};
  b.rest = Turn(spec.angle)
               .undo(deforms ? Vec2(pose_at(model, start, b.end_b).place - pose_at(model, start, b.end_a).place)
                             : Vec2(spec.point_b - spec.point_a));
  b.replaces_contact = spec.replaces_contact;
  b.starts_waiting = spec.starts_waiting;
  if (!spec.contact_after.empty()) {
    const std::vector<std::string> known = law_names();
    const auto it = std::find(known.begin(), known.end(), spec.contact_after);
    if (it == known.end())
      throw InputError(fmt::format("bearing '{}': becomes contact law '{}', which is not there{}", spec.name,
                                   spec.contact_after, name_hint(spec.contact_after, known)));
    b.contact_after = static_cast<int>(it - known.begin());
  }
  b.piece_a = piece_at(model, b.body_a, spec.point_a);
  b.piece_b = piece_at(model, b.body_b, spec.point_b);
  if (!spec.becomes_bearing.empty()) {
    std::vector<std::string> known;
    for (const BearingSpec& other : bearings_) known.push_back(other.name);
    const auto it = std::find(known.begin(), known.end(), spec.becomes_bearing);
    if (it == known.end())
      throw InputError(fmt::format("bearing '{}': becomes bearing '{}', which is not there{}", spec.name,
                                   spec.becomes_bearing, name_hint(spec.becomes_bearing, known)));
    b.becomes_bearing = static_cast<int>(it - known.begin());
  }
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
