// Reads results files: finished, still being written, and left by a killed run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/unit_system.hpp"
#include "model/seal_row.hpp"
#include "results/file/results.hpp"

namespace trilith::results {

/// A note or warning with its time [s].
struct Note {
  double time = 0;
  std::string text;
};

/// All data are those committed at the last flush before the file was opened or refreshed.
class ResultsReader {
 public:
  /// Opens `path`, or if it does not exist `<path>.part`, which a running or killed run of that name has written.
  /// Throws ResultsError: no such file, no HDF5 file, no Trilith results, a newer format version, a truncated file.
  explicit ResultsReader(const std::filesystem::path& path);
  ~ResultsReader();
  ResultsReader(ResultsReader&&) noexcept;
  ResultsReader& operator=(ResultsReader&&) noexcept;

  const std::filesystem::path& path() const;  ///< the file that was opened
  bool finished() const;                      ///< the run wrote it completely
  bool running() const;                       ///< a writer holds it at present
  bool newer_part() const;                    ///< a later run left, or writes, `<path>.part` in addition to this
                                              ///< finished file
  bool newer_part_running() const;            ///< ... and that run is still running
  /// Reads the data flushed in the meantime.
  void refresh();

  const Header& header() const;
  /// Title of pictures and pages: the model's name, or the file's name without extension.
  std::string title() const;
  /// Units of the script, in which its results are shown; the data themselves are in SI. Throws ResultsError for units
  /// that this program does not know.
  UnitSystem units() const;

  std::size_t frame_count() const;
  const std::vector<double>& frame_times() const;  ///< [s]
  /// Throws ResultsError if `index` is out of range.
  Frame frame(std::size_t index) const;
  /// Index of the frame nearest to `time`; the earlier of two. Throws ResultsError if there is no frame.
  std::size_t nearest_frame(double time) const;
  /// Motion interpolated between the two frames around `time` (positions and angles linearly, quaternions along the
  /// shorter arc); contacts, bearings, step and stage of the nearest frame. Before the first and after the last frame:
  /// that frame.
  Frame frame_at(double time) const;

  std::vector<double> history_times() const;  ///< [s]
  /// Throws ResultsError with the nearest name if there is no history `name`.
  std::vector<double> history(std::string_view name) const;

  std::vector<EventRow> events() const;
  EnergyTable energy() const;
  std::vector<StageRow> stages() const;
  std::vector<Note> notes() const;
  /// Checks of the whole run; none in an unfinished file, or one of an earlier program version.
  std::vector<SealRow> seal() const;
  /// In the order in which they were found; none in a file of an earlier program version.
  std::vector<ModeRow> modes() const;
  /// In the order in which they began, with their samples; none in a file of an earlier program version.
  std::vector<MotionRow> motions() const;

 private:
  friend void repair(const std::filesystem::path& from, const std::filesystem::path& to);
  class Body;
  std::unique_ptr<Body> body_;
};

/// Copies the committed data of a killed or running run to a clean file that every HDF5 program opens; `finished`
/// remains unchanged. Throws ResultsError; replaces `to` only if it is a Trilith results file.
void repair(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace trilith::results
