#include "model/field/seepage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <variant>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "model/pose.hpp"
#include "model/water/water.hpp"

namespace trilith {
namespace {

/// Nodes of two joints lie at one elevation within this length [m].
constexpr double node_reach = 1e-6;
constexpr int most_cells_of_joint = 100000;

template <int D>
double weight_of_water(const Model<D>& model, double density, const std::string& owner) {
  const Vec<D>& g = model.gravity.field;
  const double down = -g[D - 1], across = (g + down * Vec<D>::Unit(D - 1)).norm();
  if (!(down > 0))
    throw InputError(owner +
                     ": the model has no gravity downwards, so a head "
                     "has no pressure; leave out gravity = 0 in "
                     "trilith.model");
  if (across > 1e-9 * down || model.gravity.tilt_rate != nothing<Spin<D>>())
    throw InputError(owner +
                     ": gravity has a horizontal part or rotates; "
                     "water needs a vertical one");
  return density * down;
}

void check_numbers(const SeepageSpec& spec, const std::string& owner) {
  for (const double a : spec.aperture) require_positive(a, owner + ": aperture", "m");
  for (const double z : spec.elevation)
    if (!std::isfinite(z)) throw InputError(owner + ": an elevation is not finite");
  if (spec.upper < 0) require_positive(spec.length, owner + ": length", "m");
  require_positive(spec.width, owner + ": width", "m");
  require_not_negative(spec.stiffness, owner + ": stiffness", "Pa/m");
  require_positive(spec.density, owner + ": density", "kg/m3");
  require_positive(spec.viscosity, owner + ": viscosity", "Pa s");
  require_positive(spec.bulk_modulus, owner + ": bulk_modulus", "Pa");
  require_not_negative(spec.crack_aperture, owner + ": crack_aperture", "m");
  if (spec.divisions < 1 || spec.divisions > most_cells_of_joint)
    throw InputError(
        fmt::format("{}: divisions is {}, must be from 1 to {}", owner, spec.divisions, most_cells_of_joint));
  if (spec.from == spec.to)
    throw InputError(fmt::format("{}: from and to are both '{}', must be two nodes", owner, spec.from));
}

/// The node of that name, which is added if there is none.
int node_at(JointFlow& flow, const std::string& name, double elevation, const std::string& owner) {
  const int known = flow.find_node(name);
  if (known < 0) {
    flow.nodes.push_back({name, elevation, -1});
    return static_cast<int>(flow.nodes.size()) - 1;
  }
  const double other = flow.nodes[static_cast<std::size_t>(known)].elevation;
  if (std::abs(other - elevation) > node_reach)
    throw InputError(
        fmt::format("{}: its end at node '{}' has the elevation {:g} m, and "
                    "the node lies at {:g} m; choose another "
                    "node, or the same elevation",
                    owner, name, elevation, other));
  return known;
}

/// Stiffness of the contact law between two bodies, 0 without one [Pa/m].
template <int D>
double contact_stiffness(const Model<D>& model, int a, int b) {
  const auto surface = [&](int body) { return model.bodies[static_cast<std::size_t>(body)].surface; };
  const int law = model.law_of[static_cast<std::size_t>(surface(a) * model.surfaces + surface(b))];
  if (law < 0) return 0;
  return std::visit(
      []<class L>(const L& of) {
        if constexpr (requires { of.kn; })
          return static_cast<double>(of.kn);
        else
          return 0.0;
      },
      model.laws[static_cast<std::size_t>(law)]);
}

void set_bodies(const Model<2>& model, const SeepageSpec& spec, const std::string& owner, FlowJoint& out) {
  const JointFaces<2> faces = joint_faces(model, spec.upper, spec.lower, owner);
  const Vec2 along = Vec2(-faces.normal.y(), faces.normal.x()).normalized();
  const auto before = [&](const Vec2& p, const Vec2& q) { return along.dot(p) < along.dot(q); };
  const auto [low, high] = std::minmax_element(faces.points.begin(), faces.points.end(), before);
  Vec2 first = *low, last = *high;
  const bool turn = spec.heel ? (*spec.heel - last).norm() < (*spec.heel - first).norm()
                              : last.x() < first.x() || (last.x() == first.x() && last.y() < first.y());
  if (turn) std::swap(first, last);
  out.length = (last - first).norm(), out.elevation = {first.y(), last.y()};
  out.heel = tie_point(model, spec.lower, first, owner), out.toe = tie_point(model, spec.lower, last, owner);
  for (const WetFace<2>& f : faces.upper) out.upper.push_back({f.body, f.skin_a, f.skin_b, f.depth});
  for (const WetFace<2>& f : faces.lower) out.lower.push_back({f.body, f.skin_a, f.skin_b, f.depth});
  out.width = std::min(out.upper.front().depth, out.lower.front().depth);
  for (auto* list : {&out.upper, &out.lower})
    for (FlowFace& f : *list) f.depth = out.width;
  const double kn = contact_stiffness(model, spec.upper, spec.lower);
  out.coupling = kn > 0 ? 1 / kn : 0;
}

/// Shares of lengths: points of a joint that count as one, and corners that
/// count as right angles.
constexpr double same_corner = 1e-6, right_angle = 1e-6;

/// The corners of a joint in space in their order around it, each once, without
/// points between two others in a line.
std::vector<Vec3> corners_of(const std::vector<Vec3>& points, const Vec3& normal) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  const Vec3 x = (points.front() - middle).normalized(), y = cross(normal, x);
  std::vector<Vec3> around = points;
  const auto angle = [&](const Vec3& p) { return portable::atan2(y.dot(p - middle), x.dot(p - middle)); };
  std::sort(around.begin(), around.end(), [&](const Vec3& p, const Vec3& q) { return angle(p) < angle(q); });
  const double size = 2 * (points.front() - middle).norm();
  std::vector<Vec3> once;
  for (const Vec3& p : around)
    if (once.empty() || (p - once.back()).norm() > same_corner * size) once.push_back(p);
  if (once.size() > 1 && (once.front() - once.back()).norm() <= same_corner * size) once.pop_back();
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < once.size(); ++i) {
    const Vec3 before = once[i] - once[(i + once.size() - 1) % once.size()],
               after = once[(i + 1) % once.size()] - once[i];
    if (cross(before, after).norm() > right_angle * before.norm() * after.norm()) out.push_back(once[i]);
  }
  return out;
}

