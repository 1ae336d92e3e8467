#include "load/motion_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "base/nearest.hpp"
#include "load/motion_measures.hpp"
#include "load/motion_samples.hpp"
#include "load/text_lines.hpp"

namespace trilith {

namespace {

// The project's CSV form: header lines "# key: value" in any order, then one sample per line.
//
//     # units: g                unit of accelerations, which must be g
//     # dt: 0.02 s              uniform step
//     # npts: 2688              number of samples
//     # v0: -1.2 cm/s           velocity and displacement at the start, if the source contains them
//     # pga: 0.34874 g          check value, optional
//     0.00,-0.0014
//     0.02,-0.0110
//
// Every line is checked when it is read, so that messages contain the line.

struct CsvHeader {
  MotionSource source;
  MotionStart start;
  bool unit_is_g = false;
  std::optional<double> step;        // [s]
  std::optional<std::size_t> count;  // samples
  std::optional<double> peak;        // [g], signed as in the file
  std::vector<std::string> seen;     // keys met so far
};

struct Unit {
  std::string_view name;
  double in_si;
};
constexpr std::array<Unit, 5> speed_units{
    {{"cm/s", 0.01}, {"m/s", 1}, {"mm/s", 0.001}, {"in/s", 0.0254}, {"ft/s", 0.3048}}};
constexpr std::array<Unit, 5> length_units{{{"cm", 0.01}, {"m", 1}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};
constexpr std::array<Unit, 1> time_units{{{"s", 1}}};

/// "12.3 cm/s" in SI units. The unit is required and must be one of `units`.
double quantity(std::string_view text, std::span<const Unit> units, std::string_view key, const TextLines& lines) {
  const auto words = words_of(text);
  const double value = lines.require_number(words.empty() ? text : words[0], key);
  std::string allowed;
  for (const Unit& unit : units) {
    if (words.size() == 2 && words[1] == unit.name) return value * unit.in_si;
    allowed += (allowed.empty() ? "" : ", ") + std::string(unit.name);
  }
  lines.fail(fmt::format("{} is '{}', must be one number and its unit ({})", key, shown(text), allowed));
}

/// The step with its unit, above 0.
double read_step(std::string_view text, const TextLines& lines) {
  const double step = quantity(text, time_units, "dt", lines);
  if (!(step > 0)) lines.fail(fmt::format("dt is {:g} s, must be above 0", step));
  return step;
}

void require_unit_g(std::string_view text, const TextLines& lines) {
  if (text != "g")
    lines.fail(fmt::format("unit is '{}', must be g; convert the values to g (980.665 cm/s2)", shown(text)));
}

/// Reader of one header key.
struct Key {
  std::string_view name;
  void (*read)(CsvHeader& header, std::string_view value, const TextLines& lines);
};
constexpr std::array<Key, 11> keys{{
    {"title", [](CsvHeader& h, std::string_view v, const TextLines&) { h.source.title = v; }},
    {"component", [](CsvHeader& h, std::string_view v, const TextLines&) { h.source.component = v; }},
    {"source agency", [](CsvHeader& h, std::string_view v, const TextLines&) { h.source.agency = v; }},
    {"note", [](CsvHeader& h, std::string_view v, const TextLines&) { h.source.notes.emplace_back(v); }},
    {"columns",
     [](CsvHeader&, std::string_view v, const TextLines& lines) {
       if (v != "time_s,acceleration_g")
         lines.fail(fmt::format("columns are '{}', must be 'time_s,acceleration_g'", shown(v)));
     }},
    {"units",
     [](CsvHeader& h, std::string_view v, const TextLines& lines) {
       require_unit_g(v, lines);
       h.unit_is_g = true;
     }},
    {"dt", [](CsvHeader& h, std::string_view v, const TextLines& lines) { h.step = read_step(v, lines); }},
    {"npts",
     [](CsvHeader& h, std::string_view v, const TextLines& lines) { h.count = lines.require_count(v, "npts"); }},
    {"v0", [](CsvHeader& h, std::string_view v,
              const TextLines& lines) { h.start.velocity = quantity(v, speed_units, "v0", lines); }},
    {"u0", [](CsvHeader& h, std::string_view v,
              const TextLines& lines) { h.start.displacement = quantity(v, length_units, "u0", lines); }},
    {"pga",  // "0.34874 g at 2.120 s": a check on the samples
     [](CsvHeader& h, std::string_view v, const TextLines& lines) {
       const auto words = words_of(v);
       h.peak = lines.require_number(words.empty() ? v : words[0], "pga");
       if (words.size() < 2 || words[1] != "g") lines.fail(fmt::format("pga is '{}', must be in g", shown(v)));
     }},
}};

/// An unknown key is a remark, unless it resembles one of the known keys.
void refuse_misspelt(const std::string& key, const TextLines& lines) {
  std::vector<std::string> known;
  known.reserve(keys.size());
  for (const Key& k : keys) known.emplace_back(k.name);
  const std::string near = nearest_name(key, known);
  if (!near.empty()) lines.fail(fmt::format("unknown header key '{}'; did you mean '{}'?", shown(key), near));
}

void read_header_line(std::string_view line, CsvHeader& header, const TextLines& lines) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos) return;
  const std::string key = lower_case(trimmed(line.substr(1, colon - 1)));
  const std::string_view value = trimmed(line.substr(colon + 1));
  for (const Key& known : keys) {
    if (key != known.name) continue;
    if (key != "note" && std::find(header.seen.begin(), header.seen.end(), key) != header.seen.end())
      lines.fail(fmt::format("header key '{}' is given twice", key));
    header.seen.push_back(key);
    return known.read(header, value, lines);
  }
  refuse_misspelt(key, lines);
}

/// Requires the data without which the samples cannot be read: their unit, their step and their number.
void require_complete(const CsvHeader& header, const TextLines& lines) {
  const auto missing = [&lines](std::string_view line) {
    lines.fail_whole(fmt::format("header lacks the line '# {}'", line));
  };
  if (!header.unit_is_g) missing("units: g");
  if (!header.step) missing("dt: 0.02 s");
  if (!header.count) missing("npts: 2688");
}

/// "0.02,-0.0110": the acceleration [g] of sample `index`, after a check of its time.
double read_sample(std::string_view line, std::size_t index, double step, const TextLines& lines) {
  const auto comma = line.find(',');
  if (comma == std::string_view::npos) lines.fail(fmt::format("must be 'time,acceleration', is '{}'", shown(line)));
  const double time = lines.require_number(trimmed(line.substr(0, comma)), "time");
  const double due = static_cast<double>(index) * step;
  if (std::abs(time - due) > 0.1 * step)  // permits times rounded to few decimals
    lines.fail(
        fmt::format("time is {:g} s, must be {:g} s: the step must be uniform, {:g} s by the header", time, due, step));
  return lines.require_number(trimmed(line.substr(comma + 1)), "acceleration");
}

/// Within 0.1 %: headers are rounded, and a file cut or scaled by hand deviates by more.
void require_announced_peak(const GroundMotion& motion, double announced, const TextLines& lines) {
  const double peak = motion_peaks(motion).acceleration.value / standard_gravity;
  if (std::abs(peak - announced) > 1e-3 * std::abs(peak))
    lines.fail_whole(fmt::format("header says pga {:g} g, the samples have {:g} g; damaged, or the header is stale",
                                 announced, peak));
}

}  // namespace

/// Reads the header line by line, then sample by sample; the announced peak is compared at the end.
GroundMotion parse_csv_motion(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  CsvHeader header;
  header.source.file = name;
  std::vector<double> acceleration;  // [g]
  bool in_header = true;
  while (const auto given = lines.next()) {
    const std::string_view line = trimmed(*given);
    if (line.empty()) continue;
    if (line.starts_with('#')) {
      if (!in_header) lines.fail("header line after the first sample");
      read_header_line(line, header, lines);
      continue;
    }
    if (in_header) require_complete(header, lines);
    in_header = false;
    if (acceleration.size() == *header.count)
      lines.fail(fmt::format("more samples than the {} the header announces", *header.count));
    acceleration.push_back(read_sample(line, acceleration.size(), *header.step, lines));
  }
  require_complete(header, lines);
  GroundMotion motion = motion_from_g(std::move(acceleration), *header.count, *header.step, header.start,
                                      std::move(header.source), lines);
  if (header.peak) require_announced_peak(motion, *header.peak, lines);
  return motion;
}

}  // namespace trilith
