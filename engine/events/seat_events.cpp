#include "events/seat_events.hpp"

#include "assembly/bearing_motion.hpp"
#include "events/body_events.hpp"
#include "events/find_events.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

Vec2 end_of(const Model<2>& model, const State<2>& state, const Seat<2>& seat) {
  return pose_at(model, state, seat.end).place;
}
Vec3 end_of(const Model<3>& model, const State<3>& state, const Seat<3>& seat) {
  return point_of(model, state, seat.end);
}

/// Speed of the span [m/s]; in space, of the part that its end is attached to.
double span_speed(const Model<2>& model, const State<2>& state, const Seat<2>& seat) {
  return body_pose(model, state, seat.body).velocity.norm();
}
double span_speed(const Model<3>& model, const State<3>& state, const Seat<3>& seat) {
  return motion_of(model, state, seat.end.node[0]).velocity.norm();
}

}  // namespace

// Distance of the span end behind the seat edge, along `inward` of the support [m].
//
//         span
//     ------------+            l = n . (end - edge), n rotates with the support.
//             end | <--n       The seat is lost if l is not above 0.
//          |<- l >|
//          +---------
//     edge |  support
double seat_length(const Model<2>& model, const State<2>& state, const Seat<2>& seat) {
  const Pose edge = pose_at(model, state, seat.edge);
  const Vec2 end = pose_at(model, state, seat.end).place;
  return Turn(edge.rotation).apply(seat.inward).dot(end - edge.place);
}

double seat_length(const Model<3>& model, const State<3>& state, const Seat<3>& seat) {
  const Vec3 inward = turn_of(motion_of(model, state, seat.edge.node[0]).rotation).apply(seat.inward);
  return inward.dot(point_of(model, state, seat.end) - point_of(model, state, seat.edge));
}

template <int D>
void seat_events(const Model<D>& model, State<D>& state, Work<D>& work) {
  for (std::size_t i = 0; i < model.seats.size(); ++i) {
    const Seat<D>& seat = model.seats[i];
    if (state.seat_lost[i] != 0 || seat_length(model, state, seat) > 0) continue;
    state.seat_lost[i] = 1;
    Event e = event_now(state, EventType::seat_lost, seat.body, seat.support);
    e.value = span_speed(model, state, seat);
    e.set_place(end_of(model, state, seat));
    e.text = seat.name;
    work.events.push_back(e);
  }
}

template void seat_events(const Model<2>&, State<2>&, Work<2>&);
template void seat_events(const Model<3>&, State<3>&, Work<3>&);

}  // namespace trilith
