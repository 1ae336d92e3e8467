// Figures of a case of a study, and the small text file that transfers them from the case to the study.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace trilith {

struct StudyFigure {
  std::string name, unit;
  std::variant<double, std::string, bool> value;
};

/// Reduction of a history to one figure; `largest`: the value farthest from 0, with its sign.
enum class StudyTake { last, max, min, largest };
const std::vector<std::string>& study_takes();

struct StudyHistory {
  std::string history;
  StudyTake take = StudyTake::last;
  /// Name of its column: "top drift max".
  [[nodiscard]] std::string column() const;
};

/// "0.012", "rocking", "true".
std::string figure_value_text(const StudyFigure& figure);

/// One line for each figure: name, unit, kind (number, text or flag) and value, separated by tabs.
std::string figures_text(const std::vector<StudyFigure>& figures);

/// Reads such lines. Throws InputError for other text.
std::vector<StudyFigure> figures_from(const std::string& text);

/// The figure of `wanted` from the results files (*.h5) in `folder`: from the first file, by name, that contains the
/// history, in the units of the script of the case. Throws InputError if none does.
StudyFigure figure_from_results(const std::filesystem::path& folder, const StudyHistory& wanted);

/// File in a case's folder with figures_text, written when the script of the case has ended.
inline constexpr const char* figures_file = "figures.txt";

}  // namespace trilith
