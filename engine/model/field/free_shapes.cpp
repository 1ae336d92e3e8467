#include "model/field/free_shapes.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "model/element/element_rows.hpp"
#include "model/element/space_element_rows.hpp"

namespace trilith {

Eigen::MatrixXd point_values(const Element& e) {
  const double at = 1 / std::sqrt(3.0);
  constexpr std::array<double, 4> xi{-1, 1, 1, -1}, eta{-1, -1, 1, 1};
  const int points = e.nodes == 4 ? 4 : 1;
  Eigen::MatrixXd out(points, e.nodes);
  for (int p = 0; p < points; ++p) {
    const auto k = static_cast<std::size_t>(p);
    const Vec2 natural = e.nodes == 4 ? Vec2(at * xi[k], at * eta[k]) : Vec2(1.0 / 3, 1.0 / 3);
    const auto value = shape_functions(static_cast<std::size_t>(e.nodes), natural);
    for (int j = 0; j < e.nodes; ++j) out(p, j) = value[static_cast<std::size_t>(j)];
  }
  return out;
}

Eigen::MatrixXd point_values(const SpaceElement& e) {
  return shape_values(e.shape);
}

namespace {

/// Nodal forces of a unit temperature at each node with the nodes held, in the element's axes, a column each:
/// integral of B' C e N_j, with the free strain e for a unit of expansion times temperature.
Eigen::MatrixXd held_forces(const Model<2>& model, const Element& e) {
  const Solid& solid = model.solids[static_cast<std::size_t>(e.solid)];
  const double* const shape = &model.element_number[static_cast<std::size_t>(e.first_number)];
  std::vector<Vec2> corners;
  for (int i = 0; i < e.nodes; ++i) corners.emplace_back(shape[2 * i], shape[2 * i + 1]);
  const ElementStrain field = element_strain(corners, solid);
  const double poisson = std::visit([](const auto& law) { return law.poisson; }, solid.law);
  const double share = solid.plane == Plane::stress ? 1 : 1 + poisson;  // nothing expands across a plane strain
  const Eigen::Vector3d stress = solid.elastic() * Eigen::Vector3d(share, share, 0);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(2 * e.nodes, e.nodes);
  const Eigen::MatrixXd values = point_values(e);
  for (int p = 0; p < field.points; ++p) {
    const auto k = static_cast<std::size_t>(p);
    const Eigen::VectorXd force =
        field.area[k] * e.thickness * field.matrix[k].leftCols(2 * e.nodes).transpose() * stress;
    for (int j = 0; j < e.nodes; ++j) out.col(j) += values(p, j) * force;
  }
  return out;
}
Eigen::MatrixXd held_forces(const Model<3>& model, const SpaceElement& e) {
  const Solid& solid = model.solids[static_cast<std::size_t>(e.solid)];
  const int nodes = nodes_of(e);
  const double* const shape = &model.element_number[static_cast<std::size_t>(e.first_number)];
  std::vector<Vec3> places;
  for (int i = 0; i < nodes; ++i) places.emplace_back(shape[3 * i], shape[3 * i + 1], shape[3 * i + 2]);
  const SpaceElementStrain field = element_strain(e.shape, places, solid);
  const Eigen::MatrixXd values = point_values(e);
  const SpaceVector stress = elastic_in_space(solid) * (SpaceVector() << 1, 1, 1, 0, 0, 0).finished();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(3 * nodes, nodes);
  for (std::size_t p = 0; p < static_cast<std::size_t>(field.points); ++p) {
    const Eigen::VectorXd force = field.volume[p] * field.matrix[p].leftCols(3 * nodes).transpose() * stress;
    for (int j = 0; j < nodes; ++j) out.col(j) += values(static_cast<Eigen::Index>(p), j) * force;
  }
  return out;
}

/// The stiffness of an element, of 2 or 3 rows for each node [N/m].
Eigen::MatrixXd stiffness_of(const Model<2>& model, const Element& e) {
  const double* const k = &model.element_number[static_cast<std::size_t>(e.first_number + element_shape_numbers)];
  const Eigen::MatrixXd whole = Eigen::Map<const Eigen::MatrixXd>(k, 8, 8);
  return whole.topLeftCorner(2 * e.nodes, 2 * e.nodes);
}
Eigen::MatrixXd stiffness_of(const Model<3>& model, const SpaceElement& e) {
  const int rows = 3 * nodes_of(e);
  return Eigen::Map<const Eigen::MatrixXd>(&model.element_number[static_cast<std::size_t>(e.first_number + 2 * rows)],
                                           rows, rows);
}

/// The deformation of least norm that takes these forces: without rigid motion. The stiffness is singular by the rigid
/// motions alone.
Eigen::MatrixXd free_deformation(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& force) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> inverse;
  inverse.setThreshold(1e-10);
  inverse.compute(stiffness);
  return inverse.solve(force);
}

template <int D>
void add_element_shapes(Field& field, const Model<D>& model, const FieldBody& row) {
  const auto& elements = elements_of(model);
  field.free_shape_of.resize(std::max(field.free_shape_of.size(), elements.size()), -1);
  std::map<int, int> known;  // rows of Model::element_number, and of free_number
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto& e = elements[i];
    if (e.body != row.body) continue;
    FreeShape shape;
    shape.nodes = nodes_of(e), shape.dofs = D * shape.nodes;
    shape.reference = row.reference, shape.expansion = row.expansion;
    for (int j = 0; j < shape.nodes; ++j)
      shape.cell[static_cast<std::size_t>(j)] = row.cell_of(e.node[static_cast<std::size_t>(j)]);
    const auto found = known.find(e.first_number);
    if (found != known.end()) {
      shape.first_number = found->second;
    } else {
      shape.first_number = static_cast<int>(field.free_number.size());
      known.emplace(e.first_number, shape.first_number);
      const Eigen::MatrixXd s = row.expansion * free_deformation(stiffness_of(model, e), held_forces(model, e));
      field.free_number.insert(field.free_number.end(), s.data(), s.data() + s.size());
    }
    field.free_shape_of[i] = static_cast<int>(field.free_shapes.size());
    field.free_shapes.push_back(shape);
  }
}

