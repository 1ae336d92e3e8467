#include "model/check/frame_plausibility.hpp"

#include <fmt/format.h>

#include "model/plausible_ranges.hpp"

namespace trilith {
namespace {

/// Notes member by member; a law shared by many members is noted once.
class FrameNotes {
 public:
  FrameNotes(const std::string& owner, std::vector<std::string>& notes) : owner_(owner), notes_(notes) {}

  void section(const std::string& member, double area) {
    add_plausibility_note_once(notes_, of(member), "section area", "m2", area);
  }
  void fibres(const std::string& member, const MemberFibres& fibres) {
    const std::string owner = of(member);
    law(owner + ", fibres", fibres.spec.law);
    if (fibres.spec.cover > 0) law(owner + ", cover", fibres.spec.cover_law);
    if (!fibres.spec.bars.empty()) law(owner + ", bars", fibres.spec.bar_law);
    for (const FibreBars& bars : fibres.spec.bars)
      add_plausibility_note_once(notes_, owner + ", bars", "section area", "m2", bars.area);
  }
  void hinge(const std::string& member, const std::optional<HingeLaw>& hinge) {
    if (hinge) numbers(of(member) + ", hinge", *hinge);
  }

 private:
  [[nodiscard]] std::string of(const std::string& member) const {
    return member.empty() ? owner_ : fmt::format("{}: member '{}'", owner_, member);
  }
  void law(const std::string& owner, const UniaxialLaw& law) {
    std::visit(
        [&](const auto& l) {
          if constexpr (Declared<std::decay_t<decltype(l)>>) numbers(owner, l);
        },
        law);
  }
  template <Declared T>
  void numbers(const std::string& owner, const T& value) {
    for (const Parameter<T>& p : T::parameters())
      add_plausibility_note_once(notes_, owner, p.name, p.unit, value.*(p.member));
  }

  std::string owner_;
  std::vector<std::string>& notes_;
};

}  // namespace

template <int D>
void add_frame_plausibility_notes(const FrameSpecOf<D>& frame, const std::string& owner,
                                  std::vector<std::string>& notes) {
  FrameNotes frame_notes(owner, notes);
  for (const FrameMemberOf<D>& member : frame.members) {
    frame_notes.section(member.name, member.section.area);
    if (const auto* fibres = std::get_if<MemberFibres>(&member.yields)) frame_notes.fibres(member.name, *fibres);
    if (const auto* hinges = std::get_if<MemberHinges>(&member.yields))
      for (const auto& hinge : hinges->end) frame_notes.hinge(member.name, hinge);
  }
}

template void add_frame_plausibility_notes(const FrameSpecOf<2>& frame, const std::string& owner,
                                           std::vector<std::string>& notes);
template void add_frame_plausibility_notes(const FrameSpecOf<3>& frame, const std::string& owner,
                                           std::vector<std::string>& notes);

}  // namespace trilith
