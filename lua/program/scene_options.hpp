// Options of the verbs that draw the structure at moments of a run: draw and movie.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "draw/results/results_picture.hpp"

namespace trilith::program {

struct SceneOptions {
  std::string result, stage, since, view, units;
  bool forces = false, ghost = false, cracks = false;
  std::string stress, thrust, diagram;
  bool envelope = false;
  double magnify = 1;
  std::string colour = "group", cut, names = "auto", fit = "structure";
  bool all_cracks = false;
};

/// Adds the results file and the options to a verb. `times`: name of the times in the text of --stage.
void add_scene_options(CLI::App& verb, SceneOptions& options, const std::string& times);

/// Begin and end of the window [s of the run], and the origin of times.
struct SceneWindow {
  double begin, end;
  results::TimeOrigin origin;
};

/// The window of --stage and --since. Throws ResultsError for a file without frames.
SceneWindow scene_window(const results::ResultsReader& reader, const SceneOptions& options);

/// Time of `text` [s of the run]: a number of seconds, "start", "end", or the type of an event, the first one in the
/// window. `option`: its name in messages.
double scene_time(const results::ResultsReader& reader, const SceneWindow& window, const std::string& text,
                  const char* option);

/// Units of --units, or of the model.
draw::PictureStyle scene_style(const SceneOptions& options, const results::ResultsReader& reader);
draw::SceneChoice scene_choice(const SceneOptions& options, int dim);

}  // namespace trilith::program
