// Names of the fields of frames that hold temperatures and water in joints.
#pragma once

namespace trilith::results {

inline constexpr const char* node_temperature = "node_temperature";
inline constexpr const char* node_temperature_difference = "node_temperature_difference";
inline constexpr const char* water_cell = "water_cell";
inline constexpr const char* water_pressure = "water_pressure";
inline constexpr const char* water_fill = "water_fill";
inline constexpr const char* water_aperture = "water_aperture";

/// Temperature of a node without one: below all temperatures [degC].
inline constexpr double no_temperature = -273.15;

}  // namespace trilith::results
