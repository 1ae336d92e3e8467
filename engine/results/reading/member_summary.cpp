#include "results/reading/member_summary.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "results/file/placement.hpp"

namespace trilith::results {
namespace {

Vec3 end_of_beam(const Placement& at, const BeamRow& beam, int end) {
  const double* const arm = end == 0 ? beam.arm_a : beam.arm_b;
  return at.at(end == 0 ? beam.node_a : beam.node_b, Vec3(arm[0], arm[1], arm[2]));
}

/// The row of an event is of this member: its text names it, or it is the only one of its body.
bool is_of_member(const Header& header, const EventRow& event, const MemberRow& member) {
  if (event.body_a != member.body) return false;
  const std::string& body = header.bodies[static_cast<std::size_t>(member.body)].name;
  return member.name == body || event.text.starts_with(body + ": " + member.name + " ");
}

/// Curvature at the first yield of each member of fibres [1/m]; 0: it has not yielded.
std::vector<double> yield_curvatures(const Header& header, const std::vector<EventRow>& events) {
  std::vector<double> out(header.members.size());
  for (const EventRow& e : events) {
    if (e.type != "member.yielded" || e.second.name != "curvature") continue;
    for (std::size_t m = 0; m < out.size(); ++m)
      if (out[m] == 0 && is_of_member(header, e, header.members[m])) out[m] = std::abs(e.second.value);
  }
  return out;
}

class Gathered {
 public:
  Gathered(const Header& header, const std::vector<EventRow>& events)
      : header_(header),
        start_frame_(start_frame(header)),
        start_(header, start_frame_),
        yield_(yield_curvatures(header, events)),
        out_(header.members.size()) {}

  void add(const Frame& frame) {
    const Placement at(header_, frame);
    const MemberValues values(header_, frame);
    for (std::size_t m = 0; m < out_.size(); ++m) {
      add_forces(m, frame.time, values);
      add_yielding(m, frame.time, values);
      add_drift(m, frame.time, at);
    }
    ++frames_;
  }

  std::vector<MemberSummary> take() { return std::move(out_); }

 private:
  void add_forces(std::size_t m, double time, const MemberValues& values) {
    const MemberRow& member = header_.members[m];
    const std::vector<MemberQuantity>& quantities = member_quantities(header_.dim);
    MemberSummary& own = out_[m];
    own.low.resize(quantities.size()), own.high.resize(quantities.size());
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      double along = 0;
      for (int i = member.first_beam; i < member.first_beam + member.beam_count; ++i) {
        const auto beam = static_cast<std::size_t>(i);
        for (const int end : {0, 1}) {
          const MemberExtreme now{values.force(beam, end, quantities[q]), time,
                                  along + end * header_.beams[beam].length};
          const bool first = frames_ == 0 && i == member.first_beam && end == 0;
          if (first || now.value < own.low[q].value) own.low[q] = now;
          if (first || now.value > own.high[q].value) own.high[q] = now;
        }
        along += header_.beams[beam].length;
      }
    }
  }

  void add_yielding(std::size_t m, double time, const MemberValues& values) {
    const MemberRow& member = header_.members[m];
    if (member.yields == "elastic") return;
    MemberSummary& own = out_[m];
    own.yielded = own.can_yield = 0, own.state = MemberState::elastic;
    double along = 0;
    for (int i = member.first_beam; i < member.first_beam + member.beam_count; ++i) {
      const auto beam = static_cast<std::size_t>(i);
      for (const int end : {0, 1}) {
        const bool outer = i == (end == 0 ? member.first_beam : member.first_beam + member.beam_count - 1);
        const bool counts = member.yields == "fibres" ? end == 0 : outer && member.yield_rotation[end] > 0;
        const MemberState state = values.state(beam, end);
        own.can_yield += counts ? 1 : 0, own.yielded += counts && state != MemberState::elastic ? 1 : 0;
        own.state = std::max(own.state, state);
        add_deformation(m, end, {values.deformation(beam, end), time, along + end * header_.beams[beam].length});
      }
      along += header_.beams[beam].length;
    }
  }

  void add_deformation(std::size_t m, int end, const MemberExtreme& now) {
    const MemberRow& member = header_.members[m];
    MemberSummary& own = out_[m];
    if (std::abs(now.value) > std::abs(own.deformation.value)) own.deformation = now;
    double demand = 0;
    if (member.yields == "fibres" && yield_[m] > 0) demand = std::abs(now.value) / yield_[m];
    if (member.yields == "hinges" && member.yield_rotation[end] > 0 && now.value != 0)
      demand = 1 + std::abs(now.value) / member.yield_rotation[end];
    if (demand > own.ductility.value_or(0) && demand >= 1) own.ductility = demand;
  }

  void add_drift(std::size_t m, double time, const Placement& at) {
    const MemberRow& member = header_.members[m];
    const auto first = static_cast<std::size_t>(member.first_beam),
               last = static_cast<std::size_t>(member.first_beam + member.beam_count - 1);
    const auto between = [&](const Placement& places) {
      return Vec3(end_of_beam(places, header_.beams[last], 1) - end_of_beam(places, header_.beams[first], 0));
    };
    const int up = header_.dim - 1;
    const Vec3 stood = between(start_), way = between(at) - stood;
    if (std::abs(stood[up]) < M_SQRT1_2 * stood.norm()) return;
    double square = 0;
    for (int k = 0; k < up; ++k) square += way[k] * way[k];
    const double drift = std::sqrt(square) / std::abs(stood[up]);
    if (!out_[m].drift || drift > out_[m].drift->value) out_[m].drift = MemberExtreme{drift, time, 0};
  }

  const Header& header_;
  Frame start_frame_;
  Placement start_;
  std::vector<double> yield_;
  std::vector<MemberSummary> out_;
  std::size_t frames_ = 0;
};

}  // namespace

std::vector<MemberSummary> member_summaries(const ResultsReader& reader, const std::vector<EventRow>& events) {
  if (reader.header().members.empty() || reader.frame_count() == 0) return {};
  Gathered gathered(reader.header(), events);
  for (std::size_t f = 0; f < reader.frame_count(); ++f) gathered.add(reader.frame(f));
  return gathered.take();
}

}  // namespace trilith::results
