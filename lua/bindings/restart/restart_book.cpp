#include "bindings/restart/restart_book.hpp"

#include <fmt/format.h>
#include <time.h>

namespace trilith::script {

double coarse_clock() {
  struct timespec now {};
  ::clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string stage_name(int stage) {
  return fmt::format("stage-{:04}", stage);
}
std::string change_name(int change) {
  return fmt::format("change-{:06}", change);
}

std::pair<std::string, MomentHead> latest_checkpoint(const RestartFiles& files) {
  std::pair<std::string, MomentHead> latest;
  for (const char* const name : {"at-0", "at-1"}) {
    if (!files.has(name)) continue;
    try {
      const std::string bytes = files.get(name);
      ByteReader in(bytes, name);
      const auto head = in.get<MomentHead>();
      if (latest.first.empty() || head.sequence > latest.second.sequence) latest = {name, head};
    } catch (const InputError&) {  // the other one may be complete
      continue;
    }
  }
  return latest;
}

int stages_done(const RestartFiles& files) {
  int done = 0;
  while (files.has(stage_name(done + 1))) ++done;
  return done;
}

std::string resume_point(const RestartFiles& files) {
  const int done = stages_done(files);
  const auto [name, head] = latest_checkpoint(files);
  if (!name.empty() && head.stage > done) return fmt::format("at {:.6g} s, within stage {}", head.time, head.stage);
  if (done == 0) return "";
  const std::string bytes = files.get(stage_name(done));
  ByteReader in(bytes, stage_name(done));
  return fmt::format("at {:.6g} s, after stage {}", in.get<MomentHead>().time, done);
}

}  // namespace trilith::script
