#include "load/motion_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "load/motion_check.hpp"
#include "load/motion_measures.hpp"

namespace trilith {

namespace {

constexpr double cm = 0.01;
constexpr double inch = 0.0254;

/// Lines of a label and its text, aligned; empty texts are omitted.
class Lines {
 public:
  void add(std::string_view label, const std::string& text) {
    if (!text.empty()) fmt::format_to(std::back_inserter(text_), "{:<20} {}\n", label, text);
  }
  std::string take() && { return std::move(text_); }

 private:
  std::string text_;
};

void add_source(Lines& lines, const GroundMotion& motion) {
  const MotionSource& source = motion.source();
  lines.add("motion", motion.description());
  lines.add("title", source.title);
  lines.add("component", source.component);
  lines.add("source", source.agency);
  for (const std::string& note : source.notes) lines.add("note", note);
}

/// Length, and the initial motion if there is one, with which the integrals begin.
void add_samples(Lines& lines, const GroundMotion& motion) {
  lines.add("samples", fmt::format("{} at {:g} s", motion.samples().size(), motion.step()));
  const double begin = motion.start_time();
  lines.add("duration", fmt::format("{:.3f} s", motion.duration()) +
                            (begin == 0 ? "" : fmt::format(", from {:.3f} to {:.3f} s", begin, motion.end_time())));
  const MotionStart start = motion.start();
  if (start.velocity != 0 || start.displacement != 0)
    lines.add("start", fmt::format("{:.4g} cm/s, {:.4g} cm", start.velocity / cm, start.displacement / cm));
}

/// Peaks of acceleration, velocity and displacement, each with its time, signed as in the record.
void add_peaks(Lines& lines, const GroundMotion& motion) {
  const auto [a, v, u] = motion_peaks(motion);
  lines.add("PGA", fmt::format("{:.5f} g ({:.4f} m/s2) at {:.3f} s", a.value / standard_gravity, a.value, a.time));
  lines.add("PGV", fmt::format("{:.3f} cm/s ({:.3f} in/s) at {:.3f} s", v.value / cm, v.value / inch, v.time));
  lines.add("PGD", fmt::format("{:.3f} cm ({:.3f} in) at {:.3f} s", u.value / cm, u.value / inch, u.time));
}

std::string span_text(const TimeSpan& span) {
  if (!(span.length() > 0)) return "0 s";
  return fmt::format("{:.2f} s, from {:.2f} to {:.2f} s", span.length(), span.begin, span.end);
}

/// Measures of intensity: Arias (1970), cumulative absolute velocity, significant durations (shares of the Arias
/// intensity) and the time between the first and last 0.05 g.
void add_intensities(Lines& lines, const GroundMotion& motion) {
  lines.add("Arias intensity", fmt::format("{:.4f} m/s", arias_intensity(motion)));
  lines.add("CAV", fmt::format("{:.4f} m/s", cumulative_absolute_velocity(motion)));
  lines.add("duration D5-75", span_text(significant_duration(motion, 0.05, 0.75)));
  lines.add("duration D5-95", span_text(significant_duration(motion, 0.05, 0.95)));
  lines.add("duration > 0.05 g", span_text(bracketed_duration(motion)));
}

/// `value` in `digits` decimals, without the sign of a rounded zero.
std::string plain(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  return text.starts_with('-') && text.find_first_of("123456789") == std::string::npos ? text.substr(1) : text;
}

}  // namespace

std::string motion_summary(const GroundMotion& motion) {
  Lines lines;
  add_source(lines, motion);
  add_samples(lines, motion);
  add_peaks(lines, motion);
  add_intensities(lines, motion);
  const MotionAt& end = motion.samples().back();
  lines.add("end", plain(end.velocity / cm, 3) + " cm/s, " + plain(end.displacement / cm, 3) + " cm");
  const std::string why = why_not_usable(motion);
  const std::string drift = end_drift(motion);
  lines.add("usable", !why.empty() ? "no: " + why : drift.empty() ? "yes" : "yes; " + drift);
  return std::move(lines).take();
}

}  // namespace trilith
