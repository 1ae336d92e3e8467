#include "draw/results/field_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>

#include "base/error.hpp"
#include "results/file/field_names.hpp"
#include "results/reading/frame_values.hpp"

namespace trilith::draw {

using results::Frame;
using results::Header;

namespace {

Vec2 node_place(const Frame& frame, int node) {
  const auto at = static_cast<std::size_t>(2 * node);
  return {frame.position[at], frame.position[at + 1]};
}

/// The finite elements of the plane, each with the mean temperature of its nodes.
void add_element_patches(const Header& header, const Frame& frame, const std::vector<std::optional<double>>& node,
                         Scene& scene) {
  for (std::size_t e = 0; e < header.element_count(); ++e) {
    SceneBody& body = scene.bodies[static_cast<std::size_t>(header.element_body[e])];
    if (!body.value) continue;
    ScenePatch patch;
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const int n = header.element_node[4 * e + k];
      if (n < 0) continue;
      patch.outline.push_back(node_place(frame, n)), sum += node[static_cast<std::size_t>(n)].value_or(0);
    }
    patch.value = sum / static_cast<double>(patch.outline.size());
    body.patches.push_back(std::move(patch));
  }
}

}  // namespace

std::vector<std::optional<double>> temperatures_of_nodes(const Header& header, const Frame& frame) {
  std::vector<std::optional<double>> out(header.node_count());
  const std::vector<double>* const recorded = results::values_of(header, frame, results::node_temperature);
  for (std::size_t i = 0; recorded != nullptr && i < out.size(); ++i)
    if ((*recorded)[i] > results::no_temperature) out[i] = (*recorded)[i];
  return out;
}

void colour_by_temperature(const results::ResultsReader& reader, const Frame& frame, Scene& scene) {
  const Header& header = reader.header();
  const std::vector<std::optional<double>> node = temperatures_of_nodes(header, frame);
  if (std::none_of(node.begin(), node.end(), [](const auto& t) { return t.has_value(); }))
    throw InputError(fmt::format("'{}' has no temperatures at this time; give bodies a temperature by m:heat",
                                 reader.path().string()));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const results::BodyRow& body = header.bodies[i];
    const auto first = node.begin() + body.first_node, end = first + body.node_count;
    if (scene.bodies[i].role != BodyRole::free || !first->has_value()) continue;
    const double sum = std::accumulate(first, end, 0.0, [](double s, const auto& t) { return s + t.value_or(0); });
    scene.bodies[i].value = sum / body.node_count;
  }
  if (header.dim == 2) add_element_patches(header, frame, node, scene);
  scene.value_label = "temperature", scene.value_unit = "°C";
}

void colour_by_water(const results::ResultsReader& reader, const Frame& frame, Scene& scene) {
  const Header& header = reader.header();
  const std::vector<double>*const ends = results::values_of(header, frame, results::water_cell),
                                  *const pressure = results::values_of(header, frame, results::water_pressure);
  for (std::size_t i = 0; header.dim == 2 && pressure != nullptr && i < pressure->size(); ++i) {
    const double* const at = ends->data() + 4 * i;
    const SceneStrip strip{{at[0], at[1]}, {at[2], at[3]}, (*pressure)[i]};
    if (strip.a != strip.b) scene.strips.push_back(strip);
  }
  if (scene.strips.empty())
    throw InputError(
        fmt::format("'{}' has no water in joints between bodies of a plane model to draw; declare "
                    "m:seepage with upper and lower",
                    reader.path().string()));
  scene.value_label = "water pressure in joints", scene.value_unit = "Pa";
}

}  // namespace trilith::draw
