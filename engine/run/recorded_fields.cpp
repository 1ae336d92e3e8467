#include "run/recorded_fields.hpp"

#include "run/recorded_field_list.hpp"
#include "run/storeys.hpp"

namespace trilith {
namespace {

results::JointRow row_of(const Model<2>& model, const Joint& joint) {
  results::JointRow row;
  row.body_a = joint.body_a;
  row.body_b = joint.body_b;
  row.storey = storey_between(model, joint.body_a, joint.body_b);
  row.bonded = joint.bonds != 0 ? 1 : 0;
  for (const int k : {0, 1}) row.end_0[k] = joint.place[0][k], row.end_1[k] = joint.place[1][k];
  return row;
}

}  // namespace

RecordedFields::RecordedFields(const Model<2>& model)
    : joints_(find_joints(model)),
      bodies_(model.bodies.size()),
      values_(joints_.empty() ? 0 : RecordedFieldTypes::size) {}

void RecordedFields::extend(const Model<2>& model, const State<2>& state, int first_body) {
  for (Joint& joint : find_joints(model, state, first_body)) joints_.push_back(joint);
  bodies_ = model.bodies.size();
  if (!joints_.empty()) values_.resize(RecordedFieldTypes::size);
}

void RecordedFields::describe(const Model<2>& model, results::Header& header) const {
  if (joints_.empty()) return;
  for (const Joint& joint : joints_) header.joints.push_back(row_of(model, joint));
  header.fields.clear();
  RecordedFieldTypes::for_each([&]<class F>() {
    header.fields.push_back({std::string(F::name), std::string(F::unit), std::string(F::sentence),
                             F::rows == RowsOf::joints ? joints_.size() : bodies_, F::width});
  });
}

const std::vector<std::vector<double>>& RecordedFields::take(const Instant<2>& now,
                                                             std::span<const TouchingContact> touching) {
  if (joints_.empty()) return values_;
  motions_.clear();
  for (const Joint& joint : joints_) motions_.push_back(joint_displacement(joint, now.work));
  auto values = values_.begin();
  RecordedFieldTypes::for_each([&]<class F>() {
    values->clear();
    F::take({now, joints_, touching, motions_}, *values++);
  });
  return values_;
}

}  // namespace trilith
