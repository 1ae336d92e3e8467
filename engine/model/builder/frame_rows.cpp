#include "model/builder/frame_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/portable.hpp"
#include "base/rotation_3d.hpp"
#include "element/beam/beam_inertia.hpp"
#include "element/beam/beam_inertia_3d.hpp"

namespace trilith {
namespace {

template <int D>
using BeamOf = std::conditional_t<D == 2, Beam, Beam3>;
template <int D>
using YieldsOf = std::conditional_t<D == 2, BeamYields, BeamYields3>;

std::vector<Beam>& rows_of_beams(Model<2>& model) {
  return model.beams;
}
std::vector<Beam3>& rows_of_beams(Model<3>& model) {
  return model.beams_3d;
}
BeamYields& rows_of_yields(Model<2>& model) {
  return model.yields;
}
BeamYields3& rows_of_yields(Model<3>& model) {
  return model.yields_3d;
}

/// Supports of the body, or of a box around the node, replace the joint's.
template <int D>
auto support_of(const FrameBody<D>& body, std::size_t node) {
  auto out = node < body.frame.joints.size() ? body.frame.joints[node].support : decltype(body.support){};
  for (std::size_t k = 0; k < out.size(); ++k)
    if (body.support[k] != Support::free) out[k] = body.support[k];
  for (const NodeSupportOf<D>& hold : body.supports)
    for (std::size_t k = 0; k < hold.support.size(); ++k)
      if (is_supported_at(hold, body.plan.node[node]) && hold.support[k] != Support::free) out[k] = hold.support[k];
  return out;
}

/// Mass of a joint without its members. `density` [kg/m3] and `thickness` [m] of blocks without their own.
NodeMass<2> mass_of_joint(const FrameJoint& joint, double density, double thickness) {
  NodeMass<2> out{joint.mass, joint.inertia};
  if (!joint.has_block()) return out;
  const PolygonMoments moments = polygon_moments(joint.block);
  const double plate = joint.density.value_or(density) * joint.thickness.value_or(thickness);
  out.mass += plate * moments.area, out.inertia += plate * moments.second_moment;
  return out;
}
NodeMass<3> mass_of_joint(const SpaceJoint& joint, double density, double /*thickness*/) {
  NodeMass<3> out{joint.mass, joint.inertia * Eigen::Matrix3d::Identity()};
  if (!joint.has_block()) return out;
  const SolidMoments block = solid_moments(joint.block);
  const double own = joint.density.value_or(density);
  out.mass += own * block.volume, out.inertia += own * block.inertia;
  return out;
}

/// Length of a member's beam after its station `i` [m].
double beam_length(const FrameBody<2>& body, std::size_t m, int i) {
  const std::vector<StationOf<2>>& stations = body.plan.stations[m];
  return (body.plan.place_of(stations[i + 1]) - body.plan.place_of(stations[i])).norm();
}
double beam_length(const FrameBody<3>& body, std::size_t m, int /*i*/) {
  return length_of(body.frame, body.frame.members[m]) / body.frame.members[m].divisions;
}

/// Half of a beam: its mass [kg], and its rotary inertia [kg m2] in the plane about each of the beam's nodes, in space
/// about x, y and z of the beam.
template <int D>
struct HalfBeam {
  double mass;
  std::conditional_t<D == 2, std::array<double, 2>, Vec3> inertia;
};
HalfBeam<2> half_beam(const FrameBody<2>& body, std::size_t m, int i) {
  const Section& s = body.frame.members[m].section;
  const double half = 0.5 * (body.material[m].mass * beam_length(body, m, i)), own = s.second_moment / s.area;
  const auto about = [&](int station) { return half * (own + body.plan.stations[m][station].arm.squaredNorm()); };
  return {half, {about(i), about(i + 1)}};
}
HalfBeam<3> half_beam(const FrameBody<3>& body, std::size_t m, int i) {
  const Section3& s = body.frame.members[m].section;
  const double half = 0.5 * body.material[m].mass * beam_length(body, m, i);
  return {half, half / s.area * Vec3(s.second_moment[0] + s.second_moment[1], s.second_moment[0], s.second_moment[1])};
}

void add_half(const FrameBody<2>& /*body*/, std::size_t /*m*/, int side, const HalfBeam<2>& half, const Vec2& /*arm*/,
              NodeMass<2>& node) {
  node.mass += half.mass, node.inertia += half.inertia[side];
}
void add_half(const FrameBody<3>& body, std::size_t m, int /*side*/, const HalfBeam<3>& half, const Vec3& arm,
              NodeMass<3>& node) {
  const Turn3 turn = turn_of(member_axes(body.frame, body.frame.members[m]));
  Eigen::Matrix3d axes;
  axes << turn.x(), turn.y(), turn.z();
  const Eigen::Matrix3d inertia = axes * half.inertia.asDiagonal() * axes.transpose();
  node.mass += half.mass, node.inertia += inertia + inertia_at(half.mass, arm);
}

/// Appends the yield rows of a member's beams, in fibres or at its ends. The inner beams of a member with hinges are
/// elastic. For fibres the elastic stiffness is the largest one, for the stability limit.
template <int D>
class YieldRows {
 public:
  YieldRows(const FrameMemberOf<D>& member, const decltype(MemberMaterial<D>::elastic)& elastic, Model<D>& model)
      : member_(member), elastic_(elastic), yields_(rows_of_yields(model)), memory_(model.beam_memory) {
    if (const auto* const hinges = std::get_if<MemberHinges>(&member.yields))
      for (const int end : {0, 1})
        if (hinges->end[end]) hinge_[end] = add_law(*hinges->end[end]);
  }

