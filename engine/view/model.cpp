#include "view/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "draw/members/results_members.hpp"
#include "draw/palette.hpp"
#include "draw/results/solid_joints.hpp"
#include "model/event/event_list.hpp"
#include "results/file/body_mass.hpp"
#include "results/reading/event_units.hpp"
#include "results/reading/verdict.hpp"
#include "view/joints.hpp"

namespace trilith::view {
namespace {

bool is_shown_first(const results::EventRow& event) {
  return is_of_note(event.type, event.first.value);
}

std::string heading_in_words(const std::string& type) {
  const EventTypeInfo* const info = event_info(type);
  if (info != nullptr) return std::string(info->heading);
  std::string text = type;
  std::replace(text.begin(), text.end(), '.', ' ');
  return text;
}

/// Sorted by time; beyond the limit, important events and the earliest others.
std::vector<results::EventRow> chosen(std::vector<results::EventRow> events, double most) {
  if (static_cast<double>(events.size()) <= most) return events;
  double room = most - static_cast<double>(std::count_if(events.begin(), events.end(), is_shown_first));
  std::erase_if(events, [&](const results::EventRow& e) {
    // Tens of thousands of contacts made and lost are of little interest, so rests come before them.
    return !is_shown_first(e) && (e.type.starts_with("contact.") || --room < 0);
  });
  if (static_cast<double>(events.size()) > most) events.resize(static_cast<std::size_t>(most));
  return events;
}

std::string state_of(const results::ResultsReader& reader) {
  return reader.running() ? "running" : reader.finished() ? "finished" : "stopped";
}

void write_run(const results::ResultsReader& reader, const ViewFrames& frames, std::size_t left_out,
               const UnitSystem& units, JsonText& json) {
  const results::Provenance& from = reader.header().provenance;
  json.key("run").begin_object();
  json.text("name", reader.title()).text("state", state_of(reader));
  json.text("script", from.script).text("script_path", from.script_path).text("program", from.program_version);
  json.text("commit", from.git_commit).text("platform", from.platform).text("command", from.command_line);
  json.text("verdict", units.message(results::results_verdict(reader, reader.events()).text()));
  json.text("started", from.start_time).number("dim", reader.header().dim);
  json.number("frame_stride", static_cast<double>(frames.frame_stride));
  json.number("contact_stride", static_cast<double>(frames.contact_stride));
  json.number("events_left_out", static_cast<double>(left_out));
  json.key("parameters").begin_list();
  for (const results::ParameterRow& p : from.parameters)
    json.begin_list().text(p.name).text(p.value).text(p.unit).text(p.fallback).text(p.text).end();
  json.end().key("seal").begin_list();
  for (const SealRow& row : reader.seal()) json.begin_list().text(row.state).text(units.message(seal_text(row))).end();
  json.end().key("motions").begin_list();
  for (const std::string& motion : from.motions) json.text(motion);
  json.end().key("notes").begin_list();
  for (const results::Note& note : reader.notes())
    json.begin_list().number(note.time).text(units.message(note.text)).end();
  json.end().end();
}

/// Rounded to 1/parts: events keep their order to a millionth of a second.
double rounded(double value, double parts) {
  return std::round(value * parts) / parts;
}

/// For each face the number of its corners, then their vertex rows; and the start of the faces of each body.
void write_faces(const results::Header& header, JsonText& json) {
  json.key("faces").begin_list();
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    const results::BodyRow& body = header.bodies[i];
    json.begin_list();
    for (int f = body.first_face; f < body.first_face + body.face_count; ++f) {
      json.number(header.face_first[f + 1] - header.face_first[f]);
      for (int k = header.face_first[f]; k < header.face_first[f + 1]; ++k) json.number(header.face_vertex[k]);
    }
    json.end();
  }
  json.end();
}

/// For each sphere the vertex row of its centre, and its radius.
void write_spheres(const results::Header& header, JsonText& json) {
  json.key("spheres").begin_list();
  for (std::size_t s = 0; s < header.sphere_vertex.size(); ++s)
    json.number(header.sphere_vertex[s]).number(rounded(header.sphere_radius[s], 1e6));
  json.end();
}

void write_bodies(const results::Header& header, const ViewFrames& frames, JsonText& json) {
  const auto dim = static_cast<std::size_t>(header.dim);
  std::vector<int> bonds(header.bodies.size());
  for (const auto& [a, b] : frames.bonded) ++bonds[a], ++bonds[b];
  json.key("bodies").begin_list();
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    const results::BodyRow& b = header.bodies[i];
    json.begin_object().text("name", b.name).text("kind", b.kind).text("material", b.material);
    json.text("groups", b.groups).text("support", b.support).number("mass", results::mass_of(header, b));
    json.number("node", b.first_node).number("nodes", b.node_count);
    json.number("vertex", b.first_vertex).number("vertices", b.vertex_count).number("bonds", bonds[i]).end();
  }
  json.end().key("vertices").begin_list();
  for (std::size_t v = 0; v < header.vertex_node.size(); ++v) {
    json.number(header.vertex_node[v]);
    for (std::size_t k = 0; k < dim; ++k) json.number(rounded(header.vertices[dim * v + k], 1e6));
  }
  json.end();
  if (dim == 3) write_faces(header, json), write_spheres(header, json);
}

