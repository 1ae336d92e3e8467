#include "readings/section_forces.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/contact/contact_resultants.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/field/joint_water.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// A plane that meets a face at a smaller angle than this [1] runs along it and does not divide it.
constexpr double least_crossing = 1e-6;

SurfaceForce reversed(const SurfaceForce& f) {
  return {f.point, -f.force, -f.moment};
}

/// Adds a force and its moment about `centre`.
void add_about(const Vec2& centre, const SurfaceForce& f, Vec2& force, double& moment) {
  force += f.force;
  moment += cross(Vec2(f.point - centre), f.force) + f.moment;
}

/// Share of a half's shear that acts in its part [from, to]: shear is uniform where the half carries it.
double shear_share(const HalfGaps& half, bool bonded, double from, double to) {
  PositivePart<double> carries(-half.g0, -half.g1);
  if (bonded || !(carries.to > carries.from)) carries.from = 0, carries.to = 1;
  const double width = std::min(to, carries.to) - std::max(from, carries.from);
  return std::max(0.0, width) / (carries.to - carries.from);
}

/// Normal force, its moment about the start of the shared length, and shear [N], [N m].
struct FaceSums {
  double normal = 0, moment = 0, shear = 0;
};

/// Damping stress, linear over the shared length, from its force and its moment about the middle.
void add_damping(const FaceOverlap<double>& o, const ContactMemory& m, double from, double to, FaceSums& out) {
  const double length = o.shared, force = m.damping_force[0], couple = m.damping_force[1];
  if (force == 0 && couple == 0) return;
  const double middle = o.lo + 0.5 * length, a = from - middle, b = to - middle;
  const double mean = force / length, slope = 12 * couple / (length * length * length);
  const double sum = mean * (b - a) + 0.5 * slope * (b * b - a * a);
  const double first = 0.5 * mean * (b * b - a * a) + slope * (b * b * b - a * a * a) / 3;
  out.normal += sum;
  out.moment += first + (middle - o.lo) * sum;
}

/// Integrals of the stresses of two faces from coordinate `from` to `to` [m].
FaceSums face_sums(const Model<2>& model, const Work<2>& work, int row, double from, double to) {
  const NearPair& pair = work.pairs[static_cast<std::size_t>(row)];
  const auto at = static_cast<std::size_t>(row);
  const ContactMemory& memory = work.contacts.memory[at];
  const FaceOverlap<double> o = face_overlap(work, pair);
  FaceSums out;
  with_kernel(law_in_use(model, pair.law), [&]<class K>(const K& law) {
    const LawMemory<K> own = law_memory<K>(work.contacts.law_numbers(at));
    const auto gaps = law.gaps(o, memory, own);
    const double half = 0.5 * o.shared;
    for (const int h : {0, 1}) {
      const double start = o.lo + h * half;
      const double a = std::clamp((from - start) / half, 0.0, 1.0), b = std::clamp((to - start) / half, 0.0, 1.0);
      if (!(b > a)) continue;
      const auto side = static_cast<std::size_t>(h);
      const HalfPressure p = pressure_of_half(law, gaps[side], half, memory, own, h, a, b);
      out.normal += p.force;
      out.moment += p.moment + (start - o.lo) * p.force;
      out.shear += memory.shear_total[h] * shear_share(gaps[side], memory.bonded(h), a, b);
    }
  });
  add_damping(o, memory, from, to, out);
  return out;
}

}  // namespace

SurfaceForces::SurfaceForces(const Model<2>& model, const State<2>& state, const Work<2>& work)
    : model_(model), state_(state), work_(work), slot_(model.bodies.size(), -1) {}

