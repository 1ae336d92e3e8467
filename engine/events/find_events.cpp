#include "events/find_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "assembly/contact/bond_figure.hpp"
#include "assembly/contact/contact_resultants.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "assembly/evaluate.hpp"
#include "broad_phase/pairs.hpp"
#include "contact/joint/face_resultant.hpp"
#include "events/beam_events.hpp"
#include "events/bearing_events.hpp"
#include "events/body_events.hpp"
#include "events/parted_contacts.hpp"
#include "events/seat_events.hpp"
#include "events/water_events.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// Point at which two pieces touch and their closing speed there. For faces it is the middle of the shared length.
struct Meeting {
  Vec2 at;
  double closing;
};

/// Meeting of a general contact: its centre, and the speed along its force. For two faces, along d from a0:
///            a0 ---------------------> a1  d, and n = (d_y, -d_x) downwards, into b
///       b1 <-------------------- b0        shared from max(0, s(b1)) to min(s(a1), s(b0)); `at` is its middle
Meeting meeting(const Model<2>& model, const State<2>& state, const Work<2>& work, int row) {
  const NearPair& p = work.pairs[row];
  const int na = p.piece_a, nb = p.piece_b;
  PieceCorners corners;
  const auto velocity = [&](int piece, const Vec2& x) {
    return placed_piece(model, state, work, piece, corners).velocity_at(x);
  };
  if (const GeneralContact<2>* g = work.general_touching.find(row); g != nullptr) {
    const double size = g->force.norm();
    const Vec2 n = size > 0 ? Vec2(g->force / size) : Vec2::Zero();
    return {g->centre, -n.dot(velocity(nb, g->centre) - velocity(na, g->centre))};
  }
  const SkinMotion<2>&a0 = work.skin[p.a0], &a1 = work.skin[p.a1], &b0 = work.skin[p.b0], &b1 = work.skin[p.b1];
  const Vec2 along = Vec2(a1.x - a0.x, a1.y - a0.y).normalized(), n(along.y(), -along.x()), origin(a0.x, a0.y);
  const auto s = [&](const SkinMotion<2>& q) { return along.dot(Vec2(q.x, q.y) - origin); };
  const double middle = 0.5 * (std::max(0.0, s(b1)) + std::min(s(a1), s(b0)));
  const Vec2 at = origin + middle * along;
  return {at, -n.dot(velocity(nb, at) - velocity(na, at))};
}

/// Sets the mode and value of a bond event, from the present gaps and the committed memory; the trial memory of a lost
/// bond is empty. The mode is tension if a half that lost its bond opened beyond its limit.
void tell_mode(const Model<2>& model, const State<2>& state, const Work<2>& work, int row, Event& e) {
  const NearPair& p = work.pairs[row];
  const ContactHistory& before = contacts_before(state, work);
  const bool broken = e.type == EventType::bond_broken;
  with_kernel(law_in_use(model, p.law), [&]<class K>(const K& law) {
    if constexpr (K::bonds) {
      const auto overlap = face_overlap(work, p);
      const auto gaps = law.gaps(overlap, before.memory[row], law_memory<K>(before.law_numbers(row)));
      e.mode = JointMode::shear;
      for (const int h : {0, 1}) {
        const bool gone = !broken || before.memory[row].bonded(h) != work.contacts.memory[row].bonded(h);
        if (gone && law.pulled({gaps[h], gaps[h]})) e.mode = JointMode::tension;
      }
      tell_figure(e, {.tension = law.tension * overlap.shared,
                      .cohesion = law.cohesion * overlap.shared,
                      .stress = law.tension / model.thickness,
                      .softened = broken && K::softens});
    }
  });
}

/// The ends of a face at the start of the last step.
FaceEnds<double> ends_before(const State<2>& state, const Work<2>& work, int from, int to) {
  FaceEnds<double> ends = face_ends(work, from, to);
  const auto mean = [&](int point, double u, double v) {
    return work.skin_mean.empty() ? Vec2(u, v) : work.skin_mean[static_cast<std::size_t>(point)];
  };
  const Vec2 first = state.last_dt * mean(from, ends.u0, ends.v0), last = state.last_dt * mean(to, ends.u1, ends.v1);
  ends.x0 -= first.x(), ends.y0 -= first.y(), ends.x1 -= last.x(), ends.y1 -= last.y();
  return ends;
}

