// The kinds of body there are: a new one is its own file and a row here.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace trilith {

enum class BodyKind : std::uint8_t { rigid, quad, mesh };

struct BodyKindInfo {
  std::string_view name, sentence;
  int nodes;  ///< nodes a body of this kind has; 0 where it varies
};

inline constexpr std::array<BodyKindInfo, 3> body_kinds{{
    {"rigid", "one node with rotation; no deformation of its own", 1},
    {"quad", "a quadrilateral of four nodes, one finite element", 4},
    {"mesh", "a mesh of finite elements of three or four nodes", 0},
}};

/// "rigid", "quad", "mesh".
constexpr std::string_view name_of(BodyKind kind) {
  return body_kinds[static_cast<std::size_t>(kind)].name;
}

}  // namespace trilith
