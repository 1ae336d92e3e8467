// The contacts that carry force at this instant, for recording and for scripts.
#pragma once

#include <vector>

#include "contact/joint/face_resultant.hpp"
#include "model/work.hpp"

namespace trilith {

/// How a contact holds: by its bond, by friction not used up, or sliding.
enum class ContactHold { bonded, sticking, sliding };

struct TouchingContact {
  int row;             ///< of Work::pairs
  int body_a, body_b;  ///< force acts on body_b; body_a feels the opposite
  ContactResultant resultant;
  ContactHold hold;
};

/// Every touching contact, in the order of Work::pairs. `work` must hold the evaluation of the present instant.
/// `out` is overwritten; its memory is reused.
void contact_resultants(const Model<2>& model, const Work<2>& work, std::vector<TouchingContact>& out);

/// Of two faces that remember `memory` and, by their law, `law_numbers`.
ContactResultant face_resultant(const Model<2>& model, const Work<2>& work, const NearPair& pair,
                                const ContactMemory& memory, const double* law_numbers);

}  // namespace trilith
