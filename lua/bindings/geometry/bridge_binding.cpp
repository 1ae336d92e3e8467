// Spans between supports, and the types of their bearings.
#include <algorithm>

#include "bindings/core/bindings.hpp"
#include "bindings/geometry/bridge_book.hpp"
#include "bindings/geometry/part_makers.hpp"
#include "bindings/laws/bearing_reading.hpp"
#include "bindings/readings/body_reading.hpp"

namespace trilith::script {
namespace {

/// Name of the contact law under `key`, given as a value or by name; "" if it is not given or a problem is noted.
std::string contact_law_under(Keys& keys, std::string_view key, ScriptModel& m) {
  lua_State* L = keys.lua();
  std::string name;
  const int type = keys.push(key);
  if (type == LUA_TSTRING) {
    name = text_at(L, -1);
    const std::vector<std::string> known = m.law_names();
    if (std::find(known.begin(), known.end(), name) == known.end())
      keys.problem(fmt::format("{}: there is no contact law '{}'{}", key, name, name_hint(name, known)));
  } else if (const auto* law = type == LUA_TNIL ? nullptr : test_handle<ContactLawValue>(L, -1)) {
    keys.finish();
    name = require_law(m, *law, "");
  } else if (type != LUA_TNIL) {
    keys.wrong(key, "a contact law, or the name of one");
  }
  lua_pop(L, 1);
  return name;
}

/// True if some direction has a law.
template <int D>
bool has_law(Keys& keys) {
  bool any = D == 3 && keys.has("horizontal");
  for (const char* name : Directions<D>::names) any = keys.has(name) || any;
  return any;
}

/// True if a bearing carries the deck at any displacement: it has no law along, and no limit.
template <int D>
bool slides_on_for_ever(Keys& keys) {
  const bool held = keys.has("along") || (D == 3 && keys.has("horizontal"));
  if (!keys.has("axial") || held) return false;
  if (!keys.has("limit")) return true;
  lua_State* L = keys.lua();
  const int top = lua_gettop(L);
  keys.push("limit");
  const bool ends = lua_type(L, -1) != LUA_TTABLE || lua_getfield(L, -1, "along") != LUA_TNIL;
  lua_settop(L, top);
  return !ends;
}

template <int D, class M>
int add_bearing_type_to(lua_State* L, M& m) {
  m.adding();
  Keys keys(L, 2, "bearing type");
  BearingType type;
  BearingRecipeOf<D> recipe;
  type.name = keys.text("name");
  keys.name_owner(type.name);
  type.height = keys.number("height", "m", 0);
  read_directions(keys, recipe.bearing);
  recipe.links = has_law<D>(keys);
  for (const char* key : {"limit", "becomes"})
    if (keys.has(key) && !recipe.links)
      keys.problem(fmt::format("'{}' is given, but no law; give along, axial or {}", key,
                               D == 2 ? "turning" : "another direction"));
  if (type.height > 0 && !keys.has("axial"))
    keys.problem("'height' is given, but no law that supports the deck; give axial");
  keys.know({"becomes", "contact"});
  recipe.bearing.contact_after = contact_law_under(keys, "becomes", m);
  recipe.contact = contact_law_under(keys, "contact", m);
  keys.finish();
  if constexpr (D == 3)  // in the plane the first span finds errors of a law
    if (recipe.links) check_bearing(recipe.bearing, keys.owner());
  // A bearing that carries the deck and has no height replaces the contact of deck and seat. One without an axial law,
  // such as a dowel, leaves the weight to the contact.
  recipe.bearing.replaces_contact = keys.has("axial") && type.height == 0;
  if (slides_on_for_ever<D>(keys))
    m.add_note(fmt::format(
        "{}: supports the deck at any displacement along, even beyond the edge of its seat; to end it there, give "
        "limit = {{ along = the length of the seat }}",
        keys.owner()));
  book_of(m).layout.add_bearing_type(type);
  book_of(m).recipes.emplace(type.name, recipe);
  lua_pushstring(L, type.name.c_str());
  return 1;
}

/// m:bearing_type{ name =, height =, along =, axial =, turning =, limit =, becomes =, contact = }; in space with the
/// directions of m:bearing there.
int add_bearing_type(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (SpaceModel* space = as_space(m)) return add_bearing_type_to<3>(L, *space);
  return add_bearing_type_to<2>(L, *as_plane(m));
}

/// Name of the support under `key`; a body that is neither pier nor abutment carries spans on its top.
std::string support_under(Keys& keys, std::string_view key, PlaneModel& m) {
  lua_State* L = keys.lua();
  std::string name;
  const int type = keys.push(key);
  if (type == LUA_TSTRING)
    name = text_at(L, -1);
  else if (type != LUA_TNIL && test_handle<BodyHandle>(L, -1) != nullptr)
    name = m.builder.bodies()[static_cast<std::size_t>(row_at<BodyHandle>(L, -1, m, keys.owner()))].name;
  else if (type == LUA_TNIL)
    keys.missing(key, "a pier, an abutment or another body, or its name");
  else
    keys.wrong(key, "a pier, an abutment or another body, or its name");
  lua_pop(L, 1);
  BridgeLayout& layout = book_of(m).layout;
  for (const BodySpec& body : m.builder.bodies()) {
    if (body.name != name || layout.has_support(name)) continue;
    // Its highest face may belong to the back wall.
    if (std::find(body.groups.begin(), body.groups.end(), "abutments") != body.groups.end())
      keys.problem(
          fmt::format("{} is abutment '{}', of which only the outline is known; make it with m:abutment", key, name));
    else
      layout.add_support(top_of(name, body.outline));
  }
  return name;
}

constexpr const char* type_wanted = "the name of a bearing type, as returned by m:bearing_type";

std::string type_under(Keys& keys, std::string_view key) {
  const int type = keys.push(key);
  if (type == LUA_TNIL)
    keys.missing(key, type_wanted);
  else if (type != LUA_TSTRING)
    keys.wrong(key, type_wanted);
  const std::string name = type == LUA_TSTRING ? text_at(keys.lua(), -1) : "";
  lua_pop(keys.lua(), 1);
  return name;
}

SpanPlan read_plan(Keys& keys, PlaneModel& m) {
  SpanPlan plan;
  plan.name = keys.text("name", plan.name);
  keys.name_owner(plan.name);
  plan.from = support_under(keys, "from", m);
  plan.to = support_under(keys, "to", m);
  plan.left = type_under(keys, "left");
  plan.right = type_under(keys, "right");
  plan.gap = keys.maybe_number("gap", "m");
  plan.depth = keys.number("depth", "m");
  plan.soffit_level = keys.maybe_number("soffit_level", "m");
  for (const char* key : {"x0", "x1", "end_gap"})
    if (keys.has(key))
      keys.problem(fmt::format(
          "'{}' is given in addition to from and to, which define the ends of the span; leave it out", key));
  return plan;
}

/// Sets the law of a support and the deck on it; for a bridge that may still be rejected, it is set later.
template <class M>
void state_contact(M& m, const std::string& support, const std::string& deck, const std::string& law) {
  if (law.empty()) return;
  if (m.adds_later)
    book_of(m).contacts.push_back({support, deck, law});
  else
    m.builder.set_contact(support, deck, law);
}

/// Adds the seat of an end, and its bearing if its type has one.
void add_end(PlaneModel& m, const std::string& span, const SpanEnd& end, const std::string& name) {
  const BearingRecipe& recipe = book_of(m).recipes.at(end.type);
  m.builder.add_seat(
      {.name = name, .body = span, .support = end.support, .end = end.end, .edge = end.edge, .inward = end.inward});
  m.seats.push_back(name);
  state_contact(m, end.support, span, recipe.contact);
  if (!recipe.links) return;
  BearingSpec bearing = recipe.bearing;
  bearing.name = name;
  bearing.body_a = end.support, bearing.body_b = span;
  bearing.point_a = bearing.point_b = end.bearing;
  m.builder.add_bearing(bearing);
  m.bearings.push_back(name);
}

int add_span_between(lua_State* L, PlaneModel& m, Keys& keys) {
  const SpanPlan plan = read_plan(keys, m);
  BodyOptions options = read_body_options(keys, false, m.body_form);
  const auto weight = keys.maybe_number("weight_per_length", "N/m");
  if (weight && !(*weight > 0)) keys.problem(fmt::format("'weight_per_length' is {:g} N/m, must be above 0", *weight));
  if (weight && (options.spec.weight || options.spec.mass || options.spec.density))
    keys.problem("both weight_per_length and another weight, mass or density are given; keep one");
  keys.finish();
  const LaidSpan span = book_of(m).layout.lay(plan);
  if (weight) options.spec.weight = *weight * span.length();
  add_part(m, span.deck, options);
  const int body = m.body_count() - 1;
  for (const std::size_t side : {0, 1}) add_end(m, plan.name, span.ends[side], span_end_name(plan.name, side));
  book_of(m).layout.add(span);
  push_body(L, 1, body);
  return 1;
}

int add_span_alone(lua_State* L, PlaneModel& m, Keys& keys) {
  keys.know({"from", "to", "left", "right", "gap", "weight_per_length"});
  if (!keys.has("x0") && !keys.has("x1")) keys.missing("from", "the supports from and to, or the places x0 and x1");
  for (const char* key : {"left", "right", "gap", "weight_per_length"})
    if (keys.has(key)) keys.problem(fmt::format("'{}' needs from and to, the supports of the span; give them", key));
  const auto maker = std::find_if(part_makers().begin(), part_makers().end(),
                                  [](const PartMaker& row) { return row.name == span_maker; });
  const MakeParts make = maker->read(keys);
  const BodyOptions options = read_body_options(keys, false, m.body_form);
  keys.finish();
  add_part(m, make().parts[0], options);
  push_body(L, 1, m.body_count() - 1);
  return 1;
}

/// m:span{ name =, from =, to =, left =, right =, depth =, ... }, or { name =, x0 =, x1 =, ... } for a deck alone.
int add_span(lua_State* L) {
  PlaneModel& m = this_plane(L);
  m.adding();
  Keys keys(L, 2, "span");
  const int pushed = keys.has("from") || keys.has("to") ? add_span_between(L, m, keys) : add_span_alone(L, m, keys);
  m.catch_up();
  return pushed;
}

/// The bearing type in argument 2; argument 3 begins error messages.
template <class M>
const BearingType& type_asked(lua_State* L, M& m) {
  if (lua_type(L, 2) != LUA_TSTRING)
    throw InputError(fmt::format("{} is {}, must be {}", text_at(L, 3), what_is(L, 2), type_wanted));
  return book_of(m).layout.require_type(text_at(L, 2), text_at(L, 3));
}

/// core.bearing_height(model, type, owner): height of a bearing type [m].
int bearing_height(lua_State* L) {
  ScriptModel& m = this_model(L);
  SpaceModel* space = as_space(m);
  lua_pushnumber(L, space != nullptr ? type_asked(L, *space).height : type_asked(L, *as_plane(m)).height);
  return 1;
}

/// core.lay_bearing(model, { name =, type =, support =, span =, from =, to = }): adds a bearing of that type in space,
/// from its seat to the deck, and their contact law if the type has one. Nil for a type without a law.
int lay_bearing(lua_State* L) {
  SpaceModel& m = this_space(L);
  m.adding();
  Keys keys(L, 2, "bearing");
  const std::string name = keys.text("name"), type = keys.text("type");
  const std::string support = keys.text("support"), deck = keys.text("span");
  const Vec3 from = keys.vector("from"), to = keys.vector("to");
  keys.finish();
  const BearingRecipeOf<3>& recipe = book_of(m).recipes.at(type);
  state_contact(m, support, deck, recipe.contact);
  if (!recipe.links) return 0;
  BearingSpecOf<3> bearing = recipe.bearing;
  bearing.name = name;
  bearing.body_a = support, bearing.body_b = deck;
  bearing.point_a = from, bearing.point_b = to;
  m.builder.add_bearing(bearing);
  m.bearings.push_back(name);
  m.catch_up();
  push_bearing(L, 1, static_cast<int>(m.bearings.size()) - 1);
  return 1;
}

template <class M>
void begin_whole(M& m) {
  auto& book = book_of(m);
  book.before = {m.builder.bodies().size(), m.bearings.size(), m.seats.size(), book.layout};
  book.contacts.clear();
}

template <class M>
void end_whole(M& m) {
  for (const auto& c : book_of(m).contacts) m.builder.set_contact(c.support, c.deck, c.law);
}

template <class M>
void take_back_from(M& m) {
  auto& book = book_of(m);
  m.builder.shorten(book.before.bodies, book.before.bearings, book.before.seats);
  m.bearings.resize(std::min(book.before.bearings, m.bearings.size()));
  m.seats.resize(std::min(book.before.seats, m.seats.size()));
  book.layout = book.before.layout;
}

/// core.add_together(model, begin): parts added from here on enter a built model all at once, when this is called with
/// false.
int add_together(lua_State* L) {
  ScriptModel& m = this_model(L);
  m.adds_later = lua_toboolean(L, 2) != 0;
  const auto turn = [&](auto& model) { m.adds_later ? begin_whole(model) : end_whole(model); };
  if (SpaceModel* space = as_space(m))
    turn(*space);
  else
    turn(*as_plane(m));
  m.catch_up();
  return 0;
}

/// core.take_back(model): removes the parts added since add_together.
int take_back(lua_State* L) {
  ScriptModel& m = this_model(L);
  if (SpaceModel* space = as_space(m))
    take_back_from(*space);
  else
    take_back_from(*as_plane(m));
  m.adds_later = false;
  return 0;
}

const std::array bridge_method_list{
    Method{"bearing_type", guarded<add_bearing_type>},
    Method{"span", guarded<add_span>, 2},
};

}  // namespace

std::span<const Method> bridge_methods() {
  return bridge_method_list;
}

void open_bridge(lua_State* L) {
  set_function(L, "bearing_height", guarded<bearing_height>);
  set_function(L, "lay_bearing", guarded<lay_bearing>);
  set_function(L, "add_together", guarded<add_together>);
  set_function(L, "take_back", guarded<take_back>);
}

}  // namespace trilith::script
