#include "assembly/water/closed_joints.hpp"

#include <algorithm>

#include "contact/space/solid_faces.hpp"
#include "load/water/uplift.hpp"

namespace trilith {
namespace {

/// Largest gap or overlap of two faces in space that may be closed somewhere, over the size of the smaller solid.
constexpr double closed_reach = 0.01;

/// Marks the bodies with faces that water reaches. False: there are none.
template <int D>
bool mark_wet(const Model<D>& model, ClosedJoints<D>& joints) {
  joints.clear();
  const auto mark = [&](const std::vector<WetFace<D>>& faces) {
    if (faces.empty()) return;
    joints.wet.resize(model.bodies.size(), 0);
    for (const WetFace<D>& face : faces) joints.wet[static_cast<std::size_t>(face.body)] = 1;
  };
  for (const Water<D>& water : loads_of<Water<D>>(model))
    if (water.sealed) mark(water.faces);
  for (const Uplift<D>& uplift : loads_of<Uplift<D>>(model)) mark(uplift.upper);
  return !joints.wet.empty();
}

/// Sorts the parts by face, in the plane also by position.
void sort_parts(ClosedJoints<2>& joints) {
  std::sort(joints.parts.begin(), joints.parts.end(), [](const ClosedPart<2>& a, const ClosedPart<2>& b) {
    return a.face != b.face ? a.face < b.face : a.from < b.from;
  });
}
void sort_parts(ClosedJoints<3>& joints) {
  std::sort(joints.parts.begin(), joints.parts.end(), [](const ClosedPart<3>& a, const ClosedPart<3>& b) {
    return a.face != b.face ? a.face < b.face : a.first < b.first;
  });
}

/// Skin points of the outer edges of a piece.
template <class F>
void for_edges(const Model<2>& model, int piece, F&& f) {
  const int first = model.piece_first[piece], end = model.piece_first[piece + 1];
  for (int c = first; c < end; ++c)
    if (model.edge_is_face[c] != 0) f(model.corner_skin[c], model.corner_skin[c + 1 < end ? c + 1 : first]);
}

/// Two faces in the plane that may be closed, as a joint of the row `row`.
void add_faces(const Work<2>& work, const WetFace<2>& a, const WetFace<2>& b, unsigned bonds, ClosedJoints<2>& out) {
  struct Skins {
    const Work<2>& work;
    [[nodiscard]] Vec2 skin(int i) const { return {work.skin[i].x, work.skin[i].y}; }
  };
  const JointStretch stretch(Skins{work}, a, b);
  if (!stretch.overlap.sane) return;
  stretch.for_closed(bonds, [&](double from, double to) {
    out.parts.push_back({a.key(), stretch.on_a(from), stretch.on_a(to)});
    out.parts.push_back({b.key(), stretch.on_b(to), stretch.on_b(from)});
  });
  if (bonds != 0) out.bonded.push_back({a.key(), b.key(), bonds});
}

bool is_wet(const std::vector<std::uint8_t>& wet, int a, int b) {
  return wet[static_cast<std::size_t>(a)] != 0 || wet[static_cast<std::size_t>(b)] != 0;
}

/// Bonded halves of a row of contact.
unsigned bonds_of(const Work<2>& work, std::size_t row) {
  return row < work.contacts.memory.size() ? work.contacts.memory[row].bonds & 3U : 0U;
}
/// 1 if mortar holds some part of the joint of a row.
unsigned bonds_of(const Work<3>& work, std::size_t row) {
  const JointMemory* joint = work.contacts.joint_at(row);
  return joint != nullptr && (joint->sound || joint->bonds != 0) ? 1U : 0U;
}

}  // namespace

template <int D>
bool has_water(const Model<D>& model) {
  bool has = false;
  model.loads.for_each_kind([&]<class L>(const std::vector<L>& loads) {
    if constexpr (is_water<L>) has = has || !loads.empty();
  });
  return has;
}

void find_closed_joints(const Model<2>& model, Work<2>& work) {
  ClosedJoints<2>& out = work.closed_joints;
  if (!mark_wet(model, out)) return;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& pair = work.pairs[row];
    const int a = model.piece_body[pair.piece_a], b = model.piece_body[pair.piece_b];
    if (pair.facing == 0 || pair.replaced || !is_wet(out.wet, a, b)) continue;
    const unsigned bonds = bonds_of(work, row);
    if (pair.facing == 1) {
      add_faces(work, {a, pair.a0, pair.a1}, {b, pair.b0, pair.b1}, bonds, out);
      continue;
    }
    for_edges(model, pair.piece_a, [&](int a0, int a1) {
      for_edges(model, pair.piece_b, [&](int b0, int b1) { add_faces(work, {a, a0, a1}, {b, b0, b1}, bonds, out); });
    });
  }
  sort_parts(out);
}

void find_closed_joints(const Model<3>& model, Work<3>& work) {
  ClosedJoints<3>& out = work.closed_joints;
  if (!mark_wet(model, out)) return;
  FaceOverlap3 faces;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& pair = work.pairs[row];
    const PlacedSolid &a = work.solids.placed[pair.piece_a], &b = work.solids.placed[pair.piece_b];
    const bool is_sphere = model.piece_solid[pair.piece_a].is_sphere() || model.piece_solid[pair.piece_b].is_sphere();
    if (pair.replaced || is_sphere || !is_wet(out.wet, model.piece_body[pair.piece_a], model.piece_body[pair.piece_b]))
      continue;
    if (!meeting_faces(a, b, closed_reach * std::min(a.solid->size, b.solid->size), 0, faces)) continue;
    const unsigned bonds = bonds_of(work, row);
    const FaceKey key_a = face_key(pair.piece_a, faces.face_a), key_b = face_key(pair.piece_b, faces.face_b);
    const WetPolygon shared = polygon_of(faces);
    const WetPolygon closed = bonds != 0 ? shared : cut(shared.corners(), closed_field(faces));
    if (bonds != 0) out.bonded.push_back({key_a, key_b, bonds});
    if (closed.count < 3) continue;
    const int first = static_cast<int>(out.corner.size());
    out.corner.insert(out.corner.end(), closed.corners().begin(), closed.corners().end());
    out.parts.push_back({key_a, first, closed.count});
    out.parts.push_back({key_b, first, closed.count});
  }
  sort_parts(out);
}

template bool has_water(const Model<2>&);
template bool has_water(const Model<3>&);

}  // namespace trilith
