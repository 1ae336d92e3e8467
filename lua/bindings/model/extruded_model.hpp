// Conversion of a plane model with its thickness to a model in space. No Lua here.
#pragma once

#include <memory>
#include <string>

#include "bindings/model/built_model.hpp"

namespace trilith::script {

/// Options of the conversion.
struct PlaneExtrusion {
  bool held = true;  ///< bodies remain in the plane: none moves along y or rotates about x or z
};

/// A model whose bodies extend over their thickness about y = 0; the plane's y becomes z. Materials, laws with their
/// pairs, bearings, seats, supports, loads and initial velocities are taken from `plane` as it was given, independent
/// of its stages. Histories, events and motions are not copied. With `held`, elements in plane stress may grow thicker,
/// elements in plane strain may not. Frames follow model/builder/extruded_frame.hpp.
std::shared_ptr<SpaceModel> extruded_model(const PlaneModel& plane, const std::string& name,
                                           const PlaneExtrusion& extrusion);

}  // namespace trilith::script
