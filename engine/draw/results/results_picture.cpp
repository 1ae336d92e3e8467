#include "draw/results/results_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "draw/members/results_members.hpp"
#include "draw/results/field_colours.hpp"
#include "draw/results/results_colours.hpp"
#include "draw/results/results_findings.hpp"
#include "draw/results/results_solids.hpp"
#include "draw/results/structure.hpp"
#include "model/event/event_list.hpp"
#include "results/file/placement.hpp"
#include "results/file/presence.hpp"
#include "results/reading/verdict.hpp"

namespace trilith::draw {

using results::BodyRow;
using results::Frame;
using results::Header;
using results::ResultsReader;

namespace {

/// Up to this number of grounds are distinguished by name and hatch; other bodies have the colour of their first group
/// or material.
constexpr int few_grounds = 3;

std::string group_of(const BodyRow& body, bool named) {
  if (named) return body.name;
  const std::string first = body.groups.substr(0, body.groups.find(' '));
  return first.empty() ? body.material : first;
}

/// World position of a point in the axes of a node in `frame`.
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
    case results::BearingState::absent:
      break;
  }
  return BearingMark::intact;
}

/// False for a waiting bearing, which carries no force, and for an absent one.
bool is_seen(results::BearingState state) {
  return state != results::BearingState::waiting && state != results::BearingState::absent;
}

/// Projection of a world point onto the picture.
using Flatten = std::function<Vec2(const Vec3&)>;

Flatten flatten_for(const Header& header, const ViewAxes& view) {
  if (header.dim == 2) return [](const Vec3& p) { return Vec2(p.x(), p.y()); };
  return [view](const Vec3& p) { return view.flat(p); };
}

/// Outlines of polyhedra are found with their faces.
void add_bodies(const Header& header, const Frame& frame, Scene& scene) {
  const auto is_ground = [](const BodyRow& body) { return role_of(body.support) != BodyRole::free; };
  const bool few = std::count_if(header.bodies.begin(), header.bodies.end(), is_ground) <= few_grounds;
  std::vector<std::vector<std::vector<Vec2>>> parts = member_parts(header, frame);
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    const BodyRow& body = header.bodies[i];
    std::vector<Vec2> outline;
    if (header.dim == 2) outline = outline_of(header, body, frame);
    // In a picture in space a name would not distinguish visible from hidden bodies.
    scene.bodies.push_back({header.dim == 2 ? body.name : "", std::move(outline), role_of(body.support),
                            group_of(body, few && is_ground(body))});
    scene.bodies.back().parts = std::move(parts[i]);
  }
}

bool touch(const Frame& frame, int a, int b) {
  return std::any_of(frame.contacts.begin(), frame.contacts.end(), [&](const results::ContactForce& c) {
    return (c.body_a == a && c.body_b == b) || (c.body_a == b && c.body_b == a);
  });
}

void add_bearings(const Header& header, const Frame& frame, const Flatten& flat, Scene& scene) {
  const results::Placement place(header, frame);
  for (std::size_t i = 0; i < header.bearings.size(); ++i) {
    if (!is_seen(frame.bearing_state[i])) continue;
    const results::BearingRow& b = header.bearings[i];
    const Vec3 a_end = place.end_of(header.bodies[b.body_a], b.point_a),
               b_end = place.end_of(header.bodies[b.body_b], b.point_b);
    SceneBearing out{flat(a_end), flat(b_end), mark_of(frame.bearing_state[i])};
    // The mark of a changed bearing, sliding on a seat, ends when its bodies separate.
    const double far = (a_end - b_end).norm();
    const bool apart = far > 1 || (far > 0.1 && !touch(frame, b.body_a, b.body_b));
    if (out.state == BearingMark::changed && apart) out.state = BearingMark::failed;
    scene.bearings.push_back(out);
  }
}

/// Of the pair of forces, draws the one on the supported body.
void add_forces(const Header& header, const Frame& frame, const Flatten& flat, Scene& scene) {
  for (const results::ContactForce& c : frame.contacts) {
    const bool a_is_ground = role_of(header.bodies[c.body_a].support) != BodyRole::free;
    const bool b_is_ground = role_of(header.bodies[c.body_b].support) != BodyRole::free;
    const bool on_a = a_is_ground == b_is_ground ? c.force[header.dim - 1] >= 0 : b_is_ground;
    const double sign = on_a ? 1 : -1;
    const Vec3 point(c.point[0], c.point[1], c.point[2]), force(c.force[0], c.force[1], c.force[2]);
    scene.forces.push_back({flat(point), flat(sign * force)});
  }
}

