// Watches a run for unphysical results: elements strained beyond the range of their material law, and speeds and
// energies without a source. It checks rarely: the travel of the fastest point after the last check shows how long no
// limit can be reached.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "field/joint_flow.hpp"
#include "integrate/explicit/bond_step.hpp"
#include "run/stage.hpp"
#include "statics/travel.hpp"

namespace trilith {

/// Finding that ends a stage as diverged.
struct Divergence {
  std::string found;           ///< finding and place: "element 1 of q was squeezed by 51 % (its solid is made for 50
                               ///< %)"
  std::string advice;          ///< advice for the user
  double sound_until = 0;      ///< the last instant that was checked and valid [s]
  std::optional<Event> event;  ///< event of the element, if any
};

/// True if an element, or a beam along its axis, is strained beyond the limit of its material.
template <int D>
bool is_overstrained(const Model<D>& model, const State<D>& state);

class Watch {
 public:
  /// Resets the watch for another stage or state; the present energy counts as supplied.
  void reset();
  /// Forces a full check at the next instant, after a change of the model.
  void invalidate() { element_room_ = beam_room_ = bounds_room_ = 0, bonds_.reset(); }
  /// Call it at every evaluated instant. The check of elements depends on the instant alone; the others depend on the
  /// earlier checks.
  template <int D>
  std::optional<Divergence> look(const Instant<D>& now, bool last);
  /// Checks elements and beams alone, independent of earlier checks: for stages without time, which have no speeds.
  /// `under`: text with the present loads, appended after a comma.
  template <int D>
  std::optional<Divergence> look_at_strains(const Instant<D>& now, const std::string& under);
  /// Energy error of the steps if it exceeds a stated share of the energy supplied; otherwise empty.
  [[nodiscard]] std::string ledger_text() const;
  /// Bodies with all nodes outside the bounds that were not so before, in order. Call it at every instant too.
  template <int D>
  std::vector<int> leaving(const Model<D>& model, const State<D>& state, const Work<D>& work);

  /// Stores the positions of all nodes at the start of a stage that ends at rest in place. The positions of earlier
  /// stages are kept, because a run may be restored to them.
  template <int D>
  void keep_places(const State<D>& state);
  /// At the end of such a stage: the body that has moved farther than StageOptions::within.
  template <int D>
  const Travel& look_at_places(const Instant<D>& now);
  /// The largest displacement since the start of this stage, if its places were kept.
  template <int D>
  [[nodiscard]] Travel farthest(const Instant<D>& now) const;
  /// Result for the last stage checked this way.
  [[nodiscard]] const Travel& displaced() const { return displaced_; }
  /// Range until bonds may come near their strength, see integrate/explicit/bond_step.hpp.
  BondRoom& bonds() { return bonds_; }
  /// Solver of the water in joints, kept for its factors; no result depends on it.
  FlowSolver& flow() {
    if (!flow_) flow_ = std::make_unique<FlowSolver>();
    return *flow_;
  }
  /// Calls each(number) for all members but positions and bonds, which are found again.
  template <class Each>
  void each_number(Each&& each) {
    each(element_room_), each(beam_room_), each(bounds_room_), each(sound_until_), each(counts_);
    for (double& term : from_.value) each(term);
    each(free_dofs_), each(given_speed_), each(most_energy_), each(off_), each(most_put_in_), each(looked_speed_);
    each(next_look_);
  }

 private:
  template <int D>
  std::optional<Divergence> look_at_elements(const Instant<D>& now);
  template <int D>
  std::optional<Divergence> look_at_beams(const Instant<D>& now);
  template <int D>
  std::optional<Divergence> look_at_magnitudes(const Instant<D>& now);
  template <int D>
  void count_from(const Instant<D>& now, const Energy& energy);

  double element_room_ = 0;  // travel of the fastest point until an element may reach its limit [m]
  double beam_room_ = 0;     // ... a beam of a member [m]
  double bounds_room_ = 0;   // ... until a node may be outside the bounds [m]
  double sound_until_ = 0;   // [s]
  BondRoom bonds_;
  std::unique_ptr<FlowSolver> flow_;
  bool counts_ = false;
  Energy from_;                 // ledger at the start of the energy check
  int free_dofs_ = 0;           // at that instant
  double given_speed_ = 0;      // from the bodies at that instant, and from motions [m/s]
  double most_energy_ = 0;      // largest energy present or supplied at any check [J]
  double off_ = 0;              // energy error at the check with its largest magnitude [J]
  double most_put_in_ = 0;      // from the start of the energy check, at any instant [J]
  double looked_speed_ = 0;     // speed of the fastest point at the last check of magnitudes [m/s]
  std::int64_t next_look_ = 0;  // step number
  std::vector<std::pair<double, std::variant<Placement<2>, Placement<3>>>> places_;  // by the start of stages [s]
  Travel displaced_;
};

}  // namespace trilith
