#include "bindings/model/plane_model.hpp"

#include "model/pose.hpp"

namespace trilith::script {

Model<2> PlaneModel::lone_body(int body) const {
  ModelBuilder alone;
  alone.thickness = builder.thickness;
  alone.gravity = Vec2::Zero();
  for (const Material& m : materials) alone.add_material(m);
  alone.add_body(spec(body));
  return alone.build();
}

double PlaneModel::inertia_of(int body) {
  return has_body(body) ? body_inertia(if_built()->model(), body) : body_inertia(lone_body(body), 0);
}

}  // namespace trilith::script
