#include "assembly/field/joint_water.hpp"

#include <algorithm>

#include "assembly/load_target.hpp"

namespace trilith {
namespace {

/// Least aperture of a joint between bodies, as a share of the one without
/// load.
constexpr double least_aperture = 0.01;

/// Two faces of a joint with the coordinate s from the heel to the toe.
struct FacingPair {
  JointStretch stretch;
  Vec2 onto_a, onto_b;  // depth times length times normal into the body [m2]
  int a0, a1, b0, b1;   // skin points
  int body_a, body_b;
  double s_lo = 0, s_hi = 0;

  template <class Places>
  FacingPair(const Places& on, const FlowFace& a, const FlowFace& b, const Vec2& heel, const Vec2& along)
      : stretch(on, WetFace<2>{a.body, a.skin_a, a.skin_b}, WetFace<2>{b.body, b.skin_a, b.skin_b}),
        onto_a(a.depth * left_of(Vec2(stretch.a1 - stretch.a0))),
        onto_b(b.depth * left_of(Vec2(stretch.b1 - stretch.b0))),
        a0(a.skin_a),
        a1(a.skin_b),
        b0(b.skin_a),
        b1(b.skin_b),
        body_a(a.body),
        body_b(b.body) {
    s_lo = along.dot(stretch.point(stretch.overlap.lo) - heel);
    s_hi = along.dot(stretch.point(stretch.overlap.hi) - heel);
  }
  [[nodiscard]] bool faces() const { return bool(stretch.overlap.sane) && s_lo != s_hi; }
  [[nodiscard]] double first() const { return std::min(s_lo, s_hi); }
  [[nodiscard]] double last() const { return std::max(s_lo, s_hi); }
  /// Coordinate along the common direction of the faces.
  [[nodiscard]] double along(double s) const {
    return stretch.overlap.lo + (s - s_lo) / (s_hi - s_lo) * stretch.overlap.shared;
  }
  [[nodiscard]] double gap(double s) const { return stretch.gap(along(s)); }
};

/// A joint in its present place. Each loop computes the pairs of faces again,
/// so that a step allocates nothing.
struct PlacedJoint {
  const LoadPlaces<2>& on;
  const FlowJoint& joint;
  Vec2 heel, all;
  double length;

  PlacedJoint(const LoadPlaces<2>& places, const FlowJoint& placed)
      : on(places),
        joint(placed),
        heel(places.place_of(placed.heel)),
        all(places.place_of(placed.toe) - heel),
        length(all.norm()) {}

