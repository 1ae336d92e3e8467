#include "draw/results/results_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/portable.hpp"
#include "base/rotation_3d.hpp"
#include "draw/results/crack_mark.hpp"
#include "results/file/placement.hpp"
#include "results/reading/frame_values.hpp"

namespace trilith::draw {

using results::BodyRow;
using results::Frame;
using results::Header;

namespace {

/// Values of a field of the frame, or InputError.
const std::vector<double>& recorded_values(const Header& header, const Frame& frame, std::string_view name) {
  if (const auto* values = results::values_of(header, frame, name)) return *values;
  throw InputError(fmt::format("the results have no '{}'; they were recorded without joints", name));
}

bool is_in(const BodyRow& body, std::string_view group) {
  return (" " + body.groups + " ").find(fmt::format(" {} ", group)) != std::string::npos;
}

Vec2 start_place(const Header& header, int vertex) {
  const int n = header.vertex_node[vertex];
  const Vec2 node(header.node_position[2 * n], header.node_position[2 * n + 1]);
  return node + Turn(header.node_rotation[n]).apply(Vec2(header.vertices[2 * vertex], header.vertices[2 * vertex + 1]));
}

/// Present position of a point of the body's outline: it keeps its relative position on its edge.
Vec2 follow(const Header& header, const BodyRow& body, const std::vector<Vec2>& outline, const Vec2& point) {
  const int count = body.vertex_count;
  double nearest = std::numeric_limits<double>::infinity();
  Vec2 now = point;
  for (int i = 0; i < count; ++i) {
    const int j = (i + 1) % count;
    const Vec2 p = start_place(header, body.first_vertex + i), q = start_place(header, body.first_vertex + j);
    const Vec2 edge = q - p;
    const double share = std::clamp(edge.dot(point - p) / edge.squaredNorm(), 0.0, 1.0);
    const double far = (p + share * edge - point).norm();
    if (far >= nearest) continue;
    nearest = far;
    now = (1 - share) * outline[i] + share * outline[j];
  }
  return now;
}

double pick(std::string_view name, double xx, double yy, double xy) {
  const double mean = 0.5 * (xx + yy), radius = portable::hypot(0.5 * (xx - yy), xy);
  if (name == "major") return mean + radius;
  if (name == "minor") return mean - radius;
  return name == "xx" ? xx : name == "yy" ? yy : xy;
}

/// In space multiplies each node's rotation from the start by the factor, about its axis.
void magnify_turns(const Header& header, Frame& frame, double factor) {
  for (int n = 0; n < static_cast<int>(header.node_count()); ++n) {
    const UnitQuaternion start = results::quaternion_of(header.node_rotation, n);
    const Vec3 turn = angle_of(results::quaternion_of(frame.rotation, n) * inverse(start));
    const UnitQuaternion more = rotation_by(factor * turn) * start;
    std::copy_n(std::array{more.w, more.x, more.y, more.z}.begin(), 4, frame.rotation.begin() + 4 * n);
  }
}

/// The body outside of the chain with the largest force on its end, whatever lies on it, or -1: the body that the end
/// springs from.
int springer(const Frame& frame, const std::vector<int>& chain, int end) {
  std::map<int, Vec2> pressed;
  for (const results::ContactForce& c : frame.contacts) {
    if (c.body_a != end && c.body_b != end) continue;
    const int other = c.body_a == end ? c.body_b : c.body_a;
    if (std::find(chain.begin(), chain.end(), other) == chain.end())
      pressed.try_emplace(other, Vec2::Zero()).first->second += Vec2(c.force[0], c.force[1]);
  }
  const auto smaller = [](const auto& a, const auto& b) { return a.second.squaredNorm() < b.second.squaredNorm(); };
  const auto hardest = std::max_element(pressed.begin(), pressed.end(), smaller);
  return hardest == pressed.end() ? -1 : hardest->first;
}

}  // namespace

const std::vector<std::string>& stress_names() {
  static const std::vector<std::string> names{"minor", "major", "xx", "yy", "xy", "zz", "yz", "zx"};
  return names;
}

std::string stress_label(std::string_view name, int dim) {
  if (name == "major") return dim == 2 ? "larger principal stress" : "largest principal stress";
  if (name == "minor") return dim == 2 ? "smaller principal stress" : "smallest principal stress";
  return fmt::format("stress {}", name);
}

void magnify(const Header& header, Frame& frame, double factor) {
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    frame.position[i] = header.node_position[i] + factor * (frame.position[i] - header.node_position[i]);
  frame.contacts.clear();
  if (header.dim == 3) return magnify_turns(header, frame, factor);
  for (std::size_t i = 0; i < frame.rotation.size(); ++i)
    frame.rotation[i] = header.node_rotation[i] + factor * (frame.rotation[i] - header.node_rotation[i]);
}

void colour_by_stress(const Header& header, const Frame& frame, std::string_view name, Scene& scene) {
  const auto& names = stress_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(fmt::format("there is no stress '{}'{}", name, name_hint(name, names)));
  if (name.find('z') != std::string_view::npos)
    throw InputError(fmt::format("a model in the plane has no stress '{}'; use minor, major, xx, yy or xy", name));
  const std::vector<double>& stress = recorded_values(header, frame, "body_stress");
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].role == BodyRole::free)
      scene.bodies[i].value = pick(name, stress[3 * i], stress[3 * i + 1], stress[3 * i + 2]);
  scene.value_label = stress_label(name, 2);
  scene.value_unit = "Pa";
}

