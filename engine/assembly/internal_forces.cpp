// Internal forces of elements in the plane from the motion of their nodes.
#include <algorithm>
#include <array>

#include "assembly/contact/face_columns.hpp"
#include "assembly/element/element_stress.hpp"
#include "assembly/element/internal_forces_beams.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/single_terms.hpp"
#include "base/team.hpp"
#include "element/corotation.hpp"
#include "field/field.hpp"
#include "model/element/element_rows.hpp"

namespace trilith {
namespace {

struct ElementPass {
  const Model<2>& model;
  const State<2>& state;
  Work<2>& work;
  FieldValues heat;  ///< of elements that expand; none: no element does
};

/// The temperatures of a model with thermal strain.
FieldValues heat_in(const Model<2>& model, const State<2>& state) {
  if (model.fields.empty()) return {};
  const FieldValues heat = values_of(model.fields, state.fields, FieldKind::heat);
  return heat && heat.field().expands() ? heat : FieldValues{};
}

/// True if four elements share their rows of Model::element_number.
TRILITH_INLINE bool are_alike(const Element* four) {
  return four[0].first_number == four[1].first_number && four[0].first_number == four[2].first_number &&
         four[0].first_number == four[3].first_number;
}

/// Positions or velocities of the nodes of an element.
template <int N>
TRILITH_INLINE NodeColumns<N, double> columns_of(const std::vector<Vec2>& of, const Element& e) {
  NodeColumns<N, double> out;
  for (int i = 0; i < N; ++i) {
    const Vec2& v = of[static_cast<std::size_t>(e.node[i])];
    out.x[i] = v.x(), out.y[i] = v.y();
  }
  return out;
}
/// Positions or velocities of the nodes of four elements.
template <int N>
TRILITH_INLINE NodeColumns<N, Lanes> columns_of(const std::vector<Vec2>& of, const Element* four) {
  NodeColumns<N, Lanes> out;
  for (int i = 0; i < N; ++i) {
    const double* row[lane_count];
    for (int lane = 0; lane < lane_count; ++lane) row[lane] = of[static_cast<std::size_t>(four[lane].node[i])].data();
    load_columns(row, out.x[i], out.y[i]);
  }
  return out;
}

TRILITH_INLINE void subtract_at(std::vector<Vec2>& from, int node, const LanePair& force) {
  double* const on = from[static_cast<std::size_t>(node)].data();
  store_pair(on, load_pair(on) - force);
}
template <int N>
TRILITH_INLINE void subtract(std::vector<Vec2>& from, const Element& e, const NodeColumns<N, double>& force) {
  for (int i = 0; i < N; ++i) subtract_at(from, e.node[i], LanePair{force.x[i], force.y[i]});
}
/// Subtracts element after element: two of four may share a node.
template <int N>
TRILITH_INLINE void subtract(std::vector<Vec2>& from, const Element* four, const NodeColumns<N, Lanes>& force) {
  RowPairs rows[N];
  for (int i = 0; i < N; ++i) rows[i] = RowPairs(force.x[i], force.y[i]);
  for (int lane = 0; lane < lane_count; ++lane)
    for (int i = 0; i < N; ++i) subtract_at(from, four[lane].node[i], rows[i].of(lane));
}

/// Adds beta k v, the elastic forces of the rate of deformation times a time. `which`: one element, or the first of
/// four.
template <int N, class T, class Which>
TRILITH_INLINE void add_damping(const ElementPass& pass, const Deformation<N, T>& now, const double* shape, double beta,
                                const Which& which) {
  const auto v = now.rate(shape, columns_of<N>(pass.state.velocity, which));
  std::array<T, 8> h = multiply<N>(shape + element_shape_numbers, v);
  for (T& force : h) force *= beta;
  subtract<N>(pass.work.element_damping, which, now.forces(shape, h));
}

/// Computes h = k d in the element axes and subtracts its nodal forces; Deformation maps h to them (see
/// element/corotation.hpp). `which` as above, with `shape` its rows of Model::element_number. Returns d . k d / 2 [J].
template <int N, class T, class Which>
TRILITH_INLINE T resist_elastic(const ElementPass& pass, const double* shape, double beta, const Which& which) {
  const Deformation<N, T> now(shape, columns_of<N>(pass.state.position, which));
  const std::array<T, 8> h = multiply<N>(shape + element_shape_numbers, now.d);
  T twice{};
  for (int j = 0; j < 2 * N; ++j) twice += h[j] * now.d[j];
  subtract<N>(pass.work.element_force, which, now.forces(shape, h));
  if (beta > 0) add_damping<N, T>(pass, now, shape, beta, which);
  return 0.5 * twice;
}

/// An elastic element with a deformation without stress, d_0: h = k (d - d_0). Returns (d - d_0) . k (d - d_0) / 2 [J].
template <int N>
double resist_heated(const ElementPass& pass, const Element& e) {
  const double* const shape = &pass.model.element_number[static_cast<std::size_t>(e.first_number)];
  const Deformation<N> now(shape, columns_of<N>(pass.state.position, e));
  std::array<double, 8> d = now.d;
  if (const FreeShape* free = pass.heat.shape_of(static_cast<std::size_t>(&e - pass.model.elements.data())))
    pass.heat.subtract_free(*free, d.data());
  const std::array<double, 8> h = multiply<N>(shape + element_shape_numbers, d);
  double twice = 0;
  for (int j = 0; j < 2 * N; ++j) twice += h[j] * d[j];
  subtract<N>(pass.work.element_force, e, now.forces(shape, h));
  const double beta = pass.model.solids[static_cast<std::size_t>(e.solid)].damping();
  if (beta > 0) add_damping<N, double>(pass, now, shape, beta, e);
  return 0.5 * twice;
}
template <int N>
void resist_heated(const ElementPass& pass, const ElementBatch& batch, ElementEnergy& energy) {
  for (int i = batch.first; i < batch.first + batch.count; ++i)
    energy.stored += resist_heated<N>(pass, pass.model.elements[static_cast<std::size_t>(i)]);
}

/// Consecutive elements of one shape are processed four at a time. Loop counts are fixed, so that a lane, a single
/// element and copies for wide registers have the same bits.
template <int N>
TRILITH_INLINE void resist_elastic(const ElementPass& pass, const ElementBatch& batch, ElementEnergy& energy) {
  const double beta = pass.model.solids[batch.solid].damping();
  const int end = batch.first + batch.count;
  for (int i = batch.first; i < end;) {
    const Element* const e = &pass.model.elements[static_cast<std::size_t>(i)];
    const double* const shape = &pass.model.element_number[static_cast<std::size_t>(e->first_number)];
    if (i + lane_count <= end && are_alike(e)) {
      const Lanes stored = resist_elastic<N, Lanes>(pass, shape, beta, e);
      for (int lane = 0; lane < lane_count; ++lane) energy.stored += stored[lane];
      i += lane_count;
    } else {
      energy.stored += resist_elastic<N, double>(pass, shape, beta, *e);
      ++i;
    }
  }
}

[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void resist_quads(const ElementPass& pass,
                                                                              const ElementBatch& batch,
                                                                              ElementEnergy& energy) {
  resist_elastic<4>(pass, batch, energy);
}
[[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]] void resist_triangles(const ElementPass& pass,
                                                                                  const ElementBatch& batch,
                                                                                  ElementEnergy& energy) {
  resist_elastic<3>(pass, batch, energy);
}

/// Strain of the deformation `d` at an integration point with the rows `point` of Model::element_number.
[[maybe_unused]] PlaneVector strain_at(const double* point, const std::array<double, 8>& d) {
  PlaneVector strain = PlaneVector::Zero();
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 3; ++k) strain[k] += point[3 * i + k] * d[i];
  return strain;
}

/// h = sum over the integration points of B' s V. Input: strain e = B d; output: stress s and trial memory. The damping
/// uses the elastic stiffness, also after yield.
template <int N, class Law>
void resist_inelastic(const ElementPass& pass, const ElementBatch& batch, const Law& law, ElementEnergy& energy) {
  const Plane plane = pass.model.solids[batch.solid].plane;
  constexpr int points = N == 4 ? 4 : 1;
  for (int i = batch.first; i < batch.first + batch.count; ++i) {
    const Element& e = pass.model.elements[i];
    const double* const shape = &pass.model.element_number[e.first_number];
    const double* const k = shape + element_shape_numbers;
    const Deformation<N> now(shape, columns_of<N>(pass.state.position, e));
    std::array<double, 8> d = now.d, h{};
    if (const FreeShape* free = pass.heat.shape_of(static_cast<std::size_t>(i)))
      pass.heat.subtract_free(*free, d.data());
    for (int p = 0; p < points; ++p) {
      const double* const point = k + element_stiffness_numbers + p * element_point_numbers;
      const double volume = point[24];
      // Input: strain of the whole deformation, plastic strain of the last commit from State. The new plastic strain is
      // a trial value.
      const PointResponse r = respond_in_plane(law, plane, strain_at(point, d), pass.state.plastic[e.first_point + p]);
      pass.work.plastic[e.first_point + p] = r.memory;
      // `volume` of the element at this point.
      energy.stored += volume * r.stored, energy.plastic += volume * r.dissipated;
      const PlaneVector s = volume * r.stress.in_plane();
      for (int j = 0; j < 2 * N; ++j) h[j] += point[3 * j] * s[0] + point[3 * j + 1] * s[1] + point[3 * j + 2] * s[2];
    }
    subtract<N>(pass.work.element_force, e, now.forces(shape, h));
    if (law.damping > 0) add_damping<N, double>(pass, now, shape, law.damping, e);
  }
}

void resist_batch(const ElementPass& pass, const ElementBatch& batch, ElementEnergy& energy) {
  std::visit(
      [&](const auto& law) {
        if constexpr (std::decay_t<decltype(law)>::is_elastic) {
          if (pass.heat)
            batch.nodes == 4 ? resist_heated<4>(pass, batch, energy) : resist_heated<3>(pass, batch, energy);
          else
            batch.nodes == 4 ? resist_quads(pass, batch, energy) : resist_triangles(pass, batch, energy);
        } else {
          batch.nodes == 4 ? resist_inelastic<4>(pass, batch, law, energy)
                           : resist_inelastic<3>(pass, batch, law, energy);
        }
      },
      pass.model.solids[batch.solid].law);
}

/// Least number of elements in a chunk of a thread, about 10 microseconds. The energy of each chunk is summed
/// separately.
constexpr int least_elements = 64;

/// Divides the elements into chunks between bodies, which share no nodes, so that threads can process them. Elements
/// are stored body by body; otherwise they would not be divided.
void list_element_stretches(const Model<2>& model, Work<2>& work) {
  work.element_stretches.clear();
  const auto& all = model.elements;
  const int count = static_cast<int>(all.size());
  const bool in_order =
      std::is_sorted(all.begin(), all.end(), [](const Element& a, const Element& b) { return a.body < b.body; });
  for (int first = 0, i = 1; i <= count; ++i) {
    if (i < count && (!in_order || i - first < least_elements || all[i].body == all[i - 1].body)) continue;
    work.element_stretches.push_back({first, i - first});
    first = i;
  }
}

/// Clears the forces on the nodes of the bodies of a chunk, or on all nodes if it contains all elements.
void clear_nodes(const ElementPass& pass, const ElementRange& stretch) {
  const std::vector<Element>& all = pass.model.elements;
  int from = 0, to = pass.model.nodes();
  if (static_cast<std::size_t>(stretch.count) < all.size()) {
    const Body& last = pass.model.bodies[all[stretch.first + stretch.count - 1].body];
    from = pass.model.bodies[all[stretch.first].body].first_node, to = last.first_node + last.nodes;
  }
  std::fill_n(pass.work.element_force.begin() + from, to - from, Vec2::Zero());
  std::fill_n(pass.work.element_damping.begin() + from, to - from, Vec2::Zero());
}

/// The elements of a chunk, which may belong to several batches.
ElementEnergy resist_stretch(const ElementPass& pass, const ElementRange& stretch) {
  ElementEnergy energy;
  const std::vector<ElementBatch>& batches = pass.model.element_batches;
  const int end = stretch.first + stretch.count;
  auto batch = std::upper_bound(batches.begin(), batches.end(), stretch.first,
                                [](int first, const ElementBatch& b) { return first < b.first + b.count; });
  for (; batch != batches.end() && batch->first < end; ++batch) {
    const int from = std::max(batch->first, stretch.first), to = std::min(batch->first + batch->count, end);
    resist_batch(pass, {from, to - from, batch->nodes, batch->solid}, energy);
  }
  return energy;
}

/// Threads process chunks of elements, which share no nodes. Energies are summed by chunk, and the chunks in their
/// order, independent of the threads.
void resist_elements(const ElementPass& pass, ElementEnergy& sums) {
  Work<2>& work = pass.work;
  if (work.element_stretches.empty()) list_element_stretches(pass.model, work);
  work.element_energy.resize(work.element_stretches.size());
  share(work.threads, static_cast<int>(work.element_stretches.size()), 1, [&](int first, int last, int /*thread*/) {
    for (auto s = static_cast<std::size_t>(first); s < static_cast<std::size_t>(last); ++s) {
      clear_nodes(pass, work.element_stretches[s]);
      work.element_energy[s] = resist_stretch(pass, work.element_stretches[s]);
    }
  });
  for (const ElementEnergy& energy : work.element_energy) sums.stored += energy.stored, sums.plastic += energy.plastic;
}

}  // namespace

void element_forces(const Model<2>& model, const State<2>& state, Work<2>& work, int element) {
  resist_stretch({model, state, work, heat_in(model, state)}, {element, 1});
}

/// Batches of elements in their order, then beams. Stored energies refer to the instant; dissipated energies are added
/// to the ledger.
void internal_forces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  work.element_stored = 0;
  if (model.elements.empty() && model.beams.empty()) return;
  const auto nodes = static_cast<std::size_t>(model.nodes());
  // The chunks clear the nodes of elements; nodes of beams are cleared here.
  if (!model.beams.empty() || work.element_force.size() != nodes) {
    work.element_force.assign(nodes, Vec2::Zero());
    work.element_damping.assign(nodes, Vec2::Zero());
  }
  work.plastic.resize(state.plastic.size());
  ElementEnergy sums;
  resist_elements({model, state, work, heat_in(model, state)}, sums);
  if (!model.beams.empty()) {
    work.element_moment.assign(nodes, 0);
    work.element_damping_moment.assign(nodes, 0);
    work.beam_memory.resize(state.beam_memory.size());
    if (!work.leave_out_beams) resist_beams(model, state, work, dt, sums);
  }
  work.element_stored = sums.stored;
  work.given[EnergyTerm::plastic] += sums.plastic;
}

