// Heat in bodies: cells, conduction, expansion, exchange with surroundings (field/field.hpp), from a model.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "field/field.hpp"
#include "load/list.hpp"
#include "model/model.hpp"

namespace trilith {

/// Thermal properties of a body.
struct HeatSpec {
  double conductivity = 0;   ///< not below 0 [W/(m K)]
  double heat_capacity = 0;  ///< above 0 [J/(kg K)]
  double expansion = 0;      ///< not below 0 [1/K]
  double temperature = 0;    ///< at the start [degC]
  double reference = 0;      ///< without thermal strain [degC]
  double depth = 0;          ///< of the sections of a frame; required by frames [m]
  double density = 0;        ///< of its material, for the area of the sections of a frame [kg/m3]
};

/// Gives a body cells. Throws InputError for numbers out of range, a body that has cells already, expansion of a rigid
/// body, and a body without mass.
template <int D>
void add_heat(Field& field, const Model<D>& model, int body, const HeatSpec& spec);

/// Exchange with a surrounding at faces at the start.
struct HeatExchangeSpec {
  std::string name;
  FieldCourse course;
  std::optional<double> exchange;  ///< above 0 [W/(m2 K)]; none: the faces have the temperature of the surrounding
};

/// Faces with one surrounding.
template <int D>
struct ExchangeFaces {
  int surrounding = -1;
  std::optional<double> exchange;  ///< see HeatExchangeSpec
  std::vector<WetFace<D>> faces;
};
/// Field::faces of heat, in the order of their declaration. Sections of frames have none.
template <int D>
struct HeatFaces : FieldFaces {
  std::vector<ExchangeFaces<D>> rows;
};
/// A copy of the faces of a field, to change.
template <int D>
HeatFaces<D> heat_faces(const Field& field);
/// Adds the exchange of the cells at a face of a body with cells.
template <int D>
void add_exchange_face(Field& field, const Model<D>& model, const ExchangeFaces<D>& of, const WetFace<D>& face);

/// Replaces the cells of a body by the cells of its two parts, with the same properties: the capacity of each cell is
/// in proportion to the mass of its node. `source`: for each node of the first part, then of the second, the node of
/// the body whose temperature it has. Faces of the parts in Field::faces exchange heat as before, and contacts of the
/// body have their conductance as contacts of the parts. `values`: of the field; may be empty. A body without cells
/// changes its contacts alone.
template <int D>
void divide_heat(Field& field, const Model<D>& model, int body, const std::array<int, 2>& parts,
                 const std::vector<int>& source, FieldState& values);

/// Throws InputError for a name that exists, an invalid course, a body without cells, and no faces.
template <int D>
void add_heat_exchange(Field& field, const Model<D>& model, const HeatExchangeSpec& spec,
                       const std::vector<WetFace<D>>& faces);
/// The energy that friction of contacts dissipates heats the bodies from now on; it is counted as a surrounding without
/// exchange. Throws InputError if a surrounding has its name.
void add_friction_heat(Field& field);
/// The upper (`upper`) and the lower (`lower`) faces of a frame, as faces of the surrounding of that name, which is
/// added if there is none.
void add_frame_exchange(Field& field, const std::vector<double>& node_length, const HeatExchangeSpec& spec, int body,
                        bool lower, bool upper);

/// Half the length of the beams at each node of a frame [m].
template <int D>
std::vector<double> beam_lengths(const Model<D>& model, int body);

}  // namespace trilith
