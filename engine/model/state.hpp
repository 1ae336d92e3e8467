// The data that persists between steps. A copy is a checkpoint; its digest is the run's hash.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/space.hpp"
#include "field/field_state.hpp"
#include "law/bearing/bearing.hpp"
#include "law/material/space_point.hpp"
#include "model/contact/contact_history.hpp"
#include "model/energy.hpp"
#include "model/model.hpp"

namespace trilith {

/// A contact that opened recently: lost once it has stayed open for Model::apart_time.
struct Parted {
  ContactKey contact;
  double time;  ///< [s]
};

/// A tangent of the equation of motion (assembly/tangent/tangent.hpp), reused by implicit steps while it converges.
struct KeptTangent {
  double dt = 0, rate = 0, force = 0, inertia = 0;  ///< its parameters, see TangentOptions
  std::vector<int> column;                          ///< [column + 1] start of each column's entries
  std::vector<int> row;                             ///< [entry] increasing within a column
  std::vector<double> value;                        ///< [entry] [N/m] and so on
  [[nodiscard]] int size() const { return static_cast<int>(column.size()) - 1; }
};

/// State::removed_at of a body that is in the model, or left its bounds.
inline constexpr double never_removed = -1;

template <int D>
struct State {
  double time = 0;        ///< [s]
  std::int64_t step = 0;  ///< number of steps taken
  double dt = 0;          ///< length of the last stable step found [s]; 0: not found yet
  double safety = 0;      ///< share of the stability limit at which `dt` was found [1]; 0: it was given
  double last_dt = 0;     ///< length of the last step [s]

  // Motion of the nodes [node]. Velocities are those at the last half step (leapfrog), or directly after an implicit
  // step at this instant.
  std::vector<Vec<D>> position;       ///< [m]
  std::vector<Rotation<D>> rotation;  ///< [rad] in the plane
  std::vector<Vec<D>> velocity;       ///< [m/s]
  std::vector<Spin<D>> spin;          ///< [rad/s]

  // Data of implicit schemes [node]; empty in explicit stages.
  std::vector<Vec<D>> position_before;         ///< at the beginning of the last step [m]
  std::vector<Rotation<D>> rotation_before;    ///< at the beginning of the last step, as `rotation`
  std::vector<Vec<D>> acceleration;            ///< [m/s2]
  std::vector<Spin<D>> spin_rate;              ///< [rad/s2]
  double most_energy = 0;                      ///< largest kinetic plus stored energy in implicit steps so far [J]
  std::shared_ptr<const KeptTangent> tangent;  ///< the last one; none in explicit stages

  Contacts<D> contacts;
  std::vector<Parted> parted;             ///< in the order of opening, then by key
  std::vector<ContactKey> passed;         ///< keys of bodies, not pieces, with excessive penetration seen; sorted
  std::vector<BearingMemory<D>> bearing;  ///< [bearing]
  std::vector<PointMemory<D>> plastic;    ///< [plastic point] of inelastic elements
  std::vector<double> beam_memory;        ///< of yielding beams, see Beam::first_memory
  std::vector<std::uint8_t> seat_lost;    ///< [seat]
  std::vector<double> moved_at;           ///< [body] last time when it was faster than Model::still_speed [s]
  std::vector<std::uint8_t> resting;      ///< [body] 1: has been still for Model::still_time
  std::vector<std::uint8_t> left;  ///< [body] 1: has left Model::bounds, or was removed; stopped and in no contact
  std::vector<double> removed_at;  ///< [body] time of its removal [s], never_removed if it was not removed, or is back;
                                   ///< empty if nothing was ever removed

  /// [body] mass added for its deformation, relative to its own mass, see integrate/explicit/mass_scaling.hpp; empty
  /// except in stages with mass scaling.
  std::vector<double> added_share;

  std::vector<std::uint8_t>
      flooded;  ///< [uplift] 1: water is in the open part of the joint; empty before the first time

  std::vector<FieldState> fields;  ///< [field] of Model::fields; empty, or shorter, before the first process

  Energy given;  ///< running sums of the ledger's terms that are not computed from the state

  [[nodiscard]] bool is_removed(std::size_t body) const {
    return body < removed_at.size() && removed_at[body] != never_removed;
  }
  /// True where the last step was implicit, or the next one will be.
  [[nodiscard]] bool implicit() const { return !acceleration.empty(); }
};

/// The state at the model's start: at rest or with the initial velocities, with bonds where bonded faces meet.
template <int D>
State<D> initial_state(const Model<D>& model);

/// Extends the state to a model with additional rows at the ends of its arrays. New rows begin as in initial_state, at
/// the present time. All existing rows keep their indices, and with them all data by body, node or piece.
template <int D>
void extend_state(State<D>& state, const Model<D>& grown);

/// Digest of all data above except empty contacts.
template <int D>
std::uint64_t state_hash(const State<D>& state);

}  // namespace trilith
