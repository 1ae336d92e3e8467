#include "run/record/recorded_fields.hpp"

#include "model/contact/contact_frame.hpp"
#include "run/record/field_values.hpp"
#include "run/record/member_fields.hpp"
#include "run/record/recorded_field_list.hpp"
#include "run/record/space_stress_field.hpp"
#include "run/record/storeys.hpp"

namespace trilith {
namespace {

void set_place(const Joint& joint, results::JointRow& row) {
  for (const int k : {0, 1}) row.end_0[k] = joint.place[0][k], row.end_1[k] = joint.place[1][k];
}
void set_place(const FaceJoint& joint, results::JointRow& row) {
  for (const int k : {0, 1, 2}) row.end_0[k] = joint.end[0][k], row.end_1[k] = joint.end[1][k];
  row.area = joint.area;
}

template <int D>
results::JointRow row_of(const Model<D>& model, const JointOf<D>& joint) {
  results::JointRow row;
  row.body_a = joint.body_a;
  row.body_b = joint.body_b;
  row.storey = storey_between(model, joint.body_a, joint.body_b);
  row.bonded = is_bonded(joint) ? 1 : 0;
  set_place(joint, row);
  return row;
}

}  // namespace

template <int D>
RecordedFields<D>::RecordedFields(const Model<D>& model, bool with_joints)
    : with_joints_(with_joints), bodies_(model.bodies.size()), with_stress_(!model.space_elements.empty()) {
  if (with_joints) joints_ = find_joints(model);
}

template <int D>
void RecordedFields<D>::extend(const Model<D>& model, const State<D>& state, int first_body) {
  if (with_joints_)
    for (JointOf<D>& joint : find_joints(model, state, first_body)) joints_.push_back(std::move(joint));
  bodies_ = model.bodies.size();
}

template <int D>
void RecordedFields<D>::describe(const Model<D>& model, results::Header& header) const {
  if (with_stress_) describe_space_stress(header);
  describe_members(model, header);
  describe_field_values(model, header);
  for (const JointOf<D>& joint : joints_) header.joints.push_back(row_of<D>(model, joint));
  if (joints_.empty()) return;
  RecordedFieldsOf<D>::for_each([&]<class F>() {
    header.fields.push_back({std::string(F::name), std::string(F::unit), std::string(F::sentence),
                             F::rows == RowsOf::joints ? joints_.size() : bodies_, F::width});
  });
}

template <int D>
const std::vector<std::vector<double>>& RecordedFields<D>::take(const Instant<D>& now,
                                                                std::span<const TouchingContact> touching) {
  values_.clear();
  if constexpr (D == 3)
    if (with_stress_) take_space_stress(now, values_);
  take_members(now, values_);
  take_field_values(now, values_);
  if (joints_.empty()) return values_;
  displacements_.clear();
  for (const JointOf<D>& joint : joints_)
    displacements_.push_back(joint_displacement(joint, now.model, now.state, now.work));
  RecordedFieldsOf<D>::for_each([&]<class F>() {
    values_.emplace_back();
    F::take(FieldSource<D>{now, joints_, touching, displacements_}, values_.back());
  });
  return values_;
}

template class RecordedFields<2>;
template class RecordedFields<3>;

}  // namespace trilith
