#include "field/joint_flow.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "near.hpp"

namespace trilith::testing {
namespace {

constexpr double water_weight = 9806.65;

FlowJoint fissure(int from, int to, double length, double a0, double a1, int cells) {
  FlowJoint j;
  j.name = std::to_string(from) + "-" + std::to_string(to);
  j.from = from, j.to = to, j.length = length, j.aperture = {a0, a1}, j.cells = cells, j.weight = water_weight;
  return j;
}

struct Net {
  JointFlow flow;
  FieldState state;
  FlowSolver solver;

  void add(FlowJoint j, bool filled) {
    j.first_cell = flow.cells();
    std::vector<double> volumes(state.value.begin() + flow.cells(), state.value.end());
    for (int i = 0; i < j.cells; ++i)
      volumes.push_back(filled ? j.width * j.cell_length() * j.aperture_at((i + 0.5) / j.cells) : 0);
    flow.joints.push_back(std::move(j));
    state.value.assign(static_cast<std::size_t>(flow.cells()), 0);
    state.value.insert(state.value.end(), volumes.begin(), volumes.end());
  }
  FlowStep advance(const std::vector<double>& heads, double dt) {
    state.supplied.resize(heads.size(), 0);
    FieldState after;
    const FlowStep out = solver.advance(flow, own_apertures(flow, state), heads, {}, dt, state, after);
    state = after;
    return out;
  }
};

}  // namespace

TEST_CASE("flow through a tapered joint is exact for any number of cells") {
  for (const int cells : {1, 3, 32}) {
    CAPTURE(cells);
    Net net;
    net.flow.nodes = {{"a", 0, 0}, {"b", 0, 1}};
    net.add(fissure(0, 1, 8, 6e-4, 2e-4, cells), true);
    net.advance({9, 0}, 1e9);
    const FlowStep step = net.advance({9, 0}, 1e9);
    CHECK(near(step.into[0] / 1e9, 3.309744e-5, 1e-6));
    CHECK(near(-step.into[1] / 1e9, 3.309744e-5, 1e-6));
  }
}

TEST_CASE("water is conserved while a dry net fills from below and drains again") {
  Net net;
  net.flow.nodes = {{"low", 0, 0}, {"high", 3, -1}, {"top", 4, 1}};
  FlowJoint rise = fissure(0, 1, 3, 3e-4, 2e-4, 20), last = fissure(1, 2, 1, 2e-4, 4e-4, 10);
  rise.elevation = {0, 3}, last.elevation = {3, 4};
  net.add(rise, false), net.add(last, false);
  double most = 0;
  for (const double level : {2.0, 6.0, 1.0, 0.0, 5.0})
    for (int i = 0; i < 40; ++i) {
      net.advance({level, 0}, 2);
      const double volume = volume_of(net.flow, net.state);
      most = std::max(most, volume);
      CHECK(near_zero(volume - net.state.supplied[0] - net.state.supplied[1], 1e-15));
      for (const double v : net.state.value) CHECK(v >= 0);
    }
  CHECK(most > 1e-3);
  // Head 6 overflows at the top, 1 m above which it stands; water leaves there, and none enters.
  CHECK(net.state.supplied[1] < 0);
}

TEST_CASE("water rises to the level of the head in a dry joint, and no farther") {
  Net net;
  net.flow.nodes = {{"low", 0, 0}, {"top", 4, -1}};
  FlowJoint rise = fissure(0, 1, 4, 3e-4, 3e-4, 40);
  rise.elevation = {0, 4};
  net.add(rise, false);
  for (int i = 0; i < 400; ++i) net.advance({2.5}, 5);
  CHECK(near(volume_of(net.flow, net.state), 2.5 * 3e-4, 0.03));
  for (int i = 0; i < 400; ++i) net.advance({1}, 5);
  CHECK(near(volume_of(net.flow, net.state), 1.0 * 3e-4, 0.05));
}

TEST_CASE("a front in a dry fissure advances with the root of time") {
  Net net;
  net.flow.nodes = {{"lake", 0, 0}, {"end", 0, -1}};
  net.add(fissure(0, 1, 2, 3e-4, 3e-4, 50), false);
  double clock = 0;
  for (const double dt : {0.01, 0.03})
    for (int i = 0; i < 100; ++i) {
      net.advance({2}, dt), clock += dt;
      const double front = std::sqrt(9e-8 * 2 * water_weight * clock / 6e-3);
      if (i > 20) CHECK(near(volume_of(net.flow, net.state) / 3e-4, front, 0.03));
    }
}

TEST_CASE("flow in a net at rest is 0") {
  Net net;
  net.flow.nodes = {{"a", 0, 0}, {"b", 1, -1}, {"c", 2, 1}};
  FlowJoint first = fissure(0, 1, 1, 2e-4, 2e-4, 5), second = fissure(1, 2, 1, 3e-4, 1e-4, 5);
  first.elevation = {0, 1}, second.elevation = {1, 2};
  net.add(first, true), net.add(second, true);
  for (int i = 0; i < 3; ++i) net.advance({3, 3}, 1e9);
  const FlowStep step = net.advance({3, 3}, 1);
  for (const double q : step.into) CHECK(near_zero(q, 1e-15));
  for (const double h : step.node_head) CHECK(near(h, 3, 1e-12));
}

}  // namespace trilith::testing
