// What finding pairs keeps from one search to the next: where each piece was looked up, and how far it may go from
// there.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/space.hpp"
#include "shape/fat_boxes.hpp"
#include "world/contact_history.hpp"

namespace trilith {

/// Places are beside `together`, which may be anything as long as it is the same for all pieces at an instant: what
/// most move by then moves none of them, as of a building on its ground.
template <int D>
struct PieceSearch {
  FatBoxes<D> boxes;           ///< [piece] where it may go before it is looked up again
  std::vector<Vec<D>> corner;  ///< [corner] where it was looked up m
  std::vector<Vec<D>> low;     ///< [piece] the least that a corner may go from there ... m
  std::vector<Vec<D>> high;    ///< [piece] ... and the most m

  Vec<D> together = Vec<D>::Zero();  ///< m
  std::vector<int> sample;           ///< some skin points all over the model
  std::vector<Vec<D>> sample_at;     ///< [sample] where they were when `together` was found last m

  double beside = 0;  ///< faces whose corners are to move by no more than this to touch lie beside each other m
  std::vector<double> margin;                     ///< [piece] how far it may go however slow it is m
  std::vector<double> until;                      ///< [piece] it keeps within its box while Work::travel is below
                                                  ///< this m
  std::vector<double> arm;                        ///< [piece] half its longest diagonal; 0 of a body that deforms m
  std::vector<std::uint8_t> may_move;             ///< [piece] 1: its body does
  std::vector<std::uint8_t> is_due;               ///< [piece] 1: to be looked up now
  std::vector<int> due;                           ///< those pieces
  std::vector<ContactKey> found;                  ///< pairs of which one piece is due, sorted
  std::vector<std::vector<ContactKey>> found_by;  ///< [thread] room: the same as they come
  std::vector<int> to_face;                       ///< room: rows whose faces are to be looked at

  /// Bearings that alter the contact of the two pieces they sit between, by these, then by bearing.
  std::vector<std::pair<ContactKey, int>> bearing;
};

}  // namespace trilith
