#include "results/file/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "results/file/clean_copy.hpp"
#include "results/file/layout.hpp"
#include "results/file/part_file.hpp"
#include "results/reading/row_checks.hpp"

namespace trilith::results {
namespace {

constexpr std::size_t most_buffered = 4 * 1024 * 1024;  // bytes that trigger a flush

void copy(GrowingSet& set, const void* data, std::size_t bytes) {
  assert(bytes == set.row_bytes());
  std::memcpy(set.add(), data, bytes);
}

template <class T>
void copy(GrowingSet& set, T value) {
  copy(set, &value, sizeof value);
}

template <class T>
void copy(GrowingSet& set, std::span<const T> values) {
  copy(set, values.data(), values.size_bytes());
}

}  // namespace

class ResultsWriter::Body {
 public:
  Body(std::filesystem::path name, const Header& header, WriterOptions chosen);
  ~Body();

  void add(const FrameRow& frame);
  void add_history(double time, std::span<const double> values);
  void add(EventRow event);
  void add_energy(double time, std::span<const double> terms, double residual);
  void add(const NoteRow& note);
  void add(const ModeRow& mode);
  void seal(const std::vector<SealRow>& rows);
  void add(MotionRow motion);
  std::int32_t begin_stage(const StageRow& row);
  void end_stage(double time, std::string_view why);
  void flush();
  void finish();
  void require_open() const;
  Committed counts() const;
  std::string kept_from_before() const { return file_->kept_from_before(); }

  std::filesystem::path path, part;

 private:
  template <class Action>
  void guarded(Action action);
  void create(const Header& header);
  void discard();  // closes everything
  void flush_if_full();
  void write_rows();

