#include "edit/split_contacts_space.hpp"

#include <algorithm>
#include <utility>

#include "assembly/contact/solid_joints.hpp"
#include "contact/joint/joint_motion.hpp"
#include "contact/space/solid_faces.hpp"
#include "geometry/plane/outline_moments.hpp"
#include "law/contact/list.hpp"
#include "readings/section_forces_space.hpp"

namespace trilith {
namespace {

/// Contacts with less than this share of their area on a part are left out.
constexpr double least_area_part = 1e-9;

/// The area of a joint in its present position.
TouchedArea area_of(const Model<3>& model, const State<3>& state, const NearPair& pair, const JointMemory& joint) {
  const JointMotion motion(*joint.plan, body_motion(model, state, pair.piece_a, joint.plan->face_a),
                           body_motion(model, state, pair.piece_b, joint.plan->face_b));
  return {motion.origin, motion.x, motion.y, joint.plan->outline, joint.plan->radius};
}

/// The area where two faces overlap that lie on each other; none for other contacts.
std::optional<TouchedArea> flat_area(const Model<3>& model, const Work<3>& work, std::size_t row) {
  const NearPair& pair = work.pairs[row];
  const ConvexSolid &a = model.piece_solid[static_cast<std::size_t>(pair.piece_a)],
                    &b = model.piece_solid[static_cast<std::size_t>(pair.piece_b)];
  if (pair.replaced || a.is_sphere() || b.is_sphere()) return std::nullopt;
  FaceOverlap3 faces;
  if (!is_linear(model.laws[static_cast<std::size_t>(pair.law)]) ||
      !flat_faces(work.solids.placed[static_cast<std::size_t>(pair.piece_a)],
                  work.solids.placed[static_cast<std::size_t>(pair.piece_b)], faces))
    return std::nullopt;
  const MeanPlane& plane = faces.plane;
  const std::span<const Vec2> shared(faces.shared.corner.data(), static_cast<std::size_t>(faces.shared.count));
  std::vector<Vec2> closed = part_below(shared, -plane.overlap, Vec2(-plane.slope));
  if (closed.size() < 3 || !(OutlineMoments(closed).area > 0)) return std::nullopt;
  return TouchedArea{plane.origin, plane.x, plane.y, std::move(closed), work.solids.areas[row].radius};
}

/// The record with its two pieces in the other order. `between`: from the origin of a to the origin of b [m].
SolidRecord turned(SolidRecord record, const Vec3& between) {
  std::swap(record.piece_a, record.piece_b);
  SolidMemory& m = record.memory;
  m.damping_moment = -(m.damping_moment - cross(between, m.damping));
  for (Vec3* v : {&m.shear.elastic, &m.shear.total, &m.normal, &m.damping}) *v = -*v;
  if (!record.joint.empty()) record.joint = turned_joint(record.joint);
  return record;
}

}  // namespace

SolidRecord ordered(const Model<3>& model, const State<3>& state, SolidRecord record) {
  if (record.piece_a < record.piece_b) return record;
  const auto origin_of = [&](int piece) { return motion_of(model, state, model.carrier_of(piece)).place; };
  const Vec3 between = origin_of(record.piece_b) - origin_of(record.piece_a);
  return turned(std::move(record), between);
}

namespace {

/// Divides the contacts of one body among its parts.
class SolidDivider {
 public:
  SolidDivider(const Model<3>& model, const State<3>& state, const SplitBody& split, const Vec3& on_plane,
               const Vec3& normal)
      : model_(model), state_(state), split_(split), on_plane_(on_plane), normal_(normal) {}

  void divide(const SolidRecord& record, std::vector<SolidRecord>& out) const {
    const bool first = body_of(record.piece_a) == split_.body;
    if (!first && body_of(record.piece_b) != split_.body) {
      out.push_back(record);
    } else if (record.area) {
      give_area(record, first, split_.behind, 1, out);
      give_area(record, first, split_.ahead, -1, out);
    } else if (record.place) {
      const bool behind = normal_.dot(*record.place - on_plane_) <= 0;
      give(record, first, behind ? split_.behind : split_.ahead, out);
    }  // others are apart, and new pieces do not have their memory
  }

 private:
  [[nodiscard]] int body_of(int piece) const { return model_.piece_body[static_cast<std::size_t>(piece)]; }
  [[nodiscard]] BodyMotion motion_of_body(int body) const {
    return motion_of(model_, state_, model_.bodies[static_cast<std::size_t>(body)].first_node);
  }
  [[nodiscard]] Vec3 origin_of(int piece) const { return motion_of(model_, state_, model_.carrier_of(piece)).place; }

