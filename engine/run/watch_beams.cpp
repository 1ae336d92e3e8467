#include "run/watch_beams.hpp"

#include <algorithm>
#include <array>

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/internal_forces_beams.hpp"

namespace trilith {
namespace {

std::array<Vec2, 2> ends_of(const State<2>& state, const Beam& beam) {
  Vec2 arm;
  return {end_of(state, beam, 0, arm).place, end_of(state, beam, 1, arm).place};
}
std::array<Vec3, 2> ends_of(const State<3>& state, const Beam3& beam) {
  return {end_of(state, beam, 0).place, end_of(state, beam, 1).place};
}

/// True for a beam on rigid arms, whose ends move farther than its nodes if these turn.
bool lies_on_arms(const Beam& beam) {
  return beam.arm[0] != Vec2(0, 0) || beam.arm[1] != Vec2(0, 0);
}
bool lies_on_arms(const Beam3& beam) {
  return has_arm(beam, 0) || has_arm(beam, 1);
}

/// True for a beam that a lost hinge has removed; it no longer connects its ends.
template <int D, class SomeBeam>
bool is_removed(const Model<D>& model, const State<D>& state, const SomeBeam& beam) {
  if (beam.yield != BeamYield::at_hinges) return false;
  const std::span memory = memory_of(model, beam, std::span<const double>(state.beam_memory));
  return yield_status(beam, memory, 0) == HingeStatus::removed || yield_status(beam, memory, 1) == HingeStatus::removed;
}

}  // namespace

/// The beam with the least reserve of axial strain, which is the strain of the line between its ends. Each end may move
/// by half of the remaining elongation.
template <int D>
BeamStretch worst_beam(const Model<D>& model, const State<D>& state) {
  BeamStretch worst;
  double room = unbounded;
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const Member& member = model.members[m];
    if (state.left[static_cast<std::size_t>(member.body)] != 0) continue;
    for (int i = member.first_beam; i < member.first_beam + member.beams; ++i) {
      const auto& beam = beams_of(model)[static_cast<std::size_t>(i)];
      if (is_removed(model, state, beam)) continue;
      const auto ends = ends_of(state, beam);
      const double stretch = (ends[1] - ends[0]).norm() / beam.length;
      const double squeezed = stretch - std::max(0.0, 1 - member.strain_limit),
                   spare = std::min(squeezed, 1 + member.strain_limit - stretch);
      room = std::min(room, lies_on_arms(beam) ? 0 : 0.5 * spare * beam.length);
      if (spare < worst.spare) worst = {static_cast<int>(m), i, stretch - 1, spare, 0};
    }
  }
  worst.room = room;
  return worst;
}

template <int D>
Vec<D> middle_of_beam(const Model<D>& model, const State<D>& state, int beam) {
  const auto ends = ends_of(state, beams_of(model)[static_cast<std::size_t>(beam)]);
  return 0.5 * (ends[0] + ends[1]);
}

template BeamStretch worst_beam(const Model<2>&, const State<2>&);
template BeamStretch worst_beam(const Model<3>&, const State<3>&);
template Vec2 middle_of_beam(const Model<2>&, const State<2>&, int);
template Vec3 middle_of_beam(const Model<3>&, const State<3>&, int);

}  // namespace trilith
