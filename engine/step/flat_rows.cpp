#include "step/flat_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lane_vectors.hpp"
#include "contact/solid_faces.hpp"

namespace trilith {
namespace {

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
TRILITH_INLINE MovingInLanes four_nodes(const State<3>& state, const std::array<int, lane_count>& n) {
  const auto four = [&](const std::vector<Vec3>& v) { return four_of(v[n[0]], v[n[1]], v[n[2]], v[n[3]]); };
  return {four(state.position), four(state.velocity), four(state.spin)};
}

/// What four contacts remember into lanes.
TRILITH_INLINE void load_memories(const std::array<const SolidMemory*, lane_count>& m, FlatMemory& out) {
  const auto four = [&](const auto& of) { return four_of(of(*m[0]), of(*m[1]), of(*m[2]), of(*m[3])); };
  out.shear.elastic = four([](const SolidMemory& s) -> const Vec3& { return s.shear.elastic; });
  out.shear.total = four([](const SolidMemory& s) -> const Vec3& { return s.shear.total; });
  out.normal = four([](const SolidMemory& s) -> const Vec3& { return s.normal; });
  out.damping = four([](const SolidMemory& s) -> const Vec3& { return s.damping; });
  out.damping_moment = four([](const SolidMemory& s) -> const Vec3& { return s.damping_moment; });
  out.shear.area = Lanes{m[0]->shear.area, m[1]->shear.area, m[2]->shear.area, m[3]->shear.area};
  out.slip = Lanes{m[0]->slip, m[1]->slip, m[2]->slip, m[3]->slip};
}

/// The faces of four rows into lanes.
TRILITH_INLINE void load_faces(const Work<3>& work, const std::array<const NearPair*, lane_count>& pair,
                               const std::array<const FacePair*, lane_count>& pair_of_faces, FacesInLanes& out) {
  FourFacesOfSolids a, b;
  FourOf first_a, first_b, normal_a, normal_b;
  std::array<const std::uint8_t*, lane_count> corner_a, corner_b;
  bool few = true;
  for (std::size_t i = 0; i < pair.size(); ++i) {
    const FacePair& f = *pair_of_faces[i];
    a.solid[i] = &work.solids.placed[pair[i]->piece_a], b.solid[i] = &work.solids.placed[pair[i]->piece_b];
    a.face[i] = f.a, b.face[i] = f.b;
    first_a[i] = a.solid[i]->corners.data(), first_b[i] = b.solid[i]->corners.data();
    normal_a[i] = a.solid[i]->normals.data() + f.a, normal_b[i] = b.solid[i]->normals.data() + f.b;
    corner_a[i] = f.corner_a.data(), corner_b[i] = f.corner_b.data();
    few = few && f.few;
  }
  out.normal_a = four_at(normal_a), out.normal_b = four_at(normal_b);
  if (few) {
    out.corners_a = load_few(first_a, corner_a, out.a), out.corners_b = load_few(first_b, corner_b, out.b);
  } else {
    out.corners_a = a.load(out.a), out.corners_b = b.load(out.b);
  }
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] void load_flat(const State<3>& state, const Work<3>& work,
                                                         const std::array<int, lane_count>& row, double dt,
                                                         FlatContacts& in) {
  const std::vector<SolidMemory>& before = contacts_before(state, work).memory;
  std::array<const NearPair*, lane_count> pairs;
  std::array<const FacePair*, lane_count> faces;
  std::array<int, lane_count> node_a, node_b;
  std::array<const SolidMemory*, lane_count> memory;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto r = static_cast<std::size_t>(row[i]);
    pairs[i] = &work.pairs[r], faces[i] = &work.solids.faces[r], memory[i] = &before[r];
    node_a[i] = faces[i]->node_a, node_b[i] = faces[i]->node_b;
    const LawNumbers& law = work.solids.law[static_cast<std::size_t>(pairs[i]->law)];
    const auto lane = static_cast<int>(i);
    in.kn[lane] = law.kn, in.ks[lane] = law.ks, in.mu[lane] = law.mu, in.beta[lane] = law.beta;
    in.near[lane] = faces[i]->near, in.b_is_larger[lane] = faces[i]->b_is_larger ? -1 : 0;
  }
  in.dt = dt;
  load_faces(work, pairs, faces, in.faces);
  in.a = four_nodes(state, node_a), in.b = four_nodes(state, node_b);
  load_memories(memory, in.before);
}

}  // namespace trilith
