// Evaluation of the rows of contacts in space: one by one, or by the kernels of four
// (contact/space/flat_contact.hpp, contact/space/pressed_contact.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "assembly/contact/flat_contact_simd.hpp"
#include "assembly/contact/pressed_rows.hpp"
#include "assembly/contact/rows_by_kind.hpp"
#include "contact/space/solid_contact.hpp"
#include "model/work.hpp"

namespace trilith {

/// Rows per chunk of a thread, about 20 microseconds if they touch. A chunk of this size usually contains four rows of
/// a kind (FlatResponses::kind) and four more.
inline constexpr int solid_row_stretch = 64;
static_assert(solid_row_stretch <= RowsByKind::most);
/// Marks of an answer: the row is left to the kernel of flat faces, or to the kernel of pressed triangles.
inline constexpr int faces_to_come = -2, triangles_to_come = -3;

/// Outcome of the fast methods for a row: not applicable; tried in vain; an answer, or the mark of one to come.
enum class FastResponse { unfit, failed, given };

/// Input of the rows of one evaluation. Each row writes its own data alone, and `room`.
struct SolidPass {
  const Model<3>& model;
  const State<3>& state;
  Work<3>& work;
  double dt;

  void respond(int first, int last, SolidRoom& room, SolidAnswer* answers) const;

 private:
  void respond_bonded(int row, const JointMemory& before, SolidRoom& room, SolidAnswer& answer) const;
  void respond_alone(int row, SolidRoom& room, PressedRows& pressed, SolidAnswer& answer) const;
  void respond_other(int row, bool may_be_flat, SolidRoom& room, PressedRows& pressed, SolidAnswer& answer) const;
  void respond_shapes(int row, bool may_be_flat, bool by_edges, SolidRoom& room, SolidAnswer& answer) const;
  void respond_pressure(int row, const MovingSolid& a, const MovingSolid& b, const LawInUse& law,
                        const SolidPressure& pressed, SolidRoom& room, SolidAnswer& answer,
                        const std::array<int, 2>& sides = {-1, -1}) const;
  void respond_beside_bearing(int row, const MovingSolid& a, const MovingSolid& b, const SolidPressure& whole,
                              SolidRoom& room, SolidAnswer& answer) const;
  void face_contact_forces(std::span<const int> rows, int first, SolidRoom& room, PressedRows& pressed,
                           SolidAnswer* answers) const;
  void pressed_contact_forces(PressedRows& pressed, int first, SolidRoom& room, SolidAnswer* answers) const;
  void take_four(const FlatResponses& out, std::span<const int> rows, int first, SolidAnswer* answers) const;
  FastResponse respond_fast(int row, bool may_be_flat, SolidRoom& room, PressedRows& pressed,
                            SolidAnswer& answer) const;
  [[nodiscard]] bool fits_lanes(const NearPair& pair) const;
  void begin_answer(const FlatResponses& out, std::size_t i, int row, SolidAnswer& answer, FlatPlaces& places) const;
  void ask_early(int row) const;
  [[nodiscard]] bool stays_apart(int row) const;
  [[nodiscard]] bool looks_flat(int row) const;
  [[nodiscard]] bool is_flat_still(std::size_t row, const Contacts<3>& before) const;
  void finish(int row, bool joint_changed, const SolidResponse& response, SolidAnswer& answer) const;
};

}  // namespace trilith