  /// Moves a contact to a part of the body, and puts its pieces in their order.
  void give(SolidRecord record, bool first, int part, std::vector<SolidRecord>& out) const {
    const BodyMotion from = motion_of_body(split_.body), to = motion_of_body(part);
    if (first) record.memory.damping_moment += cross(Vec3(from.place - to.place), record.memory.damping);
    if (!record.joint.empty()) move_seat(record.joint, first, from, to);
    (first ? record.piece_a : record.piece_b) = model_.bodies[static_cast<std::size_t>(part)].first_piece;
    out.push_back(ordered(model_, state_, std::move(record)));
  }

  /// The part of a contact of faces on one side of the plane. `sign`: 1 behind, -1 ahead.
  void give_area(const SolidRecord& record, bool first, int part, double sign, std::vector<SolidRecord>& out) const {
    const TouchedArea& whole = *record.area;
    const Vec3 normal = sign * normal_;
    SolidRecord given = record;
    given.area->corners =
        part_below(whole.corners, normal.dot(whole.origin - on_plane_), Vec2(normal.dot(whole.x), normal.dot(whole.y)));
    if (given.area->corners.size() < 3) return;
    const OutlineMoments all(whole.corners), own(given.area->corners);
    if (!(own.area > least_area_part * all.area)) return;
    given.area->radius = std::sqrt((own.xx + own.yy) / own.area);
    if (own.area < (1 - least_area_part) * all.area) {
      take_part(record, own, all.area, normal, given);
      if (!record.joint.empty()) given.joint = part_of_joint(record.joint, given.area->corners);
    }
    give(std::move(given), first, part, out);
  }

  /// Shear and damping of a part. The damping moment is about the origin of the first body.
  void take_part(const SolidRecord& record, const OutlineMoments& own, double all, const Vec3& normal,
                 SolidRecord& given) const {
    const TouchedArea& whole = *record.area;
    const SolidMemory& m = record.memory;
    const Vec3 n = cross(whole.x, whole.y);
    const OutlineMoments of(whole.corners);
    const Vec3 middle = whole.origin + of.middle.x() * whole.x + of.middle.y() * whole.y;
    const Vec3 centre = whole.origin + own.middle.x() * whole.x + own.middle.y() * whole.y;
    const auto part_of_slider = [&](const Vec3& force) {
      const Vec3 shear = force - n.dot(force) * n, couple = whole.radius * n.dot(force) * n;
      const SpreadForce spread(whole.origin, whole.x, whole.y, whole.corners, shear,
                               couple + cross(Vec3(middle - whole.origin), shear));
      const SpreadPart part = spread.behind(on_plane_, normal);
      const Vec3 about = part.moment - cross(Vec3(centre - spread.centre), part.force);
      return Vec3(part.force - n.dot(part.force) * n + n.dot(about) / given.area->radius * n);
    };
    given.memory.shear = {part_of_slider(m.shear.elastic), part_of_slider(m.shear.total),
                          own.area / all * m.shear.area};
    const Vec3 origin = origin_of(record.piece_a);
    const SpreadForce damping(whole.origin, whole.x, whole.y, whole.corners, m.damping,
                              m.damping_moment - cross(Vec3(whole.origin - origin), m.damping));
    const SpreadPart part = damping.behind(on_plane_, normal);
    given.memory.damping = part.force;
    given.memory.damping_moment = part.moment + cross(Vec3(damping.centre - origin), part.force);
  }

