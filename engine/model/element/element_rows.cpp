#include "model/element/element_rows.hpp"

#include <algorithm>

#include "model/builder/shared_numbers.hpp"

namespace trilith {
namespace {

std::vector<Vec2> corners_at_start(const Model<2>& model, const Element& element) {
  std::vector<Vec2> corners;
  for (int i = 0; i < element.nodes; ++i) corners.push_back(model.start_position[element.node[i]]);
  return corners;
}

/// Nodes relative to their mean, then mean gradients, eight numbers each; a triangle's last two are 0.
void append_shape(std::span<const Vec2> corners, std::vector<double>& numbers) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& x : corners) mean += x;
  mean /= static_cast<double>(corners.size());
  for (std::size_t i = 0; i < max_element_nodes; ++i) {
    const Vec2 x = i < corners.size() ? Vec2(corners[i] - mean) : Vec2::Zero();
    numbers.insert(numbers.end(), {x.x(), x.y()});
  }
  for (const Vec2& g : mean_gradients(corners)) numbers.insert(numbers.end(), {g.x(), g.y()});
}

void append_points(const ElementStrain& strain, double thickness, std::vector<double>& numbers) {
  for (int p = 0; p < strain.points; ++p) {
    for (int i = 0; i < 2 * max_element_nodes; ++i)
      for (int k = 0; k < 3; ++k) numbers.push_back(strain.matrix[p](k, i));
    numbers.push_back(strain.area[p] * thickness);
  }
}

/// Consecutive elements of one kind and solid are processed in one loop.
void add_to_batch(Model<2>& model, const Element& element) {
  if (!model.element_batches.empty()) {
    ElementBatch& last = model.element_batches.back();
    if (last.nodes == element.nodes && last.solid == element.solid) {
      ++last.count;
      return;
    }
  }
  model.element_batches.push_back({static_cast<int>(model.elements.size()), 1, element.nodes, element.solid});
}

}  // namespace

ElementStrain element_strain(std::span<const Vec2> corners, const Solid& solid) {
  return solid.form == ElementForm::plain ? plain_strain(corners) : assumed_strain(corners, solid.elastic());
}

void append_element(Model<2>& model, Element element, double density) {
  const std::vector<Vec2> corners = corners_at_start(model, element);
  const Solid& solid = model.solids[element.solid];
  const ElementStrain strain = element_strain(corners, solid);
  // Also for inelastic solids: damping and the stability limit use it.
  const ElementMatrix stiffness = element.thickness * element_stiffness(strain, solid.elastic());
  ElementNumbers numbers{{}, 2 * max_element_nodes, rounding_of(std::span<const Vec2>(corners))};
  append_shape(corners, numbers.all);
  numbers.all.insert(numbers.all.end(), stiffness.data(), stiffness.data() + stiffness.size());
  if (!solid.is_elastic()) append_points(strain, element.thickness, numbers.all);
  const auto is_like = [&](const Element& e) { return e.nodes == element.nodes && e.solid == element.solid; };
  element.first_number = shared_numbers(model.elements, is_like, numbers, model.element_number);
  if (!solid.is_elastic()) {
    element.first_point = model.plastic_points;
    model.plastic_points += strain.points;
  }
  // Lumped at the nodes, by the integrals of their shape functions.
  std::array<double, max_element_nodes> mass = node_areas(corners);
  for (int i = 0; i < element.nodes; ++i) {
    mass[i] *= density * element.thickness;
    model.mass[element.node[i]] += mass[i];
  }
  // The largest frequency of any single element bounds the frequencies of all. The damping of a solid is its stiffness
  // times a time.
  RateBound& bound = model.element_bound[element.body];
  const double most =
      largest_frequency2(stiffness, std::span<const double>(mass).first(static_cast<std::size_t>(element.nodes)));
  bound.stiffness = std::max(bound.stiffness, most);
  bound.damping = std::max(bound.damping, solid.damping() * most);
  model.element_rate.push_back(most);
  add_to_batch(model, element);
  model.elements.push_back(element);
}

}  // namespace trilith