bool is_rectangle(const std::vector<Vec3>& corner) {
  if (corner.size() != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 a = corner[(i + 1) % 4] - corner[i], b = corner[(i + 2) % 4] - corner[(i + 1) % 4];
    if (std::abs(a.dot(b)) > right_angle * a.norm() * b.norm()) return false;
  }
  return true;
}

/// The side on which a joint begins, from corner i to the next: nearest to the
/// heel, or with the least x, y, z.
std::size_t first_side(const std::vector<Vec3>& corner, const std::optional<Vec3>& heel) {
  const auto middle = [&](std::size_t i) { return Vec3(0.5 * (corner[i] + corner[(i + 1) % 4])); };
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    const Vec3 p = middle(i), q = middle(best);
    const bool before = heel ? (p - *heel).norm() < (q - *heel).norm()
                             : std::tuple(p.x(), p.y(), p.z()) < std::tuple(q.x(), q.y(), q.z());
    if (before) best = i;
  }
  return best;
}

/// Position of a world point at the start, and a world direction, in the axes
/// of a rigid body.
Vec3 in_body(const Model<3>& model, int body, const Vec3& v, bool is_point) {
  const auto n = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].first_node);
  return Turn3(model.start_rotation[n]).undo(is_point ? Vec3(v - model.start_position[n]) : v);
}

void set_bodies(const Model<3>& model, const SeepageSpec& spec, const std::string& owner, FlowJoint& out) {
  for (const int body : {spec.upper, spec.lower})
    if (!model.bodies[static_cast<std::size_t>(body)].is_rigid())
      throw InputError(
          fmt::format("{}: body '{}' deforms; in space seepage between bodies needs rigid "
                      "ones: leave out "
                      "body, or model a section in the plane",
                      owner, model.bodies[static_cast<std::size_t>(body)].name));
  const JointFaces<3> faces = joint_faces(model, spec.upper, spec.lower, owner);
  Vec3 normal = faces.normal.normalized();
  const std::vector<Vec3> corner = corners_of(faces.points, normal);
  if (faces.upper.size() != 1 || faces.lower.size() != 1 || !is_rectangle(corner))
    throw InputError(owner +
                     ": in space the joint must be one rectangle, as between two "
                     "blocks; other joints need a model of a "
                     "section in the plane, or fissures of given length and width");
  const auto upper = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(spec.upper)].first_node);
  if (normal.dot(model.start_position[upper] - corner[0]) < 0) normal = -normal;
  const std::size_t side = first_side(corner, spec.heel_in_space);
  const auto middle = [&](std::size_t i) { return Vec3(0.5 * (corner[i % 4] + corner[(i + 1) % 4])); };
  const Vec3 heel = middle(side), toe = middle(side + 2);
  out.length = (toe - heel).norm(), out.width = (corner[(side + 1) % 4] - corner[side]).norm();
  out.elevation = {heel.z(), toe.z()};
  out.upper = {{spec.upper, -1, -1, out.width}}, out.lower = {{spec.lower, -1, -1, out.width}};
  out.rectangle = {in_body(model, spec.lower, heel, true), in_body(model, spec.lower, toe, true),
                   in_body(model, spec.lower, normal, false), in_body(model, spec.upper, heel, true),
                   in_body(model, spec.upper, normal, false)};
  const double kn = contact_stiffness(model, spec.upper, spec.lower);
  out.coupling = kn > 0 ? 1 / kn : 0;
}

}  // namespace

