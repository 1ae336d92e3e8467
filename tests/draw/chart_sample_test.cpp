// Charts for inspection; checked: they are drawn, and their texts stay on the page.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "draw/chart/chart.hpp"
#include "draw/chart/energy_chart.hpp"
#include "draw/sample_pictures.hpp"

using namespace trilith;
using namespace trilith::draw;

namespace {

/// An invented ground acceleration [m/s2]: three sines under an envelope.
std::vector<double> made_up_motion(std::size_t count, double dt) {
  std::vector<double> a(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * dt, envelope = t * std::exp(1 - t / 3) / 3 + 0.1 * std::exp(-t / 20);
    a[i] = envelope * (2 * std::sin(11 * t) + 1.3 * std::sin(23.7 * t + 1) + 0.8 * std::sin(4.1 * t + 2));
  }
  return a;
}

std::vector<double> integral(const std::vector<double>& a, double dt) {
  std::vector<double> v(a.size());
  for (std::size_t i = 1; i < a.size(); ++i) v[i] = v[i - 1] + dt * (a[i - 1] + a[i]) / 2;
  return v;
}

std::vector<double> times(std::size_t count, double dt) {
  std::vector<double> t(count);
  for (std::size_t i = 0; i < count; ++i) t[i] = static_cast<double>(i) * dt;
  return t;
}

/// Greatest |acceleration| of a damped oscillator by small central difference steps.
double spectral_acceleration(const std::vector<double>& a, double dt, double period, double damping) {
  const double w = 2 * std::numbers::pi / period, h = std::min(dt, period / 40);
  double u = 0, v = 0, most = 0;
  for (double t = 0; t < dt * static_cast<double>(a.size() - 1); t += h) {
    const double place = t / dt;
    const auto i = std::min(static_cast<std::size_t>(place), a.size() - 2);
    const double ground = std::lerp(a[i], a[i + 1], place - static_cast<double>(i));
    v += h * (-ground - 2 * damping * w * v - w * w * u);
    u += h * v;
    most = std::max(most, std::abs(2 * damping * w * v + w * w * u));
  }
  return most;
}

Chart spectrum_chart(const std::vector<double>& a, double dt) {
  ChartSeries series{"ground", {}, {}};
  for (double period = 0.05; period < 10; period *= 1.06) {
    series.x.push_back(period);
    series.y.push_back(spectral_acceleration(a, dt, period, 0.05));
  }
  Chart chart;
  chart.title = "Response spectrum, 5 % damping";
  chart.x = {"Period", "s", AxisScale::logarithmic};
  chart.panels = {{{"Spectral acceleration", "m/s2", AxisScale::logarithmic}, {series}, ""}};
  chart.share = 0.62;
  return chart;
}

void show(const std::vector<Chart>& charts, Arrangement arrangement, const char* name) {
  const Canvas canvas = chart_canvas(charts, arrangement);
  testing::check_texts(canvas);
  for (const char* ending : {".png", ".svg", ".pdf"})
    draw_charts(charts, arrangement, testing::picture_path((std::string(name) + ending).c_str()));
}

}  // namespace

TEST_CASE("sample picture: three traces of a motion and its spectrum next to them") {
  const double dt = 0.005;
  const std::vector<double> a = made_up_motion(6000, dt), v = integral(a, dt), u = integral(v, dt),
                            t = times(a.size(), dt);
  Chart traces;
  traces.title = "Made-up motion";
  traces.subtitle = "6,000 points at 0.005 s";
  traces.x = {"Time", "s"};
  traces.panels = {{{"Acceleration", "m/s2"}, {{"ground", t, a}}, "peak 4.1 m/s² at 3.1 s"},
                   {{"Velocity", "m/s"}, {{"ground", t, v}}, "peak 0.23 m/s at 3.2 s"},
                   {{"Displacement", "m"}, {{"ground", t, u}}, "peak 61 mm at 20.1 s"}};
  show({traces, spectrum_chart(a, dt)}, Arrangement::beside, "motion_beside");
  show({traces, spectrum_chart(a, dt)}, Arrangement::below, "motion_below");
}

TEST_CASE("sample picture: runs overlaid with event marks") {
  const double dt = 0.01;
  const std::vector<double> a = made_up_motion(3000, dt), t = times(a.size(), dt);
  Chart chart;
  chart.title = "Displacement of span 3 against its seat";
  chart.subtitle = "bridge.lua, pga 0.8 g";
  chart.x = {"Time", "s"};
  std::vector<ChartSeries> runs;
  for (const double factor : {1.0, 0.7, 0.45}) {
    ChartSeries run{"pga " + std::to_string(factor * 0.8).substr(0, 4) + " g", t, {}};
    for (const double x : a) run.y.push_back(0.03 * factor * x);
    runs.push_back(run);
  }
  runs[1].dash = Dash::dashed;
  chart.panels = {{{"Slip", "m"}, runs, ""}};
  chart.marks = {{11.0, "span 3: fixed bearing fails"},
                 {14.4, "span 3: seat lost"},
                 {15.9, "span 3 hits ground"},
                 {16.3, "span 3 hits pier 2"},
                 {17.7, "span 1 falls"}};
  show({chart}, Arrangement::below, "runs_marks");
  for (int i = 0; i < 9; ++i)
    chart.marks.push_back({18 + 0.4 * i, "a bearing of span " + std::to_string(i) + " fails"});
  show({chart}, Arrangement::below, "runs_many_marks");
}

TEST_CASE("sample picture: energy, stacked and as lines") {
  const double dt = 0.01;
  const std::vector<double> t = times(2000, dt);
  std::vector<double> kinetic(t.size()), stored(t.size()), friction(t.size()), damping(t.size()), input(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double envelope = t[i] * std::exp(-t[i] / 4);
    kinetic[i] = 4e5 * envelope * std::pow(std::sin(3 * t[i]), 2);
    stored[i] = 4e5 * envelope * std::pow(std::cos(3 * t[i]), 2);
    friction[i] = 2e6 * (1 - std::exp(-t[i] / 5));
    damping[i] = 0.8e6 * (1 - std::exp(-t[i] / 7));
    input[i] = kinetic[i] + stored[i] + friction[i] + damping[i];
  }
  const std::vector<EnergyCurve> terms = {
      {"friction", friction}, {"damping", damping}, {"stored", stored}, {"kinetic", kinetic}, {"input", input, true}};
  show({energy_chart(t, terms, EnergyView::stacked)}, Arrangement::below, "energy_stacked");
  show({energy_chart(t, terms, EnergyView::lines)}, Arrangement::below, "energy_lines");
}
