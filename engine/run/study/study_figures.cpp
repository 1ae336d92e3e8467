#include "run/study/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "results/reading/reader.hpp"

namespace trilith {
namespace {

std::string one_field(std::string text) {
  for (char& c : text)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  return text;
}

StudyFigure figure_of(const std::string& line) {
  std::vector<std::string> field;
  std::istringstream in(line);
  for (std::string part; std::getline(in, part, '\t');) field.push_back(part);
  if (field.size() == 3) field.emplace_back();  // an empty text
  if (field.size() != 4 || field[0].empty() || (field[2] != "number" && field[2] != "text" && field[2] != "flag"))
    throw InputError(fmt::format("'{}' is not a figure of a case", line));
  if (field[2] == "text") return {field[0], field[1], field[3]};
  if (field[2] == "flag" && (field[3] == "true" || field[3] == "false"))
    return {field[0], field[1], field[3] == "true"};
  double value = 0;
  const char* const end = field[3].data() + field[3].size();
  const auto [stop, error] = std::from_chars(field[3].data(), end, value);
  if (error != std::errc() || stop != end) throw InputError(fmt::format("'{}' is not a figure of a case", line));
  return {field[0], field[1], value};
}

/// `last`: NaN if the quantity had left the model by then. The others ignore NaN.
double take_from(std::vector<double> values, StudyTake take) {
  if (take == StudyTake::last) return values.back();
  std::erase_if(values, [](double v) { return std::isnan(v); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  switch (take) {
    case StudyTake::last:
      return values.back();
    case StudyTake::max:
      return *std::max_element(values.begin(), values.end());
    case StudyTake::min:
      return *std::min_element(values.begin(), values.end());
    case StudyTake::largest:
      return *std::max_element(values.begin(), values.end(),
                               [](double a, double b) { return std::abs(a) < std::abs(b); });
  }
  return values.back();
}

std::vector<std::filesystem::path> results_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".h5") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

const std::vector<std::string>& study_takes() {
  static const std::vector<std::string> names{"last", "max", "min", "largest"};
  return names;
}

std::string StudyHistory::column() const {
  return history + " " + study_takes()[static_cast<std::size_t>(take)];
}

std::string figure_value_text(const StudyFigure& figure) {
  if (const auto* number = std::get_if<double>(&figure.value)) return fmt::format("{}", *number);
  if (const auto* flag = std::get_if<bool>(&figure.value)) return *flag ? "true" : "false";
  return std::get<std::string>(figure.value);
}

std::string figures_text(const std::vector<StudyFigure>& figures) {
  std::string text;
  for (const StudyFigure& f : figures) {
    constexpr const char* kinds[] = {"number", "text", "flag"};
    text += fmt::format("{}\t{}\t{}\t{}\n", one_field(f.name), one_field(f.unit), kinds[f.value.index()],
                        one_field(figure_value_text(f)));
  }
  return text;
}

std::vector<StudyFigure> figures_from(const std::string& text) {
  std::vector<StudyFigure> figures;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) figures.push_back(figure_of(line));
  return figures;
}

StudyFigure figure_from_results(const std::filesystem::path& folder, const StudyHistory& wanted) {
  std::vector<std::string> known;
  for (const auto& path : results_in(folder)) {
    const results::ResultsReader results(path);
    for (const auto& h : results.header().histories) {
      known.push_back(h.name);
      if (h.name != wanted.history) continue;
      const std::vector<double> values = results.history(h.name);
      if (values.empty()) throw InputError(fmt::format("history '{}' has no values", h.name));
      const UnitSystem units = results.units();
      return {wanted.column(), units.name(h.unit), units.shown(take_from(values, wanted.take), h.unit)};
    }
  }
  if (known.empty()) throw InputError("it left no results with histories; its script needs m:results and m:history");
  throw InputError(fmt::format("its results have no history '{}'{}", wanted.history, name_hint(wanted.history, known)));
}

}  // namespace trilith
