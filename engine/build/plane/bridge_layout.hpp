// Spans between supports: where their decks, seats and bearings lie.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "build/plane/bridge.hpp"

namespace trilith {

/// From which sides spans come to a support: to a pier from both, to an abutment from that of the bridge.
enum class SupportKind { pier, left_abutment, right_abutment };

/// The joint on a support, and the seats beside it.
///
///     deck  |<-gap->|  deck          wall |<-gap->|  deck
///     ------+   :   +------          -----+   :   +------
///        |seat  :  seat|                  |   :   | seat |
///        +------:------+                  |   :   +------+ edge
///              axis                          axis
struct SupportJoint {
  double axis = 0;  ///< x of its middle, m
  double gap = 0;   ///< its width, m
  double seat = 0;  ///< length of each seat, from the end of the deck to the edge, m
};

/// The level top of a support, on which spans lie.
struct SupportTop {
  std::string name;
  SupportKind kind = SupportKind::pier;
  double level = 0;                                  ///< y, m
  double left = 0, right = 0;                        ///< its ends, x, m: edges, or a back wall's face
  std::optional<SupportJoint> joint = std::nullopt;  ///< nothing: the spans say how wide the joint is
};

/// Each throws InputError as with_seats() does.
SupportTop top_of(const Pier& pier);
SupportTop top_of(const Abutment& abutment);

/// Of any other body that is to carry spans from both sides: its highest level face. Throws InputError where the
/// highest point of the outline lies on no level face.
SupportTop top_of(const std::string& name, const Polygon& outline);

/// A kind of bearing, as far as it decides where a deck lies.
struct BearingType {
  std::string name;
  double height = 0;  ///< from the seat to the deck's underside, m, not below 0
};

/// A span to be: between two supports, on two kinds of bearings, all by name.
struct SpanPlan {
  std::string name = "span";
  std::string from, to;                               ///< left and right support
  std::string left, right;                            ///< bearing types at its ends
  std::optional<double> gap = std::nullopt;           ///< joint on supports that do not say theirs, m
  double depth = 0;                                   ///< m
  std::optional<double> soffit_level = std::nullopt;  ///< y of the underside, m; nothing: on its left bearing
};

/// An end of a span on its support; y of all points is that of the deck's underside.
struct SpanEnd {
  std::string support, type;
  double seat = 0;              ///< its length at the start, m
  Vec2 end = Vec2::Zero();      ///< of the deck, m
  Vec2 edge = Vec2::Zero();     ///< of the seat, m
  Vec2 bearing = Vec2::Zero();  ///< middle of the seat, m
  Vec2 inward = Vec2::Zero();   ///< from the edge over the seat, unit vector
};

/// A span as it lies: one deck, group "spans", and its left and right end.
struct LaidSpan {
  Part deck;
  std::array<SpanEnd, 2> ends;
  [[nodiscard]] double length() const { return ends[1].end.x() - ends[0].end.x(); }  ///< of the deck, m
};

/// Supports, bearing types and spans of a model. Each seat takes one span.
class BridgeLayout {
 public:
  void add_support(const SupportTop& top) { supports_.push_back(top); }
  [[nodiscard]] bool has_support(const std::string& name) const;

  /// Throws InputError for a height below 0 and for a name that is there already.
  void add_bearing_type(const BearingType& type);
  /// Throws InputError, with the nearest name, where there is no such type; `owner` begins it.
  [[nodiscard]] const BearingType& require_type(const std::string& name, const std::string& owner) const;

  /// Where the span lies. Throws InputError for supports and bearing types that are not there, supports that are not
  /// in order or leave no length, seats that are taken, bearings that would have the deck at two levels, and a deck
  /// that overlaps another.
  [[nodiscard]] LaidSpan lay(const SpanPlan& plan) const;
  /// The span is there from now on.
  void add(const LaidSpan& span) { spans_.push_back(span); }
  [[nodiscard]] const std::vector<LaidSpan>& spans() const { return spans_; }

 private:
  [[nodiscard]] const SupportTop& require_support(const std::string& name, const std::string& owner) const;
  void require_free(const LaidSpan& span, const std::string& owner) const;

  std::vector<SupportTop> supports_;
  std::vector<BearingType> types_;
  std::vector<LaidSpan> spans_;
};

}  // namespace trilith