void SurfaceForces::collect(std::span<const int> bodies) {
  for (const BodyForces& b : bodies_) slot_[static_cast<std::size_t>(b.body)] = -1;
  bodies_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    BodyForces& b = bodies_[i];
    b.body = bodies[i], b.points.clear(), b.faces.clear(), b.loads.clear();
    slot_[static_cast<std::size_t>(b.body)] = static_cast<int>(i);
  }
  add_contacts();
  add_bearings();
  add_loads();
  for (BodyForces& b : bodies_) {
    const Vec2 centre = state_.position[static_cast<std::size_t>(model_.bodies[b.body].first_node)];
    b.sum = {centre, Vec2::Zero(), 0};
    for (const SurfaceForce& f : b.points) add_about(centre, f, b.sum.force, b.sum.moment);
    for (const FaceForce& f : b.faces) add_about(centre, f.whole, b.sum.force, b.sum.moment);
    ForceSum<2> loads{centre};
    WholeLoads<2> on{{model_, state_, &work_, &work_.closed_joints}, loads};
    apply_parts(model_, b.loads, on);
    b.sum.force += loads.force, b.sum.moment += loads.moment;
    if (has_joint_water(model_)) {
      const JointThrust water = thrust_on_body(model_, state_, b.body, centre);
      b.sum.force += water.force, b.sum.moment += water.moment;
    }
  }
}

void SurfaceForces::add_point(int body, const SurfaceForce& force) {
  if (body >= 0 && slot_of(body) >= 0) bodies_[static_cast<std::size_t>(slot_of(body))].points.push_back(force);
}

/// Contacts of faces are kept with their stresses; others act at one point.
void SurfaceForces::add_contacts() {
  std::size_t general = 0;  // both lists are sorted by row
  for (int row = 0; row < static_cast<int>(work_.pairs.size()); ++row) {
    const NearPair& p = work_.pairs[static_cast<std::size_t>(row)];
    const int a = model_.piece_body[p.piece_a], b = model_.piece_body[p.piece_b];
    if (slot_of(a) < 0 && slot_of(b) < 0) continue;
    const ContactMemory& memory = work_.contacts.memory[static_cast<std::size_t>(row)];
    if ((memory.state & contact_touching) == 0) continue;
    if ((memory.state & contact_general) == 0) {
      add_faces(row, a, b);
      continue;
    }
    while (general < work_.general_touching.size() && work_.general_touching[general].row < row) ++general;
    if (general == work_.general_touching.size()) continue;
    const GeneralContact<2>& g = work_.general_touching[general];
    if (g.row != row) continue;
    const SurfaceForce on_b{g.centre, general_resultant(g.centre, g.force, memory).force, 0};
    add_point(b, on_b);
    add_point(a, reversed(on_b));
  }
}

void SurfaceForces::add_faces(int row, int first, int second) {
  const NearPair& p = work_.pairs[static_cast<std::size_t>(row)];
  const FaceOverlap<double> o = face_overlap(work_, p);
  if (!o.sane) return;
  FaceForce face{row, 1, Vec2::Zero(), {o.dx, o.dy}, {o.dy, -o.dx}, o.lo, o.hi, {}};
  const SkinMotion<2>&a0 = work_.skin[p.a0], &a1 = work_.skin[p.a1];
  const Vec2 start(a0.x, a0.y);
  const double slope = face.across.dot(Vec2(a1.x - a0.x, a1.y - a0.y)) * o.inv_a;
  const double middle = slope * (o.lo + 0.5 * o.shared) + 0.25 * (o.gap_lo + o.gap_hi);
  face.origin = start + middle * face.across;
  for (const auto& [body, sign] : {std::pair{second, 1.0}, std::pair{first, -1.0}}) {
    if (slot_of(body) < 0) continue;
    face.sign = sign;
    face.whole = part_of(face, o.lo, o.hi);
    bodies_[static_cast<std::size_t>(slot_of(body))].faces.push_back(face);
  }
}

/// The moment of the normal stress about the point: it acts along n, and d x n = -1.
SurfaceForce SurfaceForces::part_of(const FaceForce& face, double from, double to) const {
  const FaceSums s = face_sums(model_, work_, face.row, from, to);
  const SurfaceForce on_second{face.origin + face.lo * face.along, s.normal * face.across - s.shear * face.along,
                               -s.moment};
  return face.sign > 0 ? on_second : reversed(on_second);
}

