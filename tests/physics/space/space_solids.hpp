// Deformable bodies in space for the physics tests.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "assembly/element/element_stress.hpp"
#include "model/pose.hpp"
#include "model/space_builder/space_solid.hpp"
#include "physics/space/space_frames.hpp"

namespace trilith::testing {

inline constexpr std::array all_shapes{ElementShape::brick, ElementShape::tetrahedron,
                                       ElementShape::quadratic_tetrahedron, ElementShape::wedge};

inline Material elastic_in(const std::string& name, double density, double young, double poisson, double damping = 0,
                           ElementForm form = ElementForm::assumed) {
  return {name, density, Solid{LinearElastic{young, poisson, damping}, Plane::strain, form}};
}

/// A box divided into elements.
inline SolidSpec box_of(const std::string& name, const Polyhedron& box, const std::string& material,
                        const std::array<int, 3>& divisions, ElementShape shape = ElementShape::brick) {
  SolidSpec spec;
  spec.name = name, spec.pieces = {box}, spec.material = material, spec.floating = true;
  spec.form = {BodyKind::mesh, divisions, shape};
  return spec;
}

/// A model of one body without weight or contact.
inline Model<3> alone_in_space(const Material& material, SolidSpec spec) {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  builder.add_material(material);
  spec.material = material.name;
  builder.add_body(std::move(spec));
  return builder.build();
}

/// The elements of a box whose inner nodes are displaced by up to `by` at random; skin nodes keep their positions.
inline SpaceMesh distorted_box(const Vec3& sides, const std::array<int, 3>& divisions, ElementShape shape, double by) {
  const Vec3 low = Vec3::Zero();
  SpaceMesh mesh = mesh_of(box_solid(low, sides), {BodyKind::mesh, divisions, ElementShape::brick}, "box");
  std::mt19937_64 bits(11);
  for (Vec3& x : mesh.node) {
    bool inner = true;
    for (int k = 0; k < 3; ++k) inner = inner && x[k] > 1e-9 && x[k] < sides[k] - 1e-9;
    const Vec3 moved = by * random_in_ball(bits);
    if (inner) x += moved;
  }
  return divided_into(shape, mesh);
}

inline SolidSpec mesh_spec(const std::string& name, const std::string& material, SpaceMesh mesh) {
  SolidSpec spec;
  spec.name = name, spec.material = material, spec.floating = true;
  spec.mesh = std::move(mesh);
  return spec;
}

/// Largest difference of the stress at any point of any element from `expected`, over its size.
inline double stress_error(const Model<3>& model, const State<3>& state, const SpaceVector& expected) {
  double most = 0;
  for (int e = 0; e < static_cast<int>(model.space_elements.size()); ++e) {
    const SpaceElementStress s = element_stress(model, state, e);
    for (int p = 0; p < s.points; ++p)
      most = std::max(most, (s.at_point[static_cast<std::size_t>(p)] - expected).cwiseAbs().maxCoeff());
  }
  return most / expected.cwiseAbs().maxCoeff();
}

inline double largest_of(const std::vector<Vec3>& vectors) {
  double most = 0;
  for (const Vec3& v : vectors) most = std::max(most, v.norm());
  return most;
}

}  // namespace trilith::testing
