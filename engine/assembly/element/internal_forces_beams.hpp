// Internal forces of beams from the motion of their nodes.
#pragma once

#include <algorithm>
#include <span>

#include "element/beam/beam_element.hpp"
#include "element/beam/beam_element_3d.hpp"
#include "model/work.hpp"

namespace trilith {

/// Adds the forces and damping forces on the nodes, and writes the trial memories of beams that yield or have band
/// damping, for a step of `dt` [s].
void resist_beams(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, ElementEnergy& sums);

/// Adds the forces of a frame in space; the arrays of `work` are allocated.
void resist_beams(const Model<3>& model, const State<3>& state, Work<3>& work, double dt, ElementEnergy& sums);

/// True if the beam is removed permanently.
bool is_removed(const Model<2>& model, const Beam& beam, std::span<const double> memories);
bool is_removed(const Model<3>& model, const Beam3& beam, std::span<const double> memories);

/// Normal force and end moments of a beam at a committed state, without damping.
BeamStress beam_stress(const Model<2>& model, const State<2>& state, const Beam& beam, const BeamNow& now);

/// Section forces of a beam in space at a committed state, without damping.
BeamStress3 beam_stress(const Model<3>& model, const State<3>& state, const Beam3& beam, const BeamNow3& now);

/// Memory of the branches of a beam's band damping.
template <class Number>
std::span<Number> branches_of(const Model<2>& model, const Beam& beam, std::span<Number> memories) {
  return memories.subspan(beam.first_branch, model.bands[beam.band].memory_size());
}

template <class Number>
std::span<Number> branches_of(const Model<3>& model, const Beam3& beam, std::span<Number> memories) {
  return memories.subspan(static_cast<std::size_t>(beam.first_branch),
                          static_cast<std::size_t>(model.bands[static_cast<std::size_t>(beam.band)].memory_size(
                              static_cast<int>(BeamStress3{}.size()))));
}

/// Band damping: its branches over a step, computed once for all beams that share them.
template <int D>
class BandRelaxation {
 public:
  BandRelaxation(const Model<D>& model, const State<D>& state, Work<D>& work, double dt)
      : model_(model), before_(state.beam_memory), after_(work.beam_memory), dt_(dt) {}

  template <class SomeBeam, class Stress>
  Stress damping(const SomeBeam& beam, const Stress& stress) {
    const DampingBranches& branches = model_.bands[beam.band];
    if (beam.band != band_) step_ = BranchStep(branches, dt_);
    band_ = beam.band;
    const std::span<double> after = branches_of(model_, beam, after_);
    if (is_removed(model_, beam, after_)) {
      std::ranges::fill(after, 0);
      return {};
    }
    return relax(branches, step_, stress, branches_of(model_, beam, before_), after);
  }

 private:
  const Model<D>& model_;
  std::span<const double> before_;
  std::span<double> after_;
  double dt_;
  int band_ = -1;
  BranchStep step_;
};

/// Memory of a beam that yields.
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
