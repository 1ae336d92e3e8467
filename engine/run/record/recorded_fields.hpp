// Fields that a recording adds to each frame, in addition to motion and contacts: opening, slip and damage of joints,
// stress of bodies.
#pragma once

#include <vector>

#include "results/file/results.hpp"
#include "run/record/body_forces.hpp"
#include "run/record/face_joints.hpp"
#include "run/stage.hpp"

namespace trilith {

template <int D>
class RecordedFields {
 public:
  /// Finds the joints of the model if `with_joints` is set.
  RecordedFields(const Model<D>& model, bool with_joints);

  /// Adds the joints of the bodies from `first_body` on, which were added to the model; `state` is their initial
  /// position.
  void extend(const Model<D>& model, const State<D>& state, int first_body);
  /// Adds joints and fields to a header that contains the bodies.
  void describe(const Model<D>& model, results::Header& header) const;
  /// Values of the fields at this instant, in the order of the header; valid until the next call. `touching`: contacts
  /// of a plane model, otherwise empty.
  const std::vector<std::vector<double>>& take(const Instant<D>& now, std::span<const TouchingContact> touching);

 private:
  bool with_joints_;
  std::vector<JointOf<D>> joints_;
  std::vector<JointDisplacement> displacements_;  // of the joints, shared by all fields of an instant
  std::size_t bodies_;
  bool with_stress_;  // in space: the model has deformable bodies
  std::vector<std::vector<double>> values_;
};

}  // namespace trilith
