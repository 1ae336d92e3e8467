// Forces from outside as the model holds them; model/loads.hpp makes them.
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
  Attachment<D> at;                         ///< the point it acts on
  Vec<D> force = Vec<D>::Zero();            ///< [N]
  Moment<D> moment = nothing<Moment<D>>();  ///< [N m]
  bool follows = false;                     ///< turns with the point; given for where it was at the start
  LoadCurve curve;
};

/// Even pressure on a part of the face between two skin points of a body, counter-clockwise; times its load curve. What
/// is given to the two ends does the work that the pressure does on the straight face.
template <int D>
struct FaceLoad {
  std::string name;
  int body = -1;
  int skin_a = -1, skin_b = -1;
  std::array<double, 2> share{0.5, 0.5};  ///< of a full face's force that each end gets
  double pressure = 0;                    ///< pushes onto the face where above 0 [Pa]
  double depth = 1;                       ///< of the face out of plane [m]
  bool follows = true;                    ///< acts along the face's normal and on its length as they are now
  Vec<D> dead = Vec<D>::Zero();           ///< force on a full face where it does not follow [N]
  LoadCurve curve;
};

/// A point of a body that is pushed, with its part in the whole.
template <int D>
struct PushRow {
  int node = -1;                  ///< whose place counts
  int turn = -1;                  ///< whose rotation turns `place`; mostly the same node
  Vec<D> place = Vec<D>::Zero();  ///< in the axes of `turn`; 0 for a node that does not turn [m]
  double weight = 0;
};

/// Displacement control: points are pushed along one direction by forces in fixed proportion (their weights), as large
/// as needed for the weighed mean of their displacements to follow a motion. Everything else of them stays free.
template <int D>
struct Push {
  std::string name;
  std::vector<PushRow<D>> rows;        ///< weights sum to 1
  Vec<D> direction = Vec<D>::UnitX();  ///< unit vector
  double origin = 0;                   ///< weighed mean of the places along `direction` where the motion's is 0 [m]
  double start = 0;                    ///< time at which the motion's clock is 0 [s]
  std::shared_ptr<const GroundMotion> motion;
};

}  // namespace trilith
