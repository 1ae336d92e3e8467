#include "draw/chart/stored_motion.hpp"

#include <cmath>
#include <limits>

namespace trilith::draw {
namespace {

/// Coordinate of a node that a motion drives: x, y, z, or the rotation (-1).
int axis_of(const std::string& direction) {
  return direction == "x" ? 0 : direction == "y" ? 1 : direction == "z" ? 2 : -1;
}

/// End time of the motion of row `r`: its last sample, or the start of the next one of the same node and direction.
double over_at(const std::vector<results::MotionRow>& rows, std::size_t r, const GroundMotion& motion) {
  double end = rows[r].begin + motion.end_time();
  for (std::size_t k = r + 1; k < rows.size(); ++k)
    if (rows[k].node == rows[r].node && rows[k].direction == rows[r].direction) end = std::min(end, rows[k].begin);
  return end;
}

}  // namespace

GroundMotion stored_motion(const results::MotionRow& row) {
  MotionSource source;
  source.file = row.record;
  source.title = row.title.empty() ? row.text : row.title;
  source.notes = {row.text};
  GroundMotion motion(row.acceleration, row.step, {row.start_velocity, row.start_displacement}, source);
  return row.start_time == 0 ? motion : motion.delayed(row.start_time);
}

std::vector<double> motion_misses(const results::ResultsReader& reader, const std::vector<results::MotionRow>& rows) {
  std::vector<double> miss(rows.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<GroundMotion> motions;
  std::vector<double> end;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    motions.push_back(stored_motion(rows[r]));
    end.push_back(over_at(rows, r, motions.back()));
  }
  const int dim = reader.header().dim;
  for (std::size_t f = 0; f < reader.frame_count() && !rows.empty(); ++f) {
    const results::Frame frame = reader.frame(f);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (frame.time < rows[r].begin || frame.time > end[r]) continue;
      const int axis = axis_of(rows[r].direction);
      const auto node = static_cast<std::size_t>(rows[r].node), width = static_cast<std::size_t>(dim);
      const double is = axis < 0 ? frame.rotation[node] : frame.position[node * width + static_cast<std::size_t>(axis)];
      const double off = std::abs(is - rows[r].origin - motions[r].displacement(frame.time - rows[r].begin));
      if (!(miss[r] >= off)) miss[r] = off;
    }
  }
  return miss;
}

}  // namespace trilith::draw
