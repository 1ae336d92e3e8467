// The simulated model. Built by ModelBuilder, checked once, const during a stage.
//
// Arrays are documented with their shape: [node], [body], [skin], [piece], [corner] (all corners of all pieces in
// order).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/rotation_3d.hpp"
#include "base/space.hpp"
#include "element/band_damping.hpp"
#include "element/beam/beam_3d.hpp"
#include "element/beam/beam_inertia.hpp"
#include "element/beam/beam_inertia_3d.hpp"
#include "element/beam/beam_yield.hpp"
#include "element/beam/beam_yield_3d.hpp"
#include "element/list.hpp"
#include "element/solid/space_element.hpp"
#include "geometry/space/convex_solid.hpp"
#include "law/bearing/bearing.hpp"
#include "law/contact/list.hpp"
#include "law/material/list.hpp"
#include "load/list.hpp"
#include "load/motion.hpp"
#include "load/push.hpp"
#include "model/contact/contact_frame.hpp"

namespace trilith {

struct Field;

/// Support of one degree of freedom of a node.
enum class Support : std::uint8_t { free, fixed, driven };

/// A body: name, kind, and the ranges of its rows.
struct Body {
  std::string name;
  BodyKind kind = BodyKind::rigid;
  std::string material;
  std::vector<std::string> groups;
  int first_node = 0, nodes = 1;
  int first_skin = 0, skins = 0;
  int outline = 0;  ///< this many of its first skin points go once around it, counter-clockwise
  int first_piece = 0, pieces = 0;
  int first_fit = 0, fits = 0;  ///< in space, if its nodes have no rotation: its rows of Model::fits
  int surface = 0;              ///< index into the table of contact laws
  double area = 0;              ///< [m2]

  /// It has one node, which carries all motion.
  [[nodiscard]] bool is_rigid() const { return kind == BodyKind::rigid; }
  /// Its skin points rotate with several nodes.
  [[nodiscard]] bool skin_is_sections() const { return info_of(kind).skin == SkinLayout::sections; }
  /// Its nodes have rotations.
  [[nodiscard]] bool nodes_turn() const { return info_of(kind).nodes_turn; }
};

/// A finite element of a deformable body, see element/solid/plane_element.hpp.
struct Element {
  int body = -1;
  int nodes = 4;
  std::array<int, 4> node{-1, -1, -1, -1};
  int solid = -1;        ///< index into Model::solids
  double thickness = 1;  ///< [m]
  int first_number = 0;  ///< index of its rows in Model::element_number
  int first_point = -1;  ///< index of its rows in State::plastic, -1 if it is elastic
};

/// A finite element of a deformable body in space, see element/solid/space_element.hpp.
struct SpaceElement {
  int body = -1;
  ElementShape shape = ElementShape::brick;
  std::array<int, max_space_nodes> node{};  ///< as many as the shape has
  int solid = -1;                           ///< index into Model::solids
  int first_number = 0;  ///< index of its rows in Model::element_number, see model/element/space_element_rows.hpp
  int first_point = -1;  ///< index of its rows in State::plastic, -1 if it is elastic
  double volume = 0;     ///< [m3]
};

/// Consecutive elements that are processed alike.
struct ElementBatch {
  int first, count;
  int nodes, solid;
};

/// Bounds of a body's highest squared frequency and damping rate: see integrate/explicit/stable_step.hpp.
struct RateBound {
  double stiffness = 0;  ///< [1/s2]
  double damping = 0;    ///< [1/s]
  double unbanded = 0;   ///< `stiffness` without the contribution of damping over a band
};

/// One degree of freedom of one node follows a ground motion.
struct Drive {
  int node, dof;
  double origin;  ///< position at the start of the motion [m] or [rad]
  double start;   ///< time at which the motion begins [s]
  std::shared_ptr<const GroundMotion> motion;
};

/// Gravity. Its direction may rotate at a constant rate, as for a tilting table, and it may grow from 0, so that weight
/// is applied without a jolt.
template <int D>
struct Gravity {
  Vec<D> field = Vec<D>::Zero();           ///< [m/s2]
  Spin<D> tilt_rate = nothing<Spin<D>>();  ///< rotation rate of the field [rad/s]
  double tilt_start = 0;                   ///< time at which the rotation begins [s]
  double tilt_end = unbounded;
  double grow_start = 0, grow_end = 0;  ///< its share grows from 0 to 1 between these times [s]

