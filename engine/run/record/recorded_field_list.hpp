// List of the fields of joints and bodies in each frame. A new field is a file and a row here.
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/schema.hpp"
#include "run/record/body_stress_field.hpp"
#include "run/record/field_source.hpp"
#include "run/record/joint_fields.hpp"

namespace trilith {

/// Fields in the plane.
using RecordedFieldTypes = TypeList<JointOpening, JointSlip, JointDamage, BodyStress>;
/// Fields in space. The stress of deformable bodies is separate: run/record/space_stress_field.hpp.
using SpaceFieldTypes = TypeList<JointOpening, JointSlip, JointDamage>;

template <int D>
using RecordedFieldsOf = std::conditional_t<D == 2, RecordedFieldTypes, SpaceFieldTypes>;

/// Requirements of a field: /frames/`name` has `width` numbers [`unit`] for each joint or body, which `take` appends.
template <class F, int D>
concept RecordedFieldType = requires(const FieldSource<D>& from, std::vector<double>& out) {
  { F::name } -> std::convertible_to<std::string_view>;
  { F::unit } -> std::convertible_to<std::string_view>;
  { F::sentence } -> std::convertible_to<std::string_view>;
  { F::rows } -> std::convertible_to<RowsOf>;
  { F::width } -> std::convertible_to<int>;
  F::take(from, out);
};
static_assert(RecordedFieldTypes::all([]<class F>() { return RecordedFieldType<F, 2>; }));
static_assert(SpaceFieldTypes::all([]<class F>() { return RecordedFieldType<F, 3>; }));

}  // namespace trilith
