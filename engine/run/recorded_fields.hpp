// What a recording adds to each frame beside motion and contacts: what became of the joints, stress in the bodies.
#pragma once

#include <vector>

#include "results/results.hpp"
#include "run/body_forces.hpp"
#include "run/joints.hpp"
#include "run/stage.hpp"

namespace trilith {

class RecordedFields {
 public:
  /// Finds the joints of the model.
  explicit RecordedFields(const Model<2>& model);

  /// Adds the joints of what came to the model from body `first_body` on, where that stands by `state`.
  void extend(const Model<2>& model, const State<2>& state, int first_body);
  /// Adds joints and fields to the header.
  void describe(const Model<2>& model, results::Header& header) const;
  /// The fields' numbers at this instant, in the order of the header; valid until the next call.
  const std::vector<std::vector<double>>& take(const Instant<2>& now, std::span<const TouchingContact> touching);

 private:
  std::vector<Joint> joints_;
  std::vector<JointDisplacement> motions_;  // of the joints, for all fields of an instant
  std::size_t bodies_;
  std::vector<std::vector<double>> values_;
};

}  // namespace trilith
