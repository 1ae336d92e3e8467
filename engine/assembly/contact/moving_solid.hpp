// Pieces in space in their present position, as input of the contact functions.
#pragma once

#include "assembly/contact/solid_joints.hpp"
#include "contact/space/solid_pressure.hpp"
#include "model/work.hpp"

namespace trilith {

/// A piece in its present position, with the velocity and spin of its node, or of its fit.
inline MovingSolid moving_solid(const Model<3>& model, const State<3>& state, const Work<3>& work, int piece) {
  if (model.is_fitted(piece)) {
    const auto first = static_cast<std::size_t>(model.piece_fit[static_cast<std::size_t>(piece)]);
    const Fitted& whole = work.solids.fitted[first];
    return {work.solids.placed[piece],
            whole.place,
            whole.velocity,
            whole.spin,
            step_behind(work, model.carrier_of(piece)),
            &work.solids.face_motion[first + 1]};
  }
  const int n = model.node_of_piece(piece);
  return {work.solids.placed[piece], state.position[n], state.velocity[n], state.spin[n], step_behind(work, n)};
}

/// The surface face of a deforming piece that faces `way` most, -1 for a piece that does not deform. A contact of any
/// shape moves by this face, and its force acts there.
inline int leading_face(const MovingSolid& of, const Vec3& way) {
  if (of.faces == nullptr) return -1;
  int best = -1;
  double most = -2;
  for (int f = 0; f < of.placed.solid->shape.faces.count(); ++f) {
    const double along = of.placed.normals[static_cast<std::size_t>(f)].dot(way);
    if (of.placed.solid->is_surface(f) && along > most) best = f, most = along;
  }
  return best;
}

/// True if one of the two pieces is a sphere.
inline bool has_sphere(const Work<3>& work, const NearPair& pair) {
  const std::vector<Sphere>& sphere = work.solids.sphere;
  return !sphere.empty() && (sphere[pair.piece_a].radius > 0 || sphere[pair.piece_b].radius > 0);
}

}  // namespace trilith
