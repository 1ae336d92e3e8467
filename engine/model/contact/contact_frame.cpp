#include "model/contact/contact_frame.hpp"

#include "element/corotation_3d.hpp"
#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// First the gradient F, then its rotation, then the rates.
Fitted fitted(const Model<3>& model, const Fit& fit, std::span<const Vec3> position, std::span<const Vec3> velocity) {
  const double* const number = &model.fit_number[static_cast<std::size_t>(fit.first_number)];
  Fitted out;
  Eigen::Matrix3d f = Eigen::Matrix3d::Zero();
  for (int i = 0; i < fit.nodes; ++i) {
    const auto n = static_cast<std::size_t>(fit.node[static_cast<std::size_t>(i)]);
    const double* const w = number + 4 * i;
    out.place += w[0] * position[n], out.velocity += w[0] * velocity[n];
    for (int k = 0; k < 3; ++k) f.col(k) += w[1 + k] * position[n];
  }
  const FittedTurn turn = fit.is_face ? fitted_face_turn(f.col(0), f.col(1)) : fitted_turn(f);
  out.axes = turn.axes, out.couple = turn.couple;
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < fit.nodes; ++i) {
    const double* const w = number + 4 * i;
    const auto n = static_cast<std::size_t>(fit.node[static_cast<std::size_t>(i)]);
    sum += cross(Vec3(w[1], w[2], w[3]), Vec3(turn.axes.transpose() * velocity[n]));
  }
  out.spin = turn.axes * (turn.couple * sum);
  return out;
}

void spread_fitted(const Model<3>& model, const Fit& fit, const Fitted& now, const Vec3& force, const Vec3& moment,
                   std::vector<Vec3>& node_force) {
  const double* const number = &model.fit_number[static_cast<std::size_t>(fit.first_number)];
  const Vec3 couple = now.couple * (now.axes.transpose() * moment);
  for (int i = 0; i < fit.nodes; ++i) {
    const double* const w = number + 4 * i;
    node_force[static_cast<std::size_t>(fit.node[static_cast<std::size_t>(i)])] +=
        w[0] * force + now.axes * cross(couple, Vec3(w[1], w[2], w[3]));
  }
}

BodyMotion motion_of(const Model<3>& model, const State<3>& state, int contact_frame) {
  if (contact_frame < 0)
    return fitted(model, model.fits[static_cast<std::size_t>(-1 - contact_frame)], state.position, state.velocity)
        .motion();
  const auto n = static_cast<std::size_t>(contact_frame);
  return {state.position[n], state.rotation[n], state.velocity[n], state.spin[n]};
}

BodyMotion motion_before(const Model<3>& model, const State<3>& state, int contact_frame) {
  if (contact_frame < 0) {
    const Fit& fit = model.fits[static_cast<std::size_t>(-1 - contact_frame)];
    return fitted(model, fit, state.position_before, state.velocity).motion();
  }
  const auto n = static_cast<std::size_t>(contact_frame);
  return {state.position_before[n], state.rotation_before[n], state.velocity[n], state.spin[n]};
}

BodyMotion start_of(const Model<3>& model, int contact_frame) {
  if (contact_frame < 0)
    return fitted(model, model.fits[static_cast<std::size_t>(-1 - contact_frame)], model.start_position,
                  model.start_velocity)
        .motion();
  const auto n = static_cast<std::size_t>(contact_frame);
  return {model.start_position[n], model.start_rotation[n], model.start_velocity[n], model.start_spin[n]};
}

void push_contact_frame(const Model<3>& model, const State<3>& state, int contact_frame, const Vec3& point,
                        const Vec3& force, const Vec3& moment, std::vector<Vec3>& node_force,
                        std::vector<Vec3>& node_moment) {
  if (contact_frame < 0) {
    const Fit& fit = model.fits[static_cast<std::size_t>(-1 - contact_frame)];
    const Fitted now = fitted(model, fit, state.position, state.velocity);
    return spread_fitted(model, fit, now, force, moment + cross(Vec3(point - now.place), force), node_force);
  }
  const auto n = static_cast<std::size_t>(contact_frame);
  node_force[n] += force;
  node_moment[n] += moment + cross(Vec3(point - state.position[n]), force);
}

namespace {

/// The three faces at a corner of a brick or a tetrahedron.
std::array<int, 3> faces_at(const FaceLoops& faces, int corner) {
  std::array<int, 3> found{};
  std::size_t count = 0;
  for (int f = 0; f < faces.count() && count < 3; ++f)
    for (const int c : faces[f])
      if (c == corner && count < 3) found[count++] = f;
  return found;
}

/// Intersection of three planes (Cramer's rule).
Vec3 meeting_of(const Fitted& a, const Fitted& b, const Fitted& c) {
  const Vec3 na = a.axes.col(2), nb = b.axes.col(2), nc = c.axes.col(2);
  const Vec3 ab = cross(na, nb), bc = cross(nb, nc), ca = cross(nc, na);
  // Relative to one of the positions, so that no digits are lost far from the origin.
  const Vec3 origin = a.place;
  return origin + (nb.dot(Vec3(b.place - origin)) * ca + nc.dot(Vec3(c.place - origin)) * ab) / na.dot(bc);
}

}  // namespace

void place_between(const ConvexSolid& solid, std::span<const Fitted> now, std::vector<Vec3>& corners,
                   std::vector<Vec3>& normals) {
  normals.clear();
  for (const Fitted& face : now) normals.emplace_back(face.axes.col(2));
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const auto [f, g, h] = faces_at(solid.shape.faces, static_cast<int>(c));
    corners[c] = meeting_of(now[static_cast<std::size_t>(f)], now[static_cast<std::size_t>(g)],
                            now[static_cast<std::size_t>(h)]);
  }
}

}  // namespace trilith
