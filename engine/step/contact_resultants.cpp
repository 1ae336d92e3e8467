#include "step/contact_resultants.hpp"

#include <algorithm>
#include <cmath>

#include "step/contact_rows.hpp"

namespace trilith {
namespace {

ContactHold hold_of(const ContactMemory& memory, const ContactResultant& r, double mu) {
  if (memory.bonds != 0) return ContactHold::bonded;
  // Sliding shear stands at the limit, up to rounding.
  return std::abs(r.shear) >= (1 - 1e-9) * mu * r.normal ? ContactHold::sliding : ContactHold::sticking;
}

}  // namespace

void contact_resultants(const Model<2>& model, const Work<2>& work, std::vector<TouchingContact>& out) {
  out.clear();
  const auto append = [&](int row, const ContactResultant& r, double mu) {
    const NearPair& p = work.pairs[row];
    out.push_back({row, model.piece_body[p.piece_a], model.piece_body[p.piece_b], r, hold_of(work.memory[row], r, mu)});
  };
  std::size_t general = 0;  // both lists rise with the row
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    const ContactMemory& memory = work.memory[row];
    if ((memory.state & contact_touching) == 0) continue;
    const NearPair& p = work.pairs[row];
    const FaceLaw law = face_law(model, p.law, 0);
    if ((memory.state & contact_general) == 0) {
      append(row, face_resultant(face_ends(work, p.a0, p.a1), face_ends(work, p.b0, p.b1), memory, law), law.mu);
      continue;
    }
    while (general < work.general_touching.size() && work.general_touching[general].row < row) ++general;
    if (general == work.general_touching.size()) continue;
    const GeneralContact& g = work.general_touching[general];
    if (g.row == row) append(row, general_resultant(g.centre, g.force, memory), law.mu);
  }
}

}  // namespace trilith
