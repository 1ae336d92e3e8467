#include "run/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/portable.hpp"
#include "base/quantity_text.hpp"
#include "model/element/element_rows.hpp"
#include "model/event/event_text.hpp"
#include "model/pose.hpp"
#include "run/element_stretch.hpp"
#include "run/record/body_forces.hpp"
#include "run/stage_end.hpp"
#include "run/watch_beams.hpp"

namespace trilith {
namespace {

/// Magnitudes are checked at this interval of steps, and whenever the fastest point has doubled its speed.
constexpr std::int64_t steps_between_looks = 1024;
constexpr double least_speed = 0.01;  // no speed check below this speed [m/s]
/// Speed of sound in hard rock: contact laws are not valid for faster impacts [m/s].
constexpr double rock_sound = 5000;
/// Energies that correspond to less than this speed of all bodies are ignored [m/s].
constexpr double trifling_speed = 1e-3;

/// An energy error of the steps above this share of the energy supplied is reported.
constexpr double told_share = 0.05;

/// Largest velocity of a motion, exact at its samples [m/s].
double peak_velocity(const GroundMotion& motion) {
  double peak = 0;
  for (const MotionAt& sample : motion.samples()) peak = std::max(peak, std::abs(sample.velocity));
  return peak;
}

/// Sum of the speeds from the initial state, the present state and all motions, including the rotation of driven
/// bodies. No body can receive more.
template <int D>
double given_speed(const Instant<D>& now) {
  double speed = now.work.fastest;
  const double reach =
      now.model.body_radius.empty() ? 0 : *std::max_element(now.model.body_radius.begin(), now.model.body_radius.end());
  for (const Drive& d : now.model.drives) speed += (d.dof >= D ? reach : 1) * peak_velocity(*d.motion);
  for (const Push<D>& p : now.model.pushes) speed += peak_velocity(*p.motion);
  return speed;
}

/// Kinetic and elastic energy at present [J].
double held(const Energy& e) {
  return e[EnergyTerm::kinetic] + e[EnergyTerm::contact_elastic] + e[EnergyTerm::bearing_elastic] +
         e[EnergyTerm::strain];
}

double dissipated(const Energy& e) {
  double sum = 0;
  for (int i = 0; i < energy_terms; ++i)
    if (energy_term_info[i].dissipated) sum += e.value[i];
  return sum;
}

/// Energy supplied by weight and by all terms of the ledger that are inputs [J].
double put_in(const Energy& e) {
  double sum = 0;
  for (int i = 0; i < energy_terms; ++i)
    if (energy_term_info[i].sign < 0) sum += e.value[i];
  return sum - e[EnergyTerm::gravity];
}

/// Speed of sound in the stiffest solid, with the density of its body, and at least in rock [m/s].
template <int D>
double sound_speed(const Model<D>& model) {
  double most = rock_sound;
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const Element& element = model.elements[e];
    if (e > 0 && model.elements[e - 1].body == element.body) continue;
    const double young = std::visit([](const auto& law) { return law.young; }, model.solids[element.solid].law);
    const double volume = model.bodies[element.body].area * element.thickness;
    most = std::max(most, std::sqrt(young * volume / body_mass(model, element.body)));
  }
  if constexpr (D == 3)
    for (std::size_t e = 0, end = 0; e < model.space_elements.size(); e = end) {
      const int body = model.space_elements[e].body;
      double volume = 0, young = 0;
      for (end = e; end < model.space_elements.size() && model.space_elements[end].body == body; ++end) {
        volume += model.space_elements[end].volume;
        young =
            std::visit([](const auto& law) { return law.young; }, model.solids[model.space_elements[end].solid].law);
      }
      most = std::max(most, std::sqrt(young * volume / body_mass(model, body)));
    }
  return most;
}

template <int D>
std::string element_name(const Model<D>& model, int element) {
  int first = element;
  while (first > 0 && elements_of(model)[first - 1].body == elements_of(model)[element].body) --first;
  return fmt::format("element {}", element - first + 1);
}

/// "element 2"; for a frame of several members "element 2 of column".
template <int D>
std::string beam_name(const Model<D>& model, const BeamStretch& s) {
  const Member& member = model.members[static_cast<std::size_t>(s.member)];
  const std::string of = member.name == model.bodies[member.body].name ? "" : " of " + member.name;
  return fmt::format("element {}{}", s.beam - member.first_beam + 1, of);
}

/// Divergence of the element `name` of `body`, which was strained beyond its limit.
template <int D>
Divergence overstrained(const Instant<D>& now, const std::string& name, int body, double strain, double limit,
                        const std::type_identity_t<Vec<D>>& place) {
  Event event = stage_event(EventType::element_overstrained, now, name);
  event.body_a = body, event.value = strain;
  event.set_place(place);
  return {fmt::format("{} (its material is valid up to {:g} %)", event_text(event, now.model), 100 * limit),
          "use a stiffer material or less load, apply it more slowly, or give the material a larger strain_limit if it "
          "is valid for more",
          now.state.time - now.state.last_dt, event};
}

}  // namespace

