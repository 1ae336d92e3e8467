#include "build/plane/bridge_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace trilith {
namespace {

/// Largest difference of two equal levels [m]: far above rounding, far below the deformation of a bearing.
constexpr double same_level = 1e-6;

constexpr std::array<const char*, 2> side_names{"left", "right"};

/// The joint of the support, or a joint of the width that the span gives.
SupportJoint joint_on(const SupportTop& top, const std::optional<double>& gap, const std::string& owner) {
  if (top.joint) return *top.joint;
  if (!gap)
    throw InputError(
        fmt::format("{}: the width of the joint on support '{}' is missing; give gap at the support or at the span",
                    owner, top.name));
  SupportJoint joint{.gap = *gap};
  const double length = top.right - top.left;
  // A pier has the joint in the middle of its top and a seat on either side; an abutment has it at the back wall.
  if (top.kind == SupportKind::pier) {
    joint.axis = (top.left + top.right) / 2;
    joint.seat = (length - *gap) / 2;
  } else {
    joint.axis = top.kind == SupportKind::left_abutment ? top.left + *gap / 2 : top.right - *gap / 2;
    joint.seat = length - *gap;
  }
  if (!(joint.seat > 0))
    throw InputError(fmt::format("{}: a joint of {:g} m leaves no seat on support '{}', whose top is {:g} m long",
                                 owner, *gap, top.name, length));
  return joint;
}

/// The left (0) or right (1) end of a span, except its level. The end of the deck is half of the joint from the axis;
/// then follows the seat up to its edge, with the bearing at its middle. `into`: towards the middle of the span.
SpanEnd lay_end(const SupportTop& top, const SupportJoint& joint, std::size_t side) {
  const double into = side == 0 ? 1 : -1, end = joint.axis + into * joint.gap / 2;
  SpanEnd e;
  e.support = top.name;
  e.seat = joint.seat;
  e.end.x() = end;
  e.edge.x() = end + into * joint.seat;
  e.bearing.x() = end + into * joint.seat / 2;
  e.inward.x() = -into;
  return e;
}

void check_sides(const SupportTop& from, const SupportTop& to, const std::string& owner) {
  if (from.name == to.name)
    throw InputError(
        fmt::format("{}: from and to are both '{}'; a span reaches from one support to another", owner, from.name));
  if (from.kind == SupportKind::right_abutment)
    throw InputError(
        fmt::format("{}: from is '{}', an abutment at the right end of a bridge; give it as to", owner, from.name));
  if (to.kind == SupportKind::left_abutment)
    throw InputError(
        fmt::format("{}: to is '{}', an abutment at the left end of a bridge; give it as from", owner, to.name));
}

/// Throws if a bearing of this type on this support gives another soffit level.
void check_level(double soffit, const SupportTop& top, const BearingType& type, const std::string& owner) {
  const double here = top.level + type.height;
  if (std::abs(here - soffit) <= same_level) return;
  const auto told = [](double level) { return std::abs(level) < same_level ? 0 : level; };  // prints 0 for 1e-16
  throw InputError(
      fmt::format("{}: its underside is at y = {:g} m, but on '{}' (seat at {:g} m, bearing type '{}' "
                  "{:g} m high) it would be at {:g} m; make seats or bearings fit",
                  owner, told(soffit), top.name, told(top.level), type.name, type.height, told(here)));
}

void check_length(const LaidSpan& span, const std::array<SupportJoint, 2>& joints, const std::string& owner) {
  const std::string &from = span.ends[0].support, &to = span.ends[1].support;
  if (!(joints[1].axis > joints[0].axis))
    throw InputError(
        fmt::format("{}: '{}' at x = {:g} m is not to the right of '{}' at {:g} m; from is the left support", owner, to,
                    joints[1].axis, from, joints[0].axis));
  if (const double seats = joints[0].seat + joints[1].seat; !(span.length() > seats))
    throw InputError(
        fmt::format("{}: from '{}' at x = {:g} m to '{}' at {:g} m the joints leave {:g} m of deck, which must "
                    "be above the {:g} m of both seats",
                    owner, from, joints[0].axis, to, joints[1].axis, span.length(), seats));
}

}  // namespace

SupportTop top_of(const Pier& pier) {
  const Pier p = with_seats(pier);
  const double half = (p.top_width > 0 ? p.top_width : p.stem_width) / 2;
  SupportTop top{p.name, SupportKind::pier, p.ground_level + p.height, p.x - half, p.x + half};
  if (p.gap) top.joint = SupportJoint{p.x, *p.gap, p.seat};
  return top;
}

