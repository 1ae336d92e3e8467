// Members of frames in a picture of a results file: their shapes with clean corners, hinges, diagrams of section
// forces.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw/scene/scene_picture.hpp"
#include "results/reading/member_values.hpp"
#include "results/reading/reader.hpp"

namespace trilith::draw {

/// Distances from the axis of a member to its top and its bottom [m]; 0 where they are unknown.
struct MemberDepth {
  double above = 0, below = 0;
  [[nodiscard]] bool is_known() const { return above > 0 && below > 0; }
};

/// Depths of all members in the plane, from the outline of their body at the start; unknown in space.
std::vector<MemberDepth> member_depths(const results::Header& header);

/// Polygons of the members of each frame in the plane, and of the corners where they meet [body]; empty for other
/// bodies. The body's own outline is not among them.
std::vector<std::vector<std::vector<Vec2>>> member_parts(const results::Header& header, const results::Frame& frame);

/// Largest and smallest values at the ends of each beam over several frames: [beam][end].
struct MemberEnvelope {
  std::vector<std::array<double, 2>> low, high;
};

/// Over all frames from `begin` to `end` [s].
MemberEnvelope member_envelope(const results::ResultsReader& reader, const results::MemberQuantity& quantity,
                               double begin, double end);

/// Projection of a point or a direction onto the picture.
using Projection = std::function<Vec2(const Vec3&)>;

/// Adds the diagrams of all members that are not left out [body]: the values of the frame, or of the envelope in the
/// position of the frame.
void add_diagrams(const results::Header& header, const results::Frame& frame, const results::MemberQuantity& quantity,
                  const MemberEnvelope* envelope, const std::vector<bool>& left_out, const Projection& flat,
                  Scene& scene);

/// Adds a mark for each hinge, and one for each beam of fibres that has yielded.
void add_hinges(const results::Header& header, const results::Frame& frame, const std::vector<bool>& left_out,
                const Projection& flat, Scene& scene);

}  // namespace trilith::draw
