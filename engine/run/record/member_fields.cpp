#include "run/record/member_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <variant>

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/internal_forces_beams.hpp"
#include "base/portable.hpp"
#include "element/section/fibre_places.hpp"
#include "readings/member_forces.hpp"

namespace trilith {
namespace {

constexpr std::array yield_names{"elastic", "fibres", "hinges"};  // in the order of BeamYield

template <int D>
bool any_yields(const Model<D>& model) {
  return std::ranges::any_of(beams_of(model), [](const auto& beam) { return beam.yield != BeamYield::never; });
}

Vec2 up_in_node(const Model<2>& model, const Beam& beam) {
  return Turn(beam.angle - model.start_rotation[beam.node[0]]).apply(Vec2(0, 1));
}
Vec3 up_in_node(const Model<3>& /*model*/, const Beam3& beam) {
  return turn_of(beam.axes[0]).apply(Vec3(0, 1, 0));
}

// Bending stiffness of a beam for bending in the plane, and about z of the section.
const BeamStiffness& bending_of(const Beam& beam) {
  return beam.stiffness;
}
const BeamStiffness& bending_of(const Beam3& beam) {
  return beam.stiffness.bend[1];
}

/// EI of an elastic beam [N m2]. With two stiff ends K00 - K01 is 2 EI / L for any shear stiffness. With a pin the only
/// term is about 3 EI / L.
template <class SomeBeam>
double bending_stiffness(const SomeBeam& beam) {
  const std::array<double, 3>& k = bending_of(beam).bend;
  if (k[1] != 0) return 0.5 * (k[0] - k[1]) * beam.length;
  return std::max(k[0], k[2]) * beam.length / 3;
}

const BeamYields& yields_of(const Model<2>& model) {
  return model.yields;
}
const BeamYields3& yields_of(const Model<3>& model) {
  return model.yields_3d;
}

/// Chord rotation at which the hinge at an end of a member yields: M L / (6 EI), with the smaller yield moment (ASCE
/// 41-17, 9.4.2.2.2.2). 0: no hinge.
template <int D>
double yield_rotation(const Model<D>& model, const Member& member, double length, int end) {
  const auto& beam =
      beams_of(model)[static_cast<std::size_t>(end == 0 ? member.first_beam : member.first_beam + member.beams - 1)];
  if (beam.yield != BeamYield::at_hinges || !has_hinge(yields_of(model), beam, end)) return 0;
  const auto& rows = yields_of(model).hinged_beams[static_cast<std::size_t>(beam.yield_row)];
  const HingeLaw& law = yields_of(model).hinge_laws[static_cast<std::size_t>(rows[static_cast<std::size_t>(end)])];
  const double moment = law.hogging > 0 ? std::min(law.sagging, law.hogging) : law.sagging,
               stiffness = bending_stiffness(beam);
  return stiffness > 0 ? moment * length / (6 * stiffness) : 0;
}

template <int D>
results::MemberRow row_of(const Model<D>& model, const Member& member) {
  results::MemberRow row;
  row.name = member.name, row.from = member.joint[0], row.to = member.joint[1];
  row.body = member.body, row.first_beam = member.first_beam, row.beam_count = member.beams;
  double length = 0;
  auto kind = BeamYield::never;
  for (int i = member.first_beam; i < member.first_beam + member.beams; ++i) {
    const auto& beam = beams_of(model)[static_cast<std::size_t>(i)];
    length += beam.length, kind = std::max(kind, beam.yield);
  }
  row.yields = yield_names[static_cast<std::size_t>(kind)];
  for (const int end : {0, 1}) row.yield_rotation[end] = yield_rotation(model, member, length, end);
  return row;
}

template <int D, class SomeBeam>
results::BeamRow row_of(const Model<D>& model, const SomeBeam& beam, int member) {
  results::BeamRow row;
  row.member = member, row.node_a = beam.node[0], row.node_b = beam.node[1], row.length = beam.length;
  const Vec<D> up = up_in_node(model, beam);
  for (int k = 0; k < D; ++k) row.arm_a[k] = beam.arm[0][k], row.arm_b[k] = beam.arm[1][k], row.up[k] = up[k];
  return row;
}

/// The values in use of a fibre law. Fracture energies have become strains of the beam's length, so that optional
/// values at their preset are left out.
template <Declared L>
std::string fibre_law_text(const L& law) {
  std::string text = describe(law);
  if constexpr (requires { L::always_in_fingerprint; }) {
    std::size_t place = 0;
    for (const Parameter<L>& p : L::parameters()) {
      if (place++ < L::always_in_fingerprint || law.*(p.member) != p.preset) continue;
      const std::string unused = fmt::format(", {}={:g}{}{}", p.name, p.preset, p.unit == "1" ? "" : " ",
                                             p.unit == "1" ? std::string_view{} : std::string_view(p.unit));
      if (const std::size_t at = text.find(unused); at != std::string::npos) text.erase(at, unused.size());
    }
  }
  return text;
}

/// Laws of a section of fibres with the number and the area of their fibres.
template <class FibreSectionOf>
std::string section_text(const FibreSectionOf& section) {
  std::string text;
  for (const FibrePart& part : section.parts) {
    double area = 0;
    for (int i = part.first; i < part.first + part.count; ++i) area += section.fibres[static_cast<std::size_t>(i)].area;
    text += fmt::format("{}{} fibres of {:.4g} m2: {}", text.empty() ? "" : "; ", part.count, area,
                        std::visit([](const auto& law) { return fibre_law_text(law); }, part.law));
  }
  return text;
}

/// Section or hinges of a member as text; "" for an elastic one.
template <int D>
std::string yielding_text(const Model<D>& model, const Member& member) {
  const auto& yields = yields_of(model);
  const auto& all = beams_of(model);
  const auto& first = all[static_cast<std::size_t>(member.first_beam)];
  if (first.yield == BeamYield::in_fibres) {
    const int row = yields.fibre_beams[static_cast<std::size_t>(first.yield_row)].section;
    return section_text(yields.sections[static_cast<std::size_t>(row)]);
  }
  std::string text;
  for (const int end : {0, 1}) {
    const auto& beam =
        all[static_cast<std::size_t>(end == 0 ? member.first_beam : member.first_beam + member.beams - 1)];
    if (beam.yield != BeamYield::at_hinges || !has_hinge(yields, beam, end)) continue;
    const auto& rows = yields.hinged_beams[static_cast<std::size_t>(beam.yield_row)];
    const std::string law = describe(yields.hinge_laws[static_cast<std::size_t>(rows[static_cast<std::size_t>(end)])]);
    if (text.find(law) == std::string::npos) text += (text.empty() ? "" : "; ") + law;
  }
  return text;
}

/// One row for all members with equal yielding.
template <int D>
void add_sections(const Model<D>& model, results::Header& header) {
  std::map<std::string, std::size_t> known;
  for (const Member& member : model.members) {
    const std::string text = yielding_text(model, member);
    if (text.empty()) continue;
    const auto [at, fresh] = known.try_emplace(text, header.laws.size());
    const bool fibres = beams_of(model)[static_cast<std::size_t>(member.first_beam)].yield == BeamYield::in_fibres;
    if (fresh) header.laws.push_back({fibres ? "fibre_section" : "end_hinge", "section", "", "", text});
    std::string& users = header.laws[at->second].first;
    users += (users.empty() ? "" : ", ") + member.name;
  }
}

void append_forces(const SectionForces& from, const SectionForces& to, std::vector<double>& out) {
  out.insert(out.end(), {from.normal, from.shear, from.moment, to.moment});
}
void append_forces(const SectionForces3& from, const SectionForces3& to, std::vector<double>& out) {
  out.insert(out.end(), {from.normal, from.shear[0], from.shear[1], from.torque, from.moment[0], from.moment[1],
                         to.moment[0], to.moment[1]});
}

/// Present memory of a yielding beam: from the last commit and the present position.
std::vector<double> memory_now(const Model<2>& model, const State<2>& state, const Beam& beam) {
  const std::span before = memory_of(model, beam, std::span(state.beam_memory));
  std::vector<double> after(before.size());
  respond(model.yields, beam, now_of(state, beam), before, after);
  return after;
}
std::vector<double> memory_now(const Model<3>& model, const State<3>& state, const Beam3& beam) {
  const BeamNow3 now = now_of(state, beam);
  const std::span before = memory_of(model, beam, std::span(state.beam_memory));
  std::vector<double> after(before.size());
  respond(model.yields_3d, beam, now.strain(), now.rate(), before, after);
  return after;
}

std::array<double, 2> turned_at_hinges(const Beam& /*beam*/, std::span<const double> memory) {
  return hinge_memory(memory).turned;
}
std::array<double, 2> turned_at_hinges(const Beam3& /*beam*/, std::span<const double> memory) {
  const auto turned = space_hinge_memory(memory).turned;
  return {portable::hypot(turned[0][0], turned[0][1]), portable::hypot(turned[1][0], turned[1][1])};
}

/// Calls `use` with the place (-1 to 1) and the curvature of each fibre section of a beam; in space with its length.
template <class Use>
void for_curvatures(const Model<2>& model, const State<2>& state, const Beam& beam, const Use& use) {
  const FibreBeam& fibres = model.yields.fibre_beams[static_cast<std::size_t>(beam.yield_row)].beam;
  const BeamStrain d = now_of(state, beam).strain;
  for (int s = 0; s < fibres.stations; ++s) {
    const std::array<double, 2>& by = fibres.station[static_cast<std::size_t>(s)].curvature;
    use(place_of_station(fibres, s), by[0] * d[1] + by[1] * d[2]);
  }
}
template <class Use>
void for_curvatures(const Model<3>& model, const State<3>& state, const Beam3& beam, const Use& use) {
  const FibreBeam3& fibres = model.yields_3d.fibre_beams[static_cast<std::size_t>(beam.yield_row)].beam;
  const BeamNow3 now = now_of(state, beam);
  for (int s = 0; s < fibres.stations(); ++s) {
    const Eigen::Vector3d strain = station_strain(fibres, now.strain(), s).strain;
    use(place_of_station(fibres.plane[0], s), portable::hypot(strain[1], strain[2]));
  }
}

/// Appends states and deformations of both ends of a beam.
template <int D, class SomeBeam>
void append_yielding(const Model<D>& model, const State<D>& state, const SomeBeam& beam, std::vector<double>& states,
                     std::vector<double>& deformations) {
  std::array<double, 2> status{}, deformation{};
  if (beam.yield != BeamYield::never) {
    const std::vector<double> memory = memory_now(model, state, beam);
    for (const int end : {0, 1})
      status[static_cast<std::size_t>(end)] =
          static_cast<double>(yield_status(beam, memory, beam.yield == BeamYield::in_fibres ? 0 : end));
    if (beam.yield == BeamYield::at_hinges) deformation = turned_at_hinges(beam, memory);
  }
  if (beam.yield == BeamYield::in_fibres)
    for_curvatures(model, state, beam, [&](double place, double curvature) {
      double& most = deformation[place < 0 ? 0 : 1];
      if (std::abs(curvature) > std::abs(most)) most = curvature;
    });
  states.insert(states.end(), status.begin(), status.end());
  deformations.insert(deformations.end(), deformation.begin(), deformation.end());
}

Vec2 place_of_start(const State<2>& state, const Beam& beam) {
  Vec2 arm;
  return end_of(state, beam, 0, arm).place;
}
Vec3 place_of_start(const State<3>& state, const Beam3& beam) {
  return end_of(state, beam, 0).place;
}

template <int D>
Vec<D> place_of(const Event& event) {
  if constexpr (D == 2)
    return {event.x, event.y};
  else
    return {event.x, event.y, event.z};
}

/// The member that the text of an event names, or the only one of its body; -1: none.
template <int D>
int member_at(const Model<D>& model, const Event& event) {
  int found = -1;
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const Member& member = model.members[m];
    if (member.body != event.body_a) continue;
    const bool own = member.name == model.bodies[static_cast<std::size_t>(member.body)].name;
    if (!own && !event.text.starts_with(member.name + " ")) continue;
    if (found < 0 || member.name.size() > model.members[static_cast<std::size_t>(found)].name.size())
      found = static_cast<int>(m);
  }
  return found;
}

}  // namespace

