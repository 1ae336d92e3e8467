#include "bindings/model/space_model.hpp"

namespace trilith::script {

Model<3> SpaceModel::lone_body(int body) const {
  SolidModelBuilder alone;
  alone.gravity = Vec3::Zero();
  for (const Material& m : materials) alone.add_material(m);
  alone.add_body(spec(body));
  return alone.build();
}

}  // namespace trilith::script
