#include "run/missed_bonds.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/contact/contact_rows.hpp"
#include "assembly/evaluate.hpp"
#include "broad_phase/pairs.hpp"
#include "contact/joint/joint.hpp"
#include "contact/space/solid_faces.hpp"
#include "law/contact/list.hpp"

namespace trilith {
namespace {

// Shares of the smaller body's size: largest gap at which faces are assumed to be meant to meet, and their least shared
// width.
constexpr double widest_gap = 1e-2, least_face = 1e-3;

template <int D>
double smaller_body(const Model<D>& model, const NearPair& p) {
  return 2 * std::min(model.body_radius[model.piece_body[p.piece_a]], model.body_radius[model.piece_body[p.piece_b]]);
}

/// Counts a pair whose faces are `gap` apart [m].
template <int D>
void count_missed(const Model<D>& model, const NearPair& p, double gap, MissedBonds& found) {
  if (found.count++ > 0) return;
  found.body_a = model.piece_body[p.piece_a], found.body_b = model.piece_body[p.piece_b];
  found.law = p.law, found.gap = gap;
}

/// Gap of the faces of two bodies: the least reach at which they meet, at most `most` [m].
double gap_of_faces(const PlacedSolid& a, const PlacedSolid& b, double most, double width) {
  double apart = 0;
  FaceOverlap3 faces;
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (apart + most);
    (meeting_faces(a, b, middle, width, faces) ? most : apart) = middle;
  }
  return most;
}

template <int D>
bool any_bonds(const Model<D>& model) {
  return std::any_of(model.laws.begin(), model.laws.end(), [](const ContactLaw& law) { return may_bond(law); });
}

}  // namespace

MissedBonds missed_bonds(const Model<2>& model, const State<2>& state) {
  MissedBonds found;
  if (!any_bonds(model)) return found;
  Work<2> work;
  update_kinematics(model, state, work);
  update_contact_pairs(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    NearPair pair = work.pairs[row];
    if (!may_bond(model.laws[pair.law]) || work.matched.memory[row].bonds != 0) continue;
    if (!choose_face_pair(model, work, true, pair)) continue;
    const FaceOverlap<double> overlap = face_overlap(work, pair);
    const double size = smaller_body(model, pair);
    const double gap = std::max(std::abs(overlap.gap_lo), std::abs(overlap.gap_hi));
    if (gap <= widest_gap * size && overlap.shared >= least_face * size) count_missed(model, pair, gap, found);
  }
  return found;
}

MissedBonds missed_bonds(const Model<3>& model, const State<3>& state) {
  MissedBonds found;
  if (!any_bonds(model)) return found;
  Work<3> work;
  update_kinematics(model, state, work);
  update_contact_pairs(model, state, work);
  FaceOverlap3 faces;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& pair = work.pairs[row];
    if (model.piece_solid[pair.piece_a].is_sphere() || model.piece_solid[pair.piece_b].is_sphere()) continue;
    const JointMemory* joint = work.matched.joint_at(row);
    if (pair.replaced || !may_bond(model.laws[pair.law]) || (joint != nullptr && !joint->empty())) continue;
    const PlacedSolid &a = work.solids.placed[pair.piece_a], &b = work.solids.placed[pair.piece_b];
    const double size = smaller_body(model, pair);
    if (!meeting_faces(a, b, widest_gap * size, least_face * size, faces)) continue;
    const double gap = found.count == 0 ? gap_of_faces(a, b, widest_gap * size, least_face * size) : 0;
    count_missed(model, pair, gap, found);
  }
  return found;
}

}  // namespace trilith
