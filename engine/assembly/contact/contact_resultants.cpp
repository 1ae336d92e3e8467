#include "assembly/contact/contact_resultants.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/contact/contact_rows.hpp"

namespace trilith {
namespace {

/// Friction that a contact holds at most, by its law at its pressure and slip rate [N].
double friction_of(const Model<2>& model, const State<2>& state, const Work<2>& work, int row,
                   const ContactResultant& r) {
  const NearPair& p = work.pairs[row];
  const ContactMemory& memory = work.contacts.memory[row];
  return with_kernel(law_in_use(model, p.law), [&]<class K>(const K& law) {
    if ((memory.state & contact_general) == 0)
      return face_friction(face_ends(work, p.a0, p.a1), face_ends(work, p.b0, p.b1), r.normal, law);
    return friction_limit_of(law, r.normal, (memory.active[0] + memory.active[1]) * model.thickness, [&] {
      PieceCorners a, b;
      const Vec2 slip = placed_piece(model, state, work, p.piece_b, b).velocity_at(r.point) -
                        placed_piece(model, state, work, p.piece_a, a).velocity_at(r.point);
      const Vec2 normal = r.force - r.shear * left_of(r.force).normalized();
      return std::abs(left_of(normal).normalized().dot(slip));
    });
  });
}

/// Bonded if one of both halves is bonded; otherwise the shear is compared with the friction limit.
ContactHold hold_of(const Model<2>& model, const State<2>& state, const Work<2>& work, int row,
                    const ContactResultant& r) {
  if (work.contacts.memory[row].bonds != 0) return ContactHold::bonded;
  // Sliding shear equals the limit, up to rounding.
  const double limit = (1 - 1e-9) * friction_of(model, state, work, row, r);
  return std::abs(r.shear) >= limit ? ContactHold::sliding : ContactHold::sticking;
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

void contact_resultants(const Model<2>& model, const State<2>& state, const Work<2>& work,
                        std::vector<TouchingContact>& out) {
  out.clear();
  // The resultants of general contacts are in the list of this evaluation; their memory does not contain the force.
  const auto append = [&](int row, const ContactResultant& r) {
    const NearPair& p = work.pairs[row];
    out.push_back(
        {row, model.piece_body[p.piece_a], model.piece_body[p.piece_b], r, hold_of(model, state, work, row, r)});
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
