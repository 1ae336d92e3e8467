// Fields of stages and events in restart files; see base/bytes.hpp.
#pragma once

#include "base/bytes.hpp"
#include "model/event/event.hpp"
#include "run/stage_progress.hpp"

namespace trilith {

template <class File>
void each_field(File& file, Event& e) {
  file.item(e.type), file.item(e.id), file.item(e.cause), file.item(e.time), file.item(e.step);
  file.item(e.body_a), file.item(e.body_b), file.item(e.bearing), file.item(e.value);
  file.item(e.x), file.item(e.y), file.item(e.z), file.item(e.mode), file.item(e.text);
}

template <class File>
void each_field(File& file, ScaledMass& m) {
  file.item(m.bodies), file.item(m.share), file.item(m.most), file.item(m.body);
  file.item(m.before), file.item(m.energy), file.item(m.kinetic);
}

template <class File>
void each_field(File& file, StageReport& r) {
  file.item(r.name), file.item(r.end), file.item(r.begun), file.item(r.ended), file.item(r.steps);
  file.item(r.shortest_dt), file.item(r.longest_dt), file.item(r.speed), file.item(r.ratio);
  file.item(r.threads), file.item(r.thread_gain), file.item(r.scaled);
  file.item(r.reason), file.item(r.found), file.item(r.sound_until);
}

template <class File>
void each_field(File& file, SampleClock& c) {
  file.item(c.begun), file.item(c.interval), file.item(c.next);
}

/// All fields but the options, which the script states again.
template <class File>
void each_field(File& file, StageProgress& p) {
  file.item(p.end), file.item(p.frames), file.item(p.histories), file.item(p.energies);
  file.item(p.still_since), file.item(p.first), file.item(p.over), file.item(p.report);
}

}  // namespace trilith
