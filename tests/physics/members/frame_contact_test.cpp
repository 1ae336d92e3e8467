// Frames in contact: a beam on a bed, on piers, against another beam; moving supports; conserved quantities.
#include "model/check/energy_check.hpp"
#include "model/contact/skin_places.hpp"
#include "model/pose.hpp"
#include "near.hpp"
#include "physics/members/frames.hpp"

namespace trilith::testing {
namespace {

/// A scene without gravity.
Scene weightless(const ContactLaw& law) {
  Scene scene(law);
  scene.set_gravity({0, 0});
  return scene;
}

TEST_CASE("F13: a loaded beam lifts off a bed without tension at the place of the closed form") {
  // Bed of 5e7 N/m per m under a beam 0.3 m wide: the model is 0.3 m thick, Kn = 1.6667e8 Pa/m.
  for (const double bond : {0.0, 1e12}) {
    const ContactLaw law = bond > 0 ? ContactLaw(Bonded{5e7 / 0.3, 1e7, 0.0, 0, bond, bond})
                                    : ContactLaw(Frictional{5e7 / 0.3, 1e7, 0.0, 0});
    Scene scene = weightless(law);
    scene.builder.thickness = 0.3;
    scene.builder.add_material(elastic_material("concrete", 2400, 30e9));
    scene.fixed("bed", box(-11, -1, 11, 0));
    BodySpec spec = beam_body("beam", {-10, 0.15}, {10, 0.15}, rectangle_section(0.3, 0.3), "concrete", 80);
    spec.supports = {{{-10, 0.15}, {-10, 0.15}, {Support::fixed, Support::free}}};
    scene.builder.add_body(spec);
    Model<2> model = scene.builder.build();
    add_load(model, "beam", {0, 0.15}, {0, -100e3}, 0, {{0, 0.2}, {0, 1}, true});
    Simulation<2> sim(model);
    const StageReport report = settle(sim, 20, 1e-7);
    CHECK(report.end == StageEnd::rest);
    const Body& beam = model.bodies[1];
    double deepest = 0, touching = 0, largest = 0;
    for (int n = beam.first_node; n < beam.first_node + beam.nodes; ++n)
      deepest = std::max(deepest, model.start_position[n].y() - sim.state().position[n].y());
    std::vector<Vec2> underside;  // of the right half, starting at the middle
    for (int s = beam.first_skin; s < beam.first_skin + beam.skins; ++s)
      if (const Vec2 start = skin_start(model, s); start.y() < 0.01 && start.x() >= 0)
        underside.push_back(skin_now(model, sim.state(), s));
    std::sort(underside.begin(), underside.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    for (std::size_t i = 1; i < underside.size() && touching == 0; ++i)
      if (const Vec2& p = underside[i - 1], &q = underside[i]; p.y() < 0 && q.y() >= 0)
        touching = p.x() + (q.x() - p.x()) * -p.y() / (q.y() - p.y());
    for (const SectionForces& f : member_forces(model, sim.state(), 0)) largest = std::max(largest, f.moment);
    CHECK(near(deepest, bond > 0 ? .88638e-3 : .96645e-3, 0.01));
    CHECK(near(largest, bond > 0 ? 28.205e3 : 30.752e3, 0.01));
    if (bond == 0) CHECK(near(touching, 1.77214, 0.03));
  }
}

TEST_CASE("F12: of two bars that collide end to end the short one stops and the long one keeps vibrating") {
  Scene scene = weightless(Frictional{3e14, 0, 0, 0});
  scene.builder.add_material(elastic_material("concrete", 2400, 30e9));
  const Section section = rectangle_section(1, 0.2);
  BodySpec hits = beam_body("short", {-5, 0}, {0, 0}, section, "concrete", 100),
           rests = beam_body("long", {0, 0}, {10, 0}, section, "concrete", 200);
  hits.velocity = {1, 0};
  scene.builder.add_body(hits);
  scene.builder.add_body(rests);
  Simulation<2> sim = scene.start();
  double first = -1, last = -1;
  const auto mean = [&](const char* name) {
    return body_pose(sim.model(), sim.state(), sim.model().find_body(name)).velocity.x();
  };
  run_for(sim, 5e-3, 0, each_step([&](const Instant<2>& now) {
            bool touch = false;
            for (const ContactMemory& m : now.work.contacts.memory) touch = touch || (m.state & contact_touching) != 0;
            if (!touch) return;
            if (first < 0) first = now.state.time;
            last = now.state.time;
          }));
  CHECK(near(last - first, 2.8284e-3, 0.03));
  CHECK(near_zero(mean("short"), 0.03 * 0.5));
  CHECK(near(mean("long"), 0.5, 0.03));
}

/// A beam lies on the inner edges of two blocks: deflection of its middle relative to its ends [m].
double sag_on_piers(int divisions) {
  Scene scene(Frictional{1e12, 4e11, 0, 0});
  scene.builder.add_material(elastic_material("concrete", 2400, 30e9));
  scene.fixed("left", box(-2, -1, 0, 0));
  scene.fixed("right", box(8, -1, 10, 0));
  BodySpec spec = beam_body("beam", {-0.25, 0.25}, {8.25, 0.25}, rectangle_section(0.3, 0.5), "concrete", divisions);
  spec.supports = {{{4, 0.25}, {4, 0.25}, {Support::fixed, Support::free}}};
  scene.builder.add_body(spec);
  Simulation<2> sim = scene.start();
  const StageReport report = settle(sim, 20, 1e-7);
  CHECK(report.end == StageEnd::rest);
  const Attachment<2> middle = tie_point(sim.model(), 2, {4, 0.25}, "test"),
                      end = tie_point(sim.model(), 2, {0, 0.25}, "test");
  return pose_at(sim.model(), sim.state(), end).place.y() - pose_at(sim.model(), sim.state(), middle).place.y();
}

TEST_CASE("a beam on two piers sags as one on two supports at their edges, its ends overhanging") {
  // Weight w per length, clear span L, overhangs a: 5 w L^4 / (384 EI) minus the uplift by the moments of the
  // overhangs, w a^2 / 2 L^2 / (8 EI).
  const double w = 2400 * 0.15 * standard_gravity, bending = 30e9 * 0.3 * 0.125 / 12, span = 8, over = 0.25;
  const double exact = 5 * w * std::pow(span, 4) / (384 * bending) - w * over * over / 2 * span * span / (8 * bending);
  CHECK(near(sag_on_piers(16), exact, 0.02));
  CHECK(near(sag_on_piers(34), exact, 0.01));
}

TEST_CASE("a falling girder and its support exchange momentum, and the energy balance closes") {
  Scene scene(Frictional{1e9, 4e8, 0.4, 2e-5});
  scene.builder.add_material(elastic_material("concrete", 2400, 30e9, 0.2, 1e-6));
  scene.fixed("ground", box(-20, -1, 20, 0));
  scene.block("pier", box(-0.5, 0, 0.5, 3), 7200);
  BodySpec girder = beam_body("girder", {-3, 3.8}, {5, 4.4}, rectangle_section(0.3, 0.5), "concrete", 16);
  girder.spin = -0.3;
  scene.builder.add_body(girder);
  Simulation<2> sim = scene.start();
  StageOptions options;
  options.duration = 3, options.safety = 0.3, options.energy_interval = 0.01;
  std::optional<double> first;
  EnergyCheck books;
  RunListener<2> listener;
  listener.on_energy = [&](const Instant<2>&, const Energy& e) {
    if (!first) first = e.balance();
    books.add(e, e.balance() - *first);
  };
  const StageReport report = sim.run(options, listener);
  CHECK(report.end == StageEnd::time);
  CHECK(books.input() > 1e4);
  CHECK(books.share() < 0.01);
  CHECK(body_pose(sim.model(), sim.state(), 2).place.y() < 3.5);
}

TEST_CASE("a column follows the ground that its foot is driven with, and swings as one mass on a spring") {
  // The structure of D1 as a cantilever: mass 1 t on a column of negligible mass, T = 0.5 s, no damping; the ground's
  // velocity is a half sine. Exact solution by Duhamel's integral.
  const double period = 0.5, omega = 2 * M_PI / period, mass = 1000, length = 3;
  const double bending = mass * omega * omega * length * length * length / 3, area = 0.005;
  Scene scene = weightless(Frictional{1e9, 4e8, 0.4, 0});
  scene.builder.add_material(elastic_material("steel", 50, 2e11));
  BodySpec spec = beam_body("column", {0, 0}, {0, length}, given_section(area, bending / 2e11, 0.2), "steel", 2);
  spec.frame->joints[0].support = held;
  spec.frame->joints[1].mass = mass, spec.frame->joints[1].inertia = 10;
  scene.builder.add_body(spec);
  Model<2> model = scene.builder.build();
  const double push = 2, last = 0.2;
  const auto ground =
      motion_of(1, 1e-4, [&](double t) { return t < last ? push * std::sin(2 * M_PI * t / last) : 0.0; });
  set_drive(model, 0, 0, ground, 0, 0);
  Simulation<2> sim(model);
  double most = 0;
  run_for(sim, 1, 0, each_step([&](const Instant<2>& now) {
            const double drift = now.state.position[1].x() - now.state.position[0].x();
            most = std::max(most, std::abs(drift));
          }));
  double exact = 0, u = 0, v = 0;
  const double dt = 1e-5;
  for (double t = 0; t < 1; t += dt) {
    const double pull = t < last ? push * std::sin(2 * M_PI * t / last) : 0.0;
    v += dt * (-pull - omega * omega * u), u += dt * v;
    exact = std::max(exact, std::abs(u));
  }
  CHECK(near(most, exact, 0.01));
}

TEST_CASE("a frame continued from a saved state gives the same bits as one that never stopped") {
  const auto scene = [] {
    Scene s(Frictional{1e9, 4e8, 0.4, 2e-5});
    s.builder.add_material(elastic_material("concrete", 2400, 30e9, 0.2, 1e-6));
    s.fixed("ground", box(-20, -1, 20, 0));
    s.builder.add_body(beam_body("girder", {-3, 0.8}, {5, 1.4}, rectangle_section(0.3, 0.5), "concrete", 6));
    return s;
  };
  Scene one = scene();
  Simulation<2> whole = one.start();
  run_for(whole, 0.25);
  Simulation<2> again(whole.model(), whole.state());
  for (Simulation<2>* sim : {&whole, &again}) run_for(*sim, 0.3);
  CHECK(state_hash(again.state()) == state_hash(whole.state()));
  CHECK(whole.state().time > 0.5);
}

TEST_CASE("invalid frames are rejected with a remedy") {
  const auto refusal = [](auto&& change) -> std::string {
    ModelBuilder builder;
    builder.add_material(elastic_material("m", 2400, 1e9));
    builder.add_material({"stone", 2000});
    builder.add_material({"steel", 7850, Solid{J2{2e11, 0.3, 2.4e8}}});
    BodySpec spec = beam_body("b", {0, 0}, {4, 0}, rectangle_section(0.3, 0.4), "m", 4);
    change(spec);
    try {
      builder.add_body(spec);
      builder.build();
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  const auto mentions = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  CHECK(refusal([](BodySpec&) {}).empty());
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->members.clear(); }), "without members"));
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->joints[1].place = {0, 0}; }), "must lie apart"));
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->members[0].to = 0; }), "name two"));
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->members[0].section = {}; }), "rectangle_section"));
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->members[0].divisions = 0; }), "1 to 1000"));
  CHECK(mentions(refusal([](BodySpec& b) {
                   b.frame->members[0].pinned = {true, true}, b.frame->members[0].divisions = 1;
                 }),
                 "two divisions"));
  CHECK(mentions(refusal([](BodySpec& b) {
                   b.frame->joints.push_back({.name = "c", .place = {9, 9}});
                 }),
                 "no member leads"));
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->joints[1].name = "from"; }), "given twice"));
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->joints[1].mass = -1; }), "mass"));
  CHECK(mentions(refusal([](BodySpec& b) { b.frame->joints[1].place.x() = std::nan(""); }), "joint 'to'"));
  CHECK(mentions(refusal([](BodySpec& b) { b.material = "stone"; }), "stiffness"));
  CHECK(mentions(refusal([](BodySpec& b) { b.material = "steel"; }), "members need an elastic material"));
  CHECK(mentions(refusal([](BodySpec& b) { b.inertia = 3; }), "inertia"));
  CHECK(mentions(refusal([](BodySpec& b) { b.thickness = 3; }), "body_thickness"));
}

