#include "step/tangent.hpp"

#include <tuple>
#include <utility>

#include "step/beam_tangent.hpp"
#include "step/consistent_mass.hpp"
#include "step/disturbance.hpp"
#include "step/evaluate.hpp"
#include "step/node_forces.hpp"
#include "step/term_tangent.hpp"

namespace trilith {
double net_force(const Model<2>& model, const State<2>& state, const Work<2>& work, const Freedom& f) {
  const Dofs<2> mass = mass_of(model, f.node), v = velocity_of(state, f.node);
  const double force = f.k == 2 ? work.moment[f.node] : work.force[f.node][f.k];
  return force - model.mass_damping * mass[f.k] * v[f.k];
}

/// The pattern holds as long as the pairs do; entries of pairs that do not touch are 0 and there all the same, so that
/// a contact made within a step needs no new pattern.
void Tangent::shape(const Model<2>& model, const Work<2>& work) {
  std::vector<std::pair<int, int>> pairs;
  for (const NearPair& p : work.pairs) pairs.emplace_back(p.piece_a, p.piece_b);
  if (shaped_ && pairs == pairs_) return;
  pairs_ = std::move(pairs);
  shaped_ = true;
  coupling_ = coupling_of(model, work);
  matrix_.resize(coupling_.size(), coupling_.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const Freedom& column : coupling_.freedom)
    for (const int n : coupling_.near[column.node])
      for (const int row : coupling_.unknown[n])
        if (row >= 0) entries.emplace_back(row, coupling_.unknown[column.node][column.k], 0.0);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  matrix_.makeCompressed();
}

/// Forces on all unknowns while direction k of `nodes` is moved to one side.
void Tangent::disturbed(const Model<2>& model, State<2>& state, Work<2>& work, const std::vector<int>& nodes, int k,
                        double side, const TangentOptions& options, Eigen::VectorXd& force) const {
  std::vector<std::pair<double, double>> kept;
  for (const int n : nodes) {
    if (coupling_.unknown[n][k] < 0) continue;
    double &place = place_of(state, {n, k}), &rate = rate_of(state, {n, k});
    kept.emplace_back(place, rate);
    const double by = side * disturbance_of(model, {n, k}, options);
    place += by, rate += options.rate * by;
  }
  if (kept.empty()) return;
  evaluate(model, state, work, options.dt);
  for (int i = 0; i < coupling_.size(); ++i) force[i] = net_force(model, state, work, coupling_.freedom[i]);
  auto at = kept.begin();
  for (const int n : nodes)
    if (coupling_.unknown[n][k] >= 0) std::tie(place_of(state, {n, k}), rate_of(state, {n, k})) = *at++;
}

/// Column by column, but all nodes of a colour at once:
///
///     A e_j = -phi_f (F(x + h e_j, v + c h e_j) - F(x - h e_j, v - c h e_j)) / (2 h) + a_m M e_j
///
/// with phi_f the share of forces in the scheme's equation, a_m its coefficient of the mass and c its change of
/// velocity per change of place. Central differences leave out the second derivative; what is left is h^2 of the third,
/// and rounding of F over h. Two evaluations for each colour and direction: some 20 to 60 in all, however many nodes.
void Tangent::assemble_by_differences(const Model<2>& model, State<2>& state, Work<2>& work,
                                      const TangentOptions& options) {
  Eigen::VectorXd more(coupling_.size()), less(coupling_.size());
  work.leave_out_beams = true;
  for (const std::vector<int>& nodes : coupling_.colour)
    for (const int k : {0, 1, 2}) {
      disturbed(model, state, work, nodes, k, 1, options, more);
      disturbed(model, state, work, nodes, k, -1, options, less);
      for (const int n : nodes) {
        const int column = coupling_.unknown[n][k];
        if (column < 0) continue;
        const double scale = -options.force / (2 * disturbance_of(model, {n, k}, options));
        for (Eigen::SparseMatrix<double>::InnerIterator at(matrix_, column); at; ++at) {
          at.valueRef() = scale * (more[at.row()] - less[at.row()]);
          if (at.row() == column) at.valueRef() += options.inertia * mass_of(model, n)[k];
        }
      }
    }
  work.leave_out_beams = false;
  add_beams(model, state, options);
}

/// Term by term, see step/term_tangent.hpp; what is of a node by itself is inertia and damping by mass.
void Tangent::assemble(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options) {
  shape(model, work);  // pairs may have been found since
  matrix_.coeffs().setZero();
  const double inertia = options.inertia + options.force * options.rate * model.mass_damping;
  for (int i = 0; i < coupling_.size(); ++i)
    matrix_.coeffRef(i, i) = inertia * mass_of(model, coupling_.freedom[i].node)[coupling_.freedom[i].k];
  TermSum terms(model, state, options, coupling_.unknown, matrix_);
  add_contact_terms(terms, work);
  add_bearing_terms(terms);
  add_element_terms(terms);
  add_load_terms(terms, work);
  add_beams(model, state, options);
}

/// Beams have their 6 x 6 block by hand, in the order of unknowns u0 v0 r0 u1 v1 r1; consistent mass adds its own.
void Tangent::add_beams(const Model<2>& model, const State<2>& state, const TangentOptions& options) {
  for (const Beam& beam : model.beams) {
    BeamBlock block = -options.force * beam_block(model, state, beam, options.rate, options.bands ? options.dt : 0);
    const double inertia = options.inertia + options.force * options.rate * model.mass_damping;
    if (beam.inertia >= 0 && inertia > 0) block += inertia * added_mass(model, state, beam);
    const auto unknown = [&](int i) { return coupling_.unknown[beam.node[i / 3]][i % 3]; };
    for (int column = 0; column < 6; ++column)
      for (int row = 0; row < 6 && unknown(column) >= 0; ++row)
        if (unknown(row) >= 0) matrix_.coeffRef(unknown(row), unknown(column)) += block(row, column);
  }
}

/// Without entries of 0, which are there for pairs that do not touch: so that it is the same whenever these were found.
bool Tangent::find(const Model<2>& model, State<2>& state, Work<2>& work, const TangentOptions& options,
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

/// Modified Newton: a tangent is good for as long as steps converge by it. It is part of State, so that a run that is
/// saved and continued takes the same steps.
bool Tangent::take(const State<2>& state, const TangentOptions& options) {
  const KeptTangent* const kept = state.tangent.get();
  if (kept == nullptr || kept->size() != coupling_.size() || kept->dt != options.dt || kept->rate != options.rate ||
      kept->force != options.force || kept->inertia != options.inertia)
    return false;
  return ready_ == state.tangent || factorise(state.tangent);
}

bool Tangent::factorise(const std::shared_ptr<const KeptTangent>& kept) {
  ready_.reset();
  const Eigen::Map<const Eigen::SparseMatrix<double>> matrix(kept->size(), kept->size(),
                                                             static_cast<Eigen::Index>(kept->row.size()),
                                                             kept->column.data(), kept->row.data(), kept->value.data());
  if (!factors_.compute(matrix)) return false;
  ready_ = kept;
  return true;
}

}  // namespace trilith
