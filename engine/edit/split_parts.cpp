#include "edit/split_parts.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "base/rotation_3d.hpp"
#include "model/contact/skin_places.hpp"

namespace trilith {
namespace {

template <int D>
std::size_t node_of(const Model<D>& model, int body) {
  return static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node);
}

/// A part has axes of its own in space: rotation from the axes of the body to the axes of the part.
UnitQuaternion axes_between(const Model<3>& model, const SplitBody& split, int part) {
  return inverse(model.start_rotation[node_of(model, part)]) * model.start_rotation[node_of(model, split.body)];
}

/// The face of a solid with this normal whose plane is nearest to a point.
int nearest_face(const ConvexSolid& solid, const Vec3& normal, const Vec3& point) {
  int best = 0;
  double least = unbounded;
  for (int f = 0; f < solid.shape.faces.count(); ++f) {
    const Vec3& own = solid.normals[static_cast<std::size_t>(f)];
    const Vec3& on = solid.shape.corners[static_cast<std::size_t>(solid.shape.faces[f][0])];
    const double apart = std::abs(own.dot(point - on)) + solid.size * (1 - own.dot(normal));
    if (apart < least) least = apart, best = f;
  }
  return best;
}

/// Gives points of the body to its parts; see load/load_kind.hpp.
template <int D>
class SplitParts {
 public:
  SplitParts(const Model<D>& model, const SplitBody& split, const CrackSection<D>& section)
      : model_(model), split_(split), section_(section) {}

  [[nodiscard]] bool is_on(int body) const { return body == split_.body; }
  [[nodiscard]] bool is_behind(int body) const { return body == split_.behind; }
  [[nodiscard]] bool is_on(const Attachment<D>& at) const {
    return at.is_rigid() && static_cast<std::size_t>(at.node[0]) == node_of(model_, split_.body);
  }
  [[nodiscard]] Turn3 axes_of(int part) const requires(D == 3) { return Turn3(axes_between(model_, split_, part)); }
  /// Attaches a point to its part, if it is on the body.
  void give(Attachment<D>& at, int& body) const {
    if (!is_on(at)) return;
    body = part_at(at.arm[0]);
    at = Attachment<D>::to_node(static_cast<int>(node_of(model_, body)), in_part(at.arm[0], body));
  }
  void give(PushRow<D>& row) const {
    if (static_cast<std::size_t>(row.node) != node_of(model_, split_.body)) return;
    const int part = part_at(row.place);
    row.place = in_part(row.place, part);
    row.node = row.turn = static_cast<int>(node_of(model_, part));
  }

  template <class See>
  void for_face(const SplitFace& face, See&& see) const requires(D == 2) {
    const Vec2 a = skin_start(model_, face.skin_a), b = skin_start(model_, face.skin_b);
    const double p = ahead(a - start_of_body()), q = ahead(b - start_of_body());
    const double cut = p * q < 0 ? p / (p - q) : 1;
    const auto give_part = [&](double low, double high) {
      const Vec2 first = a + low * (b - a), last = a + high * (b - a);
      const int part = part_at(0.5 * (first + last) - start_of_body());
      see(SplitFace{part, skin_at(part, first), skin_at(part, last), low, high});
    };
    give_part(0, cut);
    if (cut < 1) give_part(cut, 1);
  }
  template <class See>
  void for_face(const WetFace<3>& face, See&& see) const requires(D == 3) {
    for_polygon(face.corners, [&](int part, int node, const std::vector<Vec3>& corners) {
      WetFace<3> given = face;
      given.body = part, given.at = Attachment<3>::to_node(node, Vec3::Zero());
      given.corners = corners, given.inner.clear();
      set_face(axes_of(part).apply(face.normal), given);
      see(given);
    });
  }
  [[nodiscard]] std::vector<Vec3> corners_of(int face) const requires(D == 3) {
    const Polyhedron& shape = solid_of(split_.body).shape;
    std::vector<Vec3> out;
    for (const int c : shape.faces[face]) out.push_back(shape.corners[static_cast<std::size_t>(c)]);
    return out;
  }
  [[nodiscard]] int face_with(int part, int face, const std::vector<Vec3>& corners) const requires(D == 3) {
    const Vec3& normal = solid_of(split_.body).normals[static_cast<std::size_t>(face)];
    return nearest_face(solid_of(part), axes_of(part).apply(normal), corners.front());
  }
  template <class See>
  void for_polygon(const std::vector<Vec3>& corners, See&& see) const requires(D == 3) {
    for (const int part : {split_.behind, split_.ahead}) {
      const double sign = part == split_.behind ? 1 : -1;
      std::vector<Vec3> kept;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 &x = corners[i], &y = corners[i + 1 < corners.size() ? i + 1 : 0];
        const double p = sign * ahead(x), q = sign * ahead(y);
        if (p <= 0) kept.push_back(in_part(x, part));
        if ((p < 0 && q > 0) || (p > 0 && q < 0)) kept.push_back(in_part(Vec3(x + p / (p - q) * (y - x)), part));
      }
      if (kept.size() > 2) see(part, static_cast<int>(node_of(model_, part)), kept);
    }
  }
  /// A plane divides each face that it meets.
  [[nodiscard]] static bool is_at_crack(const WetFace<D>& /*face*/) { return false; }
  template <class See>
  void for_new_faces(See&& see) const {
    for (const int part : {split_.behind, split_.ahead})
      if constexpr (D == 2) {
        const int from = skin_at(part, start_of_body() + section_.from),
                  to = skin_at(part, start_of_body() + section_.to);
        see(part == split_.behind ? SplitFace{part, from, to} : SplitFace{part, to, from});
      } else {
        see(new_face(part));
      }
  }

