#include "element/beam/fibre_beam_3d.hpp"

#include <algorithm>
#include <cmath>

namespace trilith {
namespace {

using Stresses = Eigen::Matrix<double, 6, 1>;

/// Indices of the bends about an axis (0: y, 1: z) in a strain.
constexpr std::array<std::array<int, 2>, 2> bends_about{{{1, 3}, {2, 4}}};

FibreBow bow_about(const FibreBeam3& beam, const BeamStrain3& d, std::size_t axis) {
  return {beam.plane[axis], d[static_cast<std::size_t>(bends_about[axis][0])],
          d[static_cast<std::size_t>(bends_about[axis][1])]};
}

/// Elastic shear on the sum of the bends about an axis.
void add_shear(const FibreBeam& plane, const std::array<int, 2>& bend, const BeamStrain3& d, Stresses& stress,
               FibreBeamResponse3& out) {
  Stresses slant = Stresses::Zero();
  for (const std::size_t end : {0, 1}) slant[bend[end]] = plane.slant[end];
  const double slanted =
      slant[bend[0]] * d[static_cast<std::size_t>(bend[0])] + slant[bend[1]] * d[static_cast<std::size_t>(bend[1])];
  stress += plane.shear * slanted * slant;
  out.tangent += plane.shear * (slant * slant.transpose());
  out.stored += 0.5 * plane.shear * slanted * slanted;
}

/// The mean normal force times the second derivatives of L q.
void add_bow(const FibreBeam& plane, const std::array<int, 2>& bend, double normal, FibreBeamResponse3& out) {
  const auto [first, second] = bend;
  out.tangent(first, first) += 2 * normal * plane.bow[0], out.tangent(second, second) += 2 * normal * plane.bow[2];
  out.tangent(first, second) += normal * plane.bow[1], out.tangent(second, first) += normal * plane.bow[1];
}

}  // namespace

FibreBeam3 make_fibre_beam_in_space(const FibreSection3& section, double length, const std::array<bool, 2>& pinned,
                                    const std::array<double, 2>& shear_stiffness, double torsion, BeamRule rule,
                                    int stations) {
  const Eigen::Matrix3d k = section.stiffest();
  FibreBeam3 beam;
  for (const std::size_t axis : {0, 1}) {
    const auto row = static_cast<Eigen::Index>(1 + axis);
    beam.plane[axis] = fibre_beam_of(k(row, row), length, pinned, shear_stiffness[axis], rule, stations);
  }
  beam.torsion = torsion / length;
  return beam;
}

/// If the stiffness is not centred, stretch and bending are coupled. With rows scaled to a diagonal of 1 no eigenvalue
/// exceeds the largest row sum.
BeamStiffness3 stiffest_beam(const FibreBeam3& beam, const FibreSection3& section) {
  const Eigen::Matrix3d k = section.stiffest();
  double more = 1;
  for (int i = 0; i < 3; ++i) {
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += std::abs(k(i, j)) / std::sqrt(k(i, i) * k(j, j));
    more = std::max(more, sum);
  }
  BeamStiffness3 out;
  out.axial = more * k(0, 0) / beam.length(), out.torsion = beam.torsion;
  for (const std::size_t axis : {0, 1}) {
    const auto row = static_cast<Eigen::Index>(1 + axis);
    BeamStiffness& plane = out.bend[axis];
    plane.axial = out.axial, plane.bow = beam.plane[axis].bow;
    plane.bend = stiffest_bend(beam.plane[axis], more * k(row, row));
  }
  return out;
}

StationStrain station_strain(const FibreBeam3& beam, const BeamStrain3& d, int station) {
  const double per = 1 / beam.length();
  StationStrain out;
  out.by.setZero();
  out.by(0, 0) = per;
  double stretch = d[0];
  for (const std::size_t axis : {0, 1}) {
    const FibreBow bow = bow_about(beam, d, axis);
    const FibreStation& s = beam.plane[axis].station[static_cast<std::size_t>(station)];
    stretch += bow.stretch;
    double curvature = 0;
    for (const std::size_t end : {0, 1}) {
      const int bend = bends_about[axis][end];
      out.by(0, bend) = per * bow.by[end];
      out.by(static_cast<Eigen::Index>(1 + axis), bend) = s.curvature[end];
      curvature += s.curvature[end] * d[static_cast<std::size_t>(bend)];
    }
    out.strain[static_cast<Eigen::Index>(1 + axis)] = curvature;
  }
  out.strain[0] = per * stretch;
  return out;
}

/// With B = d(e, k_y, k_z)/d(u, bends) at each station: stress = sum of w L B' s, tangent = sum of w L B' t B and the
/// part of the bows. Torsion and shear are parallel springs.
FibreBeamResponse3 respond(const FibreBeam3& beam, const FibreSection3& section, const BeamStrain3& d,
                           std::span<const double> before, std::span<double> after) {
  FibreBeamResponse3 out;
  const auto stations = static_cast<std::size_t>(beam.stations());
  const std::size_t size = before.size() / stations;
  Stresses stress = Stresses::Zero();
  double normal = 0;
  for (std::size_t i = 0; i < stations; ++i) {
    const StationStrain at = station_strain(beam, d, static_cast<int>(i));
    const SectionResponse3 r =
        respond(section, at.strain, before.subspan(i * size, size), after.subspan(i * size, size));
    const double weight = beam.plane[0].station[i].weight, share = weight * beam.length();
    stress.head<5>() += share * (at.by.transpose() * r.stress);
    out.tangent.topLeftCorner<5, 5>() += share * (at.by.transpose() * r.tangent * at.by);
    normal += weight * r.stress[0];
    out.stored += share * r.stored, out.dissipated += share * r.dissipated;
    out.yielding = out.yielding || r.yielding;
  }
  for (const std::size_t axis : {0, 1}) {
    add_shear(beam.plane[axis], bends_about[axis], d, stress, out);
    add_bow(beam.plane[axis], bends_about[axis], normal, out);
  }
  stress[5] += beam.torsion * d[5], out.tangent(5, 5) += beam.torsion;
  out.stored += 0.5 * beam.torsion * d[5] * d[5];
  std::copy_n(stress.data(), out.stress.size(), out.stress.begin());
  return out;
}

}  // namespace trilith
