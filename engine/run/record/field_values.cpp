#include "run/record/field_values.hpp"

#include <algorithm>

#include "assembly/field/joint_water.hpp"
#include "field/field_step.hpp"
#include "model/pose.hpp"
#include "results/file/field_names.hpp"

namespace trilith {
namespace {

bool has_frames(const Field& heat) {
  return std::any_of(heat.bodies.begin(), heat.bodies.end(),
                     [](const FieldBody& row) { return row.layout == CellLayout::sections; });
}

void describe_water(const Field& water, int dim, results::Header& header) {
  const auto cells = static_cast<std::size_t>(water.flow->cells());
  header.fields.push_back({results::water_cell, "m",
                           "both ends of each cell of the seepage in the "
                           "world; equal in a fissure, which has no place",
                           cells, 2 * dim});
  header.fields.push_back({results::water_pressure, "Pa", "pressure of the water in each cell", cells, 1});
  header.fields.push_back({results::water_fill, "1", "share of each cell that water fills", cells, 1});
  header.fields.push_back({results::water_aperture, "m", "aperture in the middle of each cell", cells, 1});
}

template <int D>
void take_temperatures(const Instant<D>& now, const FieldValues& heat, std::vector<std::vector<double>>& values) {
  std::vector<double> mean(now.model.mass.size(), results::no_temperature), difference(mean.size(), 0);
  for (const FieldBody& row : heat.field().bodies) {
    const Body& body = now.model.bodies[static_cast<std::size_t>(row.body)];
    for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
      const auto i = static_cast<std::size_t>(n);
      const double low = heat.at(row.cell_of(n, 0)), high = heat.at(row.cell_of(n, 1));
      const bool both = row.layout == CellLayout::sections;
      mean[i] = both ? 0.5 * (low + high) : low, difference[i] = both ? high - low : 0;
    }
  }
  values.push_back(std::move(mean));
  if (has_frames(heat.field())) values.push_back(std::move(difference));
}

/// Ends of the cells of a joint in the world.
void add_cell_ends(const FlowJoint& joint, const Instant<2>& now, std::vector<double>& out) {
  const Vec2 heel = pose_at(now.model, now.state, joint.heel).place,
             all = pose_at(now.model, now.state, joint.toe).place - heel;
  for (int i = 0; i < joint.cells; ++i)
    for (const int end : {0, 1}) {
      const Vec2 at = heel + static_cast<double>(i + end) / joint.cells * all;
      out.insert(out.end(), {at.x(), at.y()});
    }
}

void add_cell_ends(const FlowJoint& joint, const Instant<3>& now, std::vector<double>& out) {
  const auto [heel, toe] = ends_in_space(joint, now.model, now.state);
  for (int i = 0; i < joint.cells; ++i)
    for (const int end : {0, 1}) {
      const Vec3 at = heel + static_cast<double>(i + end) / joint.cells * (toe - heel);
      out.insert(out.end(), {at.x(), at.y(), at.z()});
    }
}

template <int D>
void take_water(const Instant<D>& now, const Field& field, FieldState state, std::vector<std::vector<double>>& values) {
  extend_field(field, state);
  const JointFlow& flow = *field.flow;
  const Apertures apertures = joint_apertures(flow, state, now.model, now.state);
  std::vector<double> ends, pressure, fill, aperture;
  for (const FlowJoint& joint : flow.joints) {
    if (joint.has_bodies())
      add_cell_ends(joint, now, ends);
    else
      ends.resize(ends.size() + static_cast<std::size_t>(2 * D * joint.cells), 0);
    for (int i = 0; i < joint.cells; ++i) {
      const auto cell = static_cast<std::size_t>(joint.first_cell + i);
      const double a = 0.5 * (apertures[cell][0] + apertures[cell][1]);
      const double water = state.value[static_cast<std::size_t>(flow.cells()) + cell];
      pressure.push_back(joint.weight * state.value[cell]), aperture.push_back(a);
      fill.push_back(std::min(1.0, water / (joint.width * joint.cell_length() * a)));
    }
  }
  for (std::vector<double>* one : {&ends, &pressure, &fill, &aperture}) values.push_back(std::move(*one));
}

}  // namespace

template <int D>
void describe_field_values(const Model<D>& model, results::Header& header) {
  if (const auto heat = field_of(model.fields, FieldKind::heat)) {
    header.fields.push_back({results::node_temperature, "degC",
                             "temperature of each node, in frames the mean of "
                             "both faces; -273.15: none",
                             header.node_count(), 1});
    if (has_frames(*heat))
      header.fields.push_back({results::node_temperature_difference, "K",
                               "upper less lower face of the section at each "
                               "node of a frame, 0 elsewhere",
                               header.node_count(), 1});
  }
  if (const auto water = field_of(model.fields, FieldKind::seepage)) describe_water(*water, D, header);
}

template <int D>
void take_field_values(const Instant<D>& now, std::vector<std::vector<double>>& values) {
  if (const FieldValues heat = values_of(now.model.fields, now.state.fields, FieldKind::heat))
    take_temperatures(now, heat, values);
  const int row = row_of(now.model.fields, FieldKind::seepage);
  if (row < 0) return;
  const auto at = static_cast<std::size_t>(row);
  take_water(now, *now.model.fields[at], at < now.state.fields.size() ? now.state.fields[at] : FieldState{}, values);
}

template void describe_field_values(const Model<2>&, results::Header&);
template void describe_field_values(const Model<3>&, results::Header&);
template void take_field_values(const Instant<2>&, std::vector<std::vector<double>>&);
template void take_field_values(const Instant<3>&, std::vector<std::vector<double>>&);

}  // namespace trilith
