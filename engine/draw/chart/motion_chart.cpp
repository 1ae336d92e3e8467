#include "draw/chart/motion_chart.hpp"

#include <fmt/format.h>

#include "base/quantity_text.hpp"
#include "load/motion_measures.hpp"
#include "load/response_spectrum.hpp"

namespace trilith::draw {
namespace {

std::string peak_note(const Peak& peak, double unit, const char* name, const UnitSystem& units) {
  return fmt::format("peak {} at {:.2f} s", quantity_text(peak.value / unit, name, units), peak.time);
}

std::vector<double> in_units(std::vector<double> values, double unit) {
  for (double& v : values) v /= unit;
  return values;
}

/// The title of the record without the component at its end, which the line below it shows.
std::string title_of(const GroundMotion& motion) {
  const std::string &title = motion.source().title, component = ", " + motion.source().component;
  const std::size_t at = title.rfind(component);
  const bool ends_with_it = at != std::string::npos && at > 0 && title.find(',', at + 1) == std::string::npos;
  if (motion.source().component.empty() || !ends_with_it) return title.empty() ? motion.description() : title;
  return title.substr(0, at) + title.substr(at + component.size());
}

}  // namespace

Chart motion_chart(const GroundMotion& motion, const UnitSystem& units) {
  const MotionTraces traces = motion_traces(motion);
  const MotionPeaks peaks = motion_peaks(motion);
  Chart chart;
  chart.units = units;
  chart.title = title_of(motion);
  if (!motion.source().component.empty()) chart.subtitle = "component " + motion.source().component;
  chart.x = {"Time", "s"};
  chart.panels = {
      {{"Acceleration", "g"},
       {{"", traces.time, in_units(traces.acceleration, standard_gravity)}},
       peak_note(peaks.acceleration, standard_gravity, "g", units)},
      {{"Velocity", "m/s"}, {{"", traces.time, traces.velocity}}, peak_note(peaks.velocity, 1, "m/s", units)},
      {{"Displacement", "m"}, {{"", traces.time, traces.displacement}}, peak_note(peaks.displacement, 1, "m", units)}};
  return chart;
}

Chart spectrum_chart(const std::vector<GroundMotion>& motions) {
  Chart chart;
  chart.title = "Spectrum, 5 %";
  chart.share = 0.55;
  chart.x = {"Period", "s", AxisScale::logarithmic};
  chart.panels = {{{"Pseudo-acceleration", "g", AxisScale::logarithmic}, {}}};
  for (const GroundMotion& motion : motions) {
    ChartSeries series{motion.source().component, spectrum_periods(0.05, 10), {}};
    for (const OscillatorPeak& peak : response_spectrum(motion, series.x))
      series.y.push_back(peak.pseudo_acceleration / standard_gravity);
    chart.panels[0].series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace trilith::draw
