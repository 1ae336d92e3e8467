#include "model/element/one_element.hpp"

#include <algorithm>

namespace trilith {

/// Elements are stored body by body.
template <class E>
const E& first_element(const std::vector<E>& elements, int body) {
  return *std::lower_bound(elements.begin(), elements.end(), body, [](const E& e, int b) { return e.body < b; });
}
template const Element& first_element(const std::vector<Element>&, int);
template const SpaceElement& first_element(const std::vector<SpaceElement>&, int);

bool is_one_element(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  if (b.kind != BodyKind::mesh || b.nodes > 4) return b.kind == BodyKind::quad;
  const Element* const next = &first_element(model.elements, body) + 1;
  return next == model.elements.data() + model.elements.size() || next->body != body;
}
bool is_one_element(const Model<3>& model, int body) {
  const Body& b = model.bodies[body];
  return b.kind == BodyKind::brick || (b.kind == BodyKind::mesh && b.nodes == 4);
}

}  // namespace trilith
