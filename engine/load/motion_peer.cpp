#include "load/motion_peer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "load/motion_samples.hpp"
#include "load/text_lines.hpp"

namespace trilith {

namespace {

// The PEER centre's AT2 form: four lines of header (agency, title, unit, count and step), then samples in g, about five
// per line.

struct PeerHeader {
  MotionSource source;
  std::size_t count = 0;
  double step = 0;  // [s]
};

/// The next line without the blanks around it.
std::string_view header_line(TextLines& lines) {
  const auto line = lines.next();
  if (!line) lines.fail_whole("is cut short: an AT2 file has 4 header lines");
  return trimmed(*line);
}

/// Third line, e.g. "ACCELERATION TIME SERIES IN UNITS OF G. FILTER POINTS: ...".
void require_units_of_g(std::string_view line, const TextLines& lines) {
  const std::string lower = lower_case(line);
  const std::string mark = "units of ";
  const auto at = lower.find(mark);
  if (at == std::string::npos)
    lines.fail(fmt::format("must say 'UNITS OF G', says '{}'; is this an AT2 file?", shown(line)));
  const auto words = words_of(std::string_view(lower).substr(at + mark.size()), ",;");
  if (words.empty() || (words[0] != "g" && words[0] != "g."))
    lines.fail(
        fmt::format("unit is '{}', must be G; convert the values and this line to g, or give unit, dt and skip = 4",
                    words.empty() ? "" : shown(words[0])));
}

/// The unit of the step: "0.0100 SEC", "20.0 MSEC"; seconds without a unit.
double step_unit(std::string_view word) {
  return word == "msec" || word == "ms" || word == "milliseconds" ? 1e-3 : 1;
}

/// Fourth line: `NPTS= 5372, DT= .0100 SEC,` or `NPTS= 4000, DT= .01000 SEC` or `4000 0.0100 NPTS, DT`. It may also
/// contain the names alone, with the numbers after them in the same line or in the next.
void read_counts(std::string_view line, PeerHeader& header, TextLines& lines) {
  std::string lower = lower_case(line);
  const std::vector<std::string_view> named = words_of(lower, "=,:");
  std::string text = lower;
  if (named.size() == 2 && named[0] == "npts" && named[1] == "dt")
    if (const auto next = lines.next()) text += " " + lower_case(trimmed(*next));
  const auto words = words_of(text, "=,:");
  const auto at = [&words](std::size_t i) { return i < words.size() ? words[i] : std::string_view(); };
  std::size_t count = 1, step = 3;  // NPTS n DT dt
  if (at(0) == "npts" && at(1) == "dt")
    count = 2, step = 3;  // NPTS DT n dt
  else if (at(2) == "npts" && at(3) == "dt")
    count = 0, step = 1;  // n dt NPTS DT
  else if (words.size() < 4 || at(0) != "npts" || at(2) != "dt" || at(3).empty())
    lines.fail(fmt::format("must be like 'NPTS= 5372, DT= 0.0100 SEC', is '{}'", shown(line)));
  header.count = lines.require_count(at(count), "NPTS");
  header.step = lines.require_number(at(step), "DT") * step_unit(at(step + 1));
  if (!(header.step > 0)) lines.fail(fmt::format("DT is {:g} s, must be above 0", header.step));
}

/// True for an azimuth in degrees, a compass direction or a name of the vertical: "180", "N90E", "NS", "UP".
bool is_component(std::string_view word) {
  constexpr std::array<std::string_view, 18> names{"n",   "s",  "e",  "w",   "z",  "v",    "ns",  "n-s",  "ew",
                                                   "e-w", "up", "dn", "dwn", "ud", "down", "ver", "vert", "vertical"};
  const std::string lower = lower_case(word);
  if (std::find(names.begin(), names.end(), lower) != names.end()) return true;
  std::string_view digits = lower;
  if (digits.size() == 4 && (digits[0] == 'n' || digits[0] == 's') && (digits[3] == 'e' || digits[3] == 'w'))
    digits = digits.substr(1, 2);
  const bool is_number = digits.find_first_not_of("0123456789") == std::string_view::npos;
  return is_number && !digits.empty() && digits.size() <= 3;
}

/// The component follows the last comma of the title, as in "EL CENTRO, 5/19/1940, ARRAY #9, 180". Text in brackets
/// after it is left out; "" if the last part of the title is something else.
std::string component_of(std::string_view title) {
  const auto comma = title.rfind(',');
  if (comma == std::string_view::npos) return "";
  const std::string_view last = trimmed(title.substr(comma + 1)), word = trimmed(last.substr(0, last.find('(')));
  return is_component(word) ? std::string(word) : "";
}

PeerHeader read_header(TextLines& lines, bool skip_empty) {
  PeerHeader header;
  do header.source.agency = header_line(lines);
  while (skip_empty && header.source.agency.empty());
  header.source.title = header_line(lines);
  header.source.component = component_of(header.source.title);
  const std::string_view third = header_line(lines);
  require_units_of_g(third, lines);
  header.source.notes.emplace_back(third);
  read_counts(header_line(lines), header, lines);
  return header;
}

}  // namespace

bool names_samples_in_fourth_line(std::string_view text, bool skip_empty) {
  TextLines lines(text, "");
  int seen = 0;
  while (const auto line = lines.next()) {
    if (skip_empty && seen == 0 && trimmed(*line).empty()) continue;
    if (++seen == 4) return lower_case(*line).find("npts") != std::string::npos;
  }
  return false;
}

/// Four lines of header, then samples, several per line.
GroundMotion parse_peer_motion(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  PeerHeader header = read_header(lines, !names_samples_in_fourth_line(text, false));
  header.source.file = name;
  std::vector<double> acceleration;  // [g]
  while (const auto line = lines.next()) {
    for (const std::string_view word : words_of(*line)) {
      if (acceleration.size() == header.count)
        lines.fail(fmt::format("more samples than the {} the header announces", header.count));
      acceleration.push_back(lines.require_number(word, "acceleration"));
    }
  }
  return motion_from_g(std::move(acceleration), header.count, header.step, {}, std::move(header.source), lines);
}

}  // namespace trilith