/// True for a beam in the plane drawn to the left, whose left-hand side is its lower face.
bool is_drawn_back(const Model<2>& model, const Beam& beam) {
  const auto x = [&](int end) {
    return model.start_position[static_cast<std::size_t>(beam.node[static_cast<std::size_t>(end)])].x();
  };
  return x(1) - x(0) < -1e-9 * beam.length;
}
/// In space the second axis of a beam points to the top of its section.
bool is_drawn_back(const Model<3>& /*model*/, const Beam3& /*beam*/) {
  return false;
}

template <int D>
void add_free_beams(Field& field, const Model<D>& model, const FieldBody& row) {
  const auto& beams = beams_of(model);
  field.free_beam_of.resize(std::max(field.free_beam_of.size(), beams.size()), -1);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (beams[i].body != row.body) continue;
    FreeBeam beam;
    const int lower = is_drawn_back(model, beams[i]) ? 1 : 0;
    for (const std::size_t end : {0, 1}) {
      beam.lower[end] = row.cell_of(beams[i].node[end], lower);
      beam.upper[end] = row.cell_of(beams[i].node[end], 1 - lower);
    }
    beam.reference = row.reference, beam.expansion = row.expansion;
    beam.depth = row.depth, beam.length = beams[i].length;
    field.free_beam_of[i] = static_cast<int>(field.free_beams.size());
    field.free_beams.push_back(beam);
  }
}

}  // namespace

void add_free_shapes(Field& field, const Model<2>& model, const FieldBody& row) {
  if (row.layout == CellLayout::sections) return add_free_beams(field, model, row);
  for (const Element& e : model.elements) {
    const Solid& solid = model.solids[static_cast<std::size_t>(e.solid)];
    if (e.body == row.body && !solid.is_elastic() && solid.plane == Plane::strain)
      throw InputError(fmt::format(
          "heat of '{}': expansion in plane strain needs an elastic material, and this one yields; leave out "
          "expansion, or model it in space",
          model.bodies[static_cast<std::size_t>(row.body)].name));
  }
  add_element_shapes(field, model, row);
}

void add_free_shapes(Field& field, const Model<3>& model, const FieldBody& row) {
  if (row.layout == CellLayout::sections) return add_free_beams(field, model, row);
  add_element_shapes(field, model, row);
}

}  // namespace trilith
