// Reads results files: finished, still being written, and left by a killed run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// A note or warning with the time it came up, s.
struct Note {
  double time = 0;
  std::string text;
};

/// Everything read is what was committed at the last flush before the file was opened or refreshed.
class ResultsReader {
 public:
  /// Opens `path`, or where there is none `<path>.part`, what a running or killed run of that name has written so far.
  /// Throws ResultsError: no such file, no HDF5 file, no Trilith results, a newer format version, a cut file.
  explicit ResultsReader(const std::filesystem::path& path);
  ~ResultsReader();
  ResultsReader(ResultsReader&&) noexcept;
  ResultsReader& operator=(ResultsReader&&) noexcept;

  const std::filesystem::path& path() const;  ///< the file that was opened
  bool finished() const;                      ///< the run wrote it to its end
  bool running() const;                       ///< a writer holds it now
  bool newer_part() const;                    ///< beside this finished file a later run left, or writes, `<path>.part`
  bool newer_part_running() const;            ///< ... and that run still goes on
  /// Sees what has been flushed since.
  void refresh();

  const Header& header() const;
  /// What pictures and pages are titled: the model's name, or where it has none the file's, without its ending.
  std::string title() const;

  std::size_t frame_count() const;
  const std::vector<double>& frame_times() const;  ///< s
  /// Throws ResultsError where `index` is out of range.
  Frame frame(std::size_t index) const;
  /// Index of the frame nearest to `time`; the earlier of two. Throws ResultsError where there is no frame.
  std::size_t nearest_frame(double time) const;
  /// Motion interpolated between the two frames around `time` (positions and angles linearly, quaternions along the
  /// shorter arc); contacts, bearings, step and stage are those of the nearest frame. Before the first and after the
  /// last frame: that frame.
  Frame frame_at(double time) const;

  std::vector<double> history_times() const;  ///< s
  /// Throws ResultsError with the nearest name where there is no history `name`.
  std::vector<double> history(std::string_view name) const;

  std::vector<EventRow> events() const;
  EnergyTable energy() const;
  std::vector<StageRow> stages() const;
  std::vector<Note> notes() const;
  /// In the order they were found; none in a file of an earlier program.
  std::vector<ModeRow> modes() const;
  /// In the order they began, with their samples; none in a file of an earlier program.
  std::vector<MotionRow> motions() const;

 private:
  friend void repair(const std::filesystem::path& from, const std::filesystem::path& to);
  class Body;
  std::unique_ptr<Body> body_;
};

/// Copies what a killed or running run has committed to a clean file that every HDF5 program opens; `finished` stays as
/// it is. Throws ResultsError; replaces `to` only where it is a Trilith results file.
void repair(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace trilith::results
