#include "bindings/model/built_model.hpp"

#include <utility>

#include "model/pose.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith::script {

template <int D>
Model<D> BuiltModel<D>::lone_body(int body) const {
  Builder alone;
  if constexpr (D == 2) alone.thickness = builder.thickness;
  alone.gravity = Vec<D>::Zero();
  for (const Material& m : this->materials) alone.add_material(m);
  Spec own = spec(body);
  own.cracks = {};  // their law belongs to this model
  alone.add_body(std::move(own));
  return alone.build();
}

namespace {

Vec2 centroid_of(const BodySpec& spec) {
  return moments_of(spec).centroid;
}
Vec3 centroid_of(const SolidSpec& spec) {
  return mass_of(spec.pieces, 1, spec.spheres).centroid;
}

}  // namespace

/// A part that a rewind has removed from the builder is none.
template <int D>
int BuiltModel<D>::first_part(int body) const {
  const int part = spec(body).first_part;
  return part >= 0 && part + 1 < body_count() && spec(part).cracked_from == body ? part : -1;
}

template <int D>
int BuiltModel<D>::part_with(int body, const Vec<D>& at) const {
  for (int part = first_part(body); part >= 0; part = first_part(body)) {
    const CrackPlane<D>& plane = spec(body).parted_at;
    body = plane.normal.dot(at - plane.point) <= 0 ? part : part + 1;
  }
  return body;
}

template <int D>
int BuiltModel<D>::heir_of(int body) const {
  return first_part(body) < 0 ? -1 : part_with(body, centroid_of(spec(body)));
}

template class BuiltModel<2>;
template class BuiltModel<3>;

double PlaneModel::inertia_of(int body) {
  return has_body(body) ? body_inertia(if_built()->model(), body) : body_inertia(lone_body(body), 0);
}

}  // namespace trilith::script
