// Contact laws and direction laws as values: constructors from their declarations.
#include <algorithm>
#include <cmath>

#include "bindings/core/bindings.hpp"
#include "bindings/core/law_values.hpp"

namespace trilith::script {
namespace {

template <class L>
int make_contact_law(lua_State* lua) {
  Keys keys(lua, 1, std::string(L::name));
  L law;
  ContactLawValue value;
  value.name = keys.text("name", "");
  keys.declared(law);
  check_ways(keys, law);
  keys.finish();
  value.law = law;
  push_handle(lua, std::move(value));
  return 1;
}

/// Points of a tabulated law, which are not declared parameters.
template <TabulatedLaw L>
void read_points(Keys& keys, L& law) {
  for (const Vec2& p : keys.points("points")) {
    law.displacement.push_back(p.x());
    law.force.push_back(p.y());
  }
}

/// Numbers that select one of several options: intermediate values would silently mean one of them.
template <class L>
void check_choices(Keys& keys, const L& law) {
  if constexpr (requires { law.side; }) {
    constexpr bool both = !requires {
      law.slack;
    };  // one-sided for tensile elements
    if (std::abs(law.side) != 1 && !(both && law.side == 0))
      keys.problem(fmt::format("'side' is {:g}, must be {}", law.side, both ? "1, -1, or 0 for both" : "1 or -1"));
  }
  if constexpr (requires { law.pull; })
    if (law.pull != 0 && law.pull != 1) keys.problem(fmt::format("'pull' is {:g}, must be 0 or 1", law.pull));
  if constexpr (requires {
                  law.ratio;
                  law.stiffness;
                })
    if (law.stiffness > 0 && keys.has("ratio"))
      keys.problem("both 'stiffness' and 'ratio' are given; keep one: K1, or K1 over post_stiffness");
}

template <class L>
int make_direction_law(lua_State* lua) {
  Keys keys(lua, 1, std::string(L::name));
  L law;
  if constexpr (TabulatedLaw<L>) read_points(keys, law);
  keys.declared(law);
  check_choices(keys, law);
  keys.finish();
  if constexpr (requires { law.check(); }) law.check();
  push_handle(lua, DirectionLawValue{law});
  return 1;
}

struct AddContactLaw {
  lua_State* lua;
  template <class L>
  void operator()() const {
    set_function(lua, std::string(L::name).c_str(), guarded<make_contact_law<L>>);
  }
};
struct AddDirectionLaw {
  lua_State* lua;
  template <class L>
  void operator()() const {
    set_function(lua, std::string(L::name).c_str(), guarded<make_direction_law<L>>);
  }
};

/// True where kind and all declared numbers agree.
bool same_law(const ContactLaw& a, const ContactLaw& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& l) {
        using T = std::decay_t<decltype(l)>;
        const auto parameters = T::parameters();
        return std::all_of(parameters.begin(), parameters.end(),
                           [&](const Parameter<T>& p) { return l.*(p.member) == std::get<T>(b).*(p.member); });
      },
      a);
}

const std::array contact_properties{
    Property<ContactLawValue>{"name", "", "name, \"\" without a name", nullptr,
                              [](lua_State* L, const ContactLawValue& v) { lua_pushstring(L, v.name.c_str()); }},
};

}  // namespace

void open_laws(lua_State* L) {
  register_kind<ContactLawValue>(L);
  register_kind<DirectionLawValue>(L);
  register_kind<SolidLawValue>(L);
  SolidLaws::for_each(AddLaw<SolidLawValue>{L});
  ContactLaws::for_each(AddContactLaw{L});
  DirectionLaws::for_each(AddDirectionLaw{L});
}

std::string require_law(ScriptModel& model, const ContactLawValue& law, const std::string& name) {
  std::string use = name.empty() ? law.name : name;
  for (const auto& [known, other] : model.laws) {
    if (use.empty() ? same_law(other, law.law) : known == use) {
      if (same_law(other, law.law)) return known;
      throw InputError(fmt::format("contact law '{}' exists already; give each its own name", use));
    }
  }
  if (use.empty()) {
    const std::string kind =
        std::visit([](const auto& l) { return std::string(std::decay_t<decltype(l)>::name); }, law.law);
    // Smaller numbers are in use already.
    int& number = model.last_unnamed_law[kind];
    const auto taken = [&] {
      return std::any_of(model.laws.begin(), model.laws.end(), [&](const auto& l) { return l.first == use; });
    };
    do use = fmt::format("{} {}", kind, ++number);
    while (taken());
  }
  model.add_law(use, law.law);
  model.laws.emplace_back(use, law.law);
  return use;
}

std::span<const Property<ContactLawValue>> Kind<ContactLawValue>::properties() {
  return contact_properties;
}
std::span<const Method> Kind<ContactLawValue>::methods() {
  return {};
}
std::string Kind<ContactLawValue>::title(const ContactLawValue& v) {
  return law_text(v.law);
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<ContactLawValue>::metamethods() {
  return {};
}
bool Kind<ContactLawValue>::read_item(lua_State* L, const ContactLawValue& v) {
  return push_declared(L, v.law);
}

TRILITH_LAW_KIND(DirectionLawValue)
TRILITH_LAW_KIND(SolidLawValue)

}  // namespace trilith::script
