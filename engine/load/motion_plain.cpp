#include "load/motion_plain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "load/motion_columns.hpp"
#include "load/motion_formats.hpp"
#include "load/motion_read.hpp"
#include "load/motion_samples.hpp"
#include "load/text_lines.hpp"

namespace trilith {
namespace {

// A file of numbers without a named format: columns, or accelerations line by line, after lines of words that become
// the title. The script specifies the unit, and the step if there is no column of times.

struct AccelerationUnit {
  std::string_view name;
  double in_g;
};
constexpr std::array acceleration_units{
    AccelerationUnit{"g", 1.0},
    AccelerationUnit{"m/s2", 1 / standard_gravity},
    AccelerationUnit{"cm/s2", 0.01 / standard_gravity},
    AccelerationUnit{"gal", 0.01 / standard_gravity},
    AccelerationUnit{"mm/s2", 0.001 / standard_gravity},
    AccelerationUnit{"in/s2", 0.0254 / standard_gravity},
    AccelerationUnit{"ft/s2", 0.3048 / standard_gravity},
};

/// Size of the unit in g, the factor of samples; InputError for an unknown unit.
double unit_in_g(const std::string& name, const std::string& file) {
  for (const AccelerationUnit& unit : acceleration_units)
    if (unit.name == name) return unit.in_g;
  throw InputError(fmt::format("motion file '{}': unit is '{}', must be one of {}", file, name, plain_units()));
}

/// The mean step of the times. They must be uniform within 10 % of it, or within their rounding if the step is given.
double even_step(const std::vector<double>& times, double resolution, bool given, const TextLines& lines) {
  const std::size_t n = times.size();
  if (n < 2) lines.fail_whole("has fewer than 2 samples");
  const double step = (times.back() - times.front()) / static_cast<double>(n - 1);
  if (!(step > 0)) lines.fail_whole("has times that do not increase");
  const double rounded = 1.01 * resolution, allowed = std::max(0.1 * step, given ? rounded : 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double due = times.front() + static_cast<double>(i) * step, off = std::abs(times[i] - due);
    if (off > allowed)
      lines.fail_whole(
          fmt::format("sample {} is at {:g} s, must be at {:g} s: the step must be uniform{}", i + 1, times[i], due,
                      off > rounded ? "" : fmt::format("; times are rounded to {:g} s, so give dt", resolution)));
  }
  return step;
}

/// Rejects times that no record has in seconds: sample numbers, or another unit.
[[noreturn]] void refuse_times(double step, double resolution, const TextLines& lines) {
  const bool numbers = resolution == 1 && std::abs(step - 1) < 1e-9;
  lines.fail_whole(fmt::format(
      "has times that increase by {:g} per sample, {}; give the step in seconds, as in dt = {:g}", step,
      numbers ? "like sample numbers" : "too much for seconds: they look like ms", numbers ? 0.01 : step / 1000));
}

/// True if a column of times names ms as its unit: "time ms", "t [msec]".
bool names_ms(const std::string& name) {
  const std::string lower = lower_case(name);
  for (const std::string_view word : words_of(lower, "()[]_/,"))
    if (word == "ms" || word == "msec" || word == "milliseconds") return true;
  return false;
}

/// A given step applies if the times agree with it within their rounding: as seconds, as ms or as sample numbers.
double given_step(double step, double resolution, std::size_t n, double given, const TextLines& lines) {
  for (const double size : {1.0, 1e-3, 1e-6, given})  // of the times' unit [s]
    if (std::abs(step * size - given) <=
        std::max(1e-3 * given, 0.9999 * size * resolution / static_cast<double>(n - 1)))
      return given;
  lines.fail_whole(fmt::format("has steps of {:g} s, dt is given as {:g} s", step, given));
}

double step_of(const NumberTable& table, std::size_t time, const PlainForm& form, const TextLines& lines) {
  if (time == RecordColumns::none) return *form.step;
  const double resolution = table.resolution[time];
  const double step = even_step(table.column(time), resolution, form.step.has_value(), lines);
  if (form.step) return given_step(step, resolution, table.rows(), *form.step, lines);
  if (step > largest_credible_step || names_ms(table.name(time))) refuse_times(step, resolution, lines);
  return step;
}

/// Rejects a first sample that is a number of the head: the step, the rate, the number of samples.
void refuse_number_of_head(const std::vector<double>& samples, double step, const TextLines& lines) {
  const auto n = static_cast<double>(samples.size());
  const double first = samples.empty() ? 0 : samples[0];
  const auto is = [first](double number) { return std::abs(first - number) <= 1e-9 * std::abs(number); };
  const char* const what = n < 10                                    ? ""
                           : is(step)                                ? "the step of the samples"
                           : first >= 10 && is(1 / step)             ? "the samples in a second"
                           : first >= 10 && (is(n - 1) || is(n - 2)) ? "the number of samples that follow"
                           : first >= 10 && is((n - 1) * step)       ? "the duration"
                                                                     : "";
  if (*what != 0)
    lines.fail_whole(fmt::format(
        "begins with {:g}, which is {}; give the number of header lines (skip = 1), or skip = 0 if it is a sample",
        first, what));
}

/// The unit comes from the script, so an unphysical peak indicates a wrong unit.
void check_peak(const std::vector<double>& in_g, const std::string& unit, const TextLines& lines) {
  double peak = 0;
  for (const double a : in_g) peak = std::max(peak, std::abs(a));
  if (peak > largest_credible_peak)
    lines.fail_whole(
        fmt::format("peak is {:.3g} g with unit = \"{}\", above {:g} g; probably the values are in another unit of {}",
                    peak, unit, largest_credible_peak, plain_units()));
}

}  // namespace

std::string plain_units() {
  std::string text;
  for (const AccelerationUnit& unit : acceleration_units) text += (text.empty() ? "" : ", ") + std::string(unit.name);
  return text;
}

/// A named format contains its unit and step; values of the script must agree.
GroundMotion parse_named_motion(std::string_view text, const std::string& name, const PlainForm& form,
                                const MotionFormat& format) {
  TextLines lines(text, name);
  if (!format.unit.empty() && unit_in_g(form.unit, name) != unit_in_g(std::string(format.unit), name))
    lines.fail_whole(
        fmt::format("is {}, whose samples are in {}; unit is given as {}. Leave the unit out, or give the number of "
                    "header lines (skip) to read it as plain columns",
                    format.name, format.unit, form.unit));
  GroundMotion motion = parse_motion(text, name);
  if (form.step && std::abs(*form.step - motion.step()) > 1e-6 * motion.step())
    lines.fail_whole(fmt::format("is {}, whose step is {:g} s; dt is given as {:g} s. Leave dt out", format.name,
                                 motion.step(), *form.step));
  return motion;
}

/// Tries named formats first, then columns of numbers.
GroundMotion parse_plain_motion(std::string_view text, const std::string& name, const PlainForm& form) {
  text = without_padding(without_byte_order_mark(text));
  const double in_g = unit_in_g(form.unit, name);
  TextLines lines(text, name);
  if (form.step && !(*form.step > 0)) lines.fail_whole(fmt::format("dt is {:g} s, must be above 0", *form.step));
  if (const MotionFormat format = named_format(text, name); format && !form.skip)
    return parse_named_motion(text, name, form, format);
  const NumberTable table = read_number_table(lines, text, form);
  if (table.values.empty()) lines.fail_whole("has no numbers");
  const RecordColumns columns = find_record_columns(table, form, lines);
  const bool all = columns.acceleration == RecordColumns::none;
  const double step = step_of(table, columns.time, form, lines);
  std::vector<double> samples = all ? table.values : table.column(columns.acceleration);
  if (all && !form.skip) refuse_number_of_head(samples, step, lines);
  for (double& value : samples) value *= in_g;
  check_peak(samples, form.unit, lines);
  MotionSource source;
  source.file = name, source.title = table.title;
  if (table.width > 1 && !all) source.component = table.name(columns.acceleration);
  const std::size_t count = samples.size();
  return motion_from_g(std::move(samples), count, step, {}, std::move(source), lines);
}

GroundMotion read_plain_motion(const std::filesystem::path& path, const PlainForm& form) {
  constexpr std::size_t largest_file = std::size_t{512} << 20;  // [bytes]
  return parse_plain_motion(text_of_file(path, "motion file", largest_file), path.string(), form);
}

}  // namespace trilith
