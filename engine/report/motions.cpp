// Ground motions in a report, from the samples in the results file. Files of earlier program versions contain only the
// processing of each record. If the record is found, the processing is repeated, so that the report contains its
// measures.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/error.hpp"
#include "draw/chart/motion_chart.hpp"
#include "draw/chart/stored_motion.hpp"
#include "load/motion_measures.hpp"
#include "load/motion_read.hpp"
#include "report/sections.hpp"

namespace trilith::report {
namespace {

/// The number after `word` in `step`, as in "time x 0.8"; none if the step begins otherwise.
std::optional<double> number_after(const std::string& step, std::string_view word) {
  if (!step.starts_with(word)) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(step.c_str() + word.size(), &end);
  return end == step.c_str() + word.size() ? std::nullopt : std::optional(value);
}

/// Repeats one processing step of a motion's description. Throws InputError for an unknown step.
GroundMotion done_again(const GroundMotion& motion, const std::string& step) {
  if (step == "reversed") return motion.reversed();
  if (const auto peak = number_after(step, "scaled to PGA ")) return motion.scaled_to_peak(*peak * standard_gravity);
  if (const auto factor = number_after(step, "x ")) return motion.scaled(*factor);
  if (const auto factor = number_after(step, "time x ")) return motion.time_scaled(*factor);
  if (const auto delay = number_after(step, "delayed ")) return motion.delayed(*delay);
  if (const auto advance = number_after(step, "advanced ")) return motion.delayed(-*advance);
  if (const auto start = number_after(step, "from "))
    return step.ends_with("m/s") ? motion.with_start_velocity(*start) : motion.with_start_displacement(*start);
  throw InputError(fmt::format("'{}' is not a known operation on a motion", step));
}

/// A line of the file: "DESCRIPTION on 'BODY' (x), from t = 1.5 s".
struct ToldMotion {
  std::string file, where;
  std::vector<std::string> steps;
  std::string text;
};

ToldMotion told_motion(const std::string& text) {
  ToldMotion out;
  out.text = text;
  const std::size_t on = text.rfind(" on '");
  std::string rest = text.substr(0, on);
  if (on != std::string::npos) out.where = text.substr(on + 4, text.rfind(", from t") - on - 4);
  for (std::size_t at; (at = rest.find(", ")) != std::string::npos; rest.erase(0, at + 2))
    out.steps.push_back(rest.substr(0, at));
  out.steps.push_back(rest);
  out.file = out.steps.front();
  out.steps.erase(out.steps.begin());
  return out;
}

/// None if there is no such record, or if a processing step cannot be repeated.
std::optional<GroundMotion> found_motion(const ToldMotion& told, const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    std::error_code ignored;
    if (told.file.empty() || !std::filesystem::is_regular_file(folder / told.file, ignored)) continue;
    try {
      GroundMotion motion = read_motion(folder / told.file);
      for (const std::string& step : told.steps) motion = done_again(motion, step);
      return motion;
    } catch (const InputError&) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// Peaks, intensity and duration; in radians for a rotating body.
std::vector<std::string> row_of(const std::string& name, const GroundMotion& motion, bool turns = false) {
  const MotionPeaks peaks = motion_peaks(motion);
  const auto size = [](const Peak& peak) { return std::abs(peak.value); };
  if (turns)
    return {name,
            fmt::format("{:.3f} rad/s2", size(peaks.acceleration)),
            fmt::format("{:.3f} rad/s", size(peaks.velocity)),
            fmt::format("{:.3f} rad", size(peaks.displacement)),
            "–",
            "–"};
  return {name,
          fmt::format("{:.3f} g", size(peaks.acceleration) / standard_gravity),
          fmt::format("{:.3f} m/s", size(peaks.velocity)),
          fmt::format("{:.3f} m", size(peaks.displacement)),
          fmt::format("{:.2f} m/s", arias_intensity(motion)),
          fmt::format("{:.1f} s", significant_duration(motion, 0.05, 0.95).length())};
}

std::string told_name(const ToldMotion& told) {
  return fmt::format("{}: {}{}", told.where, told.file, told.steps.empty() ? "" : ", ") +
         fmt::format("{}", fmt::join(told.steps, ", "));
}

/// The first motion over time, all as spectra. `names` of the lines.
void write_motion_figure(const UnitSystem& units, HtmlText& html, const std::vector<GroundMotion>& motions,
                         const std::vector<std::string>& names) {
  write_figure(
      html, "motion", fmt::format("The motion of {}; spectra of all motions, 5 % damped.", names.front()), [&] {
        draw::Chart spectrum = draw::spectrum_chart(motions);
        for (std::size_t i = 0; i < names.size(); ++i) spectrum.panels[0].series[i].name = names[i];
        return draw::chart_canvas({draw::motion_chart(motions.front(), units), spectrum}, draw::Arrangement::beside);
      });
}

/// From the samples in the file, each compared with the position of the body in the frames.
void write_stored(const ReportSource& source, const std::vector<results::MotionRow>& stored, HtmlText& html) {
  const std::vector<double> miss = draw::motion_misses(source.reader, stored);
  std::vector<std::vector<std::string>> rows;
  std::vector<GroundMotion> motions;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const results::MotionRow& row = stored[i];
    const bool turns = row.direction == "rotation";
    const GroundMotion motion = draw::stored_motion(row);
    const std::string where =
        fmt::format("'{}' ({})", source.header.bodies[static_cast<std::size_t>(row.body)].name, row.direction);
    rows.push_back(
        row_of(fmt::format("{} from t = {:g} s: {}", where, row.begin - source.origin.zero, row.text), motion, turns));
    rows.back().push_back(std::isnan(miss[i]) ? "–" : fmt::format("{:.1e} {}", miss[i], turns ? "rad" : "m"));
    if (turns) continue;
    names.push_back(where);
    motions.push_back(motion);
  }
  html.table({"Motion", "PGA", "PGV", "PGD", "Arias", "Duration", "Deviation"}, rows, 1);
  html.element("p",
               "From the samples in the results file. Duration: from 5 to 95 % of the Arias intensity. Deviation: the "
               "largest distance, over all frames, between the position of the body and its prescribed position.",
               R"(class="note")");
  if (!motions.empty()) write_motion_figure(source.units, html, motions, names);
}

void write_missing(const std::vector<std::string>& texts, bool some_found, HtmlText& html) {
  if (texts.empty()) return;
  html.open("ul");
  for (const std::string& text : texts) html.element("li", text);
  html.close();
  html.element(
      "p",
      fmt::format(
          "The results file describes {} motions without their samples, and the records were not found when the report "
          "was made. Peaks, intensity and spectrum are missing here; trilith motion FILE prints them.",
          some_found ? "these" : "the"),
      R"(class="note")");
}

}  // namespace

void write_motions(const ReportSource& source, HtmlText& html) {
  html.element("h2", "Ground motion");
  const std::vector<results::MotionRow> stored = source.reader.motions();
  if (!stored.empty()) return write_stored(source, stored, html);
  std::vector<std::string> missing;
  std::vector<std::vector<std::string>> rows;
  std::vector<GroundMotion> motions;
  std::vector<std::string> names;
  const std::vector<std::string> texts = motion_texts(source);
  for (const std::string& text : texts) {
    const ToldMotion told = told_motion(text);
    const std::optional<GroundMotion> motion = found_motion(told, source.record_folders);
    if (!motion) {
      missing.push_back(text);
      continue;
    }
    rows.push_back(row_of(told_name(told), *motion));
    names.push_back(told.where);
    motions.push_back(*motion);
  }
  if (texts.empty()) html.element("p", "The file names no ground motion.");
  if (!motions.empty()) {
    html.table({"Motion", "PGA", "PGV", "PGD", "Arias", "Duration"}, rows, 1);
    html.element("p",
                 "Duration: from 5 to 95 % of the Arias intensity. The results file holds the operations on the "
                 "records, not their samples: for these figures the records were read and processed again.",
                 R"(class="note")");
    write_motion_figure(source.units, html, motions, names);
  }
  write_missing(missing, !motions.empty(), html);
}

}  // namespace trilith::report
