// The energy ledger as a chart.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/chart.hpp"

namespace trilith::draw {

/// One term of the ledger as a line [J] over the ledger's times. `supplied`: supplied work (ground motion, weight),
/// which the sum of the others should equal.
struct EnergyCurve {
  std::string name;
  std::vector<double> energy;
  bool supplied = false;
};

enum class EnergyView { lines, stacked };

/// A chart of the terms over `time` [s]. In the stacked view terms are stacked areas and supplied work is a dashed line
/// over them, so that a gap between the two is the residual. A term that becomes negative is drawn as a line. The
/// checks of chart_canvas apply. Throws InputError for a term without a name or with another length than `time`.
Chart energy_chart(const std::vector<double>& time, const std::vector<EnergyCurve>& terms, EnergyView view);

}  // namespace trilith::draw
