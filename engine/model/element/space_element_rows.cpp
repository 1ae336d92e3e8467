#include "model/element/space_element_rows.hpp"

#include <algorithm>

#include "model/builder/shared_numbers.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith {
namespace {

std::vector<Vec3> nodes_at_start(const Model<3>& model, const SpaceElement& element) {
  std::vector<Vec3> nodes;
  for (int i = 0; i < info_of(element.shape).nodes; ++i)
    nodes.push_back(model.start_position[static_cast<std::size_t>(element.node[static_cast<std::size_t>(i)])]);
  return nodes;
}

void append(std::vector<double>& to, const Vec3& v) {
  to.insert(to.end(), v.data(), v.data() + 3);
}

void append_shape(std::span<const Vec3> nodes, ElementShape shape, std::vector<double>& numbers) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& x : nodes) mean += x;
  mean /= static_cast<double>(nodes.size());
  for (const Vec3& x : nodes) append(numbers, x - mean);
  const auto gradient = mean_gradients(shape, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) append(numbers, gradient[i]);
}

void append_points(const SpaceElementStrain& strain, int nodes, std::vector<double>& numbers) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(strain.points); ++p) {
    const double* const first = strain.matrix[p].data();
    numbers.insert(numbers.end(), first, first + 18 * nodes);
    numbers.push_back(strain.volume[p]);
  }
}

/// The fit of a whole element: mean position, mean gradients.
void append_whole_fit(Model<3>& model, const SpaceElement& element, std::span<const Vec3> nodes) {
  Fit fit;
  fit.nodes = static_cast<int>(nodes.size());
  std::copy_n(element.node.begin(), nodes.size(), fit.node.begin());
  fit.first_number = static_cast<int>(model.fit_number.size());
  const auto gradient = mean_gradients(element.shape, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    model.fit_number.push_back(1.0 / fit.nodes);
    append(model.fit_number, gradient[i]);
  }
  model.fits.push_back(fit);
}

void append_face_fit(Model<3>& model, const SpaceElement& element, std::span<const Vec3> nodes, int face) {
  const std::span<const int> on_face = info_of(element.shape).nodes_of_face(face);
  const FaceFit found = fit_face(element.shape, nodes, face);
  Fit fit;
  fit.nodes = static_cast<int>(on_face.size()), fit.is_face = true;
  fit.first_number = static_cast<int>(model.fit_number.size());
  for (std::size_t i = 0; i < on_face.size(); ++i) {
    fit.node[i] = element.node[static_cast<std::size_t>(on_face[i])];
    model.fit_number.push_back(found.mean[i]);
    append(model.fit_number, Vec3(found.gradient[i].x(), found.gradient[i].y(), 0));
  }
  model.fits.push_back(fit);
}

}  // namespace

SpaceElementStrain element_strain(ElementShape shape, std::span<const Vec3> nodes, const Solid& solid) {
  return solid.form == ElementForm::plain ? plain_strain(shape, nodes)
                                          : assumed_strain(shape, nodes, elastic_in_space(solid));
}

void append_element(Model<3>& model, SpaceElement element, double density) {
  const std::vector<Vec3> nodes = nodes_at_start(model, element);
  const Solid& solid = model.solids[static_cast<std::size_t>(element.solid)];
  const SpaceElementStrain strain = element_strain(element.shape, nodes, solid);
  // Also for inelastic solids: damping and the stability limit use it.
  const Eigen::MatrixXd stiffness = element_stiffness(element.shape, strain, elastic_in_space(solid));
  ElementNumbers numbers{{}, 3 * nodes.size(), rounding_of(std::span<const Vec3>(nodes))};
  append_shape(nodes, element.shape, numbers.all);
  numbers.all.insert(numbers.all.end(), stiffness.data(), stiffness.data() + stiffness.size());
  if (!solid.is_elastic()) append_points(strain, static_cast<int>(nodes.size()), numbers.all);
  const auto is_like = [&](const SpaceElement& e) { return e.shape == element.shape && e.solid == element.solid; };
  element.first_number = shared_numbers(model.space_elements, is_like, numbers, model.element_number);
  if (!solid.is_elastic()) {
    element.first_point = model.plastic_points;
    model.plastic_points += strain.points;
  }
  const ElementVolume volume = node_shares(element.shape, nodes);
  element.volume = volume.volume;
  std::array<double, max_space_nodes> mass = volume.share;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mass[i] *= density * volume.volume;
    model.mass[static_cast<std::size_t>(element.node[i])] += mass[i];
  }
  // The largest frequency of any single element bounds the frequencies of all. The damping of a solid is its stiffness
  // times a time.
  RateBound& bound = model.element_bound[static_cast<std::size_t>(element.body)];
  const double most = largest_frequency2(stiffness, std::span<const double>(mass).first(nodes.size()));
  bound.stiffness = std::max(bound.stiffness, most);
  bound.damping = std::max(bound.damping, solid.damping() * most);
  model.element_rate.push_back(most);
  model.space_elements.push_back(element);
}

void append_element_piece(Model<3>& model, const SpaceElement& element, std::span<const std::uint8_t> surface) {
  const ElementShapeInfo& info = info_of(element.shape);
  const std::vector<Vec3> nodes = nodes_at_start(model, element);
  const auto piece = static_cast<std::size_t>(model.pieces());
  model.piece_fit.resize(piece, -1);
  model.piece_fit.push_back(static_cast<int>(model.fits.size()));
  append_whole_fit(model, element, nodes);
  std::vector<Fitted> faces;
  ConvexSolid solid;
  for (int f = 0; f < info.faces; ++f) {
    append_face_fit(model, element, nodes, f);
    faces.push_back(fitted(model, model.fits.back(), model.start_position, model.start_velocity));
    solid.shape.faces.add(info.corners_of_face(f));
  }
  solid.shape.corners.assign(static_cast<std::size_t>(info.corners), Vec3::Zero());
  place_between(solid, faces, solid.shape.corners, solid.normals);
  for (Vec3& x : solid.shape.corners) x -= nodes[0];
  solid.edges = solid_edges(solid.shape.faces);
  solid.surface.assign(surface.begin(), surface.end());
  solid.size = solid_size(solid.shape.corners), solid.may_repeat = false;
  for (std::size_t c = 0; c < static_cast<std::size_t>(info.corners); ++c) {
    model.corner_skin.push_back(static_cast<int>(model.skin_place.size()));
    model.skin_place.push_back(Vec3::Zero());
    model.skin_node.push_back(element.node[c]), model.skin_turn.push_back(element.node[c]);
  }
  model.piece_body.push_back(element.body);
  model.piece_first.push_back(static_cast<int>(model.corner_skin.size()));
  model.piece_thickness.push_back(solid_width(solid));
  model.piece_solid.push_back(std::move(solid));
}

}  // namespace trilith
