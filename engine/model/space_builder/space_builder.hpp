// Builds a model in space from rigid solids: mass, principal axes, pieces, laws, and checks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/space/polyhedron.hpp"
#include "model/builder/frame_rows.hpp"
#include "model/model.hpp"
#include "model/names.hpp"
#include "model/space_builder/space_solid.hpp"

namespace trilith {

/// A rigid body in space: convex pieces in their initial positions, which share faces or nothing, and spheres.
struct SolidBody {
  std::string name;
  std::vector<Polyhedron> pieces = {};
  double density = 0;  ///< [kg/m3]
  bool fixed = false;
  Vec3 velocity = Vec3::Zero();              ///< of its centroid [m/s]
  Vec3 spin = Vec3::Zero();                  ///< [rad/s]
  int surface = 0;                           ///< index of its surface, see SpaceBuilder::contact
  std::vector<Sphere> spheres = {};          ///< in addition to the pieces, at the start; they may overlap
  std::optional<SolidMoments> moments = {};  ///< instead of the moments of pieces and spheres
  std::optional<Vec3> inertia = {};          ///< about x, y, z through its centroid, instead of its shape's [kg m2]
};

/// Mass, centroid and inertia of solids with one density that share no volume, and of the union of spheres.
struct SolidMass {
  double mass;               ///< [kg]
  Vec3 centroid;             ///< [m]
  PrincipalInertia inertia;  ///< about the centroid [kg m2]
};
SolidMass mass_of(const std::vector<Polyhedron>& pieces, double density, const std::vector<Sphere>& spheres = {});
SolidMass mass_of(const SolidMoments& moments, double density);

/// Computes thicknesses and default bounds of a model in space that has its bodies and table of laws.
void complete_space(Model<3>& model);

/// Marks faces by which pieces of one body are connected as inner cuts.
void mark_inner_faces(std::vector<ConvexSolid>& pieces);

/// The least width of a solid [m].
double solid_width(const ConvexSolid& solid);

/// Collects bodies and laws, then makes the model. Throws InputError, with the name, for an invalid body.
class SpaceBuilder {
 public:
  /// Gravity; default: none [m/s2].
  void gravity(const Vec3& field) { model_.gravity.field = field; }
  /// Returns its index. Throws InputError for: a name in use, no piece, a piece that is not convex or is open (see
  /// check_convex), a density that is not above 0, numbers that are not finite.
  int add(const SolidBody& body);
  /// For a frame that has been planned, and so is valid.
  int add(const SpaceFrameBody& body);
  /// For a body of elements whose mesh has been checked.
  int add(const SpaceMeshBody& body);
  /// Sets the law between two surfaces, which are numbered from 0. Without a law, bodies pass through each other.
  /// Throws InputError for a negative surface index.
  void contact(int surface_a, int surface_b, const ContactLaw& law, const std::string& name);
  [[nodiscard]] Model<3> build() const;

 private:
  struct Pairing {
    int a, b, law;
  };
  void require_new_body(const std::string& name);
  void add_node(const SolidBody& body, const SolidMass& mass);
  void add_pieces(const SolidBody& body, const SolidMass& mass);
  void add_piece(const ConvexSolid& piece, int node, int body);

  Model<3> model_;
  RowNames names_;  ///< of the bodies
  std::vector<Pairing> pairings_;
};

}  // namespace trilith
