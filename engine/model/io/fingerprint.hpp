// Digests of a Model: whether two runs, or a run and a checkpoint, are of the same thing.
#pragma once

#include <cstdint>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

/// Two digests (base/hash.hpp), of every number and name of a model. Samples of motions count; where they were read
/// from does not.
struct Fingerprint {
  std::uint64_t structure = 0;  ///< nodes, bodies, skins, contact laws, bearings, seats: what gives a State its meaning
  std::uint64_t conditions =
      0;  ///< what may change between stages: supports, drives, gravity, damping, loads, limits of rest

  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

template <int D>
Fingerprint model_fingerprint(const Model<D>& model);
/// The same whatever the supports of bodies that have left the bounds by `state` are: they are held there.
template <int D>
Fingerprint model_fingerprint(Model<D> model, const State<D>& state);

}  // namespace trilith
