#include "draw/chart/plot_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "draw/chart/axis_ticks.hpp"

namespace trilith::draw {
namespace {

/// Beyond this the span of an axis could overflow; such a value is shown as a gap. A span below its inverse counts as
/// zero.
constexpr double most_value = 1e150, least_span = 1 / most_value;

void check_ends(const ChartAxis& axis, const std::string& where) {
  for (const auto& end : {axis.low, axis.high}) {
    if (!end) continue;
    require_finite(*end, where + ": end of the axis");
    if (axis.scale == AxisScale::logarithmic && *end <= 0)
      throw InputError(fmt::format("{}: end of a logarithmic axis is {:g}, must be above 0", where, *end));
  }
  if (axis.low && axis.high && !(*axis.low < *axis.high))
    throw InputError(
        fmt::format("{}: axis from {:g} to {:g}, the first must be below the second", where, *axis.low, *axis.high));
}

void fit_linear(PlotAxis& out, const ChartAxis& axis, double margin) {
  // Constant up to rounding: there is no span to divide into ticks.
  const double largest = std::max(std::abs(out.low), std::abs(out.high));
  if (out.high - out.low <= std::max(1e-10 * largest, least_span)) {
    const double half = largest <= least_span ? 1 : 0.1 * largest;
    out.low -= half, out.high += half;
  }
  const double free_room = margin * (out.high - out.low);
  // Data that starts or ends at zero keeps zero as the axis' end: a height, a count, a response spectrum.
  if (!axis.low && out.low != 0) out.low -= free_room;
  if (!axis.high && out.high != 0) out.high += free_room;
}

/// Extends the axis to a near tick: a record of 29.99 s ends at the tick of 30 s.
void end_on_near_tick(PlotAxis& out, const ChartAxis& axis, int most_ticks) {
  const double span = out.high - out.low, near = 0.03 * span;
  const std::vector<double> ticks = linear_ticks(out.low - near, out.high + near, most_ticks);
  if (ticks.size() < 2) return;
  if (!axis.low && ticks.front() < out.low) out.low = ticks.front();
  if (!axis.high && ticks.back() > out.high) out.high = ticks.back();
}

void fit_logarithmic(PlotAxis& out, const ChartAxis& axis, double margin) {
  if (out.high <= out.low * (1 + 1e-10)) out.low /= 2, out.high *= 2;
  const double factor = std::pow(out.high / out.low, margin);
  if (!axis.low) out.low /= factor;
  if (!axis.high) out.high *= factor;
}

std::string axis_title(const std::string& label, const std::string& unit) {
  if (unit.empty()) return label;
  return label.empty() ? unit : fmt::format("{} ({})", label, unit);
}

}  // namespace

double PlotAxis::share(double value) const {
  const double part =
      scale == AxisScale::linear ? (value - low) / (high - low) : std::log(value / low) / std::log(high / low);
  return std::clamp(part, -20.0, 21.0);
}

bool PlotAxis::can_show(double value) const {
  return std::isfinite(value) && std::abs(value) < most_value && (scale == AxisScale::linear || value > least_span);
}

void ValueRange::add(double value) {
  low = any ? std::min(low, value) : value;
  high = any ? std::max(high, value) : value;
  any = true;
}

namespace {

/// An axis of words, at unit distance.
PlotAxis word_axis(const ChartAxis& axis) {
  PlotAxis out;
  out.low = -0.5, out.high = static_cast<double>(axis.words.size()) - 0.5;
  for (std::size_t i = 0; i < axis.words.size(); ++i) out.ticks.push_back(static_cast<double>(i));
  out.texts = axis.words;
  out.title = axis_title(axis.label, axis.unit);
  return out;
}

}  // namespace

PlotAxis plot_axis(const ChartAxis& axis, const ValueRange& range, double margin, int most_ticks,
                   const std::string& where, const UnitSystem& units) {
  assert(range.any);
  check_ends(axis, where);
  if (!axis.words.empty()) return word_axis(axis);
  PlotAxis out;
  out.scale = axis.scale;
  out.low = axis.low.value_or(range.low);
  out.high = axis.high.value_or(range.high);
  // A fixed end beyond all data leaves no data for the free end.
  if (out.low >= out.high && axis.low) out.high = out.low + std::max(1.0, std::abs(out.low));
  if (out.low >= out.high && axis.high) out.low = axis.scale == AxisScale::linear ? out.high - 1 : out.high / 10;
  if (axis.scale == AxisScale::linear) {
    fit_linear(out, axis, margin);
    if (margin == 0) end_on_near_tick(out, axis, most_ticks);
  } else {
    fit_logarithmic(out, axis, margin);
  }

  const ShownUnit unit = engineering_unit(std::max(std::abs(out.low), std::abs(out.high)), axis.unit, units);
  const double low = out.low / unit.size, high = out.high / unit.size;
  const bool linear = axis.scale == AxisScale::linear;
  const std::vector<double> shown = linear ? linear_ticks(low, high, most_ticks) : log_ticks(low, high);
  out.texts = linear ? tick_texts(shown) : log_tick_texts(shown);
  for (const double tick : shown) out.ticks.push_back(tick * unit.size);
  if (!linear)
    for (const double tick : log_minor_ticks(low, high)) out.minor_ticks.push_back(tick * unit.size);
  out.title = axis_title(axis.label, unit.text);
  return out;
}

}  // namespace trilith::draw
