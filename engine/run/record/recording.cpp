#include "run/record/recording.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "assembly/bearing_motion.hpp"
#include "assembly/contact/solid_resultants.hpp"
#include "assembly/element/element_stress.hpp"
#include "model/event/event_text.hpp"
#include "model/loads.hpp"
#include "model/pose.hpp"
#include "results/file/extended.hpp"
#include "run/record/member_fields.hpp"
#include "run/record/recorded_texts.hpp"

namespace trilith {
namespace {

results::ContactState state_of(ContactHold hold) {
  switch (hold) {
    case ContactHold::bonded:
      return results::ContactState::bonded;
    case ContactHold::sticking:
      return results::ContactState::sticking;
    case ContactHold::sliding:
      break;
  }
  return results::ContactState::sliding;
}

results::BearingState state_of(BearingStatus status) {
  switch (status) {
    case BearingStatus::waiting:
      return results::BearingState::waiting;
    case BearingStatus::intact:
      return results::BearingState::intact;
    case BearingStatus::yielded:
      return results::BearingState::yielded;
    case BearingStatus::failed:
      return results::BearingState::failed;
    case BearingStatus::removed:
      return results::BearingState::absent;
    case BearingStatus::changed:
      break;
  }
  return results::BearingState::changed;
}

/// Displacement of point b relative to a after the bearing was placed, in the axes of the bearing; also valid after
/// failure.
Vec2 displacement_of(const Model<2>& model, const State<2>& state, std::size_t i) {
  const Bearing<2>& b = model.bearings[i];
  const Pose a = pose_at(model, state, b.end_a), at_b = pose_at(model, state, b.end_b);
  return Turn(a.rotation + b.angle).undo(Vec2(at_b.place - a.place)) - b.rest;
}
Vec3 displacement_of(const Model<3>& model, const State<3>& state, std::size_t i) {
  return bearing_motion(model, state, i).translation();
}

/// Word for a stage in the table of stages. A push in time, and the loads of a load path, have the name of their stage.
/// A stage with local damping that does not seek rest is dynamic.
template <int D>
std::string_view kind_of_stage(const Instant<D>& now) {
  const StageOptions& stage = now.stage;
  if (stage.process) return "process";
  const auto& pushes = now.model.pushes;
  const auto of_stage = [&](const Push<D>& push) { return push.name == stage.name; };
  if (std::any_of(pushes.begin(), pushes.end(), of_stage)) return "pushover";
  if (!(stage.rest_share > 0)) return "dynamic";
  if (stage.until_rest) return "consolidation";
  const std::vector<std::string> loads = load_names(now.model);
  return std::find(loads.begin(), loads.end(), stage.name) != loads.end() ? "pushover" : "dynamic";
}

/// View of numbers, vectors and quaternions as a contiguous array, as the file requires.
template <class T>
std::span<const double> numbers(const std::vector<T>& values) {
  constexpr std::size_t bytes = sizeof(T), each = bytes / sizeof(double);
  static_assert(bytes % sizeof(double) == 0);
  return {reinterpret_cast<const double*>(values.data()), each * values.size()};
}

/// Coarse wall clock [s], accurate to some milliseconds. It needs no system call, so it can be read after every step.
double wall_clock() {
  struct timespec now {};
  ::clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <int D>
results::Header whole_header(const Model<D>& model, const State<D>& state, const RecordingOptions<D>& options,
                             const RecordedFields<D>& fields) {
  results::Header header = recording_header(model, state, options);
  fields.describe(model, header);
  return header;
}

template <int D>
State<D> places_of(const State<D>& state) {
  State<D> places;
  places.position = state.position;
  places.rotation = state.rotation;
  return places;
}

}  // namespace

template <>
void Recording<2>::take_contacts(const Instant<2>& now) {
  contact_resultants(now.model, now.state, now.work, touching_);
  contacts_.clear();
  for (const TouchingContact& c : touching_) {
    results::ContactForce out;
    for (const int k : {0, 1}) out.point[k] = c.resultant.point[k], out.force[k] = -c.resultant.force[k];
    out.body_a = c.body_a;
    out.body_b = c.body_b;
    out.state = state_of(c.hold);
    contacts_.push_back(out);
  }
}

template <int D>
void Recording<D>::take_bearings(const Instant<D>& now) {
  bearing_state_.clear();
  bearing_force_.clear();
  bearing_displacement_.clear();
  for (std::size_t i = 0; i < now.model.bearings.size(); ++i) {
    const BearingStatus status = now.state.bearing[i].status;
    const Vec<D> force = is_live(status) ? now.work.bearing_force[i] : Vec<D>(Vec<D>::Zero());
    const Vec<D> displacement = displacement_of(now.model, now.state, i);
    bearing_state_.push_back(state_of(status));
    bearing_force_.insert(bearing_force_.end(), force.data(), force.data() + D);
    bearing_displacement_.insert(bearing_displacement_.end(), displacement.data(), displacement.data() + D);
  }
}

template <>
void Recording<2>::take_stress(const Instant<2>& now) {
  stress_.clear();
  plastic_.clear();
  for (int e = 0; e < static_cast<int>(now.model.elements.size()); ++e) {
    const ElementStress stress = element_stress(now.model, now.state, e);
    const Stress mean = in_world(stress);
    stress_.insert(stress_.end(), {mean.xx, mean.yy, mean.xy});
    plastic_.push_back(stress.plastic);
  }
}

/// Stress in space refers to whole bodies: see run/record/space_stress_field.hpp.
template <>
void Recording<3>::take_stress(const Instant<3>& /*now*/) {}

/// An intact bond makes a contact bonded; otherwise it slides if its friction is exhausted.
template <>
void Recording<3>::take_contacts(const Instant<3>& now) {
  contacts_.clear();
  for (std::size_t i = 0; i < now.work.general_touching.size(); ++i) {
    const SolidResultant r = solid_resultant(now.model, now.state, now.work, i);
    results::ContactForce out;
    for (const int k : {0, 1, 2}) out.point[k] = r.point[k], out.force[k] = -r.force[k], out.normal[k] = r.normal[k];
    out.body_a = r.body_a, out.body_b = r.body_b;
    out.state = state_of(r.hold);
    out.area = r.area;
    contacts_.push_back(out);
  }
}

template <int D>
Recording<D>::Recording(std::filesystem::path path, const Model<D>& model, const State<D>& state,
                        RecordingOptions<D> options)
    : fields_(model, options.with_joints),
      options_(std::move(options)),
      start_(places_of(state)),
      header_(whole_header(model, start_, options_, fields_)),
      writer_(std::move(path), header_, {options_.sync}),
      with_velocity_(options_.with_velocity),
      flush_frames_(options_.flush_frames),
      flush_interval_(options_.flush_seconds),
      flushed_(wall_clock()),
      drives_known_(model.drives.size()),
      time_(state.time) {}

/// Names and supports of the existing bodies remain as recorded first.
template <int D>
void Recording<D>::extend(const Model<D>& model, const State<D>& state, std::vector<RecordedHistory<D>> histories) {
  const std::size_t known = start_.position.size(), bodies = header_.bodies.size();
  for (std::size_t n = known; n < model.mass.size(); ++n) {
    start_.position.push_back(model.start_position[n]);
    start_.rotation.push_back(model.start_rotation[n]);
  }
  options_.histories = std::move(histories);
  fields_.extend(model, state, static_cast<int>(bodies));
  results::Header header = whole_header(model, start_, options_, fields_);
  std::copy(header_.bodies.begin(), header_.bodies.end(), header.bodies.begin());
  header.provenance = header_.provenance;
  header_ = std::move(header);
  writer_ = results::extended(std::move(writer_), header_, {options_.sync});
}

template <int D>
RunListener<D> Recording<D>::listener() {
  RunListener<D> out;
  out.on_frame = [this](const Instant<D>& now) { frame(now); };
  if (!options_.histories.empty()) out.on_history = [this](const Instant<D>& now) { history(now); };
  out.on_energy = [this](const Instant<D>& now, const Energy& e) { energy(now, e); };
  out.on_event = [this](const Event& e, const Instant<D>& now) { event(e, now); };
  out.on_step = [this](const Instant<D>&) { step(); };
  return out;
}

template <int D>
void Recording<D>::frame(const Instant<D>& now) {
  assert(stage_ >= 0);
  take_contacts(now);
  take_bearings(now);
  take_stress(now);
  results::FrameRow row;
  row.time = time_ = now.state.time;
  row.step = now.state.step;
  row.stage = stage_;
  row.position = numbers(now.state.position);
  row.rotation = numbers(now.state.rotation);
  if (with_velocity_) {
    row.velocity = numbers(now.state.velocity);
    row.spin = numbers(now.state.spin);
  }
  row.stress = stress_;
  row.plastic = plastic_;
  row.contacts = contacts_;
  row.bearing_state = bearing_state_;
  row.bearing_force = bearing_force_;
  row.bearing_displacement = bearing_displacement_;
  row.fields = fields_.take(now, touching_);
  writer_.append_frame(row);
  ++frames_since_;
  // Writes the first frame to disk at once, so that a run that is killed early can be drawn.
  if (!std::exchange(has_frame_, true)) return flush();
  flush_when_due();
}

template <int D>
void Recording<D>::history(const Instant<D>& now) {
  values_.clear();
  for (const RecordedHistory<D>& h : options_.histories) {
    values_.push_back(h.sample(now));
    if (!std::isfinite(values_.back()))  // the file uses this value for samples before the history began
      throw results::ResultsError(
          fmt::format("history '{}' at t = {:g} s is {}", h.name, now.state.time, values_.back()));
  }
  history(now.state.time, values_);
}

template <int D>
void Recording<D>::history(double time, std::span<const double> values) {
  time_ = time;
  writer_.append_history(time, values);
  flush_when_due();
}

template <int D>
void Recording<D>::energy(const Instant<D>& now, const Energy& energy) {
  const double balance = energy.balance();
  if (!has_balance_) first_balance_ = balance;
  has_balance_ = true;
  const double residual = balance - first_balance_;
  check_.add(energy, residual);
  time_ = now.state.time;
  writer_.append_energy(time_, energy.value, residual);
  flush_when_due();
}

template <int D>
void Recording<D>::continue_ledger(const Recording<D>& before) {
  has_balance_ = before.has_balance_;
  first_balance_ = before.first_balance_;
  check_ = before.check_;
}

template <int D>
void Recording<D>::event(const Event& event, const Instant<D>& now) {
  time_ = event.time;
  if (event.type == EventType::stage_begun) begin_stage(event, now);
  const EventTypeInfo& info = info_of(event.type);
  results::EventRow row;
  row.id = event.id;
  row.time = event.time;
  row.step = event.step;
  row.stage = stage_;
  row.type = info.name;
  row.body_a = event.body_a;
  row.body_b = event.body_b;
  row.bearing = event.bearing;
  row.has_place = has_trait(event.type, has_place);
  if (row.has_place) row.place[0] = event.x, row.place[1] = event.y, row.place[2] = event.z;
  if (!info.value.name.empty()) row.first = {std::string(info.value.name), std::string(info.value.unit), event.value};
  if (has_trait(event.type, of_joint)) row.second = {"mode", "1", static_cast<double>(event.mode)};
  if (event.type == EventType::member_yielded) row.second = figure_at_yield(now, event);
  row.cause = event.cause;
  row.text = event_text(event, now.model);
  writer_.append_event(std::move(row));
  if (event.type == EventType::stage_ended) {
    note_drives(now.model);
    const std::string prefix = now.stage.name + ": ";
    const std::string_view text = event.text;
    end_stage(event.time, text.starts_with(prefix) ? text.substr(prefix.size()) : text);
  }
  flush_when_due();
}

template <int D>
void Recording<D>::begin_stage(const Event& event, const Instant<D>& now) {
  if (stage_open_) end_stage(event.time, "broken off");
  stage_ = writer_.begin_stage(now.stage.name, kind_of_stage(now), event.time);
  stage_open_ = true;
  note_drives(now.model);
}

template <int D>
void Recording<D>::end_stage(double time, std::string_view why) {
  if (!stage_open_) return;
  stage_open_ = false;
  writer_.end_stage(time, why);
}

template <int D>
void Recording<D>::note_drives(const Model<D>& model) {
  for (; drives_known_ < model.drives.size(); ++drives_known_)
    if (leads(model, model.drives[drives_known_]))
      note("ground motion: " + drive_text(model, model.drives[drives_known_]));
  for (; motions_kept_ < model.drives.size(); ++motions_kept_)
    if (leads(model, model.drives[motions_kept_]))
      writer_.append_motion(motion_row(model, model.drives[motions_kept_]));
}

template <int D>
void Recording<D>::modes(std::vector<results::ModeRow> found) {
  for (results::ModeRow& row : found) {
    row.analysis = analyses_;
    results::fit_mode(header_, row);
    writer_.append_mode(row);
  }
  ++analyses_;
}

template <int D>
void Recording<D>::note(std::string_view text) {
  writer_.append_note(time_, text);
}

template <int D>
void Recording<D>::seal(const std::vector<SealRow>& rows) {
  writer_.write_seal(rows);
}

template <int D>
void Recording<D>::step() {
  if (rows_wait_) flush_when_due();
}

template <int D>
void Recording<D>::flush_when_due() {
  rows_wait_ = true;
  if (frames_since_ >= flush_frames_ || wall_clock() - flushed_ >= flush_interval_) flush();
}

template <int D>
void Recording<D>::flush() {
  writer_.flush();
  frames_since_ = 0;
  rows_wait_ = false;
  flushed_ = wall_clock();
}

template <int D>
void Recording<D>::finish() {
  end_stage(time_, "broken off");
  writer_.finish();
}

template <int D>
void Recording<D>::abandon(std::string_view why) noexcept {
  try {
    note(fmt::format("the run ended early: {}", why));
    end_stage(time_, "broken off");
    flush();
  } catch (const std::exception&) {  // the writer has reported it already; flushed data remain
    stage_open_ = false;
  }
}

template class Recording<2>;
template class Recording<3>;

}  // namespace trilith
