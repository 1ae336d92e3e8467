// The kinds of bodies. A new kind is its own file of equations and a row here.
// docs/decisions/bodies/0022-body-kinds.md lists the other places that it affects.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>

#include "base/schema.hpp"

namespace trilith {

enum class BodyKind : std::uint8_t { rigid, quad, mesh, frame, brick };

/// Kinematics of a body's skin points: defines `place` and its transpose `spread`.
enum class SkinLayout : std::uint8_t {
  one_node,   ///< all rotate with the one node
  node_each,  ///< each is a node without rotation; both lists run in parallel
  sections,   ///< each rotates with one of the nodes, as at the end sections of a beam
};

/// The part of a body that resists deformation: it defines `resist`, the bound of its rates and its tangent.
enum class Resistance : std::uint8_t { none, elements, beams };

/// element/rigid/rigid.hpp, element/rigid/rigid_turn.hpp
struct RigidKind {
  static constexpr BodyKind kind = BodyKind::rigid;
  static constexpr std::string_view name = "rigid", sentence = "rigid; one node with rotation";
  static constexpr int nodes = 1;
  static constexpr SkinLayout skin = SkinLayout::one_node;
  static constexpr bool nodes_turn = true;
  static constexpr Resistance resistance = Resistance::none;
};

/// element/solid/plane_element.hpp
struct QuadKind {
  static constexpr BodyKind kind = BodyKind::quad;
  static constexpr std::string_view name = "quad", sentence = "a quadrilateral of four nodes, one finite element";
  static constexpr int nodes = 4;
  static constexpr SkinLayout skin = SkinLayout::node_each;
  static constexpr bool nodes_turn = false;
  static constexpr Resistance resistance = Resistance::elements;
};

/// element/solid/plane_element.hpp, element/solid/space_element.hpp
struct MeshKind {
  static constexpr BodyKind kind = BodyKind::mesh;
  static constexpr std::string_view name = "mesh",
                                    sentence = "a mesh of finite elements; in space of bricks, wedges and tetrahedra";
  static constexpr int nodes = 0;
  static constexpr SkinLayout skin = SkinLayout::node_each;
  static constexpr bool nodes_turn = false;
  static constexpr Resistance resistance = Resistance::elements;
};

/// element/beam/beam.hpp, element/beam/beam_element.hpp
struct FrameKind {
  static constexpr BodyKind kind = BodyKind::frame;
  static constexpr std::string_view name = "frame",
                                    sentence =
                                        "beams that meet at joints; nodes with rotation, sections that stay plane";
  static constexpr int nodes = 0;
  static constexpr SkinLayout skin = SkinLayout::sections;
  static constexpr bool nodes_turn = true;
  static constexpr Resistance resistance = Resistance::beams;
};

/// element/solid/space_element.hpp
struct BrickKind {
  static constexpr BodyKind kind = BodyKind::brick;
  static constexpr std::string_view name = "brick", sentence = "in space, a brick of eight nodes, one finite element";
  static constexpr int nodes = 8;
  static constexpr SkinLayout skin = SkinLayout::node_each;
  static constexpr bool nodes_turn = false;
  static constexpr Resistance resistance = Resistance::elements;
};

/// In the order of BodyKind, whose numbers are stored in results and checkpoints.
using BodyKinds = TypeList<RigidKind, QuadKind, MeshKind, FrameKind, BrickKind>;

/// Declarations of a kind: number of nodes of a body (0 if it varies), whether they have rotations, skin layout and
/// resistance. Skin that rotates with nodes requires nodes with rotations. A single node has no deformation.
template <class K>
concept BodyKindType = requires {
  { K::kind } -> std::convertible_to<BodyKind>;
  { K::name } -> std::convertible_to<std::string_view>;
  { K::sentence } -> std::convertible_to<std::string_view>;
  { K::nodes } -> std::convertible_to<int>;
  { K::skin } -> std::convertible_to<SkinLayout>;
  { K::nodes_turn } -> std::convertible_to<bool>;
  { K::resistance } -> std::convertible_to<Resistance>;
  requires K::nodes_turn == (K::skin != SkinLayout::node_each);
  requires(K::nodes == 1) == (K::skin == SkinLayout::one_node);
  requires(K::nodes == 1) == (K::resistance == Resistance::none);
};

struct BodyKindInfo {
  std::string_view name, sentence;
  int nodes;  ///< number of nodes of a body of this kind; 0 if it varies
  SkinLayout skin;
  bool nodes_turn;  ///< its nodes have rotations
  Resistance resistance;
};

/// The same declarations by number, for code that knows the kind at run time.
inline constexpr std::array<BodyKindInfo, BodyKinds::size> body_kinds = [] {
  std::array<BodyKindInfo, BodyKinds::size> out{};
  BodyKinds::for_each([&]<class K>() {
    out[static_cast<std::size_t>(K::kind)] = {K::name, K::sentence, K::nodes, K::skin, K::nodes_turn, K::resistance};
  });
  return out;
}();
static_assert([] {
  for (const BodyKindInfo& kind : body_kinds)
    if (kind.name.empty()) return false;
  return true;
}());  // each number has its own row

constexpr const BodyKindInfo& info_of(BodyKind kind) {
  return body_kinds[static_cast<std::size_t>(kind)];
}
/// "rigid", "quad", "mesh", "frame", "brick".
constexpr std::string_view name_of(BodyKind kind) {
  return info_of(kind).name;
}

}  // namespace trilith
