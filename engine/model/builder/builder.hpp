// Builds a Model from bodies, materials, laws, bearings and motions, and checks it once.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/plane/mesh.hpp"
#include "geometry/plane/polygon.hpp"
#include "load/motion.hpp"
#include "model/builder/bearing_spec.hpp"
#include "model/builder/crack_rules.hpp"
#include "model/builder/frame.hpp"
#include "model/builder/node_support.hpp"
#include "model/contact/contact_rules.hpp"
#include "model/crack_planes.hpp"
#include "model/material.hpp"
#include "model/model.hpp"
#include "model/names.hpp"
#include "model/state.hpp"

namespace trilith {

/// Specification of a body. At most one of density, mass, weight may be given; the default is the material's density.
struct BodySpec {
  std::string name;  ///< unique
  Polygon outline;  ///< world coordinates [m]; clockwise outlines are reversed, with a note. A quad, and a mesh without
                    ///< `mesh`, has four corners
  BodyKind kind = BodyKind::rigid;
  std::array<int, 2> divisions{1, 1};  ///< of a mesh, along the first and the second side of the outline
  std::optional<Mesh> mesh;  ///< for a body of kind mesh, instead of outline and divisions [m]; for a rigid body its
                             ///< elements are the pieces
  std::optional<FrameSpec> frame;     ///< for a body of kind frame, instead of outline
  std::vector<NodeSupport> supports;  ///< for some nodes of a deformable body
  std::string material;
  std::vector<std::string> groups;
  std::optional<double> density;       ///< [kg/m3]
  std::optional<double> mass;          ///< [kg]
  std::optional<double> weight;        ///< [N], at standard gravity
  std::optional<double> inertia;       ///< about the centroid [kg m2]; default: from the shape. Rigid bodies only
  std::optional<double> thickness;     ///< for mass and the stiffness of a deformable body; default: the model's [m]
  std::array<Support, 3> support{};    ///< x, y, rotation; of all nodes
  Vec2 velocity = Vec2::Zero();        ///< at the start [m/s]
  double spin = 0;                     ///< at the start [rad/s]
  Vec2 load = Vec2::Zero();            ///< steady force at the centroid, distributed like the mass [N]
  bool floating = false;               ///< may start unsupported
  CrackSpec<2> cracks = {};            ///< planes on which it may crack; not for frames
  Polygon solid = {};                  ///< outline of its mass, if the opening of a crack separates it from `outline`
  std::vector<double> node_mass = {};  ///< [node of mesh] of a part of a deformable body; empty: from its elements [kg]
  int cracked_from = -1;               ///< the body that it is a part of, or -1
  int first_part = -1;                 ///< once it has cracked: the part behind its plane; the next body is the other
  CrackPlane<2> parted_at = {};        ///< this plane
};

/// Area, centroid and second moment of the body's shape, after its check.
PolygonMoments moments_of(const BodySpec& spec);

class ModelBuilder {
 public:
  double thickness = 1;                ///< [m]
  Vec2 gravity{0, -standard_gravity};  ///< [m/s2]
  double mass_damping = 0;             ///< [1/s]
  double impact_speed = 0.5;           ///< [m/s]
  double apart_time = 0.02;            ///< [s]
  double still_speed = 2.54e-7;        ///< [m/s]
  double still_time = 0.5;             ///< [s]
  double overlap_allowed = 1e-6;       ///< largest overlap at the start, relative to the smaller body's size
  /// true: an unsupported body is a fault when it is built or added; false: only when the caller asks
  /// (standing_faults).
  bool judge_standing = true;
  Bounds<2> bounds;  ///< infinite sides use default_bounds

  // Each throws InputError, and leaves the builder unchanged.
  void add_material(const Material& material);
  void add_body(BodySpec spec);
  /// See ContactRules.
  void add_law(const std::string& name, const ContactLaw& law) { rules_.add_law(name, law, notes_); }
  void set_contact(const std::string& a, const std::string& b, const std::string& law) {
    rules_.set_contact(a, b, law);
  }
  void add_bearing(const BearingSpec& spec);
  void add_seat(const SeatSpec& spec);

  /// Adds a line to notes(): a repair or choice made before bodies were added.
  void note(const std::string& line) { notes_.push_back(line); }

  /// Checks everything and makes the model. Throws InputError with the first of faults().
  Model<2> build();

