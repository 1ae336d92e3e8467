// A row of the list of events (model/event/event_list.hpp).
#pragma once

#include <array>
#include <string_view>

#include "model/event/event.hpp"

namespace trilith {

/// How much an event means for the structure, in rising order.
enum class Severity : int {
  routine,  ///< omitted where only important events are shown
  notice,   ///< important, without damage
  change,   ///< the model has changed
  damage,   ///< yielding, cracking, crushing: the part still carries
  failure,  ///< a bond is lost
  loss,     ///< a support, a member or an element is lost
  invalid   ///< the run is not valid from here, or from the event's value; see model/verdict.hpp
};
inline constexpr int severities = 7;

/// As in scripts and on pages.
constexpr std::string_view name_of(Severity severity) {
  constexpr std::array<std::string_view, severities> names{"routine", "notice", "change", "damage",
                                                           "failure", "loss",   "invalid"};
  return names[static_cast<std::size_t>(severity)];
}

/// Properties of a type of events; several are joined by |.
enum EventTrait : unsigned {
  has_place = 1,   ///< Event::x, y and z are its place
  of_joint = 2,    ///< of a mortar joint: Event::mode is the mode of failure
  can_cause = 4,   ///< later events of its bodies may follow from it
  valid_until = 8  ///< of an invalid one: Event::value is the last valid time, instead of Event::time
};

/// Event::value; the name is empty where the type has none.
struct EventValue {
  std::string_view name = {}, unit = {};
  std::string_view doc = {};  ///< empty where the name is sufficient
};

struct EventTypeInfo {
  EventType type;
  std::string_view name;     ///< as in scripts and results
  std::string_view heading;  ///< in a few words
  Severity severity;
  unsigned traits = 0;
  EventValue value = {};
  std::string_view text_doc = {};  ///< meaning of Event::text; empty where a type has none, or its sentence states it
  std::string_view doc;            ///< for the reference
  std::string_view sentence;       ///< pattern of event_text; words in braces are among `event_words`
};

/// Words that a sentence may have in braces. model/event/event_text.cpp writes them.
inline constexpr std::array<std::string_view, 12> event_words{
    "a",        ///< name of the body that moves, or of the first one
    "b",        ///< name of the other body
    "body_a",   ///< name of Event::body_a
    "body_b",   ///< name of Event::body_b
    "bearing",  ///< name of the bearing
    "text",     ///< Event::text
    "value",    ///< Event::value in its unit
    "at",       ///< " at " and the value; nothing where it is 0
    "mode",     ///< " in shear at 12 kN"
    "becomes",  ///< "became b" or "was replaced: ..." of a failed bearing
    "strain",   ///< "was stretched by 12 %"
    "ended"     ///< "shaking ended (rest)", from "shaking: rest"
};

/// Whether all words in braces of a sentence are among `event_words`.
constexpr bool has_known_words(std::string_view sentence) {
  for (std::size_t from = sentence.find('{'); from != std::string_view::npos; from = sentence.find('{', from + 1)) {
    const std::size_t to = sentence.find('}', from);
    bool is_known = false;
    for (const std::string_view word : event_words)
      is_known = is_known || (to != std::string_view::npos && sentence.substr(from + 1, to - from - 1) == word);
    if (!is_known) return false;
  }
  return !sentence.empty();
}

constexpr bool is_complete(const EventTypeInfo& row) {
  return !row.name.empty() && !row.heading.empty() && !row.doc.empty() && has_known_words(row.sentence) &&
         row.value.name.empty() == row.value.unit.empty();
}

}  // namespace trilith
