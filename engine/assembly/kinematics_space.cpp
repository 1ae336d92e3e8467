// Positions and velocities of pieces in space from the motion of the nodes.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "assembly/displacement_bound.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/single_terms.hpp"
#include "base/simd/lane_rows.hpp"
#include "base/team.hpp"
#include "element/rigid/rigid.hpp"

namespace trilith {
namespace {

/// Radii of spheres; empty if there are no spheres.
void list_spheres(const Model<3>& model, std::vector<Sphere>& sphere) {
  sphere.clear();
  const auto& pieces = model.piece_solid;
  if (std::none_of(pieces.begin(), pieces.end(), [](const ConvexSolid& s) { return s.is_sphere(); })) return;
  for (const ConvexSolid& piece : pieces) sphere.push_back({Vec3::Zero(), piece.radius});
}

/// Pieces per chunk of a thread, about 10 microseconds.
constexpr int piece_stretch = 128;

/// A vector in the first three lanes.
TRILITH_INLINE Lanes in_lanes(const Vec3& v) {
  return Lanes{v.x(), v.y(), v.z(), 0};
}

/// Absolute value of a displacement.
TRILITH_INLINE Lanes way_of(const Lanes& moved) {
  return larger(moved, -moved);
}

/// Bounds over the corners of pieces: speed, and displacement after the last placement.
class SolidReach {
 public:
  /// Adds squared speed [m2/s2], squared displacement [m2] and displacement along each axis [m].
  TRILITH_INLINE void add(double speed2, double path2, const Vec3& steps) {
    speed2_ = std::max(speed2_, speed2), path2_ = std::max(path2_, path2);
    step_ = step_.cwiseMax(steps);
  }
  [[nodiscard]] double speed2() const { return speed2_; }  ///< largest square [m2/s2]
  [[nodiscard]] double path2() const { return path2_; }    ///< largest square [m2]
  /// Largest displacement along each axis [m].
  [[nodiscard]] const Vec3& step() const { return step_; }

 private:
  double speed2_ = 0, path2_ = 0;
  Vec3 step_ = Vec3::Zero();
};

/// The largest of four lanes.
TRILITH_INLINE double largest_of(const Lanes& of) {
  return std::max(std::max(of[0], of[1]), std::max(of[2], of[3]));
}

/// Position and motion of a body in all lanes, with bounds over the corners it has placed: largest squared speed and
/// displacement, and largest displacement along each axis.
struct MovingCorners {
  Triple<Lanes> x, y, z, at, velocity, spin;
  Lanes speed2{}, path2{};
  Triple<Lanes> step{};