  /// Rotation so far [rad].
  [[nodiscard]] Spin<D> angle(double time) const {
    return tilt_rate * (std::min(std::max(time, tilt_start), tilt_end) - tilt_start);
  }
  [[nodiscard]] Vec<D> grown(double time) const {
    return tilt_rate == nothing<Spin<D>>() ? field : turn_by(angle(time)).apply(field);
  }
  [[nodiscard]] Vec<D> at(double time) const {
    if (time >= grow_end) return grown(time);
    return std::max(0.0, (time - grow_start) / (grow_end - grow_start)) * grown(time);
  }
};

/// Support of a node to restore when its deactivated body is reactivated.
template <int D>
struct SetAside {
  int node = -1;
  std::array<Support, Space<D>::dofs> support{};
  std::array<int, Space<D>::dofs> drive_of{};
};

/// Region in which bodies are simulated. A body that leaves it is stopped and deactivated.
template <int D>
struct Bounds {
  Vec<D> low = Vec<D>::Constant(-unbounded), high = Vec<D>::Constant(unbounded);  ///< opposite corners [m]

  [[nodiscard]] bool contain(const Vec<D>& x) const {
    return (x.array() >= low.array()).all() && (x.array() <= high.array()).all();
  }
};

/// A body's end on a support. Its remaining length is the distance of the end beyond the edge of the seat.
template <int D>
struct Seat {
  std::string name;
  int body = -1, support = -1;
  Attachment<D> end;                ///< the body's end
  Attachment<D> edge;               ///< the edge of the seat, on the support
  Vec<D> inward = Vec<D>::UnitX();  ///< from the edge onto the seat, unit vector in the axes of the support
};

template <int D>
struct Model {
  double thickness = 1;  ///< out of plane, of every contact [m]
  Gravity<D> gravity;
  double mass_damping = 0;  ///< C = mass_damping * M, on velocities relative to the frame at rest [1/s]
  Bounds<D> bounds;         ///< wide ones around the initial bodies by default: see default_bounds

  // Nodes: one row per node.
  std::vector<double> mass;                                  ///< [node] [kg]
  std::vector<typename Space<D>::Inertia> inertia;           ///< [node] [kg m2]
  std::vector<std::array<Support, Space<D>::dofs>> support;  ///< [node]
  std::vector<Vec<D>> start_position;                        ///< [node] [m]
  std::vector<Rotation<D>> start_rotation;                   ///< [node]
  std::vector<Vec<D>> start_velocity;                        ///< [node] [m/s]
  std::vector<Spin<D>> start_spin;                           ///< [node] [rad/s]
  std::vector<Vec<D>> load;                                  ///< [node] steady force [N]

  std::vector<Body> bodies;         ///< [body]
  std::vector<double> body_radius;  ///< [body] largest distance of a skin point from the node [m]
  std::vector<Vec<D>> skin_place;   ///< [skin] relative to skin_node, in the axes of skin_turn [m]
  std::vector<int> skin_node;       ///< [skin]
  std::vector<int> skin_turn;       ///< [skin] the node of these axes: skin_node except at the pinned end of a beam
  std::vector<int> skin_before, skin_after;  ///< [skin] neighbours on a straight mesh side; else itself

  // Convex pieces of the bodies' skins.
  std::vector<int> piece_body;             ///< [piece]
  std::vector<int> piece_first;            ///< [piece + 1] first corner
  std::vector<int> corner_skin;            ///< [corner] counter-clockwise
  std::vector<std::uint8_t> edge_is_face;  ///< [corner] edge from this corner to the next: 1 surface, 0 inner cut
  std::vector<double> edge_corner;         ///< [corner] flatness of the edge's two ends, see model/flatness.hpp [1]
  std::vector<double> piece_thickness;     ///< [piece] of its body there, see model/check/thickness.hpp [m]
  double least_thickness = unbounded;      ///< of all pieces that may touch something [m]
  std::vector<ConvexSolid> piece_solid;    ///< [piece] in the axes of its body; of models in space
  std::vector<int> piece_fit;              ///< [piece] its row in `fits`, then its faces'; -1: moves with a node
  /// [piece] rows of `fits`: skin faces of neighbouring pieces that also bound the body at this piece. The piece meets
  /// their planes along an edge or at a corner, see model/space_builder/mesh_skin.hpp; empty: none
  std::vector<std::vector<int>> piece_bounds;
  std::vector<Fit> fits;           ///< see model/contact/contact_frame.hpp
  std::vector<double> fit_number;  ///< see model/contact/contact_frame.hpp

