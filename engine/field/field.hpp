// A scalar field on a graph of cells.
//
//     C_i d phi_i / dt + sum over links C_ij (d phi_j / dt - d phi_i / dt)
//         = sum over links K_ij (phi_j - phi_i) + sum over surroundings K_io (phi_o(t) - phi_i)
//
// The couplings C_ij are half of the entries of the consistent capacity matrix: the mean of the lumped and the
// consistent one has a smaller error than either. They are 0 between bodies and in frames. C_i is the whole capacity of
// a cell, so the content is the sum of C_i phi_i.
//
// A cell is a rigid body, a node of a mesh, or a face of a section of a frame at one of its nodes. The conduction of
// finite elements is a set of links too, because the rows of its matrix add up to 0; a link of a distorted element may
// be negative. Links across contacts follow from their present area and are not part of this structure
// (assembly/field/contact_links.hpp). Conduction: Carslaw and Jaeger, "Conduction of heat in solids", 2nd ed., 1959.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "field/course.hpp"
#include "field/field_kind.hpp"
#include "field/field_state.hpp"
#include "field/joint_flow.hpp"

namespace trilith {

/// A link between two cells.
struct FieldLink {
  int a = -1, b = -1;      ///< a < b
  double conductance = 0;  ///< K_ab [W/K]
  double capacity = 0;     ///< C_ab [J/K]

  friend bool operator==(const FieldLink&, const FieldLink&) = default;
};

/// Sorts links by their cells and adds up those between the same cells.
void merge_links(std::vector<FieldLink>& links);

/// A surrounding: air, ground, or a given temperature.
struct FieldSurrounding {
  std::string name;
  FieldCourse course;
};

/// Exchange of a cell with a surrounding.
struct FieldExchange {
  int cell = -1, surrounding = -1;
  double conductance = 0;  ///< [W/K]
};

/// A cell that has the value of a surrounding.
struct FieldHeld {
  int cell = -1, surrounding = -1;
};

/// The cells of a body.
enum class CellLayout : std::uint8_t {
  one,       ///< a rigid body has one cell
  nodes,     ///< each node of a mesh is a cell
  sections,  ///< each node of a frame has two: at the lower and at the upper face of its sections
};

/// A body with cells, and its material.
struct FieldBody {
  int body = -1;
  CellLayout layout = CellLayout::one;
  int first_node = 0;  ///< of the body
  int first_cell = 0, cells = 0;
  double conductivity = 0;   ///< [W/(m K)]
  double heat_capacity = 0;  ///< of its mass [J/(kg K)]
  double expansion = 0;      ///< [1/K]
  double reference = 0;      ///< temperature without thermal strain [degC]
  double depth = 0;          ///< of the sections of a frame [m]
  double width = 0;          ///< of the sections of a frame, their mean area over the depth [m]

  /// The cell of a node; of a frame, its lower (0) or upper (1) face.
  [[nodiscard]] int cell_of(int node, int face = 0) const {
    if (layout == CellLayout::one) return first_cell;
    const int at = node - first_node;
    return first_cell + (layout == CellLayout::nodes ? at : 2 * at + face);
  }
};

/// Conductance of contacts [W/(m2 K)] between two bodies; -1: any.
struct ContactConductance {
  int body_a = -1, body_b = -1;
  double conductance = 0;
};

inline constexpr int most_cells_of_element = 10;

/// An element that expands. Its deformation without stress is linear in its temperatures: d = S (T - reference).
struct FreeShape {
  int nodes = 0, dofs = 0;
  std::array<int, most_cells_of_element> cell{};
  double reference = 0;  ///< [degC]
  double expansion = 0;  ///< [1/K]
  int first_number = 0;  ///< in Field::free_number: S by columns, `dofs` numbers for each node [m/K]
};

/// A beam that expands.
struct FreeBeam {
  std::array<int, 2> lower{}, upper{};  ///< cells at both ends
  double reference = 0;                 ///< [degC]
  double expansion = 0;                 ///< [1/K]
  double depth = 0, length = 0;         ///< [m]
};

/// Stretch of a beam [m] and bends of its ends in the plane of its depth [rad], without stress.
struct FreeStrain {
  double stretch = 0;
  std::array<double, 2> bend{};
};

/// The faces of bodies at which cells exchange with surroundings, or have their values: HeatFaces in
/// model/field/heat.hpp.
struct FieldFaces {};

struct Field {
  FieldKind kind = FieldKind::heat;
  std::vector<double> capacity;  ///< [cell] [J/K]
  std::vector<double> start;     ///< [cell] value at the start [degC]
  std::vector<FieldLink> links;  ///< inside bodies, merged
  std::vector<FieldSurrounding> surroundings;
  std::vector<FieldExchange> exchange;
  std::vector<FieldHeld> held;
  std::shared_ptr<const FieldFaces> faces;  ///< of `exchange` and `held`, by which a body that cracks divides them
  std::vector<FieldBody> bodies;
  std::vector<int> row_of;                   ///< [body of the model] row of bodies; -1, or beyond the end: none
  std::vector<ContactConductance> contacts;  ///< a later row overrides an earlier one
  std::vector<int> free_shape_of;            ///< [element of the model] row of free_shapes; -1, or beyond the end: none
  std::vector<FreeShape> free_shapes;
  std::vector<double> free_number;
  std::vector<int> free_beam_of;  ///< [beam of the model] row of free_beams; -1, or beyond the end: none
  std::vector<FreeBeam> free_beams;
  std::shared_ptr<const JointFlow> flow;  ///< of water in joints; its cells have two values each, see JointFlow::cells
  int friction = -1;  ///< row of surroundings that counts the heat of friction; -1: friction heats no body

