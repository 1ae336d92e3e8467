// Data of a model from which another process can continue its run, and the progress of a restoration. No Lua.
//
// The script runs again from its first line. A completed stage is not computed: the model returns to the end of that
// stage, and the script continues. Within the interrupted stage, the model returns to the last checkpoint. Changes by
// handlers are repeated: each call that changed something is stored with the state that it saw.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.hpp"
#include "bindings/restart/restart_files.hpp"
#include "model/event/event.hpp"

namespace trilith::script {

/// A call of a handler, timer, story or history function that changed something.
struct HandlerCall {
  int function = 0;  ///< number in stage_run.cpp
  bool has_event = false;
  Event event;
  std::int64_t index = 0;  ///< of the timer or history
  std::string kept;        ///< tables of m:keep before the call, as bytes
};

/// Compared before a stage is taken as completed: its options, and the model and state at its start.
struct StageMark {
  std::string asked;
  std::uint64_t structure = 0, conditions = 0, state = 0;
};

/// Head of a checkpoint, or of the end of a stage.
struct MomentHead {
  std::uint64_t sequence = 0;
  int stage = 0;    ///< from 1
  int changes = 0;  ///< number of stored changes before it, in all stages
  bool ended = false;
  double time = 0;  ///< [s]
  StageMark mark;
};

template <class File>
void each_field(File& file, StageMark& m) {
  file.item(m.asked), file.item(m.structure), file.item(m.conditions), file.item(m.state);
}
template <class File>
void each_field(File& file, MomentHead& h) {
  file.item(h.sequence), file.item(h.stage), file.item(h.changes), file.item(h.ended), file.item(h.time);
  file.item(h.mark);
}

/// Largest size of the changes by handlers, and of the ends of stages [bytes]; beyond it checkpoints end.
inline constexpr std::size_t most_of_changes = std::size_t{512} << 20;

struct RestartBook {
  RestartFiles files;
  double every = 0;             ///< wall clock between checkpoints [s]; 0: none
  double stored_at = 0;         ///< wall clock of the last one [s]
  MomentHead head;              ///< of the present stage
  std::size_t first_event = 0;  ///< rows before the present stage
  std::size_t first_sample = 0, first_note = 0;
  std::size_t change_bytes = 0, stage_bytes = 0;
  std::uint64_t effects_at_pause = 0;  ///< ScriptModel::effects as a console opened
  bool at_work = false;                ///< a stage runs
  bool by_steps = false;               ///< ... that has step borders
  bool restoring = false;              ///< the script repeats stages that were completed
  bool replaying = false;              ///< ... and calls of handlers
  bool looked = false;                 ///< lost state of the script was looked for
  bool signalled = false;              ///< a signal ends the run; its checkpoint is stored
  bool told = false;                   ///< that there are no further checkpoints
  std::string off;                     ///< why there are no further checkpoints; "": there are
  std::string failure;                 ///< of the last store, reported once

  [[nodiscard]] bool keeps() const { return off.empty() && at_work && !replaying; }
  [[nodiscard]] bool due(double now) const { return every > 0 && now - stored_at >= every; }
};

/// Wall clock, read without a call of the system [s].
double coarse_clock();

std::string stage_name(int stage);
std::string change_name(int change);
/// Name and head of the latest complete checkpoint; the name is "" if there is none.
std::pair<std::string, MomentHead> latest_checkpoint(const RestartFiles& files);
/// Number of completed stages.
int stages_done(const RestartFiles& files);
/// Where a run can continue: "at 3.2 s, within stage 2"; "" if it cannot.
std::string resume_point(const RestartFiles& files);

}  // namespace trilith::script