void write_elements(const results::Header& header, JsonText& json) {
  json.key("elements").begin_list();
  for (std::size_t i = 0; i < header.element_count(); ++i) {
    json.number(header.element_body[i]);
    for (std::size_t k = 0; k < 4; ++k) json.number(header.element_node[4 * i + k]);
  }
  json.end();
}

/// Members of frames, with the depth of those in the plane; and for each beam its nodes, arms and the top of its
/// section.
void write_members(const results::Header& header, JsonText& json) {
  const std::vector<draw::MemberDepth> depths = draw::member_depths(header);
  json.key("members").begin_list();
  for (std::size_t m = 0; m < header.members.size(); ++m) {
    const results::MemberRow& row = header.members[m];
    json.begin_object().text("name", row.name).text("from", row.from).text("to", row.to).text("yields", row.yields);
    json.number("body", row.body).number("first", row.first_beam).number("count", row.beam_count);
    json.number("above", rounded(depths[m].above, 1e6)).number("below", rounded(depths[m].below, 1e6));
    json.key("hinges").begin_list().flag(row.yield_rotation[0] > 0).flag(row.yield_rotation[1] > 0).end().end();
  }
  json.end().key("beams").begin_list();
  for (const results::BeamRow& beam : header.beams) {
    json.number(beam.node_a).number(beam.node_b);
    for (const double* const point : {beam.arm_a, beam.arm_b, beam.up})
      for (int k = 0; k < header.dim; ++k) json.number(rounded(point[k], 1e6));
  }
  json.end();
}

/// The node of a point of a body, and its offset from there: on a body with several nodes, the node with the nearest
/// outline point at the start. `point` is the initial offset from the first node.
struct PointOfNode {
  int node;
  double x, y, z;
};
PointOfNode point_of_node(const results::Header& header, const results::BodyRow& body, const double* point) {
  const int first = body.first_node;
  PointOfNode best{first, point[0], point[1], point[2]};
  if (body.node_count == 1) return best;
  const auto away = [&](int node, std::size_t k) {
    return point[k] + header.node_position[2 * first + k] - header.node_position[2 * node + k];
  };
  double least = std::numeric_limits<double>::infinity();
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    const int node = header.vertex_node[v];
    const double x = away(node, 0), y = away(node, 1);
    const double far = std::hypot(header.vertices[2 * v] - x, header.vertices[2 * v + 1] - y);
    if (far < least) least = far, best = {node, x, y, 0};
  }
  return best;
}

void write_bearings(const results::Header& header, const UnitSystem& units, JsonText& json) {
  json.key("bearings").begin_list();
  for (const results::BearingRow& b : header.bearings) {
    json.begin_object()
        .text("name", b.name)
        .text("law", units.message(b.law))
        .number("a", b.body_a)
        .number("b", b.body_b);
    const PointOfNode a = point_of_node(header, header.bodies[b.body_a], b.point_a),
                      at_b = point_of_node(header, header.bodies[b.body_b], b.point_b);
    json.number("an", a.node).number("ax", a.x).number("ay", a.y);
    if (header.dim == 3) json.number("az", a.z).number("bz", at_b.z);
    json.number("bn", at_b.node).number("bx", at_b.x).number("by", at_b.y).end();
  }
  json.end();
}

void write_stages(const results::ResultsReader& reader, JsonText& json) {
  json.key("stages").begin_list();
  for (const results::StageRow& s : reader.stages()) {
    json.begin_object().text("name", s.name).text("kind", s.kind).number("begin", s.begin).number("end", s.end);
    json.flag("ended", s.ended != 0).text("why", s.why).end();
  }
  json.end();
}

/// "tension", "shear" or "compression" if the event's text contains it: "... broke in shear at 3 kN"; otherwise "".
std::string mode_of(const results::EventRow& event) {
  for (const std::string mode : {"tension", "shear", "compression"})
    if (event.text.find(" in " + mode) != std::string::npos) return mode;
  return "";
}

void write_figure(const results::Figure& figure, JsonText& json) {
  if (figure.name.empty()) return;
  json.text(figure.name).number(figure.value).text(figure.unit);
}

