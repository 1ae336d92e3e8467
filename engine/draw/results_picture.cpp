#include "draw/results_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "draw/results_findings.hpp"
#include "results/verdict.hpp"
#include "world/event_text.hpp"

namespace trilith::draw {

using results::BodyRow;
using results::Frame;
using results::Header;
using results::ResultsReader;

namespace {

BodyRole role_of(const std::string& support) {
  if (support.find("free") != std::string::npos || support.empty()) return BodyRole::free;
  return support.find("moved") != std::string::npos ? BodyRole::moved_ground : BodyRole::fixed_ground;
}

/// Few grounds are told apart by name and hatch; other bodies have the colour of their first group, else material.
constexpr int few_grounds = 3;

std::string group_of(const BodyRow& body, bool named) {
  if (named) return body.name;
  const std::string first = body.groups.substr(0, body.groups.find(' '));
  return first.empty() ? body.material : first;
}

/// A point in the axes of a node, where that stands in `frame`.
Vec2 placed(const Frame& frame, int node, const Vec2& place) {
  const Vec2 at(frame.position[2 * node], frame.position[2 * node + 1]);
  return at + Turn(frame.rotation[node]).apply(place);
}

std::vector<Vec2> outline_of(const Header& header, const BodyRow& body, const Frame& frame) {
  std::vector<Vec2> out;
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
    out.push_back(placed(frame, header.vertex_node[v], {header.vertices[2 * v], header.vertices[2 * v + 1]}));
  return out;
}

/// Where a point of a body is that was `from_first` away from its first node at the start. On a body of several nodes
/// it goes with the one whose outline point was nearest.
Vec2 place_of_end(const Header& header, const BodyRow& body, const Vec2& from_first, const Frame& frame) {
  const auto start_of = [&](int n) { return Vec2(header.node_position[2 * n], header.node_position[2 * n + 1]); };
  const Vec2 start = start_of(body.first_node) + from_first;
  int node = body.first_node;
  double least = body.node_count == 1 ? -1 : std::numeric_limits<double>::infinity();
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    const int n = header.vertex_node[v];
    const double distance = (start_of(n) + Vec2(header.vertices[2 * v], header.vertices[2 * v + 1]) - start).norm();
    if (distance < least) least = distance, node = n;
  }
  return placed(frame, node, body.node_count == 1 ? from_first : Vec2(start - start_of(node)));
}

BearingMark mark_of(results::BearingState state) {
  switch (state) {
    case results::BearingState::yielded:
      return BearingMark::yielded;
    case results::BearingState::failed:
      return BearingMark::failed;
    case results::BearingState::changed:
      return BearingMark::changed;
    case results::BearingState::intact:
    case results::BearingState::waiting:
      break;
  }
  return BearingMark::intact;
}

void add_bodies(const Header& header, const Frame& frame, Scene& scene) {
  const auto is_ground = [](const BodyRow& body) { return role_of(body.support) != BodyRole::free; };
  const bool few = std::count_if(header.bodies.begin(), header.bodies.end(), is_ground) <= few_grounds;
  for (const BodyRow& body : header.bodies)
    scene.bodies.push_back(
        {body.name, outline_of(header, body, frame), role_of(body.support), group_of(body, few && is_ground(body))});
}

bool touch(const Frame& frame, int a, int b) {
  return std::any_of(frame.contacts.begin(), frame.contacts.end(), [&](const results::ContactForce& c) {
    return (c.body_a == a && c.body_b == b) || (c.body_a == b && c.body_b == a);
  });
}

void add_bearings(const Header& header, const Frame& frame, Scene& scene) {
  for (std::size_t i = 0; i < header.bearings.size(); ++i) {
    if (frame.bearing_state[i] == results::BearingState::waiting) continue;
    const results::BearingRow& b = header.bearings[i];
    const auto at = [&](int body, const double* point) {
      return place_of_end(header, header.bodies[body], {point[0], point[1]}, frame);
    };
    SceneBearing out{at(b.body_a, b.point_a), at(b.body_b, b.point_b), mark_of(frame.bearing_state[i])};
    // What it changed to, sliding on a seat, ends where its bodies part.
    const double far = (out.a - out.b).norm();
    const bool apart = far > 1 || (far > 0.1 && !touch(frame, b.body_a, b.body_b));
    if (out.state == BearingMark::changed && apart) out.state = BearingMark::failed;
    scene.bearings.push_back(out);
  }
}

/// Of the two bodies' forces the one on the body that is held up by it.
void add_forces(const Header& header, const Frame& frame, Scene& scene) {
  for (const results::ContactForce& c : frame.contacts) {
    const bool a_is_ground = role_of(header.bodies[c.body_a].support) != BodyRole::free;
    const bool b_is_ground = role_of(header.bodies[c.body_b].support) != BodyRole::free;
    const bool on_a = a_is_ground == b_is_ground ? c.force[1] >= 0 : b_is_ground;
    const double sign = on_a ? 1 : -1;
    scene.forces.push_back({{c.point[0], c.point[1]}, {sign * c.force[0], sign * c.force[1]}});
  }
}

double size_of(const std::vector<Vec2>& outline) {
  double size = 0;
  for (const Vec2& p : outline) size = std::max(size, (p - outline.front()).norm());
  return size;
}

void add_ghosts(const Header& header, const Frame& start, Scene& scene) {
  constexpr double least_share = 0.05;  // of a body's size, before it is worth a second outline
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    if (scene.bodies[i].role != BodyRole::free) continue;
    const std::vector<Vec2> outline = outline_of(header, header.bodies[i], start);
    double moved = 0;
    for (std::size_t k = 0; k < outline.size(); ++k)
      moved = std::max(moved, (scene.bodies[i].outline[k] - outline[k]).norm());
    if (moved > least_share * size_of(outline)) scene.ghosts.push_back(outline);
  }
  scene.ghost_label = fmt::format("at t = {:.3g} s", start.time);
}

