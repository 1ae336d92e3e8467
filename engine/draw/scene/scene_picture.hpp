// A picture of the structure at one moment, or of several moments in one figure with one scale.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/space.hpp"
#include "base/unit_system.hpp"
#include "draw/canvas.hpp"

namespace trilith::draw {

/// A rectangle of the world [m], y upwards.
struct WorldBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  bool contains(const Vec2& p) const { return p.x() >= x0 && p.x() <= x1 && p.y() >= y0 && p.y() <= y1; }
};

/// Role of a body in the picture: a free body in the colour of its group, or hatched ground that is fixed or moved.
enum class BodyRole { free, fixed_ground, moved_ground };

/// A part of a body with a value of its own, such as a finite element.
struct ScenePatch {
  std::vector<Vec2> outline;  ///< m
  double value = 0;
};

/// A stretch of a joint with a value, from end to end [m].
struct SceneStrip {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();
  double value = 0;
};

/// One body: its outline [m, world] in either orientation, at least three points. `group` determines the colour and is
/// its text in the legend ("deck", "pier", "left ground"). `value`: a scalar that determines the colour instead (see
/// Scene::value_label).
struct SceneBody {
  std::string name;
  std::vector<Vec2> outline;
  BodyRole role = BodyRole::free;
  std::string group = {};
  std::optional<double> value = std::nullopt;
  bool is_debris = false;        ///< has left the structure: the view is not fitted to it, unless PictureStyle::fit_all
  std::vector<Vec2> start = {};  ///< outline at the start, for a fixed position of its name; may be empty
  /// Polygons of the members of a frame and of its corners. They cover lines of `outline` inside of the frame, and
  /// share one outer line with it.
  std::vector<std::vector<Vec2>> parts = {};
  std::vector<ScenePatch> patches = {};  ///< cover the body, and have their own colours
};

/// A section force along a member, drawn from its axis.
struct SceneDiagram {
  std::vector<Vec2> axis;     ///< points along it [m]
  std::vector<Vec2> towards;  ///< of each point: direction of values above 0, in the plane of the picture; its length
                              ///< is below 1 where that direction is not parallel to the picture
  std::vector<double> value;  ///< of each point, in Scene::diagram_unit
};

/// State of a plastic hinge, or of fibres that have yielded.
enum class HingeMark { elastic, yielded, lost, removed, fibres };

/// A hinge: the end of its member, and the direction into the member, of length 1 or 0 [m].
struct SceneHinge {
  Vec2 at = Vec2::Zero(), inward = Vec2::Zero();
  HingeMark state = HingeMark::elastic;
};

/// State of a joint that has lost its bond: its present opening in three classes, or slid with an opening below the
/// slip.
enum class CrackMark { fine, opened, wide, slid };
inline constexpr double fine_crack = 1e-3, wide_crack = 5e-3;  ///< limits of the middle class [m]
inline constexpr double least_crack = 1e-4;  ///< least displacement for drawing a dry joint; a joint with a bond is
                                             ///< drawn after its loss [m]

/// A broken joint, from end to end [m].
struct SceneCrack {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();
  CrackMark mark = CrackMark::opened;
};

/// A visible part of a polyhedron's face [m, in the plane of the picture]; it covers the previous ones.
struct SceneFace {
  std::vector<Vec2> outline;
  std::vector<bool> is_edge;  ///< true if the side from point i to the next is drawn
  double light = 1;           ///< 0 in the shade to 1 in full light
  int body = 0;               ///< row of Scene::bodies
  bool is_section = false;    ///< section of a cut solid
  double radius = 0;          ///< above 0: a sphere around `centre`; its outline is a polygon near its rim
  Vec2 centre = Vec2::Zero();
  std::vector<SceneCrack> cracks = {};         ///< drawn over it
  std::optional<double> value = std::nullopt;  ///< instead of the value of its body
};

/// A world axis in the picture: displacement in the picture per 1 m along it.
struct SceneAxis {
  std::string name;
  Vec2 along = Vec2::Zero();
};

/// A contact force [N] that acts at `point` [m].
struct SceneForce {
  Vec2 point = Vec2::Zero();
  Vec2 force = Vec2::Zero();
};