  /// Calls f(pair) for each pair of faces that overlap.
  template <class F>
  void for_pairs(F&& f) const {
    const auto is_gone = [&](const FlowFace& face) { return on.state.left[static_cast<std::size_t>(face.body)] != 0; };
    for (const FlowFace& a : joint.upper)
      for (const FlowFace& b : joint.lower) {
        if (is_gone(a) || is_gone(b)) continue;
        const FacingPair pair(on, a, b, heel, Vec2(all / length));
        if (pair.faces()) f(pair);
      }
  }
  [[nodiscard]] std::vector<FacingPair> pairs() const {
    std::vector<FacingPair> out;
    for_pairs([&](const FacingPair& pair) { out.push_back(pair); });
    return out;
  }
};

/// The gap at `s`; without overlapping faces there: 0.
double gap_at(const std::vector<FacingPair>& pairs, double s) {
  for (const FacingPair& pair : pairs)
    if (s >= pair.first() && s <= pair.last()) return pair.gap(s);
  return 0;
}

/// Calls f(t0, t1, pressure) for the cells with pressure between two faces, along their common direction.
template <class F>
void for_wet_cells(const PlacedJoint& now, const FacingPair& pair, const FieldValues& water, F&& f) {
  const FlowJoint& joint = now.joint;
  for (int i = 0; i < joint.cells; ++i) {
    const double p = joint.weight * water.at(joint.first_cell + i);
    const double from = std::max(pair.first(), now.length * i / joint.cells);
    const double to = std::min(pair.last(), now.length * (i + 1) / joint.cells);
    if (p <= 0 || !(to > from)) continue;
    const double t = pair.along(from), u = pair.along(to);
    f(std::min(t, u), std::max(t, u), p);
  }
}

/// Presses the cells of a joint onto the skins of the upper and the lower body.
template <class Push>
void press_joint(const LoadPlaces<2>& on, const FlowJoint& joint, const FieldValues& water, bool upper, bool lower,
                 Push&& push) {
  const PlacedJoint now(on, joint);
  now.for_pairs([&](const FacingPair& pair) {
    EndShares on_a, on_b;
    for_wet_cells(now, pair, water, [&](double t0, double t1, double p) {
      on_a += pressed_ends(pair.stretch.on_a(t0), p, pair.stretch.on_a(t1), p);
      on_b += pressed_ends(pair.stretch.on_b(t1), p, pair.stretch.on_b(t0), p);
    });
    if (upper) push(pair.a0, on_a.a * pair.onto_a), push(pair.a1, on_a.b * pair.onto_a);
    if (lower) push(pair.b0, on_b.a * pair.onto_b), push(pair.b1, on_b.b * pair.onto_b);
  });
}

/// True if a body has a face at the joint.
bool has_face(const FlowJoint& joint, int body) {
  const auto has = [&](const FlowFace& face) { return face.body == body; };
  return std::ranges::any_of(joint.upper, has) || std::ranges::any_of(joint.lower, has);
}

/// Adds the pressure `p` between two positions on a face, on the part of it that is behind a plane, if there is one.
void add_behind(const PlaneBehind* plane, const Vec2& a, const Vec2& b, double from, double to, double p,
                EndShares& ends) {
  if (plane != nullptr) {
    const double first = plane->normal.dot(a - plane->point), last = plane->normal.dot(b - plane->point);
    if (first >= 0 && last >= 0) return;
    const double cut = first / (first - last);
    if (first < 0 && last > 0) to = std::min(to, cut);
    if (first > 0 && last < 0) from = std::max(from, cut);
  }
  if (to > from) ends += pressed_ends(from, p, to, p);
}

}  // namespace

JointThrust thrust_on_body(const Model<2>& model, const State<2>& state, int body, const Vec2& about,
                           const PlaneBehind* plane) {
  JointThrust out;
  const LoadPlaces<2> on{model, state};
  const FieldValues water = values_of(model.fields, state.fields, FieldKind::seepage);
  if (!water) return out;
  const auto push = [&](int skin, const Vec2& f) {
    out.force += f, out.moment += cross(Vec2(on.skin(skin) - about), f);
  };
  for (const FlowJoint& joint : water.field().flow->joints) {
    if (!has_face(joint, body)) continue;
    const PlacedJoint now(on, joint);
    now.for_pairs([&](const FacingPair& pair) {
      if (pair.body_a != body && pair.body_b != body) return;
      const JointStretch& at = pair.stretch;
      EndShares on_a, on_b;
      for_wet_cells(now, pair, water, [&](double t0, double t1, double p) {
        if (pair.body_a == body) add_behind(plane, at.a0, at.a1, at.on_a(t0), at.on_a(t1), p, on_a);
        if (pair.body_b == body) add_behind(plane, at.b0, at.b1, at.on_b(t1), at.on_b(t0), p, on_b);
      });
      push(pair.a0, on_a.a * pair.onto_a), push(pair.a1, on_a.b * pair.onto_a);
      push(pair.b0, on_b.a * pair.onto_b), push(pair.b1, on_b.b * pair.onto_b);
    });
  }
  return out;
}

template <int D>
bool has_joint_water(const Model<D>& model) {
  for (const auto& field : model.fields)
    if (field->flow && field->flow->has_bodies()) return true;
  return false;
}
template bool has_joint_water(const Model<2>&);
template bool has_joint_water(const Model<3>&);

Apertures joint_apertures(const JointFlow& flow, const FieldState& state, const Model<2>& model,
                          const State<2>& positions) {
  Apertures out = own_apertures(flow, state);
  const LoadPlaces<2> on{model, positions};
  for (const FlowJoint& joint : flow.joints) {
    if (!joint.has_bodies()) continue;
    const PlacedJoint now(on, joint);
    const std::vector<FacingPair> pairs = now.pairs();
    const double inside = 1e-9 / joint.cells;
    for (int i = 0; i < joint.cells; ++i)
      for (const int end : {0, 1}) {
        const double n = joint.cells, s = (i + end) / n + (end == 0 ? inside : -inside);
        const double own = joint.aperture_at((i + end) / n);
        out[static_cast<std::size_t>(joint.first_cell + i)][static_cast<std::size_t>(end)] =
            std::max(least_aperture * own, own + gap_at(pairs, s * now.length));
      }
  }
  return out;
}

namespace {

/// A joint in space in its present place.
struct PlacedRectangle {
  Vec3 heel, all, normal, face, face_normal;
  std::size_t upper, lower;  // nodes
  bool is_there;

