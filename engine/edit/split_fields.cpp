#include "edit/split_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "assembly/load_target.hpp"
#include "law/contact/list.hpp"
#include "model/field/heat.hpp"
#include "model/loads.hpp"

namespace trilith {
namespace {

/// The values of a field, or an empty row that is written nowhere.
template <int D>
FieldState* values_in(State<D>& state, int row) {
  const auto at = static_cast<std::size_t>(row);
  return at < state.fields.size() ? &state.fields[at] : nullptr;
}

}  // namespace

template <int D>
void split_heat(Model<D>& model, State<D>& state, const SplitBody& split, const std::vector<int>& source) {
  const int row = row_of(model.fields, FieldKind::heat);
  if (row < 0) return;
  Field field = *model.fields[static_cast<std::size_t>(row)];
  FieldState none, *const values = values_in(state, row);
  divide_heat(field, model, split.body, {split.behind, split.ahead}, source, values != nullptr ? *values : none);
  set_field(model.fields, std::move(field));
}
template void split_heat(Model<2>&, State<2>&, const SplitBody&, const std::vector<int>&);
template void split_heat(Model<3>&, State<3>&, const SplitBody&, const std::vector<int>&);

namespace {

/// An end of a crack: the skin points of both parts there, and its place [m].
struct CrackEnd {
  std::array<int, 2> skin;
  Vec2 place;

  [[nodiscard]] bool is_at(const FlowFace& face) const {
    return std::any_of(skin.begin(), skin.end(), [&](int s) { return s == face.skin_a || s == face.skin_b; });
  }
  [[nodiscard]] bool is_at(const std::vector<FlowFace>& faces) const {
    return std::any_of(faces.begin(), faces.end(), [&](const FlowFace& f) { return is_at(f); });
  }
};

/// A point on a face of a body, at the share `t` of its length [1].
Attachment<2> on_face(const Model<2>& model, const FlowFace& face, double t) {
  const auto node = [&](int skin) { return model.skin_node[static_cast<std::size_t>(skin)]; };
  const auto arm = [&](int skin) -> const Vec2& { return model.skin_place[static_cast<std::size_t>(skin)]; };
  if (node(face.skin_a) == node(face.skin_b))
    return Attachment<2>::to_node(node(face.skin_a), arm(face.skin_a) + t * (arm(face.skin_b) - arm(face.skin_a)));
  Attachment<2> out;
  out.nodes = 2;
  for (const std::size_t k : {0, 1}) {
    const int skin = k == 0 ? face.skin_a : face.skin_b;
    out.node[k] = node(skin), out.turn[k] = model.skin_turn[static_cast<std::size_t>(skin)];
    out.weight[k] = k == 0 ? 1 - t : t, out.arm[k] = arm(skin);
  }
  return out;
}

/// The joints of a model at the crack of a body.
class CrackedJoints {
 public:
  CrackedJoints(const Model<2>& model, const State<2>& state, JointFlow& flow)
      : model_(model), on_{model, state}, flow_(flow) {}

  [[nodiscard]] Vec2 skin(int s) const { return on_.skin(s); }
  [[nodiscard]] Vec2 place_of(const Attachment<2>& at) const { return on_.place_of(at); }

  /// The joint with seepage that an end of the crack meets; -1: none.
  [[nodiscard]] int joint_at(const CrackEnd& end) const {
    int best = -1;
    double least = 0;
    for (std::size_t i = 0; i < flow_.joints.size(); ++i) {
      const FlowJoint& j = flow_.joints[i];
      if (!j.has_bodies() || (!end.is_at(j.upper) && !end.is_at(j.lower))) continue;
      const double s = share_of(j, end), beyond = std::abs(s - std::clamp(s, 0.0, 1.0)) * j.length;
      if (best < 0 || beyond < least) best = static_cast<int>(i), least = beyond;
    }
    return best;
  }
  /// The node of a joint at the border of its cells nearest to the crack. A node within the joint is new, and divides
  /// it.
  int node_at(int row, const CrackEnd& end, const std::string& name) {
    const FlowJoint whole = flow_.joints[static_cast<std::size_t>(row)];
    const int border = std::clamp(static_cast<int>(std::lround(share_of(whole, end) * whole.cells)), 0, whole.cells);
    if (border == 0) return whole.from;
    if (border == whole.cells) return whole.to;
    const double share = static_cast<double>(border) / whole.cells;
    FlowJoint first = whole, second = whole;
    first.cells = border, second.cells = whole.cells - border;
    second.first_cell += border;
    first.length = share * whole.length, second.length = whole.length - first.length;
    first.elevation[1] = second.elevation[0] = whole.elevation_at(share);
    first.aperture[1] = second.aperture[0] = whole.aperture_at(share);
    first.toe = second.heel = on_lower(whole, share);
    first.to = second.from = static_cast<int>(flow_.nodes.size());
    flow_.nodes.push_back({name, whole.elevation_at(share), -1});
    flow_.joints[static_cast<std::size_t>(row)] = std::move(first);
    flow_.joints.insert(flow_.joints.begin() + row + 1, std::move(second));
    return static_cast<int>(flow_.nodes.size()) - 1;
  }

