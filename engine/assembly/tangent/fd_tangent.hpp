// The tangent from single terms of the forces: contacts, bearings, elements, loads.
//
// Each term depends on the motion of a few nodes and acts on these alone. One unknown is moved at a time to both sides.
// The code of `evaluate` computes the term, and the central difference is added to the matrix of
// assembly/tangent/tangent.hpp:
//
//     A_ij -= phi_f (F_i(x_j + h, v_j + c h) - F_i(x_j - h, v_j - c h)) / (2 h).
//
// So it is the tangent of every law in every branch, including the rotation of normals, arms and skins with the nodes.
// A new law needs no code here. Between two rigid bodies a term is evaluated 12 times, in space 24 times, independent
// of other contacts.
#pragma once

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "assembly/node_forces.hpp"
#include "assembly/tangent/dof_graph.hpp"
#include "assembly/tangent/fd_perturbation.hpp"
#include "assembly/tangent/tangent.hpp"
#include "model/model.hpp"
#include "model/state.hpp"
#include "model/work.hpp"

namespace trilith {

/// Nodes of a term, each once.
class TermNodes {
 public:
  void clear() { list_.clear(); }
  void add(int node) {
    if (!has(node)) list_.push_back(node);
  }
  [[nodiscard]] bool has(int node) const { return std::find(list_.begin(), list_.end(), node) != list_.end(); }
  template <int D>
  void add(const Model<D>& model, const Attachment<D>& attachment) {
    for (int i = 0; i < attachment.nodes; ++i)
      for (const int contact_frame : {attachment.node[i], attachment.turn[i]})
        for_nodes_of(model, contact_frame, [&](int n) { add(n); });
  }
  void add_skin(const Model<2>& model, int skin) { add(model.skin_node[skin]), add(model.skin_turn[skin]); }
  [[nodiscard]] std::span<const int> list() const { return list_; }
  [[nodiscard]] std::size_t size() const { return list_.size(); }
  /// Index of a node in the list.
  [[nodiscard]] std::size_t place_of(int node) const {
    return static_cast<std::size_t>(std::find(list_.begin(), list_.end(), node) - list_.begin());
  }

 private:
  std::vector<int> list_;
};

/// Forces and moments on the nodes of a term, Space<D>::dofs for each, in their order [N], [N m].
using TermForces = std::vector<double>;

/// The matrix of the sum, and the state that is perturbed.
template <int D>
struct TermSum {
  const Model<D>& model;
  State<D>& state;  ///< perturbed temporarily, and restored bit for bit
  const TangentOptions& options;
  const std::vector<std::array<int, Space<D>::dofs>>& unknown;  ///< [node] see DofGraph
  Eigen::SparseMatrix<double>& matrix;                          ///< with an entry for every two unknowns of a term

  /// Adds the column of an unknown: forces on `nodes` at two positions of it that are `apart` [m] or [rad].
  void add_column(const TermNodes& nodes, int column, const TermForces& more, const TermForces& less, double apart);

  /// Adds a term: respond(moved, forces) computes the forces on `nodes` at the present state, into zeros. Unknowns are
  /// moved by at most `most` [m], or by this distance at the radius of gyration.
  template <class Respond>
  void add(const TermNodes& nodes, Respond&& respond, double most = unbounded) {
    for (const int node : nodes.list())
      for (int k = 0; k < Space<D>::dofs; ++k) {
        const int column = unknown[node][k];
        if (column < 0) continue;
        const double by = perturbation_of(model, {node, k}, options, most);
        for (const bool up : {true, false}) {
          const Moved<D> moved(state, {node, k}, up ? by : -by, options.rate);
          TermForces& out = up ? more_ : less_;
          out.assign(Space<D>::dofs * nodes.size(), 0.0);
          respond(Freedom{node, k}, out);
        }
        add_column(nodes, column, more_, less_, 2 * by);
      }
  }

 private:
  TermForces more_, less_;  // buffers

 public:
  TermSum(const Model<D>& m, State<D>& s, const TangentOptions& o,
          const std::vector<std::array<int, Space<D>::dofs>>& u, Eigen::SparseMatrix<double>& a)
      : model(m), state(s), options(o), unknown(u), matrix(a) {}
};
extern template struct TermSum<2>;
extern template struct TermSum<3>;

/// Forces and moments on all nodes, of which a term uses only a few: these are read and reset to 0.
template <int D>
struct NodeArrays {
  std::vector<Vec<D>> force;
  std::vector<Moment<D>> moment;

  explicit NodeArrays(const Model<D>& model)
      : force(model.mass.size(), Vec<D>::Zero()), moment(model.mass.size(), nothing<Moment<D>>()) {}
  void take(const TermNodes& nodes, TermForces& out) {
    double* to = out.data();
    for (const int n : nodes.list()) {
      for (const double f : dofs_of(force[n], moment[n])) *to++ += f;
      force[n].setZero(), moment[n] = nothing<Moment<D>>();
    }
  }
};

/// A skin point in the position that `state` determines, and its arm from its node [m].
struct PlacedSkin {
  SkinMotion<2> motion;
  Vec2 arm;
};
PlacedSkin placed_skin(const Model<2>& model, const State<2>& state, int skin);

/// True if the last evaluation processed the row as a general contact.
inline bool is_general(const Work<2>& work, int row) {
  if (work.general.empty() && work.general_now.empty()) return false;
  return work.is_general[static_cast<std::size_t>(row)] != 0;
}

/// Add the terms of face contacts, general contacts, bearings, elements and following loads about the state at which
/// `work` is evaluated. Skin points of `work` are perturbed temporarily and restored. Pairs that do not touch at this
/// state contribute nothing.
void add_face_terms(TermSum<2>& sum, Work<2>& work);
void add_overlap_terms(TermSum<2>& sum, Work<2>& work);
void add_element_terms(TermSum<2>& sum);
template <int D>
void add_bearing_terms(TermSum<D>& sum);
template <int D>
void add_load_terms(TermSum<D>& sum, const Work<D>& work);

/// In space: all contacts, elements, and damping by mass. Afterwards the pieces in `work` are restored, but not the
/// answers of its contact rows.
void add_solid_terms(TermSum<3>& sum, Work<3>& work);
void add_element_terms(TermSum<3>& sum);
void add_mass_damping_terms(TermSum<3>& sum);

}  // namespace trilith
