#include "modal/modes.hpp"

#include <fmt/format.h>

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

#include "assembly/element/consistent_mass.hpp"
#include "assembly/element/rotary_inertia.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/implicit_turn.hpp"
#include "assembly/tangent/sparse_factors.hpp"
#include "assembly/tangent/tangent.hpp"
#include "assembly/water/water_mass.hpp"
#include "base/error.hpp"
#include "base/no_solution.hpp"

namespace trilith {
namespace {

/// Up to this number of unknowns all modes are computed.
constexpr int few = 300;
/// Over this time slip is elastic and dampers are stiff [s].
constexpr double instant = 1e-6;
/// Perturbation of nodes for the tangent [m].
constexpr double perturbation = 1e-8;

struct Pencil {
  Eigen::SparseMatrix<double> stiffness, mass;
};

/// Adds the difference of the consistent mass of frames to M.
template <int D>
void add_consistent(const Model<D>& model, const State<D>& state, const DofGraph<D>& coupling,
                    Eigen::SparseMatrix<double>& mass) {
  constexpr int dofs = Space<D>::dofs;
  for (const auto& beam : beams_of(model)) {
    if (beam.inertia < 0) continue;
    const auto m = added_mass(model, state, beam);
    const auto unknown = [&](int i) { return coupling.unknown[beam.node[i / dofs]][i % dofs]; };
    for (int column = 0; column < 2 * dofs; ++column)
      for (int row = 0; row < 2 * dofs && unknown(column) >= 0; ++row)
        if (unknown(row) >= 0) mass.coeffRef(unknown(row), unknown(column)) += m(row, column);
  }
  each_rotary_entry(model, state, [&](int i, int k, int j, int l, double m) {
    const int row = coupling.unknown[i][k], column = coupling.unknown[j][l];
    if (row >= 0 && column >= 0) mass.coeffRef(row, column) += m;
  });
  each_water_entry(model, state, [&](int i, int k, int j, int l, double m) {
    const int row = coupling.unknown[i][k], column = coupling.unknown[j][l];
    if (row >= 0 && column >= 0) mass.coeffRef(row, column) += m;
  });
}

/// Lumped mass of all nodes: in the plane a diagonal, in space with the tensor of inertia in world axes.
template <int D>
Eigen::SparseMatrix<double> lumped(const Model<D>& model, const State<D>& state, const DofGraph<D>& coupling) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < coupling.size(); ++i) {
    const Freedom& f = coupling.freedom[i];
    const Dofs<D> own = inertia_column(model, state, f, 1, 0);
    for (int k = 0; k < Space<D>::dofs; ++k)
      if (const int row = coupling.unknown[f.node][k]; row >= 0 && own[k] != 0) entries.emplace_back(row, i, own[k]);
  }
  Eigen::SparseMatrix<double> mass(coupling.size(), coupling.size());
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

/// K = -dF/dx about the state at rest, by the tangent without inertia and rates. M is diagonal, except for frames with
/// consistent mass and for rotations in space.
template <int D>
Pencil pencil_of(const Model<D>& model, const State<D>& now, Tangent<D>& tangent) {
  State<D> state = at_rest(now);
  Work<D> work;
  evaluate(model, state, work, instant);
  tangent.shape(model, work);
  tangent.assemble(model, state, work, {instant, 0, 1, 0, perturbation, false, true});
  const Eigen::SparseMatrix<double> k = tangent.matrix(), turned = k.transpose();
  Pencil out{0.5 * (k + turned), {}};
  out.mass = lumped(model, state, tangent.coupling());
  add_consistent(model, state, tangent.coupling(), out.mass);
  out.mass.makeCompressed();
  return out;
}

struct Pairs {
  Eigen::VectorXd square;
  Eigen::MatrixXd shape;
};

/// K phi = w^2 M phi of a small model, with dense matrices.
Pairs all_pairs(const Pencil& p) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(Eigen::MatrixXd(p.stiffness),
                                                                         Eigen::MatrixXd(p.mass));
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// A shift below 0 keeps the matrix regular if bodies have rigid motions.
double shift_of(const Pencil& p) {
  double least = 0;
  for (Eigen::Index i = 0; i < p.mass.rows(); ++i) {
    const double ratio = p.stiffness.coeff(i, i) / p.mass.coeff(i, i);
    if (ratio > 0 && (least == 0 || ratio < least)) least = ratio;
  }
  return -1e-4 * (least > 0 ? least : 1);
}

/// x -> (K - s M)^-1 x, the operator of Spectra's shift-and-invert mode.
class ShiftedInverse {
 public:
  using Scalar = double;
  explicit ShiftedInverse(const Pencil& p) : pencil_(p) {}
  [[nodiscard]] Eigen::Index rows() const { return pencil_.mass.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return pencil_.mass.cols(); }
  void set_shift(double shift) {
    Eigen::SparseMatrix<double> shifted = pencil_.stiffness - shift * pencil_.mass;
    shifted.makeCompressed();
    const Eigen::Map<const Eigen::SparseMatrix<double>> seen(
        rows(), rows(), shifted.nonZeros(), shifted.outerIndexPtr(), shifted.innerIndexPtr(), shifted.valuePtr());
    if (!factors_.compute(seen))
      throw NoSolution(
          "modes: the matrix of the shifted eigenproblem is singular; support the bodies that move freely");
  }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) = factors_.solve(Eigen::Map<const Eigen::VectorXd>(in, rows()));
  }

 private:
  const Pencil& pencil_;
  SparseFactors factors_;
};

