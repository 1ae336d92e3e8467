#include "readings/member_forces.hpp"

#include <algorithm>

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/internal_forces_beams.hpp"
#include "element/section/fibre_places.hpp"

namespace trilith {

/// Two rows for each beam, its start and its end: the moment is linear in between, N and the shear are constant.
std::vector<SectionForces> member_forces(const Model<2>& model, const State<2>& state, int member) {
  const Member& m = model.members[member];
  std::vector<SectionForces> rows;
  double along = 0;
  for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
    const Beam& beam = model.beams[i];
    Vec2 arm;
    const BeamEnd from = end_of(state, beam, 0, arm), to = end_of(state, beam, 1, arm);
    const BeamNow now(from, to, beam.length, beam.angle);
    const BeamStress stress = beam_stress(model, state, beam, now);
    // Counter-clockwise moments on the beam's ends: a negative moment at its start, and a positive one at its end,
    // cause tension at the bottom.
    const double shear = (stress[1] + stress[2]) / now.length;
    rows.push_back({along, from.place, stress[0], shear, -stress[1]});
    along += beam.length;
    rows.push_back({along, to.place, stress[0], shear, stress[2]});
  }
  return rows;
}

/// Curvature about y has the opposite sign of curvature about z: tension on the side towards z corresponds to a shear
/// against z behind the section.
std::vector<SectionForces3> member_forces(const Model<3>& model, const State<3>& state, int member) {
  const Member& m = model.members[member];
  std::vector<SectionForces3> rows;
  double along = 0;
  for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
    const Beam3& beam = model.beams_3d[i];
    const BeamNow3 now = now_of(state, beam);
    const BeamStress3 s = beam_stress(model, state, beam, now);
    const std::array shear{(s[2] + s[4]) / now.length(), -(s[1] + s[3]) / now.length()};
    rows.push_back({along, end_of(state, beam, 0).place, s[0], shear, s[5], {-s[1], -s[2]}});
    along += beam.length;
    rows.push_back({along, end_of(state, beam, 1).place, s[0], shear, s[5], {s[3], s[4]}});
  }
  return rows;
}

namespace {

/// Each fibre separately, at the strain of its section: its stress is the force of a section of this fibre alone over
/// its area.
std::vector<FibreReading::Fibre> read_fibres(const FibreSection& section, const SectionStrain& strain,
                                             std::span<const double> before) {
  std::vector<FibreReading::Fibre> out;
  std::size_t place = 0;
  for (const FibrePart& part : section.parts)
    for (int i = part.first; i < part.first + part.count; ++i) {
      const Fibre& fibre = section.fibres[i];
      const FibreSection one{{fibre}, {{part.law, 0, 1}}};
      const auto size = static_cast<std::size_t>(one.memory_size());
      std::vector<double> after(size);
      const SectionResponse r = respond(one, strain, before.subspan(place, size), after);
      out.push_back({fibre.height, fibre.area, strain.axial - fibre.height * strain.curvature, r.normal / fibre.area});
      place += size;
    }
  return out;
}

}  // namespace

/// The memory is from the last commit; the position is the present one.
std::vector<FibreReading> member_fibres(const Model<2>& model, const State<2>& state, int member) {
  const Member& m = model.members[member];
  std::vector<FibreReading> rows;
  double start = 0;
  for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
    const Beam& beam = model.beams[i];
    if (beam.yield == BeamYield::in_fibres) {
      const FibreBeamRow& row = model.yields.fibre_beams[beam.yield_row];
      const FibreSection& section = model.yields.sections[row.section];
      const BeamStrain d = now_of(state, beam).strain;
      const double bowed = FibreBow(row.beam, d[1], d[2]).stretch;
      // The first number of a fibre beam's memory indicates whether it has yielded.
      const std::span<const double> memory = memory_of(model, beam, std::span(state.beam_memory)).subspan(1);
      const auto size = static_cast<std::size_t>(section.memory_size());
      std::vector<double> after(size);
      for (int s = 0; s < row.beam.stations; ++s) {
        const FibreStation& at = row.beam.station[s];
        const SectionStrain strain{(d[0] + bowed) / row.beam.length, at.curvature[0] * d[1] + at.curvature[1] * d[2]};
        const auto before = memory.subspan(static_cast<std::size_t>(s) * size, size);
        const SectionResponse r = respond(section, strain, before, after);
        rows.push_back({start + 0.5 * (1 + place_of_station(row.beam, s)) * beam.length, strain.axial, strain.curvature,
                        r.normal, r.moment, read_fibres(section, strain, before)});
      }
    }
    start += beam.length;
  }
  // Quadrature rules of stations list their ends first.
  std::ranges::stable_sort(rows, {}, &FibreReading::along);
  return rows;
}