  const Model<3>& model_;
  const State<3>& state_;
  SplitBody split_;
  Vec3 on_plane_, normal_;
};

/// Stiffness of a law whose bonds soften gradually; 0 for others.
double softening_stiffness(const ContactLaw& law) {
  return with_kernel({law}, []<class K>(const K& kernel) {
    if constexpr (K::bonds) return K::softens ? kernel.kn : 0.0;
    return 0.0;
  });
}

/// Seats of a joint across a section: apart by `opening`, and turned against each other by its slopes.
void set_seats(const BodyMotion& a, const BodyMotion& b, const Vec3& centre, const Eigen::Matrix3d& axes,
               const SectionStress& opening, JointPlan& plan) {
  const UnitQuaternion middle = rotation_of(axes);
  const Vec3 apart = 0.5 * opening.mean * axes.col(2);
  const Vec3 turned = 0.5 * Vec3(opening.slope.y() * axes.col(0) - opening.slope.x() * axes.col(1));
  const auto seat = [&](const BodyMotion& of, double sign) {
    const UnitQuaternion back = inverse(of.rotation);
    return JointSeat{Turn3(back).apply(Vec3(centre + sign * apart - of.place)),
                     renormalised(back * (rotation_by(Vec3(sign * turned)) * middle))};
  };
  plan.in_a = seat(a, -1), plan.in_b = seat(b, 1);
}

}  // namespace

std::vector<SolidRecord> solid_records(const Model<3>& model, const State<3>& state, const Work<3>& work) {
  const SolidHistory& contacts = contacts_before(state, work);
  std::vector<SolidRecord> records;
  for (std::size_t row = 0; row < work.pairs.size(); ++row) {
    if (contacts.memory[row].empty()) continue;
    const NearPair& pair = work.pairs[row];
    SolidRecord r{pair.piece_a, pair.piece_b, contacts.memory[row]};
    if (const JointMemory* joint = contacts.joint_at(row); joint != nullptr && !joint->empty()) {
      r.joint = *joint;
      r.area = area_of(model, state, pair, *joint);
    } else if (const GeneralContact<3>* touching = work.general_touching.find(static_cast<int>(row))) {
      r.area = flat_area(model, work, row);
      r.place = touching->centre;
    }
    records.push_back(std::move(r));
  }
  return records;
}

std::vector<SolidRecord> handed_over(const Model<3>& model, const State<3>& state,
                                     const std::vector<SolidRecord>& records, const SplitBody& split,
                                     const Vec3& on_plane, const Vec3& normal) {
  const SolidDivider divider(model, state, split, on_plane, normal);
  std::vector<SolidRecord> out;
  for (const SolidRecord& record : records) divider.divide(record, out);
  return out;
}

SolidRecord section_joint(const Model<3>& model, const State<3>& state, const CrackFaces& faces,
                          const CrackSection<3>& section, const Vec3& centre, const Eigen::Matrix3d& axes,
                          const SpaceForces& forces, double kn) {
  const SectionStress stress = section_stress(section, forces);
  const SectionStress opening{stress.mean / kn, stress.slope / kn};
  const auto plan = std::make_shared<JointPlan>();
  set_seats(body_motion(model, state, faces.piece_a, faces.face_a),
            body_motion(model, state, faces.piece_b, faces.face_b), centre, axes, opening, *plan);
  plan->face_a = faces.face_a, plan->face_b = faces.face_b;
  plan->outline = section.corners;
  divide_joint(*plan);
  SolidRecord r;
  r.piece_a = faces.piece_a, r.piece_b = faces.piece_b;
  r.joint.bonds = (1U << plan->patches) - 1U, r.joint.sound = true;
  r.joint.moved = {-opening.mean, Vec2(-opening.slope)};
  r.joint.elastic = r.joint.total = Vec3(forces.shear.x(), forces.shear.y(), forces.torsion);
  r.memory.normal = axes.col(2);
  r.memory.shear.elastic = r.memory.shear.total =
      axes * Vec3(forces.shear.x(), forces.shear.y(), forces.torsion / plan->radius);
  r.memory.shear.area = section.area;
  r.memory.state = contact_touching | contact_general;
  leave_out_patches(*plan);
  r.joint.plan = plan;
  return r;
}

std::optional<SolidRecord> crack_contact(const Model<3>& model, const State<3>& state, const SplitBody& split,
                                         const CrackingBody<3>& row, const Crack<3>& crack) {
  const double kn = softening_stiffness(model.laws[static_cast<std::size_t>(row.law)]);
  if (!(kn > 0)) return std::nullopt;
  const CrackSection<3>& section = row.sections[static_cast<std::size_t>(crack.section)];
  const auto piece = [&](int body) { return model.bodies[static_cast<std::size_t>(body)].first_piece; };
  const BodyMotion body = motion_of(model, state, model.bodies[static_cast<std::size_t>(split.body)].first_node);
  const Turn3 turn(body.rotation);
  Eigen::Matrix3d axes;
  axes.col(0) = turn.apply(section.x), axes.col(1) = turn.apply(section.y), axes.col(2) = turn.apply(section.normal);
  return section_joint(model, state, {piece(split.behind), -1, piece(split.ahead), -1}, section,
                       body.place + turn.apply(section.centre), axes, crack.forces, kn);
}

void put_contacts(State<3>& state, std::vector<SolidRecord> records) {
  const auto key_of = [](const SolidRecord& r) { return contact_key(r.piece_a, r.piece_b); };
  std::stable_sort(records.begin(), records.end(),
                   [&](const SolidRecord& a, const SolidRecord& b) { return key_of(a) < key_of(b); });
  SolidHistory rows;
  for (const SolidRecord& r : records) {
    rows.key.push_back(key_of(r));
    rows.memory.push_back(r.memory);
  }
  for (std::size_t row = 0; row < records.size(); ++row)
    if (!records[row].joint.empty()) rows.add_joint(row) = std::move(records[row].joint);
  state.contacts = std::move(rows);
}

}  // namespace trilith
