// Single elements: rigid rotation, patch tests, bending, convergence rates.
#include "near.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

const Polygon distorted{{0.1, -0.05}, {1.0, 0.1}, {1.2, 0.9}, {-0.1, 0.7}};

/// Rotates every node about `about` by `angle` [rad], from the start positions.
void turn_all(const Model<2>& model, State<2>& state, const Vec2& about, double angle) {
  const Turn turn(angle);
  for (int n = 0; n < model.nodes(); ++n) state.position[n] = about + turn.apply(Vec2(model.start_position[n] - about));
}

double largest(const std::vector<Vec2>& forces) {
  double most = 0;
  for (const Vec2& f : forces) most = std::max(most, f.norm());
  return most;
}

TEST_CASE("B1: a rigid rotation of an unstressed element by any angle causes no stress, no force and no energy") {
  const double young = 1e7;
  for (const ElementForm form : {ElementForm::assumed, ElementForm::plain})
    for (const bool triangles : {false, true}) {
      BodySpec spec = grid_body("b", distorted, "", 1, 1);
      if (triangles)
        spec.mesh = Mesh{distorted, {{0, 1, 2, -1}, {0, 2, 3, -1}}}, spec.kind = BodyKind::mesh, spec.outline = {};
      const Model<2> model = alone(elastic("m", 1000, young, 0.3, Plane::stress, form), spec);
      State<2> state = initial_state(model);
      Work<2> work;
      for (int degrees = 0; degrees <= 720; ++degrees) {
        turn_all(model, state, {3, -2}, degrees * degree);
        internal_forces(model, state, work);
        CHECK(largest(work.element_force) < 1e-9 * young);
        CHECK(work.element_stored < 1e-18 * young);
        for (int e = 0; e < static_cast<int>(model.elements.size()); ++e) {
          const ElementStress s = element_stress(model, state, e);
          for (int p = 0; p < s.points; ++p) CHECK(s.at_point[p].in_plane().cwiseAbs().maxCoeff() < 1e-9 * young);
        }
      }
    }
}

TEST_CASE("element forces are the gradient of the stored energy, with no resultant and no moment") {
  const Model<2> model = alone(elastic("m", 1000, 1e6, 0.3), grid_body("b", distorted, "", 1, 1));
  State<2> state = initial_state(model);
  Work<2> work;
  turn_all(model, state, {0, 0}, 1.1);
  const std::array<Vec2, 4> bend{Vec2(.05, -.02), Vec2(.1, .07), Vec2(-.06, .03), Vec2(.02, -.08)};
  for (int n = 0; n < 4; ++n) state.position[n] += bend[n];
  internal_forces(model, state, work);
  const std::vector<Vec2> force = work.element_force;
  Vec2 sum = Vec2::Zero();
  double moment = 0;
  for (int n = 0; n < 4; ++n) {
    sum += force[n];
    moment += cross(state.position[n], force[n]);
    for (const int k : {0, 1}) {
      const double h = 1e-6;
      std::array<double, 2> stored{};
      for (const int side : {0, 1}) {
        state.position[n][k] += side == 0 ? h : -2 * h;
        internal_forces(model, state, work);
        stored[side] = work.element_stored;
      }
      state.position[n][k] += h;
      CHECK(near(-(stored[0] - stored[1]) / (2 * h), force[n][k], 1e-6));
    }
  }
  CHECK(sum.norm() < 1e-9 * largest(force));
  CHECK(std::abs(moment) < 1e-9 * largest(force));
}

