// Pressure on faces of bodies, in the plane and in space.
#include <algorithm>
#include <array>

#include "bindings/core/bindings.hpp"
#include "bindings/loads/load_reading.hpp"
#include "model/loads.hpp"

namespace trilith::script {
namespace {

/// Faces that a pressure acts on: face = "top" ..., "all", or from = , to = .
struct FaceChoice {
  std::string side;
  std::optional<Vec2> from, to;
};

FaceChoice read_faces(Keys& keys) {
  FaceChoice faces;
  faces.side = keys.text("face", "");
  faces.from = keys.maybe_point("from");
  faces.to = keys.maybe_point("to");
  if (faces.from.has_value() != faces.to.has_value()) keys.problem("give both 'from' and 'to', points of the outline");
  if (faces.side.empty() == !faces.from.has_value())
    keys.problem("give either face = \"top\" (bottom, left, right, all), or 'from' and 'to' counter-clockwise");
  const std::array sides{"top", "bottom", "left", "right", "all"};
  if (!faces.side.empty() && std::find(sides.begin(), sides.end(), faces.side) == sides.end())
    keys.problem(fmt::format("'face' is '{}', must be top, bottom, left, right or all{}", faces.side,
                             name_hint(faces.side, {sides.begin(), sides.end()})));
  return faces;
}

std::vector<FacePart> chosen_faces(const Model<2>& model, int body, const FaceChoice& choice) {
  const std::string owner = "pressure";
  if (choice.from) return faces_between(model, body, *choice.from, *choice.to, owner);
  if (choice.side == "all") return outline_faces(model, body);
  const Vec2 side = choice.side == "top"      ? Vec2(0, 1)
                    : choice.side == "bottom" ? Vec2(0, -1)
                    : choice.side == "left"   ? Vec2(-1, 0)
                                              : Vec2(1, 0);
  const std::vector<FacePart> faces = faces_towards(model, body, side);
  if (faces.empty())
    throw InputError(fmt::format("pressure: no face of '{}' points to the {} within 45 degrees; give 'from' and 'to'",
                                 model.bodies[body].name, choice.side));
  return faces;
}

/// A side of the world by name: top, bottom, left, right, front, back.
struct NamedSide {
  std::string_view name;
  std::array<int, 3> way;
};
constexpr std::array solid_sides{NamedSide{"top", {0, 0, 1}},    NamedSide{"bottom", {0, 0, -1}},
                                 NamedSide{"left", {-1, 0, 0}},  NamedSide{"right", {1, 0, 0}},
                                 NamedSide{"front", {0, -1, 0}}, NamedSide{"back", {0, 1, 0}}};

/// Faces of a body in space for `side`, "all" or one of solid_sides.
std::vector<SolidFace> solid_faces(const Model<3>& model, int body, const std::string& side) {
  std::vector<SolidFace> faces;
  if (side == "all") faces = surface_faces(model, body);
  for (const NamedSide& s : solid_sides)
    if (s.name == side) faces = faces_towards(model, body, Vec3(s.way[0], s.way[1], s.way[2]));
  if (faces.empty())
    throw InputError(fmt::format("pressure: no plane face of '{}' points to the {} within 45 degrees",
                                 model.bodies[body].name, side));
  return faces;
}

int solid_pressure(lua_State* L, SpaceModel& m) {
  Keys keys(L, 2, "pressure");
  SolidPressureSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  std::vector<std::string> sides{"all"};
  for (const NamedSide& s : solid_sides) sides.emplace_back(s.name);
  if (!keys.has("face")) keys.missing("face", "top, bottom, left, right, front, back or all");
  const std::string side = sides[keys.choice("face", sides, 0)];
  spec.value = keys.number("value", "Pa");
  if (keys.has("direction")) spec.direction = keys.vector("direction");
  spec.follows = keys.flag("follow", !spec.direction.has_value());
  spec.curve = read_load_curve(keys, m.time());
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "pressure");
  const Model<3>& model = m.simulation().model();
  std::vector<PointLoad<3>> loads;
  for (const int body : bodies)
    for (PointLoad<3>& load : make_solid_pressure(model, body, solid_faces(model, body, side), spec))
      loads.push_back(std::move(load));
  m.change([loads](Model<3>& changed) { changed.loads.add(loads); });
  return push_load_name(L, spec.name);
}

/// m:pressure{ body =, face = | from =, to =, value =, follow =, direction =, load_curve =, name = }: returns its name.
int pressure(lua_State* L) {
  if (SpaceModel* space = as_space(this_model(L))) return solid_pressure(L, *space);
  PlaneModel& m = this_plane(L);
  Keys keys(L, 2, "pressure");
  PressureSpec spec;
  spec.name = keys.text("name", "");
  if (!spec.name.empty()) keys.name_owner(spec.name);
  const std::vector<int> bodies = read_loaded_bodies(keys, m);
  const FaceChoice faces = read_faces(keys);
  spec.value = keys.number("value", "Pa");
  spec.direction = keys.maybe_point("direction");
  spec.follows = keys.flag("follow", !spec.direction.has_value());
  spec.curve = read_load_curve(keys, m.time());
  keys.finish();
  if (spec.name.empty()) spec.name = free_load_name(m, "pressure");
  const Model<2>& model = m.simulation().model();
  std::vector<FaceLoad<2>> loads;
  for (const int body : bodies)
    for (FaceLoad<2>& load : make_pressure(model, body, chosen_faces(model, body, faces), spec))
      loads.push_back(std::move(load));
  m.change([loads](Model<2>& changed) { changed.loads.add(loads); });
  return push_load_name(L, spec.name);
}

const std::array pressure_method_list{
    Method{"pressure", guarded<pressure>},
};

}  // namespace

std::span<const Method> pressure_methods() {
  return pressure_method_list;
}

}  // namespace trilith::script
