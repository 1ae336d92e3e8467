// Rows of polyhedra whose faces may lie flat: transfer of four rows to the lanes of their kernel
// (contact/space/flat_contact.hpp) and back.
#pragma once

#include <array>
#include <cstddef>

#include "base/simd/lane_vectors.hpp"
#include "contact/space/flat_contact.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Destinations of the results of four rows. Lanes without a row, or without contact, write to a scratch location.
struct FlatPlaces {
  std::array<double*, lane_count> answer, memory, area;

  /// Sets all destinations to `nowhere`, which is large enough for any.
  explicit FlatPlaces(std::array<double, 20>& nowhere) {
    answer.fill(nowhere.data()), memory.fill(nowhere.data()), area.fill(nowhere.data());
  }
  /// Sets the destinations of a row that touches. Data common to all touching rows are written at once.
  void set(std::size_t lane, SolidAnswer& to, SolidMemory& remembered, ContactArea& lies) {
    answer[lane] = &to.area, memory[lane] = remembered.shear.elastic.data(), area[lane] = lies.middle.data();
    remembered.state = contact_touching | contact_general;
    lies.face_a = lies.face_b = -1;
  }
};

/// Writes the results of four rows from lanes to their destinations.
void store_flat(const FlatResponses& out, const FlatPlaces& to);

/// Loads motion, memory and law of four rows, in a step of `dt` [s]. The nodes of their pairs of faces are known.
void load_contacts(const State<3>& state, const Work<3>& work, const std::array<int, lane_count>& row, double dt,
                   ContactsInLanes& in);

/// Loads all inputs of the kernel for flat faces for four rows, in a step of `dt` [s].
void load_flat(const State<3>& state, const Work<3>& work, const std::array<int, lane_count>& row, double dt,
               FlatContacts& in);

}  // namespace trilith
