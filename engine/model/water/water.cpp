#include "model/water/water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "model/builder/bearing_spec.hpp"
#include "model/contact/skin_places.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Least cosine of the angle between the outward normal of a face and its side.
constexpr double least_cosine = 0.01;
/// Largest gap of two faces of a joint at the start, over their shared length; largest difference of their slopes.
constexpr double joint_reach = 0.01, joint_tilt = 0.02;
/// Two faces of a rigid body lie in one plane within this share of the body's size.
constexpr double one_plane = 1e-7;

std::string owner_of(const char* kind, const std::string& name) {
  return fmt::format("{} '{}'", kind, name);
}

template <int D>
void check_gravity(const Model<D>& model, const std::string& owner) {
  const Vec<D>& g = model.gravity.field;
  const double down = -g[D - 1], across = (g + down * Vec<D>::Unit(D - 1)).norm();
  if (!(down > 0))
    throw InputError(
        fmt::format("{}: the model has no gravity downwards, so water has no pressure; leave out gravity = 0 "
                    "in trilith.model",
                    owner));
  if (across > 1e-9 * down || model.gravity.tilt_rate != nothing<Spin<D>>())
    throw InputError(owner + ": gravity has a horizontal part or rotates; water needs a vertical one");
}

// Joints of two bodies at the start.

/// Two faces that lie on each other: points at the corners of their shared part, and the normal.
template <int D>
struct SharedFaces {
  WetFace<D> upper, lower;
  std::vector<Vec<D>> points;
  Vec<D> normal;
};

/// Positions at the start, in the form of a target of loads.
struct StartPlaces {
  const Model<2>& model;
  [[nodiscard]] Vec2 skin(int i) const { return skin_start(model, i); }
};

bool lie_on(const Model<2>& model, const WetFace<2>& a, const WetFace<2>& b, SharedFaces<2>& out) {
  const JointStretch stretch(StartPlaces{model}, a, b);
  const FaceOverlap<double>& o = stretch.overlap;
  if (!o.sane || o.tilt > joint_tilt || !(o.shared > 1e-6 * (stretch.a1 - stretch.a0).norm())) return false;
  if (std::max(std::abs(o.gap_lo), std::abs(o.gap_hi)) > joint_reach * o.shared) return false;
  out = {a, b, {stretch.point(o.lo), stretch.point(o.hi)}, Vec2(o.dy, -o.dx)};
  return true;
}

/// A face at the start.
PlacedWetFace start_face(const Model<3>& model, const WetFace<3>& face) {
  struct Places {
    const Model<3>& model;
    [[nodiscard]] Vec3 place_of(const Attachment<3>& at) const { return start_of(model, at.node[0]).place; }
    [[nodiscard]] Turn3 turn_of(const Attachment<3>& at) const {
      return trilith::turn_of(start_of(model, at.node[0]).rotation);
    }
  };
  return {Places{model}, face};
}

bool lie_on(const Model<3>& model, const WetFace<3>& a, const WetFace<3>& b, SharedFaces<3>& out) {
  const PlacedWetFace one = start_face(model, a), other = start_face(model, b);
  FaceOverlap3 shared;
  if (one.normal.dot(other.normal) > -1 + joint_tilt * joint_tilt) return false;
  if (!face_overlap({one.polygon.corners(), one.normal}, {other.polygon.corners(), other.normal}, shared)) return false;
  const FaceIntegrals of = integrals_over_all(shared);
  const WetPolygon polygon = polygon_of(shared);
  const LinearField overlap = closed_field(shared);
  if (!(of.area > 0)) return false;
  for (const Vec3& x : polygon.corners())
    if (std::abs(overlap(x)) > joint_reach * std::sqrt(of.area)) return false;
  out = {a, b, {polygon.corners().begin(), polygon.corners().end()}, shared.plane.normal};
  return true;
}

std::vector<WetFace<2>> all_faces(const Model<2>& model, int body) {
  return wet_faces(model, body, outline_faces(model, body));
}
std::vector<WetFace<3>> all_faces(const Model<3>& model, int body) {
  return wet_faces(model, body, surface_faces(model, body));
}