template <int D>
bool is_overstrained(const Model<D>& model, const State<D>& state) {
  double room = unbounded;
  return worst_element(model, state, room).spare <= 0 || worst_beam(model, state).spare <= 0;
}

template <int D>
std::optional<Divergence> Watch::look_at_elements(const Instant<D>& now) {
  const auto& elements = elements_of(now.model);
  if (elements.empty()) return std::nullopt;
  // No element is checked before the travel of the fastest point exceeds the reserve of every element.
  element_room_ -= now.work.fastest * now.state.last_dt;
  if (element_room_ > 0) return std::nullopt;
  double room = unbounded;
  const ElementStretch worst = worst_element(now.model, now.state, room);
  element_room_ = (1 - 1e-9) * room;
  if (worst.spare > 0) return std::nullopt;
  const auto& element = elements[worst.element];
  Vec<D> middle = Vec<D>::Zero();
  for (int i = 0; i < nodes_of(element); ++i) middle += now.state.position[element.node[i]] / nodes_of(element);
  return overstrained(now, element_name(now.model, worst.element), element.body, worst.strain,
                      now.model.solids[element.solid].strain_limit, middle);
}

template <int D>
std::optional<Divergence> Watch::look_at_beams(const Instant<D>& now) {
  if (now.model.members.empty()) return std::nullopt;
  beam_room_ -= now.work.fastest * now.state.last_dt;
  if (beam_room_ > 0) return std::nullopt;
  const BeamStretch worst = worst_beam(now.model, now.state);
  beam_room_ = (1 - 1e-9) * worst.room;
  if (worst.spare > 0) return std::nullopt;
  const Member& member = now.model.members[static_cast<std::size_t>(worst.member)];
  return overstrained(now, beam_name(now.model, worst), member.body, worst.strain, member.strain_limit,
                      middle_of_beam(now.model, now.state, worst.beam));
}

/// In a stage without time a strain cannot be approached more slowly, so the advice differs.
template <int D>
std::optional<Divergence> Watch::look_at_strains(const Instant<D>& now, const std::string& under) {
  invalidate();
  std::optional<Divergence> found = look_at_elements(now);
  if (!found) found = look_at_beams(now);
  if (!found) return found;
  found->found += ", " + under;
  found->advice =
      "use a stiffer material or less load, or give the material a larger strain_limit if it is valid for more";
  found->sound_until = now.begun;
  return found;
}

/// Sets the ledger from which energy errors count, and the speed that motions and the initial state can supply.
template <int D>
void Watch::count_from(const Instant<D>& now, const Energy& energy) {
  counts_ = true;
  from_ = energy;
  free_dofs_ = now.model.free_dofs();
  given_speed_ = given_speed(now);
  most_energy_ = held(energy);
  most_put_in_ = 0;
  off_ = 0;
}

std::string Watch::ledger_text() const {
  const double input = std::max(most_energy_, held(from_) + most_put_in_);
  if (!counts_ || !(std::abs(off_) > told_share * input)) return "";
  return fmt::format(
      "its steps {} {}, {} of the input of {}; impacts need shorter steps: leave dt out, or give a smaller dt, safety "
      "or accuracy",
      off_ > 0 ? "gained" : "lost", quantity_text(std::abs(off_), "J"), percent_text(std::abs(off_) / input),
      quantity_text(input, "J"));
}

