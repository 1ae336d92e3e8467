// A State in a file, from which a run can be continued with the bits of an uninterrupted run.
//
// The file is a sequence of 64-bit words in the byte order of the machine that wrote it:
//
//     0       "TRILSTAT"
//     1       byte order mark 0x0102030405060708
//     2       version of this format (checkpoint_version)
//     3, 4    fingerprint of the model: structure, conditions (model/io/fingerprint.hpp)
//     5       number n of words of the state
//     6 ..    the state
//     6 + n   digest of all words before (base/hash.hpp)
//
// The state begins with time, step, dt, safety, last_dt. Then follow lists, each preceded by its length:
// - nodes: x, y, rotation, u, v, spin; in space x, y, z, quaternion w, x, y, z, three velocities, three spins;
// - nodal data of implicit schemes: x, y, rotation before, three accelerations; empty in explicit stages; then the
//   largest energy in implicit steps so far;
// - contacts with a memory: key, the 10 numbers of ContactMemory, bonds * 2^32 + state, index of the law in ContactLaws
//   * 2^32 + size of its memory, this memory;
// - contacts that opened recently: key, time;
// - penetrated pairs of bodies: key;
// - bearings: status * 2^32 + failed direction, with bit 31 set if the depth of the replaced contact follows, 3 x 5
//   numbers of DirectionMemory;
// - points of inelastic elements: 5 numbers of PlasticMemory;
// - seats: lost;
// - bodies: moved at, resting;
// - bodies: left the bounds;
// - the first 19 terms of the energy ledger.
//
// If bodies or bearings were added or removed, the other ledger terms and the removal times of bodies (-1: not removed)
// follow. If masses are scaled, these two and the shares by body follow. If there was water, these three, the term of
// water and the flooded joints follow. Numbers are IEEE doubles.
#pragma once

#include <cstdint>
#include <filesystem>

#include "model/model.hpp"
#include "model/state.hpp"

namespace trilith {

inline constexpr std::uint64_t checkpoint_version = 11;

/// Writes `state` of `model` to `path`: first under a temporary name, which is flushed to the disk and renamed. So
/// `path` is always a complete checkpoint, the old or the new one. Throws InputError if it cannot be written; then
/// nothing remains of the new one.
template <int D>
void save_state(const State<D>& state, const Model<D>& model, const std::filesystem::path& path);

/// Reads a state written by save_state. Throws InputError if the file is missing, no checkpoint, of another version or
/// byte order, truncated or damaged, or belongs to a model other than `model` (as it was when the state was saved).
template <int D>
State<D> load_state(const Model<D>& model, const std::filesystem::path& path);

}  // namespace trilith
