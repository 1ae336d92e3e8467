// Writes a results file during a run: buffers rows, flushes them so that a killed run remains readable, and finishes
// with a clean file. The layout is described in docs/results.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "model/seal_row.hpp"
#include "results/file/results.hpp"

namespace trilith::results {

/// Number of rows of each table of a results file.
struct RowCounts {
  std::int64_t frames = 0, histories = 0, events = 0, energy = 0, stages = 0, notes = 0, modes = 0, motions = 0;
};
/// For restart files, see base/bytes.hpp.
template <class File>
void each_field(File& file, RowCounts& rows) {
  file.item(rows.frames), file.item(rows.histories), file.item(rows.events), file.item(rows.energy);
  file.item(rows.stages), file.item(rows.notes), file.item(rows.modes), file.item(rows.motions);
}

struct WriterOptions {
  bool sync = true;  ///< flush() also synchronises the disk, against loss of power
};

/// During the run rows are written to `<path>.part` (finished = 0), which any number of readers may follow. The
/// function finish() copies them, compressed, to a clean file, marks it finished and renames it to `<path>`. Only then
/// it replaces an earlier results file of that name. A writer that is destroyed without finish(), or killed, leaves
/// `<path>.part`, readable up to the last flush. The part file of an earlier run is kept under another name, which
/// kept_from_before() returns. After an error the writer rejects further calls with the same message; flushed data
/// remain readable.
class ResultsWriter {
 public:
  /// Creates `<path>.part` with the content of `header`. Throws ResultsError (unwritable, no such folder, full disk,
  /// foreign file, another run writing it, inconsistent arrays of `header`). Throws InputError for the name of a
  /// history that is empty, duplicate, "time" or contains '/'.
  ResultsWriter(std::filesystem::path path, const Header& header, WriterOptions options = {});
  /// Flushes as far as possible; leaves the file unfinished unless finish() was called. Does not throw.
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;
  ResultsWriter& operator=(ResultsWriter&&) noexcept;

  /// Each append copies its row into a buffer; the buffers are flushed automatically at a few megabytes. Throws
  /// ResultsError if a number is not finite, an array has the wrong size, or a flush failed.
  void append_frame(const FrameRow& frame);
  /// One sample of every history, in the order of Header::histories, at `time` [s]. NaN marks a missing sample: before
  /// a history begins, and while its owner is out of the model.
  void append_history(double time, std::span<const double> values);
  void append_event(EventRow event);
  /// `terms` [J] in the order of Header::energy_terms, `residual` [J].
  void append_energy(double time, std::span<const double> terms, double residual);
  /// Adds a note or warning at `time` [s].
  void append_note(double time, std::string_view text);
  /// Writes the checks of the whole run, once, before finish().
  void write_seal(const std::vector<SealRow>& rows);
  /// Adds a mode, and flushes.
  void append_mode(const ModeRow& mode);
  /// Adds a motion of a body, and flushes. Samples that the file contains already are not stored again.
  void append_motion(MotionRow motion);
  /// Opens a stage and flushes; returns its row, to which frames and events refer. Text beyond 64 bytes is cut.
  std::int32_t begin_stage(std::string_view name, std::string_view kind, double time);
  /// Ends the last stage and flushes.
  void end_stage(double time, std::string_view why);

  /// Secures every row appended so far: after it returns, a kill loses none of them.
  void flush();
  /// Flushes, writes the clean file and renames it to path(). Nothing can be appended afterwards.
  void finish();

  /// Number of rows of each table, flushed or not.
  RowCounts rows() const;
  /// Path of the finished file.
  const std::filesystem::path& path() const;
  /// Present path of the rows.
  const std::filesystem::path& part() const;
  /// Text with the name under which unfinished results of an earlier run are kept, or "".
  std::string kept_from_before() const;

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace trilith::results
