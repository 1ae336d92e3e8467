// What a results file says of a model before its first row.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/builder/builder.hpp"
#include "results/file/results.hpp"
#include "run/stage.hpp"

namespace trilith {

/// A quantity followed over time. `sample` must give a finite number and write nothing.
template <int D>
struct RecordedHistory {
  std::string name, unit, description;
  std::function<double(const Instant<D>&)> sample;
};

/// What the caller knows and the model does not.
template <int D>
struct RecordingOptions {
  /// What is left empty of compiler, platform, commit and start time is filled in; motions come from the model's
  /// drives where none are given.
  results::Provenance provenance;
  std::vector<Material> materials;  ///< for the table of laws
  std::vector<RecordedHistory<D>> histories;
  bool with_velocity = false;
  bool with_joints = false;  ///< joints, what became of them, and the mean stress of bodies, in every frame
  int flush_frames = 50;     ///< bring rows to the disk with the first frame, after so many more ...
  double flush_seconds = 1;  ///< ... or so many seconds of wall clock, whichever comes first
  bool sync = true;          ///< against loss of power too
};

/// Header of a results file of `model` that starts at `state`. Energy terms are those of model/energy.hpp.
template <int D>
results::Header recording_header(const Model<D>& model, const State<D>& state, const RecordingOptions<D>& options);

}  // namespace trilith
