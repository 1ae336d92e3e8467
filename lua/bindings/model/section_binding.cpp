// Sections of members as values: trilith.rectangle_section{...} and the others.
#include <type_traits>

#include "bindings/core/bindings.hpp"
#include "bindings/laws/section_curves.hpp"

namespace trilith::script {
namespace {

template <class Shape>
int make_section(lua_State* L) {
  Keys keys(L, 1, std::string(Shape::name));
  Shape shape;
  keys.declared(shape);
  keys.finish();
  if constexpr (requires { shape.check(); }) shape.check();
  SectionValue value{shape.numbers(), describe(shape), std::nullopt, std::nullopt};
  value.in_space = section_in_space(shape);
  if constexpr (std::is_constructible_v<FibreShape, Shape>) value.shape = shape;
  push_handle(L, std::move(value));
  return 1;
}

struct AddSection {
  lua_State* lua;
  template <class Shape>
  void operator()() const {
    set_function(lua, std::string(Shape::name).c_str(), guarded<make_section<Shape>>);
  }
};

/// trilith.polygon_section{ outline = {{x, y}, ...} }
int make_polygon_section(lua_State* L) {
  Keys keys(L, 1, "polygon_section");
  Polygon outline = keys.points("outline");
  keys.finish();
  outline = check_polygon(std::move(outline), "polygon_section").outline;
  SectionValue value{polygon_section(outline), fmt::format("polygon_section of {} corners", outline.size()),
                     SectionOutline{outline}, std::nullopt};
  try {
    value.in_space = polygon_section_in_space(outline);
  } catch (const InputError& e) {
    value.not_in_space = e.what();
  }
  push_handle(L, std::move(value));
  return 1;
}

}  // namespace

void open_sections(lua_State* L) {
  register_kind<SectionValue>(L);
  SectionShapes::for_each(AddSection{L});
  set_function(L, "polygon_section", guarded<make_polygon_section>);
}

namespace {

using SectionProperty = Property<SectionValue>;

const std::array section_properties{
    SectionProperty{"area", "m2", "of the section", [](const SectionValue& v) { return v.numbers.area; }, nullptr},
    SectionProperty{"inertia", "m4", "second moment of area for bending in the plane",
                    [](const SectionValue& v) { return v.numbers.second_moment; }, nullptr},
    SectionProperty{"shear_area", "m2", "area times shear coefficient",
                    [](const SectionValue& v) { return v.numbers.shear_area; }, nullptr},
    SectionProperty{"depth", "m", "in the plane", [](const SectionValue& v) { return v.numbers.depth(); }, nullptr},
    SectionProperty{"above", "m", "from the centroid to the top fibre",
                    [](const SectionValue& v) { return v.numbers.above; }, nullptr},
    SectionProperty{"below", "m", "from the centroid to the bottom fibre",
                    [](const SectionValue& v) { return v.numbers.below; }, nullptr},
};

}  // namespace

std::span<const Property<SectionValue>> Kind<SectionValue>::properties() {
  return section_properties;
}
std::span<const Method> Kind<SectionValue>::methods() {
  return section_methods();
}
std::string Kind<SectionValue>::title(const SectionValue& v) {
  return v.text;
}
std::span<const std::pair<const char*, lua_CFunction>> Kind<SectionValue>::metamethods() {
  return {};
}
bool Kind<SectionValue>::read_item(lua_State*, const SectionValue&) {
  return false;
}

}  // namespace trilith::script