/// Resultant of a row at the start of the last step.
ContactResultant resultant_before(const Model<2>& model, const State<2>& state, const Work<2>& work, int row) {
  const NearPair& p = work.pairs[row];
  const ContactHistory& before = contacts_before(state, work);
  return with_kernel(law_in_use(model, p.law), [&]<class K>(const K& law) {
    return face_resultant(ends_before(state, work, p.a0, p.a1), ends_before(state, work, p.b0, p.b1),
                          before.memory[row], law_memory<K>(before.law_numbers(row)), law);
  });
}

/// Event of a bond that begins to soften or is lost: its last resultant, its place, and the limit that was reached.
void bond_event(const Model<2>& model, const State<2>& state, Work<2>& work, int row, EventType type) {
  const NearPair& p = work.pairs[row];
  const ContactResultant carried = resultant_before(model, state, work, row);
  Event e = event_now(state, type, model.piece_body[p.piece_a], model.piece_body[p.piece_b]);
  e.value = carried.force.norm();
  e.set_place(carried.point);
  tell_mode(model, state, work, row, e);
  work.events.push_back(e);
}

/// Resultant of a contact that touches now.
ContactResultant resultant_now(const Model<2>& model, const Work<2>& work, int row) {
  if (const GeneralContact<2>* g = work.general_touching.find(row); g != nullptr)
    return general_resultant(g->centre, g->force, work.contacts.memory[row]);
  return face_resultant(model, work, work.pairs[row], work.contacts.memory[row], work.contacts.law_numbers(row));
}

/// Event of mortar that begins to crush: its present resultant and place.
void crushing_event(const Model<2>& model, const State<2>& state, Work<2>& work, int row) {
  const NearPair& p = work.pairs[row];
  Event e = event_now(state, EventType::joint_crushed, model.piece_body[p.piece_a], model.piece_body[p.piece_b]);
  const ContactResultant carried = resultant_now(model, work, row);
  e.value = carried.force.norm();
  e.set_place(carried.point);
  e.mode = JointMode::compression;
  work.events.push_back(e);
}

/// Events of a lost bond, the first damage of a bond, and mortar that begins to crush.
void joint_events(const Model<2>& model, const State<2>& state, Work<2>& work, int row) {
  const ContactHistory& before = contacts_before(state, work);
  const JointChange change = with_kernel_type(before.law_row[row].place, [&]<class K>() {
    return K::change(before.memory[row], law_memory<K>(before.law_numbers(row)), work.contacts.memory[row],
                     law_memory<K>(work.contacts.law_numbers(row)));
  });
  if (change.broken) bond_event(model, state, work, row, EventType::bond_broken);
  if (change.cracked) bond_event(model, state, work, row, EventType::bond_cracked);
  if (change.crushed) crushing_event(model, state, work, row);
}

void contact_events(const Model<2>& model, State<2>& state, Work<2>& work, int row) {
  const ContactMemory &before = contacts_before(state, work).memory[row], &after = work.contacts.memory[row];
  const NearPair& p = work.pairs[row];
  const int a = model.piece_body[p.piece_a], b = model.piece_body[p.piece_b];
  const bool was = (before.state & contact_touching) != 0, is = (after.state & contact_touching) != 0;
  joint_events(model, state, work, row);
  if (was == is) return;
  if (!is) {
    state.parted.push_back({work.contacts.key[row], state.time});
    return;
  }
  // A contact that closes again is reported only as an impact.
  const bool again = has_closed_again(work, work.contacts.key[row]);
  const Meeting m = meeting(model, state, work, row);
  const bool strikes = m.closing > model.impact_speed;
  if (again && !strikes) return;
  Event e = event_now(state, strikes ? EventType::impact : EventType::contact_made, a, b);
  e.set_place(m.at);
  e.value = m.closing;
  work.events.push_back(e);
}

}  // namespace

void find_events(const Model<2>& model, State<2>& state, Work<2>& work) {
  work.events.clear();
  // Sorted by row, because faces and general contacts have appended their rows one after the other.
  std::sort(work.changed_rows.begin(), work.changed_rows.end());
  take_back(state, work);
  for (const int row : work.changed_rows) contact_events(model, state, work, row);
  if (!state.parted.empty()) parted_events(model, state, work);
  bearing_events(model, state, work);
  beam_events(model, state, work);
  seat_events(model, state, work);
  water_events(model, state, work);
  body_events(model, state, work);
}

}  // namespace trilith
