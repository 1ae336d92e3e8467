// From a results file to pictures: the structure at a moment, histories and energy as charts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/chart/chart.hpp"
#include "draw/chart/energy_chart.hpp"
#include "draw/scene/scene_picture.hpp"
#include "draw/scene/solid_piece.hpp"
#include "draw/scene/view_direction.hpp"
#include "results/file/time_origin.hpp"
#include "results/reading/reader.hpp"

namespace trilith::draw {

struct SceneChoice {
  bool forces = false;              ///< contact forces; the picture is then that of the nearest frame, not between two
  bool ghost = false;               ///< outlines of the first frame, of bodies that have moved since
  bool cracks = false;              ///< broken joints, by what they did most
  std::string stress = {};          ///< bodies coloured by their mean stress: see stress_names(); "": not
  std::string thrust = {};          ///< line of thrust through the bodies of this group, or ""
  double magnify = 1;               ///< displacements since the start times this, without contact forces
  std::string colour = {};          ///< bodies coloured by one of colour_names(); "" as "group"
  ViewDirection from = {};          ///< of a model in space: from where it is seen
  results::TimeOrigin origin = {};  ///< what times in the caption count from
  std::optional<CutPlane> cut = std::nullopt;  ///< of a model in space: what is on the eye's side of it is left out
};

/// What a body is in a picture, by BodyRow::support.
BodyRole role_of(const std::string& support);

/// What bodies can be coloured by: group, displacement (of the node since the start), speed.
const std::vector<std::string>& colour_names();

/// The structure, in the plane or in space, at `time` [s], titled by its stage, and the
/// latest event of note where that was within the last second of the same stage. Throws InputError for a time outside
/// the frames (half a frame's spacing is allowed), ResultsError for a file without frames.
Scene results_scene(const results::ResultsReader& reader, double time, const SceneChoice& choice = {});

/// The same at several moments, for one figure: in space the ground ends at the same place in all of them.
std::vector<Scene> results_scenes(const results::ResultsReader& reader, const std::vector<double>& times,
                                  const SceneChoice& choice = {});

/// The bodies of a model in the plane where `frame` has them, and nothing else.
Scene plain_scene(const results::Header& header, const results::Frame& frame);

/// Events that a reader of a picture wants to hear of, in time: neither contacts made and lost, slow impacts, bodies
/// at rest, nor the ends of stages.
std::vector<results::EventRow> events_of_note(const results::ResultsReader& reader);

/// A results file and the word for it in a legend; "" where it is the only one.
struct NamedResults {
  const results::ResultsReader* reader;
  std::string name;
};

/// The part of a run that is plotted [s]: from `from` to `to`. Times count from the stage or event called `since`, else
/// from the beginning of `stage` where that is named, else from the start of the run. Within a stage its own end is the
/// last moment.
struct PlotWindow {
  std::string stage = {}, since = {};
  std::optional<double> from = std::nullopt, to = std::nullopt;
};

/// One panel for each unit among the histories `names` (every history of the first file where empty), each result a
/// line over time or, where `against` is the name of a history, over that: the loop of a bearing, a capacity curve.
/// Throws InputError where a file does not have a history (with the nearest name) or no samples in the window.
Chart history_chart(const std::vector<NamedResults>& results, const std::vector<std::string>& names,
                    const PlotWindow& window = {}, const std::string& against = {});

/// The ledger: terms that hold or have taken up energy on each other, and as a line over them what ground, loads,
/// falling weight and start have put in. Terms below a hundredth of the largest are one. Throws InputError where the
/// file has no energy.
Chart results_energy_chart(const NamedResults& result, EnergyView view, const PlotWindow& window = {});

/// Stages and the events that change the structure (bearings and bonds lost, seats lost, impacts) as marks; where there
/// are too many of one kind, one of it: the fastest impact, else the first. Those of the window, in its time.
std::vector<ChartMark> event_marks(const results::ResultsReader& reader, const PlotWindow& window = {});

}  // namespace trilith::draw
