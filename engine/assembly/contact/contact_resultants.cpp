#include "assembly/contact/contact_resultants.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/contact/contact_rows.hpp"

namespace trilith {
namespace {

/// Bonded if one of both halves is bonded; otherwise the shear is compared with mu N.
ContactHold hold_of(const ContactMemory& memory, const ContactResultant& r, double mu) {
  if (memory.bonds != 0) return ContactHold::bonded;
  // Sliding shear equals the limit, up to rounding.
  return std::abs(r.shear) >= (1 - 1e-9) * mu * r.normal ? ContactHold::sliding : ContactHold::sticking;
}

}  // namespace

/// Normal force, shear and their point of action, from the law's own equations of the stresses over the shared length.
ContactResultant face_resultant(const Model<2>& model, const Work<2>& work, const NearPair& pair,
                                const ContactMemory& memory, const double* law_numbers) {
  return with_kernel(law_in_use(model, pair.law), [&]<class K>(const K& law) {
    return face_resultant(face_ends(work, pair.a0, pair.a1), face_ends(work, pair.b0, pair.b1), memory,
                          law_memory<K>(law_numbers), law);
  });
}

void contact_resultants(const Model<2>& model, const Work<2>& work, std::vector<TouchingContact>& out) {
  out.clear();
  // The resultants of general contacts are in the list of this evaluation; their memory does not contain the force.
  const auto append = [&](int row, const ContactResultant& r) {
    const NearPair& p = work.pairs[row];
    const double mu = std::visit([](const auto& law) { return law.mu; }, model.laws[p.law]);
    out.push_back(
        {row, model.piece_body[p.piece_a], model.piece_body[p.piece_b], r, hold_of(work.contacts.memory[row], r, mu)});
  };
  std::size_t general = 0;  // both lists are sorted by row
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    const ContactMemory& memory = work.contacts.memory[row];
    if ((memory.state & contact_touching) == 0) continue;
    const NearPair& p = work.pairs[row];
    if ((memory.state & contact_general) == 0) {
      append(row, face_resultant(model, work, p, memory, work.contacts.law_numbers(row)));
      continue;
    }
    while (general < work.general_touching.size() && work.general_touching[general].row < row) ++general;
    if (general == work.general_touching.size()) continue;
    const GeneralContact<2>& g = work.general_touching[general];
    if (g.row == row) append(row, general_resultant(g.centre, g.force, memory));
  }
}

}  // namespace trilith