 private:
  [[nodiscard]] const Vec<D>& start_of_body() const { return model_.start_position[node_of(model_, split_.body)]; }
  [[nodiscard]] double ahead(const Vec<D>& arm) const { return section_.normal.dot(arm - section_.middle()); }
  /// The part that holds a point given relative to the body's node, in its axes.
  [[nodiscard]] int part_at(const Vec<D>& arm) const { return ahead(arm) <= 0 ? split_.behind : split_.ahead; }
  /// The same point relative to the node of a part, in its axes.
  [[nodiscard]] Vec<D> in_part(const Vec<D>& arm, int part) const {
    const Vec<D> between = model_.start_position[node_of(model_, part)] - start_of_body();
    if constexpr (D == 2) {
      return arm - between;
    } else {
      const Turn3 body(model_.start_rotation[node_of(model_, split_.body)]),
          own(model_.start_rotation[node_of(model_, part)]);
      return own.undo(Vec3(body.apply(arm) - between));
    }
  }
  /// The skin point of a part that was at `place` at the start.
  [[nodiscard]] int skin_at(int part, const Vec2& place) const requires(D == 2) {
    const Body& b = model_.bodies[static_cast<std::size_t>(part)];
    int best = b.first_skin;
    for (int s = b.first_skin; s < b.first_skin + b.outline; ++s)
      if ((skin_start(model_, s) - place).norm() < (skin_start(model_, best) - place).norm()) best = s;
    return best;
  }
  [[nodiscard]] const ConvexSolid& solid_of(int body) const requires(D == 3) {
    return model_.piece_solid[static_cast<std::size_t>(model_.bodies[static_cast<std::size_t>(body)].first_piece)];
  }
  /// Piece and face of a part: the face with this normal, in its axes, whose plane holds the polygon.
  void set_face(const Vec3& normal, WetFace<3>& given) const requires(D == 3) {
    given.piece = model_.bodies[static_cast<std::size_t>(given.body)].first_piece;
    given.face = nearest_face(solid_of(given.body), normal, given.corners.front());
    given.normal = solid_of(given.body).normals[static_cast<std::size_t>(given.face)];
  }
  [[nodiscard]] WetFace<3> new_face(int part) const requires(D == 3) {
    WetFace<3> given;
    given.body = part, given.at = Attachment<3>::to_node(static_cast<int>(node_of(model_, part)), Vec3::Zero());
    const Vec3 out = part == split_.behind ? section_.normal : Vec3(-section_.normal);
    for (const Vec2& p : section_.corners) given.corners.push_back(in_part(section_.at(p), part));
    if (part == split_.ahead) std::reverse(given.corners.begin(), given.corners.end());
    set_face(axes_of(part).apply(out), given);
    return given;
  }

  const Model<D>& model_;
  SplitBody split_;
  CrackSection<D> section_;
};

/// The piece of a part for a bearing that was attached to a piece of the body.
template <int D>
int piece_of(const Model<D>& model, int part) {
  return model.bodies[static_cast<std::size_t>(part)].first_piece;
}

