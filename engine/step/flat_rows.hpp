// Rows of solids whose faces may lie flat, four into the lanes of their kernel (contact/flat_contact.hpp) and out
// again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lane_vectors.hpp"
#include "contact/flat_contact.hpp"
#include "contact/solid_faces.hpp"
#include "world/state.hpp"
#include "world/work.hpp"

namespace trilith {

/// One of each of four placed solids' corners or normals.
using FourOf = std::array<const Vec3*, lane_count>;

TRILITH_INLINE Triple<Lanes> four_at(const FourOf& of) {
  return four_of(*of[0], *of[1], *of[2], *of[3]);
}

/// Faces of few corners, of each of four solids, into lanes. Returns the most corners of any.
TRILITH_INLINE int load_few(const FourOf& first, const std::array<const std::uint8_t*, lane_count>& corner,
                            std::array<Triple<Lanes>, max_face_corners>& corners) {
  bool four = false;
  for (std::size_t k = 0; k < few_corners; ++k) {
    FourOf at;
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = first[i] + corner[i][k];
    corners[k] = four_at(at);
  }
  for (const std::uint8_t* c : corner) four = four || c[few_corners - 1] != c[few_corners - 2];
  return four ? few_corners : few_corners - 1;
}

/// A face of each of four solids into lanes; corners beyond a face's own repeat its last.
struct FourFacesOfSolids {
  std::array<const PlacedSolid*, lane_count> solid;
  std::array<int, lane_count> face;

  int load(std::array<Triple<Lanes>, max_face_corners>& corners) const {
    std::array<std::span<const int>, lane_count> loop;
    std::size_t most = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      loop[i] = solid[i]->solid->shape.faces[face[i]];
      most = std::max(most, loop[i].size());
    }
    const auto corner = [&](std::size_t lane, std::size_t k) -> const Vec3& {
      const std::span<const int> l = loop[lane];
      return solid[lane]->corners[static_cast<std::size_t>(l[k < l.size() ? k : l.size() - 1])];
    };
    for (std::size_t k = 0; k < most; ++k) corners[k] = four_of(corner(0, k), corner(1, k), corner(2, k), corner(3, k));
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
inline void store_flat(const FlatResponses& out, int lane, SolidAnswer& answer, SolidMemory& memory,
                       ContactArea& area) {
  answer.joint_changed = false;
  answer.touching = out.presses[lane] != 0;
  answer.lost_damping = out.lost_damping[lane], answer.lost_friction = out.lost_friction[lane];
  answer.lost_fracture = 0;
  if (!answer.touching) {
    memory = {};
    return;
  }
  answer.moment_a = lane_of(out.moment_a, lane), answer.moment_b = lane_of(out.moment_b, lane);
  answer.force = lane_of(out.force, lane), answer.normal_force = lane_of(out.normal_force, lane);
  answer.centre = lane_of(out.centre, lane), answer.area = out.area[lane], answer.depth = out.depth[lane];
  area.middle = lane_of(out.middle, lane), area.normal = lane_of(out.normal, lane), area.area = out.area[lane];
  area.radius = out.radius[lane], area.friction_arm = out.friction_arm[lane];
  area.arm[0] = lane_of(out.arm[0], lane), area.arm[1] = lane_of(out.arm[1], lane);
  area.face_a = area.face_b = -1;
  const FlatMemory& m = out.memory;
  memory.shear = {lane_of(m.shear.elastic, lane), lane_of(m.shear.total, lane), m.shear.area[lane]};
  memory.normal = lane_of(m.normal, lane), memory.damping = lane_of(m.damping, lane);
  memory.damping_moment = lane_of(m.damping_moment, lane);
  memory.slip = m.slip[lane], memory.state = contact_touching | contact_general;
}

}  // namespace trilith