  [[nodiscard]] int cells() const { return static_cast<int>(capacity.size()); }
  /// The row of a body, or nullptr without cells.
  [[nodiscard]] const FieldBody* find(int body) const {
    const auto i = static_cast<std::size_t>(body);
    return i < row_of.size() && row_of[i] >= 0 ? &bodies[static_cast<std::size_t>(row_of[i])] : nullptr;
  }
  /// Conductance of the contacts between two bodies [W/(m2 K)].
  [[nodiscard]] double conductance_between(int body_a, int body_b) const;
  [[nodiscard]] bool expands() const { return !free_shapes.empty() || !free_beams.empty(); }
  /// Digest of all data above.
  [[nodiscard]] std::uint64_t digest() const;
};

/// A field with its values at an instant; false without a field.
class FieldValues {
 public:
  FieldValues() = default;
  /// `state`: may be shorter than the field, or nullptr; cells that it lacks have their value at the start.
  FieldValues(const Field* field, const FieldState* state) : field_(field), state_(state) {}

  explicit operator bool() const { return field_ != nullptr; }
  [[nodiscard]] const Field& field() const { return *field_; }
  [[nodiscard]] double at(int cell) const {
    const auto i = static_cast<std::size_t>(cell);
    return state_ != nullptr && i < state_->value.size() ? state_->value[i] : field_->start[i];
  }
  /// The row of an element that expands, or nullptr.
  [[nodiscard]] const FreeShape* shape_of(std::size_t element) const {
    if (field_ == nullptr || element >= field_->free_shape_of.size() || field_->free_shape_of[element] < 0)
      return nullptr;
    return &field_->free_shapes[static_cast<std::size_t>(field_->free_shape_of[element])];
  }
  /// Subtracts the deformation without stress from the deformation `d` of an element.
  void subtract_free(const FreeShape& shape, double* d) const;
  /// Mean of its temperatures less the reference [K].
  [[nodiscard]] double mean_rise(const FreeShape& shape) const;
  [[nodiscard]] const FreeBeam* beam_of(std::size_t beam) const {
    if (field_ == nullptr || beam >= field_->free_beam_of.size() || field_->free_beam_of[beam] < 0) return nullptr;
    return &field_->free_beams[static_cast<std::size_t>(field_->free_beam_of[beam])];
  }
  [[nodiscard]] FreeStrain strain_of(const FreeBeam& beam) const;

 private:
  const Field* field_ = nullptr;
  const FieldState* state_ = nullptr;
};

/// Fields of a model. Row i has its values in row i of State::fields.
using Fields = std::vector<std::shared_ptr<const Field>>;

/// Row of the field of a kind; -1: none.
int row_of(const Fields& fields, FieldKind kind);
/// The field of a kind, or nullptr.
std::shared_ptr<const Field> field_of(const Fields& fields, FieldKind kind);
/// Replaces the field of the same kind, or adds it.
void set_field(Fields& fields, Field field);
/// The field of a kind with its values, or none.
FieldValues values_of(const Fields& fields, const std::vector<FieldState>& states, FieldKind kind);

}  // namespace trilith