Vec2 middle_of_face(const Model<2>& model, const WetFace<2>& face) {
  return 0.5 * (skin_start(model, face.skin_a) + skin_start(model, face.skin_b));
}
Vec3 middle_of_face(const Model<3>& model, const WetFace<3>& face) {
  const PlacedWetFace placed = start_face(model, face);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : placed.polygon.corners()) sum += x;
  return sum / placed.polygon.count;
}

/// A point on the side where the water enters: the middle of the faces upstream. Faces of the upper body come first.
template <int D>
Vec<D> side_upstream(const Model<D>& model, const UpliftSpec<D>& spec, const Water<D>& water) {
  if (spec.heel) return *spec.heel;
  Vec<D> sum[2] = {Vec<D>::Zero(), Vec<D>::Zero()};
  int count[2] = {0, 0};
  for (const WetFace<D>& face : water.faces) {
    const int own = face.body == spec.upper ? 0 : 1;
    sum[own] += middle_of_face(model, face), ++count[own];
  }
  const int from = count[0] > 0 ? 0 : 1;
  return sum[from] / count[from];
}

Attachment<2> tie_heel(const Model<2>& model, int body, const Vec2& at, const std::string& owner) {
  return tie_point(model, body, at, owner);
}
Attachment<3> tie_heel(const Model<3>& model, int body, const Vec3& at, const std::string& /*owner*/) {
  return tie_point(model, body, at);
}

/// Sets heel and toe: the ends of the joint along the direction from the side upstream.
template <int D>
void set_ends(const Model<D>& model, const UpliftSpec<D>& spec, const Vec<D>& side, const std::vector<Vec<D>>& points,
              const Vec<D>& normal, const std::string& owner, Uplift<D>& out) {
  Vec<D> middle = Vec<D>::Zero();
  for (const Vec<D>& x : points) middle += x / static_cast<double>(points.size());
  Vec<D> along = middle - side;
  along -= along.dot(normal) * normal;
  double low = 0, high = 0;
  if (along.norm() > 0) along.normalize();
  for (const Vec<D>& x : points)
    low = std::min(low, along.dot(x - middle)), high = std::max(high, along.dot(x - middle));
  if (!(high > low))
    throw InputError(owner +
                     ": the side where the water enters does not follow from the water upstream; give heel, a "
                     "point at that end of the joint");
  out.heel = tie_heel(model, spec.lower, middle + low * along, owner);
  out.toe = tie_heel(model, spec.lower, middle + high * along, owner);
  if (spec.drain_at < 0 || spec.drain_at >= high - low)
    throw InputError(
        fmt::format("{}: the drain is {:g} m from the heel, must be above 0 and below the length of the "
                    "joint, {:g} m",
                    owner, spec.drain_at, high - low));
}

template <class T>
void add_once(std::vector<T>& list, const T& face) {
  if (std::none_of(list.begin(), list.end(), [&](const T& f) { return f.key() == face.key(); })) list.push_back(face);
}

template <int D>
const Water<D>& require_water(const Model<D>& model, const std::string& name, const char* key,
                              const std::string& owner) {
  if (const Water<D>* water = find_water(model, name)) return *water;
  throw InputError(
      fmt::format("{}: {} is '{}', and there is no water of that name; declare m:water first", owner, key, name));
}

}  // namespace

std::vector<FacePart> faces_on_side(const Model<2>& model, int body, const Vec2& side) {
  std::vector<FacePart> faces;
  for (const FacePart& f : outline_faces(model, body)) {
    const Vec2 along = skin_start(model, f.skin_b) - skin_start(model, f.skin_a);
    if (-left_of(along).dot(side) > least_cosine * along.norm()) faces.push_back(f);
  }
  return faces;
}

std::vector<SolidFace> faces_on_side(const Model<3>& model, int body, const Vec3& side) {
  std::vector<SolidFace> faces;
  for (const SolidFace& f : surface_faces(model, body)) {
    const Turn3 turn = turn_of(model.start_rotation[model.node_of_piece(f.piece)]);
    if (turn.apply(model.piece_solid[f.piece].normals[f.face]).dot(side) > least_cosine) faces.push_back(f);
  }
  return faces;
}

