// The figures a case of a study comes to, and the small text file that carries them from the case to the study.
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

/// How a history becomes one figure; `largest`: the one farthest from 0, with its sign.
enum class StudyTake { last, max, min, largest };
const std::vector<std::string>& study_takes();

struct StudyHistory {
  std::string history;
  StudyTake take = StudyTake::last;
  /// "top drift max": its column.
  [[nodiscard]] std::string column() const;
};

/// "0.012", "rocking", "true".
std::string figure_value_text(const StudyFigure& figure);

/// One line for each figure: name, unit, kind (number, text or flag) and value with tabs between.
std::string figures_text(const std::vector<StudyFigure>& figures);

/// Reads such lines. Throws InputError for text that is none.
std::vector<StudyFigure> figures_from(const std::string& text);

/// The figure that `wanted` gives from the results files (*.h5) in `folder`: the first, by name, that has the history.
/// Throws InputError where none has.
StudyFigure figure_from_results(const std::filesystem::path& folder, const StudyHistory& wanted);

/// The file of a case's folder in which figures_text stands once its script has come to its end.
inline constexpr const char* figures_file = "figures.txt";

}  // namespace trilith