TEST_CASE("B3: the patch of distorted elements carries a constant stress") {
  Mesh mesh;
  mesh.node = {{0, 0}, {.24, 0}, {.24, .12}, {0, .12}, {.04, .02}, {.18, .03}, {.16, .08}, {.08, .08}};
  SUBCASE("of quadrilaterals") {
    mesh.element = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  }
  SUBCASE("of both kinds") {
    mesh.element = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, -1}, {4, 6, 7, -1}};
  }
  for (const ElementForm form : {ElementForm::assumed, ElementForm::plain}) {
    BodySpec spec;
    spec.name = "patch", spec.kind = BodyKind::mesh, spec.mesh = mesh, spec.floating = true;
    const Model<2> model = alone(elastic("m", 1, 1e6, 0.25, Plane::stress, form), spec);
    State<2> state = initial_state(model);
    for (Vec2& x : state.position) x += 1e-3 * Vec2(x.x() + 0.5 * x.y(), x.y() + 0.5 * x.x());
    Work<2> work;
    internal_forces(model, state, work);
    for (const Vec2& inner : {Vec2(.04, .02), Vec2(.18, .03), Vec2(.16, .08), Vec2(.08, .08)})
      CHECK(work.element_force[node_at(model, inner)].norm() < 1e-6 * 1333 * 0.05);
    for (int e = 0; e < static_cast<int>(model.elements.size()); ++e) {
      const ElementStress s = element_stress(model, state, e);
      for (int p = 0; p < s.points; ++p) {
        CHECK(near(s.at_point[p].xx, 4000.0 / 3, 1e-6));
        CHECK(near(s.at_point[p].yy, 4000.0 / 3, 1e-6));
        CHECK(near(s.at_point[p].xy, 400, 1e-6));
      }
    }
  }
}

/// Tilt of the upright edges of a row: none, the same for all (parallelograms), alternating (trapezoids).
enum class Skew { none, alike, in_turn };

/// Tip deflection of a cantilever of one row of `count` elements of length over height `aspect`, under a tip moment or
/// load, over the deflection of a Timoshenko beam [1].
double row_deflection(int count, double aspect, Skew skew, bool moment, ElementForm form, int rows = 1) {
  const double height = 1, young = 1e6, length = count * aspect * height;
  Mesh mesh = grid_mesh({Vec2(0, 0), Vec2(length, 0), Vec2(length, height), Vec2(0, height)}, count, rows);
  for (Vec2& x : mesh.node) {
    const auto column = static_cast<int>(std::lround(x.x() / (aspect * height)));
    const double sign = skew == Skew::none || column == 0 || column == count ? 0
                        : skew == Skew::alike || column % 2 == 0             ? 1
                                                                             : -1;
    x.x() += 0.25 * sign * (x.y() - 0.5 * height);
  }
  BodySpec spec;
  spec.name = "beam", spec.kind = BodyKind::mesh, spec.mesh = mesh;
  // The root's section may change its shape: all its nodes are fixed in x, one is fixed in y.
  spec.supports = {{{0, 0}, {0, height}, {Support::fixed, Support::free}},
                   {{0, 0}, {0, 0}, {Support::fixed, Support::fixed}}};
  const Model<2> model = alone(elastic("m", 1, young, 0, Plane::stress, form), spec);
  std::vector<Vec2> load(static_cast<std::size_t>(model.nodes()), Vec2::Zero());
  for (int j = 0; j <= rows; ++j) {
    const double y = height * j / rows, share = (j == 0 || j == rows ? 0.5 : 1.0) / rows;
    const int n = node_at(model, {length, y});
    if (moment)
      load[n].x() = j == 0 ? -1 / height : j == rows ? 1 / height : 0;
    else
      load[n].y() = share;
  }
  const std::vector<Vec2> u = solve_small(model, load);
  const double tip = u[node_at(model, {length, 0})].y(), inertia = height * height * height / 12;
  const double beam = moment ? -length * length / (2 * young * inertia)
                             : length * length * length / (3 * young * inertia) + 1.2 * length / (0.5 * young * height);
  return tip / beam;
}

TEST_CASE("one row of elements bends as a beam within 5 %, and the plain form does not") {
  for (const bool moment : {true, false})
    for (const double aspect : {1.0, 2.0, 5.0})
      for (const Skew skew : {Skew::none, Skew::alike, Skew::in_turn}) {
        const double assumed = row_deflection(16, aspect, skew, moment, ElementForm::assumed),
                     plain = row_deflection(16, aspect, skew, moment, ElementForm::plain);
        const std::string shape = skew == Skew::none    ? "rectangles"
                                  : skew == Skew::alike ? "parallelograms"
                                                        : "trapezoids";
        MESSAGE(std::string(moment ? "moment" : "load"), ", aspect ", aspect, ", ", shape, ": assumed ", assumed,
                ", plain ", plain);
        // Trapezoids that pass the patch test lock whatever their interpolation (MacNeal, "A theorem regarding the
        // locking of tapered four-noded membrane elements", Int. J. Numer. Meth. Engng 24, 1987): reported, not
        // checked. With parallelograms, the two elements at the upright ends of a row are trapezoids.
        if (skew == Skew::none) CHECK(near(assumed, 1, 0.05));
        if (skew == Skew::alike) CHECK(near(assumed, 1, 0.05));
        CHECK(plain < 0.75);
      }
}

