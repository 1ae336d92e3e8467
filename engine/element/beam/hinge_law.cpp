#include "element/beam/hinge_law.hpp"

namespace trilith {

namespace {

/// A concave share keeps the surface of N and M convex, which the search for N requires.
void check_points(const std::vector<double>& force, const std::vector<double>& share) {
  const std::size_t n = force.size();
  if (share.size() != n || n < 3)
    throw InputError(
        fmt::format("end_hinge: {} forces and {} shares, must be equal in number, at least 3", n, share.size()));
  if (share.front() != 0 || share.back() != 0)
    throw InputError("end_hinge: the share of the moment must be 0 at the first force and the last");
  if (!(force.front() < 0 && force.back() > 0))
    throw InputError("end_hinge: the forces must begin below 0 (compression) and end above it");
  double before = unbounded;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double slope = (share[i + 1] - share[i]) / (force[i + 1] - force[i]);
    if (!(force[i + 1] > force[i]) || !(slope <= before))
      throw InputError(fmt::format(
          "end_hinge: forces must rise and the shares over them be concave; those about {:g} N are not", force[i]));
    before = slope;
  }
}

}  // namespace

/// Conditions on several parameters: the order of limits, and forces that belong together.
void HingeLaw::check() const {
  if (capping > 0 && !(softening > 0))
    throw InputError("end_hinge: with a capping rotation, softening must be above 0 rad");
  if (softening > 0 && !(capping > 0))
    throw InputError(
        fmt::format("end_hinge: softening is {:g} rad, but without a capping rotation it never softens; give capping, "
                    "the plastic rotation from which it does, or leave softening out",
                    softening));
  if (residual > 0 && !(capping > 0) && !(wear > 0))
    throw InputError(
        fmt::format("end_hinge: residual is {:g}, but the moment never decreases to it; give capping and softening, "
                    "or wear, or leave residual out",
                    residual));
  if (ultimate > 0 && ultimate < capping)
    throw InputError(fmt::format("end_hinge: ultimate is {:g} rad, must not be below the capping rotation of {:g} rad",
                                 ultimate, capping));
  if (compression > 0 && !(tension > 0)) throw InputError("end_hinge: with a compression, tension must be given too");
  if (!force.empty() || !share.empty()) check_points(force, share);
  const bool ends = ultimate > 0 || (residual == 0 && (capping > 0 || wear > 0));
  if (removes && !ends)
    throw InputError(
        "end_hinge: becomes is \"removed\", but this hinge never loses its moment; give an ultimate rotation, or "
        "softening or wear without a residual");
}

/// With the exponent e and n = |N| / Np: c = 1 - n^e, dc/dN = -sign(N) e n^(e-1) / Np, d2c/dN2 = -e (e-1) n^(e-2) /
/// Np^2. With points: linear between them; at a point the piece on the side away from 0.
AxialShare HingeLaw::beside(double normal) const {
  if (!has_axial()) return {};
  if (force.empty()) {
    const double full = normal < 0 ? -least_normal() : tension, n = std::abs(normal) / full;
    const double sign = normal < 0 ? -1 : 1;
    if (exponent == 2) return {1 - n * n, -2 * sign * n / full, -2 / (full * full)};
    const double power = n > 0 ? portable::pow(n, exponent) : 0;
    const double slope = n > 0 ? power / n : (exponent == 1 ? 1.0 : 0.0);
    return {1 - power, -sign * exponent * slope / full,
            n > 0 ? -exponent * (exponent - 1) * power / (n * n) / (full * full) : 0.0};
  }
  std::size_t i = 0;  // index of the piece that begins at point i
  while (i + 2 < force.size() && (normal < 0 ? normal > force[i + 1] : normal >= force[i + 1])) ++i;
  const double slope = (share[i + 1] - share[i]) / (force[i + 1] - force[i]);
  return {share[i] + slope * (normal - force[i]), slope, 0};
}

/// From the peak of the backbone (yield and hardening up to the cap) down to its residual share over `softening`.
void check_softening(const HingeLaw& law, double even_bending) {
  if (!(law.capping > 0)) return;
  const double top = std::max(law.yield(1), law.yield(-1)) + law.hardening * law.capping;
  // The descending slope; a less stiff beam would snap back.
  const double steep = (1 - law.residual) * top / law.softening;
  if (!(steep < even_bending))
    throw InputError(fmt::format(
        "end_hinge: it softens by {:g} N m/rad, must be less than the {:g} N m/rad of its beam (2 EI/L); a longer "
        "softening or shorter beams",
        steep, even_bending));
}

}  // namespace trilith
