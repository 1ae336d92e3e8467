// Plastic collapse of frames with hinges (F8), by a small static solver for small displacements.
#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <cmath>
#include <string>
#include <vector>

#include "element/beam/end_hinge.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::near;

constexpr double plastic_moment = 100e3;

/// Beams between nodes, with three degrees of freedom each, some of them fixed.
struct PlasticFrame {
  struct Bar {
    int from, to;
    Vec2 along;
    double length;
    BeamStiffness stiffness;
    EndHingeMemory memory = {}, next = {};
  };
  std::vector<Vec2> nodes;
  std::vector<bool> held;
  std::vector<Bar> bars;
  HingeLaw law;
  Eigen::VectorXd load, at;
  double factor = 0;
  bool settled = true;

  PlasticFrame(std::vector<Vec2> places, const HingeLaw& hinge) : nodes(std::move(places)), law(hinge) {
    held.assign(3 * nodes.size(), false);
    load = at = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * nodes.size()));
  }
  void bar(int from, int to) {
    const Vec2 chord = nodes[to] - nodes[from];
    const double length = chord.norm();
    BeamStiffness k = beam_stiffness({2.1e11, 0}, RectangleSection{0.1, 0.2}.numbers(), length, {false, false});
    k.bow = {};
    bars.push_back({from, to, chord / length, length, k});
  }
  void hold(int node, bool x, bool y, bool turn) {
    held[3 * node] = x, held[3 * node + 1] = y, held[3 * node + 2] = turn;
  }

  /// Rows: stretch, end rotations; columns: both nodes.
  static Eigen::Matrix<double, 3, 6> shape_of(const Bar& b) {
    const Vec2 n = left_of(b.along);
    Eigen::Matrix<double, 3, 6> m = Eigen::Matrix<double, 3, 6>::Zero();
    for (const int side : {0, 1}) {
      const double sign = side == 0 ? -1 : 1;
      m.block<1, 2>(0, 3 * side) = sign * b.along.transpose();
      for (const int end : {0, 1}) m.block<1, 2>(1 + end, 3 * side) = -sign / b.length * n.transpose();
      m(1 + side, 3 * side + 2) = 1;
    }
    return m;
  }

  void forces(const Eigen::VectorXd& u, Eigen::VectorXd& force, Eigen::MatrixXd& stiffness) {
    force.setZero(u.size()), stiffness.setZero(u.size(), u.size());
    for (Bar& b : bars) {
      Eigen::Matrix<double, 6, 1> own;
      own << u.segment<3>(3 * b.from), u.segment<3>(3 * b.to);
      const auto shape = shape_of(b);
      const Eigen::Vector3d d = shape * own;
      const EndHingeResponse r = respond(b.stiffness, {&law, &law}, {d[0], d[1], d[2]}, b.memory);
      settled = settled && r.settled;
      b.next = r.memory;
      const Eigen::Matrix<double, 6, 1> f = shape.transpose() * Eigen::Vector3d(r.stress[0], r.stress[1], r.stress[2]);
      const Eigen::Matrix<double, 6, 6> k = shape.transpose() * r.tangent * shape;
      const int place[2] = {3 * b.from, 3 * b.to};
      for (const int i : {0, 1}) {
        force.segment<3>(place[i]) += f.segment<3>(3 * i);
        for (const int j : {0, 1}) stiffness.block<3, 3>(place[i], place[j]) += k.block<3, 3>(3 * i, 3 * j);
      }
    }
  }

  /// Moves the degree of freedom `led` by `step`, with all loads in proportion, subdivided if the iteration does not
  /// converge. False without equilibrium.
  bool advance(int led, double step, int cuts = 10) {
    const Eigen::VectorXd from = at;
    const double before = factor;
    if (iterate(led, step)) return true;
    at = from, factor = before;
    return cuts > 0 && advance(led, 0.5 * step, cuts - 1) && advance(led, 0.5 * step, cuts - 1);
  }
  bool iterate(int led, double step) {
    const Eigen::Index n = at.size();
    const double goal = at[led] + step;
    Eigen::VectorXd force;
    Eigen::MatrixXd k;
    for (int turn = 0; turn < 25; ++turn) {
      settled = true;
      forces(at, force, k);
      Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + 1, n + 1);
      Eigen::VectorXd left = Eigen::VectorXd::Zero(n + 1);
      whole.topLeftCorner(n, n) = k, whole.topRightCorner(n, 1) = -load, left.head(n) = factor * load - force;
      whole(n, led) = 1, left[n] = goal - at[led];
      for (Eigen::Index i = 0; i < n; ++i)
        if (held[i]) whole.row(i).setZero(), whole.col(i).setZero(), whole(i, i) = 1, left[i] = 0;
      if (!left.allFinite()) return false;
      if (turn > 0 && left.cwiseAbs().maxCoeff() < 1e-4) {
        for (Bar& b : bars) b.memory = b.next;
        return true;
      }
      const Eigen::VectorXd go = whole.fullPivLu().solve(left);
      at += go.head(n), factor += go[n];
    }
    return false;
  }
  /// The load factor when `led` has reached `reach`.
  double push(int led, double reach, int steps = 400) {
    for (int i = 0; i < steps; ++i)
      if (!advance(led, reach / steps)) {
        FAIL_CHECK("no equilibrium in step ", i);
        break;
      }
    CHECK(settled);
    return factor;
  }
};

