// Rows of solids whose faces may lie flat, four into the lanes of their kernel (contact/flat_contact.hpp) and out
// again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/lane_vectors.hpp"
#include "contact/flat_contact.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// A face of each of four solids into lanes; corners beyond a face's own repeat its last.
struct FourFacesOfSolids {
  std::array<const PlacedSolid*, lane_count> solid;
  std::array<std::span<const int>, lane_count> loop;
  std::array<int, lane_count> face;

  int load(std::array<Triple<Lanes>, max_face_corners>& corners, Triple<Lanes>& normal) const {
    std::size_t most = 0;
    for (const auto& l : loop) most = std::max(most, l.size());
    const auto corner = [&](std::size_t lane, std::size_t k) -> const Vec3& {
      const std::span<const int> l = loop[lane];
      return solid[lane]->corners[static_cast<std::size_t>(l[k < l.size() ? k : l.size() - 1])];
    };
    const auto normal_of = [&](std::size_t lane) -> const Vec3& {
      return solid[lane]->normals[static_cast<std::size_t>(face[lane])];
    };
    for (std::size_t k = 0; k < most; ++k) corners[k] = four_of(corner(0, k), corner(1, k), corner(2, k), corner(3, k));
    normal = four_of(normal_of(0), normal_of(1), normal_of(2), normal_of(3));
    return static_cast<int>(most);
  }
};

/// How four nodes stand and move.
inline MovingInLanes four_nodes(const State<3>& state, const std::array<int, lane_count>& n) {
  const auto four = [&](const std::vector<Vec3>& v) { return four_of(v[n[0]], v[n[1]], v[n[2]], v[n[3]]); };
  return {four(state.position), four(state.velocity), four(state.spin)};
}

/// What four contacts remember into lanes.
inline void load_memory(const std::array<const SolidMemory*, lane_count>& m, FlatMemory& out) {
  const auto four = [&](const auto& of) { return four_of(of(*m[0]), of(*m[1]), of(*m[2]), of(*m[3])); };
  out.shear.elastic = four([](const SolidMemory& s) -> const Vec3& { return s.shear.elastic; });
  out.shear.total = four([](const SolidMemory& s) -> const Vec3& { return s.shear.total; });
  out.normal = four([](const SolidMemory& s) -> const Vec3& { return s.normal; });
  out.damping = four([](const SolidMemory& s) -> const Vec3& { return s.damping; });
  out.damping_moment = four([](const SolidMemory& s) -> const Vec3& { return s.damping_moment; });
  out.shear.area = Lanes{m[0]->shear.area, m[1]->shear.area, m[2]->shear.area, m[3]->shear.area};
  out.slip = Lanes{m[0]->slip, m[1]->slip, m[2]->slip, m[3]->slip};
}

/// What a lane came to, out of lanes.
inline void store_flat(const FlatResponses& out, int lane, SolidAnswer& answer, SolidMemory& memory) {
  SolidResponse& r = answer.response;
  answer.joint_changed = false;
  r.touching = out.presses[lane] != 0;
  r.face_a = r.face_b = -1;
  r.lost_damping = out.lost_damping[lane], r.lost_friction = out.lost_friction[lane], r.lost_fracture = 0;
  if (!r.touching) {
    memory = {};
    return;
  }
  answer.moment_a = lane_of(out.moment_a, lane), answer.moment_b = lane_of(out.moment_b, lane);
  r.force = lane_of(out.force, lane), r.normal_force = lane_of(out.normal_force, lane);
  r.centre = lane_of(out.centre, lane), r.middle = lane_of(out.middle, lane), r.normal = lane_of(out.normal, lane);
  r.area = out.area[lane], r.depth = out.depth[lane];
  r.radius = out.radius[lane], r.friction_arm = out.friction_arm[lane];
  r.arm = {lane_of(out.arm[0], lane), lane_of(out.arm[1], lane)};
  const FlatMemory& m = out.memory;
  memory.shear = {lane_of(m.shear.elastic, lane), lane_of(m.shear.total, lane), m.shear.area[lane]};
  memory.normal = lane_of(m.normal, lane), memory.damping = lane_of(m.damping, lane);
  memory.damping_moment = lane_of(m.damping_moment, lane);
  memory.slip = m.slip[lane], memory.state = contact_touching | contact_general;
}

}  // namespace trilith