  PlacedRectangle(const FlowJoint& joint, const Model<3>& model, const State<3>& state) {
    const int above = joint.upper.front().body, below = joint.lower.front().body;
    upper = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(above)].first_node);
    lower = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(below)].first_node);
    const Turn3 on_lower(state.rotation[lower]), on_upper(state.rotation[upper]);
    const FlowRectangle& r = joint.rectangle;
    heel = state.position[lower] + on_lower.apply(r.heel);
    all = on_lower.apply(r.toe - r.heel), normal = on_lower.apply(r.normal);
    face = state.position[upper] + on_upper.apply(r.face), face_normal = on_upper.apply(r.face_normal);
    is_there = state.left[static_cast<std::size_t>(above)] == 0 && state.left[static_cast<std::size_t>(below)] == 0;
  }
  [[nodiscard]] Vec3 at(double share) const { return heel + share * all; }
  /// Distance of the faces along the normal; 0 where they do not oppose each
  /// other any more.
  [[nodiscard]] double gap(double share) const {
    const double facing = face_normal.dot(normal);
    return is_there && facing > 0.5 ? face_normal.dot(face - at(share)) / facing : 0;
  }
  /// Calls push(point, force on the upper body) for each cell with pressure.
  template <class Push>
  void press(const FlowJoint& joint, const FieldValues& water, Push&& push) const {
    if (!is_there) return;
    for (int i = 0; i < joint.cells; ++i) {
      const double p = joint.weight * water.at(joint.first_cell + i);
      if (p > 0) push(at((i + 0.5) / joint.cells), Vec3(p * joint.width * joint.cell_length() * normal));
    }
  }
};

}  // namespace

Apertures joint_apertures(const JointFlow& flow, const FieldState& state, const Model<3>& model,
                          const State<3>& positions) {
  Apertures out = own_apertures(flow, state);
  for (const FlowJoint& joint : flow.joints) {
    if (!joint.has_bodies()) continue;
    const PlacedRectangle now(joint, model, positions);
    for (int i = 0; i < joint.cells; ++i)
      for (const int end : {0, 1}) {
        const double share = static_cast<double>(i + end) / joint.cells, own = joint.aperture_at(share);
        out[static_cast<std::size_t>(joint.first_cell + i)][static_cast<std::size_t>(end)] =
            std::max(least_aperture * own, own + now.gap(share));
      }
  }
  return out;
}

