// Frames in space for the physics tests: short model builders, and equilibrium by Newton's method.
#pragma once

#include <Eigen/Dense>

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "assembly/element/beam_motion.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/loads.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "physics/space/solid_bodies.hpp"
#include "readings/member_forces.hpp"

namespace trilith::testing {

inline Material member_material(double density, double young, double poisson = 0, double damping = 0) {
  return {"steel", density, Solid{LinearElastic{young, poisson, damping}}};
}

constexpr std::array<Support, 6> clamped{Support::fixed, Support::fixed, Support::fixed,
                                         Support::fixed, Support::fixed, Support::fixed};

/// A body whose members connect each joint to the next; both are named by their number, starting at "0".
inline SolidSpec chain_body(const std::string& name, const std::vector<Vec3>& places, const Section3& section,
                            int divisions) {
  SolidSpec spec;
  spec.name = name, spec.material = "steel", spec.floating = true;
  SpaceFrameSpec frame;
  for (std::size_t i = 0; i < places.size(); ++i) frame.joints.push_back({std::to_string(i), places[i]});
  for (int i = 0; i + 1 < static_cast<int>(places.size()); ++i) {
    SpaceMember member;
    member.from = i, member.to = i + 1, member.section = section, member.divisions = divisions;
    frame.members.push_back(member);
  }
  spec.frame = frame;
  return spec;
}

/// A model of frames of one material, without weight or contact.
inline Model<3> of_space_frames(const Material& material, std::vector<SolidSpec> specs) {
  SolidModelBuilder builder;
  builder.gravity = Vec3::Zero();
  builder.add_material(material);
  for (SolidSpec& spec : specs) builder.add_body(std::move(spec));
  return builder.build();
}

inline Section3 plain_section(double width, double depth) {
  return section_in_space(RectangleSection{width, depth});
}

inline UnitQuaternion random_turn(std::mt19937_64& bits) {
  return rotation_by(3 * random_in_ball(bits));
}

/// Equilibrium of a model under dead forces and moments on its nodes, by Newton's method with a tangent stiffness by
/// finite differences. Rotation increments are rotation vectors in world axes.
class SpaceEquilibrium {
 public:
  explicit SpaceEquilibrium(const Model<3>& model) : model_(model), state_(initial_state(model)) {
    for (int n = 0; n < model.nodes(); ++n)
      for (int k = 0; k < 6; ++k)
        if (model.support[n][k] == Support::free) free_.emplace_back(n, k);
    force.assign(static_cast<std::size_t>(model.nodes()), Vec3::Zero()), moment = force;
  }
  std::vector<Vec3> force, moment;  ///< [node] N, N m

  /// Loads grow in `steps` equal increments. Returns the largest residual.
  double solve(int steps, double tolerance) {
    double left = 0;
    for (int i = 1; i <= steps; ++i)
      for (int iteration = 0; iteration < 60; ++iteration) {
        const double share = static_cast<double>(i) / steps;
        const Eigen::VectorXd residual = residual_at(share);
        left = residual.cwiseAbs().maxCoeff();
        if (left < tolerance) break;
        move(tangent(share).fullPivLu().solve(-residual));
      }
    return left;
  }
  [[nodiscard]] const State<3>& state() const { return state_; }

 private:
  Eigen::VectorXd residual_at(double share) {
    internal_forces(model_, state_, work_);
    Eigen::VectorXd out(static_cast<Eigen::Index>(free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const auto [n, k] = free_[i];
      out[static_cast<Eigen::Index>(i)] = k < 3 ? work_.element_force[n][k] + share * force[n][k]
                                                : work_.element_moment[n][k - 3] + share * moment[n][k - 3];
    }
    return out;
  }
  void move(const Eigen::VectorXd& by) {
    for (std::size_t i = 0; i < free_.size(); ++i)
      if (const auto [n, k] = free_[i]; k < 3) state_.position[n][k] += by[static_cast<Eigen::Index>(i)];
    for (int n = 0; n < model_.nodes(); ++n) {
      Vec3 turn = Vec3::Zero();
      for (std::size_t i = 0; i < free_.size(); ++i)
        if (free_[i].first == n && free_[i].second >= 3) turn[free_[i].second - 3] = by[static_cast<Eigen::Index>(i)];
      state_.rotation[n] = renormalised(rotation_by(turn) * state_.rotation[n]);
    }
  }
  Eigen::MatrixXd tangent(double share) {
    const auto count = static_cast<Eigen::Index>(free_.size());
    Eigen::MatrixXd out(count, count);
    const State<3> kept = state_;
    for (Eigen::Index j = 0; j < count; ++j) {
      const double size = 1e-6 * (free_[static_cast<std::size_t>(j)].second < 3 ? model_.body_radius[0] : 1);
      Eigen::VectorXd by = Eigen::VectorXd::Zero(count);
      by[j] = size, move(by);
      const Eigen::VectorXd ahead = residual_at(share);
      state_ = kept, by[j] = -size, move(by);
      out.col(j) = (ahead - residual_at(share)) / (2 * size);
      state_ = kept;
    }
    return out;
  }

  const Model<3>& model_;
  State<3> state_;
  Work<3> work_;
  std::vector<std::pair<int, int>> free_;
};

}  // namespace trilith::testing
