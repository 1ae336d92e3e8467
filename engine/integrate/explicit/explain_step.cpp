// The part of a model that limits the stable step, as text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "integrate/explicit/stable_step.hpp"
#include "model/element/element_rows.hpp"

namespace trilith {
namespace {

/// " (element 3 of 4, at 0.1, 0.2)": the element of the highest frequency, and its middle; empty for beams.
template <int D>
std::string stiffest_element(const Model<D>& model, const State<D>& state, int body) {
  const auto& elements = elements_of(model);
  int worst = -1, first = -1, count = 0;
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    if (elements[e].body != body) continue;
    if (first < 0) first = e;
    if (worst < 0 || model.element_rate[e] > model.element_rate[worst]) worst = e;
    ++count;
  }
  if (worst < 0) return "";
  Vec<D> middle = Vec<D>::Zero();
  const int nodes = nodes_of(elements[worst]);
  for (int i = 0; i < nodes; ++i) middle += state.position[elements[worst].node[i]] / nodes;
  return fmt::format(" (element {} of {}, at {:.4g})", worst - first + 1, count,
                     fmt::join(middle.data(), middle.data() + D, ", "));
}

}  // namespace

template <int D>
std::string explain_step(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  const StableStep s = stable_step(model, state, work);
  if (s.body < 0)
    return fmt::format("no stiffness governs; steps are limited to {:g} s, and by motions, loads and bearings",
                       longest_step);
  std::string text = fmt::format("body '{}' governs: stable step {:.4g} s, {:.4g} s without damping; its contacts:",
                                 model.bodies[s.body].name, s.dt, step_for(s.stiffness, 0));
  if (!model.bodies[s.body].is_rigid()) {
    const RateBound& own = model.element_bound[s.body];
    text = fmt::format(
        "body '{}' ({}) governs: stable step {:.4g} s, {:.4g} s without damping, {:.4g} s by its elements alone{}; its "
        "contacts:",
        model.bodies[s.body].name, name_of(model.bodies[s.body].kind), s.dt, step_for(s.stiffness, 0),
        step_for(own.stiffness, own.damping), stiffest_element(model, state, s.body));
  }
  int named = 0;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    const NearPair& p = work.pairs[row];
    const int a = model.piece_body[p.piece_a], b = model.piece_body[p.piece_b];
    if ((work.contacts.memory[row].state & contact_touching) == 0 || (a != s.body && b != s.body)) continue;
    text += fmt::format(" '{}' ({})", model.bodies[a == s.body ? b : a].name, model.law_names[p.law]);
    ++named;
  }
  for (const Bearing<D>& b : model.bearings)
    if (b.body_a == s.body || b.body_b == s.body) text += fmt::format(" bearing '{}'", b.name), ++named;
  if (named == 0) text += " none at present; estimated as if it lay on its stiffest face";
  return text;
}

template std::string explain_step(const Model<2>&, const State<2>&, const Work<2>&);
template std::string explain_step(const Model<3>&, const State<3>&, const Work<3>&);

}  // namespace trilith
