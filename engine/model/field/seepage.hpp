// Water in joints: a field of pressure heads (field/joint_flow.hpp), from a
// model.
#pragma once

#include <optional>
#include <string>

#include "field/field.hpp"
#include "model/model.hpp"

namespace trilith {

/// A joint between two bodies, or a fissure of given length.
struct SeepageSpec {
  std::string name;
  int upper = -1, lower = -1;         ///< bodies; -1: a fissure
  std::optional<Vec2> heel;           ///< of a joint: a point at its first end; default: the left end [m]
  std::optional<Vec3> heel_in_space;  ///< in space a point at its first side;
                                      ///< default: the side with the least x [m]
  double length = 0;                  ///< of a fissure [m]
  double width = 1;                   ///< of a fissure, out of the plane [m]
  std::array<double, 2> elevation{};  ///< of the ends of a fissure [m]
  std::array<double, 2> aperture{};   ///< of both ends, without load, above 0 [m]
  double stiffness = 0;               ///< of the walls of a fissure, normal; 0: rigid walls [Pa/m]
  int divisions = 32;                 ///< number of cells, at least 1
  std::string from, to;               ///< names of its nodes
  bool filled = true;                 ///< water fills it at the start
  double density = 1000;              ///< [kg/m3]
  double viscosity = 1e-3;            ///< [Pa s]
  double bulk_modulus = 2.2e9;        ///< [Pa]
  double crack_aperture = 0;          ///< see FlowJoint [m]
};

/// Adds a joint or fissure, and its nodes where they are new. Throws InputError for numbers out of range, a name that
/// exists, bodies without a common face, and nodes that lie at other elevations. In space it also throws for bodies
/// that deform and joints that are not one rectangle.
template <int D>
void add_seepage(Field& field, const Model<D>& model, const SeepageSpec& spec);

/// The head at a node: a course, or without values the level of the water of
/// the surrounding's name. Throws InputError for an unknown node, a node that
/// has a head already, an invalid course, and an unknown water.
template <int D>
void add_seepage_head(Field& field, const Model<D>& model, const std::string& node, const FieldSurrounding& head);

/// Heads of the surroundings at the time of a field and of a model
/// [surrounding] [m].
template <int D>
std::vector<double> seepage_heads(const Field& field, const Model<D>& model, double clock, double time);

}  // namespace trilith