/// `changed`: the first law of the bearing was replaced (fixed bearing that slides now).
enum class BearingMark { intact, yielded, failed, changed };

/// A bearing between point `a` of one body and `b` of another [m].
struct SceneBearing {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();
  BearingMark state = BearingMark::intact;
};

/// Contents of a picture of one moment: title first, below it time, stage, event and verdict in one line, as far as
/// given.
struct Scene {
  std::string title;
  std::optional<double> time = std::nullopt;  ///< s
  std::string since = {};                     ///< text after the time if it does not count from the start
  std::string stage = {};
  std::string event = {};
  std::string verdict = {};  ///< reason for which the run is not reliable
  std::vector<SceneBody> bodies = {};
  std::vector<SceneFace> faces = {};  ///< of polyhedra, the farthest first; outlines of bodies are then not drawn
  std::vector<SceneAxis> axes = {};   ///< shown in the corner
  std::vector<SceneForce> forces = {};
  std::vector<SceneBearing> bearings = {};
  std::vector<SceneCrack> cracks = {};
  std::vector<SceneStrip> strips = {};  ///< drawn over the bodies
  std::vector<SceneHinge> hinges = {};
  std::vector<SceneDiagram> diagrams = {};
  std::string diagram_label = {};  ///< their text in the legend, such as "bending moment"
  std::string diagram_unit = {};
  std::vector<std::vector<Vec2>> lines = {};  ///< drawn over the bodies, e.g. a line of thrust [m]
  std::string line_label = {};                ///< their text in the legend
  std::vector<std::vector<Vec2>> ghosts;      ///< outlines of an earlier configuration [m]
  std::string ghost_label = "earlier";        ///< their text in the legend, e.g. "at rest, t = 0"
  std::string value_label = {};               ///< quantity of all values, e.g. "speed"
  std::string value_unit = {};
};

/// Arrows start at the contact in the direction of the force; bars are centred on it (better for many contacts).
/// `automatic`: bars above 60 forces.
enum class ForceMark { automatic, arrow, bar };

/// Page, fonts and options.
struct PictureStyle {
  double width = 510;      ///< greatest page width [pt], 180 mm
  double height = 0;       ///< page height, if texts leave enough space [pt]; 0: 430, or 660 for several rows
  double font_size = 7.5;  ///< pt
  UnitSystem units = {};   ///< of the scale bar, of values, and of numbers in texts
  std::optional<WorldBox> view = std::nullopt;  ///< [m]; none: fitted to the free bodies, with some ground
  bool fit_all = false;                         ///< the view is fitted to all free bodies, wherever they are
  ForceMark force_mark = ForceMark::automatic;
  int label_limit = 30;          ///< names are drawn if at most this many bodies have one
  double pixels_per_inch = 220;  ///< PNG only
};

/// A time [s] with two decimals, or with three digits where these would show 0.00.
std::string time_label(double time);

/// Draws one or more scenes in `columns` columns, with one scale, one view and one legend; several are lettered (a),
/// (b), ... Throws InputError (with scene and body) for no scene or no body, an outline with fewer than three points,
/// and a value that is not finite. It also throws for a point beyond 1e9 m and an invalid view or style.
Canvas scene_canvas(const std::vector<Scene>& scenes, int columns, const PictureStyle& style = {});

/// Pictures of many moments with the same page, view, colours and legend: the frames of a film. Each page is
/// PictureStyle::width x height; title and subtitle have one line each.
class SceneSeries {
 public:
  /// `samples`: scenes over the whole duration, which determine the view, the range of values and the legend. Throws
  /// InputError as scene_canvas.
  SceneSeries(const std::vector<Scene>& samples, const PictureStyle& style);
  [[nodiscard]] Canvas picture(const Scene& scene) const { return draw_(scene); }

 private:
  std::function<Canvas(const Scene&)> draw_;
};

/// One scene to a .svg, .pdf or .png file. Throws InputError as scene_canvas and Canvas::save.
void draw_scene(const Scene& scene, const PictureStyle& style, const std::filesystem::path& path);

/// Several scenes in one figure, e.g. four configurations of a collapse.
void draw_panels(const std::vector<Scene>& scenes, int columns, const PictureStyle& style,
                 const std::filesystem::path& path);

}  // namespace trilith::draw