  // Finite elements of deformable bodies.
  std::vector<Solid> solids;
  std::vector<Element> elements;               ///< [element], body by body
  std::vector<ElementBatch> element_batches;   ///< all of them, in order
  std::vector<SpaceElement> space_elements;    ///< [element] of models in space, body by body
  std::vector<double> element_number;          ///< see model/element/element_rows.hpp
  std::vector<Member> members;                 ///< of frames, body by body
  std::vector<Beam> beams;                     ///< [beam] of frames, body by body
  std::vector<Beam3> beams_3d;                 ///< [beam] of frames in space, body by body
  BeamYields yields;                           ///< of yielding beams
  BeamYields3 yields_3d;                       ///< of yielding beams in space
  std::vector<DampingBranches> bands;          ///< of beams with damping over a band
  std::vector<BeamInertia> beam_inertias;      ///< of beams with consistent mass, for implicit steps and modes
  std::vector<BeamInertia3> beam_inertias_3d;  ///< of beams in space with consistent mass
  std::vector<RateBound> element_bound;        ///< [body] of its elements or beams; 0 if it is rigid
  std::vector<double> element_rate;            ///< [element] bound of its highest squared frequency [1/s2]
  int plastic_points = 0;                      ///< number of rows of State::plastic
  int beam_memory = 0;                         ///< number of rows of State::beam_memory

  // Contact laws, and the law between each pair of surfaces.
  std::vector<ContactLaw> laws;
  std::vector<std::string> law_names;
  int surfaces = 0;
  std::vector<int> law_of;  ///< [surface * surfaces] index into laws, or -1 for no contact

  std::vector<Bearing<D>> bearings;
  std::vector<Seat<D>> seats;
  std::vector<Drive> drives;
  std::vector<std::array<int, Space<D>::dofs>> drive_of;  ///< [node] index into drives, or -1
  std::vector<SetAside<D>> set_aside;                     ///< of nodes that are held because their body is deactivated
  Loads<D> loads;                                         ///< an array for each kind
  std::vector<Push<D>> pushes;
  std::vector<std::shared_ptr<const Field>> fields;  ///< see field/field.hpp; none: nothing is computed or stored
  double impact_speed = 0.5;                         ///< a contact that closes faster than this is an impact [m/s]
  double apart_time = 0.02;                          ///< a contact is lost when it has been open for this time [s]
  double still_speed = 2.54e-7;                      ///< a body slower than this for still_time is at rest [m/s]
  double still_time = 0.5;                           ///< [s]

  /// True if there is any load except weight and the steady forces of `load`.
  [[nodiscard]] bool loaded() const { return !(loads.empty() && pushes.empty()); }
  [[nodiscard]] int nodes() const { return static_cast<int>(mass.size()); }
  [[nodiscard]] bool has_consistent_mass() const { return !beam_inertias.empty() || !beam_inertias_3d.empty(); }
  [[nodiscard]] int pieces() const { return static_cast<int>(piece_body.size()); }
  /// In space: the node that moves a piece; for a frame one of several.
  [[nodiscard]] int node_of_piece(int piece) const { return skin_node[corner_skin[piece_first[piece]]]; }
  /// The contact frame of a piece in space, or of its face `face`: see model/contact/contact_frame.hpp.
  [[nodiscard]] int carrier_of(int piece, int face = -1) const {
    if (piece_fit.empty() || piece_fit[piece] < 0) return node_of_piece(piece);
    return -1 - (piece_fit[piece] + 1 + face);
  }
  /// In space: a piece of a body whose nodes have no rotation.
  [[nodiscard]] bool is_fitted(int piece) const { return !piece_fit.empty() && piece_fit[piece] >= 0; }
  [[nodiscard]] int corners_of(int piece) const { return piece_first[piece + 1] - piece_first[piece]; }
  [[nodiscard]] bool moves(int node) const {
    for (const Support s : support[node])
      if (s == Support::free) return true;
    return false;
  }
  [[nodiscard]] int free_dofs() const {
    int count = 0;
    for (const auto& node : support)
      for (const Support s : node) count += s == Support::free ? 1 : 0;
    return count;
  }
  /// True if some node of the body is free to move.
  [[nodiscard]] bool body_moves(int body) const {
    const Body& b = bodies[body];
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
      if (moves(n)) return true;
    return false;
  }
  /// Index of the body named `name`, or -1.
  [[nodiscard]] int find_body(std::string_view name) const {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (bodies[i].name == name) return static_cast<int>(i);
    return -1;
  }
};

/// The beams of a model.
inline const std::vector<Beam>& beams_of(const Model<2>& model) {
  return model.beams;
}
inline const std::vector<Beam3>& beams_of(const Model<3>& model) {
  return model.beams_3d;
}

/// The elements of a model, and the number of nodes of one.
inline const std::vector<Element>& elements_of(const Model<2>& model) {
  return model.elements;
}
inline const std::vector<SpaceElement>& elements_of(const Model<3>& model) {
  return model.space_elements;
}
inline int nodes_of(const Element& e) {
  return e.nodes;
}
inline int nodes_of(const SpaceElement& e) {
  return info_of(e.shape).nodes;
}

}  // namespace trilith
