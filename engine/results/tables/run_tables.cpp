#include "results/tables/run_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "model/event/event.hpp"
#include "results/file/body_mass.hpp"
#include "results/file/placement.hpp"
#include "results/file/presence.hpp"
#include "results/reading/event_units.hpp"
#include "results/reading/member_values.hpp"

namespace trilith::results {
namespace {

/// Cells that are given to a sink one after the other.
class Cells {
 public:
  Cells(TableSink& out, const UnitSystem& units) : out_(out), units_(units) {}
  Cells& cell(std::string_view text) {
    out_.text(text);
    return *this;
  }
  Cells& cell(double value) {
    out_.number(value);
    return *this;
  }
  /// A number in the SI unit `unit`, written in the units of the table.
  Cells& cell(double value, std::string_view unit) { return cell(units_.shown(value, unit)); }
  /// A text of the engine, whose numbers are written in the units of the table.
  Cells& message(std::string_view text) { return cell(units_.message(text)); }
  [[nodiscard]] std::string text_of(const EventRow& event) const { return text_in(event, units_); }
  [[nodiscard]] std::string unit(std::string_view si) const { return units_.name(si); }
  Cells& count(std::int64_t value) {
    out_.count(value);
    return *this;
  }
  Cells& head(std::string_view name, std::string_view unit) {
    return cell(unit.empty() || unit == "1" ? std::string(name) : fmt::format("{} [{}]", name, units_.name(unit)));
  }
  /// "x [m]", "y [m]" and, in space, "z [m]" behind `prefix`.
  Cells& axes(std::string_view prefix, std::string_view unit, int dim) {
    for (int k = 0; k < dim; ++k) head(fmt::format("{}{}", prefix, "xyz"[k]), unit);
    return *this;
  }
  Cells& triple(const Vec3& value, std::string_view unit, int dim) {
    for (int k = 0; k < dim; ++k) cell(value[k], unit);
    return *this;
  }
  void end_row() { out_.end_row(); }

