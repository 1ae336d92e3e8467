#include "edit/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "assembly/evaluate.hpp"
#include "base/quantity_text.hpp"
#include "edit/deactivate.hpp"
#include "edit/mesh_section.hpp"
#include "edit/restart.hpp"
#include "edit/split_contacts.hpp"
#include "edit/split_contacts_space.hpp"
#include "edit/split_fields.hpp"
#include "edit/split_mesh.hpp"
#include "edit/split_parts.hpp"
#include "law/contact/list.hpp"
#include "statics/displacement_control.hpp"

namespace trilith {
namespace {

template <int D>
Event split_event(const State<D>& state, EventType type, int body, const Vec<D>& at) {
  Event e;
  e.type = type;
  e.time = state.time;
  e.step = state.step;
  e.body_a = body;
  e.set_place(at);
  return e;
}

/// Crack first, because the others follow from it.
template <int D>
void append_events(const Model<D>& model, const State<D>& state, const Crack<D>& crack, const SplitBody& split,
                   const CrackSection<D>& section, std::vector<Event>& events) {
  Event cracked = split_event(state, EventType::unit_cracked, crack.body, crack.place);
  cracked.body_b = split.behind;
  cracked.mode = crack.mode;
  cracked.value = crack.stress;
  cracked.text = fmt::format("{} on plane {}", quantity_text(crack.stress, "Pa"), section.number);
  events.push_back(std::move(cracked));
  const auto place_of = [&](int body) {
    return state.position[static_cast<std::size_t>(model.bodies[body].first_node)];
  };
  events.push_back(split_event(state, EventType::body_removed, crack.body, place_of(crack.body)));
  for (const int part : {split.behind, split.ahead})
    events.push_back(split_event(state, EventType::body_added, part, place_of(part)));
}

/// The planes of a body that cracks.
template <int D>
const CrackingBody<D>& row_of(const std::vector<CrackingBody<D>>& bodies, const Crack<D>& crack) {
  return *std::find_if(bodies.begin(), bodies.end(), [&](const CrackingBody<D>& c) { return c.body == crack.body; });
}

/// A body that has split touches nothing, so its recent separations are forgotten.
template <int D>
void forget_parted(const Model<D>& model, State<D>& state) {
  std::erase_if(state.parted, [&](const Parted& p) {
    return state.left[static_cast<std::size_t>(model.piece_body[first_piece(p.contact)])] != 0 ||
           state.left[static_cast<std::size_t>(model.piece_body[second_piece(p.contact)])] != 0;
  });
}

/// Balance of the ledger after the split [J].
template <int D>
double balance_after(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options) {
  hold_left(model, state);
  work.drop();
  evaluate(model, state, work, state.last_dt);
  control_displacement(model, state, work, options);
  return energy_now(model, state, work, options).balance();
}

/// Stress of the section over the stiffness of its law, at both ends of it.
CrackOpening opening_of(const ContactLaw& law, const Crack<2>& crack, double length, double thickness) {
  const double area = length * thickness, mean = crack.normal / area, bend = 6 * crack.moment / (area * length);
  return with_kernel({law}, [&]<class K>(const K& kernel) {
    if constexpr (K::bonds) {
      if constexpr (K::softens) return CrackOpening{(mean + bend) / kernel.kn, (mean - bend) / kernel.kn};
    }
    return CrackOpening{};
  });
}

}  // namespace

Model<2> with_cracks(ModelBuilder& builder, const Model<2>& model, const std::vector<CrackingBody<2>>& bodies,
                     std::span<const Crack<2>> cracks) {
  for (const Crack<2>& crack : cracks) {
    const CrackingBody<2>& row = row_of(bodies, crack);
    const CrackSection<2>& section = row.sections[static_cast<std::size_t>(crack.section)];
    const ContactLaw& law = model.laws[static_cast<std::size_t>(row.law)];
    if (section.cut)
      builder.crack_mesh(crack.body, section, cut_openings(model, crack.body, *section.cut, crack.traction, law));
    else
      builder.crack(model, crack.body, section, opening_of(law, crack, section.length(), model.thickness));
  }
  return builder.with_parts(model);
}

Model<3> with_cracks(SolidModelBuilder& builder, const Model<3>& model, const std::vector<CrackingBody<3>>& bodies,
                     std::span<const Crack<3>> cracks) {
  for (const Crack<3>& crack : cracks)
    builder.crack(model, crack.body, row_of(bodies, crack).sections[static_cast<std::size_t>(crack.section)]);
  return builder.with_parts(model);
}

namespace {

std::vector<ContactRecord> records_of(const Model<2>& model, const State<2>& state, const Work<2>& work) {
  return contact_records(model, state, work);
}
std::vector<SolidRecord> records_of(const Model<3>& model, const State<3>& state, const Work<3>& work) {
  return solid_records(model, state, work);
}

/// Moves the links and fields of a rigid body to its parts.
template <int D>
void give_rigid(Model<D>& model, State<D>& state, const SplitBody& parts, const CrackingBody<D>& row,
                const CrackSection<D>& section) {
  place_parts(model, state, parts);
  hand_over_links(model, parts, section);
  const int whole = model.bodies[static_cast<std::size_t>(parts.body)].first_node;
  split_heat(model, state, parts, {whole, whole});
  if constexpr (D == 2)
    split_seepage(model, state, parts, crack_faces(model, parts, section),
                  model.laws[static_cast<std::size_t>(row.law)]);
}

/// Moves a mesh to its parts, with all its contacts.
template <int D, class Records>
Records give_mesh(Model<D>& model, State<D>& state, const Records& records, const SplitBody& parts,
                  const CrackingBody<D>& row, const Crack<D>& crack) {
  const MeshCut& cut = *row.sections[static_cast<std::size_t>(crack.section)].cut;
  place_mesh_parts(model, state, parts, cut);
  hand_over_mesh_links(model, parts, cut);
  split_heat(model, state, parts, MeshParts<D>(model, parts, cut).continued_nodes());
  if constexpr (D == 2)
    split_seepage(model, state, parts, mesh_crack_faces(model, parts, cut),
                  model.laws[static_cast<std::size_t>(row.law)]);
  Records given = mesh_handed_over(model, state, records, parts, cut);
  const Records own = mesh_crack_contacts(model, state, parts, row, crack);
  given.insert(given.end(), own.begin(), own.end());
  return given;
}

std::vector<ContactRecord> divided(const Model<2>& model, const State<2>& state,
                                   const std::vector<ContactRecord>& records, const SplitBody& parts,
                                   const CrackSection<2>& /*section*/) {
  return handed_over(model, state, records, parts);
}
std::vector<SolidRecord> divided(const Model<3>& model, const State<3>& state, const std::vector<SolidRecord>& records,
                                 const SplitBody& parts, const CrackSection<3>& section) {
  const auto n = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(parts.body)].first_node);
  const Turn3 turn(state.rotation[n]);
  return handed_over(model, state, records, parts, state.position[n] + turn.apply(section.centre),
                     turn.apply(section.normal));
}

}  // namespace