  /// `first`, `last`: the beam is the member's first or last one.
  void add(BeamOf<D>& beam, bool first, bool last, const std::array<bool, 2>& pinned) {
    if (const auto* const fibres = std::get_if<MemberFibres>(&member_.yields)) {
      const int section = section_of_length(*fibres, beam.length);
      const auto made = fibre_beam(*fibres, section, beam.length, pinned);
      beam.yield = BeamYield::in_fibres, beam.yield_row = static_cast<int>(yields_.fibre_beams.size());
      beam.stiffness = stiffest_beam(made, yields_.sections[section]);
      yields_.fibre_beams.push_back({made, section});
    } else if ((first && hinge_[0] >= 0) || (last && hinge_[1] >= 0)) {
      const std::array<int, 2> law{first && hinge_[0] >= 0 ? hinge_[0] : add_law(HingeLaw::never()),
                                   last && hinge_[1] >= 0 ? hinge_[1] : add_law(HingeLaw::never())};
      beam.yield = BeamYield::at_hinges, beam.yield_row = static_cast<int>(yields_.hinged_beams.size());
      yields_.hinged_beams.push_back(law);
    }
    beam.first_memory = memory_;
    memory_ += memory_size(yields_, beam);
  }

 private:
  /// The row of the section of a beam: one for the member, or one for each length if its laws depend on it.
  int section_of_length(const MemberFibres& fibres, double length) {
    const double key = depends_on_length(fibres.spec) ? length : 0;
    for (const auto& [known, row] : sections_)
      if (std::abs(known - key) <= same_length * key) return row;
    sections_.emplace_back(key, static_cast<int>(yields_.sections.size()));
    if constexpr (D == 2)
      yields_.sections.push_back(make_fibres(for_length(fibres.spec, length)));
    else
      yields_.sections.push_back(make_fibres_in_space(for_length(fibres.spec, length)));
    return sections_.back().second;
  }
  int add_law(const HingeLaw& law) {
    yields_.hinge_laws.push_back(law);
    return static_cast<int>(yields_.hinge_laws.size()) - 1;
  }
  [[nodiscard]] std::conditional_t<D == 2, FibreBeam, FibreBeam3> fibre_beam(const MemberFibres& fibres, int row,
                                                                             double length,
                                                                             const std::array<bool, 2>& pinned) const {
    const auto& section = yields_.sections[row];
    if constexpr (D == 2) {
      const double shear = member_.shear ? elastic_.shear * member_.section.shear_area : 0;
      return make_fibre_beam(section, length, pinned, shear, fibres.rule, fibres.stations);
    } else {
      std::array<double, 2> shear{};
      if (elastic_.shears)
        for (const std::size_t axis : {0, 1}) shear[axis] = elastic_.shear * member_.section.shear_area[axis];
      return make_fibre_beam_in_space(section, length, pinned, shear, elastic_.shear * member_.section.torsion,
                                      fibres.rule, fibres.stations);
    }
  }

