#include "events/bearing_events.hpp"

#include "assembly/bearing_motion.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "assembly/evaluate.hpp"
#include "broad_phase/bearing_rules.hpp"
#include "broad_phase/pairs.hpp"
#include "contact/plane/overlap_energy.hpp"
#include "contact/space/solid_contact.hpp"
#include "events/body_events.hpp"
#include "model/pose.hpp"

namespace trilith {

double failed_displacement(const Vec2& displacement, std::uint32_t direction) {
  return direction == turning ? 0 : displacement[direction];
}
double failed_displacement(const Vec3& displacement, std::uint32_t direction) {
  if (direction == Directions<3>::horizontal) return portable::hypot(displacement.x(), displacement.y());
  return direction < 3 ? displacement[direction] : 0;
}

namespace {

Vec2 first_point(const Model<2>& model, const State<2>& state, const Bearing<2>& b) {
  return pose_at(model, state, b.end_a).place;
}
Vec3 first_point(const Model<3>& model, const State<3>& state, const Bearing<3>& b) {
  return point_of(model, state, b.end_a);
}

/// The direction in which a bearing that was intact has begun to yield or slide.
template <int D>
std::uint32_t yielded_direction(const Bearing<D>& b, const BearingMemory<D>& before, const BearingMemory<D>& after) {
  const std::uint32_t level = b.has_horizontal() ? Directions<3>::horizontal : 0;
  for (std::size_t k = 0; k < after.direction.size(); ++k)
    if (after.direction[k].travelled > before.direction[k].travelled)
      return k < 2 && b.has_horizontal() ? level : static_cast<std::uint32_t>(k);
  return level;
}

/// Adds the event of a bearing with its name, place, and displacement in `direction`, which yielded or failed.
template <int D>
void push_bearing_event(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i, EventType type,
                        std::uint32_t direction) {
  const Bearing<D>& b = model.bearings[i];
  Event e = event_now(state, type, b.body_a, b.body_b);
  e.bearing = static_cast<int>(i);
  e.value = failed_displacement(work.bearing_displacement[i], direction);
  e.set_place(first_point(model, state, b));
  work.events.push_back(e);
}

/// Elastic energy of the contact of two pieces, with the bearings in the given states [J]. Valid for an overlap of any
/// shape; 0 while a bearing suppresses the contact.
double energy_beside(const Model<2>& model, const State<2>& state, const Work<2>& work,
                     std::span<const BearingMemory<2>> bearings, int p, int q) {
  NearPair pair{p, q, contact_law(model, model.piece_body[p], model.piece_body[q]), 0, 0, 0, 0, 0, 1.0, false};
  if (pair.law < 0) return 0;
  apply_bearings<2>(model, work.search, bearings, pair);
  LawInUse law = law_in_use(model, pair.law);
  PieceCorners corners_p, corners_q;
  const PlacedPiece a = placed_piece(model, state, work, p, corners_p),
                    b = placed_piece(model, state, work, q, corners_q);
  if (pair.replaced) {
    if (presses_flat<2>(model, state, work, bearings, pair, whole_overlap(a, b, law).force)) return 0;
    law.held = depth_stood_for<2>(model, work.search, bearings, pair);
  }
  return overlap_energy(a, b, law);
}

/// Elastic energy of a contact of two pieces without the bearings that suppressed it, with the shear in its memory [J].
double energy_beside(const Model<3>& model, const State<3>& state, const Work<3>& work,
                     std::span<const BearingMemory<3>> bearings, int p, int q) {
  const int a = model.piece_body[p], b = model.piece_body[q];
  NearPair pair{std::min(p, q),
                std::max(p, q),
                model.law_of[model.bodies[a].surface * model.surfaces + model.bodies[b].surface],
                0,
                0,
                0,
                0,
                0,
                1.0,
                false};
  if (pair.law < 0) return 0;
  apply_bearings<3>(model, work.search, bearings, pair);
  SolidOverlapBuffer shared, scratch;  // buffers; bearings fail once
  const PlacedSolid &first = work.solids.placed[pair.piece_a], &second = work.solids.placed[pair.piece_b];
  LawInUse law{model.laws[pair.law], model.thickness, 0};
  SolidMemory memory;
  if (const int row = work.contacts.find(contact_key(pair.piece_a, pair.piece_b)); row >= 0)
    memory = work.contacts.memory[static_cast<std::size_t>(row)];
  const auto at_rest = [&](const PlacedSolid& solid, int piece) {
    return MovingSolid{solid, motion_of(model, state, model.carrier_of(piece)).place, Vec3::Zero(), Vec3::Zero()};
  };
  if (pair.replaced) {
    Separation3 apart{0, Vec3::UnitX(), SeparatingFeature::face_of_a, 0, 0};
    const SolidPressure pressed = pressure_between(at_rest(first, pair.piece_a), at_rest(second, pair.piece_b), law,
                                                   apart, shared, true, memory.crushed);
    if (presses_flat<3>(model, state, work, bearings, pair, pressed.force)) return 0;
    law.held = depth_stood_for<3>(model, work.search, bearings, pair);
  }
  return solid_contact_energy(first, second, memory, law, shared, scratch);
}

/// Increase of the elastic energy of the contact at bearing `i` due to its failure [J].
template <int D>
double released_contact_energy(const Model<D>& model, const State<D>& state, const Work<D>& work, std::size_t i) {
  const Bearing<D>& b = model.bearings[i];
  for (std::size_t j = 0; j < i; ++j)  // a bearing that failed earlier in the same step has counted it
    if (is_live(state.bearing[j].status) && !is_live(work.bearing[j].status) && model.bearings[j].alters_contact() &&
        model.bearings[j].sits_between(b.piece_a, b.piece_b))
      return 0;
  return energy_beside(model, state, work, work.bearing, b.piece_a, b.piece_b) -
         energy_beside(model, state, work, state.bearing, b.piece_a, b.piece_b);
}

/// Displacement at which the successor of `b` takes over, in the directions in which its displacement starts there.
template <int D>
std::array<double, Space<D>::dofs> takes_over_at(const Model<D>& model, const State<D>& state, const Bearing<D>& b) {
  std::array<double, Space<D>::dofs> at{};
  const auto here = bearing_motion(model, state, static_cast<std::size_t>(b.becomes_bearing)).displacement;
  for (std::size_t k = 0; k < at.size(); ++k)
    if (b.next_from_here[k]) at[k] = here[k];
  return at;
}

/// Starts the successor of a failed bearing. Its initial elastic energy is subtracted from the dissipated energy.
template <int D>
void hand_on(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i) {
  const Bearing<D>& b = model.bearings[i];
  double& dissipated = work.given[EnergyTerm::bearing_failure];
  if (b.becomes_bearing >= 0 && work.bearing[b.becomes_bearing].status == BearingStatus::waiting)
    dissipated -= start_bearing(model, state, work, b.becomes_bearing, takes_over_at(model, state, b));
  if (!b.alters_contact()) return;
  dissipated -= released_contact_energy(model, state, work, i);
  work.valid = false;  // the contact of the two pieces follows another law from now on
}

/// A horizontal displacement of a bearing below this value does not count as yielding [m]. A slider without load has no
/// friction, so rounding moves it before the weight of the structure arrives.
constexpr double least_yielding = 1e-6;

/// True if the bearing yields in a horizontal direction and has not been displaced noticeably.
template <int D>
bool yields_unnoticed(const Work<D>& work, std::size_t i, std::uint32_t direction) {
  const bool level =
      direction == Directions<3>::horizontal || direction < static_cast<std::uint32_t>(Directions<D>::axial);
  return level && std::abs(failed_displacement(work.bearing_displacement[i], direction)) < least_yielding;
}

template <int D>
void bearing_event(const Model<D>& model, const State<D>& state, Work<D>& work, std::size_t i) {
  const BearingStatus before = state.bearing[i].status;
  BearingMemory<D>& after = work.bearing[i];
  if (before == after.status) return;
  const Bearing<D>& b = model.bearings[i];
  const auto push = [&](EventType type, std::uint32_t direction) {
    push_bearing_event(model, state, work, i, type, direction);
  };
  if (after.status == BearingStatus::yielded) {
    const std::uint32_t direction = yielded_direction(b, state.bearing[i], after);
    if (yields_unnoticed(work, i, direction))
      after.status = before;
    else
      push(EventType::bearing_yielded, direction);
  }
  if (after.status != BearingStatus::failed) return;
  push(EventType::bearing_failed, after.failed_direction);
  if (b.becomes_bearing < 0 && !b.alters_contact()) return;
  after.status = BearingStatus::changed;
  push(EventType::bearing_changed, after.failed_direction);
  hand_on(model, state, work, i);
}

/// A bearing that ends dissipates its elastic energy at once.
template <int D>
void account_failed(const State<D>& state, Work<D>& work, std::size_t i) {
  if (!is_live(state.bearing[i].status) || is_live(work.bearing[i].status)) return;
  work.given[EnergyTerm::bearing_failure] += work.bearing_energy[i];
}

}  // namespace

template <int D>
void bearing_events(const Model<D>& model, const State<D>& state, Work<D>& work) {
  for (std::size_t i = 0; i < model.bearings.size(); ++i) {
    bearing_event(model, state, work, i);
    account_failed(state, work, i);
  }
}

template void bearing_events(const Model<2>&, const State<2>&, Work<2>&);
template void bearing_events(const Model<3>&, const State<3>&, Work<3>&);

}  // namespace trilith
