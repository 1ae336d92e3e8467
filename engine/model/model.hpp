// What is simulated. Made by ModelBuilder, checked once, const while a stage runs.
//
// Arrays are named with their shape: [node], [body], [skin], [piece], [corner] (all corners of all pieces in a row).
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
#include "load/forces.hpp"
#include "load/motion.hpp"
#include "model/contact/contact_frame.hpp"

namespace trilith {

/// How one degree of freedom of a node is held.
enum class Support : std::uint8_t { free, fixed, driven };

/// A body: who it is, and where its rows are.
struct Body {
  std::string name;
  BodyKind kind = BodyKind::rigid;
  std::string material;
  std::vector<std::string> groups;
  int first_node = 0, nodes = 1;
  int first_skin = 0, skins = 0;
  int outline = 0;  ///< the first of its skin points go once around it, counter-clockwise
  int first_piece = 0, pieces = 0;
  int first_fit = 0, fits = 0;  ///< in space, where its nodes do not turn: its rows of Model::fits
  int surface = 0;              ///< index into the table of contact laws
  double area = 0;              ///< [m2]

  /// One node carries it.
  [[nodiscard]] bool is_rigid() const { return kind == BodyKind::rigid; }
  /// Its skin points turn with several nodes.
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
  int first_number = 0;  ///< its rows of Model::element_number
  int first_point = -1;  ///< its rows of State::plastic, -1 where it is elastic
};

/// A finite element of a deformable body in space, see element/solid/space_element.hpp.
struct SpaceElement {
  int body = -1;
  ElementShape shape = ElementShape::brick;
  std::array<int, max_space_nodes> node{};  ///< as many as the shape has
  int solid = -1;                           ///< index into Model::solids
  int first_number = 0;                     ///< its rows of Model::element_number, see model/space_element_rows.hpp
  int first_point = -1;                     ///< its rows of State::plastic, -1 where it is elastic
  double volume = 0;                        ///< [m3]
};

/// Neighbouring elements that are worked on alike.
struct ElementBatch {
  int first, count;
  int nodes, solid;
};

/// Bounds of a body's highest frequency squared and damping rate: see integrate/explicit/stable_step.hpp.
struct RateBound {
  double stiffness = 0;  ///< [1/s2]
  double damping = 0;    ///< [1/s]
  double unbanded = 0;   ///< `stiffness` without what damping over a band adds
};

/// One degree of freedom of one node follows a ground motion.
struct Drive {
  int node, dof;
  double origin;  ///< position at the start of the motion [m] or [rad]
  double start;   ///< time at which the motion's clock is 0 [s]
  std::shared_ptr<const GroundMotion> motion;
};

/// Gravity; its direction may turn at a steady rate, which is what a tilting table does, and it may grow from nothing,
/// so that weight comes on without a jolt.
template <int D>
struct Gravity {
  Vec<D> field = Vec<D>::Zero();           ///< [m/s2]
  Spin<D> tilt_rate = nothing<Spin<D>>();  ///< the field turns with this [rad/s]
  double tilt_start = 0;                   ///< time at which it begins to turn [s]
  double tilt_end = unbounded;
  double grow_start = 0, grow_end = 0;  ///< its share goes from 0 to 1 between these times [s]

  /// How far it has turned [rad].
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

/// How a node of a body that is out of the step is held once the body is back.
template <int D>
struct SetAside {
  int node = -1;
  std::array<Support, Space<D>::dofs> support{};
  std::array<int, Space<D>::dofs> drive_of{};
};

/// Where bodies are followed. What leaves stands still from then on and is no longer part of the step.
template <int D>
struct Bounds {
  Vec<D> low = Vec<D>::Constant(-unbounded), high = Vec<D>::Constant(unbounded);  ///< opposite corners [m]

  [[nodiscard]] bool contain(const Vec<D>& x) const {
    return (x.array() >= low.array()).all() && (x.array() <= high.array()).all();
  }
};

/// A body's end resting on a support. Its length left is how far the end reaches over the edge of the seat.
template <int D>
struct Seat {
  std::string name;
  int body = -1, support = -1;
  Attachment<D> end;                ///< the body's end
  Attachment<D> edge;               ///< the edge of the seat, on the support
  Vec<D> inward = Vec<D>::UnitX();  ///< from the edge over the seat, unit vector in the axes of the support
};

template <int D>
struct Model {
  double thickness = 1;  ///< out of plane, of every contact [m]
  Gravity<D> gravity;
  double mass_damping = 0;  ///< C = mass_damping * M, on velocities relative to rest [1/s]
  Bounds<D> bounds;         ///< wide ones around where all begins, unless chosen: see default_bounds

  // Nodes: one row per node.
  std::vector<double> mass;                                  ///< [node] kg
  std::vector<typename Space<D>::Inertia> inertia;           ///< [node] kg m2
  std::vector<std::array<Support, Space<D>::dofs>> support;  ///< [node]
  std::vector<Vec<D>> start_position;                        ///< [node] m
  std::vector<Rotation<D>> start_rotation;                   ///< [node]
  std::vector<Vec<D>> start_velocity;                        ///< [node] m/s
  std::vector<Spin<D>> start_spin;                           ///< [node] rad/s
  std::vector<Vec<D>> load;                                  ///< [node] steady force N

