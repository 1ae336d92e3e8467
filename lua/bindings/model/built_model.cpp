#include "bindings/model/built_model.hpp"

#include "model/pose.hpp"

namespace trilith::script {

template <int D>
Model<D> BuiltModel<D>::lone_body(int body) const {
  Builder alone;
  if constexpr (D == 2) alone.thickness = builder.thickness;
  alone.gravity = Vec<D>::Zero();
  for (const Material& m : this->materials) alone.add_material(m);
  alone.add_body(spec(body));
  return alone.build();
}

template class BuiltModel<2>;
template class BuiltModel<3>;

double PlaneModel::inertia_of(int body) {
  return has_body(body) ? body_inertia(if_built()->model(), body) : body_inertia(lone_body(body), 0);
}

}  // namespace trilith::script