template <int D>
void describe_members(const Model<D>& model, results::Header& header) {
  if (model.members.empty()) return;
  const std::size_t beams = beams_of(model).size();
  header.beams.resize(beams);
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const Member& member = model.members[m];
    header.members.push_back(row_of(model, member));
    for (int i = member.first_beam; i < member.first_beam + member.beams; ++i)
      header.beams[static_cast<std::size_t>(i)] =
          row_of(model, beams_of(model)[static_cast<std::size_t>(i)], static_cast<int>(m));
  }
  add_sections(model, header);
  header.fields.push_back({"member_force", "N, N m",
                           D == 2
                               ? "of each beam: normal force, shear force, moment at its start, at its end"
                               : "of each beam: normal, shear y, shear z, torque, moments y, z at its start, its end",
                           beams, D == 2 ? 4 : 8});
  if (!any_yields(model)) return;
  header.fields.push_back(
      {"member_state", "1", "ends of each beam: 0 elastic, 1 yielded, 2 without moment, 3 removed", beams, 2});
  header.fields.push_back({"member_deformation", "rad, 1/m",
                           "ends of each beam: plastic rotation of a hinge, or curvature of fibres", beams, 2});
}

template <int D>
void take_members(const Instant<D>& now, std::vector<std::vector<double>>& fields) {
  const Model<D>& model = now.model;
  if (model.members.empty()) return;
  std::vector<double> forces, states, deformations;
  for (std::size_t m = 0; m < model.members.size(); ++m) {
    const auto rows = member_forces(model, now.state, static_cast<int>(m));
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) append_forces(rows[i], rows[i + 1], forces);
  }
  fields.push_back(std::move(forces));
  if (!any_yields(model)) return;
  for (const auto& beam : beams_of(model)) append_yielding(model, now.state, beam, states, deformations);
  fields.push_back(std::move(states));
  fields.push_back(std::move(deformations));
}

