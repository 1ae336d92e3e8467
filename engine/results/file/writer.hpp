// Writes a results file as a run goes: buffers rows, flushes them so that a killed run stays readable, and finishes
// with a clean file. The layout is described in docs/results.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "results/file/results.hpp"

namespace trilith::results {

struct WriterOptions {
  bool sync = true;  ///< flush() also brings the rows to the disk, against loss of power
};

/// While it runs, rows go to `<path>.part` (finished = 0), which any number of readers may follow. finish() copies
/// them, compressed, to a clean file, marks it finished and renames it to `<path>`; only then an earlier results file
/// of that name is replaced. A writer destroyed without finish(), or killed, leaves `<path>.part`, readable up to the
/// last flush. What an earlier run left so is not lost either: it gets a name of its own, and kept_from_before() says
/// so. After an error the writer refuses further calls with the same message; what was flushed stays readable.
class ResultsWriter {
 public:
  /// Creates `<path>.part` with everything of `header`. Throws ResultsError (unwritable, no such folder, full disk, a
  /// file that is not ours, another run writing it, arrays of `header` that do not fit each other) and InputError for
  /// the name of a history that is empty, double, "time" or holds '/'.
  ResultsWriter(std::filesystem::path path, const Header& header, WriterOptions options = {});
  /// Flushes what it can; leaves the file unfinished unless finish() was called. Throws nothing.
  ~ResultsWriter();
  ResultsWriter(ResultsWriter&&) noexcept;
  ResultsWriter& operator=(ResultsWriter&&) noexcept;

  /// Each append copies its row into a buffer; the buffers are flushed by themselves at a few megabytes.
  /// Throws ResultsError where a number is not finite, an array has the wrong size, or a flush failed.
  void append_frame(const FrameRow& frame);
  /// One sample of every history, in the order of Header::histories. `time`: s. NaN stands for a sample that
  /// was not taken: before a history begins, and while its owner is out of the model.
  void append_history(double time, std::span<const double> values);
  void append_event(EventRow event);
  /// `terms`: J, in the order of Header::energy_terms; `residual`: J.
  void append_energy(double time, std::span<const double> terms, double residual);
  /// A note or warning that came up at `time`, s.
  void append_note(double time, std::string_view text);
  /// A mode, and flushes.
  void append_mode(const ModeRow& mode);
  /// A motion of a body, and flushes. Samples that are in the file already are not stored again.
  void append_motion(MotionRow motion);
  /// Opens a stage and flushes; gives its row, which frames and events name. Text beyond 64 bytes is cut.
  std::int32_t begin_stage(std::string_view name, std::string_view kind, double time);
  /// Ends the last stage and flushes.
  void end_stage(double time, std::string_view why);

  /// Makes every row appended so far safe: after it returns, a kill loses none of them.
  void flush();
  /// Flushes, writes the clean file and renames it to path(). Nothing may be appended afterwards.
  void finish();

  /// Where the finished file will stand.
  const std::filesystem::path& path() const;
  /// Where the rows are now.
  const std::filesystem::path& part() const;
  /// Says under which name the unfinished results of an earlier run are kept, where there were any; else "".
  std::string kept_from_before() const;

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace trilith::results
