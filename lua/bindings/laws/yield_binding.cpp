// Yielding of members of frames, as values: laws of fibres, sections of fibres, laws of hinges.
#include "bindings/core/bindings.hpp"
#include "bindings/core/law_values.hpp"
#include "bindings/geometry/part_reading.hpp"
#include "bindings/model/frame_binding.hpp"

namespace trilith::script {
namespace {

/// trilith.end_hinge{ sagging =, hogging =, ..., axial = {{N, share}, ...} }
int make_end_hinge(lua_State* L) {
  Keys keys(L, 1, std::string(HingeLaw::name));
  HingeLaw law;
  keys.declared(law);
  law.removes = keys.choice("becomes", {"pinned", "removed"}, 0) == 1;
  if (keys.has("axial")) {
    for (const Vec2& p : keys.points("axial")) law.force.push_back(p.x()), law.share.push_back(p.y());
    if (law.force.empty())
      keys.problem("'axial' has no points; give { { normal force, share of the moment left }, ... }");
  }
  keys.finish();
  law.check();
  push_handle(L, HingeLawValue{law});
  return 1;
}

/// The shape of the section under `key`, which must be divisible into fibres.
std::optional<FibreShape> read_shape(Keys& keys, const char* key) {
  const auto* const section = keys.maybe_handle<SectionValue>(key);
  if (section == nullptr) return std::nullopt;
  if (!section->shape)
    keys.problem(
        fmt::format("'{}' is {}, which has no shape to cut into fibres; give one such as "
                    "trilith.rectangle_section{{width =, depth =}}",
                    key, section->fibres ? "made of fibres already" : section->text));
  return section->shape;
}

std::optional<UniaxialLaw> read_fibre_law(Keys& keys, const char* key) {
  const auto* const law = keys.maybe_handle<FibreLawValue>(key);
  return law == nullptr ? std::nullopt : std::optional(law->law);
}

/// Section of members in space for a shape, with torsion and shear; `why`: reason for which there is none.
Section3 shape_in_space(const FibreShape& shape, std::string& why) {
  try {
    return std::visit(
        [](const auto& s) {
          if constexpr (requires { s.outline; })
            return polygon_section_in_space(s.outline);
          else
            return section_in_space(s);
        },
        shape);
  } catch (const InputError& e) {
    why = e.what();
    return {};
  }
}

/// trilith.fibre_section{ shape =, law =, layers =, layers_across =, cover =, cover_law =, core =, bars =, bar_law = }
int make_fibre_section(lua_State* L) {
  Keys keys(L, 1, "fibre_section");
  if (!keys.has("shape")) keys.missing("shape", "a section such as trilith.rectangle_section{width =, depth =}");
  if (!keys.has("law")) keys.missing("law", "a law of fibres such as trilith.kent_park{strength = 30e6}");
  const std::optional<FibreShape> shape = read_shape(keys, "shape");
  FibreSpec spec{shape.value_or(RectangleSection{1, 1}), read_fibre_law(keys, "law").value_or(UniaxialElastic{})};
  if (keys.has("layers")) spec.layers = spec.cells[0] = keys.count("layers", spec.layers);
  if (keys.has("layers_across") && (spec.cells[1] = keys.count("layers_across", 1)) < 1)
    keys.problem(fmt::format("'layers_across' is {}, must be at least 1", spec.cells[1]));
  spec.cover = keys.number("cover", "m", 0);
  spec.core = read_shape(keys, "core");
  spec.cover_law = read_fibre_law(keys, "cover_law").value_or(spec.law);
  read_list(keys, "bars", "bars", [&](Keys& own) {
    spec.bars.push_back({own.number("area", "m2"), own.number("height", "m"), own.count("count", 1),
                         own.number("across", "m", 0), own.number("spread", "m", 0)});
  });
  const std::optional<UniaxialLaw> bar_law = read_fibre_law(keys, "bar_law");
  if (!spec.bars.empty() && !bar_law) keys.missing("bar_law", "the law of the bars, such as trilith.menegotto_pinto{}");
  spec.bar_law = bar_law.value_or(UniaxialElastic{});
  keys.finish();
  const FibreSection made = make_fibres(spec);  // reports errors here instead of at a member later
  const std::string text = fmt::format("fibre_section of {} fibres of {}", made.fibres.size(), law_text(spec.law));
  std::string not_in_space;
  const Section3 in_space = shape_in_space(spec.shape, not_in_space);
  push_handle(L, SectionValue{section_of(spec.shape), text, std::nullopt, spec, in_space, not_in_space});
  return 1;
}

constexpr std::array<const char*, 4> hinge_states{"elastic", "yielded", "failed", "removed"};

}  // namespace

std::array<std::optional<HingeLaw>, 2> read_hinges(Keys& keys) {
  std::array<std::optional<HingeLaw>, 2> out;
  const auto read = [&](const char* key, std::initializer_list<std::size_t> ends) {
    if (const auto* const hinge = keys.maybe_handle<HingeLawValue>(key))
      for (const std::size_t end : ends) out[end] = std::get<HingeLaw>(hinge->law);
  };
  read("hinge", {0, 1}), read("from_hinge", {0}), read("to_hinge", {1});
  return out;
}

bool read_mass_matrix(Keys& keys) {
  return keys.choice("mass_matrix", {"lumped", "consistent"}, 0) == 1;
}

const char* hinge_state_text(HingeStatus status) {
  return hinge_states[static_cast<std::size_t>(status)];
}

void open_yields(lua_State* L) {
  register_kind<FibreLawValue>(L);
  register_kind<HingeLawValue>(L);
  UniaxialLaws::for_each(AddLaw<FibreLawValue>{L});
  set_function(L, std::string(HingeLaw::name).c_str(), guarded<make_end_hinge>);
  set_function(L, "fibre_section", guarded<make_fibre_section>);
}

TRILITH_LAW_KIND(FibreLawValue)
TRILITH_LAW_KIND(HingeLawValue)

}  // namespace trilith::script