HingeLaw frame_hinge() {
  HingeLaw law = HingeLaw::sample();
  law.sagging = plastic_moment, law.hardening = 10;  // so small that a joint between two hinges keeps its position
  return law;
}

PlasticFrame plastic_portal(double down, double side, bool fixed, const HingeLaw& law) {
  PlasticFrame frame({{0, 0}, {0, 4}, {3, 4}, {6, 4}, {6, 0}}, law);
  for (const auto& [from, to] : {std::pair(0, 1), {1, 2}, {2, 3}, {4, 3}}) frame.bar(from, to);
  frame.hold(0, true, true, fixed), frame.hold(4, true, true, fixed);
  frame.load[3] = side, frame.load[7] = -down;
  return frame;
}

int hinges_of(const PlasticFrame& frame) {
  int count = 0;
  for (const auto& b : frame.bars)
    for (const int end : {0, 1}) count += status_of(b.memory, end) == HingeStatus::yielded ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("F8: plastic collapse of portals: combined, beam and sway mechanisms") {
  struct Row {
    double down, side;
    bool fixed;
    int led;
    double reach, expected;
  };
  for (const Row& row : {Row{100e3, 50e3, true, 3, 0.3, 1.2}, Row{100e3, 10e3, true, 7, -0.3, 4.0 / 3},
                         Row{20e3, 60e3, true, 3, 0.3, 5.0 / 3}, Row{100e3, 50e3, false, 3, 0.4, 0.8}}) {
    PlasticFrame frame = plastic_portal(row.down, row.side, row.fixed, frame_hinge());
    const double factor = frame.push(row.led, row.reach);
    MESSAGE("F8 V " << row.down << " H " << row.side << std::string(row.fixed ? " fixed: " : " pinned: ") << factor
                    << ", " << row.expected << "; ends that yielded " << hinges_of(frame));
    CHECK(near(factor, row.expected, 0.01));
  }
}

TEST_CASE("F8: plastic collapse of a beam of two spans") {
  PlasticFrame frame({{0, 0}, {3, 0}, {6, 0}, {9, 0}, {12, 0}}, frame_hinge());
  for (int i = 0; i < 4; ++i) frame.bar(i, i + 1);
  frame.hold(0, true, true, false), frame.hold(2, false, true, false), frame.hold(4, false, true, false);
  frame.load[4] = frame.load[10] = -100e3;
  const double factor = frame.push(4, -0.3);
  MESSAGE("F8 two spans: " << factor * 100 << " kN, 100 kN");
  CHECK(near(factor, 1, 0.01));
}

TEST_CASE("normal forces reduce the collapse load of a portal by their share of the interaction") {
  HingeLaw law = frame_hinge();
  law.hardening = 1e4;  // two hinges at a joint have different normal forces; the joint rotates until they agree
  PlasticFrame plain = plastic_portal(100e3, 50e3, true, law);
  const double without = plain.push(3, 0.3);
  double before = without;
  for (const double full : {4.8e6, 0.6e6, 0.3e6}) {
    law.tension = full;
    PlasticFrame frame = plastic_portal(100e3, 50e3, true, law);
    const double factor = frame.push(3, 0.3);
    MESSAGE("combined mechanism, Np " << full << " N: " << factor << "; without " << without);
    CHECK(factor < before);
    // Columns carry up to about 90 kN; half of the yielding ends belong to them.
    CHECK(factor > without * (1 - 90e3 * 90e3 / (full * full)));
    before = factor;
  }
}

TEST_CASE("a portal whose hinges soften passes a limit and carries less and less") {
  HingeLaw law = frame_hinge();
  law.capping = 0.01, law.softening = 0.1, law.residual = 0.1;
  PlasticFrame frame = plastic_portal(20e3, 60e3, true, law);
  double most = 0;
  for (int i = 0; i < 600; ++i) {
    REQUIRE(frame.advance(3, 0.5 / 600));
    most = std::max(most, frame.factor);
  }
  MESSAGE("softening portal: limit " << most << ", at last " << frame.factor);
  CHECK(near(most, 5.0 / 3, 0.05));
  CHECK(near(frame.factor, 0.1 * 5.0 / 3, 0.02));
}

}  // namespace trilith