std::vector<WetFace<2>> wet_faces(const Model<2>& model, int body, const std::vector<FacePart>& faces) {
  std::vector<WetFace<2>> out;
  for (const FacePart& f : faces) out.push_back({body, f.skin_a, f.skin_b, f.from, f.to, depth_of(model, body)});
  return out;
}

namespace {

/// A face of a rigid body with the parts that its other pieces cover. Returns false for a face that is covered
/// entirely.
bool leave_inner(const Model<3>& model, WetFace<3>& out, const BodyMotion& frame) {
  const Body& b = model.bodies[out.body];
  if (!b.is_rigid()) return true;
  const PlacedWetFace own = start_face(model, out);
  double left = 1;
  for (int p = b.first_piece; p < b.first_piece + b.pieces; ++p) {
    const ConvexSolid& other = model.piece_solid[p];
    for (int g = 0; p != out.piece && g < other.shape.faces.count(); ++g) {
      WetPolygon corners;
      const Turn3 turn = turn_of(frame.rotation);
      for (const int c : other.shape.faces[g])
        corners.add(frame.place + turn.apply(other.shape.corners[static_cast<std::size_t>(c)]));
      const Vec3 normal = turn.apply(other.normals[static_cast<std::size_t>(g)]);
      if (normal.dot(own.normal) > -1 + one_plane) continue;
      if (std::abs(own.normal.dot(corners.at(0) - own.polygon.at(0))) > one_plane * other.size) continue;
      FaceOverlap3 shared;
      if (!face_overlap({own.polygon.corners(), own.normal}, {corners.corners(), normal}, shared)) continue;
      PressureSum area, whole;
      area.add(polygon_of(shared).corners(), own.normal, {1, Vec3::Zero()}, 1);
      whole.add(own.polygon.corners(), own.normal, {1, Vec3::Zero()}, 1);
      left -= area.force / whole.force;
      std::vector<Vec3> inner;
      for (const Vec3& x : polygon_of(shared).corners()) inner.push_back(turn.undo(Vec3(x - frame.place)));
      out.inner.push_back(std::move(inner));
    }
  }
  return left > 1e-9;
}

}  // namespace

std::vector<WetFace<3>> wet_faces(const Model<3>& model, int body, const std::vector<SolidFace>& faces) {
  std::vector<WetFace<3>> out;
  for (const SolidFace& f : faces) {
    const ConvexSolid& solid = model.piece_solid[f.piece];
    const int node = model.node_of_piece(f.piece), frame = model.carrier_of(f.piece, f.face);
    const Turn3 piece = turn_of(model.start_rotation[node]);
    const BodyMotion begins = start_of(model, frame);
    const Turn3 start = turn_of(begins.rotation);
    WetFace<3> face;
    face.body = body, face.piece = f.piece, face.face = f.face;
    face.at = Attachment<3>::to_node(frame, Vec3::Zero());
    for (const int c : solid.shape.faces[f.face]) {
      const Vec3 x = model.start_position[node] + piece.apply(solid.shape.corners[static_cast<std::size_t>(c)]);
      face.corners.push_back(start.undo(Vec3(x - begins.place)));
    }
    face.normal = start.undo(piece.apply(solid.normals[static_cast<std::size_t>(f.face)]));
    if (leave_inner(model, face, begins)) out.push_back(std::move(face));
  }
  return out;
}

template <int D>
Water<D> make_water(const Model<D>& model, const WaterSpec& spec, std::vector<WetFace<D>> faces) {
  const std::string owner = owner_of("water", spec.name);
  check_gravity(model, owner);
  require_positive(spec.density, owner + ": density", "kg/m3");
  check_load_curve(spec.level, owner);
  if (faces.empty()) throw InputError(owner + ": no face of its bodies points to the water");
  Water<D> out;
  out.name = spec.name, out.curve = spec.level, out.density = spec.density, out.sealed = spec.sealed;
  out.faces = std::move(faces);
  return out;
}

