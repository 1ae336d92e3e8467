// Pictures and charts of a results file: the structure at a moment, histories and energy.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "draw/chart/chart.hpp"
#include "draw/chart/energy_chart.hpp"
#include "draw/results/trimmed_ground.hpp"
#include "draw/scene/scene_picture.hpp"
#include "draw/scene/solid_piece.hpp"
#include "draw/scene/view_direction.hpp"
#include "results/file/time_origin.hpp"
#include "results/reading/reader.hpp"

namespace trilith::draw {

struct SceneChoice {
  bool forces = false;              ///< contact forces; the picture then shows the nearest frame instead of an
                                    ///< interpolation
  bool ghost = false;               ///< outlines in the first frame of bodies that have moved
  bool cracks = false;              ///< broken joints, by their larger displacement component
  bool all_cracks = false;          ///< also between bodies that have moved by more than their size
  std::string stress = {};          ///< bodies coloured by their mean stress: see stress_names(); "": no
  std::string thrust = {};          ///< line of thrust through the bodies of this group; "": no
  double magnify = 1;               ///< factor of displacements from the start, without contact forces
  std::string colour = {};          ///< bodies coloured by one of colour_names(); "" means "group"
  ViewDirection from = {};          ///< of a model in space: view direction
  results::TimeOrigin origin = {};  ///< origin of the times in the caption
  std::string diagram = {};         ///< section force of members: a name of results::member_quantities; "": no
  bool envelope = false;            ///< diagrams of the largest and smallest values over `span`
  std::array<double, 2> span{-std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};  ///< [s]
  std::optional<CutPlane> cut = std::nullopt;     ///< of a model in space: the part on the eye's side is omitted
  std::optional<SpaceBox> around = std::nullopt;  ///< of a model in space: the ground is cut off around this AABB;
                                                  ///< none: around the free bodies of the figure
};

/// AABB of the free bodies in the frames at `times` [s]; none in the plane.
std::optional<SpaceBox> box_of_free_bodies(const results::ResultsReader& reader, const std::vector<double>& times);

/// Role of a body in a picture, by BodyRow::support.
BodyRole role_of(const std::string& support);

/// Quantities for colouring bodies: group, displacement (of the node from the start), speed, damage, pressure,
/// temperature; and "water", the pressure of the water in joints.
const std::vector<std::string>& colour_names();

/// The structure, in the plane or in space, at `time` [s], titled by its stage, and the latest important event if it
/// was within the last second of the same stage. Throws InputError for a time outside the frames (half a frame interval
/// is allowed), ResultsError for a file without frames.
Scene results_scene(const results::ResultsReader& reader, double time, const SceneChoice& choice = {});

/// Several moments for one figure: in space the ground ends at the same place in all of them.
std::vector<Scene> results_scenes(const results::ResultsReader& reader, const std::vector<double>& times,
                                  const SceneChoice& choice = {});

/// Only the bodies of a plane model, in their position in `frame`.
Scene plain_scene(const results::Header& header, const results::Frame& frame);

/// Important events in order of time: without contacts made and lost, slow impacts, bodies at rest, and the ends of
/// stages.
std::vector<results::EventRow> events_of_note(const results::ResultsReader& reader);

/// A results file and its name in a legend; "" for a single file.
struct NamedResults {
  const results::ResultsReader* reader;
  std::string name;
};

/// The part of a run to plot [s]: from `from` to `to`. Times count from the stage or event called `since`, otherwise
/// from the start of `stage` if given, otherwise from the start of the run. Within a stage its end is the last moment.
struct PlotWindow {
  std::string stage = {}, since = {};
  std::optional<double> from = std::nullopt, to = std::nullopt;
};

/// One panel for each unit among the histories `names` (every history of the first file if empty). Each result is a
/// line over time or, if `against` names a history, over that history, such as the loop of a bearing or a capacity
/// curve. Throws InputError if a file lacks a history (with the nearest name) or has no samples in the window.
Chart history_chart(const std::vector<NamedResults>& results, const std::vector<std::string>& names,
                    const PlotWindow& window = {}, const std::string& against = {});

/// The ledger: stored and dissipated terms stacked, and the energy supplied by ground, loads, falling weight and the
/// initial state as a line over them. Terms below 1 % of the largest are merged. Throws InputError if the file has no
/// energy.
Chart results_energy_chart(const NamedResults& result, EnergyView view, const PlotWindow& window = {});

/// Marks of stages and of the events that change the structure (bearings and bonds lost, seats lost, impacts) in the
/// window, with its origin of time. For many events of one kind there is one mark: for the fastest impact, otherwise
/// for the first event. Numbers in their texts are in `units`.
std::vector<ChartMark> event_marks(const results::ResultsReader& reader, const PlotWindow& window = {},
                                   const UnitSystem& units = {});

}  // namespace trilith::draw
