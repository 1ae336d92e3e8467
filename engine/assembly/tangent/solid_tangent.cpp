// Terms of the tangent in space: contacts, elements, damping by mass.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "assembly/contact/pair_sleeping.hpp"
#include "assembly/contact/shared_edge_normal.hpp"
#include "assembly/single_terms.hpp"
#include "assembly/tangent/fd_perturbation.hpp"
#include "assembly/tangent/fd_tangent.hpp"
#include "broad_phase/incremental_pairs.hpp"

namespace trilith {
namespace {

/// The contact of a row, including the rows whose springs change its direction at a shared edge
/// (assembly/contact/shared_edge_normal.hpp). Input: a state with one unknown moved. Output: forces of the row at its
/// nodes. At its end the pieces and the trial memory of the row are restored.
class SolidTerm {
 public:
  SolidTerm(const TermSum<3>& sum, Work<3>& work, int row)
      : sum_(sum),
        work_(work),
        row_(row),
        memory_(work.contacts.memory[at()]),
        separation_(work.solids.separation[at()]),
        asleep_until_(work.asleep_until[at()]) {
    work.asleep_until[at()] = 0;  // the pair must not sleep while it is perturbed
    add_pieces(row);
    const SharedEdgeRows<3> ridge = rows_at_shared_edges(work, row);
    if (!ridge.has_others()) return;
    for (std::size_t i = 0; i < ridge.count; ++i) {
      met_.push_back(static_cast<std::size_t>(ridge.row[i] - work.met.data()));
      push_.push_back(ridge.row[i]->push);
      add_pieces(ridge.row[i]->row);
    }
  }
  SolidTerm(const SolidTerm&) = delete;
  SolidTerm& operator=(const SolidTerm&) = delete;
  ~SolidTerm() {
    place(-1);
    for (std::size_t i = 0; i < met_.size(); ++i) work_.met[met_[i]].push = push_[i];
    work_.contacts.memory[at()] = memory_, work_.solids.separation[at()] = separation_;
    work_.asleep_until[at()] = asleep_until_;
  }

  void list_nodes(TermNodes& nodes) const {
    nodes.clear();
    for (const TermNodes& of : nodes_)
      for (const int n : of.list()) nodes.add(n);
  }
  /// Largest perturbation of unknowns at the present state [m].
  [[nodiscard]] double most_move() {
    SolidAnswer answer;
    contact_row_forces(sum_.model, sum_.state, work_, row_, sum_.options.dt, answer);
    if (answer.row < 0 || !answer.touching || !(answer.depth > 0)) return unbounded;
    return std::max(share_of_depth * answer.depth, least_move);
  }
  void respond(const Freedom& moved, NodeArrays<3>& to) {
    place(moved.node);
    for (const std::size_t i : met_)
      work_.met[i].push =
          spring_force(sum_.model, sum_.state, work_, work_.met[i].row, sum_.options.dt, work_.solids.room.front());
    SolidAnswer answer;
    contact_row_forces(sum_.model, sum_.state, work_, row_, sum_.options.dt, answer);
    if (answer.row < 0 || !answer.touching) return;
    push(answer.carrier_a, -answer.force, answer.moment_a, to);
    push(answer.carrier_b, answer.force, answer.moment_b, to);
  }

 private:
  [[nodiscard]] std::size_t at() const { return static_cast<std::size_t>(row_); }
  void add_pieces(int row) {
    const NearPair& pair = work_.pairs[static_cast<std::size_t>(row)];
    for (const int piece : {pair.piece_a, pair.piece_b}) {
      if (std::find(pieces_.begin(), pieces_.end(), piece) != pieces_.end()) continue;
      pieces_.push_back(piece);
      TermNodes& of = nodes_.emplace_back();
      for_nodes_of_piece(sum_.model, piece, [&](int n) { of.add(n); });
    }
  }
  /// Places the pieces again that move with the perturbed `node`, and the pieces of the node perturbed before, which is
  /// restored.
  void place(int node) {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (nodes_[i].has(node) || nodes_[i].has(moved_)) place_again(sum_.model, sum_.state, work_, pieces_[i]);
    moved_ = node;
  }
  /// Adds a force and a moment about the position of a contact frame.
  void push(int contact_frame, const Vec3& force, const Vec3& moment, NodeArrays<3>& to) const {
    if (const auto n = static_cast<std::size_t>(contact_frame); contact_frame >= 0) {
      to.force[n] += force, to.moment[n] += moment;
      return;
    }
    const auto fit = static_cast<std::size_t>(-1 - contact_frame);
    spread_fitted(sum_.model, sum_.model.fits[fit], work_.solids.fitted[fit], force, moment, to.force);
  }

  const TermSum<3>& sum_;
  Work<3>& work_;
  const int row_;
  std::vector<int> pieces_;
  std::vector<TermNodes> nodes_;  // of these
  int moved_ = -1;                // node whose pieces are displaced
  std::vector<std::size_t> met_;  // rows of Work::met
  std::vector<Vec3> push_;        // their spring forces
  const SolidMemory memory_;
  const Separation3 separation_;
  const double asleep_until_;
};

}  // namespace

void add_solid_terms(TermSum<3>& sum, Work<3>& work) {
  const double reach = 2 * reach_of_moves(sum.options);  // of two pieces
  const Contacts<3>& before = contacts_before(sum.state, work);
  NodeArrays<3> all(sum.model);
  TermNodes nodes;
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    const auto r = static_cast<std::size_t>(row);
    const JointMemory* const joint = before.joint_at(r);
    const bool holds = (work.contacts.memory[r].state & contact_touching) != 0 || (joint != nullptr && !joint->empty());
    if (!holds && work.asleep_until[r] > way_of(work, work.pairs[r]) + reach) continue;
    SolidTerm term(sum, work, row);
    term.list_nodes(nodes);
    const auto respond = [&](const Freedom& moved, TermForces& out) {
      term.respond(moved, all);
      all.take(nodes, out);
    };
    sum.add(nodes, respond, term.most_move());
  }
}

/// Terms of single elements: stresses and damping, as in internal_forces.
void add_element_terms(TermSum<3>& sum) {
  Work<3> own;
  own.plastic.resize(sum.state.plastic.size());
  TermNodes nodes;
  SpaceElementAnswer answer;
  for (int i = 0; i < static_cast<int>(sum.model.space_elements.size()); ++i) {
    const SpaceElement& e = sum.model.space_elements[static_cast<std::size_t>(i)];
    const auto count = static_cast<std::size_t>(info_of(e.shape).nodes);
    const bool damped = sum.model.solids[static_cast<std::size_t>(e.solid)].damping() > 0;
    nodes.clear();
    for (std::size_t k = 0; k < count; ++k) nodes.add(e.node[k]);
    sum.add(nodes, [&](const Freedom& /*moved*/, TermForces& out) {
      element_forces(sum.model, sum.state, own, i, answer);
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t axis = 0; axis < 3; ++axis)
          out[Space<3>::dofs * k + axis] = -answer.force[k][axis] - (damped ? answer.damping[k][axis] : 0.0);
    });
  }
}

void add_mass_damping_terms(TermSum<3>& sum) {
  if (!(sum.model.mass_damping > 0)) return;
  TermNodes nodes;
  for (int n = 0; n < sum.model.nodes(); ++n) {
    nodes.clear(), nodes.add(n);
    sum.add(nodes, [&](const Freedom& /*moved*/, TermForces& out) {
      const Dofs<3> taken = damping_by_mass(sum.model, sum.state, n);
      for (std::size_t k = 0; k < taken.size(); ++k) out[k] = -taken[k];
    });
  }
}

}  // namespace trilith
