// Moment-curvature curves and normal force-moment interaction of a section of fibres, under loads that only grow.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "element/section/fibre_section.hpp"

namespace trilith {

/// Largest strains of any fibre, of either sign, at which a curve ends [1].
struct SectionLimits {
  double compression = 0.01, tension = 0.05;
};

struct SectionPoint {
  double curvature = 0;  ///< positive with tension at the bottom [1/m]
  double axial = 0;      ///< strain of the centroid, tension above 0 [1]
  double moment = 0;     ///< [N m]
};

struct MomentCurvature {
  std::vector<SectionPoint> points;     ///< from curvature 0
  std::optional<SectionPoint> yield;    ///< where the first fibre yields
  std::optional<SectionPoint> largest;  ///< where the magnitude of the moment is largest
  /// Why it ends: "curvature", "compression" or "tension" (the limits), "no equilibrium" (the section does not carry
  /// the normal force beyond the last point).
  std::string end;
};

/// Moments of a section under a constant normal force [N], tension above 0, for curvatures from 0 to `curvature` [1/m]
/// of either sign in `steps` equal steps, or until a limit. The points are an equilibrium of the normal force to 1e-9
/// of the largest force of the fibres. `yield` is found by bisection within its step. There is no point if the section
/// does not carry the normal force without bending. `steps`: at least 1.
MomentCurvature moment_curvature(const FibreSection& section, double normal, double curvature, int steps,
                                 const SectionLimits& limits = {});

/// Curvature at which both limits would be reached together over the depth of the section: no curve is longer [1/m].
double longest_curvature(const FibreSection& section, const SectionLimits& limits = {});

/// A corner of the interaction curve: the largest moments at a normal force.
struct InteractionPoint {
  double normal = 0;   ///< [N]
  double sagging = 0;  ///< bottom in tension, at least 0 [N m]
  double hogging = 0;  ///< top in tension, at most 0 [N m]
};

/// From the largest compression to the largest tension without bending, at `points` equal distances (3 or more).
/// Moments are the largest of the moment-curvature curve within the limits. Both ends have a moment of 0 where the
/// section is symmetric, otherwise the moment of its eccentric resultant.
std::vector<InteractionPoint> interaction(const FibreSection& section, int points, const SectionLimits& limits = {});

}  // namespace trilith