template <int D>
results::Figure figure_at_yield(const Instant<D>& now, const Event& event) {
  const int m = member_at(now.model, event);
  if (m < 0) return {};
  const Member& member = now.model.members[static_cast<std::size_t>(m)];
  const auto& all = beams_of(now.model);
  const auto first = all.begin() + member.first_beam;
  const Vec<D> place = place_of<D>(event);
  const auto nearest = std::min_element(first, first + member.beams, [&](const auto& a, const auto& b) {
    return (place_of_start(now.state, a) - place).squaredNorm() < (place_of_start(now.state, b) - place).squaredNorm();
  });
  if (nearest->yield == BeamYield::in_fibres) {
    double most = 0;
    for_curvatures(now.model, now.state, *nearest,
                   [&](double /*place*/, double curvature) { most = std::max(most, std::abs(curvature)); });
    return {"curvature", "1/m", most};
  }
  double length = 0;
  for (auto beam = first; beam != first + member.beams; ++beam) length += beam->length;
  const bool at_start = (place_of_start(now.state, *first) - place).norm() < 0.5 * length;
  return {"yield rotation", "rad", yield_rotation(now.model, member, length, at_start ? 0 : 1)};
}

template void describe_members(const Model<2>&, results::Header&);
template void describe_members(const Model<3>&, results::Header&);
template void take_members(const Instant<2>&, std::vector<std::vector<double>>&);
template void take_members(const Instant<3>&, std::vector<std::vector<double>>&);
template results::Figure figure_at_yield(const Instant<2>&, const Event&);
template results::Figure figure_at_yield(const Instant<3>&, const Event&);

}  // namespace trilith
