// A picture of the structure at one moment, or of several moments in one figure with one scale.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/space.hpp"
#include "draw/canvas.hpp"

namespace trilith::draw {

/// A rectangle of the world [m], y upwards.
struct WorldBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  bool contains(const Vec2& p) const { return p.x() >= x0 && p.x() <= x1 && p.y() >= y0 && p.y() <= y1; }
};

/// What a body is in the picture: a free body in its group's colour, or ground, hatched, that is fixed or moved.
enum class BodyRole { free, fixed_ground, moved_ground };

/// One body: its outline [m, world] in either order, at least three points. `group` chooses the colour and is its text
/// in the legend ("deck", "pier", "left ground"). `value`: a scalar to colour it by instead (see Scene::value_label).
struct SceneBody {
  std::string name;
  std::vector<Vec2> outline;
  BodyRole role = BodyRole::free;
  std::string group = {};
  std::optional<double> value = std::nullopt;
  std::vector<Vec2> start = {};  ///< the outline at the start, by which its name has a place that stays; may be empty
};

/// How a joint that has lost its bond stands: how far it is open now, in three classes, or slid and open by less than
/// it slid.
enum class CrackMark { fine, opened, wide, slid };
inline constexpr double fine_crack = 1e-3, wide_crack = 5e-3;  ///< ends of the class between them [m]
inline constexpr double least_crack = 1e-4;  ///< from which a dry joint is drawn; one with a bond from its loss on [m]

/// A broken joint, from end to end [m].
struct SceneCrack {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();
  CrackMark mark = CrackMark::opened;
};

/// A part of a solid's face as it is seen [m, in the plane of the picture]; it covers those before it.
struct SceneFace {
  std::vector<Vec2> outline;
  std::vector<bool> is_edge;  ///< whether the side from point i to the next is drawn
  double light = 1;           ///< 0 in the shade to 1 in full light
  int body = 0;               ///< row of Scene::bodies
  bool is_section = false;    ///< where the solid is cut
  double radius = 0;          ///< above 0: a ball, drawn round about `centre`; its outline is a polygon near its rim
  Vec2 centre = Vec2::Zero();
  std::vector<SceneCrack> cracks = {};  ///< drawn over it
};

/// An axis of the world as it is seen: where 1 m along it leads.
struct SceneAxis {
  std::string name;
  Vec2 along = Vec2::Zero();
};

/// A contact force [N] that acts at `point` [m].
struct SceneForce {
  Vec2 point = Vec2::Zero();
  Vec2 force = Vec2::Zero();
};

/// `changed`: the bearing's first law has given way to another (fixed bearing become sliding).
enum class BearingMark { intact, yielded, failed, changed };

/// A bearing between point `a` of one body and `b` of another [m].
struct SceneBearing {
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();
  BearingMark state = BearingMark::intact;
};

/// What is seen at one moment. Title first, below it time, stage, event and verdict in one line, as far as given.
struct Scene {
  std::string title;
  std::optional<double> time = std::nullopt;  ///< s
  std::string since = {};                     ///< what follows the time where it counts from elsewhere than the start
  std::string stage = {};
  std::string event = {};
  std::string verdict = {};  ///< why the run is not to be trusted
  std::vector<SceneBody> bodies = {};
  std::vector<SceneFace> faces = {};  ///< of solids, the farthest first; outlines of bodies are then not drawn
  std::vector<SceneAxis> axes = {};   ///< shown in the corner
  std::vector<SceneForce> forces = {};
  std::vector<SceneBearing> bearings = {};
  std::vector<SceneCrack> cracks = {};
  std::vector<std::vector<Vec2>> lines = {};  ///< drawn over the bodies, e.g. a line of thrust [m]
  std::string line_label = {};                ///< their text in the legend
  std::vector<std::vector<Vec2>> ghosts;      ///< outlines of an earlier configuration [m]
  std::string ghost_label = "earlier";        ///< their text in the legend, e.g. "at rest, t = 0"
  std::string value_label = {};               ///< what SceneBody::value is, e.g. "speed"
  std::string value_unit = {};
};

enum class LengthUnits { si, us };
/// Arrows start at the contact and point where the force does; bars are centred on it (better for many contacts).
/// `automatic`: bars above 60 forces.
enum class ForceMark { automatic, arrow, bar };

/// Page, type and choices.
struct PictureStyle {
  double width = 510;      ///< greatest page width [pt], 180 mm
  double height = 0;       ///< page height that is kept to where words leave room [pt]; 0: 430, or 660 for several rows
  double font_size = 7.5;  ///< pt
  LengthUnits units = LengthUnits::si;          ///< scale bar in m or ft, forces in N or kip
  std::optional<WorldBox> view = std::nullopt;  ///< m; else fitted to what is free, with some ground
  ForceMark force_mark = ForceMark::automatic;
  int label_limit = 30;          ///< names are written where at most this many bodies have one
  double pixels_per_inch = 220;  ///< PNG only
};

/// The drawing of one or more scenes in `columns` columns, all to one scale, one view and one legend; several are
/// lettered (a), (b), ... Throws InputError (naming scene and body) where there is no scene or no body, an outline has
/// fewer than three points, a value is not finite or a point lies beyond 1e9 m, or view or style make no sense.
Canvas scene_canvas(const std::vector<Scene>& scenes, int columns, const PictureStyle& style = {});

/// One scene to a .svg, .pdf or .png file. Throws InputError as scene_canvas and Canvas::save.
void draw_scene(const Scene& scene, const PictureStyle& style, const std::filesystem::path& path);

/// Several scenes in one figure, e.g. four configurations of a collapse.
void draw_panels(const std::vector<Scene>& scenes, int columns, const PictureStyle& style,
                 const std::filesystem::path& path);

}  // namespace trilith::draw