template <int D>
JointFaces<D> joint_faces(const Model<D>& model, int upper, int lower, const std::string& owner) {
  JointFaces<D> out;
  const std::vector<WetFace<D>> below = all_faces(model, lower);
  for (const WetFace<D>& a : all_faces(model, upper))
    for (const WetFace<D>& b : below) {
      SharedFaces<D> shared;
      if (!lie_on(model, a, b, shared)) continue;
      add_once(out.upper, a), add_once(out.lower, b);
      out.points.insert(out.points.end(), shared.points.begin(), shared.points.end());
      out.normal += shared.normal;
    }
  if (out.points.empty())
    throw InputError(fmt::format("{}: no faces of '{}' and '{}' lie on each other at the start", owner,
                                 model.bodies[upper].name, model.bodies[lower].name));
  return out;
}

template <int D>
Uplift<D> make_uplift(const Model<D>& model, const UpliftSpec<D>& spec) {
  const std::string owner = owner_of("uplift", spec.name);
  const Water<D>& water = require_water(model, spec.upstream, "upstream", owner);
  Uplift<D> out;
  out.name = spec.name, out.upstream = spec.upstream, out.downstream = spec.downstream;
  out.curve = water.curve, out.density = water.density;
  if (!spec.downstream.empty()) out.tail = require_water(model, spec.downstream, "downstream", owner).curve;
  out.full = spec.full, out.drain_at = spec.drain_at, out.drain_efficiency = spec.drain_efficiency;
  if (!(spec.drain_efficiency >= 0 && spec.drain_efficiency <= 1))
    throw InputError(
        fmt::format("{}: the efficiency of the drain is {:g}, must be from 0 to 1", owner, spec.drain_efficiency));
  const JointFaces<D> faces = joint_faces(model, spec.upper, spec.lower, owner);
  out.upper = faces.upper, out.lower = faces.lower;
  set_ends<D>(model, spec, side_upstream(model, spec, water), faces.points, faces.normal.normalized(), owner, out);
  return out;
}

template <int D>
Drag<D> make_drag(const Model<D>& model, int body, const DragSpec<D>& spec) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const std::string owner = fmt::format("drag '{}' on '{}'", spec.name, b.name);
  require_positive(spec.coefficient, owner + ": coefficient", "");
  require_positive(spec.area, owner + ": area", "m2");
  require_positive(spec.density, owner + ": density", "kg/m3");
  check_load_curve(spec.curve, owner);
  if (!spec.flow.allFinite()) throw InputError(owner + ": velocity is not finite");
  if (!spec.at && !b.is_rigid())
    throw InputError(owner + ": the body deforms; give 'at', the point where the drag acts");
  Drag<D> out;
  out.name = spec.name, out.body = body, out.flow = spec.flow, out.coefficient = spec.coefficient;
  out.area = spec.area, out.density = spec.density, out.curve = spec.curve;
  out.at = spec.at ? tie_heel(model, body, *spec.at, owner) : Attachment<D>::to_node(b.first_node, Vec<D>::Zero());
  return out;
}

template <int D>
int change_level(Model<D>& model, const std::string& name, double now, double level, double duration) {
  int count = 0;
  const auto change = [&](LoadCurve& curve) { curve = ramp_curve(now, curve.at(now), level, duration, true); };
  for (Water<D>& water : loads_of<Water<D>>(model))
    if (water.name == name) change(water.curve), ++count;
  for (Uplift<D>& uplift : loads_of<Uplift<D>>(model)) {
    if (uplift.upstream == name) change(uplift.curve);
    if (uplift.downstream == name) change(uplift.tail);
  }
  return count;
}

template <int D>
const Water<D>* find_water(const Model<D>& model, const std::string& name) {
  for (const Water<D>& water : loads_of<Water<D>>(model))
    if (water.name == name) return &water;
  return nullptr;
}

#define TRILITH_WATER(D)                                                                    \
  template Water<D> make_water(const Model<D>&, const WaterSpec&, std::vector<WetFace<D>>); \
  template JointFaces<D> joint_faces(const Model<D>&, int, int, const std::string&);        \
  template Uplift<D> make_uplift(const Model<D>&, const UpliftSpec<D>&);                    \
  template Drag<D> make_drag(const Model<D>&, int, const DragSpec<D>&);                     \
  template int change_level(Model<D>&, const std::string&, double, double, double);         \
  template const Water<D>* find_water(const Model<D>&, const std::string&);
TRILITH_WATER(2)
TRILITH_WATER(3)
#undef TRILITH_WATER

}  // namespace trilith
