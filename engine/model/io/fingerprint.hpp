// Digests of a Model, to check whether two runs, or a run and a checkpoint, belong together.
#pragma once

#include <cstdint>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Two digests (base/hash.hpp) of every number and name of a model. Samples of motions count; the files that they were
/// read from do not.
struct Fingerprint {
  std::uint64_t structure = 0;  ///< defines a State: nodes, bodies, skins, contact laws, bearings, seats
  std::uint64_t conditions =
      0;  ///< data that may change between stages: supports, drives, gravity, damping, loads, limits of rest

  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

template <int D>
Fingerprint model_fingerprint(const Model<D>& model);
/// Independent of the supports of bodies that have left the bounds in `state`: they are held there.
template <int D>
Fingerprint model_fingerprint(Model<D> model, const State<D>& state);

}  // namespace trilith
