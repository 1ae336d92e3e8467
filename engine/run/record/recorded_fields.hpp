// What a recording adds to each frame beside motion and contacts: what became of the joints, stress in the bodies.
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
  /// Finds the joints of the model, where they are asked for.
  RecordedFields(const Model<D>& model, bool with_joints);

  /// Adds the joints of what came to the model from body `first_body` on, where that stands by `state`.
  void extend(const Model<D>& model, const State<D>& state, int first_body);
  /// Adds joints and fields to a header that has its bodies.
  void describe(const Model<D>& model, results::Header& header) const;
  /// The fields' numbers at this instant, in the order of the header; valid until the next call. `touching`: of the
  /// plane, else none.
  const std::vector<std::vector<double>>& take(const Instant<D>& now, std::span<const TouchingContact> touching);

 private:
  bool with_joints_;
  std::vector<JointOf<D>> joints_;
  std::vector<JointDisplacement> displacements_;  // of the joints, for all fields of an instant
  std::size_t bodies_;
  bool with_stress_;  // in space: bodies that deform
  std::vector<std::vector<double>> values_;
};

}  // namespace trilith
