#include "draw/results/results_colours.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "draw/results/field_colours.hpp"
#include "draw/results/results_findings.hpp"
#include "draw/results/results_picture.hpp"
#include "results/file/placement.hpp"
#include "results/reading/frame_values.hpp"

namespace trilith::draw {

using results::Frame;
using results::Header;
using results::ResultsReader;

namespace {

/// Length of a row of positions or velocities of the first node of a body, from `from` if given.
double length_of_row(const Header& header, std::size_t body, const std::vector<double>& rows,
                     const std::vector<double>* from) {
  double square = 0;
  for (int k = 0; k < header.dim; ++k) {
    const auto at = static_cast<std::size_t>(header.dim * header.bodies[body].first_node + k);
    const double part = rows[at] - (from != nullptr ? (*from)[at] : 0);
    square += part * part;
  }
  return std::sqrt(square);
}

/// Mean damage of the bonded joints of each body.
std::vector<double> damages(const ResultsReader& reader, const Frame& frame) {
  const Header& header = reader.header();
  const std::vector<double>* const lost = results::values_of(header, frame, "joint_damage");
  const bool bonded = std::ranges::any_of(header.joints, [](const results::JointRow& j) { return j.bonded != 0; });
  if (lost == nullptr || !bonded)
    throw InputError(fmt::format("'{}' has no bonded joints, so there is no damage to show", reader.path().string()));
  std::vector<double> sum(header.bodies.size()), count(header.bodies.size());
  for (std::size_t j = 0; j < header.joints.size(); ++j)
    if (header.joints[j].bonded != 0)
      for (const int body : {header.joints[j].body_a, header.joints[j].body_b})
        sum[static_cast<std::size_t>(body)] += (*lost)[j], ++count[static_cast<std::size_t>(body)];
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (count[i] > 0) sum[i] /= count[i];
  return sum;
}

/// Largest mean pressure of one of the contacts of each body [Pa].
std::vector<double> pressures(const ResultsReader& reader, const Frame& frame) {
  const Header& header = reader.header();
  if (header.dim == 2)
    throw InputError(
        fmt::format("'{}' is of a model in the plane, whose contacts have no area; colour it by --stress minor",
                    reader.path().string()));
  std::vector<double> most(header.bodies.size());
  for (const results::ContactForce& c : frame.contacts) {
    if (!(c.area > 0)) continue;
    const Vec3 force(c.force[0], c.force[1], c.force[2]), normal(c.normal[0], c.normal[1], c.normal[2]);
    const double pressure = (normal.norm() > 0 ? std::abs(force.dot(normal)) : force.norm()) / c.area;
    for (const int body : {c.body_a, c.body_b})
      most[static_cast<std::size_t>(body)] = std::max(most[static_cast<std::size_t>(body)], pressure);
  }
  return most;
}

double sphere_volume(double radius) {
  return 4 * M_PI / 3 * radius * radius * radius;
}

/// Volume of a body in space [m3], from its outer faces and spheres.
double volume_of(const Header& header, const results::BodyRow& body, const results::Placement& at) {
  double volume = 0;
  for (int f = body.first_face; f < body.first_face + body.face_count; ++f) {
    const auto corner = [&](int k) { return at.vertex(header.face_vertex[static_cast<std::size_t>(k)]); };
    const int first = header.face_first[static_cast<std::size_t>(f)],
              end = header.face_first[static_cast<std::size_t>(f) + 1];
    for (int k = first + 1; k + 1 < end; ++k) volume += corner(first).dot(cross(corner(k), corner(k + 1))) / 6;
  }
  for (std::size_t s = 0; s < header.sphere_vertex.size(); ++s)
    if (header.sphere_vertex[s] >= body.first_vertex && header.sphere_vertex[s] < body.first_vertex + body.vertex_count)
      volume += sphere_volume(header.sphere_radius[s]);
  return volume;
}

/// Mean stress of each body from its contact forces [Pa], tension above 0.
std::vector<Eigen::Matrix3d> stresses_of_contacts(const Header& header, const Frame& frame) {
  const results::Placement at(header, frame);
  std::vector<Eigen::Matrix3d> out(header.bodies.size(), Eigen::Matrix3d::Zero());
  for (const results::ContactForce& c : frame.contacts) {
    const Vec3 point(c.point[0], c.point[1], c.point[2]), force(c.force[0], c.force[1], c.force[2]);
    for (const auto& [body, sign] : {std::pair(c.body_a, 1.0), {c.body_b, -1.0}}) {
      const auto b = static_cast<std::size_t>(body);
      const Vec3 arm = point - at.node(header.bodies[b].first_node);
      out[b] += 0.5 * sign * (arm * force.transpose() + force * arm.transpose());
    }
  }
  for (std::size_t b = 0; b < out.size(); ++b) {
    const double volume = volume_of(header, header.bodies[b], at);
    out[b] = volume > 0 ? Eigen::Matrix3d(out[b] / volume) : Eigen::Matrix3d(Eigen::Matrix3d::Zero());
  }
  return out;
}

double component(const Eigen::Matrix3d& stress, std::string_view name) {
  static constexpr std::array<std::string_view, 6> names{"xx", "yy", "zz", "xy", "yz", "zx"};
  static constexpr std::array<std::array<int, 2>, 6> places{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return stress(places[i][0], places[i][1]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> found(stress, Eigen::EigenvaluesOnly);
  return found.eigenvalues()[name == "minor" ? 0 : 2];
}

}  // namespace

const std::vector<std::string>& colour_names() {
  static const std::vector<std::string> names{"group",    "displacement", "speed", "damage",
                                              "pressure", "temperature",  "water"};
  return names;
}

void colour_bodies(const ResultsReader& reader, const Frame& frame, const std::string& by, Scene& scene) {
  const Header& header = reader.header();
  if (std::find(colour_names().begin(), colour_names().end(), by) == colour_names().end())
    throw InputError(fmt::format("bodies cannot be coloured by '{}'{}", by, name_hint(by, colour_names())));
  if (by == "group") return;
  if (by == "temperature") return colour_by_temperature(reader, frame, scene);
  if (by == "water") return colour_by_water(reader, frame, scene);
  if (by == "speed" && !header.with_velocity)
    throw InputError(
        fmt::format("'{}' has no velocities; record them with m:results{{velocities = true}}", reader.path().string()));
  std::vector<double> values(scene.bodies.size());
  if (by == "damage")
    values = damages(reader, frame);
  else if (by == "pressure")
    values = pressures(reader, frame);
  else
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = by == "speed" ? length_of_row(header, i, frame.velocity, nullptr)
                                : length_of_row(header, i, frame.position, &header.node_position);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].role == BodyRole::free) scene.bodies[i].value = values[i];
  scene.value_label = by == "damage" ? "damage: mean lost share of bonds" : by == "pressure" ? "contact pressure" : by;
  scene.value_unit = by == "speed" ? "m/s" : by == "displacement" ? "m" : by == "pressure" ? "Pa" : "1";
}

void colour_by_space_stress(const Header& header, const Frame& frame, std::string_view name, Scene& scene) {
  const auto& names = stress_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(fmt::format("there is no stress '{}'{}", name, name_hint(name, names)));
  const std::vector<double>* const recorded = results::values_of(header, frame, "body_stress_tensor");
  const std::vector<Eigen::Matrix3d> contacts = stresses_of_contacts(header, frame);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].role != BodyRole::free) continue;
    Eigen::Matrix3d stress = contacts[i];
    if (recorded != nullptr && header.bodies[i].node_count > 1) {
      const double* const s = recorded->data() + 6 * i;
      stress << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    }
    scene.bodies[i].value = component(stress, name);
  }
  scene.value_label = stress_label(name, 3);
  scene.value_unit = "Pa";
}

}  // namespace trilith::draw
