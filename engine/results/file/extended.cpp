#include "results/file/extended.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "results/file/field_names.hpp"
#include "results/file/part_path.hpp"
#include "results/reading/reader.hpp"

namespace trilith::results {
namespace {

/// Appends to `values` the entries of `whole` that it lacks.
void fill_up(std::vector<double>& values, const std::vector<double>& whole) {
  if (values.size() < whole.size())
    values.insert(values.end(), whole.begin() + static_cast<std::ptrdiff_t>(values.size()), whole.end());
  values.resize(whole.size());  // of a continued run: bodies may have been added after its checkpoint
}

/// The fields of a frame in the order of `header`, by their names.
std::vector<std::vector<double>> fields_in(const Header& header, const Header& before, const Frame& frame) {
  std::vector<std::vector<double>> fields;
  for (const Field& field : header.fields) {
    const auto known = std::find_if(before.fields.begin(), before.fields.end(),
                                    [&](const Field& other) { return other.name == field.name; });
    std::vector<double> values;
    if (known != before.fields.end()) values = frame.fields[static_cast<std::size_t>(known - before.fields.begin())];
    values.resize(field.rows * static_cast<std::size_t>(field.width),
                  field.name == node_temperature ? no_temperature : 0);
    fields.push_back(std::move(values));
  }
  return fields;
}

void copy_frame(Frame frame, const Header& before, const Header& header, ResultsWriter& to) {
  const std::size_t nodes = header.node_count(), bearings = header.bearings.size();
  const auto dim = static_cast<std::size_t>(header.dim);
  fill_up(frame.position, header.node_position);
  fill_up(frame.rotation, header.node_rotation);
  if (header.with_velocity) {
    frame.velocity.resize(nodes * dim);
    frame.spin.resize(nodes * static_cast<std::size_t>(spin_width(header.dim)));
  }
  frame.stress.resize(3 * header.element_count());
  frame.plastic.resize(header.element_count());
  frame.bearing_state.resize(bearings, BearingState::absent);
  frame.bearing_force.resize(bearings * dim);
  frame.bearing_displacement.resize(bearings * dim);
  const std::vector<std::vector<double>> fields = fields_in(header, before, frame);
  FrameRow row;
  row.time = frame.time, row.step = frame.step, row.stage = frame.stage;
  row.position = frame.position, row.rotation = frame.rotation;
  row.velocity = frame.velocity, row.spin = frame.spin;
  row.contacts = frame.contacts;
  row.bearing_state = frame.bearing_state;
  row.bearing_force = frame.bearing_force, row.bearing_displacement = frame.bearing_displacement;
  row.stress = frame.stress, row.plastic = frame.plastic, row.fields = fields;
  to.append_frame(row);
}

/// The first `count` rows of a table, or all if there are fewer.
template <class Rows>
Rows first_rows(Rows rows, std::int64_t count) {
  if (static_cast<std::int64_t>(rows.size()) > count) rows.resize(static_cast<std::size_t>(count));
  return rows;
}

void copy_histories(const ResultsReader& from, const Header& header, const RowCounts& rows, ResultsWriter& to) {
  const std::vector<double> times = first_rows(from.history_times(), rows.histories);
  std::vector<std::vector<double>> columns;
  for (const Quantity& q : header.histories) {
    const auto& known = from.header().histories;
    const bool followed = std::any_of(known.begin(), known.end(), [&](const Quantity& k) { return k.name == q.name; });
    columns.push_back(followed ? from.history(q.name)
                               : std::vector<double>(times.size(), std::numeric_limits<double>::quiet_NaN()));
  }
  std::vector<double> row(columns.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k) row[k] = columns[k][i];
    to.append_history(times[i], row);
  }
}

void copy_tables(const ResultsReader& from, const RowCounts& rows, ResultsWriter& to) {
  for (EventRow& event : first_rows(from.events(), rows.events)) to.append_event(std::move(event));
  EnergyTable energy = from.energy();
  energy.time = first_rows(std::move(energy.time), rows.energy);
  std::vector<double> terms(energy.terms.size());
  for (std::size_t i = 0; i < energy.time.size(); ++i) {
    for (std::size_t k = 0; k < terms.size(); ++k) terms[k] = energy.terms[k][i];
    to.append_energy(energy.time[i], terms, energy.residual[i]);
  }
  for (const Note& note : first_rows(from.notes(), rows.notes)) to.append_note(note.time, note.text);
}

void copy_modes(const ResultsReader& from, const Header& header, const RowCounts& rows, ResultsWriter& to) {
  for (ModeRow& mode : first_rows(from.modes(), rows.modes)) {
    fit_mode(header, mode);
    to.append_mode(mode);
  }
}

RowCounts all_rows() {
  constexpr std::int64_t all = std::numeric_limits<std::int64_t>::max();
  return {all, all, all, all, all, all, all, all};
}

/// `last_is_open`: the last stage is not ended, even if `from` contains its end.
void copy_first_rows(const ResultsReader& from, const Header& header, const RowCounts& rows, bool last_is_open,
                     ResultsWriter& to) {
  const std::vector<StageRow> stages = first_rows(from.stages(), rows.stages);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    to.begin_stage(stages[i].name, stages[i].kind, stages[i].begin);
    if (stages[i].ended && !(last_is_open && i + 1 == stages.size())) to.end_stage(stages[i].end, stages[i].why);
  }
  const auto frames = std::min(from.frame_count(), static_cast<std::size_t>(rows.frames));
  for (std::size_t i = 0; i < frames; ++i) copy_frame(from.frame(i), from.header(), header, to);
  copy_histories(from, header, rows, to);
  copy_tables(from, rows, to);
  copy_modes(from, header, rows, to);
  for (MotionRow& motion : first_rows(from.motions(), rows.motions)) to.append_motion(std::move(motion));
}

}  // namespace

void fit_mode(const Header& header, ModeRow& mode) {
  fill_up(mode.position, header.node_position);
  fill_up(mode.rotation, header.node_rotation);
  mode.displacement.resize(header.node_position.size());
  mode.turn.resize(header.node_inertia.size());
}

void continue_rows(const std::filesystem::path& from, const Header& header, const RowCounts& rows, bool last_is_open,
                   ResultsWriter& to) {
  const ResultsReader reader(from);
  copy_first_rows(reader, header, rows, last_is_open, to);
  const RowCounts now = to.rows();
  if (now.frames != rows.frames || now.histories != rows.histories || now.events != rows.events ||
      now.energy != rows.energy || now.stages != rows.stages || now.notes != rows.notes || now.modes != rows.modes ||
      now.motions != rows.motions)
    throw ResultsError(fmt::format(
        "results file '{}': has fewer rows than its checkpoint states; it was changed after the run", from.string()));
  to.flush();
}

ResultsWriter extended(ResultsWriter before, const Header& header, WriterOptions options) {
  const std::filesystem::path path = before.path(), part = before.part(), kept = replaced_part_path(path);
  before.flush();
  { const ResultsWriter closed = std::move(before); }
  std::error_code error;
  std::filesystem::rename(part, kept, error);
  if (error)
    throw ResultsError(fmt::format("results file '{}': cannot be renamed: {}", part.string(), error.message()));
  try {
    ResultsWriter to(path, header, options);
    copy_first_rows(ResultsReader(kept), header, all_rows(), false, to);
    to.flush();
    std::filesystem::remove(kept, error);
    return to;
  } catch (const std::runtime_error& failure) {
    throw ResultsError(fmt::format("{}; earlier results are in '{}'", failure.what(), kept.string()));
  }
}

}  // namespace trilith::results