  TRILITH_INLINE MovingCorners(const NodeMotion<3>& node, const Turn3& turn)
      : x(in_all(turn.x())),
        y(in_all(turn.y())),
        z(in_all(turn.z())),
        at(in_all(node.position)),
        velocity(in_all(node.velocity)),
        spin(in_all(node.spin)) {}
  TRILITH_INLINE static Triple<Lanes> in_all(const Vec3& v) { return four_of(v, v, v, v); }
  [[nodiscard]] TRILITH_INLINE Triple<Lanes> turned(const Triple<Lanes>& r) const {
    return x * r.x + y * r.y + z * r.z;
  }
  TRILITH_INLINE Triple<Lanes> place(const Triple<Lanes>& own, const Triple<Lanes>& before) {
    const Triple<Lanes> arm = turned(own), now = at + arm, rate = velocity + cross(spin, arm);
    const Triple<Lanes> moved = now - before;
    speed2 = larger(speed2, rate.square()), path2 = larger(path2, moved.square());
    step = {larger(step.x, way_of(moved.x)), larger(step.y, way_of(moved.y)), larger(step.z, way_of(moved.z))};
    return now;
  }
  TRILITH_INLINE void take_up(SolidReach& reach) const {
    reach.add(largest_of(speed2), largest_of(path2), {largest_of(step.x), largest_of(step.y), largest_of(step.z)});
  }
};

/// Places corners and normals of a piece, four at a time. Lanes beyond the last corner repeat it. Normals beyond the
/// last group of four are placed one by one, with a lane for each axis.
[[gnu::target_clones("avx2", "default")]] void place_solid(const ConvexSolid& solid, const NodeMotion<3>& node,
                                                           const Turn3& turn, PlacedSolid& out, SolidReach& reach) {
  MovingCorners body(node, turn);
  const std::vector<Vec3>& own = solid.shape.corners;
  const std::size_t fours = own.size() - own.size() % lane_count;
  for (std::size_t i = 0; i < fours; i += lane_count)
    store_neighbours(body.place(load_neighbours(&own[i]), load_neighbours(&out.corners[i])), &out.corners[i]);
  if (const std::size_t i = fours; i < own.size()) {
    const std::size_t last = own.size() - 1, k1 = std::min(i + 1, last), k2 = std::min(i + 2, last);
    Vec3 *const p0 = &out.corners[i], *const p1 = &out.corners[k1], *const p2 = &out.corners[k2];
    const Triple<Lanes> place = body.place(four_of(own[i], own[k1], own[k2], own[k2]), four_of(*p0, *p1, *p2, *p2));
    *p0 = lane_of(place, 0), *p1 = lane_of(place, 1), *p2 = lane_of(place, 2);
  }
  body.take_up(reach);
  const std::vector<Vec3>& normals = solid.normals;
  const std::size_t whole = normals.size() - normals.size() % lane_count;
  for (std::size_t f = 0; f < whole; f += lane_count)
    store_neighbours(body.turned(load_neighbours(&normals[f])), &out.normals[f]);
  const Lanes along_x = in_lanes(turn.x()), along_y = in_lanes(turn.y()), along_z = in_lanes(turn.z());
  for (std::size_t f = whole; f < normals.size(); ++f) {
    const Vec3& n = normals[f];
    const Lanes now = along_x * n.x() + along_y * n.y() + along_z * n.z();
    out.normals[f] = {now[0], now[1], now[2]};
  }
}

/// Places the single corner of a sphere, its centre, by the operations of a lane of place_solid.
void place_centre(const Vec3& own, const NodeMotion<3>& node, const Turn3& turn, Vec3& out, SolidReach& reach) {
  const auto square = [](const Vec3& v) { return v.x() * v.x() + v.y() * v.y() + v.z() * v.z(); };
  const Vec3 arm = turn.x() * own.x() + turn.y() * own.y() + turn.z() * own.z(), now = node.position + arm,
             rate = node.velocity + cross(node.spin, arm), moved = now - out;
  reach.add(square(rate), square(moved), moved.cwiseAbs());
  out = now;
}

/// Places the additional faces that bound the body at a piece.
void place_beside(const Model<3>& model, const State<3>& state, std::size_t piece, PlacedSolid& out) {
  if (model.piece_bounds.empty()) return;
  out.beside.clear();
  for (const int fit : model.piece_bounds[piece]) {
    const Fitted now = fitted(model, model.fits[static_cast<std::size_t>(fit)], state.position, state.velocity);
    out.beside.push_back({now.axes.col(2), now.place});
  }
}

/// Places a piece of a body whose nodes do not turn: its own fit and the fits of its faces, then the polyhedron between
/// them. The speed of its fastest node bounds the speed of its corners, nearly.
SolidReach place_fitted(const Model<3>& model, const State<3>& state, int piece, SolidWork<3>& solids) {
  const auto p = static_cast<std::size_t>(piece), first = static_cast<std::size_t>(model.piece_fit[p]);
  const ConvexSolid& solid = model.piece_solid[p];
  const auto faces = static_cast<std::size_t>(solid.shape.faces.count());
  for (std::size_t i = first; i <= first + faces; ++i)
    solids.fitted[i] = fitted(model, model.fits[i], state.position, state.velocity);
  for (std::size_t f = 0; f < faces; ++f) {
    const Fitted& now = solids.fitted[first + 1 + f];
    const StepBehind* behind = solids.behind.empty() ? nullptr : &solids.behind[state.position.size() + first + 1 + f];
    solids.face_motion[first + 1 + f] = {now.place, now.velocity, now.spin, behind};
  }
  PlacedSolid& out = solids.placed[p];
  const std::vector<Vec3>& own = solid.shape.corners;
  if (out.corners.size() != own.size()) out.corners.assign(own.size(), solids.fitted[first].place);
  solids.before[p] = out.corners;
  out.solid = &solid;
  place_between(solid, std::span(solids.fitted).subspan(first + 1, faces), out.corners, out.normals);
  place_beside(model, state, p, out);
  double speed2 = 0;
  const Fit& whole = model.fits[first];
  for (int i = 0; i < whole.nodes; ++i)
    speed2 = std::max(speed2, state.velocity[whole.node[static_cast<std::size_t>(i)]].squaredNorm());
  SolidReach reach;
  for (std::size_t c = 0; c < out.corners.size(); ++c) {
    const Vec3 moved = out.corners[c] - solids.before[p][c];
    reach.add(speed2, moved.squaredNorm(), moved.cwiseAbs());
  }
  solids.speed2[p] = reach.speed2();
  return reach;
}

/// Corners and normals of a piece that moves with one node, also in a frame, see model/space_builder/frame_skin.hpp.
SolidReach place_piece(const Model<3>& model, const State<3>& state, int piece, SolidWork<3>& solids) {
  const auto p = static_cast<std::size_t>(piece);
  if (model.is_fitted(piece)) return place_fitted(model, state, piece, solids);
  const int n = model.node_of_piece(piece);
  const NodeMotion<3> node{state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
  const Turn3 turn(node.rotation);
  const ConvexSolid& solid = model.piece_solid[p];
  PlacedSolid& out = solids.placed[p];
  out.solid = &solid;
  if (out.corners.size() != solid.shape.corners.size()) out.corners.assign(solid.shape.corners.size(), node.position);
  out.normals.resize(solid.normals.size());
  SolidReach reach;
  solid.is_sphere() ? place_centre(solid.shape.corners[0], node, turn, out.corners[0], reach)
                    : place_solid(solid, node, turn, out, reach);
  solids.speed2[p] = reach.speed2();
  if (!solids.sphere.empty()) solids.sphere[p].centre = out.corners[0];
  return reach;
}

/// True if a node of the piece is free to move.
bool piece_moves(const Model<3>& model, int piece) {
  if (!model.is_fitted(piece)) return model.moves(model.node_of_piece(piece));
  const Fit& whole = model.fits[static_cast<std::size_t>(model.piece_fit[static_cast<std::size_t>(piece)])];
  return std::any_of(whole.node.begin(), whole.node.begin() + whole.nodes, [&](int n) { return model.moves(n); });
}

/// Motion of all nodes along an implicit step, with space for fits; empty after an explicit step.
void place_behind(const Model<3>& model, const State<3>& state, std::vector<StepBehind>& behind) {
  behind.clear();
  if (!state.implicit()) return;
  behind.resize(state.position.size() + model.fits.size());
  for (std::size_t n = 0; n < state.position.size(); ++n)
    behind[n] = {state.position[n], state.rotation[n], state.position_before[n], state.rotation_before[n]};
}

/// Motion of all placed fits along an implicit step.
void place_fits_behind(const Model<3>& model, const State<3>& state, SolidWork<3>& solids) {
  if (solids.behind.empty()) return;
  for (std::size_t i = 0; i < model.fits.size(); ++i) {
    const BodyMotion now = solids.fitted[i].motion(), before = motion_before(model, state, -1 - static_cast<int>(i));
    solids.behind[state.position.size() + i] = {now.place, now.rotation, before.place, before.rotation};
  }
}

DisplacementBound<3> place_all(const Model<3>& model, const State<3>& state, Work<3>& work) {
  const std::size_t pieces = model.piece_solid.size();
  work.solids.placed.resize(pieces), work.solids.speed2.resize(pieces), work.solids.way.resize(pieces);
  work.solids.fitted.resize(model.fits.size()), work.solids.face_motion.resize(model.fits.size());
  if (!model.fits.empty()) work.solids.before.resize(pieces);
  if (!work.valid) list_spheres(model, work.solids.sphere);
  place_behind(model, state, work.solids.behind);
  work.search.left.resize(pieces);
  const DisplacementBound<3> reach =
      place_shared(work, static_cast<int>(pieces), piece_stretch, [&](int first, int last, DisplacementBound<3>& to) {
        for (int p = first; p < last; ++p) {
          const SolidReach of = place_piece(model, state, p, work.solids);
          to.add(of, [&] { return piece_moves(model, p); });
          work.solids.way[static_cast<std::size_t>(p)] += std::sqrt(of.path2());
          to.follow(of.step(), work.search.left[static_cast<std::size_t>(p)]);
        }
      });
  place_fits_behind(model, state, work.solids);
  return reach;
}

}  // namespace

/// The positions of a piece and its faces at the start of an implicit step do not change; their fits contain the
/// present ones.
void place_again(const Model<3>& model, const State<3>& state, Work<3>& work, int piece) {
  SolidWork<3>& solids = work.solids;
  place_piece(model, state, piece, solids);
  if (solids.behind.empty()) return;
  const bool is_fitted = model.is_fitted(piece);
  const int faces = is_fitted ? model.piece_solid[static_cast<std::size_t>(piece)].shape.faces.count() : 0;
  for (int face = -1; face < faces; ++face) {
    const int contact_frame = model.carrier_of(piece, face), fit = -1 - contact_frame;
    StepBehind& behind = solids.behind[static_cast<std::size_t>(is_fitted ? model.nodes() + fit : contact_frame)];
    const BodyMotion now =
        is_fitted ? solids.fitted[static_cast<std::size_t>(fit)].motion() : motion_of(model, state, contact_frame);
    behind = {now.place, now.rotation, behind.place_before, behind.rotation_before};
  }
}

template <>
void update_kinematics(const Model<3>& model, const State<3>& state, Work<3>& work) {
  if (!work.valid) list_bodies(model, work);  // elements need no chunks: see assembly/element/internal_forces_space.cpp
  keep_displacement_bound(place_all(model, state, work), work);
}

}  // namespace trilith
