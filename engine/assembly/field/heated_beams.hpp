// Thermal strain of beams.
#pragma once

#include <optional>

#include "element/beam/beam_element_3d.hpp"
#include "field/field.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// The strain of a beam without stress; none without expansion. `beam`: an element of the model's array.
template <int D, class SomeBeam>
std::optional<FreeStrain> free_strain(const Model<D>& model, const State<D>& state, const SomeBeam& beam) {
  if (model.fields.empty()) return std::nullopt;
  const FieldValues heat = values_of(model.fields, state.fields, FieldKind::heat);
  const FreeBeam* row = heat.beam_of(static_cast<std::size_t>(&beam - beams_of(model).data()));
  return row == nullptr ? std::nullopt : std::optional(heat.strain_of(*row));
}

/// Subtracts it from the strain of a beam in its present position; the stress follows from the rest. The second-order
/// term of the bow then contains the bends less the free ones.
inline void relax_heated(const Model<2>& model, const State<2>& state, const Beam& beam, BeamNow& now) {
  if (const auto free = free_strain(model, state, beam))
    now.strain[0] -= free->stretch, now.strain[1] -= free->bend[0], now.strain[2] -= free->bend[1];
}
inline void relax_heated(const Model<3>& model, const State<3>& state, const Beam3& beam, BeamNow3& now) {
  if (const auto free = free_strain(model, state, beam)) now.subtract_free(free->stretch, free->bend);
}

}  // namespace trilith