  WriterOptions options_;
  int dim_;
  std::size_t nodes_, elements_;
  bool with_velocity_;
  std::vector<std::string> bodies_, bearings_;
  std::vector<std::size_t> field_size_;  // numbers in a row of each field
  std::vector<Quantity> history_names_, term_names_;
  std::vector<std::vector<double>> accelerations_;  // of motions, without duplicates
  std::vector<std::int64_t> first_sample_;          // of each of those
  std::optional<PartFile> file_;
  std::optional<Layout> layout_;
  std::vector<GrowingSet*> sets_;
  h5::Handle committed_;
  StageRow stage_;
  std::string broken_;
  bool finished_ = false;
};

ResultsWriter::Body::Body(std::filesystem::path name, const Header& header, WriterOptions chosen)
    : path(std::move(name)),
      part(part_path(path)),
      options_(chosen),
      dim_(header.dim),
      nodes_(header.node_count()),
      elements_(header.element_count()),
      with_velocity_(header.with_velocity),
      history_names_(header.histories),
      term_names_(header.energy_terms) {
  check_header(header);
  for (const BodyRow& body : header.bodies) bodies_.push_back(body.name);
  for (const BearingRow& bearing : header.bearings) bearings_.push_back(bearing.name);
  require_writable(path);
  const h5::Quiet quiet;
  file_.emplace(path);
  try {
    create(header);
  } catch (const std::runtime_error& failure) {
    discard();
    file_->undo();
    throw ResultsError(fmt::format("results file '{}': {}", path.string(), failure.what()));
  }
}

void ResultsWriter::Body::create(const Header& header) {
  for (const Field& f : header.fields) field_size_.push_back(f.rows * static_cast<std::size_t>(f.width));
  write_header(file_->file(), header);
  layout_.emplace(file_->file(), header);
  sets_ = layout_->sets();
  committed_ = create_committed(file_->file());
  h5::check(H5Fflush(file_->file(), H5F_SCOPE_LOCAL), "cannot flush the file");
  file_->start_swmr();
  file_->require_written();
}

ResultsWriter::Body::~Body() {
  if (finished_ || !broken_.empty()) return;
  try {
    flush();
    const h5::Quiet quiet;
    committed_.reset();
    layout_.reset();
    file_->close();
  } catch (const std::runtime_error&) {
    // Errors cannot be reported here; flushed data are safe.
  }
}

void ResultsWriter::Body::discard() {
  committed_.reset();
  sets_.clear();
  layout_.reset();
  file_->abandon();
}

// Converts a failed HDF5 call into the single error of this writer, and closes the file so that nothing fails again at
// exit.
template <class Action>
void ResultsWriter::Body::guarded(Action action) {
  require_open();
  const h5::Quiet quiet;
  try {
    action();
  } catch (const h5::Failure& failure) {
    broken_ = fmt::format("results file '{}': {}; the rows flushed before are safe in '{}'", path.string(),
                          failure.what(), part.string());
    discard();
    throw ResultsError(broken_);
  }
}

void ResultsWriter::Body::require_open() const {
  if (!broken_.empty()) throw ResultsError(broken_);
  if (finished_) throw ResultsError(fmt::format("results file '{}': is finished, nothing can be added", path.string()));
}

void ResultsWriter::Body::add(const FrameRow& frame) {
  require_open();
  check_frame(frame, {dim_, nodes_, elements_, bearings_.size(), with_velocity_, field_size_});
  Layout& to = *layout_;
  const auto row = static_cast<std::int32_t>(to.time.rows());
  const std::int64_t first = to.contacts.set.rows();
  for (const ContactForce& contact : frame.contacts) to.contacts.append(ContactRow{row, contact}, dim_);
  copy(to.time, frame.time);
  copy(to.step, frame.step);
  copy(to.stage, frame.stage);
  copy(to.position, frame.position);
  copy(to.rotation, frame.rotation);
  copy(to.contact_first, first);
  copy(to.contact_count, static_cast<std::int32_t>(frame.contacts.size()));
  if (with_velocity_) {
    copy(*to.velocity, frame.velocity);
    copy(*to.spin, frame.spin);
  }
  if (elements_ > 0) {
    copy(*to.stress, frame.stress);
    copy(*to.plastic, frame.plastic);
  }
  if (!bearings_.empty()) {
    copy(*to.bearing_state, frame.bearing_state);
    copy(*to.bearing_force, frame.bearing_force);
    copy(*to.bearing_displacement, frame.bearing_displacement);
  }
  for (std::size_t i = 0; i < to.fields.size(); ++i) copy(to.fields[i], std::span<const double>(frame.fields[i]));
  flush_if_full();
}

void ResultsWriter::Body::add_history(double time, std::span<const double> values) {
  require_open();
  if (values.size() != history_names_.size())
    throw ResultsError(fmt::format("results histories at t = {:g} s: {} values for {} histories", time, values.size(),
                                   history_names_.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    // NaN is a missing sample: before the history begins, and while its owner is out of the model.
    if (std::isinf(values[i]) || !std::isfinite(time))
      throw ResultsError(fmt::format("history '{}' at t = {:g} s is {}", history_names_[i].name, time, values[i]));
  copy(layout_->history_time, time);
  for (std::size_t i = 0; i < values.size(); ++i) copy(layout_->histories[i], values[i]);
  flush_if_full();
}

void ResultsWriter::Body::add_energy(double time, std::span<const double> terms, double residual) {
  require_open();
  if (terms.size() != term_names_.size())
    throw ResultsError(
        fmt::format("results energy at t = {:g} s: {} values for {} terms", time, terms.size(), term_names_.size()));
  for (std::size_t i = 0; i < terms.size(); ++i)
    if (!std::isfinite(terms[i]))
      throw ResultsError(fmt::format("energy term '{}' at t = {:g} s is {}", term_names_[i].name, time, terms[i]));
  if (!std::isfinite(residual) || !std::isfinite(time))
    throw ResultsError(fmt::format("energy residual at t = {:g} s is {}", time, residual));
  copy(layout_->energy_time, time);
  for (std::size_t i = 0; i < terms.size(); ++i) copy(layout_->energy_terms[i], terms[i]);
  copy(layout_->energy_residual, residual);
  flush_if_full();
}

void ResultsWriter::Body::add(EventRow event) {
  require_open();
  event.body_a_name = row_name(bodies_, event.body_a, "body");
  event.body_b_name = row_name(bodies_, event.body_b, "body");
  event.bearing_name = row_name(bearings_, event.bearing, "bearing");
  for (const double value :
       {event.time, event.place[0], event.place[1], event.place[2], event.first.value, event.second.value})
    if (!std::isfinite(value))
      throw ResultsError(fmt::format("event '{}' at t = {:g} s holds {}", event.type, event.time, value));
  layout_->events.append(event, dim_);
  flush_if_full();
}

void ResultsWriter::Body::add(const NoteRow& note) {
  require_open();
  layout_->notes.append(note, dim_);
}

void ResultsWriter::Body::seal(const std::vector<SealRow>& rows) {
  guarded([&] { results::write_seal(file_->file(), rows, dim_); });
}

void ResultsWriter::Body::add(const ModeRow& mode) {
  require_open();
  check_mode(mode, dim_, nodes_);
  Layout& to = *layout_;
  to.modes.append(mode, dim_);
  copy(to.mode_position, std::span<const double>(mode.position));
  copy(to.mode_rotation, std::span<const double>(mode.rotation));
  copy(to.mode_displacement, std::span<const double>(mode.displacement));
  copy(to.mode_turn, std::span<const double>(mode.turn));
  flush();
}

// Samples that equal an earlier row to the bit are not stored again: delayed copies, and one motion of many bodies.
void ResultsWriter::Body::add(MotionRow motion) {
  require_open();
  check_motion(motion, bodies_.size(), nodes_);
  const auto same = std::find(accelerations_.begin(), accelerations_.end(), motion.acceleration);
  motion.sample_count = static_cast<std::int64_t>(motion.acceleration.size());
  motion.first_sample = layout_->motion_acceleration.rows();
  if (same != accelerations_.end())
    motion.first_sample = first_sample_[static_cast<std::size_t>(same - accelerations_.begin())];
  layout_->motions.append(motion, dim_);
  if (same == accelerations_.end()) {
    const std::span<const double> values = motion.acceleration;
    std::memcpy(layout_->motion_acceleration.add(values.size()), values.data(), values.size_bytes());
    first_sample_.push_back(motion.first_sample);
    accelerations_.push_back(std::move(motion.acceleration));
  }
  flush();
}

std::int32_t ResultsWriter::Body::begin_stage(const StageRow& row) {
  require_open();
  stage_ = row;
  layout_->stages.append(row, dim_);
  flush();
  return static_cast<std::int32_t>(layout_->stages.set.rows() - 1);
}

void ResultsWriter::Body::end_stage(double time, std::string_view why) {
  guarded([&] {
    GrowingTable& stages = layout_->stages;
    assert(stages.set.rows() > 0);
    stage_.end = time;
    stage_.ended = true;
    stage_.why = why;
    std::vector<std::byte> record(stages.type.size);
    pack(stages.type, dim_, stage_, record.data());
    stages.set.replace(stages.set.rows() - 1, record.data());
  });
  flush();
}

void ResultsWriter::Body::flush_if_full() {
  std::size_t bytes = 0;
  for (const GrowingSet* set : sets_) bytes += set->buffered_bytes();
  if (bytes >= most_buffered) flush();
}

Committed ResultsWriter::Body::counts() const {
  const Layout& from = *layout_;
  return {from.time.rows(),        from.contacts.set.rows(),       from.history_time.rows(), from.events.set.rows(),
          from.energy_time.rows(), from.stages.set.rows(),         from.notes.set.rows(),    from.modes.set.rows(),
          from.motions.set.rows(), from.motion_acceleration.rows()};
}

void ResultsWriter::Body::flush() {
  guarded([&] { write_rows(); });
}

// The order provides the guarantee: rows first, synchronised if requested, and only then their counters, synchronised
// too because a checkpoint that follows relies on them. The whole file is flushed once, because HDF5 walks through its
// whole cache for each separately flushed set.
void ResultsWriter::Body::write_rows() {
  for (GrowingSet* set : sets_) set->write();
  h5::check(H5Fflush(file_->file(), H5F_SCOPE_LOCAL), "cannot flush the file");
  file_->require_written();
  if (options_.sync) file_->sync();
  write_committed(committed_.get(), counts());
  h5::check(H5Fflush(file_->file(), H5F_SCOPE_LOCAL), "cannot flush the file");
  file_->require_written();
  if (options_.sync) file_->sync();
}

void ResultsWriter::Body::finish() {
  require_open();
  require_writable(path);  // another file may have been created there during the run
  guarded([&] {
    write_rows();
    committed_.reset();
    layout_.reset();
    write_clean_copy(file_->file(), path, true);
  });
  finished_ = true;
  const h5::Quiet quiet;
  file_->remove();
}

ResultsWriter::ResultsWriter(std::filesystem::path path, const Header& header, WriterOptions options)
    : body_(std::make_unique<Body>(std::move(path), header, options)) {}
ResultsWriter::~ResultsWriter() = default;
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;
ResultsWriter& ResultsWriter::operator=(ResultsWriter&&) noexcept = default;

void ResultsWriter::append_frame(const FrameRow& frame) {
  body_->add(frame);
}
void ResultsWriter::append_history(double time, std::span<const double> values) {
  body_->add_history(time, values);
}
void ResultsWriter::append_event(EventRow event) {
  body_->add(std::move(event));
}
void ResultsWriter::append_energy(double time, std::span<const double> terms, double residual) {
  body_->add_energy(time, terms, residual);
}
void ResultsWriter::append_note(double time, std::string_view text) {
  body_->add(NoteRow{time, std::string(text)});
}
void ResultsWriter::write_seal(const std::vector<SealRow>& rows) {
  body_->seal(rows);
}
void ResultsWriter::append_mode(const ModeRow& mode) {
  body_->add(mode);
}
void ResultsWriter::append_motion(MotionRow motion) {
  body_->add(std::move(motion));
}
std::int32_t ResultsWriter::begin_stage(std::string_view name, std::string_view kind, double time) {
  return body_->begin_stage({std::string(name), std::string(kind), time, time, false, ""});
}
void ResultsWriter::end_stage(double time, std::string_view why) {
  body_->end_stage(time, why);
}
void ResultsWriter::flush() {
  body_->flush();
}
void ResultsWriter::finish() {
  body_->finish();
}
RowCounts ResultsWriter::rows() const {
  const Committed c = body_->counts();
  return {c.frames, c.histories, c.events, c.energy, c.stages, c.notes, c.modes, c.motions};
}
const std::filesystem::path& ResultsWriter::path() const {
  return body_->path;
}
const std::filesystem::path& ResultsWriter::part() const {
  return body_->part;
}
std::string ResultsWriter::kept_from_before() const {
  return body_->kept_from_before();
}

}  // namespace trilith::results
