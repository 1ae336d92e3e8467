#include "run/record/recorded_modes.hpp"

namespace trilith {
namespace {

template <class Value>
std::vector<double> in_a_row(const std::vector<Value>& values) {
  std::vector<double> out;
  for (const Value& v : values) for_each_number(v, [&](double number) { out.push_back(number); });
  return out;
}

}  // namespace

template <int D>
std::vector<results::ModeRow> recorded_modes(const State<D>& state, const std::vector<NaturalMode<D>>& modes,
                                             const std::vector<ModeDamping>& damping) {
  std::vector<results::ModeRow> rows;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    results::ModeRow row;
    row.number = static_cast<std::int32_t>(i) + 1;
    row.time = state.time;
    row.frequency = modes[i].frequency();
    row.damping = damping[i].total();
    for (std::size_t k = 0; k < modes[i].mass.size(); ++k) row.mass[k] = modes[i].mass[k];
    row.position = in_a_row(state.position), row.rotation = in_a_row(state.rotation);
    row.displacement = in_a_row(modes[i].displacement), row.turn = in_a_row(modes[i].rotation);
    rows.push_back(std::move(row));
  }
  return rows;
}

template std::vector<results::ModeRow> recorded_modes(const State<2>&, const std::vector<NaturalMode<2>>&,
                                                      const std::vector<ModeDamping>&);
template std::vector<results::ModeRow> recorded_modes(const State<3>&, const std::vector<NaturalMode<3>>&,
                                                      const std::vector<ModeDamping>&);

}  // namespace trilith