/// Adds the joints that have lost part of their bonds, and dry ones that are open or have slid, at the present position
/// of their ends on the first body. A joint with an opening above its length is ignored.
void add_cracks(const Header& header, const Frame& frame, const std::vector<bool>& left_out, Scene& scene) {
  const std::vector<double>&damage = recorded_values(header, frame, "joint_damage"),
        &opening = recorded_values(header, frame, "joint_opening"),
        &slip = recorded_values(header, frame, "joint_slip");
  for (std::size_t j = 0; j < header.joints.size(); ++j) {
    const results::JointRow& joint = header.joints[j];
    const bool dry = joint.bonded == 0;
    if (dry ? !(std::max(opening[j], std::abs(slip[j])) > least_crack) : !(damage[j] > 0)) continue;
    if (left_out[joint.body_a] || left_out[joint.body_b]) continue;
    const auto end = [&](const double* at) {
      return follow(header, header.bodies[joint.body_a], scene.bodies[joint.body_a].outline, {at[0], at[1]});
    };
    const double length = portable::hypot(joint.end_1[0] - joint.end_0[0], joint.end_1[1] - joint.end_0[1]);
    if (std::max(opening[j], std::abs(slip[j])) > length) continue;  // the two are no longer neighbours
    scene.cracks.push_back({end(joint.end_0), end(joint.end_1), crack_mark(opening[j], slip[j])});
  }
}

/// From springing to springing, along the bodies of the group in their order: the force-weighted mean of the contact
/// points between neighbours. The line is interrupted between neighbours without contact.
void add_thrust_line(const Header& header, const Frame& frame, std::string_view group, Scene& scene) {
  std::vector<int> chain;
  for (std::size_t i = 0; i < header.bodies.size(); ++i)
    if (is_in(header.bodies[i], group)) chain.push_back(static_cast<int>(i));
  if (chain.empty()) throw InputError(fmt::format("no body is in the group '{}'", group));
  const int first = springer(frame, chain, chain.front()), last = springer(frame, chain, chain.back());
  if (first >= 0) chain.insert(chain.begin(), first);
  if (last >= 0) chain.push_back(last);
  scene.lines.emplace_back();
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    Vec2 point = Vec2::Zero();
    double weight = 0;
    for (const results::ContactForce& c : frame.contacts) {
      if (std::minmax(c.body_a, c.body_b) != std::minmax(chain[i], chain[i + 1])) continue;
      const double size = portable::hypot(c.force[0], c.force[1]);
      point += size * Vec2(c.point[0], c.point[1]);
      weight += size;
    }
    if (weight > 0)
      scene.lines.back().push_back(point / weight);
    else if (!scene.lines.back().empty())
      scene.lines.emplace_back();
  }
  scene.line_label = "line of thrust";
}

}  // namespace trilith::draw