/// Members of a frame that meet at joint b at (0, 1), by their joints and depths.
struct MemberOf {
  int from, to;
  double depth;
};
BodySpec meeting_at_b(const std::vector<MemberOf>& members, const Polygon& block = {}) {
  BodySpec spec;
  spec.name = "frame", spec.kind = BodyKind::frame, spec.material = "concrete", spec.floating = true;
  FrameSpec frame;
  frame.joints = {{.name = "a", .place = {0, 0}, .support = held},
                  {.name = "b", .place = {0, 1}, .block = block},
                  {.name = "c", .place = {0, 2}},
                  {.name = "d", .place = {2, 1}}};
  for (const MemberOf& m : members) {
    FrameMember member;
    member.from = m.from, member.to = m.to, member.section = rectangle_section(1, m.depth), member.divisions = 2;
    frame.members.push_back(member);
  }
  frame.joints.erase(frame.joints.begin() + (members.back().to == 2 ? 3 : 2));
  for (FrameMember& m : frame.members) m.to = std::min(m.to, 2);
  spec.frame = frame;
  return spec;
}

/// Of the two members that meet at b: whether the end of the first and the start of the second are faces.
std::array<bool, 2> faces_at_b(const BodySpec& spec) {
  const Model<2> model = of_frames(elastic_material("concrete", 2400, 30e9), {spec});
  const auto is_face = [&](int piece, int edge) { return model.edge_is_face[model.piece_first[piece] + edge] != 0; };
  return {is_face(1, 1), is_face(2, 3)};
}