/// Both forces of a bearing act along one line through the point of its second body.
void SurfaceForces::add_bearings() {
  for (std::size_t i = 0; i < model_.bearings.size() && i < work_.bearing_force.size(); ++i) {
    const Bearing<2>& b = model_.bearings[i];
    if (slot_of(b.body_a) < 0 && slot_of(b.body_b) < 0) continue;
    const Vec2 place = pose_at(model_, state_, b.end_b).place, first = pose_at(model_, state_, b.end_a).place;
    const SurfaceForce on_b{place, work_.bearing_force[i], work_.bearing_moment[i]};
    add_point(b.body_b, on_b);
    // At the point of the first body, with the moment that the line of action has about it.
    add_point(b.body_a, {first, -on_b.force, -on_b.moment - cross(Vec2(place - first), on_b.force)});
  }
}

/// Loads are kept by kind, because the part of a pressure behind a plane follows from its kind.
void SurfaceForces::add_loads() {
  for_load_parts(model_, [&](const auto& load, int part, const LoadPart& row) {
    const int body = load.body_of(part);
    if (body >= 0 && slot_of(body) >= 0) bodies_[static_cast<std::size_t>(slot_of(body))].loads.push_back(row);
  });
  add_pushes();
}

void SurfaceForces::add_pushes() {
  for (std::size_t i = 0; i < model_.pushes.size() && i < work_.push_force.size(); ++i)
    for (const PushRow<2>& row : model_.pushes[i].rows) {
      const auto n = static_cast<std::size_t>(row.node);
      const Vec2 place =
          state_.position[n] + Turn(state_.rotation[static_cast<std::size_t>(row.turn)]).apply(row.place);
      add_point(body_of_node(model_, row.node),
                {place, work_.push_force[i] * row.weight * model_.pushes[i].direction, 0});
    }
}

/// Leapfrog velocities are half a step old; the spin is brought to the instant.
PlaneForces SurfaceForces::in_section(std::size_t i, const CrackSection<2>& section) const {
  const BodyForces& b = bodies_[i];
  const auto n = static_cast<std::size_t>(model_.bodies[b.body].first_node);
  const Turn turn(state_.rotation[n]);
  const Vec2 centre = state_.position[n], normal = turn.apply(section.normal);
  const Vec2 middle = centre + turn.apply(section.middle()), arm = turn.apply(section.centroid);
  Vec2 force = Vec2::Zero();
  double moment = 0;
  const auto is_behind = [&](const Vec2& at) { return normal.dot(at - middle) <= 0; };
  for (const SurfaceForce& f : b.points)
    if (is_behind(f.point)) add_about(middle, f, force, moment);
  for (const FaceForce& f : b.faces) {
    const double slope = normal.dot(f.along), start = normal.dot(f.origin - middle);
    const double at = std::abs(slope) > least_crossing ? -start / slope : f.lo - 1;
    if (at > f.lo && at < f.hi)
      add_about(middle, slope > 0 ? part_of(f, f.lo, at) : part_of(f, at, f.hi), force, moment);
    else if (start + 0.5 * (f.lo + f.hi) * slope <= 0)
      add_about(middle, f.whole, force, moment);
  }
  ForceSum<2> loads{middle};
  LoadsBehind<2> on{{model_, state_, &work_, &work_.closed_joints}, middle, normal, loads};
  apply_parts(model_, b.loads, on);
  force += loads.force, moment += loads.moment;
  if (has_joint_water(model_)) {
    const PlaneBehind plane{middle, normal};
    const JointThrust water = thrust_on_body(model_, state_, b.body, middle, &plane);
    force += water.force, moment += water.moment;
  }
  const double turning = b.sum.moment / model_.inertia[n];
  const double spin = state_.spin[n] + (state_.implicit() ? 0.0 : 0.5 * state_.last_dt * turning);
  const Vec2 inert = section.mass * (b.sum.force / model_.mass[n] + cross(turning, arm) - spin * spin * arm);
  const Vec2 from_ahead = inert - force;
  return {normal.dot(from_ahead), left_of(normal).dot(from_ahead),
          section.inertia * turning + cross(Vec2(centre + arm - middle), inert) - moment};
}

}  // namespace trilith
