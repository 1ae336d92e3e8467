// Beams of frames: what the motion of their nodes makes of them.
#pragma once

#include <span>

#include "body/beam_element.hpp"
#include "body/beam_element_3d.hpp"
#include "world/work.hpp"

namespace trilith {

/// Energies of deformable bodies, summed in the order of their elements.
struct ResistSums {
  double stored = 0;   ///< [J]
  double plastic = 0;  ///< given off in this step [J]
};

/// Adds to the forces and dampings on the nodes, and writes the trial memories of beams that yield or are damped over a
/// band, of a step of `dt` [s].
void resist_beams(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, ResistSums& sums);

/// The same of a frame in space; `work` has its arrays.
void resist_beams(const Model<3>& model, const State<3>& state, Work<3>& work, ResistSums& sums);

/// True where the beam is gone for good.
bool is_removed(const Model<2>& model, const Beam& beam, std::span<const double> memories);

/// Normal force and end moments of a beam at a state that has been committed, without damping.
BeamStress beam_stress(const Model<2>& model, const State<2>& state, const Beam& beam, const BeamNow& now);

/// Of a beam in space likewise.
BeamStress3 beam_stress(const Model<3>& model, const State<3>& state, const Beam3& beam, const BeamNow3& now);

/// What the branches of a beam's damping over a band remember.
template <class Number>
std::span<Number> branches_of(const Model<2>& model, const Beam& beam, std::span<Number> memories) {
  return memories.subspan(beam.first_branch, model.bands[beam.band].memory_size());
}

/// What a beam that yields remembers.
template <class Number>
std::span<Number> memory_of(const Model<2>& model, const Beam& beam, std::span<Number> memories) {
  return memories.subspan(beam.first_memory, memory_size(model.yields, beam));
}
template <class Number>
std::span<Number> memory_of(const Model<3>& model, const Beam3& beam, std::span<Number> memories) {
  return memories.subspan(static_cast<std::size_t>(beam.first_memory),
                          static_cast<std::size_t>(memory_size(model.yields_3d, beam)));
}

}  // namespace trilith
