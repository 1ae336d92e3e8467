#include "run/recording_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "record/provenance.hpp"

namespace trilith {
namespace {

/// Names separated by blanks; a blank within a name becomes '_'.
std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (std::string name : names) {
    std::replace(name.begin(), name.end(), ' ', '_');
    if (!out.empty()) out += ' ';
    out += name;
  }
  return out;
}

/// Outline of a body in the axes of its node.
std::vector<double> outline_of(const Model<2>& model, const Body& body) {
  std::vector<double> out;
  for (int i = body.first_skin; i < body.first_skin + body.skins; ++i) {
    out.push_back(model.skin_place[i].x());
    out.push_back(model.skin_place[i].y());
  }
  return out;
}

void add_bodies(const Model<2>& model, const State<2>& state, record::Header& header) {
  for (const Body& body : model.bodies) {
    const int n = body.first_node;
    record::BodyRow row;
    row.name = body.name;
    row.kind = body.kind;
    row.material = body.material;
    row.groups = joined(body.groups);
    row.support = support_text(model.support[n]);
    const std::array position{state.position[n].x(), state.position[n].y()};
    header.add_rigid_body(std::move(row), position, std::span(&state.rotation[n], 1), model.mass[n],
                          std::span(&model.inertia[n], 1), outline_of(model, body));
  }
}

/// What the bodies of a surface have in common: material and groups.
std::string surface_label(const Body& body) {
  if (body.groups.empty()) return body.material.empty() ? body.name : body.material;
  const std::string groups = joined(body.groups);
  return body.material.empty() ? fmt::format("({})", groups) : fmt::format("{} ({})", body.material, groups);
}

void add_laws(const Model<2>& model, const std::vector<Material>& materials, record::Header& header) {
  for (const Material& m : materials)
    header.laws.push_back({m.name, "material", "", "", fmt::format("density={:g} kg/m3", m.density)});
  std::vector<std::string> label(static_cast<std::size_t>(model.surfaces));
  for (const Body& body : model.bodies)
    if (label[body.surface].empty()) label[body.surface] = surface_label(body);
  std::set<std::tuple<int, std::string, std::string>> pairs;  // by law, each pair of labels once
  for (int i = 0; i < model.surfaces; ++i)
    for (int j = i; j < model.surfaces; ++j)
      if (const int law = model.law_of[i * model.surfaces + j]; law >= 0) pairs.emplace(law, label[i], label[j]);
  for (const auto& [law, first, second] : pairs)
    header.laws.push_back({model.law_names[law], "contact", first, second,
                           std::visit([](const auto& l) { return describe(l); }, model.laws[law])});
}

std::string direction_text(const DirectionLaw& law) {
  return std::visit(
      [](const auto& l) -> std::string {
        using Law = std::decay_t<decltype(l)>;
        if constexpr (std::is_same_v<Law, std::monostate>) {
          return "free";
        } else {
          std::string out = describe(l);
          if constexpr (std::is_same_v<Law, Table>)
            for (std::size_t i = 0; i < l.displacement.size(); ++i)
              out += fmt::format(" ({:g}, {:g})", l.displacement[i], l.force[i]);
          return out;
        }
      },
      law);
}

void add_bearings(const Model<2>& model, record::Header& header) {
  for (const Bearing<2>& b : model.bearings) {
    record::BearingRow row;
    row.name = b.name;
    row.body_a = b.body_a;
    row.body_b = b.body_b;
    for (const int k : {0, 1}) row.point_a[k] = b.point_a[k], row.point_b[k] = b.point_b[k];
    row.law = bearing_text(model, b);
    header.bearings.push_back(std::move(row));
  }
}

void complete(const Model<2>& model, record::Provenance& p) {
  const record::Provenance here = record::provenance_here();
  for (const auto part : {&record::Provenance::compiler, &record::Provenance::platform, &record::Provenance::git_commit,
                          &record::Provenance::start_time})
    if ((p.*part).empty()) p.*part = here.*part;
  if (!p.motions.empty()) return;
  for (const Drive& drive : model.drives) p.motions.push_back(drive_text(model, drive));
}

}  // namespace

record::Header recording_header(const Model<2>& model, const State<2>& state, const RecordingOptions& options) {
  record::Header header;
  header.dim = 2;
  header.provenance = options.provenance;
  complete(model, header.provenance);
  add_bodies(model, state, header);
  add_laws(model, options.materials, header);
  add_bearings(model, header);
  for (const RecordedHistory& h : options.histories) header.histories.push_back({h.name, h.unit, h.description});
  for (const EnergyTermInfo& term : energy_term_info)
    header.energy_terms.push_back({std::string(term.name), "J", std::string(term.sentence)});
  header.with_velocity = options.with_velocity;
  return header;
}

std::string support_text(const std::array<Support, 3>& support) {
  const auto word = [](Support s) { return s == Support::free ? "free" : s == Support::fixed ? "fixed" : "moved"; };
  const auto all = [&](Support s) { return std::count(support.begin(), support.end(), s) == 3; };
  for (const Support s : {Support::free, Support::fixed})
    if (all(s)) return word(s);
  if (std::count(support.begin(), support.end(), Support::free) == 0) return "moved";
  return fmt::format("x {}, y {}, rotation {}", word(support[0]), word(support[1]), word(support[2]));
}

std::string drive_text(const Model<2>& model, const Drive& drive) {
  constexpr std::array names{"x", "y", "rotation"};
  const auto body =
      std::find_if(model.bodies.begin(), model.bodies.end(), [&](const Body& b) { return b.first_node == drive.node; });
  return fmt::format("{} on '{}' ({}), from t = {:g} s", drive.motion->description(),
                     body == model.bodies.end() ? "?" : body->name, names[static_cast<std::size_t>(drive.dof)],
                     drive.start);
}

std::string bearing_text(const Model<2>& model, const Bearing<2>& bearing) {
  constexpr std::array<const char*, 3> names{"along", "axial", "turning"}, units{"m", "m", "rad"};
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    out += fmt::format("{}{}: {}", k == 0 ? "" : "; ", names[k], direction_text(bearing.law[k]));
    if (bearing.limit[k] < unbounded) out += fmt::format(", limit {:g} {}", bearing.limit[k], units[k]);
  }
  if (bearing.angle != 0) out += fmt::format("; axes turned by {:g} rad", bearing.angle);
  if (bearing.starts_waiting) out += "; waits for another's failure";
  if (bearing.holds_off_contact) out += "; its bodies do not touch while it holds";
  if (bearing.contact_after >= 0) out += fmt::format("; becomes contact {}", model.law_names[bearing.contact_after]);
  if (bearing.becomes_bearing >= 0)
    out += fmt::format("; becomes bearing {}", model.bearings[bearing.becomes_bearing].name);
  return out;
}

}  // namespace trilith
