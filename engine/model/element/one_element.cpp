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

/// A mesh of one quadrilateral, as of one brick, is a part of a mesh that has cracked: others are of the kind quad.
bool is_one_element(const Model<2>& model, int body) {
  const Body& b = model.bodies[body];
  return b.kind == BodyKind::quad || (b.kind == BodyKind::mesh && b.nodes == 3);
}
bool is_one_element(const Model<3>& model, int body) {
  const Body& b = model.bodies[body];
  return b.kind == BodyKind::brick || (b.kind == BodyKind::mesh && b.nodes == 4);
}

}  // namespace trilith
