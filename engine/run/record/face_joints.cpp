#include "run/record/face_joints.hpp"

#include <algorithm>
#include <numeric>

#include "assembly/evaluate.hpp"
#include "assembly/start.hpp"
#include "contact/space/solid_faces.hpp"
#include "model/contact/contact_frame.hpp"

namespace trilith {
namespace {

// Shares of the smaller body's size: largest gap at the start between faces that count as touching, and their least
// shared width.
constexpr double nearly_flat = 1e-3, least_width = 1e-3;

/// World position of a joint's seat, which moves with a contact frame.
struct SeatNow {
  Vec3 place;
  Turn3 axes;
  SeatNow(const JointSeat& seat, const BodyMotion& body)
      : place(body.place + Turn3(body.rotation).apply(seat.place)), axes(body.rotation * seat.axes) {}
  [[nodiscard]] Vec3 at(const Vec2& p) const { return place + p.x() * axes.x() + p.y() * axes.y(); }
};

/// Fills `joint` from a plan: a mortar joint, or a joint of dry faces.
void take_plan(const JointPlan& plan, const Model<3>& model, const NearPair& pair, FaceJoint& joint) {
  joint.contact_frame = {model.carrier_of(pair.piece_a, plan.face_a), model.carrier_of(pair.piece_b, plan.face_b)};
  joint.in_a = plan.in_a, joint.in_b = plan.in_b, joint.outline = plan.outline, joint.area = plan.whole.area;
}

/// Mean loss of strength of the points of a patch.
double damage_of(const JointMemory& memory, std::size_t patch) {
  if (!memory.bonded(static_cast<int>(patch))) return 1;
  const PatchNumbers& damage = memory.patch[patch].damage;
  return std::accumulate(damage.begin(), damage.end(), 0.0) / patch_points;
}

/// Finds the touching faces of a pair and sets joint.outline; false if there are none.
bool lay_joint(const Model<3>& model, const State<3>& state, const Work<3>& work, const NearPair& pair,
               FaceJoint& joint) {
  const double size = 2 * std::min(model.body_radius[static_cast<std::size_t>(joint.body_a)],
                                   model.body_radius[static_cast<std::size_t>(joint.body_b)]);
  FaceOverlap3 faces;
  if (!meeting_faces(work.solids.placed[static_cast<std::size_t>(pair.piece_a)],
                     work.solids.placed[static_cast<std::size_t>(pair.piece_b)], nearly_flat * size, least_width * size,
                     faces))
    return false;
  if (!model.is_fitted(pair.piece_a)) faces.face_a = -1;
  if (!model.is_fitted(pair.piece_b)) faces.face_b = -1;
  const auto motion = [&](int piece, int face) { return motion_of(model, state, model.carrier_of(piece, face)); };
  const JointPlan plan = plan_joint(faces, motion(pair.piece_a, faces.face_a), motion(pair.piece_b, faces.face_b));
  take_plan(plan, model, pair, joint);
  return true;
}

/// Sets the middle and the ends of the longer axis of the shared polygon, in the world.
void set_place(const Model<3>& model, const State<3>& state, FaceJoint& joint) {
  const SeatNow seat(joint.in_a, motion_of(model, state, joint.contact_frame[0]));
  joint.place = seat.place;
  Vec2 low = Vec2::Constant(unbounded), high = -low;
  for (const Vec2& p : joint.outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const int longer = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
  for (const int e : {0, 1}) {
    Vec2 p = Vec2::Zero();
    p[longer] = (e == 0 ? low : high)[longer];
    joint.end[static_cast<std::size_t>(e)] = seat.at(p);
  }
}

}  // namespace

std::vector<FaceJoint> find_joints(const Model<3>& model) {
  return find_joints(model, start_state(model), 0);
}

/// Bonded faces use the joint of their mortar; dry joints use the faces that lie flat on each other.
std::vector<FaceJoint> find_joints(const Model<3>& model, const State<3>& state, int first_body) {
  Work<3> work;
  update_kinematics(model, state, work);
  update_contact_pairs(model, state, work);
  std::vector<FaceJoint> joints;
  for (const NearPair& pair : work.pairs) {
    if (pair.replaced) continue;
    const bool round = model.piece_solid[static_cast<std::size_t>(pair.piece_a)].is_sphere() ||
                       model.piece_solid[static_cast<std::size_t>(pair.piece_b)].is_sphere();
    if (round) continue;
    FaceJoint joint;
    joint.contact = contact_key(pair.piece_a, pair.piece_b);
    joint.body_a = model.piece_body[pair.piece_a], joint.body_b = model.piece_body[pair.piece_b];
    if (std::max(joint.body_a, joint.body_b) < first_body) continue;
    const int row = state.contacts.find(joint.contact);
    const JointMemory* memory = row < 0 ? nullptr : state.contacts.joint_at(static_cast<std::size_t>(row));
    if (memory != nullptr && !memory->empty()) {
      take_plan(*memory->plan, model, pair, joint);
      joint.bonded = memory->bonds != 0;
    } else if (!lay_joint(model, state, work, pair, joint)) {
      continue;
    }
    set_place(model, state, joint);
    joints.push_back(std::move(joint));
  }
  return joints;
}

JointDisplacement joint_displacement(const FaceJoint& joint, const Model<3>& model, const State<3>& state,
                                     const Work<3>& /*work*/) {
  const SeatNow a(joint.in_a, motion_of(model, state, joint.contact_frame[0])),
      b(joint.in_b, motion_of(model, state, joint.contact_frame[1]));
  const Vec3 normal = a.axes.z(), between = b.place - a.place;
  JointDisplacement change{-unbounded, (between - normal.dot(between) * normal).norm()};
  for (const Vec2& p : joint.outline) change.opening = std::max(change.opening, normal.dot(b.at(p) - a.at(p)));
  return change;
}

double joint_damage(const FaceJoint& joint, const State<3>& state) {
  if (!joint.bonded) return 0;
  const int row = state.contacts.find(joint.contact);
  const JointMemory* memory = row < 0 ? nullptr : state.contacts.joint_at(static_cast<std::size_t>(row));
  if (memory == nullptr || memory->empty()) return 1;
  if (memory->sound) return 0;
  double lost = 0, all = 0;
  for (std::size_t k = 0; k < memory->plan->patch.size(); ++k) {
    const double area = memory->plan->patch[k].area;
    lost += area * damage_of(*memory, k), all += area;
  }
  return lost / all;
}

Vec3 joint_middle(const FaceJoint& joint, const Model<3>& model, const State<3>& state) {
  return SeatNow(joint.in_a, motion_of(model, state, joint.contact_frame[0])).place;
}

}  // namespace trilith
