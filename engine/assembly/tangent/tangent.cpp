#include "assembly/tangent/tangent.hpp"

#include <algorithm>
#include <list>
#include <utility>

#include "assembly/element/consistent_mass.hpp"
#include "assembly/element/rotary_inertia.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/implicit_turn.hpp"
#include "assembly/node_forces.hpp"
#include "assembly/tangent/beam_tangent.hpp"
#include "assembly/tangent/fd_perturbation.hpp"
#include "assembly/tangent/fd_tangent.hpp"
#include "assembly/water/water_mass.hpp"
#include "element/rigid/rigid.hpp"

namespace trilith {

/// A rotation moves a point at the radius of gyration by the same distance as a translation.
template <int D>
double perturbation_of(const Model<D>& model, const Freedom& f, const TangentOptions& options, double most) {
  const double move = std::min(most, options.move > 0 ? options.move : std::clamp(1e-5 * options.dt, 1e-12, 1e-8));
  if (!is_turn<D>(f)) return move;
  const double radius = gyration_of(model, f.node);
  return move / (radius > 0 ? radius : 1);
}

template <int D>
double net_force(const Model<D>& model, const State<D>& state, const Work<D>& work, const Freedom& f) {
  const double force = dofs_of(work.force[f.node], work.moment[f.node])[f.k];
  return force - damping_by_mass(model, state, f.node)[f.k];
}

/// The pattern is valid while the pairs are. Pairs that do not touch have entries of 0, so that a contact made within a
/// step needs no new pattern.
template <int D>
void Tangent<D>::shape(const Model<D>& model, const Work<D>& work) {
  std::vector<std::pair<int, int>> pairs;
  for (const NearPair& p : work.pairs) pairs.emplace_back(p.piece_a, p.piece_b);
  if (shaped_ && pairs == pairs_) return;
  pairs_ = std::move(pairs);
  shaped_ = true;
  coupling_ = dof_graph_of(model, work);
  matrix_.resize(coupling_.size(), coupling_.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const Freedom& column : coupling_.freedom)
    for (const int n : coupling_.near[column.node])
      for (const int row : coupling_.unknown[n])
        if (row >= 0) entries.emplace_back(row, coupling_.unknown[column.node][column.k], 0.0);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  matrix_.makeCompressed();
}

/// Forces on all unknowns with direction k of `nodes` moved to one side.
template <int D>
void Tangent<D>::disturbed(const Model<D>& model, State<D>& state, Work<D>& work, const std::vector<int>& nodes, int k,
                           double side, const TangentOptions& options, Eigen::VectorXd& force) const {
  std::list<Moved<D>> moved;
  for (const int n : nodes)
    if (coupling_.unknown[n][k] >= 0)
      moved.emplace_back(state, Freedom{n, k}, side * perturbation_of(model, {n, k}, options), options.rate);
  if (moved.empty()) return;
  evaluate(model, state, work, options.dt);
  for (int i = 0; i < coupling_.size(); ++i) force[i] = net_force(model, state, work, coupling_.freedom[i]);
}

/// Column by column, with all nodes of a colour at once:
///
///     A e_j = -phi_f (F(x + h e_j, v + c h e_j) - F(x - h e_j, v - c h e_j)) / (2 h) + a_m M e_j.
///
/// Here phi_f is the share of forces in the scheme's equation, a_m its coefficient of the mass and c its change of
/// velocity per change of position. Central differences have no error from the second derivative. The remaining errors
/// are h^2 times the third derivative, and rounding of F over h. Each colour and direction needs two evaluations: some
/// 20 to 60 in all, independent of the number of nodes.
template <int D>
void Tangent<D>::assemble_by_differences(const Model<D>& model, State<D>& state, Work<D>& work,
                                         const TangentOptions& options) {
  Eigen::VectorXd more(coupling_.size()), less(coupling_.size());
  work.leave_out_beams = true;
  for (const std::vector<int>& nodes : coupling_.colour)
    for (int k = 0; k < Space<D>::dofs; ++k) {
      disturbed(model, state, work, nodes, k, 1, options, more);
      disturbed(model, state, work, nodes, k, -1, options, less);
      for (const int n : nodes) {
        const int column = coupling_.unknown[n][k];
        if (column < 0) continue;
        const double scale = -options.force / (2 * perturbation_of(model, {n, k}, options));
        const Dofs<D> own = inertia_column(model, state, {n, k}, options.inertia, options.rate);
        for (Eigen::SparseMatrix<double>::InnerIterator at(matrix_, column); at; ++at) {
          at.valueRef() = scale * (more[at.row()] - less[at.row()]);
          if (const Freedom& row = coupling_.freedom[at.row()]; row.node == n) at.valueRef() += own[row.k];
        }
      }
    }
  work.leave_out_beams = false;
  add_beams(model, state, options, nullptr);
}

/// Adds a block of the forces on a beam's two nodes by their unknowns, one node after the other.
template <int D>
template <class Block>
void Tangent<D>::add_block(const std::array<int, 2>& node, const Block& block) {
  constexpr int dofs = Space<D>::dofs;
  const auto unknown = [&](int i) { return coupling_.unknown[node[i / dofs]][i % dofs]; };
  for (int column = 0; column < 2 * dofs; ++column)
    for (int row = 0; row < 2 * dofs && unknown(column) >= 0; ++row)
      if (unknown(row) >= 0) matrix_.coeffRef(unknown(row), unknown(column)) += block(row, column);
}

/// In the plane term by term, see assembly/tangent/fd_tangent.hpp. Single nodes contribute inertia and damping by mass.
template <>
void Tangent<2>::assemble(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options) {
  shape(model, work);  // the pairs may have changed
  matrix_.coeffs().setZero();
  const double inertia = options.inertia + options.force * options.rate * model.mass_damping;
  for (int i = 0; i < coupling_.size(); ++i)
    matrix_.coeffRef(i, i) = inertia * mass_of(model, state, coupling_.freedom[i].node)[coupling_.freedom[i].k];
  TermSum<2> terms(model, state, options, coupling_.unknown, matrix_);
  add_face_terms(terms, work), add_overlap_terms(terms, work);
  add_bearing_terms(terms);
  add_element_terms(terms);
  add_load_terms(terms, work);
  add_beams(model, state, options, &work.beam_memory);
}

/// In space inertia and damping by mass of a rotation are blocks. The last responses of the contact rows belong to a
/// perturbed state, so everything is evaluated once more if there are any.
template <>
void Tangent<3>::assemble(const Model<3>& model, State<3>& state, Work<3>& work, const TangentOptions& options) {
  shape(model, work);
  matrix_.coeffs().setZero();
  for (int column = 0; column < coupling_.size(); ++column) {
    const Freedom f = coupling_.freedom[column];
    const Dofs<3> own = inertia_column(model, state, f, options.inertia, options.rate);
    for (int k = 0; k < Space<3>::dofs; ++k)
      if (const int row = coupling_.unknown[f.node][k]; row >= 0) matrix_.coeffRef(row, column) = own[k];
  }
  TermSum<3> terms(model, state, options, coupling_.unknown, matrix_);
  add_mass_damping_terms(terms);
  add_solid_terms(terms, work);
  add_bearing_terms(terms);
  add_element_terms(terms);
  add_load_terms(terms, work);
  add_beams(model, state, options, &work.beam_memory);
  if (!work.pairs.empty()) evaluate(model, state, work, options.dt);
}

namespace {

/// Beams have separate blocks, in the order of the unknowns of one node, then of the other; consistent mass adds its
/// own.
template <int D, class Add>
void each_beam_block(const Model<D>& model, const State<D>& state, const TangentOptions& options,
                     const std::vector<double>* trial, const Add& add) {
  const double inertia = options.inertia + options.force * options.rate * model.mass_damping;
  for (const auto& beam : beams_of(model)) {
    auto block = beam_block(model, state, beam, options.rate, options.bands ? options.dt : 0, trial);
    block *= -options.force;
    if (beam.inertia >= 0 && inertia > 0) block += inertia * added_mass(model, state, beam);
    add(beam.node, block);
  }
}

/// The added mass of water.
template <int D>
void add_water_blocks(const Model<D>& model, const State<D>& state, const TangentOptions& options,
                      const DofGraph<D>& coupling, Eigen::SparseMatrix<double>& matrix) {
  if (!(options.inertia > 0)) return;
  each_water_entry(model, state, [&](int i, int k, int j, int l, double m) {
    const int row = coupling.unknown[i][k], column = coupling.unknown[j][l];
    if (row >= 0 && column >= 0) matrix.coeffRef(row, column) += options.inertia * m;
  });
}

/// The rotary inertia of bodies of one element, whose nodes are all coupled.
template <int D>
void add_rotary_blocks(const Model<D>& model, const State<D>& state, const TangentOptions& options,
                       const DofGraph<D>& coupling, Eigen::SparseMatrix<double>& matrix) {
  const double inertia = options.inertia + options.force * options.rate * model.mass_damping;
  if (!(inertia > 0)) return;
  each_rotary_entry(model, state, [&](int i, int k, int j, int l, double m) {
    const int row = coupling.unknown[i][k], column = coupling.unknown[j][l];
    if (row >= 0 && column >= 0) matrix.coeffRef(row, column) += inertia * m;
  });
}

}  // namespace

template <>
void Tangent<2>::add_beams(const Model<2>& model, const State<2>& state, const TangentOptions& options,
                           const std::vector<double>* trial) {
  each_beam_block(model, state, options, trial, [&](const auto& node, const auto& block) { add_block(node, block); });
  add_rotary_blocks(model, state, options, coupling_, matrix_);
  add_water_blocks(model, state, options, coupling_, matrix_);
}
template <>
void Tangent<3>::add_beams(const Model<3>& model, const State<3>& state, const TangentOptions& options,
                           const std::vector<double>* trial) {
  each_beam_block(model, state, options, trial, [&](const auto& node, const auto& block) { add_block(node, block); });
  add_rotary_blocks(model, state, options, coupling_, matrix_);
  add_water_blocks(model, state, options, coupling_, matrix_);
}

/// Removes entries of 0 of pairs that do not touch, so that the matrix does not depend on when they were found.
template <int D>
bool Tangent<D>::find(const Model<D>& model, State<D>& state, Work<D>& work, const TangentOptions& options,
                      StepTimes* times) {
  StepClock clock(times);
  assemble(model, state, work, options);
  const auto kept = std::make_shared<KeptTangent>();
  kept->dt = options.dt, kept->rate = options.rate, kept->force = options.force, kept->inertia = options.inertia;
  kept->column.push_back(0);
  for (int column = 0; column < coupling_.size(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator at(matrix_, column); at; ++at)
      if (at.value() != 0) kept->row.push_back(static_cast<int>(at.row())), kept->value.push_back(at.value());
    kept->column.push_back(static_cast<int>(kept->row.size()));
  }
  clock.mark(StepPart::tangent);
  const bool regular = factorise(kept);
  clock.mark(StepPart::factorise);
  if (!regular) return false;
  state.tangent = kept;
  return true;
}

/// Modified Newton: a tangent is reused while steps converge with it. It is part of State, so that a restarted run
/// takes the same steps.
template <int D>
bool Tangent<D>::take(const State<D>& state, const TangentOptions& options) {
  const KeptTangent* const kept = state.tangent.get();
  if (kept == nullptr || kept->size() != coupling_.size() || kept->dt != options.dt || kept->rate != options.rate ||
      kept->force != options.force || kept->inertia != options.inertia)
    return false;
  return ready_ == state.tangent || factorise(state.tangent);
}

/// Without pivoting, see assembly/tangent/sparse_factors.hpp; friction and following loads make the matrix unsymmetric.
template <int D>
bool Tangent<D>::factorise(const std::shared_ptr<const KeptTangent>& kept) {
  ready_.reset();
  const Eigen::Map<const Eigen::SparseMatrix<double>> matrix(kept->size(), kept->size(),
                                                             static_cast<Eigen::Index>(kept->row.size()),
                                                             kept->column.data(), kept->row.data(), kept->value.data());
  if (!factors_.compute(matrix)) return false;
  ready_ = kept;
  return true;
}

template double perturbation_of(const Model<2>&, const Freedom&, const TangentOptions&, double);
template double perturbation_of(const Model<3>&, const Freedom&, const TangentOptions&, double);
template double net_force(const Model<2>&, const State<2>&, const Work<2>&, const Freedom&);
template double net_force(const Model<3>&, const State<3>&, const Work<3>&, const Freedom&);
template class Tangent<2>;
template class Tangent<3>;

}  // namespace trilith
