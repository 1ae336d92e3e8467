// Header of a results file: description of the model.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/builder/builder.hpp"
#include "results/file/results.hpp"
#include "run/stage.hpp"

namespace trilith {

/// A history: quantity recorded over time. `sample` must return a finite number and modify nothing.
template <int D>
struct RecordedHistory {
  std::string name, unit, description;
  std::function<double(const Instant<D>&)> sample;
};

/// Data of a recording that the model does not contain.
template <int D>
struct RecordingOptions {
  /// Empty fields for compiler, platform, commit and start time are filled in. Without given motions they are taken
  /// from the drives of the model.
  results::Provenance provenance;
  std::vector<Material> materials;  ///< for the table of laws
  std::vector<RecordedHistory<D>> histories;
  bool with_velocity = false;
  bool with_joints = false;  ///< record joints, their opening, slip and damage, and the mean stress of bodies in every
                             ///< frame
  int flush_frames = 50;     ///< flush rows to disk after the first frame and then after this number of frames ...
  double flush_seconds = 1;  ///< ... or after this wall-clock time [s], whichever comes first
  bool sync = true;          ///< synchronise the disk, against loss of power
};

/// Header of a results file of `model` that starts at `state`. The energy terms are listed in model/energy.hpp.
template <int D>
results::Header recording_header(const Model<D>& model, const State<D>& state, const RecordingOptions<D>& options);

}  // namespace trilith
