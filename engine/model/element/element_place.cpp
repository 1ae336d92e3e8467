#include "model/element/element_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "element/solid/element_point.hpp"

namespace trilith {
namespace {

/// Larger natural coordinates are outside of an element, beyond rounding.
constexpr double on_face = 1e-9;
/// Largest distance of a point from its element in natural coordinates: elements of round bodies do not fill them.
constexpr double beside = 0.05;

std::vector<Vec3> start_of(const Model<3>& model, const SpaceElement& element) {
  std::vector<Vec3> nodes;
  for (int i = 0; i < info_of(element.shape).nodes; ++i)
    nodes.push_back(model.start_position[element.node[static_cast<std::size_t>(i)]]);
  return nodes;
}

/// Whether a point may be inside an element with these nodes; edges may bulge by the element's length.
bool may_hold(const std::vector<Vec3>& nodes, const Vec3& at) {
  Vec3 low = nodes[0], high = nodes[0];
  for (const Vec3& x : nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  const Vec3 margin = Vec3::Constant(0.5 * (high - low).maxCoeff());
  return ((at - low + margin).array() >= 0).all() && ((high + margin - at).array() >= 0).all();
}

struct Found {
  int element = -1;
  Vec3 natural = Vec3::Zero();
  double outside = unbounded;
};

/// The element that contains the point, or the nearest of the tested ones.
Found find_element(const Model<3>& model, int body, const Vec3& at, bool near_alone) {
  Found best;
  for (std::size_t e = 0; e < model.space_elements.size() && best.outside > on_face; ++e) {
    const SpaceElement& element = model.space_elements[e];
    if (element.body != body) continue;
    const std::vector<Vec3> nodes = start_of(model, element);
    if (near_alone && !may_hold(nodes, at)) continue;
    const Vec3 natural = natural_coordinates(element.shape, nodes, at);
    if (const double outside = outside_of(element.shape, natural); outside < best.outside)
      best = {static_cast<int>(e), natural, outside};
  }
  return best;
}

}  // namespace

ElementShares element_shares(const Model<3>& model, int body, const Vec3& at) {
  Found found = find_element(model, body, at, true);
  if (found.element < 0) found = find_element(model, body, at, false);
  const auto n = shape_functions(model.space_elements[static_cast<std::size_t>(found.element)].shape, found.natural);
  ElementShares shares;
  shares.element = found.element, shares.outside = found.outside > on_face ? found.outside : 0;
  std::copy(n.begin(), n.end(), shares.share.begin());
  return shares;
}

ElementShares element_shares(const Model<3>& model, int body, const Vec3& at, const std::string& owner) {
  const ElementShares shares = element_shares(model, body, at);
  if (shares.outside > beside)
    throw InputError(
        fmt::format("{}: the point ({:g}, {:g}, {:g}) is not in '{}', which deforms, so it cannot be attached; give a "
                    "point in it or on it",
                    owner, at.x(), at.y(), at.z(), model.bodies[body].name));
  return shares;
}

Vec3 element_place(const Model<3>& model, const State<3>& state, int body, const Vec3& at) {
  const ElementShares shares = element_shares(model, body, at);
  const SpaceElement& element = model.space_elements[static_cast<std::size_t>(shares.element)];
  Vec3 now = Vec3::Zero();
  for (int i = 0; i < info_of(element.shape).nodes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    now += shares.share[k] * state.position[element.node[k]];
  }
  return now;
}

}  // namespace trilith