void write_events(const std::vector<results::EventRow>& events, int dim, const UnitSystem& units, JsonText& json) {
  std::map<std::string, int> order;
  json.key("types").begin_list();
  for (const results::EventRow& e : events)
    if (order.emplace(e.type, static_cast<int>(order.size())).second)
      json.begin_list()
          .text(e.type)
          .text(heading_in_words(e.type))
          .text(std::string(name_of(severity_of(e.type))))
          .end();
  json.end().key("events").begin_list();
  for (const results::EventRow& e : events) {
    json.begin_list().number(static_cast<double>(e.id)).number(rounded(e.time, 1e6)).number(order[e.type]);
    json.flag(is_shown_first(e))
        .number(e.body_a)
        .number(e.body_b)
        .number(e.bearing)
        .number(static_cast<double>(e.cause));
    json.number(e.has_place ? rounded(e.place[0], 1e4) : NAN).number(e.has_place ? rounded(e.place[1], 1e4) : NAN);
    json.text(results::text_in(e, units)).begin_list();
    write_figure(e.first, json);
    write_figure(e.second, json);
    json.end();
    if (dim == 3) json.number(e.has_place ? rounded(e.place[2], 1e4) : NAN);
    json.end();
  }
  json.end();
}

/// The line along which a bond in the plane broke.
void write_joint(const results::EventRow& e, std::size_t index, const EdgePart& part, JsonText& json) {
  json.begin_list().number(static_cast<double>(index)).number(part.body).number(part.edge);
  json.number(rounded(part.from, 1e4)).number(rounded(part.to, 1e4)).text(mode_of(e)).end();
}

/// The outline of the joint whose bond in space broke, attached to one of its bodies.
void write_joint(const results::EventRow& e, std::size_t index, const draw::SolidJoint::Side& side, JsonText& json) {
  json.begin_list().number(static_cast<double>(index)).number(side.body).begin_list();
  for (const int row : side.corner) json.number(row);
  json.end().begin_list();
  for (const Vec2& share : side.share) json.number(rounded(share.x(), 1e4)).number(rounded(share.y(), 1e4));
  json.end().text(mode_of(e)).end();
}

/// Bonds that cracked or broke, each with the initial position of the joint.
void write_joints(const results::Header& header, const std::vector<results::EventRow>& events, JsonText& json) {
  const auto is_of_bond = [](const results::EventRow& e) {
    return e.type.starts_with("bond.") && std::min(e.body_a, e.body_b) >= 0;
  };
  std::map<std::pair<int, int>, std::vector<draw::SolidJoint>> solid;
  if (header.dim == 3 && std::any_of(events.begin(), events.end(), is_of_bond))
    for (draw::SolidJoint& joint : draw::solid_joints(header))
      solid[std::minmax(joint.a.body, joint.b.body)].push_back(std::move(joint));
  json.key("joints").begin_list();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const results::EventRow& e = events[i];
    if (!is_of_bond(e)) continue;
    // Written for both bodies, because one of them may be removed.
    if (header.dim == 2)
      for (const auto& [one, other] : {std::pair(e.body_a, e.body_b), std::pair(e.body_b, e.body_a)})
        for (const EdgePart& part : joint_of(header, one, other)) write_joint(e, i, part, json);
    else
      for (const draw::SolidJoint& joint : solid[std::minmax(e.body_a, e.body_b)])
        for (const draw::SolidJoint::Side& side : {joint.a, joint.b}) write_joint(e, i, side, json);
  }
  json.end();
}

std::string hex(const draw::Colour& c) {
  const auto channel = [](double v) { return static_cast<int>(std::lround(255 * v)); };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(c.red), channel(c.green), channel(c.blue));
}

void write_palette(JsonText& json) {
  constexpr int steps = 16;
  const draw::Palette& p = draw::palette();
  json.key("palette").begin_object().key("tints").begin_list();
  for (std::size_t i = 0; i < draw::body_tint_count; ++i) json.text(hex(draw::body_tint(i)));
  json.end().key("series").begin_list();
  for (std::size_t i = 0; i < draw::series_colour_count; ++i) json.text(hex(draw::series_colour(i)));
  json.end().key("sequential").begin_list();
  for (int i = 0; i <= steps; ++i) json.text(hex(draw::sequential_colour(static_cast<double>(i) / steps)));
  json.end().key("diverging").begin_list();
  for (int i = 0; i <= steps; ++i) json.text(hex(draw::diverging_colour(static_cast<double>(i) / steps)));
  json.end().text("force", hex(p.force)).text("yielded", hex(p.yielded)).text("failed", hex(p.failed));
  json.text("changed", hex(p.changed)).end();
}

}  // namespace

void write_view_model(const results::ResultsReader& reader, const ViewFrames& frames, const ViewLimits& limits,
                      const UnitSystem& units, JsonText& json) {
  const results::Header& header = reader.header();
  std::vector<results::EventRow> events = reader.events();
  const std::size_t all = events.size();
  events = chosen(std::move(events), limits.event_rows);
  write_run(reader, frames, all - events.size(), units, json);
  write_bodies(header, frames, json);
  write_elements(header, json);
  write_bearings(header, units, json);
  write_members(header, json);
  write_stages(reader, json);
  write_events(events, header.dim, units, json);
  write_joints(header, events, json);
  write_palette(json);
}

}  // namespace trilith::view