template <int D>
void add_seepage(Field& field, const Model<D>& model, const SeepageSpec& spec) {
  const std::string owner = fmt::format("seepage '{}'", spec.name);
  check_numbers(spec, owner);
  JointFlow flow = field.flow ? *field.flow : JointFlow{};
  if (flow.find(spec.name) != nullptr)
    throw InputError(owner + ": there is a joint of that name already; choose another name");
  FlowJoint joint;
  joint.name = spec.name, joint.first_cell = flow.cells(), joint.cells = spec.divisions;
  joint.length = spec.length, joint.width = spec.width;
  joint.elevation = spec.elevation, joint.aperture = spec.aperture;
  joint.compliance = spec.stiffness > 0 ? 1 / spec.stiffness : 0;
  joint.density = spec.density, joint.viscosity = spec.viscosity, joint.bulk_modulus = spec.bulk_modulus;
  joint.crack_aperture = spec.crack_aperture;
  joint.weight = weight_of_water(model, spec.density, owner);
  if (spec.upper >= 0) set_bodies(model, spec, owner, joint);
  joint.from = node_at(flow, spec.from, joint.elevation[0], owner);
  joint.to = node_at(flow, spec.to, joint.elevation[1], owner);
  // Values of the cells: all pressure heads, then all volumes.
  const auto old = static_cast<std::size_t>(flow.cells()), more = static_cast<std::size_t>(joint.cells);
  field.start.insert(field.start.begin() + static_cast<std::ptrdiff_t>(old), more, 0.0);
  for (std::size_t i = 0; i < more; ++i)
    field.start.push_back(spec.filled ? joint.width * joint.cell_length() *
                                            joint.aperture_at((static_cast<double>(i) + 0.5) / joint.cells)
                                      : 0);
  field.capacity.assign(field.start.size(), 0);
  field.kind = FieldKind::seepage;
  flow.joints.push_back(std::move(joint));
  field.flow = std::make_shared<const JointFlow>(std::move(flow));
}

template <int D>
void add_seepage_head(Field& field, const Model<D>& model, const std::string& node, const FieldSurrounding& head) {
  const std::string owner = fmt::format("seepage_head '{}'", node);
  JointFlow flow = *field.flow;
  const int at = flow.find_node(node);
  if (at < 0) {
    std::vector<std::string> names;
    for (const FlowNode& n : flow.nodes) names.push_back(n.name);
    throw InputError(fmt::format("{}: there is no node of that name; nodes are {}", owner, fmt::join(names, ", ")));
  }
  FlowNode& here = flow.nodes[static_cast<std::size_t>(at)];
  if (here.surrounding >= 0) {
    field.surroundings[static_cast<std::size_t>(here.surrounding)] = head;
  } else {
    here.surrounding = static_cast<int>(field.surroundings.size());
    field.surroundings.push_back(head);
  }
  if (head.course.value.empty()) {
    if (find_water(model, head.name) == nullptr)
      throw InputError(
          fmt::format("{}: water is '{}', and there is no water "
                      "of that name; declare m:water first",
                      owner, head.name));
  } else {
    check_course(head.course, owner + ": head");
  }
  field.flow = std::make_shared<const JointFlow>(std::move(flow));
}

template <int D>
std::vector<double> seepage_heads(const Field& field, const Model<D>& model, double clock, double time) {
  std::vector<double> out;
  for (const FieldSurrounding& s : field.surroundings) {
    const auto* water = s.course.value.empty() ? find_water(model, s.name) : nullptr;
    if (s.course.value.empty() && water == nullptr)
      throw InputError(fmt::format("seepage: the water '{}', which gives a head, is not there any more", s.name));
    out.push_back(water != nullptr ? water->curve.at(time) : s.course.at(clock));
  }
  return out;
}

#define TRILITH_SEEPAGE(D)                                                                              \
  template void add_seepage(Field&, const Model<D>&, const SeepageSpec&);                               \
  template void add_seepage_head(Field&, const Model<D>&, const std::string&, const FieldSurrounding&); \
  template std::vector<double> seepage_heads(const Field&, const Model<D>&, double, double);
TRILITH_SEEPAGE(2)
TRILITH_SEEPAGE(3)
#undef TRILITH_SEEPAGE

}  // namespace trilith
