#include "results/file/time_origin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace trilith::results {

TimeOrigin time_origin(const ResultsReader& reader, std::string_view name) {
  if (name.empty()) return {};
  std::vector<std::string> known;
  for (const StageRow& stage : reader.stages()) {
    if (stage.name == name) return {stage.begin, std::string(name), fmt::format("'{}' began", name)};
    known.push_back(stage.name);
  }
  for (const EventRow& e : reader.events()) {
    if (e.type == name) return {e.time, std::string(name), fmt::format("the first {}", name)};
    if (std::find(known.begin(), known.end(), e.type) == known.end()) known.push_back(e.type);
  }
  throw InputError(fmt::format("--since: '{}' has no stage and no event '{}'{}", reader.path().string(), name,
                               name_hint(name, known)));
}

StageRow find_stage(const ResultsReader& reader, std::string_view name) {
  std::vector<std::string> known;
  for (const StageRow& stage : reader.stages()) {
    if (stage.name == name) return stage;
    known.push_back(stage.name);
  }
  throw InputError(fmt::format("'{}' has no stage '{}'{}", reader.path().string(), name, name_hint(name, known)));
}

}  // namespace trilith::results
