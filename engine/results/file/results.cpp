#include "results/file/results.hpp"

#include <cassert>

namespace trilith::results {

void Header::add_rigid_body(BodyRow body, std::span<const double> position, std::span<const double> rotation,
                            double mass, std::span<const double> inertia, std::span<const double> outline) {
  assert(position.size() == static_cast<std::size_t>(dim));
  assert(rotation.size() == static_cast<std::size_t>(rotation_width(dim)));
  assert(inertia.size() == static_cast<std::size_t>(spin_width(dim)));
  assert(outline.size() % static_cast<std::size_t>(dim) == 0);
  const auto node = static_cast<std::int32_t>(node_mass.size());
  const auto points = static_cast<std::int32_t>(outline.size() / static_cast<std::size_t>(dim));
  body.first_node = node;
  body.node_count = 1;
  body.first_vertex = static_cast<std::int32_t>(vertex_node.size());
  body.vertex_count = points;
  bodies.push_back(std::move(body));
  node_position.insert(node_position.end(), position.begin(), position.end());
  node_rotation.insert(node_rotation.end(), rotation.begin(), rotation.end());
  node_mass.push_back(mass);
  node_inertia.insert(node_inertia.end(), inertia.begin(), inertia.end());
  vertices.insert(vertices.end(), outline.begin(), outline.end());
  vertex_node.insert(vertex_node.end(), static_cast<std::size_t>(points), node);
}

void Header::add_solid_body(BodyRow body, std::span<const double> position, std::span<const double> rotation,
                            double mass, std::span<const double> inertia, std::span<const double> corners,
                            const FaceLoops& faces) {
  assert(dim == 3);
  if (face_first.empty()) face_first.push_back(0);
  body.first_face = static_cast<std::int32_t>(face_count());
  body.face_count = faces.count();
  const auto base = static_cast<std::int32_t>(vertex_node.size()), loops = face_first.back();
  for (const int corner : faces.corner) face_vertex.push_back(base + corner);
  for (int face = 1; face <= faces.count(); ++face) face_first.push_back(loops + faces.start[face]);
  add_rigid_body(std::move(body), position, rotation, mass, inertia, corners);
}

void Header::add_sphere(int corner, double radius) {
  assert(dim == 3 && !bodies.empty() && corner < bodies.back().vertex_count);
  sphere_vertex.push_back(bodies.back().first_vertex + corner);
  sphere_radius.push_back(radius);
}

std::vector<double> Header::vertex_radius() const {
  if (sphere_vertex.empty()) return {};
  std::vector<double> radius(vertex_node.size());
  for (std::size_t s = 0; s < sphere_vertex.size(); ++s)
    radius[static_cast<std::size_t>(sphere_vertex[s])] = sphere_radius[s];
  return radius;
}

}  // namespace trilith::results
