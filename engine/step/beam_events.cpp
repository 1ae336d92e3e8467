#include "step/beam_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/portable.hpp"
#include "step/beam_motion.hpp"
#include "step/resist_beams.hpp"

namespace trilith {
namespace {

double length_of(const Model<2>& model, int beam) {
  return model.beams[static_cast<std::size_t>(beam)].length;
}
double length_of(const Model<3>& model, int beam) {
  return model.beams_3d[static_cast<std::size_t>(beam)].length;
}

/// "column 1 at a"; of beams within a member, how far along they begin.
template <int D>
std::string place_text(const Model<D>& model, const Member& m, int beam, int end) {
  const std::string member = m.name == model.bodies[m.body].name ? "" : m.name + " ";
  if (end == 0 && beam == m.first_beam) return fmt::format("{}at {}", member, m.joint[0]);
  if (end == 1 && beam + 1 == m.first_beam + m.beams) return fmt::format("{}at {}", member, m.joint[1]);
  double along = 0;
  for (int i = m.first_beam; i < beam; ++i) along += length_of(model, i);
  return fmt::format("{}{:.3g} m from {}", member, along, m.joint[0]);
}

/// Moment that the end of a beam carries, or of one of fibres the larger of both [N m].
double moment_at(const Model<2>& model, const State<2>& state, const Work<2>& work, const Beam& beam, int end) {
  const std::span after = memory_of(model, beam, std::span<const double>(work.beam_memory));
  if (beam.yield == BeamYield::at_hinges) return std::abs(hinge_memory(after).moment[end]);
  const BeamStress stress = beam_stress(model, state, beam, now_of(state, beam));
  return std::max(std::abs(stress[1]), std::abs(stress[2]));
}

/// Elastic, yielded, lost: told where the trial's memory says another one than the committed memory. The figure is the
/// moment as it yields, or the rotation at which it is lost.
void member_event(const Model<2>& model, const State<2>& state, Work<2>& work, const Member& m, int beam, int end) {
  const Beam& b = model.beams[beam];
  const std::span after = memory_of(model, b, std::span<const double>(work.beam_memory));
  const HingeStatus was = yield_status(b, memory_of(model, b, std::span<const double>(state.beam_memory)), end);
  const HingeStatus is = yield_status(b, after, end);
  // A beam that goes is told of at the end where its hinge had gone.
  if (was == is || (is == HingeStatus::removed && was != HingeStatus::lost)) return;
  Event e;
  e.time = state.time, e.step = state.step, e.body_a = m.body;
  if (is == HingeStatus::removed) {
    const EndHingeMemory before = hinge_memory(memory_of(model, b, std::span<const double>(state.beam_memory)));
    e.type = EventType::member_removed, e.value = held_energy(b.stiffness, before);
  } else if (is == HingeStatus::lost) {
    e.type = EventType::member_failed, e.value = hinge_memory(after).reach[end];
  } else {
    e.type = EventType::member_yielded, e.value = moment_at(model, state, work, b, end);
  }
  Vec2 arm;
  const Vec2 at = end_of(state, b, static_cast<std::size_t>(end), arm).place;
  e.x = at.x(), e.y = at.y();
  e.text = place_text(model, m, beam, end);
  work.events.push_back(std::move(e));
}

bool can_yield(const Model<2>& model, const Beam& beam, int end) {
  if (beam.yield == BeamYield::at_hinges) return has_hinge(model.yields, beam, end);
  return beam.yield == BeamYield::in_fibres;
}

}  // namespace

void beam_events(const Model<2>& model, const State<2>& state, Work<2>& work) {
  if (model.beam_memory == 0) return;
  for (const Member& m : model.members)
    for (int i = m.first_beam; i < m.first_beam + m.beams; ++i)
      for (const int end : {0, 1})
        if (can_yield(model, model.beams[i], end)) member_event(model, state, work, m, i, end);
}

/// A beam of fibres is told of at its end 0, for all of it.
void beam_events(const Model<3>& model, const State<3>& state, Work<3>& work) {
  if (model.beam_memory == 0) return;
  for (const Member& m : model.members)
    for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
      const Beam3& beam = model.beams_3d[static_cast<std::size_t>(i)];
      if (beam.fibre_row < 0) continue;
      const auto memory = static_cast<std::size_t>(beam.first_memory);
      if (state.beam_memory[memory] != 0 || work.beam_memory[memory] == 0) continue;
      const BeamStress3 stress = beam_stress(model, state, beam, now_of(state, beam));
      Event e;
      e.time = state.time, e.step = state.step, e.body_a = m.body;
      e.type = EventType::member_yielded;
      e.value = std::max(portable::hypot(stress[1], stress[2]), portable::hypot(stress[3], stress[4]));
      e.set_place(state.position[static_cast<std::size_t>(beam.node[0])]);
      e.text = place_text(model, m, i, 0);
      work.events.push_back(std::move(e));
    }
}

}  // namespace trilith
