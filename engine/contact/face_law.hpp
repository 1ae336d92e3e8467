// A contact law's numbers as the kernels of contact want them.
#pragma once

namespace trilith {

/// What a law's faces can hold beside friction.
enum class Bond {
  none,
  brittle,   ///< a bond that is there or lost
  softening  ///< a bond that loses its strength by and by
};

/// Stiffness and strength are those of the law times the thickness.
struct FaceLaw {
  double kn, ks;             ///< [N/m per m of length]
  double mu, beta;           ///< [1], [s]
  double cohesion, tension;  ///< [N per m of length]
  double dt;                 ///< the step [s]
  bool loss_by_point;

  // A softening bond alone.
  double last_opening = 0;    ///< at which no tension is left [m]; 0: does not soften
  double last_slip = 0;       ///< at which no cohesion is left [m]
  double dilation = 0;        ///< tan of the dilatancy angle
  double dilation_slip = 0;   ///< up to which sliding opens the joint [m]
  double crushing = 0;        ///< mean overlap at which a pressed joint crushes [m]; 0: never
  double crushing_depth = 0;  ///< by which it can crush [m]

  /// Loss of shear strength per tension [1]: that of the Coulomb line, but such that cohesion and tension are both
  /// reached where tension is beyond the line's apex.
  [[nodiscard]] double tension_slope() const { return mu * tension > cohesion ? cohesion / tension : mu; }
  /// Opening at which the tension of an undamaged bond is reached [m].
  [[nodiscard]] double first_opening() const { return tension / kn; }
};

}  // namespace trilith
