#include "assembly/stored_energy.hpp"

#include <utility>

#include "assembly/contact/contact_rows.hpp"
#include "broad_phase/bearing_rules.hpp"
#include "contact/joint/face_resultant.hpp"
#include "contact/joint/joint.hpp"
#include "contact/plane/overlap_energy.hpp"
#include "contact/space/recorded_energy.hpp"

namespace trilith {
namespace {

/// Elastic shear energy of one half: T^2 / (2 ks l), with l the length that carries shear.
double shear_energy(const ContactMemory& m, int half, double ks) {
  if (!(m.active[half] > 0 && ks > 0)) return 0;
  return 0.5 * m.shear_elastic[half] * m.shear_elastic[half] / (ks * m.active[half]);
}

double face_energy(const Model<2>& model, const Work<2>& work, std::size_t row) {
  const NearPair& pair = work.pairs[row];
  return with_kernel(law_in_use(model, pair.law), [&]<class K>(const K& law) {
    double sum = pressing_energy(face_overlap(work, pair), work.contacts.memory[row],
                                 law_memory<K>(work.contacts.law_numbers(row)), law);
    for (const int h : {0, 1}) sum += shear_energy(work.contacts.memory[row], h, law.ks);
    return sum;
  });
}

double general_energy(const Model<2>& model, const State<2>& state, const Work<2>& work, const GeneralContact<2>& g) {
  const NearPair& p = work.pairs[g.row];
  PieceCorners corners_a, corners_b;
  return general_energy(
      placed_piece(model, state, work, p.piece_a, corners_a), placed_piece(model, state, work, p.piece_b, corners_b),
      {work.contacts.memory[g.row], work.contacts.law_numbers(g.row)}, law_beside_bearings(model, state, work, p));
}

}  // namespace

double general_energy(const PlacedPiece& a, const PlacedPiece& b, const Remembered& remembered, const LawInUse& law) {
  const auto [crushed, ks] = with_kernel(
      law, [&]<class K>(const K& kernel) { return std::pair(K::crushed(law_memory<K>(remembered.law)), kernel.ks); });
  const ContactMemory& m = remembered.contact;
  const double normal = overlap_energy(a, b, law, crushed);
  const double shear = m.shear_elastic[0] + m.shear_elastic[1], stiffness = ks * (m.active[0] + m.active[1]);
  return normal + (stiffness > 0 ? 0.5 * shear * shear / stiffness : 0);
}

/// Sum of the elastic energies of all touching contacts, from normal overlap and elastic slip. Faces come first, by
/// row, in closed form; then the general contacts of this evaluation, by the integral over the shared area.
double contact_energy(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  double sum = 0;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const ContactMemory& m = work.contacts.memory[row];
    const bool face = (m.state & contact_touching) != 0 && (m.state & contact_general) == 0;
    if (face) sum += face_energy(model, work, row);
  }
  for (const GeneralContact<2>& g : work.general_touching) sum += general_energy(model, state, work, g);
  return sum;
}

/// In space: a bonded joint by its patches, all other contacts by the shared volume and the stored shear.
double contact_energy(const Model<3>& model, const State<3>& state, const Work<3>& work) {
  SolidOverlapBuffer shared, cell;
  double sum = 0;
  for (const GeneralContact<3>& g : work.general_touching) {
    const NearPair& p = work.pairs[g.row];
    const LawInUse law = law_beside_bearings(model, state, work, p);
    const JointMemory* joint = work.contacts.joint_at(static_cast<std::size_t>(g.row));
    if (joint != nullptr && !joint->empty()) {
      sum += joint_energy(*joint, law);
      continue;
    }
    sum += recorded_contact_energy(work.solids.placed[p.piece_a], work.solids.placed[p.piece_b],
                                   work.contacts.memory[g.row], law, shared, cell);
  }
  return sum;
}

}  // namespace trilith
