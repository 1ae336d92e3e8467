// The kinds of fields. A new kind is a row here, the makers of its cells in model/field/, and its mechanical effect.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace trilith {

/// Quantity of a field.
enum class FieldKind : std::uint8_t { heat, seepage };

struct FieldKindInfo {
  std::string_view name, value, unit;  ///< of the field, of its value
  std::string_view content_unit;       ///< of capacity times value
};

/// In the order of FieldKind, whose numbers enter digests.
inline constexpr std::array<FieldKindInfo, 2> field_kinds{
    {{"heat", "temperature", "degC", "J"}, {"seepage", "pressure head", "m", "m3"}}};

constexpr const FieldKindInfo& info_of(FieldKind kind) {
  return field_kinds[static_cast<std::size_t>(kind)];
}

}  // namespace trilith
