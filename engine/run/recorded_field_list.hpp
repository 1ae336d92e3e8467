// What a recording adds to each frame of joints and bodies: a new one is its own file and a row here.
#pragma once

#include <concepts>
#include <string_view>
#include <vector>

#include "base/schema.hpp"
#include "run/body_stress_field.hpp"
#include "run/field_source.hpp"
#include "run/joint_fields.hpp"

namespace trilith {

template <int D>
struct RecordedFieldsOf;
template <>
struct RecordedFieldsOf<2> {
  using Types = TypeList<JointOpening, JointSlip, JointDamage, BodyStress>;
};
/// Stress of bodies that deform is beside them: run/space_stress_field.hpp.
template <>
struct RecordedFieldsOf<3> {
  using Types = TypeList<JointOpening, JointSlip, JointDamage>;
};

/// What each is asked: /frames/`name` has `width` numbers [`unit`] for each joint or body, which `take` appends.
template <class F, int D>
concept RecordedFieldType = requires(const FieldSource<D>& from, std::vector<double>& out) {
  { F::name } -> std::convertible_to<std::string_view>;
  { F::unit } -> std::convertible_to<std::string_view>;
  { F::sentence } -> std::convertible_to<std::string_view>;
  { F::rows } -> std::convertible_to<RowsOf>;
  { F::width } -> std::convertible_to<int>;
  F::take(from, out);
};
static_assert(RecordedFieldsOf<2>::Types::all([]<class F>() { return RecordedFieldType<F, 2>; }));
static_assert(RecordedFieldsOf<3>::Types::all([]<class F>() { return RecordedFieldType<F, 3>; }));

}  // namespace trilith
