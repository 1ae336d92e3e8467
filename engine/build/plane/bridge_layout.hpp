// Spans between supports: positions of their decks, seats and bearings.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "build/plane/bridge.hpp"

namespace trilith {

/// Kind of support: a pier carries spans on both sides, an abutment on the side of the bridge.
enum class SupportKind { pier, left_abutment, right_abutment };

/// The joint on a support, with its seats.
///
///     deck  |<-gap->|  deck          wall |<-gap->|  deck
///     ------+   :   +------          -----+   :   +------
///        |seat  :  seat|                  |   :   | seat |
///        +------:------+                  |   :   +------+ edge
///              axis                          axis
struct SupportJoint {
  double axis = 0;  ///< x of its middle [m]
  double gap = 0;   ///< its width [m]
  double seat = 0;  ///< length of each seat, from the end of the deck to the edge [m]
};

/// The level top of a support, on which spans lie.
struct SupportTop {
  std::string name;
  SupportKind kind = SupportKind::pier;
  double level = 0;                                  ///< y [m]
  double left = 0, right = 0;                        ///< x of its ends [m]: edges, or the face of a back wall
  std::optional<SupportJoint> joint = std::nullopt;  ///< none: the spans determine the width of the joint
};

/// Each throws InputError as with_seats() does.
SupportTop top_of(const Pier& pier);
SupportTop top_of(const Abutment& abutment);

/// Top of any other body that carries spans on both sides: its highest level face. Throws InputError if the highest
/// point of the outline is on no level face.
SupportTop top_of(const std::string& name, const Polygon& outline);

/// The properties of a bearing type that determine the position of a deck.
struct BearingType {
  std::string name;
  double height = 0;  ///< from the seat to the deck's underside [m], not below 0
};

/// Description of a span: two supports and two bearing types, all by name.
struct SpanPlan {
  std::string name = "span";
  std::string from, to;                               ///< left and right support
  std::string left, right;                            ///< bearing types at its ends
  std::optional<double> gap = std::nullopt;           ///< joint on supports without a joint of their own [m]
  double depth = 0;                                   ///< [m]
  std::optional<double> soffit_level = std::nullopt;  ///< y of the underside [m]; none: determined by its left bearing
};

/// An end of a span on its support; the y of all points is the soffit level of the deck.
struct SpanEnd {
  std::string support, type;
  double seat = 0;              ///< seat length at the start [m]
  Vec2 end = Vec2::Zero();      ///< of the deck [m]
  Vec2 edge = Vec2::Zero();     ///< of the seat [m]
  Vec2 bearing = Vec2::Zero();  ///< middle of the seat [m]
  Vec2 inward = Vec2::Zero();   ///< unit vector from the edge towards the seat
};

/// A span in position: one deck, group "spans", and its left and right end.
struct LaidSpan {
  Part deck;
  std::array<SpanEnd, 2> ends;
  [[nodiscard]] double length() const { return ends[1].end.x() - ends[0].end.x(); }  ///< of the deck [m]
};

/// Supports, bearing types and spans of a model. Each seat carries one span.
class BridgeLayout {
 public:
  void add_support(const SupportTop& top) { supports_.push_back(top); }
  [[nodiscard]] bool has_support(const std::string& name) const;

  /// Throws InputError for a height below 0 and for a duplicate name.
  void add_bearing_type(const BearingType& type);
  /// Throws InputError, with the nearest name, for an unknown type; `owner` begins the message.
  [[nodiscard]] const BearingType& require_type(const std::string& name, const std::string& owner) const;

  /// Position of the span. Throws InputError for unknown supports and bearing types, and for supports out of order or
  /// without length between them. It also throws for occupied seats, bearings that give two different soffit levels,
  /// and overlapping decks.
  [[nodiscard]] LaidSpan lay(const SpanPlan& plan) const;
  /// Adds the span to the layout.
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