/// The directions of a bearing or a seat are given in the axes of its first body, and the rest of its rotation in the
/// axes of the second. In the plane parts have the axes of their body.
void turn_ends(const Model<2>& /*model*/, const SplitBody& /*split*/, Bearing<2>& /*b*/, bool /*first*/) {}
void turn_ends(const Model<3>& model, const SplitBody& split, Bearing<3>& b, bool first) {
  const UnitQuaternion between = axes_between(model, split, first ? b.body_a : b.body_b);
  if (first)
    b.angle = between * b.angle;
  else
    b.rest_angle = between * b.rest_angle;
}
void turn_seat(const Model<2>& /*model*/, const SplitBody& /*split*/, Seat<2>& /*seat*/) {}
void turn_seat(const Model<3>& model, const SplitBody& split, Seat<3>& seat) {
  seat.inward = Turn3(axes_between(model, split, seat.support)).apply(seat.inward);
}

/// Position of a part's node relative to the body's, in the world, and its rotation.
struct PartPlace {
  Vec2 arm;
  double rotation;
};
struct PartPlace3 {
  Vec3 arm;
  UnitQuaternion rotation;
};
PartPlace place_in_body(const Model<2>& model, const State<2>& state, std::size_t body, std::size_t part) {
  return {Turn(state.rotation[body]).apply(Vec2(model.start_position[part] - model.start_position[body])),
          state.rotation[body]};
}
PartPlace3 place_in_body(const Model<3>& model, const State<3>& state, std::size_t body, std::size_t part) {
  const UnitQuaternion turned = renormalised(state.rotation[body] * inverse(model.start_rotation[body]));
  return {Turn3(turned).apply(Vec3(model.start_position[part] - model.start_position[body])),
          renormalised(turned * model.start_rotation[part])};
}

template <int D>
void give_loads(Model<D>& model, const SplitParts<D>& parts) {
  replace_loads(model, [&](const auto& load, auto& given) { hand_over(load, parts, given); });
}

}  // namespace

/// The parts rotate with the body from its initial position.
template <int D>
void place_parts(const Model<D>& model, State<D>& state, const SplitBody& split) {
  const std::size_t n = node_of(model, split.body);
  for (const int part : {split.behind, split.ahead}) {
    const std::size_t p = node_of(model, part);
    const auto place = place_in_body(model, state, n, p);
    state.position[p] = state.position[n] + place.arm;
    state.rotation[p] = place.rotation;
    state.velocity[p] = state.velocity[n] + cross(state.spin[n], place.arm);
    state.spin[p] = state.spin[n];
    state.resting[static_cast<std::size_t>(part)] = state.resting[static_cast<std::size_t>(split.body)];
    state.moved_at[static_cast<std::size_t>(part)] = state.moved_at[static_cast<std::size_t>(split.body)];
  }
  state.velocity[n].setZero(), state.spin[n] = nothing<Spin<D>>();
  state.removed_at.resize(state.left.size(), never_removed);
  state.left[static_cast<std::size_t>(split.body)] = 1;
  state.removed_at[static_cast<std::size_t>(split.body)] = state.time;
}

template <int D>
void hand_over_links(Model<D>& model, const SplitBody& split, const CrackSection<D>& section) {
  const SplitParts<D> parts(model, split, section);
  for (Bearing<D>& b : model.bearings) {
    if (parts.is_on(b.end_a)) {
      parts.give(b.end_a, b.body_a), b.piece_a = piece_of(model, b.body_a);
      turn_ends(model, split, b, true);
    }
    if (parts.is_on(b.end_b)) {
      parts.give(b.end_b, b.body_b), b.piece_b = piece_of(model, b.body_b);
      turn_ends(model, split, b, false);
    }
  }
  for (Seat<D>& s : model.seats) {
    parts.give(s.end, s.body);
    if (!parts.is_on(s.edge)) continue;
    parts.give(s.edge, s.support);
    turn_seat(model, split, s);
  }
  for (Push<D>& push : model.pushes)
    for (PushRow<D>& row : push.rows) parts.give(row);
  give_loads(model, parts);
  give_field_faces(model, parts);
  const std::size_t n = node_of(model, split.body);
  for (const int part : {split.behind, split.ahead})
    model.load[node_of(model, part)] = model.mass[node_of(model, part)] / model.mass[n] * model.load[n];
}

std::vector<SplitFace> crack_faces(const Model<2>& model, const SplitBody& split, const CrackSection<2>& section) {
  std::vector<SplitFace> out;
  SplitParts<2>(model, split, section).for_new_faces([&](const SplitFace& face) { out.push_back(face); });
  return out;
}

template void place_parts(const Model<2>&, State<2>&, const SplitBody&);
template void place_parts(const Model<3>&, State<3>&, const SplitBody&);
template void hand_over_links(Model<2>&, const SplitBody&, const CrackSection<2>&);
template void hand_over_links(Model<3>&, const SplitBody&, const CrackSection<3>&);

}  // namespace trilith
