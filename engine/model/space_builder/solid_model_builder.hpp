// Builds a Model in space from bodies, materials, laws and motions, and checks it once; the plane counterpart is
// ModelBuilder.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/space/polyhedron.hpp"
#include "model/builder/bearing_spec.hpp"
#include "model/builder/frame_rows.hpp"
#include "model/contact/contact_rules.hpp"
#include "model/crack_planes.hpp"
#include "model/material.hpp"
#include "model/model.hpp"
#include "model/names.hpp"
#include "model/space_builder/space_solid.hpp"
#include "model/state.hpp"

namespace trilith {

/// Specification of a body in space: rigid, a frame, or of finite elements. At most one of density and mass may be
/// given; the default is the material's density.
struct SolidSpec {
  std::string name;                ///< unique
  std::vector<Polyhedron> pieces;  ///< convex, in their initial positions; they share faces or nothing [m]
  std::string material;
  std::vector<std::string> groups;
  std::optional<double> density;                ///< [kg/m3]
  std::optional<double> mass;                   ///< [kg]
  std::array<Support, 6> support{};             ///< x, y, z, and rotations about them
  Vec3 velocity = Vec3::Zero();                 ///< of the centroid at the start [m/s]
  Vec3 spin = Vec3::Zero();                     ///< at the start [rad/s]
  Vec3 load = Vec3::Zero();                     ///< steady force at the centroid [N]
  bool floating = false;                        ///< may start unsupported
  std::vector<Sphere> spheres = {};             ///< in addition to the pieces, at the start; they may overlap
  std::optional<SpaceFrameSpec> frame = {};     ///< instead of pieces and spheres: `pieces` become its initial skin
  SpaceForm form = {};                          ///< rigid, or the elements into which its one piece is divided
  std::optional<SpaceMesh> mesh = {};           ///< its elements, instead of `form`; `pieces` become its skin
  std::vector<SpaceNodeSupport> supports = {};  ///< for some nodes of a deformable body, or of a frame
  std::optional<SolidMoments> moments = {};     ///< of a rigid body, instead of the pieces' moments
  std::optional<Vec3> inertia = {};  ///< rigid body: about x, y, z through its centroid, at the start [kg m2]
  CrackSpec<3> cracks = {};          ///< planes on which it may crack; rigid of one piece, or elements
  int cracked_from = -1;             ///< the body that it is a part of, or -1
  int first_part = -1;               ///< once it has cracked: the part behind its plane; the next body is the other
  CrackPlane<3> parted_at = {};      ///< this plane

  [[nodiscard]] bool deforms() const { return mesh.has_value() || form.kind != BodyKind::rigid; }
  [[nodiscard]] BodyKind kind() const { return frame ? BodyKind::frame : mesh ? mesh_kind(*mesh) : form.kind; }
};

class SolidModelBuilder {
 public:
  Vec3 gravity{0, 0, -standard_gravity};  ///< [m/s2]
  double mass_damping = 0;                ///< [1/s]
  double impact_speed = 0.5;              ///< [m/s]
  double apart_time = 0.02;               ///< [s]
  double still_speed = 2.54e-7;           ///< [m/s]
  double still_time = 0.5;                ///< [s]
  double overlap_allowed = 1e-6;          ///< largest overlap at the start, relative to the smaller body's size
  /// true: an unsupported body is a fault when it is built or added; false: only when the caller asks
  /// (standing_faults).
  bool judge_standing = true;
  Bounds<3> bounds;  ///< infinite sides use default_bounds

  // Each throws InputError, and leaves the builder unchanged.
  void add_material(const Material& material);
  void add_body(SolidSpec spec);
  /// See ContactRules.
  void add_law(const std::string& name, const ContactLaw& law);
  void set_contact(const std::string& a, const std::string& b, const std::string& law) {
    rules_.set_contact(a, b, law);
  }
  /// Replaces the laws and statements so far by another model's.
  void take_contacts(const ContactRules& rules);
  void add_bearing(const BearingSpecOf<3>& spec);
  void add_seat(const SeatSpecOf<3>& spec);
  /// Adds a line to notes(): a repair or choice made before bodies were added.
  void note(const std::string& line) { notes_.push_back(line); }

  /// Checks everything and makes the model. Throws InputError with the first of faults().
  Model<3> build();
  /// As ModelBuilder::extended and ModelBuilder::shorten.
  Model<3> extended(const Model<3>& model, const State<3>& state);
  void shorten(std::size_t bodies, std::size_t bearings, std::size_t seats);
  /// As ModelBuilder::cracking, ModelBuilder::crack and ModelBuilder::with_parts.
  [[nodiscard]] std::vector<CrackingBody<3>> cracking(const Model<3>& model) const;
  void crack(const Model<3>& model, int body, const CrackSection<3>& section);
  [[nodiscard]] Model<3> with_parts(const Model<3>& model) const;
  /// All faults that prevent build(), a line for each. Empty if there is none.
  [[nodiscard]] std::vector<std::string> faults() const;
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] const std::vector<SolidSpec>& bodies() const { return bodies_; }
  [[nodiscard]] const std::vector<BearingSpecOf<3>>& bearings() const { return bearings_; }
  [[nodiscard]] std::vector<std::string> law_names() const { return rules_.law_names(); }

 private:
  Model<3> assemble(std::vector<std::string>& faults, std::vector<std::string>& notes) const;
  Model<3> assemble_bodies(std::vector<std::string>& faults) const;
  [[nodiscard]] double density_of(const SolidSpec& spec) const;
  void check_frame(SolidSpec& spec, const std::string& owner) const;
  void check_mesh_body(SolidSpec& spec, const std::string& owner);
  static void check_cracks(const SolidSpec& spec, const std::string& owner);
  void check_crack_laws(std::vector<std::string>& faults) const;
  [[nodiscard]] SpaceMeshBody mesh_body(const SolidSpec& spec) const;
  [[nodiscard]] SpaceFrameBody frame_body(const SolidSpec& spec) const;
  [[nodiscard]] int require_body(const std::string& name, const std::string& owner) const;
  /// `arm`: of a bearing, see BearingSpecOf; negative: of others.
  void require_near(const std::string& body, const Vec3& point, const std::string& owner, double arm = -1) const;
  void append_bearing(const BearingSpecOf<3>& spec, Model<3>& model) const;
  void append_seat(const SeatSpecOf<3>& spec, Model<3>& model) const;
  void append_links(const Model<3>& model, const State<3>& state, Model<3>& grown) const;

  std::vector<Material> materials_;
  std::vector<SolidSpec> bodies_;
  RowNames body_names_known_;
  std::vector<BearingSpecOf<3>> bearings_;
  std::vector<SeatSpecOf<3>> seats_;
  ContactRules rules_;
  std::vector<std::string> notes_;
};

/// Fixes or frees one degree of freedom of a body (0 to 2 along x, y, z, 3 to 5 about them) for the next stage.
void set_support(Model<3>& model, int body, int dof, Support support);

/// Drives one degree of freedom of a body along x, y or z by `motion` from time `start` [s] and position `origin` on.
/// For a frame it applies to the nodes that are held along it; `origin` is then the first node's position, and the
/// others keep their relative positions in `state`.
void set_drive(Model<3>& model, int body, int dof, const std::shared_ptr<const GroundMotion>& motion, double start,
               double origin, const State<3>* state = nullptr);

}  // namespace trilith