/// Two bounds that hold for every physical run. Energy error (stored + dissipated - initial - supplied): at most the
/// largest energy that was present or supplied. Speed: at most the sum of the speeds from the initial state and
/// motions, of a fall through the bounds, and of sound.
template <int D>
std::optional<Divergence> Watch::look_at_magnitudes(const Instant<D>& now) {
  const Energy e = energy_now(now.model, now.state, now.work, {now.dt, {now.stage.rest_share}});
  // Freed or removed bodies change the kinetic energy; the check restarts here.
  if (!counts_ || now.model.free_dofs() != free_dofs_) count_from(now, e);
  most_put_in_ = std::max(most_put_in_, put_in(e) - put_in(from_));
  const double start = held(from_), given = most_put_in_;
  const double lost = dissipated(e) - dissipated(from_), made = held(e) + lost - start - (put_in(e) - put_in(from_));
  double mass = 0;
  for (int n = 0; n < now.model.nodes(); ++n)
    if (now.model.moves(n)) mass += now.model.mass[n];
  // The kinetic energy of leapfrog is negative if a velocity reverses.
  const double most = std::max({0.0, most_energy_, start + given}),
               trifle = 0.5 * mass * trifling_speed * trifling_speed;
  const auto fastest = [&] {
    const int body = worst_bodies(now.model, now.work).fastest;
    if (body < 0) return std::string("all bodies are held or driven");
    return fmt::format("{} is fastest, at {:.3g} m/s", now.model.bodies[body].name, now.speed);
  };
  if (!std::isfinite(made))
    return Divergence{fmt::format("the energy is no longer a finite number; {}", fastest()),
                      "use a smaller safety or less load",
                      sound_until_,
                      {}};
  if (made > most + trifle)
    return Divergence{fmt::format("the energy balance gained {}, more than the input of {}; {}",
                                  quantity_text(made, "J"), quantity_text(most, "J"), fastest()),
                      "use a smaller safety, or find the stiff parts near it with explain_dt",
                      sound_until_,
                      {}};
  const double fall = now.model.gravity.field.norm() * (now.model.bounds.high - now.model.bounds.low).norm();
  const double limit = given_speed_ + std::sqrt(2 * fall) + sound_speed(now.model);
  if (now.speed > limit)
    return Divergence{
        fmt::format(
            "{}, more than its start, motions, fall and the speed of sound in its material ({:.3g} m/s) can explain",
            fastest(), sound_speed(now.model)),
        "check loads and masses near it; give an intended speed as the velocity at the start",
        sound_until_,
        {}};
  if (std::abs(made) > std::max(trifle, std::abs(off_))) off_ = made;
  // An energy error does not count as present energy, otherwise a slow growth would raise its own bound.
  most_energy_ = std::max({most_energy_, start + given, held(e) + lost - std::max(0.0, made)});
  looked_speed_ = std::max(now.speed, least_speed);
  next_look_ = now.state.step + steps_between_looks;
  sound_until_ = now.state.time;
  return std::nullopt;
}

template <int D>
std::optional<Divergence> Watch::look(const Instant<D>& now, bool last) {
  if (!std::isfinite(now.speed) || !std::isfinite(now.work.unbalanced))
    return Divergence{"speeds or forces are no longer finite numbers",
                      "use a smaller safety or less load",
                      counts_ ? sound_until_ : now.begun,
                      {}};
  if (auto found = look_at_elements(now)) return found;
  if (auto found = look_at_beams(now)) return found;
  if (!now.stage.watched) return std::nullopt;
  // A cyclic support motion withdraws the energy that it supplied, and no check may fall between the two.
  if (counts_) most_put_in_ = std::max(most_put_in_, put_in(now.state.given) - put_in(from_));
  // Energies require a pass over all contacts, so they are checked rarely.
  if (counts_ && !last && now.speed <= 2 * looked_speed_ && now.state.step < next_look_) return std::nullopt;
  return look_at_magnitudes(now);
}

template <int D>
std::vector<int> Watch::leaving(const Model<D>& model, const State<D>& state, const Work<D>& work) {
  std::vector<int> out;
  bounds_room_ -= work.fastest * state.last_dt;
  if (bounds_room_ > 0) return out;
  double room = unbounded;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
    if (state.left[b] != 0 || !model.body_moves(b)) continue;
    const Body& body = model.bodies[b];
    double inside = -unbounded;  // distance of the innermost node from the bounds; positive inside
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
      inside = std::max(inside, std::min((state.position[n] - model.bounds.low).minCoeff(),
                                         (model.bounds.high - state.position[n]).minCoeff()));
    if (inside < 0)
      out.push_back(b);
    else
      room = std::min(room, inside);
  }
  bounds_room_ = (1 - 1e-9) * room;
  return out;
}

template bool is_overstrained(const Model<2>&, const State<2>&);
template bool is_overstrained(const Model<3>&, const State<3>&);
template std::optional<Divergence> Watch::look(const Instant<2>&, bool);
template std::optional<Divergence> Watch::look_at_strains(const Instant<2>&, const std::string&);
template std::optional<Divergence> Watch::look_at_strains(const Instant<3>&, const std::string&);
template std::vector<int> Watch::leaving(const Model<2>&, const State<2>&, const Work<2>&);
template std::optional<Divergence> Watch::look(const Instant<3>&, bool);
template std::vector<int> Watch::leaving(const Model<3>&, const State<3>&, const Work<3>&);

}  // namespace trilith
