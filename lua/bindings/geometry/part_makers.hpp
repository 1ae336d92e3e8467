// The geometry builders of engine/build/plane in scripts.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "bindings/core/handles.hpp"
#include "build/list.hpp"
#include "build/plane/bridge_layout.hpp"
#include "build/plane/part.hpp"

namespace trilith::script {

/// Parts, repairs of their outlines, and the supports among them.
struct MadeParts {
  std::vector<Part> parts;
  std::vector<std::string> notes = {};
  std::vector<SupportTop> tops = {};
};

/// Makes the parts; call it after Keys::finish.
using MakeParts = std::function<MadeParts()>;

struct PartMaker {
  std::string_view name;  ///< in trilith.build
  bool single;            ///< always one part
  MakeParts (*read)(Keys&);
};

/// The rows of build/list.hpp.
inline constexpr std::size_t part_maker_count = PlaneBuilders::size;
std::span<const PartMaker, part_maker_count> part_makers();
/// m:span takes more than the part; bridge_binding.cpp adds it.
inline constexpr std::string_view span_maker = "span";

/// Pushes a part as {name =, outline =, groups =}.
void push_part(lua_State* L, const Part& part);

}  // namespace trilith::script
