// Turns a running simulation into a results file. Reads Instant, writes nothing back.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assembly/contact/contact_resultants.hpp"
#include "model/check/energy_check.hpp"
#include "results/file/writer.hpp"
#include "run/record/recorded_fields.hpp"
#include "run/record/recording_header.hpp"

namespace trilith {

class ByteReader;
class ByteWriter;

template <int D>
class Recording {
 public:
  /// Opens `<path>.part` and writes the constant data of a run. Throws ResultsError (unwritable, full disk, ...) and
  /// InputError for invalid names of histories (see results::ResultsWriter).
  Recording(std::filesystem::path path, const Model<D>& model, const State<D>& state, RecordingOptions<D> options = {});
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;
  /// Leaves the file unfinished, readable up to its last row, unless finish() was called.
  ~Recording() = default;

  /// Listener that records all notifications of a run; valid during the lifetime of this object. Stages follow from
  /// their events.
  RunListener<D> listener();

  // The functions of the listener, for callers with their own listener. All throw ResultsError.
  void frame(const Instant<D>& now);
  /// One sample of every history, computed by their `sample`.
  void history(const Instant<D>& now);
  /// One sample with known values, in the order of the histories; time [s].
  void history(double time, std::span<const double> values);
  /// Records the ledger. Its residual is the balance minus the balance of the first sample.
  void energy(const Instant<D>& now, const Energy& energy);
  /// Events "stage.begun" and "stage.ended" open and close rows of the table of stages.
  void event(const Event& event, const Instant<D>& now);
  /// Call it after each step: flushes rows that have waited long enough, even if no further rows follow. It costs a
  /// read of a coarse clock if rows wait, otherwise nothing.
  void step();
  /// The model has further rows at the ends of its arrays, or the run has further `histories`. The file continues with
  /// these and all previous records. `state` contains the initial position of the added bodies.
  void extend(const Model<D>& model, const State<D>& state, std::vector<RecordedHistory<D>> histories);
  /// This file continues `before`: its residual counts from the same start.
  void continue_ledger(const Recording& before);
  // For restart files (run/record/recording_bytes.cpp).
  /// Writes the counts of all rows, flushed or not, and the state of the recording.
  void write(ByteWriter& out);
  /// Flushes all rows.
  void flush();
  /// Continues an interrupted recording from the data of write(), and copies its rows from the unfinished file `rows`.
  /// Nothing may have been recorded before.
  void read(ByteReader& in, const std::filesystem::path& rows);
  /// Adds natural modes, all found at the same instant (run/record/recorded_modes.hpp).
  void modes(std::vector<results::ModeRow> found);
  /// Adds a line of text to the run, at the time of the last row.
  void note(std::string_view text);

  /// Writes the checks of the whole run, before finish().
  void seal(const std::vector<SealRow>& rows);
  /// Completes the file under its final name. Nothing can be recorded afterwards.
  void finish();
  /// Ends an incomplete run: writes the reason to the file, which remains `<path>.part`, unfinished. Does not throw.
  void abandon(std::string_view why) noexcept;

  [[nodiscard]] const EnergyCheck& energy_check() const { return check_; }
  [[nodiscard]] const std::filesystem::path& path() const { return writer_.path(); }
  /// See results::ResultsWriter.
  [[nodiscard]] std::string kept_from_before() const { return writer_.kept_from_before(); }
  /// Path of the rows until finish().
  [[nodiscard]] const std::filesystem::path& part() const { return writer_.part(); }

 private:
  void begin_stage(const Event& event, const Instant<D>& now);
  void end_stage(double time, std::string_view why);
  /// Adds the drives that are new: a note for each one that the header does not list, and its samples.
  void note_drives(const Model<D>& model);
  void take_contacts(const Instant<D>& now);
  void take_bearings(const Instant<D>& now);
  void take_stress(const Instant<D>& now);
  void flush_when_due();
  template <class File>
  void walk(File& file);

  RecordedFields<D> fields_;
  RecordingOptions<D> options_;
  State<D> start_;  // positions and rotations of the nodes only
  results::Header header_;
  results::ResultsWriter writer_;
  bool with_velocity_;
  int flush_frames_;
  double flush_interval_, flushed_;  // wall clock [s]
  int frames_since_ = 0;
  bool has_frame_ = false, rows_wait_ = false;
  std::int32_t stage_ = -1, analyses_ = 0;
  bool stage_open_ = false;
  std::size_t drives_known_, motions_kept_ = 0;
  double time_;
  bool has_balance_ = false;
  double first_balance_ = 0;
  EnergyCheck check_;

  // Row buffers, kept to avoid allocation.
  std::vector<TouchingContact> touching_;
  std::vector<results::ContactForce> contacts_;
  std::vector<results::BearingState> bearing_state_;
  std::vector<double> bearing_force_, bearing_displacement_, stress_, plastic_, values_;
};

}  // namespace trilith