TEST_CASE("the end of a member is a face unless another member covers it completely") {
  using Faces = std::array<bool, 2>;
  CHECK(faces_at_b(meeting_at_b({{0, 1, 0.6}, {1, 2, 0.2}})) == Faces{true, false});
  CHECK(faces_at_b(meeting_at_b({{0, 1, 0.2}, {1, 2, 0.6}})) == Faces{false, true});
  CHECK(faces_at_b(meeting_at_b({{0, 1, 0.4}, {1, 2, 0.4}})) == Faces{false, false});
  // A beam across: the beam covers no more than its side of the column's head, and the column covers the lower half of
  // the beam's end.
  CHECK(faces_at_b(meeting_at_b({{0, 1, 0.6}, {1, 3, 0.2}})) == Faces{true, true});
  // A block of a joint covers faces as a member does: as wide as the column, wider than the beam.
  CHECK(faces_at_b(meeting_at_b({{0, 1, 0.6}, {1, 3, 0.2}}, box(-0.3, 0.7, 0.3, 1.3))) == Faces{false, false});
  CHECK(faces_at_b(meeting_at_b({{0, 1, 0.6}, {1, 3, 0.2}}, box(-0.2, 0.7, 0.2, 1.3))) == Faces{true, false});
}

TEST_CASE("a block stands on the ledge of a column and on its head next to a beam, set down or dropped") {
  struct Ledge {
    MemberOf above;
    double x, width;
  };
  for (const Ledge& ledge : {Ledge{{1, 2, 0.2}, 0.2, 0.18}, Ledge{{1, 3, 0.2}, -0.15, 0.2}})
    for (const double drop : {0.0, 0.05}) {
      const double stiffness = 1e9, half = 0.5 * ledge.width;
      Scene scene(Frictional{stiffness, 4e8, 0.6, 1e-3});
      scene.builder.add_material(elastic_material("concrete", 2400, 30e9, 0.2, 1e-5));
      scene.builder.add_body(meeting_at_b({{0, 1, 0.6}, ledge.above}));
      BodySpec block;
      block.name = "b", block.outline = box(ledge.x - half, 1 + drop, ledge.x + half, 1.2 + drop), block.mass = 100;
      block.floating = true;
      scene.add(block);
      Simulation<2> sim = scene.start();
      const double start = body_pose(sim.model(), sim.state(), 1).place.y(), column = sim.state().position[1].y();
      const StageReport report = settle(sim, 20, 1e-6);
      CHECK(report.end == StageEnd::rest);
      CHECK(sim.verdict().sound());
      // The head turns under the block, which presses off the head's middle: the block's middle follows the rotation.
      const double sinks = 100 * standard_gravity / (stiffness * ledge.width),
                   head = sim.state().position[1].y() - column + ledge.x * sim.state().rotation[1];
      const double came = start - body_pose(sim.model(), sim.state(), 1).place.y() - drop;
      CHECK(near(came, sinks - head, 0.01));
    }
}

}  // namespace
}  // namespace trilith::testing
