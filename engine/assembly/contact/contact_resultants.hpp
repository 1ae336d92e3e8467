// Resultants of the touching contacts at this instant, for recordings and scripts.
#pragma once

#include <vector>

#include "contact/joint/face_resultant.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// State of a contact: bonded, sticking (friction not exhausted), or sliding.
enum class ContactHold { bonded, sticking, sliding };

struct TouchingContact {
  int row;             ///< index in Work::pairs
  int body_a, body_b;  ///< the force acts on body_b, the opposite on body_a
  ContactResultant resultant;
  ContactHold hold;
};

/// Lists every touching contact, in the order of Work::pairs. `work` must be evaluated at the present instant. `out` is
/// overwritten; its memory is reused.
void contact_resultants(const Model<2>& model, const State<2>& state, const Work<2>& work,
                        std::vector<TouchingContact>& out);

/// Resultant of two faces with the contact memory `memory` and the law memory `law_numbers`.
ContactResultant face_resultant(const Model<2>& model, const Work<2>& work, const NearPair& pair,
                                const ContactMemory& memory, const double* law_numbers);

}  // namespace trilith