template <int D>
std::vector<Event> split(Model<D>& model, State<D>& state, Work<D>& work, const StepOptions& options, Model<D> grown,
                         const std::vector<CrackingBody<D>>& bodies, std::span<const Crack<D>> cracks) {
  const RestartedRun<D> anew(model, state, work);
  const double before = energy_now(model, state, work, options).balance();
  auto records = records_of(model, state, work);
  int next = static_cast<int>(model.bodies.size());
  model = std::move(grown);
  extend_state(state, model);
  std::vector<Event> events = anew.events();
  for (const Crack<D>& crack : cracks) {
    const CrackingBody<D>& row = row_of(bodies, crack);
    const SplitBody parts{crack.body, next, next + 1};
    next += 2;
    const CrackSection<D>& section = row.sections[static_cast<std::size_t>(crack.section)];
    if (section.cut) {
      records = give_mesh(model, state, records, parts, row, crack);
    } else {
      give_rigid(model, state, parts, row, section);
      records = divided(model, state, records, parts, section);
      if (auto contact = crack_contact(model, state, parts, row, crack)) records.push_back(std::move(*contact));
    }
    append_events(model, state, crack, parts, section, events);
  }
  put_contacts(state, std::move(records));
  forget_parted(model, state);
  const double lost = before - balance_after(model, state, work, options);
  state.given[EnergyTerm::contact_fracture] += lost, work.given[EnergyTerm::contact_fracture] += lost;
  anew.go_on(model, state, work);
  return events;
}

template std::vector<Event> split(Model<2>&, State<2>&, Work<2>&, const StepOptions&, Model<2>,
                                  const std::vector<CrackingBody<2>>&, std::span<const Crack<2>>);
template std::vector<Event> split(Model<3>&, State<3>&, Work<3>&, const StepOptions&, Model<3>,
                                  const std::vector<CrackingBody<3>>&, std::span<const Crack<3>>);

}  // namespace trilith
