// The model in space that a model of the plane is, with its thickness. No Lua here.
#pragma once

#include <memory>
#include <string>

#include "bindings/model/plane_model.hpp"
#include "bindings/model/space_model.hpp"

namespace trilith::script {

/// How a model of the plane is taken into space.
struct PlaneExtrusion {
  bool held = true;  ///< bodies stay in the plane: none moves along y or turns about x or z
};

/// A model whose bodies reach over their thickness about y = 0; x stays and the plane's y is z. Materials, laws and
/// where they hold, bearings, seats, supports, loads and velocities at the start are those of `plane` as it was given,
/// whatever stages it has run; histories, events and motions are not taken over. Elements in plane stress may grow
/// thicker where they are held, those in plane strain may not; frames are those of model/builder/extruded_frame.hpp.
std::shared_ptr<SpaceModel> extruded_model(const PlaneModel& plane, const std::string& name,
                                           const PlaneExtrusion& extrusion);

}  // namespace trilith::script
