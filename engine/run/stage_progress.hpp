// Progress of a stage: the data of its loop that are not in Model, State and Work. A snapshot contains a copy.
#pragma once

#include <cstdint>

#include "run/stage.hpp"

namespace trilith {

/// Samples at equal intervals from the start of the stage. They are counted, so that rounding errors do not accumulate.
struct SampleClock {
  double begun, interval;  ///< [s]
  std::int64_t next = 0;
  bool due(double time, double dt) {
    if (interval <= 0 || time < begun + static_cast<double>(next) * interval - 0.5 * dt) return false;
    next = static_cast<std::int64_t>((time + 0.5 * dt - begun) / interval) + 1;
    return true;
  }
};

struct StageProgress {
  StageProgress(const StageOptions& asked, double time)
      : options(asked),
        end(asked.end_time > time ? asked.end_time : time + asked.duration),
        frames{time, asked.frame_interval},
        histories{time, asked.history_interval},
        energies{time, asked.energy_interval},
        still_since(time) {
    report.name = asked.name;
    report.begun = time;
  }

  StageOptions options;
  double end;  ///< [s]
  SampleClock frames, histories, energies;
  double still_since;  ///< [s]
  bool first = true;   ///< its first instant has not been reported
  bool over = false;
  StageReport report;
};

}  // namespace trilith