double size_of(const std::vector<Vec2>& outline) {
  double size = 0;
  for (const Vec2& p : outline) size = std::max(size, (p - outline.front()).norm());
  return size;
}

void add_ghosts(const Header& header, const Frame& start, const std::vector<bool>& left, Scene& scene) {
  constexpr double least_share = 0.05;  // of a body's size; smaller displacements get no second outline
  for (std::size_t i = 0; i < header.bodies.size(); ++i) {
    if (scene.bodies[i].role != BodyRole::free || left[i]) continue;
    const std::vector<Vec2> outline = outline_of(header, header.bodies[i], start);
    double moved = 0;
    for (std::size_t k = 0; k < outline.size(); ++k)
      moved = std::max(moved, (scene.bodies[i].outline[k] - outline[k]).norm());
    if (moved > least_share * size_of(outline)) scene.ghosts.push_back(outline);
  }
}

void require_time(const ResultsReader& reader, double time, const results::TimeOrigin& origin) {
  const std::vector<double>& times = reader.frame_times();
  if (times.empty())
    throw results::ResultsError(fmt::format("results file '{}': there is no frame to draw", reader.path().string()));
  const double spacing = (times.back() - times.front()) / static_cast<double>(times.size());
  if (!(time >= times.front() - 0.5 * spacing && time <= times.back() + 0.5 * spacing))
    throw InputError(fmt::format("time {:g} s{} is outside the frames of '{}', {:g} s to {:g} s", time - origin.zero,
                                 origin.text(), reader.path().string(), times.front() - origin.zero,
                                 times.back() - origin.zero));
}

/// At the change of stages there are two frames with the same time: the later one counts.
Frame frame_for(const ResultsReader& reader, double time, bool whole) {
  const std::vector<double>& times = reader.frame_times();
  std::size_t nearest = reader.nearest_frame(time);
  if (!whole && times[nearest] != time) return reader.frame_at(time);
  while (nearest + 1 < times.size() && times[nearest + 1] == times[nearest]) ++nearest;
  return reader.frame(nearest);
}

/// The title is the name of the stage; the caption shows one time, with the requested origin.
void add_stage(const ResultsReader& reader, const Frame& frame, Scene& scene) {
  const std::vector<results::StageRow> stages = reader.stages();
  if (frame.stage < 0 || frame.stage >= static_cast<int>(stages.size())) return;
  const results::StageRow& stage = stages[static_cast<std::size_t>(frame.stage)];
  scene.title = stage.name;
}

/// Bodies that had left the bounds, were removed or not yet added are not drawn, unless no body would remain.
std::vector<bool> left_bodies(const ResultsReader& reader, double time) {
  std::vector<bool> left(reader.header().bodies.size());
  const results::Presence presence(reader.events(), left.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = !presence.is_followed(i, time);
  if (std::find(left.begin(), left.end(), false) == left.end()) left.assign(left.size(), false);
  return left;
}

void drop_left(const std::vector<bool>& left, Scene& scene) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    if (!left[i]) std::swap(scene.bodies[kept++], scene.bodies[i]);
  scene.bodies.resize(kept);
}

/// The latest important event, if it is recent: an old one would appear under every later picture.
std::string event_before(const ResultsReader& reader, double time, double zero) {
  constexpr double recent = 1;  // [s]
  std::string out;
  for (const results::EventRow& e : events_of_note(reader)) {
    if (e.time > time) break;
    if (e.type == "stage.begun" || e.time < time - recent)
      out.clear();
    else
      out = fmt::format("{}: {}", time_label(e.time - zero), e.text);
  }
  return out;
}

}  // namespace

std::vector<results::EventRow> events_of_note(const ResultsReader& reader) {
  std::vector<results::EventRow> out;
  for (results::EventRow& e : reader.events()) {
    if (event_info(e.type) != nullptr && is_of_note(e.type, e.first.value)) out.push_back(std::move(e));
  }
  return out;
}

BodyRole role_of(const std::string& support) {
  if (support.find("free") != std::string::npos || support.empty()) return BodyRole::free;
  return support.find("moved") != std::string::npos ? BodyRole::moved_ground : BodyRole::fixed_ground;
}