  const FrameMemberOf<D>& member_;
  const decltype(MemberMaterial<D>::elastic)& elastic_;
  YieldsOf<D>& yields_;
  int& memory_;  ///< of all beams of the model
  /// Beams whose lengths differ by less than this share have one section.
  static constexpr double same_length = 1e-9;
  std::vector<std::pair<double, int>> sections_;  ///< lengths [m] and rows
  std::array<int, 2> hinge_{-1, -1};
};

/// A beam between two stations of a member, elastic. `rotation`: of the frame's nodes in space.
Beam elastic_beam(const FrameBody<2>& body, std::size_t m, int i, const std::array<bool, 2>& pinned,
                  const UnitQuaternion* /*rotation*/) {
  const std::vector<StationOf<2>>& stations = body.plan.stations[m];
  Beam beam;
  for (const int side : {0, 1}) beam.arm[side] = stations[i + side].arm;
  const Vec2 along = body.plan.place_of(stations[i + 1]) - body.plan.place_of(stations[i]);
  beam.length = along.norm();
  beam.angle = portable::atan2(along.y(), along.x());
  beam.stiffness = beam_stiffness(body.material[m].elastic, body.frame.members[m].section, beam.length, pinned);
  return beam;
}
/// Its arms and axes are in the principal axes of the nodes.
Beam3 elastic_beam(const FrameBody<3>& body, std::size_t m, int i, const std::array<bool, 2>& pinned,
                   const UnitQuaternion* rotation) {
  const SpaceMember& member = body.frame.members[m];
  const std::vector<StationOf<3>>& stations = body.plan.stations[m];
  const UnitQuaternion axes = member_axes(body.frame, member);
  Beam3 beam;
  beam.length = beam_length(body, m, i);
  for (const int side : {0, 1}) {
    const StationOf<3>& station = stations[i + side];
    const UnitQuaternion to_node = inverse(rotation[station.node]);
    beam.axes[side] = to_node * axes;
    if (station.arm != Vec3(0, 0, 0)) beam.arm[side] = turn_of(to_node).apply(station.arm);
  }
  beam.stiffness = beam_stiffness_in_space(body.material[m].elastic, member.section, beam.length, pinned);
  return beam;
}

/// Bound of the beam's squared frequency on half of its mass at either end [1/s2].
double frequency2(const Beam& beam, const HalfBeam<2>& half) {
  const Turn axes(beam.angle);
  return beam_frequency2(beam.stiffness, beam.length, {axes.undo(beam.arm[0]), axes.undo(beam.arm[1])},
                         {half.mass, half.mass}, half.inertia);
}
double frequency2(const Beam3& beam, const HalfBeam<3>& half) {
  const auto own = [&](int side) { return turn_of(inverse(beam.axes[side])).apply(beam.arm[side]); };
  return beam_frequency2(beam.stiffness, beam.length, half.mass, half.inertia, {own(0), own(1)});
}

/// Adds the band damping of a beam, and its part of the bounds of the body's rates. The memory of its damping branches
/// follows the memory of its yielding.
template <int D>
void add_damping(BeamOf<D>& beam, int band, const HalfBeam<D>& half, Model<D>& model) {
  beam.band = band;
  double stiffening = 1;
  if (band >= 0) {
    const DampingBranches& branches = model.bands[band];
    beam.first_branch = model.beam_memory, stiffening = branches.stiffening();
    model.beam_memory += branches.memory_size(D == 2 ? 3 : 6);
  }
  const double most = frequency2(beam, half);
  RateBound& bound = model.element_bound.back();
  bound.stiffness = std::max(bound.stiffness, stiffening * most);
  bound.unbanded = std::max(bound.unbanded, most);
  bound.damping = std::max(bound.damping, beam.damping * most);
}

/// Gives a beam its consistent mass.
void add_inertia(Beam& beam, double mass, const Section& section, const HalfBeam<2>& half,
                 const std::array<bool, 2>& pinned, Model<2>& model) {
  BeamInertia inertia = beam_inertia(mass, beam.length, section, pinned);
  inertia.lumped = half.mass, inertia.turning = half.inertia;
  beam.inertia = static_cast<int>(model.beam_inertias.size());
  model.beam_inertias.push_back(inertia);
}
void add_inertia(Beam3& beam, double mass, const Section3& /*section*/, const HalfBeam<3>& /*half*/,
                 const std::array<bool, 2>& pinned, Model<3>& model) {
  beam.inertia = static_cast<int>(model.beam_inertias_3d.size());
  model.beam_inertias_3d.push_back(beam_inertia_in_space(mass, beam.length, pinned));
}

template <int D>
void append_member(const FrameBody<D>& body, std::size_t m, int body_row, int first_node, Model<D>& model) {
  const FrameMemberOf<D>& member = body.frame.members[m];
  const MemberMaterial<D>& made = body.material[m];
  auto& beams = rows_of_beams(model);
  model.members.push_back({name_of(body.frame, member),
                           body_row,
                           static_cast<int>(beams.size()),
                           member.divisions,
                           {body.frame.joints[member.from].name, body.frame.joints[member.to].name},
                           made.strain_limit});
  YieldRows<D> yields(member, made.elastic, model);
  const int band = band_row(made.band, model.bands);
  const UnitQuaternion* rotation = nullptr;
  if constexpr (D == 3) rotation = model.start_rotation.data() + first_node;
  for (int i = 0; i < member.divisions; ++i) {
    const bool first = i == 0, last = i + 1 == member.divisions;
    const std::array pinned{first && member.pinned[0], last && member.pinned[1]};
    BeamOf<D> beam = elastic_beam(body, m, i, pinned, rotation);
    beam.body = body_row;
    for (const int side : {0, 1}) beam.node[side] = first_node + body.plan.stations[m][i + side].node;
    beam.damping = made.damping;
    yields.add(beam, first, last, pinned);
    const HalfBeam<D> half = half_beam(body, m, i);
    add_damping(beam, band, half, model);
    if (body.frame.consistent) add_inertia(beam, 2 * half.mass, member.section, half, pinned, model);
    beams.push_back(beam);
  }
}

}  // namespace

template <int D>
std::vector<NodeMass<D>> node_masses(const FrameBody<D>& body, double thickness) {
  std::vector<NodeMass<D>> nodes;
  for (std::size_t n = 0; n < body.plan.node.size(); ++n)
    nodes.push_back(mass_of_joint(n < body.frame.joints.size() ? body.frame.joints[n] : FrameJointOf<D>{}, body.density,
                                  thickness));
  for (std::size_t m = 0; m < body.frame.members.size(); ++m)
    for (int i = 0; i < body.frame.members[m].divisions; ++i) {
      const HalfBeam<D> half = half_beam(body, m, i);
      for (const int side : {0, 1}) {
        const StationOf<D>& station = body.plan.stations[m][i + side];
        add_half(body, m, side, half, station.arm, nodes[station.node]);
      }
    }
  return nodes;
}

template <int D>
void append_nodes(const FrameBody<D>& body, const std::vector<NodeMass<D>>& nodes, const Vec<D>& centre,
                  Model<D>& model) {
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    model.mass.push_back(nodes[n].mass);
    if constexpr (D == 2) {
      model.inertia.push_back(nodes[n].inertia), model.start_rotation.push_back(0);
    } else {
      const PrincipalInertia principal = principal_inertia(nodes[n].inertia);
      model.inertia.push_back(principal.moments), model.start_rotation.push_back(principal.axes);
    }
    model.support.push_back(support_of(body, n));
    model.start_position.push_back(body.plan.node[n]);
    model.start_velocity.emplace_back(body.velocity + cross(body.spin, Vec<D>(body.plan.node[n] - centre)));
    model.start_spin.push_back(body.spin);
    model.load.push_back(Vec<D>::Zero());
  }
}

template <int D>
void append_beams(const FrameBody<D>& body, int body_row, int first_node, Model<D>& model) {
  for (std::size_t m = 0; m < body.frame.members.size(); ++m) append_member(body, m, body_row, first_node, model);
}

template std::vector<NodeMass<2>> node_masses(const FrameBody<2>& body, double thickness);
template std::vector<NodeMass<3>> node_masses(const FrameBody<3>& body, double thickness);
template void append_nodes(const FrameBody<2>& body, const std::vector<NodeMass<2>>& nodes, const Vec<2>& centre,
                           Model<2>& model);
template void append_nodes(const FrameBody<3>& body, const std::vector<NodeMass<3>>& nodes, const Vec<3>& centre,
                           Model<3>& model);
template void append_beams(const FrameBody<2>& body, int body_row, int first_node, Model<2>& model);
template void append_beams(const FrameBody<3>& body, int body_row, int first_node, Model<3>& model);

}  // namespace trilith
