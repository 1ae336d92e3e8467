// Contacts of bodies that split: each goes to the part that holds it, with its memory.
#pragma once

#include <optional>
#include <vector>

#include "edit/crack_search.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// The contact of two pieces with its memory, apart from the rows of a state.
struct ContactRecord {
  int piece_a = -1, piece_b = -1;
  int a0 = -1, a1 = -1, b0 = -1, b1 = -1;  ///< skin points of the two faces of a face contact
  bool general = false;                    ///< found by overlap, not as two faces
  std::optional<Vec2> place = {};          ///< of a general contact that touches [m]
  ContactMemory memory = {};
  std::uint32_t law = 0;             ///< place of the law in ContactLaws
  std::vector<double> numbers = {};  ///< memory of the law
};

/// The two parts of a body that has split, in the grown model.
struct SplitBody {
  int body = -1;                ///< the body that has split
  int behind = -1, ahead = -1;  ///< its parts
};

/// Records of all contacts with a memory, before the model grows. `work` must be evaluated, and committed in `state`.
std::vector<ContactRecord> contact_records(const Model<2>& model, const State<2>& state, const Work<2>& work);

/// The contact of both parts across the section of their crack, if its law softens: a whole bond over their opening
/// (see with_cracks), with the shear of the section. None for a brittle law, whose parts begin without bond.
std::optional<ContactRecord> crack_contact(const Model<2>& model, const State<2>& state, const SplitBody& split,
                                           const CrackingBody<2>& row, const Crack<2>& crack);

/// Gives the contacts of a body that has split to its parts. `model` and `state` contain the parts in their positions.
/// A contact that spans the plane becomes two, which share its forces in proportion to their lengths.
std::vector<ContactRecord> handed_over(const Model<2>& model, const State<2>& state,
                                       const std::vector<ContactRecord>& records, const SplitBody& split);

/// Puts the pieces of a record in their order, lower index first.
ContactRecord ordered(ContactRecord record);

/// Writes all records to the state, in the order of their pieces.
void put_contacts(State<2>& state, std::vector<ContactRecord> records);

}  // namespace trilith
