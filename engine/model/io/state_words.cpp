#include "model/io/state_words.hpp"

#include <span>
#include <type_traits>
#include <utility>

#include "contact/joint/joint_plan.hpp"
#include "model/check/check_state.hpp"
#include "model/io/state_file.hpp"

namespace trilith {
namespace {

/// One contact: its key, the common memory, its law and the law's memory.
template <class File, class Memory>
void walk_memory(File& file, Memory& m) {
  ContactMemory::fields(
      m, [&](auto& v) { file.number(v); }, [&](auto& bonds, auto& state) { file.pair(bonds, state); });
}

void walk_contacts(StateWriter& file, const ContactHistory& s) {
  std::size_t kept = 0;
  for (const ContactMemory& m : s.memory) kept += m.empty() ? 0 : 1;
  file.words.push_back(kept);
  for (std::size_t row = 0; row < s.memory.size(); ++row) {
    if (s.memory[row].empty()) continue;
    file.key(s.key[row]);
    walk_memory(file, s.memory[row]);
    const std::uint32_t place = s.law_row[row].place, numbers = law_number_counts[place];
    file.pair(place, numbers);
    for (std::uint32_t k = 0; k < numbers; ++k) file.number(s.law_numbers(row)[k]);
  }
}

/// A joint: the data from which its plan follows, and the memories of its patches.
template <class File, class Plan>
void walk_plan(File& file, Plan& plan) {
  const auto number = [&](auto& v) { file.number(v); };
  JointSeat::fields(plan.in_a, number), JointSeat::fields(plan.in_b, number);
  number(plan.standing.at), number(plan.standing.slope[0]), number(plan.standing.slope[1]);
  for (std::size_t i = 0, n = file.open_count(plan.outline, 2); i < n; ++i)
    number(plan.outline[i][0]), number(plan.outline[i][1]);
}
template <class File, class Joint>
void walk_patches(File& file, Joint& joint, std::uint32_t patches) {
  const auto number = [&](auto& v) { file.number(v); };
  number(joint.moved.at), number(joint.moved.slope[0]), number(joint.moved.slope[1]);
  for (auto* shear : {&joint.elastic, &joint.total})
    if (joint.sound)
      for (const int k : {0, 1, 2}) number((*shear)[k]);
  for (std::uint32_t k = 0; k < patches && !joint.sound; ++k) PatchMemory::fields(joint.patch[k], number);
}
/// The crushed depths of its patches, if there are any.
template <class File, class Joint>
void walk_crushed(File& file, Joint& joint, std::uint32_t patches) {
  for (std::uint32_t k = 0; k < patches; ++k) file.number(joint.patch[k].crushed);
}
/// Openings of its patches by the slip of the last step, where there are any.
template <class File, class Joint>
void walk_opened(File& file, Joint& joint, std::uint32_t patches) {
  for (std::uint32_t k = 0; k < patches; ++k) file.number(joint.patch[k].opened);
}
constexpr std::uint32_t crushed_mark = 1U << 15U, opened_mark = 1U << 16U;

/// One contact of solids, for both writer and reader. `patches`: of its joint, 0 without a joint.
template <class File, class Memory>
void walk_solid_memory(File& file, Memory& m, std::uint32_t& patches) {
  SolidMemory::fields(
      m, [&](auto& v) { file.number(v); }, [&](auto& state) { file.pair(patches, state); });
}

void walk_contacts(StateWriter& file, const SolidHistory& s) {
  std::size_t kept = 0;
  for (const SolidMemory& m : s.memory) kept += m.empty() ? 0 : 1;
  file.words.push_back(kept);
  for (std::size_t row = 0; row < s.memory.size(); ++row) {
    if (s.memory[row].empty()) continue;
    const JointMemory* joint = s.joint_at(row);
    const bool has = joint != nullptr && !joint->empty();
    auto patches = has ? static_cast<std::uint32_t>(joint->plan->patches) : 0U;
    file.key(s.key[row]);
    walk_solid_memory(file, s.memory[row], patches);
    if (!has) continue;
    walk_plan(file, *joint->plan);
    const auto face = [](int f) { return static_cast<std::uint32_t>(f + 1); };
    const bool crushed = joint->most_crushed() > 0, opened = joint->most_opened() > 0;
    file.pair((joint->sound ? 1U : 0U) | face(joint->plan->face_a) << 1 | face(joint->plan->face_b) << 8 |
                  (crushed ? crushed_mark : 0U) | (opened ? opened_mark : 0U),
              joint->bonds);
    walk_patches(file, *joint, patches);
    if (crushed) walk_crushed(file, *joint, patches);
    if (opened) walk_opened(file, *joint, patches);
  }
}

/// The rest of a plan is recomputed from the outline.
void read_joint(StateReader& file, JointMemory& s, std::uint32_t patches) {
  const auto plan = std::make_shared<JointPlan>();
  walk_plan(file, *plan);
  if (plan->outline.size() < 3) file.fail("has a joint without an area");
  divide_joint(*plan);
  // Bit 0: intact; seven bits each for the faces that its seats follow, from 1 on; then whether some patch is crushed,
  // and whether slip opens one.
  std::uint32_t marks = 0;
  file.pair(marks, s.bonds);
  plan->face_a = static_cast<int>(marks >> 1 & 127U) - 1, plan->face_b = static_cast<int>(marks >> 8 & 127U) - 1;
  const bool crushed = (marks & crushed_mark) != 0, opened = (marks & opened_mark) != 0;
  s.plan = plan, s.sound = (marks & 1U) == 1;
  if (plan->patch.size() != patches || s.bonds >> patches != 0 || marks >> 17 != 0 || (s.sound && (crushed || opened)))
    file.fail("has a joint that does not fit its faces");
  if (s.sound)
    leave_out_patches(*plan);
  else
    divide(s);
  walk_patches(file, s, patches);
  if (crushed) walk_crushed(file, s, patches);
  if (opened) walk_opened(file, s, patches);
}

void walk_contacts(StateReader& file, SolidHistory& s) {
  const std::size_t count = file.open_count(s.key, 19);
  s.memory.resize(count);
  for (std::size_t row = 0; row < count; ++row) {
    std::uint32_t patches = 0;
    file.key(s.key[row]);
    walk_solid_memory(file, s.memory[row], patches);
    if (patches > most_patches) file.fail("has a joint of too many patches");
    if (patches > 0) read_joint(file, s.add_joint(row), patches);
  }
}

void walk_contacts(StateReader& file, ContactHistory& s) {
  const std::size_t count = file.open_count(s.key, 13);
  s.memory.resize(count), s.law_row.resize(count);
  for (std::size_t row = 0; row < count; ++row) {
    file.key(s.key[row]);
    walk_memory(file, s.memory[row]);
    std::uint32_t numbers = 0;
    file.pair(s.law_row[row].place, numbers);
    if (s.law_row[row].place >= law_number_counts.size() || numbers != law_number_counts[s.law_row[row].place])
      file.fail("has a contact of a law that does not exist");
    s.law_row[row].first = static_cast<std::uint32_t>(s.law_memory.size());
    s.law_memory.resize(s.law_memory.size() + numbers);
    for (std::uint32_t k = 0; k < numbers; ++k) file.number(s.law_numbers(row)[k]);
  }
}

/// Every number of a tangent, for both writer and reader.
template <class File, class T>
void walk_numbers_of(File& file, T& t) {
  for (auto* v : {&t.dt, &t.rate, &t.force, &t.inertia}) file.number(*v);
  for (std::size_t i = 0, n = file.open_count(t.column, 1); i < n; ++i) file.index(t.column[i]);
  for (std::size_t i = 0, n = file.open_count(t.row, 1); i < n; ++i) file.index(t.row[i]);
  for (std::size_t i = 0, n = file.open_count(t.value, 1); i < n; ++i) file.number(t.value[i]);
}

void walk_tangent(StateWriter& file, const std::shared_ptr<const KeptTangent>& kept) {
  file.flag(kept ? 1 : 0);
  if (kept) walk_numbers_of(file, *kept);
}

void walk_tangent(StateReader& file, std::shared_ptr<const KeptTangent>& kept) {
  std::uint8_t has = 0;
  file.flag(has);
  if (has == 0) return;
  const auto read = std::make_shared<KeptTangent>();
  walk_numbers_of(file, *read);
  kept = read;
}

/// Resizes the nodal data of implicit schemes to the announced number of accelerations.
template <int D>
void make_room(State<D>& s) {
  s.position_before.resize(s.acceleration.size());
  s.rotation_before.resize(s.acceleration.size());
  s.spin_rate.resize(s.acceleration.size());
}

/// The components of a position, a rotation, a velocity or a spin.
template <class File, class V>
void walk_numbers(File& file, V& v) {
  for_each_number(v, [&](auto& number) { file.number(number); });
}

/// The failed direction of a bearing. One mark is set if the depth of the replaced contact follows, another if the
/// origin of the displacement follows.
constexpr std::uint32_t stands_mark = 1U << 31U, begun_mark = 1U << 30U;
template <int D>
void walk_status(StateWriter& file, const BearingMemory<D>& m) {
  const bool stands = m.stood_for > 0, begun = m.begun_at != decltype(m.begun_at){};
  file.pair(m.status, m.failed_direction | (stands ? stands_mark : 0U) | (begun ? begun_mark : 0U));
  if (stands) file.number(m.stood_for);
  for (std::size_t k = 0; begun && k < m.begun_at.size(); ++k) file.number(m.begun_at[k]);
}
template <int D>
void walk_status(StateReader& file, BearingMemory<D>& m) {
  file.pair(m.status, m.failed_direction);
  if ((m.failed_direction & stands_mark) != 0) file.number(m.stood_for);
  if ((m.failed_direction & begun_mark) != 0)
    for (double& at : m.begun_at) file.number(at);
  m.failed_direction &= ~(stands_mark | begun_mark);
}

/// Memories of bearings, one after the other.
template <class File, class S>
void walk_bearings(File& file, S& s) {
  for (std::size_t i = 0, n = file.count(s.bearing); i < n; ++i) {
    walk_status(file, s.bearing[i]);
    for (auto& d : s.bearing[i].direction)
      for (auto* v : {&d.inner, &d.force, &d.damping, &d.travelled, &d.compression}) file.number(*v);
    if constexpr (requires { s.bearing[i].turned; }) {
      for (auto& v : s.bearing[i].turned) file.number(v);
      for (auto& v : s.bearing[i].horizontal) file.number(v);
    }
  }
}

/// Plastic strains of the points of elements.
template <class File, class S>
void walk_plastic(File& file, S& s) {
  for (std::size_t i = 0, n = file.count(s.plastic); i < n; ++i) {
    auto& p = s.plastic[i];
    for (auto* v : {&p.xx, &p.yy, &p.zz, &p.xy}) file.number(*v);
    if constexpr (requires { p.yz; }) file.number(p.yz), file.number(p.zx);
    file.number(p.measure);
  }
}

/// The clock, values and supplied heat of a field.
template <class File, class F>
void walk_field(File& file, F& field) {
  file.number(field.clock);
  for (std::size_t i = 0, n = file.open_count(field.value, 1); i < n; ++i) file.number(field.value[i]);
  for (std::size_t i = 0, n = file.open_count(field.supplied, 1); i < n; ++i) file.number(field.supplied[i]);
}

/// Every member of a state, in order, for both writer and reader. `S`: State<D>, const or not.
template <class File, class S>
void walk(File& file, S& s) {
  file.number(s.time), file.whole(s.step), file.number(s.dt), file.number(s.safety), file.number(s.last_dt);
  for (std::size_t n = 0, nodes = file.count(s.position); n < nodes; ++n) {
    walk_numbers(file, s.position[n]), walk_numbers(file, s.rotation[n]);
    walk_numbers(file, s.velocity[n]), walk_numbers(file, s.spin[n]);
  }
  for (std::size_t n = 0, nodes = file.open_count(s.acceleration, 6); n < nodes; ++n) {
    if constexpr (!std::is_const_v<S>) make_room(s);
    walk_numbers(file, s.position_before[n]), walk_numbers(file, s.rotation_before[n]);
    walk_numbers(file, s.acceleration[n]), walk_numbers(file, s.spin_rate[n]);
  }
  file.number(s.most_energy);
  walk_tangent(file, s.tangent);
  walk_contacts(file, s.contacts);
  for (std::size_t i = 0, n = file.open_count(s.parted, 2); i < n; ++i)
    file.key(s.parted[i].contact), file.number(s.parted[i].time);
  for (std::size_t i = 0, n = file.open_count(s.passed, 1); i < n; ++i) file.key(s.passed[i]);
  walk_bearings(file, s), walk_plastic(file, s);
  for (std::size_t i = 0, n = file.count(s.beam_memory); i < n; ++i) file.number(s.beam_memory[i]);
  for (std::size_t i = 0, n = file.count(s.seat_lost); i < n; ++i) file.flag(s.seat_lost[i]);
  for (std::size_t i = 0, n = file.count(s.moved_at); i < n; ++i) file.number(s.moved_at[i]), file.flag(s.resting[i]);
  for (std::size_t i = 0, n = file.count(s.left); i < n; ++i) file.flag(s.left[i]);
  for (std::size_t i = 0, n = file.count(std::span(s.given.value).first(plain_energy_terms)); i < n; ++i)
    file.number(s.given.value[i]);
  if (!file.changed(s)) return;
  for (std::size_t k = plain_energy_terms; k < dry_energy_terms; ++k) file.number(s.given.value[k]);
  for (std::size_t i = 0, n = file.open_count(s.removed_at, 1); i < n; ++i) file.number(s.removed_at[i]);
  if (!file.scaled(s)) return;
  for (std::size_t i = 0, n = file.open_count(s.added_share, 1); i < n; ++i) file.number(s.added_share[i]);
  if (!file.flooded(s)) return;
  for (std::size_t k = dry_energy_terms; k < cold_energy_terms; ++k) file.number(s.given.value[k]);
  for (std::size_t i = 0, n = file.open_count(s.flooded, 1); i < n; ++i) file.flag(s.flooded[i]);
  if (!file.heated(s)) return;
  file.number(s.given[EnergyTerm::heat]);
  for (std::size_t i = 0, n = file.open_count(s.fields, 3); i < n; ++i) walk_field(file, s.fields[i]);
}

}  // namespace

template <int D>
std::vector<std::uint64_t> state_words(const State<D>& state) {
  StateWriter file;
  walk(file, state);
  return std::move(file.words);
}

template <int D>
State<D> state_from_words(const Model<D>& model, std::span<const std::uint64_t> words, const std::string& owner) {
  State<D> state = initial_state(model);  // for the number of rows
  StateReader file(words, owner);
  walk(file, state);
  file.done();
  check_state(model, state, owner);
  return state;
}

template std::vector<std::uint64_t> state_words(const State<2>&);
template std::vector<std::uint64_t> state_words(const State<3>&);
template State<2> state_from_words(const Model<2>&, std::span<const std::uint64_t>, const std::string&);
template State<3> state_from_words(const Model<3>&, std::span<const std::uint64_t>, const std::string&);

}  // namespace trilith
