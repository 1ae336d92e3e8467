#include "element/beam/fibre_beam.hpp"

#include "element/section/fibre_places.hpp"

#include <cmath>

namespace trilith {

namespace {

/// Position (-1 to 1) and weight (sum 2).
struct RulePoint {
  double place, weight;
};

std::vector<RulePoint> mirrored(std::initializer_list<RulePoint> half) {
  std::vector<RulePoint> all;
  for (const RulePoint& p : half) {
    if (p.place > 0) all.push_back({-p.place, p.weight});
    all.push_back(p);
  }
  return all;
}

/// The ends are points; exact for polynomials up to degree 2 n - 3.
std::vector<RulePoint> lobatto_points(int count) {
  const double seven = std::sqrt(7.0);
  switch (count) {
    case 3:
      return mirrored({{1, 1.0 / 3}, {0, 4.0 / 3}});
    case 4:
      return mirrored({{1, 1.0 / 6}, {std::sqrt(0.2), 5.0 / 6}});
    case 5:
      return mirrored({{1, 0.1}, {std::sqrt(3.0 / 7), 49.0 / 90}, {0, 32.0 / 45}});
    case 6:
      return mirrored({{1, 1.0 / 15},
                       {std::sqrt((7 + 2 * seven) / 21), (14 - seven) / 30},
                       {std::sqrt((7 - 2 * seven) / 21), (14 + seven) / 30}});
    default:
      throw InputError(fmt::format("fibres: {} stations along a beam, must be 3 to 6 (lobatto)", count));
  }
}

/// Inner points only; exact for polynomials up to degree 2 n - 1.
std::vector<RulePoint> gauss_points(int count) {
  const double six = 2 * std::sqrt(1.2), ten = 2 * std::sqrt(10.0 / 7), thirty = std::sqrt(30.0);
  const double seventy = 13 * std::sqrt(70.0);
  switch (count) {
    case 2:
      return mirrored({{std::sqrt(1.0 / 3), 1}});
    case 3:
      return mirrored({{std::sqrt(0.6), 5.0 / 9}, {0, 8.0 / 9}});
    case 4:
      return mirrored({{std::sqrt((3 + six) / 7), (18 - thirty) / 36}, {std::sqrt((3 - six) / 7), (18 + thirty) / 36}});
    case 5:
      return mirrored({{std::sqrt(5 + ten) / 3, (322 - seventy) / 900},
                       {std::sqrt(5 - ten) / 3, (322 + seventy) / 900},
                       {0, 128.0 / 225}});
    default:
      throw InputError(fmt::format("fibres: {} stations along a beam, must be 2 to 5 (gauss)", count));
  }
}

}  // namespace

FibreBeam make_fibre_beam(const FibreSection& section, double length, const std::array<bool, 2>& pinned,
                          double shear_stiffness, BeamRule rule, int stations) {
  return fibre_beam_of(section.stiffest()(1, 1), length, pinned, shear_stiffness, rule, stations);
}

FibreBeam fibre_beam_of(double bending, double length, const std::array<bool, 2>& pinned, double shear_stiffness,
                        BeamRule rule, int stations) {
  if (!(length > 0)) throw InputError(fmt::format("fibres: a beam of {:g} m, must be above 0", length));
  const std::vector<RulePoint> points = rule == BeamRule::lobatto ? lobatto_points(stations) : gauss_points(stations);
  const double phi = shear_stiffness > 0 ? 12 * bending / (shear_stiffness * length * length) : 0;
  FibreBeam beam;
  beam.length = length, beam.stations = stations;
  beam.bow = beam_stiffness({1, 0}, {.area = 1, .second_moment = 1}, length, pinned).bow;
  // The elastic energy of the antisymmetric mode, 6 EI/((1 + phi) L) theta^2 for two equal bends, minus the part of its
  // curvature.
  beam.shear = 3 * phi * bending / ((1 + phi) * (1 + phi) * length);
  // Bends of the ends in terms of the given bends: pinned ends follow.
  Eigen::Matrix2d bends = Eigen::Matrix2d::Identity();
  // M = 0 at a pinned end: (4 + phi) theta_i + (2 - phi) theta_j = 0.
  const double follows = -(2 - phi) / (4 + phi);
  for (const int end : {0, 1})
    if (pinned[end]) bends(end, end) = 0, bends(end, 1 - end) = pinned[1 - end] ? 0 : follows;
  for (const int end : {0, 1}) beam.slant[end] = bends(0, end) + bends(1, end);
  for (int i = 0; i < stations; ++i) {
    FibreStation& s = beam.station[i];
    s.weight = 0.5 * points[i].weight;
    // (6 x/L - 3) / ((1 + phi) L) at a position from -1 to 1.
    const double slanted = 3 * points[i].place / ((1 + phi) * length);
    for (const int end : {0, 1})
      s.curvature[end] = (bends(1, end) - bends(0, end)) / length + beam.slant[end] * slanted;
  }
  return beam;
}

/// The two rules have different weights for each number of points.
double place_of_station(const FibreBeam& beam, int station) {
  const bool lobatto = beam.stations >= 3 && 0.5 * lobatto_points(beam.stations)[0].weight == beam.station[0].weight;
  return (lobatto ? lobatto_points(beam.stations) : gauss_points(beam.stations))[station].place;
}

/// The integral in `respond`, with the largest stiffness of the section at each station.
BeamStiffness stiffest_beam(const FibreBeam& beam, const FibreSection& section) {
  const Eigen::Matrix2d k = section.stiffest();
  // If the stiffness is not centred, stretch and bending are coupled; the coupling adds at most this share to either.
  const double more = 1 + std::abs(k(0, 1)) / std::sqrt(k(0, 0) * k(1, 1));
  BeamStiffness out;
  out.axial = more * k(0, 0) / beam.length, out.bow = beam.bow;
  out.bend = stiffest_bend(beam, more * k(1, 1));
  return out;
}

std::array<double, 3> stiffest_bend(const FibreBeam& beam, double bending) {
  std::array<double, 3> out{};
  const auto add = [&](double stiffness, const std::array<double, 2>& by) {
    out[0] += stiffness * by[0] * by[0], out[1] += stiffness * by[0] * by[1];
    out[2] += stiffness * by[1] * by[1];
  };
  for (int i = 0; i < beam.stations; ++i)
    add(bending * beam.station[i].weight * beam.length, beam.station[i].curvature);
  add(beam.shear, beam.slant);
  return out;
}

FibreBeamResponse respond(const FibreBeam& beam, const FibreSection& section, const BeamStrain& d,
                          std::span<const double> before, std::span<double> after) {
  FibreBeamResponse out;
  const double per = 1 / beam.length;
  const FibreBow bow(beam, d[1], d[2]);
  const auto& [bowed, by] = bow;
  const std::size_t size = before.size() / beam.stations;
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();
  double normal = 0;
  for (int i = 0; i < beam.stations; ++i) {
    const FibreStation& s = beam.station[i];
    const SectionStrain strain{per * (d[0] + bowed), s.curvature[0] * d[1] + s.curvature[1] * d[2]};
    const SectionResponse r = respond(section, strain, before.subspan(i * size, size), after.subspan(i * size, size));
    // d(axial strain, curvature) / d(u, theta_0, theta_1): stress and tangent are sums of B' s and B' t B.
    Eigen::Matrix<double, 2, 3> b;
    b << per, per * by[0], per * by[1], 0, s.curvature[0], s.curvature[1];
    const double share = s.weight * beam.length;
    stress += share * (b.transpose() * Eigen::Vector2d(r.normal, r.moment));
    out.tangent += share * (b.transpose() * r.tangent * b);
    normal += s.weight * r.normal;
    out.stored += share * r.stored, out.dissipated += share * r.dissipated;
    out.yielding = out.yielding || r.yielding;
  }
  const Eigen::Vector3d slant(0, beam.slant[0], beam.slant[1]);
  const double slanted = beam.slant[0] * d[1] + beam.slant[1] * d[2];
  stress += beam.shear * slanted * slant;
  out.tangent += beam.shear * (slant * slant.transpose());
  out.stored += 0.5 * beam.shear * slanted * slanted;
  // The bow's part: mean N times the second derivatives of L q.
  out.tangent(1, 1) += 2 * normal * beam.bow[0], out.tangent(2, 2) += 2 * normal * beam.bow[2];
  out.tangent(1, 2) += normal * beam.bow[1], out.tangent(2, 1) += normal * beam.bow[1];
  for (int k = 0; k < 3; ++k) out.stress[k] = stress[k];
  return out;
}

}  // namespace trilith