void require_time(const ResultsReader& reader, double time) {
  const std::vector<double>& times = reader.frame_times();
  if (times.empty())
    throw results::ResultsError(fmt::format("results file '{}': there is no frame to draw", reader.path().string()));
  const double spacing = (times.back() - times.front()) / static_cast<double>(times.size());
  if (!(time >= times.front() - 0.5 * spacing && time <= times.back() + 0.5 * spacing))
    throw InputError(fmt::format("time {:g} s is outside the frames of '{}', {:g} s to {:g} s", time,
                                 reader.path().string(), times.front(), times.back()));
}

/// Where one stage ends and the next begins there are two frames of one time: the later one counts.
Frame frame_for(const ResultsReader& reader, double time, bool whole) {
  const std::vector<double>& times = reader.frame_times();
  std::size_t nearest = reader.nearest_frame(time);
  if (!whole && times[nearest] != time) return reader.frame_at(time);
  while (nearest + 1 < times.size() && times[nearest + 1] == times[nearest]) ++nearest;
  return reader.frame(nearest);
}

/// Title and how long the stage had run, where the moment is not counted from the start of the file anyway.
void add_stage(const ResultsReader& reader, const Frame& frame, Scene& scene) {
  const std::vector<results::StageRow> stages = reader.stages();
  if (frame.stage < 0 || frame.stage >= static_cast<int>(stages.size())) return;
  const results::StageRow& stage = stages[static_cast<std::size_t>(frame.stage)];
  scene.title = stage.name;
  if (stage.begin > 0) scene.stage = fmt::format("{:.2f} s into the stage", frame.time - stage.begin);
}

/// Leaves out bodies that had left the bounds, so that the picture is of what is still there; but not all.
void drop_left(const std::vector<results::EventRow>& events, double time, Scene& scene) {
  std::vector<bool> left(scene.bodies.size());
  for (const results::EventRow& e : events)
    if (e.type == "body.left" && e.time <= time && e.body_a >= 0 && e.body_a < static_cast<int>(left.size()))
      left[static_cast<std::size_t>(e.body_a)] = true;
  if (std::find(left.begin(), left.end(), false) == left.end()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (!left[i]) std::swap(scene.bodies[kept++], scene.bodies[i]);
  scene.bodies.resize(kept);
}

std::string event_before(const ResultsReader& reader, double time) {
  std::string out;
  for (const results::EventRow& e : events_of_note(reader)) {
    if (e.time > time) break;
    if (e.type != "stage.begun") out = fmt::format("{:.2f} s: {}", e.time, e.text);
  }
  return out;
}

}  // namespace

std::vector<results::EventRow> events_of_note(const ResultsReader& reader) {
  std::vector<results::EventRow> out;
  for (results::EventRow& e : reader.events()) {
    const auto info = std::find_if(event_type_info.begin(), event_type_info.end(),
                                   [&](const EventTypeInfo& known) { return known.name == e.type; });
    const auto type = static_cast<EventType>(info - event_type_info.begin());
    const bool slow = type == EventType::impact && e.first.value < slow_impact;
    if (info != event_type_info.end() && !has_trait(type, is_minor) && type != EventType::stage_ended && !slow)
      out.push_back(std::move(e));
  }
  return out;
}

results::StageRow find_stage(const ResultsReader& reader, std::string_view name) {
  std::vector<std::string> known;
  for (const results::StageRow& stage : reader.stages()) {
    if (stage.name == name) return stage;
    known.push_back(stage.name);
  }
  throw InputError(fmt::format("'{}' has no stage '{}'{}", reader.path().string(), name, name_hint(name, known)));
}

Scene results_scene(const ResultsReader& reader, double time, const SceneChoice& choice) {
  const Header& header = reader.header();
  if (header.dim != 2)
    throw InputError(
        fmt::format("'{}' is of a model in {} dimensions; only two can be drawn", reader.path().string(), header.dim));
  require_time(reader, time);
  if (choice.magnify != 1 && (choice.forces || !choice.thrust.empty()))
    throw InputError("forces and the line of thrust have no place among magnified displacements; leave one out");
  const bool whole = choice.forces || choice.cracks || !choice.stress.empty() || !choice.thrust.empty();
  Frame frame = frame_for(reader, time, whole);
  if (choice.magnify != 1) magnify(header, frame, choice.magnify);
  Scene scene;
  scene.time = frame.time;
  add_stage(reader, frame, scene);
  scene.event = event_before(reader, frame.time);
  scene.verdict = results::results_verdict(reader.events()).text();
  add_bodies(header, frame, scene);
  if (!header.bearings.empty()) add_bearings(header, frame, scene);
  if (choice.forces) add_forces(header, frame, scene);
  if (!choice.stress.empty()) colour_by_stress(header, frame, choice.stress, scene);
  if (choice.cracks) add_cracks(header, frame, scene);
  if (!choice.thrust.empty()) add_thrust_line(header, frame, choice.thrust, scene);
  if (choice.magnify != 1)
    scene.stage += fmt::format("{}displacements x {:g}", scene.stage.empty() ? "" : ", ", choice.magnify);
  if (choice.ghost) add_ghosts(header, reader.frame(0), scene);
  drop_left(reader.events(), frame.time, scene);
  return scene;
}

}  // namespace trilith::draw