  /// Extends `model`, which this builder made, by later additions: bodies, bearings, seats and laws, at the ends of its
  /// arrays. New bodies are checked against the others in their present positions in `state`. Throws InputError as
  /// build() does, for the new ones; then nothing has changed.
  Model<2> extended(const Model<2>& model, const State<2>& state);
  /// The bodies of `model`, which this builder made, that may crack.
  [[nodiscard]] std::vector<CrackingBody<2>> cracking(const Model<2>& model) const;
  /// Adds the two parts of a body that cracks at a section of `model`, which this builder made. They have the names
  /// "u17.a" (behind the plane) and "u17.b", and the group "pieces of u17". Their faces at the section are apart by
  /// `opening`; their masses are divided by the plane.
  void crack(const Model<2>& model, int body, const CrackSection<2>& section, const CrackOpening& opening);
  /// The same for a mesh that cracks along the faces of its section. Both copies of a node are apart by its `opening`
  /// [node of the cut], which their masses divide, so that the centre of mass stays [m].
  void crack_mesh(int body, const CrackSection<2>& section, const std::vector<Vec2>& opening);
  /// Extends `model` by these parts, in the initial position of their bodies, without checks.
  [[nodiscard]] Model<2> with_parts(const Model<2>& model) const;
  /// Removes everything added after the given numbers of bodies, bearings and seats.
  void shorten(std::size_t bodies, std::size_t bearings, std::size_t seats);

  /// All faults that prevent build(), a line for each: overlapping bodies, unsupported bodies, contacts between unknown
  /// names, ... Empty if there is none.
  [[nodiscard]] std::vector<std::string> faults() const;

  /// Repairs and other notable facts; complete after build().
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] const std::vector<BodySpec>& bodies() const { return bodies_; }
  [[nodiscard]] const std::vector<BearingSpec>& bearings() const { return bearings_; }
  [[nodiscard]] const std::vector<SeatSpec>& seats() const { return seats_; }
  [[nodiscard]] std::vector<std::string> body_names() const;
  [[nodiscard]] std::vector<std::string> law_names() const { return rules_.law_names(); }
  [[nodiscard]] const ContactRules& contact_rules() const { return rules_; }

 private:
  Model<2> assemble(std::vector<std::string>& faults, std::vector<std::string>& notes) const;
  Model<2> assemble_bodies(std::vector<std::string>& faults) const;
  void append_links(const Model<2>& model, const State<2>& state, Model<2>& grown) const;
  /// `arm`: of a bearing, see BearingSpecOf; negative: of others.
  void require_near(const std::string& body, const Vec2& point, const std::string& what, double arm = -1) const;
  void check_deformable(BodySpec& spec, const std::string& owner);
  void take_checked_mesh(BodySpec& spec, const std::string& owner);
  void check_frame(BodySpec& spec, const std::string& owner) const;
  void append_body(const BodySpec& spec, Model<2>& model) const;
  static void check_cracks(const BodySpec& spec, const std::string& owner);
  void check_crack_laws(std::vector<std::string>& faults) const;
  void append_deformable(const BodySpec& spec, Model<2>& model) const;
  void append_frame(const BodySpec& spec, Model<2>& model) const;
  void append_pieces(const Polygon& outline, int body, Model<2>& model) const;
  void append_bearing(const BearingSpec& spec, Model<2>& model) const;
  void append_seat(const SeatSpec& spec, Model<2>& model) const;
  int require_body(const std::string& name, const std::string& owner) const;

  std::vector<Material> materials_;
  std::vector<BodySpec> bodies_;
  RowNames body_names_known_;
  ContactRules rules_;
  std::vector<BearingSpec> bearings_;
  std::vector<SeatSpec> seats_;
  std::vector<std::string> notes_;
};

/// Fixes or frees one degree of freedom of a body (0 x, 1 y, 2 rotation) for the next stage. Applies to all nodes of a
/// body. Nodes of elements have no rotation, so 2 has no effect on them.
void set_support(Model<2>& model, int body, int dof, Support support);

/// Drives one degree of freedom of a body by `motion` from time `start` [s] and position `origin` on. For a deformable
/// body it applies to all nodes. `origin` is then the first node's position, and the others keep their relative
/// positions in `state`, or in the model's start if there is no state. For a frame it applies to the nodes that are
/// held along it. Throws InputError for the rotation of a body with many nodes.
void set_drive(Model<2>& model, int body, int dof, const std::shared_ptr<const GroundMotion>& motion, double start,
               double origin, const State<2>* state = nullptr);

}  // namespace trilith
