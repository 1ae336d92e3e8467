// Makes a Model of bodies, materials, laws, bearings and motions, and checks it once.
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
#include "model/builder/frame.hpp"
#include "model/builder/node_support.hpp"
#include "model/contact/contact_rules.hpp"
#include "model/material.hpp"
#include "model/model.hpp"
#include "model/names.hpp"
#include "model/state.hpp"

namespace trilith {

/// A body to be. Give at most one of density, mass, weight; without any, the material's density counts.
struct BodySpec {
  std::string name;  ///< unique
  Polygon outline;   ///< world coordinates [m]; clockwise ones are turned round, with a note. A quad, and a mesh that
                     ///< is not given by `mesh`, has four corners
  BodyKind kind = BodyKind::rigid;
  std::array<int, 2> divisions{1, 1};  ///< of a mesh, along the first and the second side of the outline
  std::optional<Mesh> mesh;            ///< of a body of kind mesh, instead of outline and divisions [m]; of a rigid
                                       ///< body its elements are the pieces
  std::optional<FrameSpec> frame;      ///< of a body of kind frame, instead of outline
  std::vector<NodeSupport> supports;   ///< of some nodes of a deformable body
  std::string material;
  std::vector<std::string> groups;
  std::optional<double> density;     ///< [kg/m3]
  std::optional<double> mass;        ///< [kg]
  std::optional<double> weight;      ///< [N], at standard gravity
  std::optional<double> inertia;     ///< about the centroid [kg m2]; without it, from the shape. Rigid bodies only
  std::optional<double> thickness;   ///< for mass and, of a deformable body, stiffness; without it, the model's [m]
  std::array<Support, 3> support{};  ///< x, y, rotation; of all nodes
  Vec2 velocity = Vec2::Zero();      ///< at the start [m/s]
  double spin = 0;                   ///< at the start [rad/s]
  Vec2 load = Vec2::Zero();          ///< steady force at the centroid, spread like the mass [N]
  bool floating = false;             ///< may start with nothing that holds it up
};

/// Area, centroid and second moment of the body's shape, after it was checked.
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
  double overlap_allowed = 1e-6;       ///< deepest overlap at the start, share of the smaller body's size
  /// What stands on nothing is a fault as it is built or added; false: not before who runs it asks (standing_faults).
  bool judge_standing = true;
  Bounds<2> bounds;  ///< sides that are infinite are those of default_bounds

  // Each throws InputError, and leaves the builder as it was.
  void add_material(const Material& material);
  void add_body(BodySpec spec);
  /// See ContactRules.
  void add_law(const std::string& name, const ContactLaw& law) { rules_.add_law(name, law, notes_); }
  void set_contact(const std::string& a, const std::string& b, const std::string& law) {
    rules_.set_contact(a, b, law);
  }
  void add_bearing(const BearingSpec& spec);
  void add_seat(const SeatSpec& spec);

  /// Adds a line to notes(): what was repaired or chosen before bodies came here.
  void note(const std::string& line) { notes_.push_back(line); }

  /// Checks everything and makes the model. Throws InputError with the first of faults().
  Model<2> build();

  /// `model`, which this builder made, with what was added here since: further bodies, bearings, seats and laws, at the
  /// ends of its arrays. They are placed beside the others as these stand by `state`. Throws InputError as build()
  /// does, for the new ones; then everything is as it was.
  Model<2> extended(const Model<2>& model, const State<2>& state);
  /// Forgets what was added after the first so many bodies, bearings and seats.
  void shorten(std::size_t bodies, std::size_t bearings, std::size_t seats);

  /// All that keeps build() from making the model, a line for each: overlapping bodies, bodies on nothing, contacts
  /// between names that are not there, ... Empty where nothing does.
  [[nodiscard]] std::vector<std::string> faults() const;

  /// What was repaired or is worth knowing; complete after build().
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
  /// `arm`: of a bearing, see BearingSpecOf; below 0: of others.
  void require_near(const std::string& body, const Vec2& point, const std::string& what, double arm = -1) const;
  void check_deformable(BodySpec& spec, const std::string& owner);
  void take_checked_mesh(BodySpec& spec, const std::string& owner);
  void check_frame(BodySpec& spec, const std::string& owner) const;
  void append_body(const BodySpec& spec, Model<2>& model) const;
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

/// Fixes or frees one degree of freedom of a body (0 x, 1 y, 2 rotation), for the next stage. Of a body of many nodes:
/// that of all of them; where these have no rotation, throws InputError for 2 unless it is to be fixed.
void set_support(Model<2>& model, int body, int dof, Support support);

/// Lets one degree of freedom of a body follow `motion` from time `start` [s] and position `origin` on. Of a deformable
/// body: that of all its nodes; `origin` is that of the first one, the others keep their places beside it as `state`
/// has them, or the model's start where there is none. Of a frame: of its nodes that are held along it. Throws
/// InputError for the rotation of a body of many nodes.
void set_drive(Model<2>& model, int body, int dof, const std::shared_ptr<const GroundMotion>& motion, double start,
               double origin, const State<2>* state = nullptr);

}  // namespace trilith