void press_joints(const Model<3>& model, const State<3>& state, const Work<3>& /*work*/, std::vector<Vec3>& force,
                  std::vector<Vec3>& moment) {
  const FieldValues water = values_of(model.fields, state.fields, FieldKind::seepage);
  if (!water || !water.field().flow->has_bodies()) return;
  for (const FlowJoint& joint : water.field().flow->joints) {
    if (!joint.has_bodies()) continue;
    const PlacedRectangle now(joint, model, state);
    now.press(joint, water, [&](const Vec3& at, const Vec3& f) {
      force[now.upper] += f, moment[now.upper] += cross(Vec3(at - state.position[now.upper]), f);
      force[now.lower] -= f, moment[now.lower] -= cross(Vec3(at - state.position[now.lower]), f);
    });
  }
}

SpaceThrust thrust_on_upper(const FlowJoint& joint, const Model<3>& model, const State<3>& state) {
  SpaceThrust out;
  const FieldValues water = values_of(model.fields, state.fields, FieldKind::seepage);
  if (joint.has_bodies())
    PlacedRectangle(joint, model, state).press(joint, water, [&](const Vec3& at, const Vec3& f) {
      out.force += f, out.moment += cross(at, f);
    });
  return out;
}

std::array<Vec3, 2> ends_in_space(const FlowJoint& joint, const Model<3>& model, const State<3>& state) {
  const PlacedRectangle now(joint, model, state);
  return {now.heel, now.at(1)};
}

void press_joints(const Model<2>& model, const State<2>& state, const Work<2>& work, std::vector<Vec2>& force,
                  std::vector<double>& moment) {
  const FieldValues water = values_of(model.fields, state.fields, FieldKind::seepage);
  if (!water || !water.field().flow->has_bodies()) return;
  LoadTarget<2> nodes{{model, state, &work}, force, moment};
  for (const FlowJoint& joint : water.field().flow->joints)
    if (joint.has_bodies())
      press_joint(nodes, joint, water, true, true, [&](int skin, const Vec2& f) { nodes.push_skin(skin, f); });
}

std::vector<WaterSpring> water_springs(const Model<2>& model, const State<2>& state) {
  std::vector<WaterSpring> out;
  const FieldValues water = values_of(model.fields, state.fields, FieldKind::seepage);
  if (!water || !water.field().flow->in_motion) return out;
  const LoadPlaces<2> on{model, state};
  for (const FlowJoint& joint : water.field().flow->joints) {
    if (!joint.has_bodies()) continue;
    const double own = std::min(joint.aperture[0], joint.aperture[1]);
    PlacedJoint(on, joint).for_pairs([&](const FacingPair& pair) {
      const double gap = std::min(pair.gap(pair.first()), pair.gap(pair.last()));
      const double least = std::max(least_aperture * own, own + std::min(0.0, gap));
      WaterSpring spring;
      spring.body_a = pair.body_a, spring.body_b = pair.body_b;
      spring.skin = {{{pair.a0, pair.a1}, {pair.b0, pair.b1}}};
      spring.at = pair.stretch.point(pair.along(0.5 * (pair.first() + pair.last())));
      spring.normal = pair.onto_a.normalized(), spring.length = pair.last() - pair.first();
      spring.stiffness = joint.width * joint.bulk_modulus / least;
      out.push_back(spring);
    });
  }
  return out;
}

template <int D>
bool flows_in_motion(const Model<D>& model, bool steps_are_explicit) {
  for (const auto& field : model.fields)
    if (field->flow) return field->flow->in_motion && ((steps_are_explicit && D == 2) || !field->flow->has_bodies());
  return false;
}
template bool flows_in_motion(const Model<2>&, bool);
template bool flows_in_motion(const Model<3>&, bool);

JointThrust thrust_on_upper(const FlowJoint& joint, const Model<2>& model, const State<2>& state) {
  JointThrust out;
  const LoadPlaces<2> on{model, state};
  const FieldValues water = values_of(model.fields, state.fields, FieldKind::seepage);
  if (joint.has_bodies())
    press_joint(on, joint, water, true, false,
                [&](int skin, const Vec2& f) { out.force += f, out.moment += cross(on.skin(skin), f); });
  return out;
}

}  // namespace trilith