 private:
  /// Present position of the crack along a joint [1].
  [[nodiscard]] double share_of(const FlowJoint& j, const CrackEnd& end) const {
    const Vec2 heel = place_of(j.heel), all = place_of(j.toe) - heel;
    return all.dot(end.place - heel) / all.squaredNorm();
  }
  /// A point of a joint on the nearest face of its lower bodies.
  [[nodiscard]] Attachment<2> on_lower(const FlowJoint& j, double share) const {
    const Vec2 heel = place_of(j.heel), x = heel + share * (place_of(j.toe) - heel);
    const FlowFace* best = nullptr;
    double least = 0, at = 0;
    for (const FlowFace& face : j.lower) {
      const Vec2 a = skin(face.skin_a), all = skin(face.skin_b) - a;
      const double t = std::clamp(all.dot(x - a) / all.squaredNorm(), 0.0, 1.0), apart = (a + t * all - x).norm();
      if (best == nullptr || apart < least) best = &face, least = apart, at = t;
    }
    return on_face(model_, *best, at);
  }

  const Model<2>& model_;
  LoadPlaces<2> on_;
  JointFlow& flow_;
};

/// True if a water at rest acts on the faces of a crack.
bool is_filled_at_rest(const Model<2>& model, const SplitFace& face) {
  bool found = false;
  model.loads.for_each_kind([&]<class L>(const std::vector<L>& loads) {
    if constexpr (requires(const L& load) { load.faces.front().skin_a; })
      for (const L& load : loads)
        for (const auto& wet : load.faces) found = found || (wet.body == face.body && wet.skin_a == face.skin_a);
  });
  return found;
}

/// A node that is open to the air.
int open_node(Field& field, JointFlow& flow, const std::string& name, double elevation) {
  flow.nodes.push_back({name, elevation, static_cast<int>(field.surroundings.size())});
  field.surroundings.push_back({name, {{}, {elevation}, 0, 0}});
  return static_cast<int>(flow.nodes.size()) - 1;
}

std::vector<FlowFace> every_second(const std::vector<SplitFace>& faces, std::size_t first, double depth) {
  std::vector<FlowFace> out;
  for (std::size_t i = first; i < faces.size(); i += 2)
    out.push_back({faces[i].body, faces[i].skin_a, faces[i].skin_b, depth});
  return out;
}

/// Adds cells without water at the end of all pressure heads, and of all volumes.
void add_dry_cells(std::vector<double>& values, int old, int more) {
  values.insert(values.begin() + old, static_cast<std::size_t>(more), 0.0);
  values.insert(values.end(), static_cast<std::size_t>(more), 0.0);
}

}  // namespace

void split_seepage(Model<2>& model, State<2>& state, const SplitBody& split, const std::vector<SplitFace>& faces,
                   const ContactLaw& law) {
  const int row = row_of(model.fields, FieldKind::seepage);
  if (row < 0 || faces.empty() || is_filled_at_rest(model, faces.front())) return;
  Field field = *model.fields[static_cast<std::size_t>(row)];
  JointFlow flow = *field.flow;
  CrackedJoints joints(model, state, flow);
  const std::size_t last = faces.size() - 2;
  const auto end_at = [&](int behind, int ahead) { return CrackEnd{{behind, ahead}, joints.skin(behind)}; };
  const std::array ends{end_at(faces[0].skin_a, faces[1].skin_b), end_at(faces[last].skin_b, faces[last + 1].skin_a)};
  const std::array met{joints.joint_at(ends[0]), joints.joint_at(ends[1])};
  if (met[0] < 0 && met[1] < 0) return;
  const std::size_t known = met[0] >= 0 ? 0 : 1;
  FlowJoint crack = flow.joints[static_cast<std::size_t>(met[known])];
  const double cell = crack.cell_length();
  crack.name = model.bodies[static_cast<std::size_t>(split.body)].name + " crack";
  if (!(crack.crack_aperture > 0)) crack.crack_aperture = 0.5 * (crack.aperture[0] + crack.aperture[1]);
  crack.aperture = {crack.crack_aperture, crack.crack_aperture};
  crack.length = (ends[1].place - ends[0].place).norm(), crack.first_cell = flow.cells();
  crack.cells = std::max(1, static_cast<int>(std::lround(crack.length / cell)));
  crack.lower = every_second(faces, 0, crack.width), crack.upper = every_second(faces, 1, crack.width);
  crack.heel = on_face(model, crack.lower.front(), 0), crack.toe = on_face(model, crack.lower.back(), 1);
  const double kn = with_kernel({law}, [](const auto& kernel) { return kernel.kn; });
  crack.coupling = kn > 0 ? 1 / kn : 0;
  const double rise = ends[1].place.y() - ends[0].place.y();
  std::array<int, 2> node{-1, -1};
  for (const std::size_t k : {known, 1 - known}) {
    const std::string name = crack.name + (k == 0 ? ".from" : ".to");
    const int at = joints.joint_at(ends[k]);  // a joint that the other end has divided has two rows
    if (at >= 0)
      node[k] = joints.node_at(at, ends[k], name);
    else
      node[k] = open_node(field, flow, name,
                          flow.nodes[static_cast<std::size_t>(node[1 - k])].elevation + (k == 1 ? rise : -rise));
    crack.elevation[k] = flow.nodes[static_cast<std::size_t>(node[k])].elevation;
  }
  crack.from = node[0], crack.to = node[1];
  const int old = crack.first_cell, more = crack.cells;
  flow.joints.push_back(std::move(crack));
  FieldState* const values = values_in(state, row);
  if (values != nullptr && !values->value.empty()) add_dry_cells(values->value, old, more);
  add_dry_cells(field.start, old, more);
  field.capacity.assign(field.start.size(), 0);
  field.flow = std::make_shared<const JointFlow>(std::move(flow));
  set_field(model.fields, std::move(field));
}

}  // namespace trilith