namespace {

/// Checks that the requested contents are available.
void check_choice(const ResultsReader& reader, const SceneChoice& choice) {
  if (choice.magnify != 1 && (choice.forces || !choice.thrust.empty()))
    throw InputError("forces and the line of thrust cannot be drawn with magnified displacements; leave one out");
  if (!choice.stress.empty() && !choice.colour.empty() && choice.colour != "group")
    throw InputError(fmt::format("bodies cannot be coloured by their stress and by {} at once", choice.colour));
  const bool plane = reader.header().dim == 2;
  if (choice.magnify != 1 && !choice.diagram.empty())
    throw InputError("diagrams of section forces cannot be drawn with magnified displacements; leave one out");
  const bool by_joint = choice.colour == "pressure" || choice.colour == "water" || (!plane && !choice.stress.empty());
  if (choice.magnify != 1 && by_joint)
    throw InputError("colours by contact forces or water cannot be drawn with magnified displacements; leave one out");
  if (choice.envelope && choice.diagram.empty())
    throw InputError("an envelope needs a section force, such as --diagram moment");
  if (plane && choice.cut)
    throw InputError(fmt::format("'{}' is of a model in the plane, which cannot be cut", reader.path().string()));
  if (!plane && !choice.thrust.empty())
    throw InputError(fmt::format("'{}' is of a model in space; the line of thrust is drawn of models in the plane only",
                                 reader.path().string()));
}

/// Contents of pictures of plane models only, drawn over their bodies.
void add_findings(const Header& header, const Frame& frame, const SceneChoice& choice, const std::vector<bool>& left,
                  Scene& scene) {
  if (!choice.stress.empty()) colour_by_stress(header, frame, choice.stress, scene);
  if (choice.cracks) add_cracks(header, frame, left, scene);
  if (!choice.thrust.empty()) add_thrust_line(header, frame, choice.thrust, scene);
}

/// A moment to draw: the frame, and the omitted bodies.
struct Moment {
  Frame frame;
  std::vector<bool> left;
  std::vector<bool> crack_free;  ///< bodies without cracks: omitted, or no longer in place
};

Moment moment_at(const ResultsReader& reader, double time, const SceneChoice& choice) {
  require_time(reader, time, choice.origin);
  const bool by_fields = choice.colour == "temperature" || choice.colour == "water";
  const bool by_contacts = choice.colour == "pressure" || choice.colour == "damage";
  const bool whole = choice.forces || choice.cracks || by_contacts || by_fields || !choice.stress.empty() ||
                     !choice.thrust.empty() || !choice.diagram.empty();
  Frame frame = frame_for(reader, time, whole);
  if (choice.magnify != 1) magnify(reader.header(), frame, choice.magnify);
  std::vector<bool> left = left_bodies(reader, frame.time), crack_free = left;
  if (choice.cracks && !choice.all_cracks) {
    const std::vector<bool> moved = displaced(reader.header(), frame);
    for (std::size_t i = 0; i < left.size(); ++i) crack_free[i] = left[i] || moved[i];
  }
  return {std::move(frame), std::move(left), std::move(crack_free)};
}

/// Sets time, title and texts.
void add_words(const ResultsReader& reader, const Frame& frame, const SceneChoice& choice, Scene& scene) {
  scene.time = frame.time - choice.origin.zero;
  scene.since = choice.origin.text();
  add_stage(reader, frame, scene);
  scene.event = event_before(reader, frame.time, choice.origin.zero);
  const Verdict verdict = results::results_verdict(reader, reader.events());
  if (frame.time > verdict.sound_until()) scene.verdict = verdict.text(choice.origin.zero);
  if (choice.magnify != 1)
    scene.stage += fmt::format("{}displacements x {:g}", scene.stage.empty() ? "" : ", ", choice.magnify);
  if (choice.ghost)
    scene.ghost_label = fmt::format("at t = {:.3g} s", reader.frame_times().front() - choice.origin.zero);
}

/// Common data of the pictures of a figure.
struct SharedData {
  std::optional<SpaceBox> around;  ///< in space: AABB of the free bodies in all of them
  std::vector<SolidJoint> joints;  ///< in space
  std::optional<MemberEnvelope> envelope;
};

/// Hinges of members, and their diagrams.
void add_members(const Header& header, const Moment& moment, const SceneChoice& choice, const Flatten& flat,
                 const SharedData& shared, Scene& scene) {
  add_hinges(header, moment.frame, moment.left, flat, scene);
  if (choice.diagram.empty()) return;
  const results::MemberQuantity& quantity = results::member_quantity(header.dim, choice.diagram);
  add_diagrams(header, moment.frame, quantity, shared.envelope ? &*shared.envelope : nullptr, moment.left, flat, scene);
}

PairBonds bonds_at(const ResultsReader& reader, const Frame& frame) {
  PairBonds bonds;
  for (const results::EventRow& e : reader.events())
    if (e.type.starts_with("bond.") && e.time <= frame.time) bonds.lost.insert(std::minmax(e.body_a, e.body_b));
  for (const results::ContactForce& c : frame.contacts)
    if (c.state == results::ContactState::bonded) bonds.held.insert(std::minmax(c.body_a, c.body_b));
  return bonds;
}

void add_solids_at(const ResultsReader& reader, const Moment& moment, const SceneChoice& choice,
                   const SharedData& shared, Scene& scene) {
  const Header& header = reader.header();
  SolidsView shown{choice.from, choice.cut, shared.around};
  if (!shared.joints.empty())
    shown.cracks = solid_cracks(shared.joints, results::Placement(header, moment.frame), bonds_at(reader, moment.frame),
                                moment.crack_free);
  if (choice.colour == "temperature") shown.node_value = temperatures_of_nodes(header, moment.frame);
  add_solids(header, moment.frame, shown, moment.left, scene);
  if (choice.ghost) add_solid_ghosts(header, reader.frame(0), moment.frame, ViewAxes(choice.from), scene);
}

Scene scene_of(const ResultsReader& reader, const Moment& moment, const SceneChoice& choice, const SharedData& shared) {
  const Header& header = reader.header();
  const Frame& frame = moment.frame;
  const Flatten flat = flatten_for(header, ViewAxes(choice.from));
  Scene scene;
  add_words(reader, frame, choice, scene);
  add_bodies(header, frame, scene);
  const std::vector<bool> away = debris(header, frame);
  for (std::size_t i = 0; i < away.size(); ++i) scene.bodies[i].is_debris = away[i];
  if (!choice.colour.empty()) colour_bodies(reader, frame, choice.colour, scene);
  if (header.dim == 3 && !choice.stress.empty()) colour_by_space_stress(header, frame, choice.stress, scene);
  if (!header.bearings.empty()) add_bearings(header, frame, flat, scene);
  if (choice.forces) add_forces(header, frame, flat, scene);
  add_members(header, moment, choice, flat, shared, scene);
  if (header.dim == 3) {
    add_solids_at(reader, moment, choice, shared, scene);
    return scene;
  }
  add_findings(header, frame, choice, moment.crack_free, scene);
  const Frame start = reader.frame(0);
  if (choice.ghost) add_ghosts(header, start, moment.left, scene);
  for (std::size_t i = 0; i < header.bodies.size(); ++i)
    scene.bodies[i].start = outline_of(header, header.bodies[i], start);
  drop_left(moment.left, scene);
  return scene;
}

}  // namespace

