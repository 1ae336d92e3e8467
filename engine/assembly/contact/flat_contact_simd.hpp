// Rows of solids whose faces may lie flat, four into the lanes of their kernel (contact/space/flat_contact.hpp) and out
// again.
#pragma once

#include <array>
#include <cstddef>

#include "base/simd/lane_vectors.hpp"
#include "contact/space/flat_contact.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Where what four rows came to goes; of a lane that is no row, or does not touch, to a place that nobody reads.
struct FlatPlaces {
  std::array<double*, lane_count> answer, memory, area;

  /// All of them `nowhere`, which has room for any.
  explicit FlatPlaces(std::array<double, 20>& nowhere) {
    answer.fill(nowhere.data()), memory.fill(nowhere.data()), area.fill(nowhere.data());
  }
  /// Of one that touches. What is the same of all such is written at once.
  void set(std::size_t lane, SolidAnswer& to, SolidMemory& remembered, ContactArea& lies) {
    answer[lane] = &to.area, memory[lane] = remembered.shear.elastic.data(), area[lane] = lies.middle.data();
    remembered.state = contact_touching | contact_general;
    lies.face_a = lies.face_b = -1;
  }
};

/// What four rows came to, out of lanes.
void store_flat(const FlatResponses& out, const FlatPlaces& to);

/// All that the kernel of flat faces asks of four rows, in a step of `dt` [s].
void load_flat(const State<3>& state, const Work<3>& work, const std::array<int, lane_count>& row, double dt,
               FlatContacts& in);

}  // namespace trilith
