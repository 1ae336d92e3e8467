// Private to view/: the frames of a results file as blocks of integers.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "view/bytes.hpp"
#include "view/data.hpp"

namespace trilith::view {

/// Blocks of T frames, N nodes, E elements, B bearings, and K contact forces in G of the frames. Without frames there
/// are none.
///
///     time [T], stage [T], position [T, 2 N], rotation [T, N]; stress [T, 3 E], plastic [T, E]; bearing_state [T, B],
///     bearing_force and bearing_displacement [T, 2 B]; contact_frame [G] and contact_first [G + 1] (rows),
///     contact_place and contact_force [K, 2], contact_pair [K, 3] (body a, body b, state); temperature [T, N]
///     [degC], -273.15: none; member_force and member_state.
struct ViewFrames {
  std::vector<ViewBlock> blocks;
  std::size_t frame_stride = 1, contact_stride = 1;  ///< stride of the frames kept
  std::set<std::pair<int, int>> bonded;              ///< pairs of bodies with a bond in some frame, the lower index
                                                     ///< first
};

ViewFrames view_frames(const results::ResultsReader& reader, const ViewLimits& limits, const ViewProgress& progress);

}  // namespace trilith::view
