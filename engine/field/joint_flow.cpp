#include "field/joint_flow.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace trilith {

bool JointFlow::has_bodies() const {
  return std::any_of(joints.begin(), joints.end(), [](const FlowJoint& j) { return j.has_bodies(); });
}

const FlowJoint* JointFlow::find(const std::string& name) const {
  for (const FlowJoint& j : joints)
    if (j.name == name) return &j;
  return nullptr;
}

int JointFlow::find_node(const std::string& name) const {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].name == name) return static_cast<int>(i);
  return -1;
}

Apertures own_apertures(const JointFlow& flow, const FieldState& state) {
  Apertures out(static_cast<std::size_t>(flow.cells()));
  for (const FlowJoint& j : flow.joints)
    for (int i = 0; i < j.cells; ++i) {
      const auto cell = static_cast<std::size_t>(j.first_cell + i);
      const double opened = j.compliance * j.weight * state.value[cell], n = j.cells;
      out[cell] = {j.aperture_at(i / n) + opened, j.aperture_at((i + 1) / n) + opened};
    }
  return out;
}

double volume_of(const JointFlow& flow, const FieldState& state) {
  const auto n = static_cast<std::size_t>(flow.cells());
  double sum = 0;
  for (std::size_t i = n; i < 2 * n && i < state.value.size(); ++i) sum += state.value[i];
  return sum;
}

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// A step whose set of full cells is not found is taken in halves, at most so many times.
constexpr int most_halvings = 10;

/// Share of the conductance of a point that is added to its capacity, so that a group of empty cells has a solution.
constexpr double regular_share = 1e-13;

/// Conductance of the part of a joint of length `length` with a linear aperture [m2/s].
double conductance_of(const FlowJoint& j, double length, double a0, double a1) {
  return j.width * j.weight * 2 * a0 * a0 * a1 * a1 / (12 * j.viscosity * length * (a0 + a1));
}

}  // namespace

struct FlowSolver::Equations {
  /// Condition of a cell or node in a step. Full: its head is unknown. Level: its head is its elevation, or given.
  /// Empty: its head is any below its elevation.
  enum class FlowStatus : std::uint8_t { full, level, empty };

  /// A cell or node of the equations.
  struct FlowPoint {
    FlowStatus status = FlowStatus::full;
    bool given = false;    ///< its head is given
    double elevation = 0;  ///< [m]
    double fixed = 0;      ///< head where `status` is level [m]
    double held = 0;       ///< water before the step [m3]
    double most = 0;       ///< water without pressure [m3]
    double capacity = 0;   ///< water for its pressure head [m2]
  };

  struct FlowLink {
    int a, b;
    double conductance;  ///< [m2/s]
  };

  std::vector<FlowPoint> points;  // cells, then nodes
  std::vector<FlowLink> links;
  std::vector<double> sum;     // [point] conductance of its links [m2/s]
  std::vector<double> inflow;  // [point] [m3/s]
  Eigen::VectorXd head;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
  Eigen::SparseMatrix<double> matrix;
  std::vector<std::array<int, 2>> pattern;  // pairs of points of `factors`

  void add_joint(const JointFlow& flow, const FlowJoint& j, const Apertures& apertures,
                 std::span<const double> expected, const FieldState& before);
  void add_node(const FlowNode& node, std::span<const double> given);
  void solve(double dt);
  void refine(const Eigen::VectorXd& right, const Eigen::VectorXd& own, double dt);
  int change_status(double dt);
  bool find_status(double dt, int& iterations);
  int halved = 0;  // times that the present step was halved
  void find_inflow();
};

void FlowSolver::Equations::add_joint(const JointFlow& flow, const FlowJoint& j, const Apertures& apertures,
                                      std::span<const double> expected, const FieldState& before) {
  const int cells = flow.cells();
  const double length = j.cell_length(), area = j.width * length;
  double last = 0;  // conductance of the second half of the cell before
  for (int i = 0; i < j.cells; ++i) {
    const int cell = j.first_cell + i;
    const auto at = static_cast<std::size_t>(cell);
    const auto [a0, a1] = apertures[at];
    const double middle = 0.5 * (a0 + a1);
    const double first = conductance_of(j, 0.5 * length, a0, middle);
    links.push_back({i == 0 ? cells + j.from : cell - 1, cell, i == 0 ? first : first * last / (first + last)});
    last = conductance_of(j, 0.5 * length, middle, a1);
    FlowPoint& p = points[at];
    p.elevation = p.fixed = j.elevation_at((i + 0.5) / j.cells);
    p.held = before.value[static_cast<std::size_t>(cells) + at];
    // Without pressure a fissure has its own aperture, and a joint the present one less its response to `expected`.
    const bool follows = j.has_bodies() && !expected.empty();
    const double response = !j.has_bodies() ? j.compliance : follows ? j.coupling : 0;
    p.most = area * (!j.has_bodies() ? j.aperture_at((i + 0.5) / j.cells)
                     : follows       ? middle - response * j.weight * expected[at]
                                     : middle);
    p.capacity = j.weight * area * (middle / j.bulk_modulus + response);
    const double least = 1e-6 * area * middle;
    p.most = std::max(p.most, least);
    p.status = before.value[at] > 0 || p.held >= p.most ? FlowStatus::full
               : p.held > 0                             ? FlowStatus::level
                                                        : FlowStatus::empty;
  }
  links.push_back({j.first_cell + j.cells - 1, cells + j.to, last});
}