namespace {

std::vector<FibreReading3::Fibre> read_fibres(const FibreSection3& section, const Eigen::Vector3d& strain,
                                              std::span<const double> before) {
  std::vector<FibreReading3::Fibre> out;
  std::size_t place = 0;
  for (const FibrePart& part : section.parts)
    for (int i = part.first; i < part.first + part.count; ++i) {
      const Fibre3& fibre = section.fibres[static_cast<std::size_t>(i)];
      const FibreSection3 one{{fibre}, {{part.law, 0, 1}}};
      const auto size = static_cast<std::size_t>(one.memory_size());
      std::vector<double> after(size);
      const SectionResponse3 r = respond(one, strain, before.subspan(place, size), after);
      out.push_back({fibre.up, fibre.across, fibre.area, Eigen::Vector3d(1, fibre.across, -fibre.up).dot(strain),
                     r.stress[0] / fibre.area});
      place += size;
    }
  return out;
}

}  // namespace

std::vector<FibreReading3> member_fibres(const Model<3>& model, const State<3>& state, int member) {
  const Member& m = model.members[static_cast<std::size_t>(member)];
  std::vector<FibreReading3> rows;
  double start = 0;
  for (int i = m.first_beam; i < m.first_beam + m.beams; ++i) {
    const Beam3& beam = model.beams_3d[static_cast<std::size_t>(i)];
    if (beam.yield == BeamYield::in_fibres) {
      const FibreBeamRow3& row = model.yields_3d.fibre_beams[static_cast<std::size_t>(beam.yield_row)];
      const FibreSection3& section = model.yields_3d.sections[static_cast<std::size_t>(row.section)];
      const BeamNow3 now = now_of(state, beam);
      const std::span<const double> memory = memory_of(model, beam, std::span(state.beam_memory)).subspan(1);
      const auto size = static_cast<std::size_t>(section.memory_size());
      std::vector<double> after(size);
      for (int s = 0; s < row.beam.stations(); ++s) {
        const Eigen::Vector3d strain = station_strain(row.beam, now.strain(), s).strain;
        const auto before = memory.subspan(static_cast<std::size_t>(s) * size, size);
        const SectionResponse3 r = respond(section, strain, before, after);
        rows.push_back({start + 0.5 * (1 + place_of_station(row.beam.plane[0], s)) * beam.length,
                        strain[0],
                        {strain[1], strain[2]},
                        r.stress[0],
                        {r.stress[1], r.stress[2]},
                        read_fibres(section, strain, before)});
      }
    }
    start += beam.length;
  }
  std::ranges::stable_sort(rows, {}, &FibreReading3::along);
  return rows;
}

/// The rotations, moments and energy of the plastic hinges at the two ends of a member, if it has any.
std::vector<HingeReading> member_hinges(const Model<2>& model, const State<2>& state, int member) {
  const Member& m = model.members[member];
  std::vector<HingeReading> rows;
  for (const int end : {0, 1}) {
    const Beam& beam = model.beams[end == 0 ? m.first_beam : m.first_beam + m.beams - 1];
    if (beam.yield != BeamYield::at_hinges || !has_hinge(model.yields, beam, end)) continue;
    // The memory is from the last commit; the position is the present one.
    const std::span before = memory_of(model, beam, std::span(state.beam_memory));
    std::vector<double> memory(before.size());
    respond(model.yields, beam, now_of(state, beam), before, memory);
    Vec2 arm;
    const Vec2 place = end_of(state, beam, static_cast<std::size_t>(end), arm).place;
    const EndHingeMemory at = hinge_memory(memory);
    rows.push_back({end, place, yield_status(beam, memory, end), at.turned[end], at.stretch, at.moment[end], at.normal,
                    at.dissipated[end]});
  }
  return rows;
}

std::vector<HingeReading3> member_hinges(const Model<3>& model, const State<3>& state, int member) {
  const Member& m = model.members[static_cast<std::size_t>(member)];
  std::vector<HingeReading3> rows;
  for (const int end : {0, 1}) {
    const Beam3& beam = model.beams_3d[static_cast<std::size_t>(end == 0 ? m.first_beam : m.first_beam + m.beams - 1)];
    if (beam.yield != BeamYield::at_hinges || !has_hinge(model.yields_3d, beam, end)) continue;
    const BeamNow3 now = now_of(state, beam);
    const std::span before = memory_of(model, beam, std::span(state.beam_memory));
    std::vector<double> memory(before.size());
    respond(model.yields_3d, beam, now.strain(), now.rate(), before, memory);
    const auto i = static_cast<std::size_t>(end);
    const EndHingeMemory3 at = space_hinge_memory(memory);
    rows.push_back({end, end_of(state, beam, i).place, yield_status(beam, memory, end), at.turned[i], at.stretch,
                    at.moment[i], at.normal, at.dissipated[i]});
  }
  return rows;
}

}  // namespace trilith
