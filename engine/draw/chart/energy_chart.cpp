#include "draw/chart/energy_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace trilith::draw {

Chart energy_chart(const std::vector<double>& time, const std::vector<EnergyCurve>& terms, EnergyView view) {
  Chart chart;
  chart.title = "Energy";
  chart.x = {"Time", "s"};
  chart.panels = {{{"Energy", "J"}, {}}};
  for (const EnergyCurve& term : terms) {
    if (term.name.empty()) throw InputError("energy chart: a term has no name");
    if (term.energy.size() != time.size())
      throw InputError(fmt::format("energy chart, term '{}': {} values at {} times, must be equal in number", term.name,
                                   term.energy.size(), time.size()));
    const bool below_zero = std::any_of(term.energy.begin(), term.energy.end(), [](double e) { return e < 0; });
    ChartSeries series{term.name, time, term.energy};
    series.stacked = view == EnergyView::stacked && !term.supplied && !below_zero;
    if (term.supplied) {
      series.dash = Dash::dashed;
      series.colour = palette().ink;
    }
    chart.panels[0].series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace trilith::draw