/// A node at whose elevation the given head ends is open to the air: water leaves it, and none comes from it.
void FlowSolver::Equations::add_node(const FlowNode& node, std::span<const double> given) {
  FlowPoint p;
  p.elevation = p.fixed = node.elevation;
  if (node.surrounding >= 0) {
    const double h = given[static_cast<std::size_t>(node.surrounding)];
    p.status = FlowStatus::level;
    p.given = h > node.elevation;
    if (p.given)
      p.fixed = h;
    else
      p.most = endless;
  }
  points.push_back(p);
}

/// Solves for the heads with the present status of the points. A given head has a row of the identity, so that
/// the pattern remains the same.
void FlowSolver::Equations::solve(double dt) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::VectorXd right(n), diagonal(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const FlowPoint& p = points[static_cast<std::size_t>(i)];
    const double regular = regular_share * dt * sum[static_cast<std::size_t>(i)];
    if (p.status == FlowStatus::level) {
      diagonal[i] = 1, right[i] = p.fixed;
    } else if (p.status == FlowStatus::empty || p.most == 0) {
      diagonal[i] = regular, right[i] = regular * p.elevation + p.held;
    } else {
      diagonal[i] = p.capacity, right[i] = p.capacity * p.elevation + p.held - p.most;
    }
  }
  Eigen::VectorXd own = diagonal, given = right;  // without links and regular terms
  for (Eigen::Index i = 0; i < n; ++i) {
    const FlowPoint& p = points[static_cast<std::size_t>(i)];
    if (p.status != FlowStatus::level && (p.status == FlowStatus::empty || p.most == 0)) own[i] = 0, given[i] = p.held;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(links.size() + points.size());
  for (const FlowLink& l : links) {
    const double k = dt * l.conductance;
    const auto a = static_cast<std::size_t>(l.a), b = static_cast<std::size_t>(l.b);
    const bool fixed_a = points[a].status == FlowStatus::level, fixed_b = points[b].status == FlowStatus::level;
    if (!fixed_a) diagonal[l.a] += k;
    if (!fixed_b) diagonal[l.b] += k;
    if (!fixed_a && fixed_b) right[l.a] += k * points[b].fixed;
    if (!fixed_b && fixed_a) right[l.b] += k * points[a].fixed;
    entries.emplace_back(std::max(l.a, l.b), std::min(l.a, l.b), fixed_a || fixed_b ? 0 : -k);
  }
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, diagonal[i]);
  matrix.resize(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors.factorize(matrix);
  if (factors.info() != Eigen::Success)
    throw InputError(
        "the equations of the seepage have no solution: some joint is shut off from every head and has no capacity");
  head = factors.solve(right);
  refine(given, own, dt);
}

/// Corrects the heads by the residual of the balances, whose flows are then accurate to rounding.
void FlowSolver::Equations::refine(const Eigen::VectorXd& right, const Eigen::VectorXd& own, double dt) {
  find_inflow();
  Eigen::VectorXd left = right - own.cwiseProduct(head);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].status != FlowStatus::level) left[static_cast<Eigen::Index>(i)] += dt * inflow[i];
  head += factors.solve(left);
}

void FlowSolver::Equations::find_inflow() {
  inflow.assign(points.size(), 0);
  for (const FlowLink& l : links) {
    const double q = l.conductance * (head[l.b] - head[l.a]);
    inflow[static_cast<std::size_t>(l.a)] += q, inflow[static_cast<std::size_t>(l.b)] -= q;
  }
}

