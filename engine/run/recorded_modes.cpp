#include "run/recorded_modes.hpp"

namespace trilith {
namespace {

std::vector<double> in_a_row(const std::vector<Vec2>& values) {
  std::vector<double> out;
  out.reserve(2 * values.size());
  for (const Vec2& v : values) out.insert(out.end(), {v.x(), v.y()});
  return out;
}

}  // namespace

std::vector<results::ModeRow> recorded_modes(const State<2>& state, const std::vector<Mode>& modes,
                                             const std::vector<ModeDamping>& damping) {
  std::vector<results::ModeRow> rows;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    results::ModeRow row;
    row.number = static_cast<std::int32_t>(i) + 1;
    row.time = state.time;
    row.frequency = modes[i].frequency();
    row.damping = damping[i].total();
    for (const std::size_t k : {0, 1}) row.mass[k] = modes[i].mass[k];
    row.position = in_a_row(state.position), row.rotation = state.rotation;
    row.displacement = in_a_row(modes[i].displacement), row.turn = modes[i].rotation;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace trilith
