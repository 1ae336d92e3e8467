// Builds a model in space from rigid solids: mass, principal axes, pieces, laws, and the checks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/space/polyhedron.hpp"
#include "model/model.hpp"
#include "model/space_builder/space_frame.hpp"
#include "model/space_builder/space_solid.hpp"

namespace trilith {

/// A rigid body in space: convex pieces where they stand, which share faces or nothing, and spheres.
struct SolidBody {
  std::string name;
  std::vector<Polyhedron> pieces = {};
  double density = 0;  ///< [kg/m3]
  bool fixed = false;
  Vec3 velocity = Vec3::Zero();              ///< of its centroid [m/s]
  Vec3 spin = Vec3::Zero();                  ///< [rad/s]
  int surface = 0;                           ///< whose law of contact it has, see SpaceBuilder::contact
  std::vector<Sphere> spheres = {};          ///< beside the pieces, where they stand; they may overlap each other
  std::optional<SolidMoments> moments = {};  ///< instead of those of pieces and spheres
  std::optional<Vec3> inertia = {};          ///< about x, y, z through its centroid, instead of its shape's [kg m2]
};

/// Mass, centroid and inertia of solids of one density that share no volume, and of the union of spheres.
struct SolidMass {
  double mass;               ///< [kg]
  Vec3 centroid;             ///< [m]
  PrincipalInertia inertia;  ///< about the centroid [kg m2]
};
SolidMass mass_of(const std::vector<Polyhedron>& pieces, double density, const std::vector<Sphere>& spheres = {});
SolidMass mass_of(const SolidMoments& moments, double density);

/// Writes thicknesses and the usual bounds of a model in space whose bodies and table of laws are there.
void complete_space(Model<3>& model);

/// Faces by which pieces of one body hang together are no surface.
void mark_inner_faces(std::vector<ConvexSolid>& pieces);

/// The width of a solid where it is least [m].
double solid_width(const ConvexSolid& solid);

/// Collects bodies and laws, then makes the model. Refuses with an InputError what is no body, with its name.
class SpaceBuilder {
 public:
  /// Weight per mass, by default none [m/s2].
  void gravity(const Vec3& field) { model_.gravity.field = field; }
  /// Returns its index. Throws InputError: a name taken, no piece, a piece that is not convex or is open (see
  /// check_convex), a density that is not above 0, numbers that are not finite.
  int add(const SolidBody& body);
  /// The same of a frame, which has been planned and so is one.
  int add(const SpaceFrameBody& body);
  /// ... and of a body of elements, whose mesh has been checked.
  int add(const SpaceMeshBody& body);
  /// The law between two surfaces, which are numbered from 0. Without one, bodies pass through each other. Throws
  /// InputError: a surface below 0.
  void contact(int surface_a, int surface_b, const ContactLaw& law, const std::string& name);
  [[nodiscard]] Model<3> build() const;

 private:
  struct Pairing {
    int a, b, law;
  };
  void add_node(const SolidBody& body, const SolidMass& mass);
  void add_pieces(const SolidBody& body, const SolidMass& mass);
  void add_piece(const ConvexSolid& piece, int node, int body);

  Model<3> model_;
  std::vector<Pairing> pairings_;
};

}  // namespace trilith
