// The kinds of body there are: a new one is its own file and a row here.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace trilith {

enum class BodyKind : std::uint8_t { rigid, quad, mesh, frame };

/// How the points of a body's skin hang on its nodes.
enum class SkinLayout : std::uint8_t {
  one_node,   ///< all turn with the one node
  node_each,  ///< each is a node, which has no rotation; the two run side by side
  sections,   ///< each turns with one of the nodes, as the ends of a beam's sections do
};

struct BodyKindInfo {
  std::string_view name, sentence;
  int nodes;  ///< nodes a body of this kind has; 0 where it varies
  SkinLayout skin;
  bool nodes_turn;  ///< they have rotations
};

inline constexpr std::array<BodyKindInfo, 4> body_kinds{{
    {"rigid", "one node with rotation; no deformation of its own", 1, SkinLayout::one_node, true},
    {"quad", "a quadrilateral of four nodes, one finite element", 4, SkinLayout::node_each, false},
    {"mesh", "a mesh of finite elements of three or four nodes", 0, SkinLayout::node_each, false},
    {"frame", "beams that meet at joints; nodes with rotation, sections that stay plane", 0, SkinLayout::sections,
     true},
}};

constexpr const BodyKindInfo& info_of(BodyKind kind) {
  return body_kinds[static_cast<std::size_t>(kind)];
}
/// "rigid", "quad", "mesh", "frame".
constexpr std::string_view name_of(BodyKind kind) {
  return info_of(kind).name;
}

}  // namespace trilith
