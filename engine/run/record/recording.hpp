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

template <int D>
class Recording {
 public:
  /// Opens `<path>.part` and writes what does not change during a run. Throws ResultsError (unwritable, full disk, ...)
  /// and InputError for names of histories that cannot be used (see results::ResultsWriter).
  Recording(std::filesystem::path path, const Model<D>& model, const State<D>& state, RecordingOptions<D> options = {});
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  Recording(Recording&&) = delete;
  Recording& operator=(Recording&&) = delete;
  /// Leaves the file unfinished, readable up to its last row, unless finish() was called.
  ~Recording() = default;

  /// Records all a run tells; valid as long as this lives. Stages are known by their events.
  RunListener<D> listener();

  // What the listener does, for callers with a listener of their own. All throw ResultsError.
  void frame(const Instant<D>& now);
  /// One sample of every history, from their `sample`.
  void history(const Instant<D>& now);
  /// The same from values known elsewhere, in the order of the histories; time [s].
  void history(double time, std::span<const double> values);
  /// The residual is the balance less that of the first sample.
  void energy(const Instant<D>& now, const Energy& energy);
  /// Events "stage.begun" and "stage.ended" open and close rows of the table of stages.
  void event(const Event& event, const Instant<D>& now);
  /// After each step: brings rows to the disk that have waited long enough, though no further ones come. Costs a look
  /// at a coarse clock where rows wait, and nothing else.
  void step();
  /// The model has further rows at the ends of its arrays, or the run further `histories`: the file goes on as one that
  /// has them too, with all that was recorded. `state`: what came is where it stands first.
  void extend(const Model<D>& model, const State<D>& state, std::vector<RecordedHistory<D>> histories);
  /// This file goes on where `before` was left off: its residual counts from the same start.
  void continue_ledger(const Recording& before);
  /// Modes that were found at once (run/record/recorded_modes.hpp).
  void modes(std::vector<results::ModeRow> found);
  /// A line of text that belongs to the run; time of the last row.
  void note(std::string_view text);

  /// Completes the file under its own name. Nothing may be recorded afterwards.
  void finish();
  /// The run ended early: says why in the file, which stays `<path>.part`, unfinished. Throws nothing.
  void abandon(std::string_view why) noexcept;

  [[nodiscard]] const EnergyCheck& energy_check() const { return check_; }
  [[nodiscard]] const std::filesystem::path& path() const { return writer_.path(); }
  /// See results::ResultsWriter.
  [[nodiscard]] std::string kept_from_before() const { return writer_.kept_from_before(); }
  /// Where the rows are until finish().
  [[nodiscard]] const std::filesystem::path& part() const { return writer_.part(); }

 private:
  void begin_stage(const Event& event, const Instant<D>& now);
  void end_stage(double time, std::string_view why);
  /// Those that came since the last look: a note for each, where the header does not name it, and its samples.
  void note_drives(const Model<D>& model);
  void take_contacts(const Instant<D>& now);
  void take_bearings(const Instant<D>& now);
  void take_stress(const Instant<D>& now);
  void flush_when_due();
  void flush();

  RecordedFields<D> fields_;
  RecordingOptions<D> options_;
  State<D> start_;  // places and turns of the nodes alone
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

  // Rows under way; kept for their memory.
  std::vector<TouchingContact> touching_;
  std::vector<results::ContactForce> contacts_;
  std::vector<results::BearingState> bearing_state_;
  std::vector<double> bearing_force_, bearing_displacement_, stress_, plastic_, values_;
};

}  // namespace trilith
