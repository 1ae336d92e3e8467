#include "load/motion_plain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "load/motion_read.hpp"
#include "load/motion_samples.hpp"
#include "load/text_lines.hpp"

namespace trilith {
namespace {

// A file of numbers that says nothing of itself: one or two columns, or many accelerations in a line, after lines of
// words that become the title. The script says the unit, and the step where there is no column of times.

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

/// Its size in g, by which samples are multiplied; InputError for a unit that is not known.
double unit_in_g(const std::string& name, const std::string& file) {
  for (const AccelerationUnit& unit : acceleration_units)
    if (unit.name == name) return unit.in_g;
  throw InputError(fmt::format("motion file '{}': unit is '{}', must be one of {}", file, name, plain_units()));
}

/// The columns of a file, and the lines that stood before them.
struct Columns {
  std::vector<double> times, values;
  std::string title;
};

/// The first line of numbers decides: two columns are time and acceleration, anything else is accelerations in a row.
void read_line(TextLines& lines, std::string_view line, const PlainForm& form, Columns& columns) {
  const std::vector<std::string_view> words = words_of(line, ",;");
  if (columns.values.empty() && !number_in(words.empty() ? line : words[0])) {
    columns.title += (columns.title.empty() ? "" : ", ") + shown(line);
    return;
  }
  std::vector<double> numbers;
  for (const std::string_view word : words) numbers.push_back(lines.require_number(word, "value"));
  const bool with_time = columns.values.empty() ? numbers.size() == 2 : !columns.times.empty();
  if (with_time && numbers.size() != 2)
    lines.fail(fmt::format("has {} columns, the first line of numbers has 2: time and acceleration", numbers.size()));
  if (with_time) {
    columns.times.push_back(numbers[0]);
    columns.values.push_back(numbers[1]);
    return;
  }
  if (!form.step)
    lines.fail(fmt::format("has {} column(s) and no time; say the step of the samples (dt)", numbers.size()));
  columns.values.insert(columns.values.end(), numbers.begin(), numbers.end());
}

/// The mean step of the times, where they are uniform.
double step_of(const Columns& columns, const PlainForm& form, const TextLines& lines) {
  if (columns.times.empty()) return *form.step;
  const std::size_t n = columns.times.size();
  if (n < 2) lines.fail_whole("has fewer than 2 samples");
  const double step = (columns.times.back() - columns.times.front()) / static_cast<double>(n - 1);
  if (!(step > 0)) lines.fail_whole("has times that do not grow");
  for (std::size_t i = 0; i < n; ++i) {
    const double due = columns.times.front() + static_cast<double>(i) * step;
    // Times are mostly rounded to a few decimals, which moves none by a tenth of a step.
    if (std::abs(columns.times[i] - due) > 0.1 * step)
      lines.fail_whole(fmt::format("sample {} is at {:g} s, must be at {:g} s: the step must be uniform", i + 1,
                                   columns.times[i], due));
  }
  if (form.step && std::abs(*form.step - step) > 1e-3 * step)
    lines.fail_whole(fmt::format("has steps of {:g} s, dt is given as {:g} s", step, *form.step));
  return form.step.value_or(step);
}

/// The unit is the script's word, so it is that which a size beyond any ground speaks against.
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

/// Line by line; what is no number before the first sample is the title, later it is an error.
GroundMotion parse_plain_motion(std::string_view text, const std::string& name, const PlainForm& form) {
  text = without_byte_order_mark(text);
  const double in_g = unit_in_g(form.unit, name);
  TextLines lines(text, name);
  Columns columns;
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (content.empty() || content[0] == '#' || content[0] == '%') continue;
    read_line(lines, content, form, columns);
  }
  if (columns.values.empty()) lines.fail_whole("has no numbers");
  const double step = step_of(columns, form, lines);
  for (double& value : columns.values) value *= in_g;
  check_peak(columns.values, form.unit, lines);
  MotionSource source;
  source.file = name, source.title = columns.title;
  const std::size_t count = columns.values.size();
  return motion_from_g(std::move(columns.values), count, step, {}, std::move(source), lines);
}

GroundMotion read_plain_motion(const std::filesystem::path& path, const PlainForm& form) {
  constexpr std::size_t largest_file = std::size_t{512} << 20;  // [bytes]
  return parse_plain_motion(text_of_file(path, "motion file", largest_file), path.string(), form);
}

}  // namespace trilith
