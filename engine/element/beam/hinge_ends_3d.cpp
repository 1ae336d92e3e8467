#include "element/beam/hinge_ends_3d.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace trilith {
namespace {

/// Unknowns of the flowing ends: two each, one end after the other.
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
using UnknownMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, 4>;

/// Solves both ends at a normal force: flowing ends are on their surfaces at the end of the step.
class EndsBeside {
 public:
  EndsBeside(const SpaceBeamOfStep& beam, const Hinges& hinge, double normal)
      : hinge_(hinge), turn_(beam.turn), k_(beam.bend + normal * beam.bow) {
    for (const std::size_t i : {0, 1}) share_[i] = std::max(0.0, hinge[i].law->beside(normal).share);
    from_ << hinge[0].from, hinge[1].from;
    trial_ = k_ * (turn_ - from_);
  }

  /// `near`: start of the search, from a similar normal force; or null.
  SpaceEnds find(const SpaceEnds* near) {
    SpaceEnds out;
    if (settle(near, out) && keeps(out)) return out;
    out = {};
    if (take_turns(out) && keeps(out)) return out;
    // Continuation from surfaces so large that no end flows, down to their size.
    constexpr double least = 1e-12, widest = 1e30;
    const std::array<double, 2> share = share_;
    double wide = 1;
    for (const std::size_t i : {0, 1})
      if (hinge_[i].yields() && !hinge_[i].gone)
        wide = std::max(wide, gauge(hinge_[i], part(trial_, i), std::max(share[i], least)));
    SpaceEnds at;
    const SpaceEnds* before = nullptr;
    if (!(wide <= widest)) return out.settled = false, out;
    for (double narrower = 0.7; wide > 1; wide *= narrower) {
      for (const std::size_t i : {0, 1}) share_[i] = wide * std::max(share[i], least);
      SpaceEnds next;
      if (settle(before, next) || take_turns(next)) at = next, before = &at;
    }
    share_ = share;
    out = {};
    if (!settle(before, out)) out = {}, take_turns(out);
    out.settled = out.settled && keeps(out);
    return out;
  }

 private:
  static Eigen::Vector2d part(const Bends& v, std::size_t end) {
    return v.segment<2>(2 * static_cast<Eigen::Index>(end));
  }

  /// Whether the laws hold. A beam beyond its own buckling load has no stiffness for the return.
  [[nodiscard]] bool keeps(const SpaceEnds& at) const {
    for (const std::size_t i : {0, 1}) {
      const SpaceHinge& h = hinge_[i];
      const auto row = 2 * static_cast<Eigen::Index>(i);
      const bool stiff = k_(row, row) > 0 && k_(row + 1, row + 1) > 0;
      if (h.yields() && !stiff && (!k_.middleRows<2>(row).isZero(0))) return false;
      if (at.flows[i] || !h.yields() || h.gone) continue;
      if (gauge(h, part(at.moment, i), share_[i]) > 1 + 1e-9) return false;
    }
    return true;
  }

  /// Tries which ends flow until it is consistent; false if no choice is.
  bool settle(const SpaceEnds* near, SpaceEnds& out) {
    out.p = from_, out.moment = trial_;
    for (const std::size_t i : {0, 1})
      if (is_out(i, trial_)) start(i, near, out);
    for (int choice = 0; choice < 8; ++choice) {
      if (!solve(out, out.flows)) return out.settled = false;
      bool fits = true;
      for (const std::size_t i : {0, 1}) {
        if (out.flows[i] && !hinge_[i].gone && out.flow[i].length < 0)
          out.flows[i] = fits = false, out.p.segment<2>(2 * static_cast<Eigen::Index>(i)) = hinge_[i].from;
        else if (!out.flows[i] && is_out(i, out.moment))
          start(i, near, out), fits = false;
      }
      if (fits) return out.settled = true;
    }
    return out.settled = false;
  }
  /// One end alone, then the other with the first one's flow, as in the plane; once the same ends flow twice, both at
  /// once from there.
  bool take_turns(SpaceEnds& out) const {
    out.p = from_, out.moment = trial_;
    constexpr int most_turns = 100;
    for (int turn = 0; turn < most_turns; ++turn) {
      const std::array<bool, 2> was = out.flows;
      for (const std::size_t i : {0, 1}) {
        const SpaceEnds before = out;
        reactivate(i, out);
        if (!is_out(i, out.moment)) continue;
        start(i, &before, out);
        if (solve(out, {i == 0, i == 1}) && (hinge_[i].gone || out.flow[i].length >= 0)) continue;
        reactivate(i, out), start(i, nullptr, out);
        if (!solve(out, {i == 0, i == 1})) return out.settled = false;
      }
      if (turn == 0 || was != out.flows) continue;
      SpaceEnds both = out;
      if (!solve(both, both.flows)) continue;
      bool fits = true;
      for (const std::size_t i : {0, 1})
        fits = fits && (both.flows[i] ? hinge_[i].gone || both.flow[i].length >= 0 : !is_out(i, both.moment));
      if (fits) return out = both, out.settled = true;
    }
    return out.settled = false;
  }
  /// Resets an end to no flow.
  void reactivate(std::size_t i, SpaceEnds& out) const {
    out.flows[i] = false, out.p.segment<2>(2 * static_cast<Eigen::Index>(i)) = hinge_[i].from;
    out.moment = k_ * (turn_ - out.p);
  }
  [[nodiscard]] bool is_out(std::size_t i, const Bends& moment) const {
    const SpaceHinge& h = hinge_[i];
    if (!h.yields() || !(k_(2 * static_cast<Eigen::Index>(i), 2 * static_cast<Eigen::Index>(i)) > 0)) return false;
    return h.gone || gauge(h, part(moment, i), share_[i]) > 1;
  }
  /// First direction of an end's flow: from `near`, else the normal of the surface at the elastic moment.
  void start(std::size_t i, const SpaceEnds* near, SpaceEnds& out) const {
    const SpaceHinge& h = hinge_[i];
    out.flows[i] = true;
    if (h.gone) {
      out.flow[i] = flow_along(h, Eigen::Vector2d::Zero(), 1, 0);
    } else if (near != nullptr && near->flows[i] && near->flow[i].length > 0) {
      out.flow[i] = flow_along(h, near->flow[i].way, near->flow[i].length, share_[i]);
    } else {
      const Eigen::Vector2d moment = part(out.moment, i), n = normal_at(h, moment);
      const auto row = 2 * static_cast<Eigen::Index>(i);
      const Eigen::Matrix2d own = k_.block<2, 2>(row, row);
      const double beyond = n.dot(moment - flow_along(h, n, 0, share_[i]).most);
      out.flow[i] = flow_along(h, n, std::max(0.0, beyond) / n.dot(own * n), share_[i]);
    }
    out.p.segment<2>(2 * static_cast<Eigen::Index>(i)) = out.flow[i].p;
  }