/// The lowest modes of a large model, by Lanczos' method on the inverse of K - s M (Ericsson and Ruhe, "The spectral
/// transformation Lanczos method", Math. Comp. 35, 1980). The modes nearest to the shift s converge first.
Pairs lowest_pairs(const Pencil& p, int count) {
  using Product = Spectra::SparseSymMatProd<double>;
  ShiftedInverse invert(p);
  Product product(p.mass);
  // Twice the requested modes, for good convergence of Lanczos' method; at least 40.
  const int basis = std::min(static_cast<int>(p.mass.rows()), std::max(2 * count + 1, 40));
  Spectra::SymGEigsShiftSolver<ShiftedInverse, Product, Spectra::GEigsMode::ShiftInvert> solver(invert, product, count,
                                                                                                basis, shift_of(p));
  solver.init();
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-10, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw NoSolution(fmt::format("modes: only {} of {} were found; ask for fewer", found, count));
  return {solver.eigenvalues(), solver.eigenvectors()};
}

/// Scales the mode to phi' M phi = 1; factor = phi' M r for r = 1 along x or y, effective mass = factor^2.
template <int D>
NaturalMode<D> mode_of(const Model<D>& model, const DofGraph<D>& coupling, const Eigen::SparseMatrix<double>& mass,
                       double square, const Eigen::VectorXd& shape) {
  NaturalMode<D> mode;
  mode.square = square;
  mode.displacement.assign(model.mass.size(), Vec<D>::Zero());
  mode.rotation.assign(model.mass.size(), nothing<Spin<D>>());
  const Eigen::VectorXd momentum = mass * shape;
  double generalised = 0;
  for (int i = 0; i < coupling.size(); ++i) {
    const auto [n, k] = coupling.freedom[i];
    generalised += momentum[i] * shape[i];
    if (is_turn<D>({n, k})) {
      number_at(k - Space<D>::translations, mode.rotation[n]) = shape[i];
    } else {
      mode.displacement[n][k] = shape[i];
      mode.factor[k] += momentum[i];
    }
  }
  const double scale = 1 / std::sqrt(generalised);
  for (auto& v : mode.displacement) v *= scale;
  for (auto& v : mode.rotation) v *= scale;
  for (std::size_t k = 0; k < mode.factor.size(); ++k)
    mode.factor[k] *= scale, mode.mass[k] = mode.factor[k] * mode.factor[k];
  return mode;
}

}  // namespace

template <int D>
State<D> at_rest(const State<D>& from) {
  State<D> state = from;
  for (Vec<D>& v : state.velocity) v = Vec<D>::Zero();
  std::fill(state.spin.begin(), state.spin.end(), nothing<Spin<D>>());
  state.position_before = state.position, state.rotation_before = state.rotation;
  state.acceleration.assign(state.position.size(), Vec<D>::Zero());
  state.spin_rate.assign(state.position.size(), nothing<Spin<D>>());
  state.last_dt = instant;
  return state;
}

template <int D>
double NaturalMode<D>::frequency() const {
  return square > 0 ? std::sqrt(square) / (2 * M_PI) : 0;
}

template <int D>
std::array<double, D> free_mass(const Model<D>& model, const State<D>& state) {
  std::array<double, D> sum{};
  for (int n = 0; n < model.nodes(); ++n)
    for (std::size_t k = 0; k < sum.size(); ++k)
      if (model.support[n][k] == Support::free) sum[k] += model.mass[n];
  constexpr int dofs = Space<D>::dofs;
  for (const auto& beam : beams_of(model)) {
    if (beam.inertia < 0) continue;
    const auto m = added_mass(model, state, beam);
    const auto is_free = [&](int i) { return model.support[beam.node[i / dofs]][i % dofs] == Support::free; };
    for (int k = 0; k < D; ++k)
      for (const int i : {k, k + dofs})
        for (const int j : {k, k + dofs})
          if (is_free(i) && is_free(j)) sum[static_cast<std::size_t>(k)] += m(i, j);
  }
  return sum;
}

template <int D>
std::vector<NaturalMode<D>> modes(const Model<D>& model, const State<D>& state, int count) {
  if (count < 1) throw InputError(fmt::format("modes: count is {}, must be at least 1", count));
  Tangent<D> tangent;
  const Pencil pencil = pencil_of(model, state, tangent);
  const int size = tangent.coupling().size();
  if (size == 0) throw InputError("modes: no degree of freedom is free");
  // Lanczos with a basis close to the size of the matrix is not faster.
  const bool all = size <= few || count > size / 3;
  const Pairs pairs = all ? all_pairs(pencil) : lowest_pairs(pencil, count);
  std::vector<NaturalMode<D>> out;
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(count, pairs.square.size()); ++i)
    out.push_back(mode_of(model, tangent.coupling(), pencil.mass, pairs.square[i], pairs.shape.col(i)));
  return out;
}

template struct NaturalMode<2>;
template struct NaturalMode<3>;
template State<2> at_rest(const State<2>&);
template State<3> at_rest(const State<3>&);
template std::vector<NaturalMode<2>> modes(const Model<2>&, const State<2>&, int);
template std::vector<NaturalMode<3>> modes(const Model<3>&, const State<3>&, int);
template std::array<double, 2> free_mass<2>(const Model<2>&, const State<2>&);
template std::array<double, 3> free_mass<3>(const Model<3>&, const State<3>&);

}  // namespace trilith
