// The kinds of body there are: a new one is its own file and a row here.
#pragma once

#include <array>
#include <string_view>

namespace trilith {

struct BodyKindInfo {
  std::string_view name, sentence;
  int nodes;  ///< nodes a body of this kind has; 0 where it varies
};

inline constexpr std::array<BodyKindInfo, 1> body_kinds{{
    {"rigid", "one node with rotation; no deformation of its own", 1},
}};

}  // namespace trilith