  /// Excess of the moments over the capacity of the ends `which`, to be made 0 [N m]; and its scale, for the tolerance.
  Unknowns beyond(const SpaceEnds& at, const std::array<bool, 2>& which, double& size) const {
    Unknowns out(2 * (which[0] + which[1]));
    Eigen::Index row = 0;
    size = 0;
    const Bends bent = turn_ - at.p;
    for (const std::size_t i : {0, 1}) {
      if (!which[i]) continue;
      out.segment<2>(row) = part(at.moment, i) - at.flow[i].most;
      const auto own = k_.middleRows<2>(2 * static_cast<Eigen::Index>(i)).cwiseAbs();
      size = std::max({size, (own * bent.cwiseAbs()).maxCoeff(), at.flow[i].most.cwiseAbs().maxCoeff(),
                       (own * turn_.cwiseAbs()).maxCoeff()});
      row += 2;
    }
    return out;
  }
  UnknownMatrix slope(const SpaceEnds& at, const std::array<bool, 2>& which) const {
    const Eigen::Index n = 2 * (which[0] + which[1]);
    UnknownMatrix out(n, n);
    Eigen::Index row = 0;
    for (const std::size_t i : {0, 1}) {
      if (!which[i]) continue;
      Eigen::Index column = 0;
      for (const std::size_t j : {0, 1}) {
        if (!which[j]) continue;
        const auto a = 2 * static_cast<Eigen::Index>(i), b = 2 * static_cast<Eigen::Index>(j);
        out.block<2, 2>(row, column) = -k_.block<2, 2>(a, b) * at.flow[j].p_by;
        if (i == j) out.block<2, 2>(row, column) -= at.flow[i].most_by;
        column += 2;
      }
      row += 2;
    }
    return out;
  }
  /// The flows after a share of a Newton step.
  [[nodiscard]] SpaceEnds moved(const SpaceEnds& at, const std::array<bool, 2>& which, const Unknowns& go,
                                double by) const {
    SpaceEnds out = at;
    Eigen::Index row = 0;
    for (const std::size_t i : {0, 1}) {
      if (!which[i]) continue;
      const double first = by * go[row], second = by * go[row + 1];
      const SpaceFlow& f = at.flow[i];
      if (hinge_[i].gone) {
        out.flow[i] = flow_along(hinge_[i], f.way + Eigen::Vector2d(first, second), 1, 0);
      } else {
        const double turn = std::clamp(second, -0.7, 0.7);
        const Eigen::Vector2d way = (f.way + turn * Eigen::Vector2d(-f.way[1], f.way[0])).normalized();
        out.flow[i] = flow_along(hinge_[i], way, f.length + first, share_[i]);
      }
      out.p.segment<2>(2 * static_cast<Eigen::Index>(i)) = out.flow[i].p;
      row += 2;
    }
    out.moment = k_ * (turn_ - out.p);
    return out;
  }
  /// Newton's method for the flow of the ends `which`; each step is shortened until the residual decreases.
  bool solve(SpaceEnds& at, const std::array<bool, 2>& which) const {
    at.moment = k_ * (turn_ - at.p);
    if (!which[0] && !which[1]) return true;
    constexpr double rounding = 1e-15, enough = 1e-11;
    double size = 0;
    Unknowns left = beyond(at, which, size);
    for (int turn = 0; turn < 60 && left.norm() > rounding * size; ++turn) {
      const Unknowns go = slope(at, which).partialPivLu().solve(-left);
      if (!go.allFinite()) break;
      bool better = false;
      for (double by = 1; by > 1e-4 && !better; by *= 0.5) {
        double other = 0;
        const SpaceEnds next = moved(at, which, go, by);
        const Unknowns rest = beyond(next, which, other);
        better = rest.norm() < left.norm();
        if (better) at = next, left = rest, size = other;
      }
      if (!better) break;
    }
    return left.norm() <= enough * size;
  }

  const Hinges& hinge_;
  Bends turn_, from_, trial_;
  Eigen::Matrix4d k_;
  std::array<double, 2> share_{};
};

}  // namespace

SpaceEnds ends_beside(const SpaceBeamOfStep& beam, const Hinges& hinge, double normal, const SpaceEnds* near) {
  return EndsBeside(beam, hinge, normal).find(near);
}

}  // namespace trilith
