#include "events/beam_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/internal_forces_beams.hpp"
#include "base/portable.hpp"

namespace trilith {
namespace {

double length_of(const Model<2>& model, int beam) {
  return model.beams[static_cast<std::size_t>(beam)].length;
}
double length_of(const Model<3>& model, int beam) {
  return model.beams_3d[static_cast<std::size_t>(beam)].length;
}

/// "column 1 at a"; for a beam within a member, with its distance from the start of the member.
template <int D>
std::string place_text(const Model<D>& model, const Member& m, int beam, int end) {
  const std::string member = m.name == model.bodies[m.body].name ? "" : m.name + " ";
  if (end == 0 && beam == m.first_beam) return fmt::format("{}at {}", member, m.joint[0]);
  if (end == 1 && beam + 1 == m.first_beam + m.beams) return fmt::format("{}at {}", member, m.joint[1]);
  double along = 0;
  for (int i = m.first_beam; i < beam; ++i) along += length_of(model, i);
  return fmt::format("{}{:.3g} m from {}", member, along, m.joint[0]);
}

/// Moment at an end of a beam; for a fibre beam, the larger moment of both ends [N m].
double moment_at(const Model<2>& model, const State<2>& state, const Work<2>& work, const Beam& beam, int end) {
  const std::span after = memory_of(model, beam, std::span<const double>(work.beam_memory));
  if (beam.yield == BeamYield::at_hinges) return std::abs(hinge_memory(after).moment[end]);
  const BeamStress stress = beam_stress(model, state, beam, now_of(state, beam));
  return std::max(std::abs(stress[1]), std::abs(stress[2]));
}
double moment_at(const Model<3>& model, const State<3>& state, const Work<3>& work, const Beam3& beam, int end) {
  const std::span after = memory_of(model, beam, std::span<const double>(work.beam_memory));
  if (beam.yield == BeamYield::at_hinges) {
    const auto m = space_hinge_memory(after).moment[static_cast<std::size_t>(end)];
    return portable::hypot(m[0], m[1]);
  }
  const BeamStress3 stress = beam_stress(model, state, beam, now_of(state, beam));
  return std::max(portable::hypot(stress[1], stress[2]), portable::hypot(stress[3], stress[4]));
}

/// Memory of the hinges at the ends of a beam.
EndHingeMemory memory_of_hinges(const Beam& /*beam*/, std::span<const double> memory) {
  return hinge_memory(memory);
}
EndHingeMemory3 memory_of_hinges(const Beam3& /*beam*/, std::span<const double> memory) {
  return space_hinge_memory(memory);
}

Vec2 place_of_end(const State<2>& state, const Beam& beam, int end) {
  Vec2 arm;
  return end_of(state, beam, static_cast<std::size_t>(end), arm).place;
}
Vec3 place_of_end(const State<3>& state, const Beam3& beam, int end) {
  return end_of(state, beam, static_cast<std::size_t>(end)).place;
}

/// Adds an event if the status (elastic, yielded, lost) differs between the trial memory and the committed memory. Its
/// value is the moment at yield, or the rotation at which the hinge is lost.
template <int D, class SomeBeam>
void member_event(const Model<D>& model, const State<D>& state, Work<D>& work, const Member& m, int beam,
                  const SomeBeam& b, int end) {
  const std::span after = memory_of(model, b, std::span<const double>(work.beam_memory));
  const std::span before = memory_of(model, b, std::span<const double>(state.beam_memory));
  const HingeStatus was = yield_status(b, before, end), is = yield_status(b, after, end);
  // A removed beam is reported at the end whose hinge was lost.
  if (was == is || (is == HingeStatus::removed && was != HingeStatus::lost)) return;
  Event e;
  e.time = state.time, e.step = state.step, e.body_a = m.body;
  if (is == HingeStatus::removed) {
    e.type = EventType::member_removed, e.value = held_energy(b.stiffness, memory_of_hinges(b, before));
  } else if (is == HingeStatus::lost) {
    e.type = EventType::member_failed, e.value = memory_of_hinges(b, after).reach[static_cast<std::size_t>(end)];
  } else {
    e.type = EventType::member_yielded, e.value = moment_at(model, state, work, b, end);
  }
  e.set_place(place_of_end(state, b, end));
  e.text = place_text(model, m, beam, end);
  work.events.push_back(std::move(e));
}

bool can_yield(const Model<2>& model, const Beam& beam, int end) {
  if (beam.yield == BeamYield::at_hinges) return has_hinge(model.yields, beam, end);
  return beam.yield == BeamYield::in_fibres;
}
bool can_yield(const Model<3>& model, const Beam3& beam, int end) {
  if (beam.yield == BeamYield::at_hinges) return has_hinge(model.yields_3d, beam, end);
  return beam.yield == BeamYield::in_fibres && end == 0;
}

}  // namespace

/// A fibre beam is reported at its end 0, for the whole beam.
template <int D>
void beam_events(const Model<D>& model, const State<D>& state, Work<D>& work) {
  if (model.beam_memory == 0) return;
  for (const Member& m : model.members)
    for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
      const auto& beam = beams_of(model)[static_cast<std::size_t>(i)];
      for (const int end : {0, 1})
        if (can_yield(model, beam, end)) member_event(model, state, work, m, i, beam, end);
    }
}

template void beam_events(const Model<2>&, const State<2>&, Work<2>&);
template void beam_events(const Model<3>&, const State<3>&, Work<3>&);

}  // namespace trilith
