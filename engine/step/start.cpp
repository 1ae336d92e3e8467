#include "step/start.hpp"

#include <algorithm>
#include <cmath>

#include "contact/face_overlap.hpp"
#include "detect/pairs.hpp"
#include "step/evaluate.hpp"

namespace trilith {
namespace {

double face_gap(const Work<2>& work, const NearPair& p) {
  const auto ends = [&](int i, int j) {
    const SkinMotion &a = work.skin[i], &b = work.skin[j];
    return FaceEnds<double>{a.x, a.y, b.x, b.y, 0, 0, 0, 0};
  };
  const FaceOverlap<double> o(ends(p.a0, p.a1), ends(p.b0, p.b1));
  return std::max(std::abs(o.gap_lo), std::abs(o.gap_hi));
}

}  // namespace

State<2> start_state(const Model<2>& model, double reach) {
  State<2> state = initial_state(model);
  Work<2> work;
  place(model, state, work);
  find(model, state, work);
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    NearPair pair = work.pairs[row];
    if (bond_of(model.laws[pair.law]) == Bond::none || !choose_face_pair(model, work, true, pair)) continue;
    const double size = 2 * std::min(model.body_radius[model.piece_body[pair.piece_a]],
                                     model.body_radius[model.piece_body[pair.piece_b]]);
    if (face_gap(work, pair) > reach * size) continue;
    state.memory[row].bonds = 3;
    state.memory[row].state = contact_touching;
  }
  return state;
}

}  // namespace trilith