/// Changes the status of the points whose conditions are violated beyond rounding; returns their number.
int FlowSolver::Equations::change_status(double dt) {
  find_inflow();
  int count = 0;
  const auto change = [&](FlowPoint& p, FlowStatus to) { p.status = to, ++count; };
  for (std::size_t i = 0; i < points.size(); ++i) {
    FlowPoint& p = points[i];
    if (p.given || p.most == 0) continue;
    const double size = 1 + std::abs(p.elevation), rise = head[static_cast<Eigen::Index>(i)] - p.elevation;
    const double slack = 1e-9 * size;
    if (p.status == FlowStatus::level) {
      const double water = p.held + dt * inflow[i];
      const double least = 1e-12 * (p.most < endless ? p.most : 0) + 1e-14 * dt * sum[i] * size;
      if (water > p.most + least)
        change(p, FlowStatus::full);
      else if (water < -least)
        change(p, FlowStatus::empty);
    } else if (p.status == FlowStatus::full ? rise < -slack : rise > slack) {
      change(p, FlowStatus::level);
    }
  }
  return count;
}

/// Solves with the right status of all points. The changes may cycle, then the search restarts with all points full.
bool FlowSolver::Equations::find_status(double dt, int& iterations) {
  const int most = 40 + 2 * static_cast<int>(points.size());
  for (const bool all_full : {false, true}) {
    for (FlowPoint& p : points)
      if (all_full && !p.given && p.most < endless) p.status = FlowStatus::full;
    for (int i = 0; i < most; ++i) {
      ++iterations;
      solve(dt);
      if (change_status(dt) == 0) return true;
    }
  }
  return false;
}

FlowSolver::FlowSolver() : equations_(std::make_unique<Equations>()) {}
FlowSolver::~FlowSolver() = default;

FlowStep FlowSolver::advance(const JointFlow& flow, const Apertures& apertures, std::span<const double> head,
                             std::span<const double> expected, double dt, const FieldState& before, FieldState& after) {
  Equations& e = *equations_;
  const auto cells = static_cast<std::size_t>(flow.cells());
  e.points.assign(cells, {}), e.links.clear();
  for (const FlowJoint& j : flow.joints) e.add_joint(flow, j, apertures, expected, before);
  for (const FlowNode& node : flow.nodes) e.add_node(node, head);
  std::vector<std::array<int, 2>> pattern;
  for (const Equations::FlowLink& l : e.links) pattern.push_back({l.a, l.b});
  e.sum.assign(e.points.size(), 0);
  for (const Equations::FlowLink& l : e.links)
    e.sum[static_cast<std::size_t>(l.a)] += l.conductance, e.sum[static_cast<std::size_t>(l.b)] += l.conductance;
  if (pattern != e.pattern) {
    e.pattern = std::move(pattern);
    std::vector<Eigen::Triplet<double>> entries;
    for (const Equations::FlowLink& l : e.links) entries.emplace_back(std::max(l.a, l.b), std::min(l.a, l.b), 1);
    for (int i = 0; i < static_cast<int>(e.points.size()); ++i) entries.emplace_back(i, i, 1);
    e.matrix.resize(static_cast<Eigen::Index>(e.points.size()), static_cast<Eigen::Index>(e.points.size()));
    e.matrix.setFromTriplets(entries.begin(), entries.end());
    e.factors.analyzePattern(e.matrix);
  }
  FlowStep out;
  if (!e.find_status(dt, out.iterations)) {
    if (std::exchange(e.halved, e.halved + 1) >= most_halvings) {
      e.halved = 0;
      throw InputError("the seepage finds no set of full joints in this step; give a shorter step");
    }
    FieldState half;
    const FlowStep first = advance(flow, apertures, head, expected, 0.5 * dt, before, half);
    FlowStep second = advance(flow, apertures, head, expected, 0.5 * dt, half, after);
    --e.halved;
    for (std::size_t i = 0; i < first.into.size(); ++i) second.into[i] += first.into[i];
    second.iterations += first.iterations + out.iterations;
    return second;
  }
  after = before;
  for (std::size_t i = 0; i < cells; ++i) {
    const Equations::FlowPoint& p = e.points[i];
    const double rise = e.head[static_cast<Eigen::Index>(i)] - p.elevation;
    after.value[i] = p.status == Equations::FlowStatus::full ? std::max(0.0, rise) : 0;
    const bool full = p.status == Equations::FlowStatus::full;
    after.value[cells + i] = full ? p.most + p.capacity * rise : std::max(0.0, p.held + dt * e.inflow[i]);
  }
  for (std::size_t i = 0; i < flow.nodes.size(); ++i) {
    out.node_head.push_back(e.head[static_cast<Eigen::Index>(cells + i)]);
    out.into.push_back(-dt * e.inflow[cells + i]);
    const int s = flow.nodes[i].surrounding;
    if (s >= 0) after.supplied[static_cast<std::size_t>(s)] += out.into.back();
  }
  after.clock = before.clock + dt;
  return out;
}

}  // namespace trilith
