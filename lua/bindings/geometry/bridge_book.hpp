// Bridge data of a model: supports, bearing types and spans, and the bearing that each type creates.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bindings/model/built_model.hpp"
#include "build/plane/bridge_layout.hpp"

namespace trilith::script {

/// A bearing type: a bearing except its name, bodies and place, and the contact law of deck and support.
template <int D>
struct BearingRecipeOf {
  BearingSpecOf<D> bearing;
  bool links = false;   ///< it has a law in some direction; otherwise the deck lies on its seat
  std::string contact;  ///< name of the law; "": the law of the surfaces
};
using BearingRecipe = BearingRecipeOf<2>;

/// For a model in space the layout contains only the bearing types: the library computes the positions of decks.
template <int D>
struct BridgeBookOf {
  BridgeLayout layout;
  std::map<std::string, BearingRecipeOf<D>> recipes;  ///< by the type's name

  /// Sizes before a bridge began to be added.
  struct Before {
    std::size_t bodies = 0, bearings = 0, seats = 0;
    BridgeLayout layout;
  };
  Before before;

  /// The contact law of a support and the deck on it, by name.
  struct SeatContact {
    std::string support, deck, law;
  };
  std::vector<SeatContact> contacts;  ///< of the bridge that is being added; set when all of it is present
};

/// The model's book; created if there is none.
inline BridgeBookOf<2>& book_of(PlaneModel& m) {
  if (!m.bridge) m.bridge = std::make_shared<BridgeBookOf<2>>();
  return *m.bridge;
}
inline BridgeBookOf<3>& book_of(SpaceModel& m) {
  if (!m.bridge) m.bridge = std::make_shared<BridgeBookOf<3>>();
  return *m.bridge;
}

/// Name of the bearing and the seat at the left (0) or right (1) end of a span: "S1.left".
inline std::string span_end_name(const std::string& span, std::size_t side) {
  return part_name(span, side == 0 ? "left" : "right");
}

}  // namespace trilith::script