  std::vector<Body> bodies;         ///< [body]
  std::vector<double> body_radius;  ///< [body] farthest skin point from the node m
  std::vector<Vec<D>> skin_place;   ///< [skin] from skin_node, in the axes of skin_turn m
  std::vector<int> skin_node;       ///< [skin]
  std::vector<int> skin_turn;       ///< [skin] the node whose axes those are: skin_node but at the pinned end of a beam
  std::vector<int> skin_before, skin_after;  ///< [skin] of a side of a mesh that goes straight on there, the skin point
                                             ///< before and after it; else itself. Empty where no side does

  // Convex pieces of the bodies' skins.
  std::vector<int> piece_body;             ///< [piece]
  std::vector<int> piece_first;            ///< [piece + 1] first corner
  std::vector<int> corner_skin;            ///< [corner] counter-clockwise
  std::vector<std::uint8_t> edge_is_face;  ///< [corner] edge from this corner to the next: 1 surface, 0 inner cut
  std::vector<double> edge_corner;         ///< [corner] flatness of the edge's two ends, see model/flatness.hpp [1]
  std::vector<double> piece_thickness;     ///< [piece] of its body where it is, see model/check/thickness.hpp m
  double least_thickness = unbounded;      ///< of all pieces that may touch something [m]
  std::vector<ConvexSolid> piece_solid;    ///< [piece] in the axes of its body; of models in space
  std::vector<int> piece_fit;  ///< [piece] its own row of `fits`, those of its faces follow; -1: it goes with
                               ///< a node; empty where all do
  /// [piece] rows of `fits`: faces of the skin that belong to pieces next to it and yet bound the body where it lies,
  /// as it meets their planes by an edge or a corner, see model/space_builder/mesh_skin.hpp; empty: none of any
  std::vector<std::vector<int>> piece_bounds;
  std::vector<Fit> fits;           ///< see model/contact/contact_frame.hpp
  std::vector<double> fit_number;  ///< likewise

  // Finite elements of deformable bodies.
  std::vector<Solid> solids;
  std::vector<Element> elements;               ///< [element], body by body
  std::vector<ElementBatch> element_batches;   ///< all of them, in order
  std::vector<SpaceElement> space_elements;    ///< [element] of models in space, body by body
  std::vector<double> element_number;          ///< see model/element_rows.hpp
  std::vector<Member> members;                 ///< of frames, body by body
  std::vector<Beam> beams;                     ///< [beam] of frames, body by body
  std::vector<Beam3> beams_3d;                 ///< [beam] of frames in space, body by body
  BeamYields yields;                           ///< of those that yield ...
  BeamYields3 yields_3d;                       ///< ... in space
  std::vector<DampingBranches> bands;          ///< of beams that are damped over a band
  std::vector<BeamInertia> beam_inertias;      ///< of beams with consistent mass, which implicit steps and modes know
  std::vector<BeamInertia3> beam_inertias_3d;  ///< ... in space
  std::vector<RateBound> element_bound;        ///< [body] of its elements or beams; 0 where it is rigid
  std::vector<double> element_rate;            ///< [element] bound of its highest frequency squared 1/s2
  int plastic_points = 0;                      ///< rows of State::plastic
  int beam_memory = 0;                         ///< rows of State::beam_memory

  // Contact laws: which one holds between two surfaces.
  std::vector<ContactLaw> laws;
  std::vector<std::string> law_names;
  int surfaces = 0;
  std::vector<int> law_of;  ///< [surface * surfaces] index into laws, or -1 for no contact

  std::vector<Bearing<D>> bearings;
  std::vector<Seat<D>> seats;
  std::vector<Drive> drives;
  std::vector<std::array<int, Space<D>::dofs>> drive_of;  ///< [node] index into drives, or -1
  std::vector<SetAside<D>> set_aside;                     ///< of nodes that are held as their body is out of the step
  std::vector<PointLoad<D>> point_loads;
  std::vector<FaceLoad<D>> face_loads;
  std::vector<Push<D>> pushes;
  double impact_speed = 0.5;     ///< a contact made faster than this is an impact [m/s]
  double apart_time = 0.02;      ///< a contact is lost when it has been open this long [s]
  double still_speed = 2.54e-7;  ///< a body slower than this for still_time is at rest [m/s]
  double still_time = 0.5;       ///< [s]

  /// True where there is any load but weight and the steady ones of `load`.
  [[nodiscard]] bool loaded() const { return !(point_loads.empty() && face_loads.empty() && pushes.empty()); }
  [[nodiscard]] int nodes() const { return static_cast<int>(mass.size()); }
  [[nodiscard]] bool has_consistent_mass() const { return !beam_inertias.empty() || !beam_inertias_3d.empty(); }
  [[nodiscard]] int pieces() const { return static_cast<int>(piece_body.size()); }
  /// In space: the node that a piece goes with, of a frame one of several.
  [[nodiscard]] int node_of_piece(int piece) const { return skin_node[corner_skin[piece_first[piece]]]; }
  /// What carries a piece in space, or face `face` of it: see model/contact/contact_frame.hpp.
  [[nodiscard]] int carrier_of(int piece, int face = -1) const {
    if (piece_fit.empty() || piece_fit[piece] < 0) return node_of_piece(piece);
    return -1 - (piece_fit[piece] + 1 + face);
  }
  /// In space: a piece of a body whose nodes do not turn.
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
  /// True where some node of the body is free to move.
  [[nodiscard]] bool body_moves(int body) const {
    const Body& b = bodies[body];
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
      if (moves(n)) return true;
    return false;
  }
  /// Index of the body called `name`, or -1.
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

/// The elements of a model, and as many nodes as one has.
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
