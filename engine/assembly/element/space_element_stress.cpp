// Stress in elements in space, for recordings and scripts.
#include "assembly/element/element_stress.hpp"
#include "assembly/element/space_element_now.hpp"
#include "field/field.hpp"

namespace trilith {
namespace {

/// Deformation of an element of N nodes, and its axes.
template <int N>
Eigen::VectorXd deformation_of(const double* number, const SpaceElement& e, const State<3>& state,
                               Eigen::Matrix3d& axes) {
  const SpaceElementNow<N> now(number, e.node.data(), state.position, state.velocity);
  axes = now.turn.axes;
  return Eigen::Map<const Eigen::VectorXd>(now.d.data(), 3 * N);
}

Eigen::VectorXd deformation_of(const Model<3>& model, const SpaceElement& e, const State<3>& state,
                               Eigen::Matrix3d& axes) {
  const double* const number = &model.element_number[static_cast<std::size_t>(e.first_number)];
  switch (e.shape) {
    case ElementShape::brick:
      return deformation_of<8>(number, e, state, axes);
    case ElementShape::tetrahedron:
      return deformation_of<4>(number, e, state, axes);
    case ElementShape::wedge:
      return deformation_of<6>(number, e, state, axes);
    case ElementShape::quadratic_tetrahedron:
      break;
  }
  return deformation_of<10>(number, e, state, axes);
}

}  // namespace

/// B is computed again, because elastic elements store only their stiffness.
SpaceElementStress element_stress(const Model<3>& model, const State<3>& state, int element) {
  const SpaceElement& e = model.space_elements[static_cast<std::size_t>(element)];
  const Solid& solid = model.solids[static_cast<std::size_t>(e.solid)];
  const int nodes = info_of(e.shape).nodes;
  const double* const shape = &model.element_number[static_cast<std::size_t>(e.first_number)];
  std::vector<Vec3> places;
  for (int i = 0; i < nodes; ++i) places.emplace_back(shape[3 * i], shape[3 * i + 1], shape[3 * i + 2]);
  const SpaceElementStrain field = element_strain(e.shape, places, solid);
  SpaceElementStress out;
  Eigen::VectorXd d = deformation_of(model, e, state, out.axes);
  const FieldValues heat = values_of(model.fields, state.fields, FieldKind::heat);
  if (const FreeShape* free = heat.shape_of(static_cast<std::size_t>(element))) heat.subtract_free(*free, d.data());
  out.points = field.points;
  for (std::size_t p = 0; p < static_cast<std::size_t>(field.points); ++p) {
    const SpaceVector strain = field.matrix[p].leftCols(3 * nodes) * d;
    const SpaceMemory memory =
        e.first_point >= 0 ? state.plastic[static_cast<std::size_t>(e.first_point) + p] : SpaceMemory{};
    out.at_point[p] = stress_in_space(solid, strain, memory);
    out.volume += field.volume[p];
    out.mean += field.volume[p] * out.at_point[p], out.plastic += field.volume[p] * memory.measure;
  }
  out.mean /= out.volume, out.plastic /= out.volume;
  return out;
}

/// R S R'.
SpaceVector in_world(const SpaceElementStress& e) {
  const SpaceVector& m = e.mean;
  Eigen::Matrix3d s;
  s << m[0], m[3], m[5], m[3], m[1], m[4], m[5], m[4], m[2];
  s = (e.axes * s * e.axes.transpose()).eval();
  return (SpaceVector() << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0)).finished();
}

}  // namespace trilith
