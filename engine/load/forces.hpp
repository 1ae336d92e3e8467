// External forces in the model; model/loads.hpp creates them.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/attachment.hpp"
#include "base/space.hpp"
#include "load/load_curve.hpp"
#include "load/motion.hpp"

namespace trilith {

/// A force and a moment at a point of a body, times their load curve.
template <int D>
struct PointLoad {
  std::string name;
  int body = -1;
  Attachment<D> at;                         ///< point of action
  Vec<D> force = Vec<D>::Zero();            ///< [N]
  Moment<D> moment = nothing<Moment<D>>();  ///< [N m]
  bool follows = false;                     ///< rotates with the point; given for its initial orientation
  LoadCurve curve;
};

/// Uniform pressure on a part of the face between two skin points of a body, counter-clockwise, times its load curve.
/// The forces at the two ends do the work of the pressure on the straight face.
template <int D>
struct FaceLoad {
  std::string name;
  int body = -1;
  int skin_a = -1, skin_b = -1;
  std::array<double, 2> share{0.5, 0.5};  ///< of a full face's force at each end
  double pressure = 0;                    ///< positive towards the face [Pa]
  double depth = 1;                       ///< out-of-plane width of the face [m]
  bool follows = true;                    ///< acts along the present normal of the face and on its present length
  Vec<D> dead = Vec<D>::Zero();           ///< force on a full face if it does not follow [N]
  LoadCurve curve;
};

/// A pushed point of a body, with its weight.
template <int D>
struct PushRow {
  int node = -1;                  ///< node of its position
  int turn = -1;                  ///< node whose rotation rotates `place`; usually the same node
  Vec<D> place = Vec<D>::Zero();  ///< in the axes of `turn`; 0 for a node that does not turn [m]
  double weight = 0;
};

/// Displacement control: points are pushed along one direction by forces in fixed proportion (their weights). The
/// forces have the size with which the weighted mean of their displacements follows a motion. All other motion of the
/// points is free.
template <int D>
struct Push {
  std::string name;
  std::vector<PushRow<D>> rows;        ///< weights sum to 1
  Vec<D> direction = Vec<D>::UnitX();  ///< unit vector
  double origin = 0;                   ///< weighted mean of the coordinates along `direction` at motion 0 [m]
  double start = 0;                    ///< time at which the motion begins [s]
  std::shared_ptr<const GroundMotion> motion;
};

}  // namespace trilith
