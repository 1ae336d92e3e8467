// A State in a file, so that a run can be continued: the continued run has the bits of one that was never broken off.
//
// The file is a row of 64-bit words in the byte order of the machine that wrote it:
//   0       "TRILSTAT"
//   1       byte order mark 0x0102030405060708
//   2       version of this format (checkpoint_version)
//   3, 4    fingerprint of the model: structure, conditions (model/io/fingerprint.hpp)
//   5       number n of words of the state
//   6 ..    the state: time, step, dt, safety, last_dt; then, each led by its count: nodes (x, y, rotation, u, v,
//           spin; in space x, y, z, quaternion w, x, y, z, three velocities, three spins), what an implicit scheme
//           keeps of them (x, y, rotation before, three accelerations; none in explicit stages), the most energy since
//           these began, contacts that remember something (key, the 10 numbers of ContactMemory, bonds * 2^32 + state,
//           place of the law in ContactLaws * 2^32 + how many numbers it remembers, these), contacts that parted a
//           moment ago (key, time), pairs of bodies that passed (key), bearings (status * 2^32 + failed direction, with
//           bit 31 set where the depth of the contact that it stands for follows, 3 x 5 numbers of DirectionMemory),
//           points of inelastic elements (5 numbers of PlasticMemory), seats (lost), bodies (moved at, resting), bodies
//           (left the bounds), the first 19 terms of the energy ledger; and where bodies or bearings were added or
//           removed, the other terms and the times at which bodies were removed (-1: not); and where masses are scaled
//           these two, and shares by body. Numbers are IEEE doubles.
//   6 + n   digest of all words before (base/hash.hpp)
#pragma once

#include <cstdint>
#include <filesystem>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

inline constexpr std::uint64_t checkpoint_version = 11;

/// Writes `state` of `model` to `path`: first under a name of its own, which is then forced to the disk and renamed, so
/// that at any time `path` is a whole checkpoint, the old or the new one. Throws InputError where it cannot be written;
/// then nothing is left of the new one.
template <int D>
void save_state(const State<D>& state, const Model<D>& model, const std::filesystem::path& path);

/// Reads a state that save_state wrote. Throws InputError where the file is missing, no checkpoint, of another version
/// or byte order, cut or damaged, or of another model than `model` (as it was when the state was saved).
template <int D>
State<D> load_state(const Model<D>& model, const std::filesystem::path& path);

}  // namespace trilith
