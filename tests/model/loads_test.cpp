// Places, faces and resultants of loads; rejected input.
#include "model/loads.hpp"

#include <random>

#include "base/error.hpp"
#include "load/ramp.hpp"
#include "model/io/fingerprint.hpp"
#include "model/pushes.hpp"
#include "near.hpp"
#include "physics/space/solids.hpp"

namespace trilith::testing {
namespace {

/// One free body without weight: rigid, one quad, or a mesh.
Model<2> lone(const Polygon& outline, int divisions, double thickness = 1) {
  BodySpec spec = grid_body("b", outline, "soft", std::max(1, divisions), std::max(1, divisions));
  if (divisions == 0) spec.kind = BodyKind::rigid;
  spec.thickness = thickness;
  return alone(elastic("soft", 2000, 1e9, 0.2), spec);
}

struct Resultant {
  Vec2 force = Vec2::Zero();
  double moment = 0;  // about the origin
};

Resultant pushed(const Model<2>& model, State<2> state) {
  Work<2> work;
  evaluate(model, state, work, 0);
  Resultant r;
  for (int n = 0; n < model.nodes(); ++n) {
    r.force += work.load[n];
    r.moment += cross(state.position[n], work.load[n]) + work.load_moment[n];
  }
  return r;
}

template <class F>
std::string message_of(F&& f) {
  try {
    f();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

const Polygon crooked{{0, 0}, {1.1, 0.1}, {0.9, 0.7}, {0.1, 0.6}};

TEST_CASE("pressure that follows a closed outline has no resultant, whatever the body's kind and pose") {
  std::mt19937_64 bits(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const int divisions : {0, 1, 3}) {
    Model<2> model = lone(crooked, divisions);
    PressureSpec spec;
    spec.name = "water", spec.value = 3e5;
    loads_of<FaceLoad<2>>(model) = make_pressure(model, 0, outline_faces(model, 0), spec);
    for (int round = 0; round < 20; ++round) {
      State<2> state = initial_state(model);
      for (Vec2& p : state.position) p += Vec2(5 * (divisions == 0) + 0.05 * any(bits), 0.05 * any(bits));
      if (divisions == 0) state.rotation[0] = 10 * any(bits);
      const Resultant r = pushed(model, state);
      CHECK(r.force.norm() < 1e-12 * 3e5);
      CHECK(std::abs(r.moment) < 1e-11 * 3e5);
    }
  }
}

TEST_CASE("pressure on a part of the outline is its size times its length, at its middle") {
  for (const int divisions : {0, 1, 4})
    for (const bool follows : {true, false}) {
      Model<2> model = lone(rectangle({0, 0}, {2, 1}), divisions, 0.3);
      PressureSpec spec;
      spec.name = "p", spec.value = 1e4, spec.follows = follows;
      loads_of<FaceLoad<2>>(model) = make_pressure(model, 0, faces_between(model, 0, {1.7, 1}, {0.45, 1}, "p"), spec);
      const double depth = divisions == 0 ? 1 : 0.3;
      const Resultant r = pushed(model, initial_state(model));
      CHECK(std::abs(r.force.x()) < 1e-9);
      CHECK(near(r.force.y(), -1e4 * 1.25 * depth, 1e-12));
      CHECK(near(r.moment / r.force.y(), 0.5 * (1.7 + 0.45), 1e-12));
      // The rest of the outline, over three corners, completes it.
      spec.name = "rest";
      for (FaceLoad<2>& f : make_pressure(model, 0, faces_between(model, 0, {0.45, 1}, {1.7, 1}, "p"), spec))
        loads_of<FaceLoad<2>>(model).push_back(std::move(f));
      CHECK(pushed(model, initial_state(model)).force.norm() < 1e-9);
    }
}

TEST_CASE("pressure that does not follow keeps its force, along a direction too, when the body turns") {
  Model<2> model = lone(rectangle({0, 0}, {2, 1}), 0);
  PressureSpec spec;
  spec.name = "p", spec.value = 1e4, spec.follows = false, spec.direction = Vec2(3, -4);
  loads_of<FaceLoad<2>>(model) = make_pressure(model, 0, faces_towards(model, 0, {0, 1}), spec);
  State<2> state = initial_state(model);
  for (const double turn : {0.0, 1.0, 3.0}) {
    state.rotation[0] = turn;
    CHECK((pushed(model, state).force - Vec2(1.2e4, -1.6e4)).norm() < 1e-8);
  }
  PressureSpec follows = spec;
  follows.follows = true, follows.direction.reset();
  loads_of<FaceLoad<2>>(model) = make_pressure(model, 0, faces_towards(model, 0, {0, 1}), follows);
  state.rotation[0] = 0.5 * M_PI;
  CHECK((pushed(model, state).force - Vec2(2e4, 0)).norm() < 1e-8);
}

TEST_CASE("a point load keeps its direction or rotates with the body, and its moment follows its point") {
  for (const int divisions : {0, 1, 3})
    for (const bool follows : {false, true}) {
      Model<2> model = lone(rectangle({0, 0}, {2, 1}), divisions);
      PointLoadSpec spec;
      spec.name = "P", spec.at = Vec2(1.5, 0.8), spec.force = Vec2(300, -400), spec.moment = 50, spec.follows = follows;
      loads_of<PointLoad<2>>(model) = make_point_load(model, 0, spec);
      State<2> state = initial_state(model);
      const double angle = 0.7;
      const Turn turn(angle);
      for (Vec2& p : state.position) p = Vec2(3, 1) + turn.apply(p);
      if (divisions == 0) state.rotation[0] = angle;
      const Resultant r = pushed(model, state);
      const Vec2 force = follows ? turn.apply(spec.force) : spec.force, at = Vec2(3, 1) + turn.apply(*spec.at);
      CAPTURE(divisions);
      CAPTURE(follows);
      CHECK((r.force - force).norm() < 1e-9);
      CHECK(near(r.moment, cross(at, force) + 50, 1e-12));
    }
  // Force and moment follow the load curve together.
  for (const bool follows : {false, true}) {
    Model<2> model = lone(rectangle({0, 0}, {2, 1}), 0);
    PointLoadSpec spec;
    spec.name = "P", spec.at = Vec2(1.5, 0.8), spec.force = Vec2(300, -400), spec.moment = 50, spec.follows = follows;
    spec.curve = ramp_curve(0, 0, 1, 2, false);
    loads_of<PointLoad<2>>(model) = make_point_load(model, 0, spec);
    State<2> state = initial_state(model);
    state.time = 0.5;
    const Resultant r = pushed(model, state);
    CHECK((r.force - 0.25 * spec.force).norm() < 1e-9);
    CHECK(near(r.moment, 0.25 * (cross(*spec.at, spec.force) + 50), 1e-12));
  }
  // Without a point: at the centroid, distributed like the mass.
  for (const int divisions : {0, 3}) {
    Model<2> model = lone(crooked, divisions);
    PointLoadSpec spec;
    spec.name = "P", spec.force = Vec2(10, 20);
    loads_of<PointLoad<2>>(model) = make_point_load(model, 0, spec);
    const Resultant r = pushed(model, initial_state(model));
    CHECK((r.force - spec.force).norm() < 1e-12);
    CHECK(near(r.moment, cross(body_start(model, 0), spec.force), 1e-12));
  }
}

TEST_CASE("points of a body have names") {
  const Model<2> model = lone(rectangle({1, 2}, {4, 3}), 0);
  const auto place = [&](const char* name) { return named_place(model, 0, name).value_or(Vec2(-9, -9)); };
  CHECK((place("centroid") - Vec2(2.5, 2.5)).norm() < 1e-12);
  CHECK((place("top") - Vec2(2.5, 3)).norm() < 1e-12);
  CHECK((place("left") - Vec2(1, 2.5)).norm() < 1e-12);
  CHECK((place("bottom right") - Vec2(4, 2)).norm() < 1e-12);
  CHECK((place("top left") - Vec2(1, 3)).norm() < 1e-12);
  CHECK_FALSE(named_place(model, 0, "topp").has_value());
}

TEST_CASE("invalid loads are rejected with the load, the body and the allowed values") {
  const Model<2> mesh = lone(crooked, 2);
  PointLoadSpec point;
  point.name = "P", point.force = Vec2(1, 0), point.moment = 2;
  CHECK(message_of([&] { make_point_load(mesh, 0, point); }) ==
        "load 'P' on 'b': the body deforms; give 'at', the point where the moment acts");
  point.at = Vec2(5, 5);
  CHECK(message_of([&] { make_point_load(mesh, 0, point); }).find("load 'P' on 'b': the point (5, 5) is") == 0);
  point.force.x() = NAN;
  CHECK(message_of([&] { make_point_load(mesh, 0, point); }).find("load 'P' on 'b': force along x") == 0);
  PressureSpec pressure;
  pressure.name = "p", pressure.value = 1, pressure.direction = Vec2(1, 0);
  CHECK(message_of([&] { make_pressure(mesh, 0, outline_faces(mesh, 0), pressure); }).find("does not follow") !=
        std::string::npos);
  CHECK(message_of([&] {
          faces_between(mesh, 0, {0.5, 0.35}, {1, 0.4}, "pressure 'p'");
        }).find("pressure 'p': the point (0.5, 0.35) is") == 0);
  CHECK(message_of([&] {
          faces_between(mesh, 0, {0, 0}, {0, 0}, "pressure 'p'");
        }).find("are the same point") != std::string::npos);
}

TEST_CASE("the fingerprint depends on every number of a load and of a push") {
  Model<2> model = lone(rectangle({0, 0}, {2, 1}), 0);
  const Fingerprint bare = model_fingerprint(model);
  PointLoadSpec point;
  point.name = "P", point.at = Vec2(1.5, 0.8), point.force = Vec2(1, 2), point.curve = ramp_curve(0, 0, 1, 2, true);
  loads_of<PointLoad<2>>(model) = make_point_load(model, 0, point);
  PressureSpec pressure;
  pressure.name = "p", pressure.value = 1e4;
  loads_of<FaceLoad<2>>(model) = make_pressure(model, 0, faces_towards(model, 0, {0, 1}), pressure);
  add_push(model, initial_state(model), "push", push_rows(model, {0}, {}, PushPattern::mass, Vec2::UnitX()),
           Vec2::UnitX(), std::make_shared<GroundMotion>(even_motion(0.1, 0.01)));
  const Fingerprint print = model_fingerprint(model);
  CHECK(print.structure == bare.structure);
  CHECK(print.conditions != bare.conditions);
  const auto differs = [&](auto&& change) {
    Model<2> other = model;
    change(other);
    return model_fingerprint(other).conditions != print.conditions;
  };
  CHECK_FALSE(differs([](Model<2>&) {}));
  CHECK(differs([](Model<2>& m) { loads_of<PointLoad<2>>(m)[0].force.x() += 1e-12; }));
  CHECK(differs([](Model<2>& m) { loads_of<PointLoad<2>>(m)[0].moment = 1; }));
  CHECK(differs([](Model<2>& m) { loads_of<PointLoad<2>>(m)[0].follows = true; }));
  CHECK(differs([](Model<2>& m) { loads_of<PointLoad<2>>(m)[0].curve.time[1] += 1e-9; }));
  CHECK(differs([](Model<2>& m) { loads_of<PointLoad<2>>(m)[0].curve.smooth = false; }));
  CHECK(differs([](Model<2>& m) { loads_of<FaceLoad<2>>(m)[0].pressure *= 1.001; }));
  CHECK(differs([](Model<2>& m) { loads_of<FaceLoad<2>>(m)[0].share = {0.4, 0.6}; }));
  CHECK(differs([](Model<2>& m) { m.pushes[0].rows[0].weight = 0.9; }));
  CHECK(differs([](Model<2>& m) { m.pushes[0].rows[0].turn = 1; }));
  CHECK(differs([](Model<2>& m) { m.pushes[0].origin += 1e-9; }));
}

TEST_CASE("pushes share bodies by mass, evenly or by mass times height, and no node is pushed twice") {
  ModelBuilder builder;
  builder.add_material({"stone", 2000});
  for (int i = 0; i < 3; ++i) {
    BodySpec spec;
    spec.name = "b" + std::to_string(i), spec.outline = rectangle({0, 2.0 * i}, {1.0 + i, 2.0 * i + 1});
    spec.material = "stone", spec.floating = true;
    builder.add_body(spec);
  }
  Model<2> model = builder.build();
  const auto weights = [&](PushPattern pattern) {
    std::vector<double> w;
    for (const PushRow<2>& r : push_rows(model, {0, 1, 2}, {}, pattern, Vec2::UnitX())) w.push_back(r.weight);
    return w;
  };
  CHECK(near(weights(PushPattern::uniform)[1], 1.0 / 3, 1e-12));
  CHECK(near(weights(PushPattern::mass)[2], 3.0 / 6, 1e-12));
  CHECK(near(weights(PushPattern::triangle)[1], 2 * 2.5 / (0.5 + 5 + 13.5), 1e-12));
  const auto motion = std::make_shared<GroundMotion>(even_motion(0.1, 0.01));
  const auto rows = push_rows(model, {0, 1}, {}, PushPattern::mass, Vec2::UnitX());
  add_push(model, initial_state(model), "one", rows, Vec2::UnitX(), motion);
  CHECK(message_of([&] { add_push(model, initial_state(model), "one", rows, Vec2::UnitX(), motion); }) ==
        "push: push 'one' exists already; release it, or give another name");
  CHECK(message_of([&] { add_push(model, initial_state(model), "two", rows, Vec2::UnitX(), motion); }) ==
        "push: body 'b0' is pushed already by 'one'; release that push first");
  set_support(model, 2, 0, Support::fixed);
  CHECK(message_of([&] {
          push_rows(model, {2}, {}, PushPattern::mass, Vec2::UnitX());
        }).find("body 'b2' is held or driven in the direction") != std::string::npos);
  CHECK(push_rows(model, {2}, {}, PushPattern::mass, Vec2::UnitY()).size() == 1);
}

}  // namespace
}  // namespace trilith::testing
