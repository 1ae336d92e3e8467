#include "assembly/contact/flat_contact_simd.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "base/simd/lane_rows.hpp"
#include "contact/space/solid_faces.hpp"

namespace trilith {
namespace {

/// One corner or normal of each of four placed polyhedra.
using FourOf = std::array<const Vec3*, lane_count>;

TRILITH_INLINE Triple<Lanes> four_at(const FourOf& of) {
  return four_of(*of[0], *of[1], *of[2], *of[3]);
}

/// Loads faces with few corners, one of each of four polyhedra, into lanes. Returns the largest number of corners.
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

/// Loads a face of each of four polyhedra into lanes; corners beyond the end of a face repeat its last corner.
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

/// Nodal vectors of four nodes.
TRILITH_INLINE Triple<Lanes> four_nodes(const std::vector<Vec3>& of, const std::array<int, lane_count>& n) {
  return four_of(of[static_cast<std::size_t>(n[0])], of[static_cast<std::size_t>(n[1])],
                 of[static_cast<std::size_t>(n[2])], of[static_cast<std::size_t>(n[3])]);
}
TRILITH_INLINE MovingInLanes moving_nodes(const State<3>& state, const std::array<int, lane_count>& n) {
  return {four_nodes(state.position, n), four_nodes(state.velocity, n), four_nodes(state.spin, n)};
}

// Rows of numbers are read and written as whole registers, in this order.
static_assert(std::is_standard_layout_v<SolidMemory> && offsetof(SolidMemory, normal) == 7 * sizeof(double) &&
              offsetof(SolidMemory, damping_moment) == 13 * sizeof(double) &&
              offsetof(SolidMemory, slip) == 16 * sizeof(double));
static_assert(std::is_standard_layout_v<SolidAnswer> &&
              offsetof(SolidAnswer, centre) + sizeof(Vec3) - offsetof(SolidAnswer, area) == 20 * sizeof(double));
static_assert(std::is_standard_layout_v<ContactArea> && offsetof(ContactArea, arm) == 9 * sizeof(double) &&
              offsetof(ContactArea, face_a) == 15 * sizeof(double));
static_assert(offsetof(LawNumbers, beta) == 3 * sizeof(double));

/// Loads the memories of four contacts into lanes.
TRILITH_INLINE void load_memories(const std::array<const double*, lane_count>& of, FlatMemory& out) {
  const FourRowsOf<const double> row(of);
  Triple<Lanes>&elastic = out.shear.elastic, &total = out.shear.total, &moment = out.damping_moment;
  row.load(0, elastic.x, elastic.y, elastic.z, total.x);
  row.load(4, total.y, total.z, out.shear.area, out.normal.x);
  row.load(8, out.normal.y, out.normal.z, out.damping.x, out.damping.y);
  row.load(12, out.damping.z, moment.x, moment.y, moment.z);
  row.load(16, out.slip);
}

TRILITH_INLINE void store_memories(const FlatMemory& m, const std::array<double*, lane_count>& to) {
  const FourRowsOf<double> row(to);
  const Triple<Lanes>&elastic = m.shear.elastic, &total = m.shear.total, &moment = m.damping_moment;
  row.store(0, elastic.x, elastic.y, elastic.z, total.x);
  row.store(4, total.y, total.z, m.shear.area, m.normal.x);
  row.store(8, m.normal.y, m.normal.z, m.damping.x, m.damping.y);
  row.store(12, m.damping.z, moment.x, moment.y, moment.z);
  row.store(16, m.slip);
}

TRILITH_INLINE void store_answers(const FlatResponses& out, const std::array<double*, lane_count>& to) {
  const FourRowsOf<double> row(to);
  const Triple<Lanes>&f = out.force, &a = out.moment_a, &b = out.moment_b, &n = out.normal_force, &c = out.centre;
  row.store(0, out.area, out.depth, out.lost_damping, out.lost_friction);
  row.store(4, Lanes{}, f.x, f.y, f.z);  // no fracture energy
  row.store(8, a.x, a.y, a.z, b.x);
  row.store(12, b.y, b.z, n.x, n.y);
  row.store(16, n.z, c.x, c.y, c.z);
}

TRILITH_INLINE void store_areas(const FlatResponses& out, const std::array<double*, lane_count>& to) {
  const FourRowsOf<double> row(to);
  const Triple<Lanes>&m = out.middle, &n = out.normal, &along = out.arm[0], &aside = out.arm[1];
  row.store(0, m.x, m.y, m.z, n.x);
  row.store(4, n.y, n.z, out.area, out.radius);
  row.store(8, out.friction_arm, along.x, along.y, along.z);
  row.store(12, aside.x), row.store(13, aside.y), row.store(14, aside.z);
}

/// Loads the faces of four rows into lanes.
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

/// load_contacts() for any width of registers.
TRILITH_INLINE void load_moving(const State<3>& state, const Work<3>& work, const std::array<int, lane_count>& row,
                                double dt, ContactsInLanes& in) {
  const std::vector<SolidMemory>& before = contacts_before(state, work).memory;
  std::array<int, lane_count> node_a, node_b;
  std::array<const double*, lane_count> memory, law;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto r = static_cast<std::size_t>(row[i]);
    const FacePair& faces = work.solids.faces[r];
    memory[i] = before[r].shear.elastic.data();
    node_a[i] = faces.node_a, node_b[i] = faces.node_b;
    law[i] = &work.solids.law[static_cast<std::size_t>(work.pairs[r].law)].kn;
  }
  FourRowsOf<const double>(law).load(0, in.kn, in.ks, in.mu, in.beta);
  in.dt = dt;
  in.a = moving_nodes(state, node_a), in.b = moving_nodes(state, node_b);
  load_memories(memory, in.before);
}

}  // namespace

[[gnu::target_clones("avx2", "default")]] void load_contacts(const State<3>& state, const Work<3>& work,
                                                             const std::array<int, lane_count>& row, double dt,
                                                             ContactsInLanes& in) {
  load_moving(state, work, row, dt, in);
}

[[gnu::target_clones("avx2", "default")]] void load_flat(const State<3>& state, const Work<3>& work,
                                                         const std::array<int, lane_count>& row, double dt,
                                                         FlatContacts& in) {
  std::array<const NearPair*, lane_count> pairs;
  std::array<const FacePair*, lane_count> faces;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto r = static_cast<std::size_t>(row[i]);
    pairs[i] = &work.pairs[r], faces[i] = &work.solids.faces[r];
  }
  in.near = Lanes{faces[0]->near, faces[1]->near, faces[2]->near, faces[3]->near};
  const auto larger = [&](std::size_t i) { return faces[i]->b_is_larger ? std::int64_t{-1} : std::int64_t{0}; };
  in.b_is_larger = LaneMask{larger(0), larger(1), larger(2), larger(3)};
  load_faces(work, pairs, faces, in.faces);
  load_moving(state, work, row, dt, in);
}

[[gnu::target_clones("avx2", "default")]] void store_flat(const FlatResponses& out, const FlatPlaces& to) {
  store_answers(out, to.answer);
  store_memories(out.memory, to.memory);
  store_areas(out, to.area);
}

}  // namespace trilith
