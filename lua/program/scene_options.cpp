#include "program/scene_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "draw/results/results_findings.hpp"
#include "program/comma_list.hpp"
#include "program/positive.hpp"
#include "program/since_option.hpp"
#include "program/units_option.hpp"

namespace trilith::program {
namespace {

/// "x=2": all points whose x is 2 m.
draw::CutPlane cut_plane(const std::string& text) {
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || text[1] != '=')
    throw InputError(fmt::format("--cut: '{}' must be an axis and a place on it in metres, such as x=2.5", text));
  return {Vec3::Unit(text[0] - 'x'), number_of(text.substr(2), "--cut")};
}

}  // namespace

SceneWindow scene_window(const results::ResultsReader& reader, const SceneOptions& options) {
  const std::vector<double>& times = reader.frame_times();
  if (times.empty())
    throw results::ResultsError(fmt::format("results file '{}': there is no frame to draw", reader.path().string()));
  if (options.stage.empty()) return {0, times.back(), results::time_origin(reader, options.since)};
  const results::StageRow row = results::find_stage(reader, options.stage);
  return {row.begin, row.ended ? row.end : times.back(),
          results::time_origin(reader, options.since.empty() ? options.stage : options.since)};
}

double scene_time(const results::ResultsReader& reader, const SceneWindow& window, const std::string& text,
                  const char* option) {
  if (text == "end") return window.end;
  if (text == "start") return std::max(window.begin, reader.frame_times().front());
  if (text.empty() || std::string("0123456789+-.").find(text[0]) != std::string::npos)
    return window.origin.zero + number_of(text, option);
  std::vector<std::string> known{"start", "end"};
  for (const results::EventRow& e : reader.events()) {
    if (e.type == text && e.time >= window.begin && e.time <= window.end) return e.time;
    if (std::find(known.begin(), known.end(), e.type) == known.end()) known.push_back(e.type);
  }
  throw InputError(
      fmt::format("{}: '{}' is neither a time nor an event of this run{}", option, text, name_hint(text, known)));
}

draw::PictureStyle scene_style(const SceneOptions& options, const results::ResultsReader& reader) {
  draw::PictureStyle style;
  style.units = shown_units(options.units, reader);
  if (options.names != "auto") style.label_limit = options.names == "all" ? std::numeric_limits<int>::max() : 0;
  style.fit_all = options.fit == "all";
  if (options.view.empty() || reader.header().dim == 3) return style;
  const std::vector<std::string> ends = comma_list(options.view);
  if (ends.size() != 4)
    throw InputError(fmt::format("--view: '{}' must be four numbers x0,y0,x1,y1 in metres", options.view));
  const auto end = [&](std::size_t i) { return number_of(ends[i], "--view"); };
  style.view = draw::WorldBox{end(0), end(1), end(2), end(3)};
  return style;
}

draw::SceneChoice scene_choice(const SceneOptions& options, int dim) {
  draw::SceneChoice choice;
  choice.all_cracks = options.all_cracks;
  choice.forces = options.forces, choice.ghost = options.ghost, choice.cracks = options.cracks;
  choice.stress = options.stress, choice.thrust = options.thrust, choice.magnify = options.magnify;
  choice.colour = options.colour;
  choice.diagram = options.diagram, choice.envelope = options.envelope;
  if (dim == 3 && !options.view.empty()) choice.from = draw::view_direction(options.view);
  if (!options.cut.empty()) choice.cut = cut_plane(options.cut);
  return choice;
}

void add_scene_options(CLI::App& verb, SceneOptions& o, const std::string& times) {
  verb.add_option("result", o.result, "results file, also of a run that was killed or is in progress")
      ->required()
      ->type_name("RESULT");
  verb.add_option("--stage", o.stage, fmt::format("within this stage, with {} counted from its beginning", times))
      ->type_name("NAME");
  add_since(verb, o.since);
  verb.add_flag("--forces", o.forces, "contact forces");
  verb.add_flag("--ghost", o.ghost, "positions of the bodies at the start");
  verb.add_flag("--cracks", o.cracks, "joints that have lost their bond, and dry joints, by opening or slip");
  verb.add_flag("--all-cracks", o.all_cracks, "with --cracks: also between bodies that are no longer in their place");
  verb.add_option("--stress", o.stress,
                  "colour bodies by their mean stress: minor or major principal stress, or a component")
      ->check(CLI::IsMember(draw::stress_names()));
  verb.add_option("--thrust", o.thrust, "the line of thrust through the bodies of this group, in their order")
      ->type_name("GROUP");
  verb.add_option("--diagram", o.diagram,
                  "section force along the members of frames: moment, shear or normal; in space also moment_y, "
                  "moment_z, shear_y, shear_z or torque")
      ->type_name("FORCE");
  verb.add_flag("--envelope", o.envelope,
                "with --diagram: the largest and smallest values of all frames, or of the frames of --stage");
  verb.add_option("--magnify", o.magnify, "factor on displacements since the start")
      ->type_name("FACTOR")
      ->check(CLI::Validator(is_positive, "", ""));
  verb.add_option("--colour", o.colour, "quantity that colours the bodies")
      ->check(CLI::IsMember(draw::colour_names()))
      ->capture_default_str();
  verb.add_option("--view", o.view,
                  "the part to show, X0,Y0,X1,Y1 in metres; in space the direction: front, back, left, right, top, "
                  "iso, or AZIMUTH,ELEVATION in degrees; write --view=-3,0,5,4 if it begins with a minus")
      ->type_name("VIEW");
  verb.add_option("--fit", o.fit,
                  "the view is fitted to: the structure without bodies that have left it, or all bodies")
      ->check(CLI::IsMember({"structure", "all"}))
      ->capture_default_str();
  verb.add_option("--cut", o.cut, "in space: the section at a place on an axis, such as x=2.5, in metres")
      ->type_name("AXIS=PLACE");
  verb.add_option("--names", o.names, "names of bodies: auto (for at most 30), all or none")
      ->check(CLI::IsMember({"auto", "all", "none"}))
      ->capture_default_str();
  add_units(verb, o.units);
}

}  // namespace trilith::program
