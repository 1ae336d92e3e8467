// m:change{...}: another number in a law or a limit of a built model, between stages or in a pause.
#include <algorithm>

#include "bindings.hpp"
#include "world/usual.hpp"

namespace trilith::script {
namespace {

/// The declared numbers of a law with those that are given put in; a problem is noted where one is out of range.
ContactLaw changed_law(Keys& keys, ContactLaw law) {
  std::visit(
      [&](auto& l) {
        using T = std::decay_t<decltype(l)>;
        bool any = false;
        for (const Parameter<T>& p : T::parameters()) {
          const auto given = keys.maybe_number(p.name, p.unit);
          if (!given) continue;
          any = true;
          l.*(p.member) = *given;
          if (!p.allows(*given))
            keys.problem(fmt::format("'{}' is {:g}{}{}, must be {}", p.name, *given, p.unit == "1" ? "" : " ",
                                     p.unit == "1" ? "" : p.unit, p.range()));
        }
        if (!any) keys.problem("no number is given; give one of the law's, such as mu");
      },
      law);
  return law;
}

std::string text_of(const ContactLaw& law) {
  return std::visit([](const auto& l) { return describe(l); }, law);
}

std::string change_law(Keys& keys, PlaneModel& m, const std::string& name) {
  const auto& names = m.simulation().model().law_names;
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end()) throw InputError(fmt::format("change: there is no law '{}'{}", name, name_hint(name, names)));
  const auto row = static_cast<std::size_t>(it - names.begin());
  const ContactLaw law = changed_law(keys, m.simulation().model().laws[row]);
  keys.finish();
  m.change([row, law](Model<2>& model) { model.laws[row] = law; });
  for (auto& [known, value] : m.laws)
    if (known == name) value = law;
  return fmt::format("law '{}' is now {}", name, text_of(law));
}

std::string change_bearing(Keys& keys, PlaneModel& m, const std::string& name) {
  constexpr std::array directions{"along", "axial", "turning"};
  const auto& bearings = m.simulation().model().bearings;
  const auto it = std::find_if(bearings.begin(), bearings.end(), [&](const auto& b) { return b.name == name; });
  if (it == bearings.end())
    throw InputError(fmt::format("change: there is no bearing '{}'{}", name, name_hint(name, m.bearings)));
  const auto row = static_cast<std::size_t>(it - bearings.begin());
  std::array<double, 3> limit = it->limit;
  if (keys.push("limit") == LUA_TTABLE) {
    Keys own(keys.lua(), -1, "change: limit");
    for (std::size_t k = 0; k < 3; ++k) {
      limit[k] = own.number(directions[k], k == 2 ? "rad" : "m", limit[k]);
      if (!(limit[k] > 0)) own.problem(fmt::format("'{}' is {:g}, must be above 0", directions[k], limit[k]));
    }
    own.finish();
  } else {
    keys.wrong("limit", "a table { along = , axial = , turning = }");
  }
  lua_pop(keys.lua(), 1);
  keys.finish();
  m.change([row, limit](Model<2>& model) { model.bearings[row].limit = limit; });
  return fmt::format("bearing '{}': limit is now along {:g} m, axial {:g} m, turning {:g} rad", name, limit[0],
                     limit[1], limit[2]);
}

/// m:change{ law = "name", mu = 0.4 } or m:change{ bearing = "name", limit = { along = 0.3 } }
int change(lua_State* L) {
  PlaneModel& m = this_plane(L);
  if (m.running() && !m.paused())
    throw InputError("change: a stage runs; change laws and limits between stages or in a pause");
  Keys keys(L, 2, "change");
  const std::string law = keys.text("law", ""), bearing = keys.text("bearing", "");
  if (law.empty() == bearing.empty()) {
    keys.problem("give either law or bearing, the name of one");
    keys.know({"limit"});
    keys.finish();
  }
  const std::string said = law.empty() ? change_bearing(keys, m, bearing) : change_law(keys, m, law);
  m.simulation().drop_step();
  std::vector<std::string> doubts;
  for (const auto& [name, value] : m.laws)
    if (name == law) std::visit([&](const auto& l) { add_doubts(doubts, "change: law '" + law + "'", l); }, value);
  for (const std::string& doubt : doubts)
    if (host(L).observer != nullptr) host(L).observer->note(doubt);
  m.note(fmt::format("changed at {:.6g} s: {}", m.time(), said));
  if (host(L).observer != nullptr) host(L).observer->note(said);
  return 0;
}

const std::array change_method_list{
    Method{"change", guarded<change>, "change{law=, mu=, ...} or change{bearing=, limit=}: another number from now on"},
};

/// core.contact_laws(model): a list of the model's laws, with their names.
int contact_laws(lua_State* L) {
  const ScriptModel& m = handle<ModelBox>(L, 1).get();
  lua_newtable(L);
  lua_Integer i = 0;
  for (const auto& [name, law] : m.laws) {
    push_handle(L, ContactLawValue{law, name});
    lua_rawseti(L, -2, ++i);
  }
  return 1;
}

/// core.set_law_number(model, law, key, value): as m:change, and says nothing.
int set_law_number(lua_State* L) {
  PlaneModel& m = this_plane(L);
  const std::string name = text_at(L, 2), key = text_at(L, 3);
  const double value = lua_tonumber(L, 4);
  const auto& names = m.simulation().model().law_names;
  const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  if (row == names.size()) throw InputError(fmt::format("there is no law '{}'", name));
  ContactLaw law = m.simulation().model().laws[row];
  std::visit(
      [&](auto& l) {
        for (const auto& p : std::decay_t<decltype(l)>::parameters())
          if (p.name == key) l.*(p.member) = value;
      },
      law);
  m.change([row, law](Model<2>& model) { model.laws[row] = law; });
  m.simulation().drop_step();
  return 0;
}

}  // namespace

std::span<const Method> change_methods() {
  return change_method_list;
}

void open_change(lua_State* L) {
  set_function(L, "contact_laws", guarded<contact_laws>);
  set_function(L, "set_law_number", guarded<set_law_number>);
}

}  // namespace trilith::script
