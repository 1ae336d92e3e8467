#include "draw/results/results_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "draw/results/results_solids.hpp"
#include "results/file/placement.hpp"
#include "results/file/presence.hpp"

namespace trilith::draw {

using results::Frame;
using results::Header;
using results::ModeRow;

namespace {

/// Largest displacement in the picture, as a share of the structure's size; largest turn [rad].
constexpr double shown_share = 0.06, most_shown_turn = 0.5;

/// Applies a rotation vector to a quaternion.
void turn_on(double* q, const Vec3& angle) {
  const UnitQuaternion now = rotation_by(angle) * UnitQuaternion{q[0], q[1], q[2], q[3]};
  q[0] = now.w, q[1] = now.x, q[2] = now.y, q[3] = now.z;
}

/// The nodes in their initial position plus `scale` times the mode.
Frame moved(const Header& header, const ModeRow& mode, double scale) {
  Frame frame;
  frame.time = mode.time;
  frame.position = mode.position, frame.rotation = mode.rotation;
  for (std::size_t i = 0; i < frame.position.size(); ++i) frame.position[i] += scale * mode.displacement[i];
  for (std::size_t i = 0; i < header.node_count(); ++i) {
    if (header.dim == 2)
      frame.rotation[i] += scale * mode.turn[i];
    else
      turn_on(&frame.rotation[4 * i], Vec3(scale * Vec3::Map(&mode.turn[3 * i])));
  }
  return frame;
}

/// Limits the displacement of the mode in the picture.
double shown_scale(double size, double way, double turn) {
  const double by_way = way > 0 ? shown_share * size / way : 1;
  return turn * by_way > most_shown_turn ? most_shown_turn / turn : by_way;
}

/// In space: by the corners of the polyhedra.
double scale_in_space(const Header& header, const ModeRow& mode) {
  const Frame frame = moved(header, mode, 0);
  const results::Placement at(header, frame);
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  double most = 0, most_turn = 0;
  for (const results::BodyRow& body : header.bodies) {
    if (body.support.find("free") == std::string::npos && !body.support.empty()) continue;
    for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
      const auto n = static_cast<std::size_t>(header.vertex_node[static_cast<std::size_t>(v)]);
      const Vec3 place = at.vertex(v), turn = Vec3::Map(&mode.turn[3 * n]);
      const Vec3 way =
          Vec3::Map(&mode.displacement[3 * n]) + cross(turn, Vec3(place - Vec3::Map(&mode.position[3 * n])));
      low = low.cwiseMin(place), high = high.cwiseMax(place);
      most = std::max(most, way.norm()), most_turn = std::max(most_turn, turn.norm());
    }
  }
  return shown_scale((high - low).norm(), most, most_turn);
}

/// Diagonal of the AABB of all free bodies [m].
double size_of_free(const Scene& scene) {
  Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
  for (const SceneBody& body : scene.bodies)
    if (body.role == BodyRole::free)
      for (const Vec2& p : body.outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

std::string mode_text(const ModeRow& mode) {
  if (!(mode.frequency > 0)) return "does not oscillate";
  return fmt::format("{:.4g} Hz, damping {:.2g} %", mode.frequency, 100 * mode.damping);
}

}  // namespace

std::vector<ModeRow> modes_found(const results::ResultsReader& reader, double time) {
  std::vector<ModeRow> all = reader.modes();
  if (all.empty())
    throw InputError(fmt::format(
        "'{}' has no natural modes; compute them in the script with m:modes() and record them with m:results",
        reader.path().string()));
  int last = -1;
  for (const ModeRow& mode : all)
    if (mode.time <= time) last = mode.analysis;
  if (last < 0)
    throw InputError(fmt::format("'{}' has no modes at or before {:g} s; the first were computed at {:g} s",
                                 reader.path().string(), time, all.front().time));
  std::erase_if(all, [&](const ModeRow& mode) { return mode.analysis != last; });
  return all;
}

double mode_scale(const Header& header, const ModeRow& mode) {
  if (header.dim == 3) return scale_in_space(header, mode);
  const double size = size_of_free(plain_scene(header, moved(header, mode, 0)));
  double most = 0, turn = 0;
  for (std::size_t v = 0; v < header.vertex_node.size(); ++v) {
    const auto n = static_cast<std::size_t>(header.vertex_node[v]);
    const Vec2 arm = Turn(mode.rotation[n]).apply(Vec2(header.vertices[2 * v], header.vertices[2 * v + 1]));
    const Vec2 way = Vec2(mode.displacement[2 * n], mode.displacement[2 * n + 1]) + cross(mode.turn[n], arm);
    most = std::max(most, way.norm()), turn = std::max(turn, std::abs(mode.turn[n]));
  }
  return shown_scale(size, most, turn);
}

namespace {

/// Title and time of a picture of a mode.
Scene titled(Scene scene, const ModeRow& mode) {
  scene.title = fmt::format("mode {}", mode.number);
  scene.time = mode.time;
  scene.stage = mode_text(mode);
  return scene;
}

/// Bodies in `gone` are omitted; empty: none.
Scene scene_of_mode(const Header& header, const ModeRow& mode, double magnify, const std::vector<bool>& gone) {
  const Scene stood = plain_scene(header, moved(header, mode, 0));
  const double scale = magnify * mode_scale(header, mode);
  Scene scene = titled(plain_scene(header, moved(header, mode, scale)), mode);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stood.bodies.size(); ++i) {
    if (i < gone.size() && gone[i]) continue;
    if (stood.bodies[i].role == BodyRole::free) scene.ghosts.push_back(stood.bodies[i].outline);
    std::swap(scene.bodies[kept++], scene.bodies[i]);
  }
  scene.bodies.resize(kept);
  scene.ghost_label = "reference shape";
  return scene;
}

}  // namespace

Scene mode_scene(const Header& header, const ModeRow& mode, double magnify) {
  return scene_of_mode(header, mode, magnify, {});
}

Scene mode_scene(const results::ResultsReader& reader, const ModeRow& mode, double magnify, const SceneChoice& choice) {
  const Header& header = reader.header();
  const results::Presence presence(reader.events(), header.bodies.size());
  std::vector<bool> gone(header.bodies.size());
  for (std::size_t i = 0; i < gone.size(); ++i) gone[i] = !presence.is_followed(i, mode.time);
  if (header.dim == 2) return scene_of_mode(header, mode, magnify, gone);
  const Frame stood = moved(header, mode, 0), now = moved(header, mode, magnify * mode_scale(header, mode));
  Scene scene = titled(plain_scene(header, now), mode);
  const std::optional<SpaceBox> around = box_of_free(header, results::Placement(header, now), gone);
  add_solids(header, now, {choice.from, choice.cut, around}, gone, scene);
  add_solid_ghosts(header, stood, now, ViewAxes(choice.from), scene);
  scene.ghost_label = "reference shape";
  return scene;
}

}  // namespace trilith::draw
