// The energy ledger as a chart.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/chart.hpp"

namespace trilith::draw {

/// One term of the ledger as a line [J] over the ledger's times. `supplied`: work put in (ground motion, weight), which
/// the sum of the others should reach.
struct EnergyCurve {
  std::string name;
  std::vector<double> energy;
  bool supplied = false;
};

enum class EnergyView { lines, stacked };

/// A chart of the terms over `time` [s]. Stacked: terms are areas on each other and supplied work is a dashed line over
/// them, so that a gap between the two is the residual; a term that falls below zero is drawn as a line. The chart's
/// checks (chart_canvas) apply; a term without its name or with another length than `time` is refused (InputError).
Chart energy_chart(const std::vector<double>& time, const std::vector<EnergyCurve>& terms, EnergyView view);

}  // namespace trilith::draw
