// Internal forces of elements and beams in space from the motion of their nodes.
#include <algorithm>
#include <array>

#include "assembly/element/beam_motion.hpp"
#include "assembly/element/fibre_answers.hpp"
#include "assembly/element/internal_forces_beams.hpp"
#include "assembly/element/space_element_now.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/field/heated_beams.hpp"
#include "assembly/single_terms.hpp"
#include "base/team.hpp"
#include "element/corotation_3d.hpp"
#include "field/field.hpp"

namespace trilith {
namespace {

/// Adds force and moments to the two nodes of a beam.
void add_action(const Beam3& beam, const BeamAction3& action, double share, std::vector<Vec3>& force,
                std::vector<Vec3>& moment) {
  const auto a = static_cast<std::size_t>(beam.node[0]), b = static_cast<std::size_t>(beam.node[1]);
  force[a] += share * action.force, force[b] -= share * action.force;
  moment[a] += share * action.moment[0], moment[b] += share * action.moment[1];
}

}  // namespace

bool is_removed(const Model<3>& model, const Beam3& beam, std::span<const double> memories) {
  return beam.yield == BeamYield::at_hinges && space_hinge_memory(memory_of(model, beam, memories)).gone[0] > 1;
}

/// Beam stress s = K(d) of the strains d in axes that rotate with the chord, plus damping beta K d' of their rates.
/// Yielding beams use the stress of their law and its tangent instead of K; the response of fibres is kept for the
/// tangent. Band branches add damping by their stored stress. The transpose of d' maps all of it to the nodes.
void resist_beams(const Model<3>& model, const State<3>& state, Work<3>& work, double dt, ElementEnergy& sums) {
  BandRelaxation<3> bands(model, state, work, dt);
  const auto add_band = [&](const Beam3& beam, const BeamNow3& now, const BeamStress3& stress) {
    if (beam.band >= 0)
      add_action(beam, on_nodes(state, beam, now.action(bands.damping(beam, stress))), 1, work.element_damping,
                 work.element_damping_moment);
  };
  FibreAnswers<3>::make_room(model, work.beam_memory);
  for (const Beam3& beam : model.beams_3d) {
    BeamNow3 now = now_of(state, beam);
    relax_heated(model, state, beam, now);
    if (beam.yield != BeamYield::never) {
      const BeamAnswer3 r =
          respond(model.yields_3d, beam, now.strain(), now.rate(), memory_of(model, beam, std::span(state.beam_memory)),
                  memory_of(model, beam, std::span(work.beam_memory)));
      add_action(beam, on_nodes(state, beam, now.action(r.stress)), 1, work.element_force, work.element_moment);
      if (beam.damping > 0)
        add_action(beam, on_nodes(state, beam, now.action(r.damping)), 1, work.element_damping,
                   work.element_damping_moment);
      add_band(beam, now, r.stress);
      if (beam.yield == BeamYield::in_fibres)
        FibreAnswers<3>::keep(model, beam.yield_row, fibre_answer(now.strain(), now.rate(), r), work.beam_memory);
      sums.stored += r.stored, sums.plastic += r.dissipated;
      continue;
    }
    const BeamStress3 stress = stress_of(beam.stiffness, now.strain());
    add_action(beam, on_nodes(state, beam, now.action(stress)), 1, work.element_force, work.element_moment);
    add_band(beam, now, stress);
    sums.stored += stored_in(beam.stiffness, now.strain());
    if (beam.damping > 0)
      add_action(beam, on_nodes(state, beam, now.action(linear_stress(beam.stiffness, now.rate()))), beam.damping,
                 work.element_damping, work.element_damping_moment);
  }
}

BeamStress3 beam_stress(const Model<3>& model, const State<3>& state, const Beam3& beam, const BeamNow3& position) {
  BeamNow3 now = position;
  relax_heated(model, state, beam, now);
  if (beam.yield == BeamYield::never) return stress_of(beam.stiffness, now.strain());
  const std::span before = memory_of(model, beam, std::span(state.beam_memory));
  std::vector<double> after(before.size());
  return respond(model.yields_3d, beam, now.strain(), now.rate(), before, after).stress;
}

namespace {

/// k d for a 3 N x 3 N stiffness, column by column.
template <int N>
void multiply(const double* k, const double* d, double* out) {
  std::fill_n(out, 3 * N, 0.0);
  for (int j = 0; j < 3 * N; ++j)
    for (int i = 0; i < 3 * N; ++i) out[i] += k[3 * N * j + i] * d[j];
}

/// Integrates an inelastic element. Input: strain e = B d at each integration point; output: stress s and trial memory.
/// Returns h = sum over the points of B' s V.
template <int N, class Law>
void respond_at_points(const Model<3>& model, const SpaceElement& e, const Law& law, const State<3>& state,
                       const double* d, Work<3>& work, double* h, SpaceElementAnswer& out) {
  const int points = info_of(e.shape).points;
  const double* point = &model.element_number[static_cast<std::size_t>(e.first_number + 6 * N + 9 * N * N)];
  std::fill_n(h, 3 * N, 0.0);
  for (int p = 0; p < points; ++p, point += space_point_numbers(N)) {
    SpaceVector strain = SpaceVector::Zero();
    for (int j = 0; j < 3 * N; ++j)
      for (int k = 0; k < 6; ++k) strain[k] += point[6 * j + k] * d[j];
    const auto row = static_cast<std::size_t>(e.first_point + p);
    const SpaceResponse r = respond_in_space(law, strain, state.plastic[row]);
    work.plastic[row] = r.memory;
    const double volume = point[18 * N];
    out.stored += volume * r.stored, out.plastic += volume * r.dissipated;
    for (int j = 0; j < 3 * N; ++j)
      for (int k = 0; k < 6; ++k) h[j] += volume * point[6 * j + k] * r.stress[k];
  }
}

/// Nodal forces h of the deformation d in the element axes. For an elastic element h = k d with the energy d . k d / 2;
/// otherwise h follows from the stress at the integration points. The damping is beta k times the rate of d.
/// element/corotation_3d.hpp maps both to the nodes.
template <int N>
[[gnu::always_inline]] inline void element_forces(const Model<3>& model, const SpaceElement& e, const State<3>& state,
                                                  Work<3>& work, SpaceElementAnswer& out) {
  const Solid& solid = model.solids[static_cast<std::size_t>(e.solid)];
  const double* const number = &model.element_number[static_cast<std::size_t>(e.first_number)];
  const double* const k = number + 6 * N;
  const SpaceElementNow<N> now(number, e.node.data(), state.position, state.velocity);
  std::array<double, 3 * N> h;
  const double* d = now.d.data();
  std::array<double, 3 * N> stressed;  // the deformation less the one without stress, where temperatures cause one
  if (!model.fields.empty()) {
    const FieldValues heat = values_of(model.fields, state.fields, FieldKind::heat);
    if (const FreeShape* free = heat.shape_of(static_cast<std::size_t>(&e - model.space_elements.data()))) {
      stressed = now.d;
      heat.subtract_free(*free, stressed.data());
      d = stressed.data();
    }
  }
  out.stored = out.plastic = 0;
  std::visit(
      [&](const auto& law) {
        if constexpr (std::decay_t<decltype(law)>::is_elastic) {
          multiply<N>(k, d, h.data());
          double twice = 0;
          for (int j = 0; j < 3 * N; ++j) twice += h[j] * d[j];
          out.stored = 0.5 * twice;
        } else {
          respond_at_points<N>(model, e, law, state, d, work, h.data(), out);
        }
      },
      solid.law);
  now.to_nodes(number, h.data(), out.force.data());
  const double beta = solid.damping();
  if (!(beta > 0)) return;
  multiply<N>(k, now.v.data(), h.data());
  for (double& v : h) v *= beta;
  now.to_nodes(number, h.data(), out.damping.data());
}

// One copy for wide registers and one for any machine, with the same operations in the same order and so the same bits.
[[gnu::target_clones("avx2", "default")]] void resist_one(const Model<3>& model, const SpaceElement& e,
                                                          const State<3>& state, Work<3>& work,
                                                          SpaceElementAnswer& out) {
  switch (e.shape) {
    case ElementShape::brick:
      return element_forces<8>(model, e, state, work, out);
    case ElementShape::tetrahedron:
      return element_forces<4>(model, e, state, work, out);
    case ElementShape::wedge:
      return element_forces<6>(model, e, state, work, out);
    case ElementShape::quadratic_tetrahedron:
      return element_forces<10>(model, e, state, work, out);
  }
}

/// Elements per chunk of a thread; some microseconds.
constexpr int space_stretch = 16;

/// Threads compute elements; forces and energies are added in the order of elements, independent of the threads.
void resist_elements(const Model<3>& model, const State<3>& state, Work<3>& work, ElementEnergy& sums) {
  work.element_answer.resize(static_cast<std::size_t>(stretches_under_way(work.threads)) * space_stretch);
  const auto answer_of = [&](int slot, int i) -> SpaceElementAnswer& {
    return work.element_answer[static_cast<std::size_t>(slot * space_stretch + i)];
  };
  share_in_order(
      work.threads, static_cast<int>(model.space_elements.size()), space_stretch,
      [&](int first, int last, int /*thread*/, int slot) {
        for (int i = first; i < last; ++i)
          resist_one(model, model.space_elements[static_cast<std::size_t>(i)], state, work, answer_of(slot, i - first));
      },
      [&](int first, int last, int slot) {
        for (int i = first; i < last; ++i) {
          const SpaceElement& e = model.space_elements[static_cast<std::size_t>(i)];
          const SpaceElementAnswer& answer = answer_of(slot, i - first);
          const bool damped = model.solids[static_cast<std::size_t>(e.solid)].damping() > 0;
          sums.stored += answer.stored, sums.plastic += answer.plastic;
          for (std::size_t k = 0; k < static_cast<std::size_t>(info_of(e.shape).nodes); ++k) {
            const auto n = static_cast<std::size_t>(e.node[k]);
            work.element_force[n] -= answer.force[k];
            if (damped) work.element_damping[n] -= answer.damping[k];
          }
        }
      });
}

}  // namespace

void element_forces(const Model<3>& model, const State<3>& state, Work<3>& work, int element, SpaceElementAnswer& out) {
  resist_one(model, model.space_elements[static_cast<std::size_t>(element)], state, work, out);
}

void internal_forces(const Model<3>& model, const State<3>& state, Work<3>& work, double dt) {
  work.element_stored = 0;
  if (model.beams_3d.empty() && model.space_elements.empty()) return;
  const auto nodes = static_cast<std::size_t>(model.nodes());
  work.element_force.assign(nodes, Vec3::Zero()), work.element_damping.assign(nodes, Vec3::Zero());
  work.element_moment.assign(nodes, Vec3::Zero()), work.element_damping_moment.assign(nodes, Vec3::Zero());
  work.plastic.resize(state.plastic.size()), work.beam_memory.resize(state.beam_memory.size());
  ElementEnergy sums;
  resist_elements(model, state, work, sums);
  if (!work.leave_out_beams) resist_beams(model, state, work, dt, sums);
  work.element_stored = sums.stored;
  work.given[EnergyTerm::plastic] += sums.plastic;
}

}  // namespace trilith