/// Half of a beam of 8 m by 1 m under a uniform load, with meshes of 4 n by n elements. Symmetry at the middle and the
/// load's resultant as a parabolic shear at the end keep the stress free of singularities. Deflection of the end, and
/// work.
struct Solved {
  double tip, energy;
};
Solved half_beam(int n, bool triangles) {
  const double young = 1e6, poisson = 0.3, length = 4, height = 1;
  Mesh mesh = grid_mesh({Vec2(0, 0), Vec2(length, 0), Vec2(length, height), Vec2(0, height)}, 4 * n, n);
  if (triangles) {
    Mesh halves{mesh.node, {}};
    for (const auto& e : mesh.element)
      halves.element.push_back({e[0], e[1], e[2], -1}), halves.element.push_back({e[0], e[2], e[3], -1});
    mesh = halves;
  }
  BodySpec spec;
  spec.name = "beam", spec.kind = BodyKind::mesh, spec.mesh = mesh;
  spec.supports = {{{0, 0}, {0, height}, {Support::fixed, Support::free}},
                   {{0, 0}, {0, 0}, {Support::fixed, Support::fixed}}};
  const Model<2> model = alone(elastic("m", 1, young, poisson), spec);
  std::vector<Vec2> load(static_cast<std::size_t>(model.nodes()), Vec2::Zero());
  const double h = height / n;
  for (int e = 0; e < 4 * n; ++e)
    for (const double x : {e * h, (e + 1) * h}) load[node_at(model, {x, height})].y() -= 0.5 * h;
  for (int e = 0; e < n; ++e)  // consistent with 6 y (1 - y), two Gauss points per edge
    for (const double s : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)}) {
      const double y = (e + s) * h, q = 0.5 * h * 6 * y * (1 - y) * length;
      load[node_at(model, {length, e * h})].y() += (1 - s) * q;
      load[node_at(model, {length, (e + 1) * h})].y() += s * q;
    }
  // The two resultants cancel, so the node fixed in y carries no force.
  double sum = 0;
  for (const Vec2& f : load) sum += f.y();
  CHECK(std::abs(sum) < 1e-9);
  const std::vector<Vec2> u = solve_small(model, load);
  double work = 0;
  for (std::size_t i = 0; i < u.size(); ++i) work += 0.5 * u[i].dot(load[i]);
  return {u[node_at(model, {length, 0})].y(), work};
}

TEST_CASE("displacement and energy of a mesh converge with about the square of its size") {
  for (const bool triangles : {false, true}) {
    std::vector<Solved> s;
    for (const int n : {1, 2, 4, 8}) s.push_back(half_beam(n, triangles));
    // Richardson's convergence rate from three meshes; triangle meshes are still far from their limit.
    const double least = triangles ? 1.1 : 1.6;
    for (std::size_t i = 0; i + 2 < s.size(); ++i) {
      const double tip = std::log2((s[i + 1].tip - s[i].tip) / (s[i + 2].tip - s[i + 1].tip));
      const double energy = std::log2((s[i + 1].energy - s[i].energy) / (s[i + 2].energy - s[i + 1].energy));
      MESSAGE(std::string(triangles ? "triangles" : "quadrilaterals"), " ", 1 << i, " to ", 4 << i,
              " rows: rate of the tip ", tip, ", of the energy ", energy, ", tip ", s[i + 2].tip);
      if (i == 1) CHECK(tip > least);
      if (i == 1) CHECK(tip < 2.4);
      if (i == 1) CHECK(energy > least);
      if (i == 1) CHECK(energy < 2.4);
    }
  }
}

}  // namespace
}  // namespace trilith::testing
