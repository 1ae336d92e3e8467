#include "results/reading/row_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith::results {
namespace {

void check_frame_sizes(const FrameRow& frame, const FrameSizes& sizes) {
  const auto require = [&](std::size_t given, std::size_t needed, const char* what) {
    if (given != needed)
      throw ResultsError(
          fmt::format("results frame at t = {:g} s: {} has {} numbers, needs {}", frame.time, what, given, needed));
  };
  const auto dim = static_cast<std::size_t>(sizes.dim);
  const std::size_t moving = sizes.with_velocity ? sizes.nodes : 0, bearings = sizes.bearings;
  require(frame.position.size(), sizes.nodes * dim, "position");
  require(frame.rotation.size(), sizes.nodes * static_cast<std::size_t>(rotation_width(sizes.dim)), "rotation");
  require(frame.velocity.size(), moving * dim, "velocity");
  require(frame.spin.size(), moving * static_cast<std::size_t>(spin_width(sizes.dim)), "spin");
  require(frame.stress.size(), 3 * sizes.elements, "stress");
  require(frame.plastic.size(), sizes.elements, "plastic");
  require(frame.bearing_state.size(), bearings, "bearing_state");
  require(frame.bearing_force.size(), bearings * dim, "bearing_force");
  require(frame.bearing_displacement.size(), bearings * dim, "bearing_displacement");
  require(frame.fields.size(), sizes.field.size(), "fields");
  for (std::size_t i = 0; i < sizes.field.size(); ++i) require(frame.fields[i].size(), sizes.field[i], "a field");
}

void check_frame_numbers(const FrameRow& frame) {
  const auto require = [&](std::span<const double> values, const char* what) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isfinite(values[i]))
        throw ResultsError(
            fmt::format("results frame at t = {:g} s: number {} of {} is {}", frame.time, i, what, values[i]));
  };
  require({&frame.time, 1}, "time");
  require(frame.position, "position");
  require(frame.rotation, "rotation");
  require(frame.velocity, "velocity");
  require(frame.spin, "spin");
  require(frame.stress, "stress");
  require(frame.plastic, "plastic");
  require(frame.bearing_force, "bearing_force");
  require(frame.bearing_displacement, "bearing_displacement");
  for (const std::vector<double>& field : frame.fields) require(field, "a field");
  for (const ContactForce& contact : frame.contacts) {
    require(contact.point, "a contact's point");
    require(contact.force, "a contact's force");
    require({&contact.area, 1}, "a contact's area");
    require(contact.normal, "a contact's normal");
  }
}

}  // namespace

void check_frame(const FrameRow& frame, const FrameSizes& sizes) {
  check_frame_sizes(frame, sizes);
  check_frame_numbers(frame);
}

void check_mode(const ModeRow& mode, int dimension, std::size_t nodes) {
  const std::size_t dim = static_cast<std::size_t>(dimension),
                    turns = static_cast<std::size_t>(rotation_width(dimension)),
                    spins = static_cast<std::size_t>(spin_width(dimension));
  for (const auto& [values, width] : {std::pair{&mode.position, dim}, std::pair{&mode.rotation, turns},
                                      std::pair{&mode.displacement, dim}, std::pair{&mode.turn, spins}}) {
    if (values->size() != width * nodes)
      throw ResultsError(fmt::format("results mode {}: {} numbers for {} nodes", mode.number, values->size(), nodes));
    if (!std::all_of(values->begin(), values->end(), [](double v) { return std::isfinite(v); }))
      throw ResultsError(fmt::format("results mode {}: holds a number that is not finite", mode.number));
  }
}

void check_motion(const MotionRow& motion, std::size_t bodies, std::size_t nodes) {
  const auto refuse = [&](const std::string& why) {
    throw ResultsError(fmt::format("results motion '{}': {}", motion.text, why));
  };
  if (motion.body < 0 || static_cast<std::size_t>(motion.body) >= bodies)
    refuse(fmt::format("moves body {} of {}", motion.body, bodies));
  if (motion.node < 0 || static_cast<std::size_t>(motion.node) >= nodes)
    refuse(fmt::format("moves node {} of {}", motion.node, nodes));
  if (motion.acceleration.size() < 2) refuse(fmt::format("has {} samples, needs 2", motion.acceleration.size()));
  if (!(motion.step > 0)) refuse(fmt::format("has the step {}, must be above 0", motion.step));
  const auto is_number = [](double v) { return std::isfinite(v); };
  for (const double v :
       {motion.step, motion.begin, motion.origin, motion.start_time, motion.start_velocity, motion.start_displacement})
    if (!is_number(v)) refuse("holds a number that is not finite");
  if (!std::all_of(motion.acceleration.begin(), motion.acceleration.end(), is_number))
    refuse("holds a sample that is not finite");
}

std::string row_name(const std::vector<std::string>& names, std::int32_t index, const char* what) {
  if (index == -1) return "";
  if (index < 0 || static_cast<std::size_t>(index) >= names.size())
    throw ResultsError(fmt::format("results event: {} {} of {}", what, index, names.size()));
  return names[static_cast<std::size_t>(index)];
}

}  // namespace trilith::results
