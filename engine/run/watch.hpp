// Watches a run for what cannot be: elements beyond what their solid is made for, speeds and energies that nothing
// gave. It looks seldom: the path of the fastest point since it last looked tells how long nothing can have happened.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "integrate/explicit/bond_step.hpp"
#include "run/stage.hpp"
#include "statics/travel.hpp"

namespace trilith {

/// What ends a stage as diverged.
struct Divergence {
  std::string found;           ///< what and where: "element 1 of q was squeezed by 51 % (its solid is made for 50 %)"
  std::string advice;          ///< what to try
  double sound_until = 0;      ///< the last instant that was looked at and sound [s]
  std::optional<Event> event;  ///< of the element, where it is one
};

/// An element's largest principal strain, by the deformation gradient at its corners.
struct ElementStretch {
  int element = -1;
  double strain = 0;  ///< stretch less 1; -1 and below: a corner has no area left, or is turned inside out [1]
  double spare = 0;   ///< how much more the element is made for; not above 0 where it is too much [1]
};
ElementStretch element_stretch(const Model<2>& model, const State<2>& state, int element);

/// Whether an element, or a beam along its axis, is strained beyond what its solid is made for.
template <int D>
bool is_overstrained(const Model<D>& model, const State<D>& state);

class Watch {
 public:
  /// Forgets all, as for another stage or state: what is there now counts as given.
  void reset();
  /// Looks at everything at the next instant: the model was changed.
  void invalidate() { element_room_ = beam_room_ = bounds_room_ = 0, bonds_.reset(); }
  /// To be called at every evaluated instant. What it finds depends on the instant alone for elements, and for the rest
  /// on when it looked before.
  template <int D>
  std::optional<Divergence> look(const Instant<D>& now, bool last);
  /// At elements and beams alone, whatever was looked at before: for stages without time, which have no speeds.
  /// `under`: of which loads that is told, after a comma.
  template <int D>
  std::optional<Divergence> look_at_strains(const Instant<D>& now, const std::string& under);
  /// What its steps gained or lost of the energy put in, where that is more than a stated share of it; else nothing.
  [[nodiscard]] std::string ledger_text() const;
  /// Bodies that have just come outside the bounds with all of their nodes, in order. Call it at every instant too.
  template <int D>
  std::vector<int> leaving(const Model<D>& model, const State<D>& state, const Work<D>& work);

  /// Remembers where all nodes are as a stage that looks for rest in place begins. What earlier stages began with is
  /// kept, as a run may go back into them.
  template <int D>
  void keep_places(const State<D>& state);
  /// At the end of such a stage: the body that has left its place since it began, farther than StageOptions::within.
  template <int D>
  const Travel& look_at_places(const Instant<D>& now);
  /// Of the last stage that was looked at so.
  [[nodiscard]] const Travel& displaced() const { return displaced_; }
  /// Until when no bond can come near its strength, see integrate/explicit/bond_step.hpp.
  BondRoom& bonds() { return bonds_; }

 private:
  template <int D>
  std::optional<Divergence> look_at_elements(const Instant<D>& now);
  template <int D>
  std::optional<Divergence> look_at_beams(const Instant<D>& now);
  template <int D>
  std::optional<Divergence> look_at_magnitudes(const Instant<D>& now);
  template <int D>
  void count_from(const Instant<D>& now, const Energy& energy);

  double element_room_ = 0;  // path of the fastest point until an element may be at its limit [m]
  double beam_room_ = 0;     // ... a beam of a member [m]
  double bounds_room_ = 0;   // ... until a node may be outside the bounds [m]
  double sound_until_ = 0;   // [s]
  BondRoom bonds_;
  bool counts_ = false;
  Energy from_;                 // ledger from which energies count
  int free_dofs_ = 0;           // then
  double given_speed_ = 0;      // that bodies had then, and motions have [m/s]
  double most_energy_ = 0;      // that was there, or put in, at any look [J]
  double off_ = 0;              // energy made, at the look where it was most of either sign [J]
  double most_put_in_ = 0;      // since energies count, at any instant [J]
  double looked_speed_ = 0;     // fastest point when it last looked at magnitudes [m/s]
  std::int64_t next_look_ = 0;  // at this step
  std::vector<std::pair<double, std::variant<Placement<2>, Placement<3>>>> places_;  // by the begin of stages [s]
  Travel displaced_;
};

}  // namespace trilith