Scene plain_scene(const Header& header, const Frame& frame) {
  Scene scene;
  add_bodies(header, frame, scene);
  return scene;
}

Scene results_scene(const ResultsReader& reader, double time, const SceneChoice& choice) {
  return results_scenes(reader, {time}, choice)[0];
}

std::optional<SpaceBox> box_of_free_bodies(const ResultsReader& reader, const std::vector<double>& times) {
  std::optional<SpaceBox> box;
  if (reader.header().dim < 3) return box;
  for (const double time : times) {
    const Frame frame = frame_for(reader, time, false);
    box = joined(box,
                 box_of_free(reader.header(), results::Placement(reader.header(), frame), left_bodies(reader, time)));
  }
  return box;
}

std::vector<Scene> results_scenes(const ResultsReader& reader, const std::vector<double>& times,
                                  const SceneChoice& choice) {
  check_choice(reader, choice);
  std::vector<Moment> moments;
  const Header& header = reader.header();
  SharedData shared{choice.around, {}, std::nullopt};
  if (choice.envelope && !header.members.empty())
    shared.envelope =
        member_envelope(reader, results::member_quantity(header.dim, choice.diagram), choice.span[0], choice.span[1]);
  if (header.dim == 3 && choice.cracks) shared.joints = solid_joints(header);
  for (const double time : times) {
    moments.push_back(moment_at(reader, time, choice));
    if (header.dim < 3 || choice.around) continue;
    const results::Placement at(header, moments.back().frame);
    shared.around = joined(shared.around, box_of_free(header, at, moments.back().left));
  }
  std::vector<Scene> scenes;
  for (const Moment& moment : moments) scenes.push_back(scene_of(reader, moment, choice, shared));
  return scenes;
}

}  // namespace trilith::draw
