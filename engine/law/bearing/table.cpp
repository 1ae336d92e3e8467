#include "law/bearing/table.hpp"

#include <fmt/format.h>

namespace trilith {

/// Increasing points that enclose 0: a force for every displacement, and one at rest.
void Table::check() const {
  if (displacement.size() < 2 || displacement.size() != force.size())
    throw InputError(
        fmt::format("table: {} displacements and {} forces; give at least 2 points {{displacement, force}}",
                    displacement.size(), force.size()));
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    require_finite(displacement[i], fmt::format("table: displacement of point {}", i + 1));
    require_finite(force[i], fmt::format("table: force of point {}", i + 1));
    if (i > 0 && displacement[i] <= displacement[i - 1])
      throw InputError(
          fmt::format("table: displacement of point {} is {:g} m, must be above the displacement of point {} ({:g} m)",
                      i + 1, displacement[i], i, displacement[i - 1]));
  }
  if (displacement.front() > 0 || displacement.back() < 0)
    throw InputError(
        fmt::format("table: displacements go from {:g} to {:g} m, must include 0; add a point for the force at rest",
                    displacement.front(), displacement.back()));
}

/// The steepest segment: the stability limit of the time step must hold wherever the bearing is.
double Table::tangent() const {
  double steepest = 0;
  for (std::size_t i = 1; i < displacement.size(); ++i)
    steepest = std::max(steepest, std::abs((force[i] - force[i - 1]) / (displacement[i] - displacement[i - 1])));
  return steepest;
}

/// Constant beyond both ends, linear between the two points around d.
double Table::force_at(double d) const {
  if (d <= displacement.front()) return force.front();
  if (d >= displacement.back()) return force.back();
  const auto above = std::upper_bound(displacement.begin(), displacement.end(), d) - displacement.begin();
  const auto i = static_cast<std::size_t>(above);
  const double share = (d - displacement[i - 1]) / (displacement[i] - displacement[i - 1]);
  return force[i - 1] + share * (force[i] - force[i - 1]);
}

/// Integral of the force from 0 to d [J]: the stored energy, because unloading follows the same curve.
double Table::energy_at(double d) const {
  // Trapezoids between 0 and d and the points between them: exact, because the force is linear there.
  const double from = std::min(0.0, d), to = std::max(0.0, d);
  double sum = 0, last = from, last_force = force_at(from);
  for (const double x : displacement) {
    if (x <= from || x >= to) continue;
    const double f = force_at(x);
    sum += 0.5 * (f + last_force) * (x - last);
    last = x;
    last_force = f;
  }
  sum += 0.5 * (force_at(to) + last_force) * (to - last);
  return d < 0 ? -sum : sum;
}

}  // namespace trilith
