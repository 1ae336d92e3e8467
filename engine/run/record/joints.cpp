#include "run/record/joints.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "assembly/evaluate.hpp"
#include "assembly/start.hpp"
#include "broad_phase/pairs.hpp"

namespace trilith {
namespace {

constexpr double flat_share =
    1e-3;  // largest gap at the start between faces that count as touching, share of the shorter face
constexpr double least_share = 1e-6;  // length of a joint, share of the shorter face

Vec2 at(const Work<2>& work, int skin) {
  return {work.skin[skin].x, work.skin[skin].y};
}

Vec2 between(const Work<2>& work, int from, int to, double share) {
  return (1 - share) * at(work, from) + share * at(work, to);
}

/// Axes of the face of body a: along it from its first end, and outward.
struct FaceAxes {
  Vec2 origin, along, normal;
  double length;
  FaceAxes(const Work<2>& work, int from, int to)
      : origin(at(work, from)),
        along((at(work, to) - origin).normalized()),
        normal(along.y(), -along.x()),
        length((at(work, to) - origin).norm()) {}
};

/// Sets the ends of the shared length of two faces. Returns false without one.
///
///       a0 -----------------> a1   Both ends are stored as shares of either face.
///       lo |.........| hi          They move with the bodies,
///  b1 <------------------ b0       and with their gap and slip at the start.
bool lay_joint(const Work<2>& work, Joint& joint) {
  const FaceAxes face(work, joint.a0, joint.a1);
  const Vec2 b0 = at(work, joint.b0), b1 = at(work, joint.b1);
  const double s0 = face.along.dot(b0 - face.origin), s1 = face.along.dot(b1 - face.origin);
  const double lo = std::max(0.0, std::min(s0, s1)), hi = std::min(face.length, std::max(s0, s1));
  const double size = std::min(face.length, std::abs(s1 - s0));
  if (!(hi - lo > least_share * size)) return false;
  const std::array<double, 2> ends{lo, hi};
  for (std::size_t e = 0; e < 2; ++e) {
    JointEnd& end = joint.end[e];
    end.share_a = ends[e] / face.length;
    end.share_b = (ends[e] - s0) / (s1 - s0);
    joint.place[e] = between(work, joint.a0, joint.a1, end.share_a);
    const Vec2 apart = between(work, joint.b0, joint.b1, end.share_b) - joint.place[e];
    end.gap = face.normal.dot(apart);
    end.slip = face.along.dot(apart);
    if (joint.bonds == 0 && std::abs(end.gap) > flat_share * size) return false;
  }
  return true;
}

std::uint32_t bonds_of(const State<2>& state, ContactKey key) {
  const int row = state.contacts.find(key);
  return row < 0 ? 0 : state.contacts.memory[row].bonds;
}

}  // namespace

std::vector<Joint> find_joints(const Model<2>& model) {
  return find_joints(model, start_state(model), 0);
}

std::vector<Joint> find_joints(const Model<2>& model, const State<2>& state, int first_body) {
  Work<2> work;
  update_kinematics(model, state, work);
  update_contact_pairs(model, state, work);
  std::vector<Joint> joints;
  for (NearPair pair : work.pairs) {
    if (pair.replaced) continue;
    Joint joint;
    joint.contact = contact_key(pair.piece_a, pair.piece_b);
    joint.bonds = bonds_of(state, joint.contact);
    // With the search reach of bonds, so that faces without compression count; their gap is tested below.
    if (!choose_face_pair(model, work, true, pair)) continue;
    joint.body_a = model.piece_body[pair.piece_a], joint.body_b = model.piece_body[pair.piece_b];
    if (std::max(joint.body_a, joint.body_b) < first_body) continue;
    joint.a0 = pair.a0, joint.a1 = pair.a1, joint.b0 = pair.b0, joint.b1 = pair.b1;
    if (lay_joint(work, joint)) joints.push_back(joint);
  }
  return joints;
}

/// Opening: larger value of both ends. Slip: mean of both ends.
JointDisplacement joint_displacement(const Joint& joint, const Work<2>& work) {
  const FaceAxes face(work, joint.a0, joint.a1);
  JointDisplacement motion;
  motion.opening = -unbounded;
  for (const JointEnd& end : joint.end) {
    const Vec2 apart = between(work, joint.b0, joint.b1, end.share_b) - between(work, joint.a0, joint.a1, end.share_a);
    motion.opening = std::max(motion.opening, face.normal.dot(apart) - end.gap);
    motion.slip += 0.5 * (face.along.dot(apart) - end.slip);
  }
  return motion;
}

/// Mean over the halves that were bonded at the start; 1 for a lost half, or for a contact that no longer exists.
double joint_damage(const Joint& joint, const State<2>& state) {
  if (joint.bonds == 0) return 0;
  const ContactHistory& contacts = state.contacts;
  const int row = contacts.find(joint.contact);
  if (row < 0) return 1;
  return with_kernel_type(contacts.law_row[row].place, [&]<class K>() {
    const LawMemory<K> own = law_memory<K>(contacts.law_numbers(row));
    double lost = 0;
    for (const int half : {0, 1})
      if ((joint.bonds >> half & 1U) != 0) lost += contacts.memory[row].bonded(half) ? K::damage(own, half) : 1;
    return lost / std::popcount(joint.bonds);
  });
}

std::array<Vec2, 2> joint_place(const Joint& joint, const Work<2>& work) {
  return {between(work, joint.a0, joint.a1, joint.end[0].share_a),
          between(work, joint.a0, joint.a1, joint.end[1].share_a)};
}

}  // namespace trilith
