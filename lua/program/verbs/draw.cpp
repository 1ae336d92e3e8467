// trilith draw RESULT [--at T,...] [-o FILE]
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "draw/scene/results_findings.hpp"
#include "draw/scene/results_modes.hpp"
#include "draw/scene/results_picture.hpp"
#include "program/comma_list.hpp"
#include "program/newer_run.hpp"
#include "program/output_folder.hpp"
#include "program/positive.hpp"
#include "program/since_option.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct DrawOptions {
  std::string result, at = "end", stage, since, out, view, units = "si";
  bool forces = false, ghost = false, cracks = false;
  std::string stress, thrust;
  double magnify = 1;
  std::string colour = "group", cut;
  std::string mode, names = "auto";
  int columns = 0;
};

/// Begin and end of the window [s of the run], and the origin of T.
struct Window {
  double begin, end;
  results::TimeOrigin origin;
};

Window window_of(const results::ResultsReader& reader, const std::string& stage, const std::string& since) {
  const std::vector<double>& times = reader.frame_times();
  if (times.empty())
    throw results::ResultsError(fmt::format("results file '{}': there is no frame to draw", reader.path().string()));
  if (stage.empty()) return {0, times.back(), results::time_origin(reader, since)};
  const results::StageRow row = results::find_stage(reader, stage);
  return {row.begin, row.ended ? row.end : times.back(), results::time_origin(reader, since.empty() ? stage : since)};
}

/// A number of seconds, "start", "end", or the type of an event: the first one of it in the window.
double time_of(const results::ResultsReader& reader, const Window& window, const std::string& text) {
  if (text == "end") return window.end;
  if (text == "start") return std::max(window.begin, reader.frame_times().front());
  if (text.empty() || std::string("0123456789+-.").find(text[0]) != std::string::npos)
    return window.origin.zero + number_of(text, "--at");
  std::vector<std::string> known{"start", "end"};
  for (const results::EventRow& e : reader.events()) {
    if (e.type == text && e.time >= window.begin && e.time <= window.end) return e.time;
    if (std::find(known.begin(), known.end(), e.type) == known.end()) known.push_back(e.type);
  }
  throw InputError(
      fmt::format("--at: '{}' is neither a time nor an event of this run{}", text, name_hint(text, known)));
}

draw::PictureStyle style_of(const DrawOptions& options, int dim) {
  draw::PictureStyle style;
  style.units = options.units == "us" ? draw::LengthUnits::us : draw::LengthUnits::si;
  if (options.names != "auto") style.label_limit = options.names == "all" ? std::numeric_limits<int>::max() : 0;
  if (options.view.empty() || dim == 3) return style;
  const std::vector<std::string> ends = comma_list(options.view);
  if (ends.size() != 4)
    throw InputError(fmt::format("--view: '{}' must be four numbers x0,y0,x1,y1 in metres", options.view));
  const auto end = [&](std::size_t i) { return number_of(ends[i], "--view"); };
  style.view = draw::WorldBox{end(0), end(1), end(2), end(3)};
  return style;
}

/// "x=2": all points whose x is 2 m.
draw::CutPlane cut_plane(const std::string& text) {
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || text[1] != '=')
    throw InputError(fmt::format("--cut: '{}' must be an axis and a place on it in metres, such as x=2.5", text));
  return {Vec3::Unit(text[0] - 'x'), number_of(text.substr(2), "--cut")};
}

draw::SceneChoice choice_of(const DrawOptions& options, int dim) {
  draw::SceneChoice choice{options.forces,
                           options.ghost,
                           options.cracks,
                           options.stress,
                           options.thrust,
                           options.magnify,
                           options.colour,
                           {},
                           {},
                           std::nullopt};
  if (dim == 3 && !options.view.empty()) choice.from = draw::view_direction(options.view);
  if (!options.cut.empty()) choice.cut = cut_plane(options.cut);
  return choice;
}

