// Frames that yield, for the physics tests.
#pragma once

#include "physics/members/frames.hpp"

namespace trilith::testing {

inline constexpr double yield_moment = 1e5;  ///< [N m]

inline HingeLaw plain_hinge(double sagging = yield_moment) {
  HingeLaw law;
  law.sagging = sagging;
  return law;
}

/// A portal of 4 m by 6 m on two fixed or pinned feet, sections of 0.1 m x 0.2 m, with plastic hinges at both ends of
/// its columns and at mid-span. It is so stiff that it keeps its shape until it is a mechanism.
struct YieldingPortal {
  double down = 0, side = 0;  ///< full loads at mid-span and at beam level [N]
  bool fixed = true;
  HingeLaw law = plain_hinge();
  double young = 2.1e13;

  [[nodiscard]] BodySpec body() const {
    const auto foot = fixed ? held : hinged;
    BodySpec spec;
    spec.name = "portal", spec.kind = BodyKind::frame, spec.material = "steel", spec.floating = true;
    FrameSpec frame;
    frame.joints = {{.name = "a", .place = {0, 0}, .support = foot},
                    {.name = "b", .place = {0, 4}},
                    {.name = "m", .place = {3, 4}},
                    {.name = "c", .place = {6, 4}},
                    {.name = "d", .place = {6, 0}, .support = foot}};
    const auto add = [&](const char* name, int from, int to, const MemberHinges& hinges) {
      FrameMember member;
      member.name = name, member.from = from, member.to = to, member.divisions = 1;
      member.section = rectangle_section(0.1, 0.2), member.yields = hinges;
      frame.members.push_back(member);
    };
    add("left", 0, 1, {{fixed ? std::optional(law) : std::nullopt, law}});
    add("beam 1", 1, 2, {{std::nullopt, law}});
    add("beam 2", 2, 3, {});
    add("right", 4, 3, {{fixed ? std::optional(law) : std::nullopt, law}});
    spec.frame = frame;
    return spec;
  }
  /// The loads grow over 2 s to `share` of their full values.
  [[nodiscard]] Model<2> model(double share) const {
    Model<2> made = of_frames(elastic_material("steel", 7850, young), {body()});
    const LoadCurve ramp{{0, 2}, {0, share}};
    add_load(made, "portal", {3, 4}, {0, -down}, 0, ramp);
    add_load(made, "portal", {0, 4}, {side, 0}, 0, ramp);
    made.mass_damping = 5;
    return made;
  }
};

}  // namespace trilith::testing
