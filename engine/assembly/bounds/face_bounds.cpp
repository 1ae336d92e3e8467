// Bounds of bodies in the plane in contact along their stiffest faces, for which the stable step must be short enough.
#include "assembly/bounds/face_bounds.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "assembly/bounds/local_springs.hpp"
#include "assembly/whole_body.hpp"
#include "model/contact/skin_places.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Keeps the stiffer face of a deformable body in full contact: stiffness per mass at its end with the smaller mass.
void add_stiffer_face(const Model<2>& model, int from, int to, const ContactTangent& law, Local& stiffest) {
  const double length = (model.start_position[to] - model.start_position[from]).norm();
  const double k =
      2 * (0.5 + 1.0 / 6) * length * std::max(law.normal, law.shear) / std::min(model.mass[from], model.mass[to]);
  if (k <= stiffest.k(0, 0)) return;
  stiffest.k(0, 0) = k;
  stiffest.c(0, 0) = law.beta * k;
}

/// Keeps the stiffer face of a frame in full contact: stiffness per mass at the sections of its ends.
void add_stiffer_section(const Model<2>& model, int from, int to, const ContactTangent& law, Local& stiffest) {
  const double length = (skin_start(model, to) - skin_start(model, from)).norm();
  for (const int skin : {from, to}) {
    const int n = model.skin_node[skin], t = model.skin_turn[skin];
    const double pinned = n == t ? 1 : 2, arm = model.skin_place[skin].squaredNorm() / model.inertia[t];
    const double k = pinned * 2 * (0.5 + 1.0 / 6) * length *
                     (std::max(law.normal, law.shear) / model.mass[n] + std::max(law.normal, law.shear) * arm);
    if (k <= stiffest.k(0, 0)) continue;
    stiffest.k(0, 0) = k;
    stiffest.c(0, 0) = law.beta * k;
  }
}

/// Replaces `stiffest` by the stiffest face of a body under the law `numbers`, if that is stiffer.
void add_stiffer_faces(const Model<2>& model, const Body& b, const ContactTangent& numbers, Local& stiffest) {
  for (int piece = b.first_piece; piece < b.first_piece + b.pieces; ++piece)
    for (int c = 0, count = model.corners_of(piece), first = model.piece_first[piece]; c < count; ++c) {
      if (!model.edge_is_face[first + c]) continue;
      const int from = model.corner_skin[first + c], to = model.corner_skin[first + (c + 1) % count];
      if (b.skin_is_sections()) {
        add_stiffer_section(model, from, to, numbers, stiffest);
        continue;
      }
      if (!b.is_rigid()) {
        add_stiffer_face(model, model.skin_node[from], model.skin_node[to], numbers, stiffest);
        continue;
      }
      // Weight 2: the other body moves too.
      const Vec2 &p = model.skin_place[from], &q = model.skin_place[to];
      const double length = (q - p).norm();
      const Vec2 t = (q - p) / length, n(t.y(), -t.x()), arm = 0.5 * (p + q);
      Local local;
      add_spring(local, n, arm, numbers.normal * length, numbers.beta, length, t, 2);
      add_spring(local, t, arm, numbers.shear * length, numbers.beta, length, t, 2);
      if (local.k.trace() > stiffest.k.trace()) stiffest = local;
    }
}

/// Laws between the surface of a body and the others, in their order, without repetition in sequence.
std::vector<ContactTangent> tangents_of(const Model<2>& model, const Body& b) {
  std::vector<ContactTangent> out;
  int last = -1;
  for (int other = 0; other < model.surfaces; ++other)
    if (const int law = model.law_of[b.surface * model.surfaces + other]; law >= 0 && law != std::exchange(last, law))
      out.push_back(spring_tangent(model, law, 0));
  return out;
}

/// The stiffest face of a body under the stiffest law of its surface, as if in full contact with an equal body, in the
/// axes of the body. Laws that are softer in both directions than another one are skipped.
Local on_stiffest_face(const Model<2>& model, int body) {
  Local stiffest;
  const Body& b = model.bodies[body];
  const std::vector<ContactTangent> tangents = tangents_of(model, b);
  ContactTangent hardest{0, 0, 0}, most{-1, -1, 0};
  for (const ContactTangent& t : tangents)
    if (t.normal > hardest.normal) hardest = t;
  for (const ContactTangent& t : tangents) {
    if (t.normal < hardest.normal && t.shear <= hardest.shear && hardest.shear < hardest.normal) continue;
    if (t.normal <= most.normal && t.shear <= most.shear) continue;
    if (t.normal >= most.normal && t.shear >= most.shear) most = t;
    add_stiffer_faces(model, b, t, stiffest);
  }
  return stiffest;
}

/// Springs all around a meshed body as if it were rigid, half as stiff as in full contact with moving bodies. This is
/// at least the stiffness of its longest side, because no side is longer than half the outline.
RateBound around_outline(const Model<2>& model, int body) {
  const WholeBody<2> whole = whole_body(model, model.start_position, body);
  if (!whole.moves()) return {};
  ContactTangent stiffest{0, 0, 0};
  const Body& b = model.bodies[body];
  for (const ContactTangent& t : tangents_of(model, b))
    if (t.normal > stiffest.normal) stiffest = t;
  Local out;
  for (int piece = b.first_piece; piece < b.first_piece + b.pieces; ++piece)
    for (int c = 0, count = model.corners_of(piece), first = model.piece_first[piece]; c < count; ++c) {
      if (!model.edge_is_face[first + c]) continue;
      const Vec2 p = skin_start(model, model.corner_skin[first + c]),
                 q = skin_start(model, model.corner_skin[first + (c + 1) % count]);
      const double length = (q - p).norm();
      const Vec2 t = (q - p) / length, n(t.y(), -t.x()), arm = 0.5 * (p + q) - whole.centre;
      add_spring(out, n, arm, stiffest.normal * length, stiffest.beta, length, t, 1);
      add_spring(out, t, arm, stiffest.shear * length, stiffest.beta, length, t, 1);
    }
  constexpr std::array all{true, true, true};
  return rate_bound(out, whole.mass, whole.inertia, all);
}

}  // namespace

void bound_faces(const Model<2>& model, Work<2>& work) {
  work.face_bound.resize(model.bodies.size());
  work.around_bound.assign(model.bodies.size(), {});
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (!model.body_moves(static_cast<int>(b))) continue;
    if (is_of_elements(model.bodies[b])) work.around_bound[b] = around_outline(model, static_cast<int>(b));
    const Local local = on_stiffest_face(model, static_cast<int>(b));
    if (!model.bodies[b].is_rigid()) {
      work.face_bound[b] = {local.k(0, 0), local.c(0, 0)};
      continue;
    }
    work.face_bound[b] = larger_rates(model, model.bodies[b].first_node, local, {});
  }
}

}  // namespace trilith
