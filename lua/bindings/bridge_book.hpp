// What a model knows of its bridges: supports, bearing types and spans, and what a bearing of each type is made of.
#pragma once

#include <map>
#include <string>

#include "build/bridge_layout.hpp"
#include "script_model.hpp"

namespace trilith::script {

/// A bearing type: a bearing but for its name, bodies and place, and the contact law of deck and support.
struct BearingRecipe {
  BearingSpec bearing;
  bool links = false;   ///< it has a law in some direction; else the deck just lies on its seat
  std::string contact;  ///< name of the law; "": the one of the surfaces
};

struct BridgeBook {
  BridgeLayout layout;
  std::map<std::string, BearingRecipe> recipes;  ///< by the type's name
};

/// The model's book; made where there is none.
inline BridgeBook& book_of(PlaneModel& m) {
  if (!m.bridge) m.bridge = std::make_shared<BridgeBook>();
  return *m.bridge;
}

/// Of the bearing and the seat at the left (0) or right (1) end of a span: "S1.left".
inline std::string span_end_name(const std::string& span, std::size_t side) {
  return part_name(span, side == 0 ? "left" : "right");
}

}  // namespace trilith::script