/// A panel for each requested mode of the last analysis, or of the last one before the time of --at.
std::vector<draw::Scene> mode_scenes(const results::ResultsReader& reader, const DrawOptions& options) {
  if (options.forces || options.ghost || options.cracks || !options.stress.empty() || !options.thrust.empty() ||
      options.colour != "group")
    throw InputError(
        "--mode: shows the shape alone; leave out --forces, --ghost, --cracks, --stress, --thrust, --colour");
  const bool last = options.at == "end" && options.stage.empty();
  const std::vector<results::ModeRow> found =
      draw::modes_found(reader, last ? std::numeric_limits<double>::infinity()
                                     : time_of(reader, window_of(reader, options.stage, options.since), options.at));
  std::vector<draw::Scene> scenes;
  for (const std::string& text : comma_list(options.mode)) {
    const double number = number_of(text, "--mode");
    const auto at = std::find_if(found.begin(), found.end(), [&](const auto& row) { return row.number == number; });
    if (at == found.end())
      throw InputError(fmt::format("--mode: there is no mode {}; '{}' has modes 1 to {}", text, reader.path().string(),
                                   found.size()));
    scenes.push_back(draw::mode_scene(reader, *at, options.magnify, choice_of(options, reader.header().dim)));
  }
  return scenes;
}

std::vector<draw::Scene> scenes_of(const results::ResultsReader& reader, const DrawOptions& options) {
  if (!options.mode.empty()) return mode_scenes(reader, options);
  draw::SceneChoice choice = choice_of(options, reader.header().dim);
  const Window window = window_of(reader, options.stage, options.since);
  choice.origin = window.origin;  // the caption uses the same origin as --at
  std::vector<double> times;
  for (const std::string& at : comma_list(options.at)) times.push_back(time_of(reader, window, at));
  return draw::results_scenes(reader, times, choice);
}

int draw(const DrawOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.result).replace_extension(".png")
                                        : std::filesystem::path(options.out);
  draw::picture_format(out);
  const results::ResultsReader reader(options.result);
  const draw::PictureStyle style = style_of(options, reader.header().dim);
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
  verb->add_option("result", o->result, "results file, also of a run that was killed or is in progress")
      ->required()
      ->type_name("RESULT");
  verb->add_option("--at", o->at,
                   "seconds from the start or from --stage or --since, 'start', 'end', or an event such as seat.lost "
                   "(the first); several, separated by commas, become panels")
      ->type_name("T[,T...]")
      ->capture_default_str();
  verb->add_option("--stage", o->stage, "within this stage, with T counted from its beginning")->type_name("NAME");
  add_since(*verb, o->since);
  verb->add_option("-o,--output", o->out, "picture, .svg, .pdf or .png; default RESULT with .png")->type_name("FILE");
  verb->add_flag("--forces", o->forces, "contact forces");
  verb->add_flag("--ghost", o->ghost, "positions of the bodies at the start");
  verb->add_flag("--cracks", o->cracks, "joints that have lost their bond, and dry joints, by opening or slip");
  verb->add_option("--stress", o->stress,
                   "colour bodies by their mean stress: smaller or larger principal, or a component")
      ->check(CLI::IsMember(draw::stress_names()));
  verb->add_option("--thrust", o->thrust, "the line of thrust through the bodies of this group, in their order")
      ->type_name("GROUP");
  verb->add_option("--magnify", o->magnify, "factor on displacements since the start")
      ->type_name("FACTOR")
      ->check(CLI::Validator(is_positive, "", ""));
  verb->add_option("--mode", o->mode,
                   "natural modes by number, from the last call of m:modes, or the last before --at; several become "
                   "panels; --magnify is a factor on the automatic size")
      ->type_name("N[,N...]");
  verb->add_option("--colour", o->colour, "quantity that colours the bodies")
      ->check(CLI::IsMember(draw::colour_names()))
      ->capture_default_str();
  verb->add_option("--view", o->view,
                   "the part to show, X0,Y0,X1,Y1 in metres; in space the direction: front, back, left, right, top, "
                   "iso, or AZIMUTH,ELEVATION in degrees; write --view=-3,0,5,4 if it begins with a minus")
      ->type_name("VIEW");
  verb->add_option("--cut", o->cut, "in space: the section at a place on an axis, such as x=2.5, in metres")
      ->type_name("AXIS=PLACE");
  verb->add_option("--names", o->names, "names of bodies: auto (for at most 30), all or none")
      ->check(CLI::IsMember({"auto", "all", "none"}))
      ->capture_default_str();
  verb->add_option("--units", o->units, "units of the scales in the legend: si or us")
      ->check(CLI::IsMember({"si", "us"}))
      ->capture_default_str();
  verb->add_option("--columns", o->columns, "columns of panels")->check(CLI::Range(1, 20));
  verb->callback([o, &code] { code = draw(*o); });
}

}  // namespace trilith::program
