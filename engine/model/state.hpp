// What survives a step. A copy is a checkpoint; its digest is the run's hash.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/space.hpp"
#include "law/bearing/bearing.hpp"
#include "law/material/space_point.hpp"
#include "model/contact/contact_history.hpp"
#include "model/energy.hpp"
#include "model/model.hpp"

namespace trilith {

/// A contact that opened a moment ago: lost once it has stayed open for Model::apart_time.
struct Parted {
  ContactKey contact;
  double time;  ///< [s]
};

/// A tangent of the equation of motion (assembly/tangent/tangent.hpp), which implicit steps use as long as it serves.
struct KeptTangent {
  double dt = 0, rate = 0, force = 0, inertia = 0;  ///< what it was taken for, see TangentOptions
  std::vector<int> column;                          ///< [column + 1] where its entries begin
  std::vector<int> row;                             ///< [entry] rising within a column
  std::vector<double> value;                        ///< [entry] N/m and so on
  [[nodiscard]] int size() const { return static_cast<int>(column.size()) - 1; }
};

/// State::removed_at of a body that is in the model, or left its bounds.
inline constexpr double never_removed = -1;

template <int D>
struct State {
  double time = 0;        ///< [s]
  std::int64_t step = 0;  ///< steps taken
  double dt = 0;          ///< length of the step last found stable [s]; 0: not found yet
  double safety = 0;      ///< share of the longest stable step that `dt` was found with [1]; 0: it was given
  double last_dt = 0;     ///< length of the last step [s]

  // Motion of the nodes [node]. Velocities are those of the last half step (leapfrog), or where a step has just been
  // taken by an implicit scheme, of this instant.
  std::vector<Vec<D>> position;       ///< m
  std::vector<Rotation<D>> rotation;  ///< rad in the plane
  std::vector<Vec<D>> velocity;       ///< m/s
  std::vector<Spin<D>> spin;          ///< rad/s

  // What an implicit scheme goes on from [node]; empty in explicit stages.
  std::vector<Vec<D>> position_before;       ///< as the step behind began m
  std::vector<Rotation<D>> rotation_before;  ///< as `rotation`
  std::vector<Vec<D>> acceleration;          ///< m/s2
  std::vector<Spin<D>> spin_rate;            ///< rad/s2
  double most_energy = 0;                    ///< the most that has moved and been stored since implicit steps began [J]
  std::shared_ptr<const KeptTangent> tangent;  ///< the last one; none in explicit stages

  Contacts<D> contacts;
  std::vector<Parted> parted;             ///< in the order of parting, then by key
  std::vector<ContactKey> passed;         ///< of bodies, not pieces: one has been seen too deep in the other; sorted
  std::vector<BearingMemory<D>> bearing;  ///< [bearing]
  std::vector<PointMemory<D>> plastic;    ///< [plastic point] of inelastic elements
  std::vector<double> beam_memory;        ///< of beams that yield, see Beam::first_memory
  std::vector<std::uint8_t> seat_lost;    ///< [seat]
  std::vector<double> moved_at;           ///< [body] when it was last faster than Model::still_speed s
  std::vector<std::uint8_t> resting;      ///< [body] 1: has been still for Model::still_time
  std::vector<std::uint8_t> left;  ///< [body] 1: has left Model::bounds, or was removed; it stands still there and
                                   ///< touches nothing
  std::vector<double> removed_at;  ///< [body] when it was removed [s], never_removed where it was not, or is back;
                                   ///< empty where nothing was ever removed

  /// [body] what its deformation has in mass on top of its own, as a share of it, see
  /// integrate/explicit/mass_scaling.hpp; empty but in stages that scale masses.
  std::vector<double> added_share;

  Energy given;  ///< running sums of the ledger (the terms that are not found from the state)

  [[nodiscard]] bool is_removed(std::size_t body) const {
    return body < removed_at.size() && removed_at[body] != never_removed;
  }
  /// True where the last step was taken by an implicit scheme, or the next one will be.
  [[nodiscard]] bool implicit() const { return !acceleration.empty(); }
};

/// The state at the model's start: at rest or with the start velocities, bonds made where bonded faces meet.
template <int D>
State<D> initial_state(const Model<D>& model);

/// The state of a model that has got further rows at the ends of its arrays: these begin as in initial_state, at the
/// present time. All rows that were there keep their places, and so all that is remembered by body, node or piece.
template <int D>
void extend_state(State<D>& state, const Model<D>& grown);

/// Digest of everything above but empty contacts.
template <int D>
std::uint64_t state_hash(const State<D>& state);

}  // namespace trilith