SupportTop top_of(const Abutment& abutment) {
  const Abutment a = with_seats(abutment);
  const bool left = a.side == AbutmentSide::left;
  const double away = left ? -1 : 1, far = a.x + away * (a.width - a.back_wall_width);
  SupportTop top{a.name, left ? SupportKind::left_abutment : SupportKind::right_abutment, a.ground_level + a.height,
                 std::min(a.x, far), std::max(a.x, far)};
  if (a.gap) top.joint = SupportJoint{a.axis.value_or(a.x + away * (*a.gap / 2 + a.seat)), *a.gap, a.seat};
  return top;
}

SupportTop top_of(const std::string& name, const Polygon& outline) {
  const double high = bounding_box(outline).high.y();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (std::abs(a.y() - high) <= same_level && std::abs(b.y() - high) <= same_level)
      return {name, SupportKind::pier, high, std::min(a.x(), b.x()), std::max(a.x(), b.x())};
  }
  throw InputError(fmt::format("support '{}': its highest point, at y = {:g} m, is a corner; a span needs a level face",
                               name, high));
}

bool BridgeLayout::has_support(const std::string& name) const {
  return std::any_of(supports_.begin(), supports_.end(), [&](const SupportTop& top) { return top.name == name; });
}

const SupportTop& BridgeLayout::require_support(const std::string& name, const std::string& owner) const {
  std::vector<std::string> known;
  for (const SupportTop& top : supports_) {
    if (top.name == name) return top;
    known.push_back(top.name);
  }
  throw InputError(fmt::format("{}: there is no support '{}'{}", owner, name,
                               known.empty() ? "; piers and abutments come before spans" : name_hint(name, known)));
}

void BridgeLayout::add_bearing_type(const BearingType& type) {
  const std::string owner = builder_title("bearing type", type.name);
  require_not_negative(type.height, owner + ": height", "m");
  for (const BearingType& other : types_)
    if (other.name == type.name) throw InputError(owner + ": exists already; give each type its own name");
  types_.push_back(type);
}

const BearingType& BridgeLayout::require_type(const std::string& name, const std::string& owner) const {
  std::vector<std::string> known;
  for (const BearingType& type : types_) {
    if (type.name == name) return type;
    known.push_back(type.name);
  }
  throw InputError(fmt::format("{}: there is no bearing type '{}'{}", owner, name,
                               known.empty() ? "; bearing types come before spans" : name_hint(name, known)));
}

LaidSpan BridgeLayout::lay(const SpanPlan& plan) const {
  const std::string owner = builder_title("span", plan.name);
  require_positive(plan.depth, owner + ": depth", "m");
  if (plan.gap) require_not_negative(*plan.gap, owner + ": gap", "m");
  if (plan.soffit_level) require_finite(*plan.soffit_level, owner + ": soffit level");
  const std::array tops{&require_support(plan.from, owner + ": from"), &require_support(plan.to, owner + ": to")};
  const std::array types{&require_type(plan.left, owner + ": left"), &require_type(plan.right, owner + ": right")};
  check_sides(*tops[0], *tops[1], owner);
  const std::array joints{joint_on(*tops[0], plan.gap, owner), joint_on(*tops[1], plan.gap, owner)};
  // The left bearing determines the level, and the right one must match it.
  const double soffit = plan.soffit_level.value_or(tops[0]->level + types[0]->height);
  LaidSpan span;
  for (const std::size_t side : {0, 1}) {
    SpanEnd& e = span.ends[side] = lay_end(*tops[side], joints[side], side);
    e.type = types[side]->name;
    e.end.y() = e.edge.y() = e.bearing.y() = soffit;
    check_level(soffit, *tops[side], *types[side], owner);
  }
  check_length(span, joints, owner);
  span.deck = {plan.name, rectangle(span.ends[0].end, span.ends[1].end + Vec2(0, plan.depth)), {"spans"}};
  require_free(span, owner);
  return span;
}

/// Each seat carries one span, and decks must not overlap.
void BridgeLayout::require_free(const LaidSpan& span, const std::string& owner) const {
  const Box2 box = bounding_box(span.deck.outline);
  for (const LaidSpan& other : spans_) {
    for (const std::size_t side : {0, 1})
      if (other.ends[side].support == span.ends[side].support)
        throw InputError(fmt::format(
            "{}: the seat on '{}' to the {} of its joint already carries span '{}'; each seat carries one span", owner,
            span.ends[side].support, side_names[1 - side], other.deck.name));
    const Box2 theirs = bounding_box(other.deck.outline);
    if (box.low.x() < theirs.high.x() && theirs.low.x() < box.high.x() && box.low.y() < theirs.high.y() &&
        theirs.low.y() < box.high.y())
      throw InputError(fmt::format("{}: from x = {:g} to {:g} m it overlaps span '{}', from {:g} to {:g} m", owner,
                                   box.low.x(), box.high.x(), other.deck.name, theirs.low.x(), theirs.high.x()));
  }
}

}  // namespace trilith
