// Invented results in space: boxes that fly and rotate at constant rates, so that their positions are functions of
// time.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/rotation_3d.hpp"
#include "geometry/space/polyhedron.hpp"
#include "results/file/writer.hpp"

namespace trilith::testing {

/// A box with its faces along its own axes. It moves with `velocity` [m/s] and rotates with `spin` [rad/s] from the
/// time `begin` [s] on.
struct FlyingBox {
  Vec3 half;  ///< half of its edges [m]
  Vec3 start = Vec3::Zero();
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
  std::string group = "stones", support = "free";
  UnitQuaternion rotation = {};
  double begin = 0;

  [[nodiscard]] Vec3 place(double time) const { return start + std::max(time - begin, 0.0) * velocity; }
  [[nodiscard]] UnitQuaternion turn(double time) const {
    return rotation_by(std::max(time - begin, 0.0) * spin) * rotation;
  }
};

/// A fixed slab, and three stones above it, of which the first (body 1, 0.4 m x 0.2 m x 0.1 m) rotates about an oblique
/// axis.
inline std::vector<FlyingBox> tumbling_boxes() {
  return {{{1, 0.8, 0.1}, {0, 0, -0.1}, Vec3::Zero(), Vec3::Zero(), "slab", "fixed"},
          {{0.2, 0.1, 0.05}, {-0.4, 0, 0.5}, {0.1, 0.2, 0.3}, {1, 2, -1.5}},
          {{0.2, 0.1, 0.05}, {0.3, 0.1, 0.05}, Vec3::Zero(), Vec3::Zero()},
          {{0.2, 0.1, 0.05}, {0.3, -0.3, 0.4}, {0, 0, 0.5}, {3, 0, 0}, "upper stones"}};
}

inline std::vector<double> numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

inline void add_box(results::Header& header, const FlyingBox& box) {
  const Polyhedron solid = box_solid(-box.half, box.half);
  std::vector<double> corners;
  for (const Vec3& c : solid.corners) corners.insert(corners.end(), {c.x(), c.y(), c.z()});
  const Vec3 square = 4 * box.half.cwiseProduct(box.half);
  const double mass = 8 * 2000 * box.half.prod();
  const Vec3 inertia = mass / 12 * Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
  const UnitQuaternion q = box.turn(0);
  header.add_solid_body({fmt::format("stone {}", header.bodies.size()), "rigid", "limestone", box.group, box.support},
                        numbers(box.start), std::vector<double>{q.w, q.x, q.y, q.z}, mass, numbers(inertia), corners,
                        solid.faces);
}

/// One contact: of the last body on the first, with a normal that points down.
inline results::ContactForce sample_contact(int last) {
  results::ContactForce contact{{0.3, 0.1, 0}, {5, 0, 80}, last, 0, results::ContactState::sticking};
  contact.area = 0.08;
  contact.normal[2] = -1;
  return contact;
}

/// Writes `frames` frames of the boxes at an interval of `interval` [s], with velocities, one contact and, if
/// requested, one bearing between the first two bodies.
inline void record_boxes(const std::filesystem::path& path, const std::vector<FlyingBox>& boxes, int frames,
                         double interval, bool with_bearing = true) {
  results::Header header;
  header.dim = 3;
  header.with_velocity = true;
  for (const FlyingBox& box : boxes) add_box(header, box);
  if (with_bearing) header.bearings = {{"cable", 0, 1, {0, 0, 0.1}, {0, 0, -0.05}, "linear"}};
  header.energy_terms = {{"kinetic", "J", "kinetic energy"}};
  results::ResultsWriter writer(path, header, {false});
  writer.begin_stage("fall", "dynamic", 0);
  const std::vector<results::ContactForce> contacts{sample_contact(static_cast<int>(boxes.size()) - 1)};
  std::vector<results::BearingState> state;
  std::vector<double> force, displacement;
  if (with_bearing) state = {results::BearingState::yielded}, force = {1, 2, 3}, displacement = {0.1, 0.2, 0.3};
  for (int i = 0; i < frames; ++i) {
    const double time = i * interval;
    std::vector<double> position, rotation, velocity, spin;
    const auto append = [](std::vector<double>& to, const Vec3& v) { to.insert(to.end(), {v.x(), v.y(), v.z()}); };
    for (const FlyingBox& box : boxes) {
      const UnitQuaternion q = box.turn(time);
      append(position, box.place(time));
      rotation.insert(rotation.end(), {q.w, q.x, q.y, q.z});
      append(velocity, time >= box.begin ? box.velocity : Vec3::Zero());
      append(spin, time >= box.begin ? box.spin : Vec3::Zero());
    }
    writer.append_frame({time, i, 0, position, rotation, velocity, spin, contacts, state, force, displacement});
    writer.append_energy(time, std::vector<double>{1.0 * i}, 0);
  }
  writer.end_stage((frames - 1) * interval, "over");
  writer.finish();
}

}  // namespace trilith::testing
