#include "step/stored_energy.hpp"

#include <algorithm>
#include <array>

#include "contact/face_resultant.hpp"
#include "contact/overlap_energy.hpp"
#include "step/contact_rows.hpp"

namespace trilith {
namespace {

/// kn/2 of the integral of g^2 over one half, where closed, and of the share a bond holds all along [J].
double half_store(const HalfGaps& gaps, double length, double hold, double kn) {
  const double g0 = gaps.g0, g1 = gaps.g1;
  const PositivePart<double> part(-g0, -g1);
  const double d0 = -g0 - (g1 - g0) * part.from, d1 = -g0 - (g1 - g0) * part.to;
  const double closed = (part.to - part.from) * (d0 * d0 + d0 * d1 + d1 * d1), all = g0 * g0 + g0 * g1 + g1 * g1;
  const double mortar = 3 * gaps.filling.product(g0, g1, g0, g1);
  return kn * length * (closed + hold * (all + mortar - closed)) / 6;
}

}  // namespace

double pressing_energy(const Work<2>& work, const NearPair& p, const ContactMemory& m, const FaceLaw& law) {
  const FaceOverlap<double> o = face_overlap(work, p);
  if (!o.sane) return 0;
  const std::array<HalfGaps, 2> gaps = half_gaps(o, m, law);
  return half_store(gaps[0], 0.5 * o.shared, bond_hold(m, 0, law), law.kn) +
         half_store(gaps[1], 0.5 * o.shared, bond_hold(m, 1, law), law.kn);
}

namespace {

double face_energy(const Work<2>& work, const NearPair& p, const ContactMemory& m, const FaceLaw& law) {
  double sum = pressing_energy(work, p, m, law);
  for (const int h : {0, 1})
    if (m.active[h] > 0 && law.ks > 0) sum += 0.5 * m.shear_elastic[h] * m.shear_elastic[h] / (law.ks * m.active[h]);
  return sum;
}

double general_energy(const Model<2>& model, const State<2>& state, const Work<2>& work, const GeneralContact& g) {
  const NearPair& p = work.pairs[g.row];
  const ContactMemory& m = work.memory[g.row];
  const FaceLaw law = face_law(model, p.law, 0);
  PieceCorners corners_a, corners_b;
  const double normal =
      overlap_energy(placed_piece(model, state, work, p.piece_a, corners_a),
                     placed_piece(model, state, work, p.piece_b, corners_b), law.kn, general_crushed(m));
  const double shear = m.shear_elastic[0] + m.shear_elastic[1], stiffness = law.ks * (m.active[0] + m.active[1]);
  return normal + (stiffness > 0 ? 0.5 * shear * shear / stiffness : 0);
}

}  // namespace

double dilation_energy(const Work<2>& work, const NearPair& pair, const ContactMemory& memory, const FaceLaw& law) {
  ContactMemory bare = memory;
  bare.state |= contact_worn;
  return pressing_energy(work, pair, memory, law) - pressing_energy(work, pair, bare, law);
}

double crushing_energy(const Work<2>& work, const NearPair& pair, const ContactMemory& memory, const FaceLaw& law) {
  ContactMemory even = memory;
  even.state |= contact_worn;
  ContactMemory worn = even;
  for (double& half : even.crushed) half = std::max(memory.crushed[0], memory.crushed[1]);
  return pressing_energy(work, pair, worn, law) - pressing_energy(work, pair, even, law);
}

double contact_energy(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  double sum = 0;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const ContactMemory& m = work.memory[row];
    const bool face = (m.state & contact_touching) != 0 && (m.state & contact_general) == 0;
    if (face) sum += face_energy(work, work.pairs[row], m, face_law(model, work.pairs[row].law, 0));
  }
  for (const GeneralContact& g : work.general_touching) sum += general_energy(model, state, work, g);
  return sum;
}

}  // namespace trilith