 private:
  TableSink& out_;
  const UnitSystem& units_;
};

/// Columns of numbers below a time.
void write_columns(const std::vector<double>& times, const std::vector<Quantity>& heads,
                   const std::vector<std::vector<double>>& columns, Cells& out) {
  out.head("time", "s");
  for (const Quantity& q : heads) out.head(q.name, q.unit);
  out.end_row();
  for (std::size_t i = 0; i < times.size(); ++i) {
    out.cell(times[i]);
    for (std::size_t k = 0; k < columns.size(); ++k) out.cell(columns[k][i], heads[k].unit);
    out.end_row();
  }
}

void write_histories(const ResultsReader& reader, Cells& out) {
  std::vector<std::vector<double>> columns;
  for (const Quantity& q : reader.header().histories) columns.push_back(reader.history(q.name));
  write_columns(reader.history_times(), reader.header().histories, columns, out);
}

void write_energy(const ResultsReader& reader, Cells& out) {
  const EnergyTable energy = reader.energy();
  std::vector<Quantity> heads = reader.header().energy_terms;
  std::vector<std::vector<double>> columns = energy.terms;
  heads.push_back({"residual", "J", ""});
  columns.push_back(energy.residual);
  write_columns(energy.time, heads, columns, out);
}

/// The word for the number of a failure mode; "" for a number of a later version.
std::string_view joint_mode(double code) {
  for (const JointMode mode : {JointMode::tension, JointMode::shear, JointMode::compression})
    if (code == static_cast<double>(mode)) return name_of(mode);
  return "";
}

void write_events(const ResultsReader& reader, Cells& out) {
  for (const char* name : {"id", "time [s]", "step", "stage", "type", "body_a", "body_b", "bearing"}) out.cell(name);
  out.axes("", "m", 3);
  for (const char* name : {"mode", "figure_1", "value_1", "unit_1", "figure_2", "value_2", "unit_2", "cause", "text"})
    out.cell(name);
  out.end_row();
  for (const EventRow& e : reader.events()) {
    out.count(e.id).cell(e.time).count(e.step).count(e.stage).cell(e.type);
    out.cell(e.body_a_name).cell(e.body_b_name).cell(e.bearing_name);
    for (int k = 0; k < 3; ++k) {
      if (e.has_place && k < reader.header().dim)
        out.cell(e.place[k], "m");
      else
        out.cell("");
    }
    const bool of_joint = e.second.name == "mode";
    out.cell(of_joint ? joint_mode(e.second.value) : "");
    for (const Figure& f : {e.first, of_joint ? Figure{} : e.second}) {
      if (f.name.empty())
        out.cell("").cell("").cell("");
      else
        out.cell(f.name).cell(f.value, f.unit).cell(out.unit(f.unit));
    }
    out.cell(e.cause < 0 ? std::string() : fmt::format("{}", e.cause)).cell(out.text_of(e)).end_row();
  }
}

void write_stages(const ResultsReader& reader, Cells& out) {
  out.cell("name").cell("kind").head("begin", "s").head("end", "s").cell("why").end_row();
  for (const StageRow& s : reader.stages()) {
    out.cell(s.name).cell(s.kind).cell(s.begin);
    if (s.ended)
      out.cell(s.end);
    else
      out.cell("");
    out.cell(s.why).end_row();
  }
}

void write_notes(const ResultsReader& reader, Cells& out) {
  out.head("time", "s").cell("text").end_row();
  for (const Note& n : reader.notes()) out.cell(n.time).message(n.text).end_row();
}

void write_modes(const ResultsReader& reader, Cells& out) {
  const int dim = reader.header().dim;
  out.cell("analysis").cell("number").head("time", "s").head("frequency", "Hz").cell("damping");
  out.axes("effective mass ", "kg", dim).end_row();
  for (const ModeRow& m : reader.modes()) {
    out.count(m.analysis).count(m.number).cell(m.time).cell(m.frequency).cell(m.damping);
    out.triple(Vec3(m.mass[0], m.mass[1], m.mass[2]), "kg", dim).end_row();
  }
}

void write_parameters(const ResultsReader& reader, Cells& out) {
  out.cell("name").cell("value").cell("unit").cell("default").cell("text").end_row();
  for (const ParameterRow& p : reader.header().provenance.parameters)
    out.cell(p.name).cell(p.value).cell(p.unit).cell(p.fallback).cell(p.text).end_row();
}

/// Centre of mass of a body's nodes; without mass, the mean of its nodes.
Vec3 centre_of(const Header& header, const BodyRow& body, const Placement& at) {
  const double mass = mass_of(header, body);
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < body.node_count; ++i) {
    const double share =
        mass > 0 ? header.node_mass[static_cast<std::size_t>(body.first_node + i)] / mass : 1.0 / body.node_count;
    sum += share * at.node(body.first_node + i);
  }
  return sum;
}

/// The centre at the start, the displacement from it, and the rotation of the first node.
void write_bodies(const ResultsReader& reader, const std::vector<double>& times, Cells& out) {
  const Header& header = reader.header();
  const Presence presence(reader.events(), header.bodies.size());
  const Frame start = start_frame(header);
  const Placement at_start(header, start);
  out.head("time", "s").cell("body").cell("kind").cell("material").cell("groups").cell("support").head("mass", "kg");
  out.cell("present").axes("", "m", header.dim).axes("u", "m", header.dim).head("rotation", "rad").end_row();
  for (const double time : times) {
    const Frame frame = reader.frame_at(time);
    const Placement now(header, frame);
    for (std::size_t i = 0; i < header.bodies.size(); ++i) {
      const BodyRow& body = header.bodies[i];
      const Vec3 centre = centre_of(header, body, now);
      out.cell(time).cell(body.name).cell(body.kind).cell(body.material).cell(body.groups).cell(body.support);
      out.cell(mass_of(header, body), "kg")
          .count(presence.is_followed(i, time) ? 1 : 0)
          .triple(centre, "m", header.dim);
      out.triple(centre - centre_of(header, body, at_start), "m", header.dim)
          .cell(now.turned(body.first_node))
          .end_row();
    }
  }
}

const char* state_name(BearingState state) {
  constexpr const char* names[] = {"intact", "yielded", "failed", "changed", "waiting", "absent"};
  return names[static_cast<int>(state)];
}

void write_bearings(const ResultsReader& reader, const std::vector<double>& times, Cells& out) {
  const Header& header = reader.header();
  const auto dim = static_cast<std::size_t>(header.dim);
  out.head("time", "s").cell("bearing").cell("body_a").cell("body_b").cell("law").cell("state");
  out.axes("force on b, ", "N", header.dim).head("displacement along", "m");
  if (header.dim == 3) out.head("displacement across", "m");
  out.head("displacement axial", "m").end_row();
  for (const double time : times) {
    const Frame frame = reader.frame_at(time);
    for (std::size_t i = 0; i < header.bearings.size(); ++i) {
      const BearingRow& b = header.bearings[i];
      out.cell(time).cell(b.name).cell(header.bodies[static_cast<std::size_t>(b.body_a)].name);
      out.cell(header.bodies[static_cast<std::size_t>(b.body_b)].name).message(b.law);
      out.cell(state_name(frame.bearing_state[i]));
      for (std::size_t k = 0; k < dim; ++k) out.cell(frame.bearing_force[dim * i + k], "N");
      for (std::size_t k = 0; k < dim; ++k) out.cell(frame.bearing_displacement[dim * i + k], "m");
      out.end_row();
    }
  }
}

const char* state_name(MemberState state) {
  constexpr const char* names[] = {"elastic", "yielded", "without moment", "removed"};
  return names[static_cast<int>(state)];
}

/// A row for each end of each beam, with the distance from the start of the member.
void write_members(const ResultsReader& reader, const std::vector<double>& times, Cells& out) {
  const Header& header = reader.header();
  out.head("time", "s").cell("body").cell("member").cell("from").cell("to").head("along", "m");
  out.axes("", "m", header.dim);
  for (const MemberQuantity& q : member_quantities(header.dim)) out.head(q.name, q.unit == "N*m" ? "N m" : q.unit);
  out.cell("state").cell(fmt::format("deformation [rad or {}]", out.unit("1/m"))).end_row();
  if (header.members.empty()) return;
  for (const double time : times) {
    const Frame frame = reader.frame(reader.nearest_frame(time));
    const Placement at(header, frame);
    const MemberValues values(header, frame);
    for (const MemberRow& member : header.members) {
      double along = 0;
      for (int i = member.first_beam; i < member.first_beam + member.beam_count; ++i) {
        const BeamRow& beam = header.beams[static_cast<std::size_t>(i)];
        for (const int end : {0, 1}) {
          const double* const arm = end == 0 ? beam.arm_a : beam.arm_b;
          out.cell(frame.time).cell(header.bodies[static_cast<std::size_t>(member.body)].name).cell(member.name);
          out.cell(member.from).cell(member.to).cell(along + end * beam.length, "m");
          out.triple(at.at(end == 0 ? beam.node_a : beam.node_b, Vec3(arm[0], arm[1], arm[2])), "m", header.dim);
          for (const MemberQuantity& q : member_quantities(header.dim))
            out.cell(values.force(static_cast<std::size_t>(i), end, q), q.unit);
          out.cell(state_name(values.state(static_cast<std::size_t>(i), end)));
          out.cell(values.deformation(static_cast<std::size_t>(i), end), member.yields == "fibres" ? "1/m" : "rad")
              .end_row();
        }
        along += beam.length;
      }
    }
  }
}

using Writer = std::function<void(const ResultsReader&, const std::vector<double>&, Cells&)>;

/// A table without moments.
template <void (*write)(const ResultsReader&, Cells&)>
void whole_run(const ResultsReader& reader, const std::vector<double>&, Cells& out) {
  write(reader, out);
}

const std::vector<std::pair<std::string, Writer>>& writers() {
  static const std::vector<std::pair<std::string, Writer>> list{{"histories", whole_run<write_histories>},
                                                                {"energy", whole_run<write_energy>},
                                                                {"events", whole_run<write_events>},
                                                                {"stages", whole_run<write_stages>},
                                                                {"bodies", write_bodies},
                                                                {"bearings", write_bearings},
                                                                {"members", write_members},
                                                                {"modes", whole_run<write_modes>},
                                                                {"notes", whole_run<write_notes>},
                                                                {"parameters", whole_run<write_parameters>}};
  return list;
}

}  // namespace

const std::vector<std::string>& table_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& entry : writers()) list.push_back(entry.first);
    return list;
  }();
  return names;
}

void write_table(const ResultsReader& reader, std::string_view name, const std::vector<double>& times, TableSink& out,
                 const UnitSystem& units) {
  Cells cells(out, units);
  for (const auto& [known, write] : writers())
    if (known == name) return write(reader, times, cells);
  throw InputError(fmt::format("there is no table '{}'{}", name, name_hint(name, table_names())));
}

}  // namespace trilith::results
