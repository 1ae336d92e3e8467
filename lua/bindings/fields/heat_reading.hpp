// Readers of the keys of fields.
#pragma once

#include <string>
#include <vector>

#include "bindings/core/keys.hpp"
#include "bindings/model/simulated_model.hpp"
#include "field/field.hpp"
#include "model/field/heat.hpp"

namespace trilith::script {

/// Fields change the model and the rows of the state between stages. Ends the reading of keys, so that a wrong key is
/// reported first, and builds the model with all bodies added so far. `what`: the field, for the message.
void finish_between_stages(Keys& keys, ScriptModel& m, const char* what);

/// A number, or { {time, value}, ..., period = } with times from `clock` on [s].
FieldCourse read_course(Keys& keys, const char* key, double clock);

/// The values of the field of heat; nullptr before the first process.
template <int D>
const FieldState* heat_values(const SimulatedModel<D>& m) {
  const Simulation<D>* s = m.if_built();
  const int row = s == nullptr ? -1 : row_of(s->model().fields, FieldKind::heat);
  const auto at = static_cast<std::size_t>(row);
  return row < 0 || at >= s->state().fields.size() ? nullptr : &s->state().fields[at];
}

/// The clock of the field of heat [s].
template <int D>
double heat_clock(const SimulatedModel<D>& m) {
  const FieldState* values = heat_values(m);
  return values == nullptr ? 0 : values->clock;
}

/// The field of heat, or InputError, beginning with `owner`.
template <int D>
const Field& require_heat(const Model<D>& model, const std::string& owner) {
  for (const auto& field : model.fields)
    if (field->kind == FieldKind::heat) return *field;
  throw InputError(owner + ": no body has thermal properties; declare m:heat first");
}

/// The bodies that a body has become by cracks: itself if it is whole.
std::vector<int> parts_of(const ScriptModel& m, int body);

/// Temperature of bodies, the mean by heat capacity, or of a body at a point at the start; `difference`: upper less
/// lower face of the sections of a frame.
struct BodyTemperature {
  double value = 0, lowest = 0, highest = 0, difference = 0;
};
BodyTemperature temperature_of(const FieldValues& heat, const std::vector<int>& bodies, const std::string& owner);
BodyTemperature temperature_of(const Model<2>& model, const FieldValues& heat, int body, const Vec2& at,
                               const std::string& owner);
BodyTemperature temperature_of(const Model<3>& model, const FieldValues& heat, int body, const Vec3& at,
                               const std::string& owner);

}  // namespace trilith::script