/// B is computed again, because elastic elements store only their stiffness.
ElementStress element_stress(const Model<2>& model, const State<2>& state, int element) {
  const Element& e = model.elements[element];
  const Solid& solid = model.solids[e.solid];
  const double* const shape = &model.element_number[e.first_number];
  std::vector<Vec2> corners;
  for (int i = 0; i < e.nodes; ++i) corners.emplace_back(shape[2 * i], shape[2 * i + 1]);
  const auto deform = [&]<int N>() {
    const Deformation<N> now(shape, columns_of<N>(state.position, e));
    return std::pair(now.d, std::pair(now.c, now.s));
  };
  auto [d, axes] = e.nodes == 4 ? deform.template operator()<4>() : deform.template operator()<3>();
  const FieldValues heat = heat_in(model, state);
  const FreeShape* const free = heat.shape_of(static_cast<std::size_t>(element));
  if (free != nullptr) heat.subtract_free(*free, d.data());
  // In plane strain, the expansion that is prevented across the plane.
  const double across =
      free != nullptr && solid.plane == Plane::strain
          ? free->expansion * heat.mean_rise(*free) * std::visit([](const auto& law) { return law.young; }, solid.law)
          : 0;
  const ElementStrain field = element_strain(corners, solid);
  const Eigen::Map<const Eigen::Matrix<double, 8, 1>> motion(d.data());
  ElementStress out;
  for (int p = 0; p < field.points; ++p) {
    const PlaneVector strain = field.matrix[p] * motion;
    const PlasticMemory none, &memory = e.first_point >= 0 ? state.plastic[e.first_point + p] : none;
    Stress s = point_stress(solid, strain, memory);
    s.zz -= across;
    out.at_point[p] = s;
    out.points = field.points;
    const double share = field.area[p];
    out.area += share;
    out.mean.xx += share * s.xx, out.mean.yy += share * s.yy, out.mean.zz += share * s.zz, out.mean.xy += share * s.xy;
    out.plastic += share * memory.measure;
  }
  // The sums over the points, weighted by area, become means.
  for (double* v : {&out.mean.xx, &out.mean.yy, &out.mean.zz, &out.mean.xy, &out.plastic}) *v /= out.area;
  out.axes_c = axes.first, out.axes_s = axes.second;
  return out;
}

/// R S R' with R by (c, s), the angle of the element's axes.
Stress in_world(const ElementStress& e) {
  const double c = e.axes_c, s = e.axes_s;
  const Stress& m = e.mean;
  return {c * c * m.xx + s * s * m.yy - 2 * c * s * m.xy, s * s * m.xx + c * c * m.yy + 2 * c * s * m.xy, m.zz,
          c * s * (m.xx - m.yy) + (c * c - s * s) * m.xy};
}

}  // namespace trilith
