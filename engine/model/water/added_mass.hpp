// Makers of the added mass of water (load/water/added_mass.hpp).
#pragma once

#include <optional>
#include <string>

#include "load/list.hpp"
#include "model/model.hpp"

namespace trilith {

/// Pressure of incompressible water of depth H on an upright rigid face that accelerates, at a height z above the bed.
/// `exact`: Westergaard's series 8 rho H / pi^2 sum of (-1)^((n-1)/2) / n^2 cos(n pi z / 2H) over odd n. `parabola`:
/// his approximation 7/8 rho sqrt(H (H - z)). H. M. Westergaard, "Water pressures on dams during earthquakes", Trans.
/// ASCE 98, 1933. `cylinder`: rho pi R^2 per length of a slender cylinder, in every horizontal direction.
enum class AddedMassForm { exact, parabola, cylinder };

struct AddedMassSpec {
  std::string name;
  AddedMassForm form = AddedMassForm::exact;
  double level = 0, bed = 0;  ///< elevations of the surface and of the bed at the start [m]
  std::optional<double> from,
      to;                    ///< elevations between which the body has its face; default: the bed and the level [m]
  double density = 1000;     ///< [kg/m3]
  Vec3 side = Vec3::Zero();  ///< outward normal of the face, along a horizontal axis; (x, 0, 0) in the plane
  double width = 0;          ///< in space: of the face [m]
  double radius = 0;         ///< of the cylinder [m]
};

/// Mass of a strip from z0 to z1 above the bed, for a unit of density and width, and its first moment about the bed.
struct StripMass {
  double mass = 0, moment = 0;  ///< [m2], [m3]
};
StripMass strip_mass(AddedMassForm form, double depth, double z0, double z1);

/// Directed masses on a body, in strips of equal height. They act across the face alone. Throws InputError for a level
/// that is not above the bed, a face that is not upright over the depth, and in space a body of elements.
template <int D>
AddedMass<D> make_added_mass(const Model<D>& model, int body, const AddedMassSpec& spec);

}  // namespace trilith
