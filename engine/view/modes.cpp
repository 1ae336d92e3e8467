#include "view/modes.hpp"

#include <algorithm>
#include <cmath>

#include "draw/results/results_modes.hpp"

namespace trilith::view {
namespace {

/// Limit of a page; the last ones are kept.
constexpr std::size_t most_modes = 40;
/// Resolution as a share of the largest number in a block.
constexpr double mode_parts = 1e5;

ViewBlock mode_block(const char* name, std::size_t columns, const std::vector<std::vector<double>>& rows) {
  double largest = 0;
  for (const auto& row : rows)
    for (const double v : row) largest = std::max(largest, std::abs(v));
  ViewBlock block{name, columns, largest > 0 ? largest / mode_parts : 1, {}};
  for (const auto& row : rows)
    for (const double v : row) block.values.push_back(quantised(v, block.quantum));
  return block;
}

std::vector<double> times(double scale, std::vector<double> values) {
  for (double& v : values) v *= scale;
  return values;
}

}  // namespace

void write_modes(const results::ResultsReader& reader, JsonText& json, std::vector<ViewBlock>& blocks) {
  const results::Header& header = reader.header();
  std::vector<results::ModeRow> modes = reader.modes();
  if (modes.size() > most_modes) modes.erase(modes.begin(), modes.end() - most_modes);
  std::vector<std::vector<double>> position, rotation, displacement, turn;
  json.key("modes").begin_list();
  for (const results::ModeRow& m : modes) {
    json.begin_object().number("number", m.number).number("time", m.time).number("frequency", m.frequency);
    json.number("damping", m.damping).end();
    const double scale = draw::mode_scale(header, m);
    position.push_back(m.position), rotation.push_back(m.rotation);
    displacement.push_back(times(scale, m.displacement)), turn.push_back(times(scale, m.turn));
  }
  json.end();
  if (modes.empty()) return;
  blocks.push_back(mode_block("mode_position", position[0].size(), position));
  blocks.push_back(mode_block("mode_rotation", rotation[0].size(), rotation));
  blocks.push_back(mode_block("mode_displacement", displacement[0].size(), displacement));
  blocks.push_back(mode_block("mode_turn", turn[0].size(), turn));
}

}  // namespace trilith::view
