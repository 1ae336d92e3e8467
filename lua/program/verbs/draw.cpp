// trilith draw RESULT [--at T,...] [-o FILE]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "base/error.hpp"
#include "draw/results/results_modes.hpp"
#include "draw/results/results_picture.hpp"
#include "draw/scene/view_direction.hpp"
#include "program/comma_list.hpp"
#include "program/newer_run.hpp"
#include "program/output_folder.hpp"
#include "program/scene_options.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct DrawOptions {
  SceneOptions scene;
  std::string at = "end", out, mode;
  int columns = 0;
};

/// A panel for each requested mode of the last analysis, or of the last one before the time of --at.
std::vector<draw::Scene> mode_scenes(const results::ResultsReader& reader, const DrawOptions& options) {
  const SceneOptions& scene = options.scene;
  if (scene.forces || scene.ghost || scene.cracks || !scene.stress.empty() || !scene.thrust.empty() ||
      !scene.diagram.empty() || scene.colour != "group")
    throw InputError(
        "--mode: shows the shape alone; leave out --forces, --ghost, --cracks, --stress, --thrust, "
        "--diagram, --colour");
  const bool last = options.at == "end" && scene.stage.empty();
  const std::vector<results::ModeRow> found =
      draw::modes_found(reader, last ? std::numeric_limits<double>::infinity()
                                     : scene_time(reader, scene_window(reader, scene), options.at, "--at"));
  std::vector<draw::Scene> scenes;
  for (const std::string& text : comma_list(options.mode)) {
    const double number = number_of(text, "--mode");
    const auto at = std::find_if(found.begin(), found.end(), [&](const auto& row) { return row.number == number; });
    if (at == found.end())
      throw InputError(fmt::format("--mode: there is no mode {}; '{}' has modes 1 to {}", text, reader.path().string(),
                                   found.size()));
    scenes.push_back(draw::mode_scene(reader, *at, scene.magnify, scene_choice(scene, reader.header().dim)));
  }
  return scenes;
}

/// The first event of a type in the window that has a place.
const results::EventRow* placed_event(const std::vector<results::EventRow>& events, const SceneWindow& window,
                                      const std::string& type) {
  const auto found = std::find_if(events.begin(), events.end(), [&](const results::EventRow& e) {
    return e.type == type && e.time >= window.begin && e.time <= window.end;
  });
  return found != events.end() && found->has_place ? &*found : nullptr;
}

/// Diagonal of the rectangle around the free bodies of a scene [m].
double extent(const draw::Scene& scene) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec2 low(far, far), high(-far, -far);
  const auto add = [&](const std::vector<Vec2>& outline) {
    for (const Vec2& p : outline) low = low.cwiseMin(p), high = high.cwiseMax(p);
  };
  const auto is_free = [&](std::size_t body) { return scene.bodies[body].role == draw::BodyRole::free; };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (is_free(i)) add(scene.bodies[i].outline);
  for (const draw::SceneFace& face : scene.faces)
    if (is_free(static_cast<std::size_t>(face.body))) add(face.outline);
  return high.x() > low.x() ? (high - low).norm() : 1;
}

/// A ring around the place of an event, with the type of the event in the legend.
void mark_event(const results::EventRow& event, const draw::SceneChoice& choice, int dim, draw::Scene& scene) {
  constexpr int corners = 48;
  const Vec3 place(event.place[0], event.place[1], event.place[2]);
  const Vec2 centre = dim == 2 ? Vec2(place.x(), place.y()) : draw::ViewAxes(choice.from).flat(place);
  const double radius = 0.03 * extent(scene);
  std::vector<Vec2> ring;
  for (int i = 0; i <= corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / corners;
    ring.emplace_back(centre + radius * Vec2(std::cos(turn), std::sin(turn)));
  }
  scene.lines.push_back(std::move(ring));
  if (scene.line_label.empty()) scene.line_label = "place of " + event.type;
}

std::vector<draw::Scene> scenes_of(const results::ResultsReader& reader, const DrawOptions& options) {
  if (!options.mode.empty()) return mode_scenes(reader, options);
  draw::SceneChoice choice = scene_choice(options.scene, reader.header().dim);
  const SceneWindow window = scene_window(reader, options.scene);
  choice.span = {window.begin, window.end};
  choice.origin = window.origin;  // the caption uses the same origin as --at
  const std::vector<std::string> moments = comma_list(options.at);
  std::vector<double> times;
  for (const std::string& at : moments) times.push_back(scene_time(reader, window, at, "--at"));
  std::vector<draw::Scene> scenes = draw::results_scenes(reader, times, choice);
  if (choice.magnify != 1 || !choice.thrust.empty()) return scenes;  // a ring would be misplaced, or share a label
  const std::vector<results::EventRow> events = reader.events();
  for (std::size_t i = 0; i < scenes.size(); ++i)
    if (const results::EventRow* event = placed_event(events, window, moments[i]))
      mark_event(*event, choice, reader.header().dim, scenes[i]);
  return scenes;
}

int draw(const DrawOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.scene.result).replace_extension(".png")
                                        : std::filesystem::path(options.out);
  draw::picture_format(out);
  const results::ResultsReader reader(options.scene.result);
  const draw::PictureStyle style = scene_style(options.scene, reader);
  std::vector<draw::Scene> scenes = scenes_of(reader, options);
  const std::string title = reader.title();
  if (scenes.size() == 1) scenes[0].title = scenes[0].title.empty() ? title : title + ", " + scenes[0].title;
  const int columns = options.columns > 0 ? options.columns : scenes.size() <= 3 ? 1 : 2;
  make_folder_for(out);
  draw::draw_panels(scenes, columns, style, out);
  fmt::print("{}\n", out.string());
  tell_of_newer_run(reader);
  return ended_well;
}

}  // namespace

void add_draw(CLI::App& app, int& code) {
  auto o = std::make_shared<DrawOptions>();
  CLI::App* verb = app.add_subcommand("draw", "Draw the structure at one or more moments of a run");
  add_scene_options(*verb, o->scene, "T");
  verb->add_option("--at", o->at,
                   "seconds from the start or from --stage or --since, 'start', 'end', or an event such as seat.lost "
                   "(the first); several, separated by commas, become panels")
      ->type_name("T[,T...]")
      ->capture_default_str();
  verb->add_option("-o,--output", o->out, "picture, .svg, .pdf or .png; default RESULT with .png")->type_name("FILE");
  verb->add_option("--mode", o->mode,
                   "natural modes by number, from the last call of m:modes, or the last before --at; several become "
                   "panels; --magnify is a factor on the automatic size")
      ->type_name("N[,N...]");
  verb->add_option("--columns", o->columns, "columns of panels")->check(CLI::Range(1, 20));
  verb->callback([o, &code] { code = draw(*o); });
}

}  // namespace trilith::program
