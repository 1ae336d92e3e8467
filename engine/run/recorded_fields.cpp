#include "run/recorded_fields.hpp"

#include "run/storeys.hpp"

namespace trilith {
namespace {

enum FieldPlace : std::size_t { opening, slip, damage, stress };

results::JointRow row_of(const Model<2>& model, const Joint& joint) {
  results::JointRow row;
  row.body_a = joint.body_a;
  row.body_b = joint.body_b;
  row.storey = storey_of(model, joint);
  row.bonded = joint.bonds != 0 ? 1 : 0;
  for (const int k : {0, 1}) row.end_0[k] = joint.place[0][k], row.end_1[k] = joint.place[1][k];
  return row;
}

}  // namespace

int storey_of(const Model<2>& model, const Joint& joint) {
  const double a = model.start_position[model.bodies[joint.body_a].first_node].y(),
               b = model.start_position[model.bodies[joint.body_b].first_node].y();
  const int upper = storey_of(model, a > b ? joint.body_a : joint.body_b);
  return upper > 0 ? upper : storey_of(model, a > b ? joint.body_b : joint.body_a);
}

RecordedFields::RecordedFields(const Model<2>& model)
    : joints_(find_joints(model)), bodies_(model.bodies.size()), values_(joints_.empty() ? 0 : 4) {}

void RecordedFields::extend(const Model<2>& model, const State<2>& state, int first_body) {
  for (Joint& joint : find_joints(model, state, first_body)) joints_.push_back(joint);
  bodies_ = model.bodies.size();
  if (!joints_.empty()) values_.resize(4);
}

void RecordedFields::describe(const Model<2>& model, results::Header& header) const {
  if (joints_.empty()) return;
  for (const Joint& joint : joints_) header.joints.push_back(row_of(model, joint));
  const std::size_t n = joints_.size();
  header.fields = {
      {"joint_opening", "m", "opening of each joint since the start, at its farther end", n, 1},
      {"joint_slip", "m", "slip of each joint since the start, at its middle", n, 1},
      {"joint_damage", "1", "part of each joint's bond that is lost", n, 1},
      {"body_stress", "Pa", "mean stress of each body from contacts and bearings: xx, yy, xy; tension positive",
       bodies_, 3},
  };
}

const std::vector<std::vector<double>>& RecordedFields::take(const Instant<2>& now,
                                                             std::span<const TouchingContact> touching) {
  if (joints_.empty()) return values_;
  for (std::vector<double>& v : values_) v.clear();
  for (const Joint& joint : joints_) {
    const JointMotion motion = joint_motion(joint, now.work);
    values_[opening].push_back(motion.opening);
    values_[slip].push_back(motion.slip);
    values_[damage].push_back(joint_damage(joint, now.state));
  }
  for (const MeanStress& s : mean_stress(now.model, now.state, now.work, touching))
    values_[stress].insert(values_[stress].end(), {s.xx, s.yy, s.xy});
  return values_;
}

}  // namespace trilith
