// Members of frames in results files, pictures, reports and tables: section forces by closed forms, clean corners,
// hinges, envelopes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "draw/members/results_members.hpp"
#include "draw/results/results_picture.hpp"
#include "near.hpp"
#include "physics/members/yielding.hpp"
#include "report/report.hpp"
#include "results/reading/member_summary.hpp"
#include "results/sample_run.hpp"
#include "results/tables/csv_table.hpp"
#include "run/record/recording.hpp"
#include "run/simulation.hpp"
#include "statics/equilibrium.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double span = 6, force = 40e3;

RecordingOptions<2> quiet_options() {
  RecordingOptions<2> o;
  o.sync = false;
  return o;
}

StageOptions recorded_stage() {
  StageOptions o;
  o.name = "load", o.duration = 1, o.frame_interval = 0.1;
  return o;
}

/// A beam on two hinges of which the right one slides, with a force at mid-span.
Model<2> simple_beam() {
  BodySpec spec = beam_body("beam", {0, 0}, {span, 0}, rectangle_section(0.2, 0.4), "steel", 8);
  spec.frame->joints[0].support = hinged;
  spec.frame->joints[1].support = {Support::free, Support::fixed, Support::free};
  Model<2> model = of_frames(elastic_material("steel", 7850, 2.1e11), {spec});
  add_load(model, "beam", {span / 2, 0}, {0, -force});
  return model;
}

/// Records a static stage.
void record_static(const Model<2>& model, const std::filesystem::path& path) {
  Simulation<2> simulation(model);
  Recording<2> recording(path, simulation.model(), simulation.state(), quiet_options());
  const StageReport report = simulation.settle(recorded_stage(), {}, recording.listener());
  REQUIRE(report.end == StageEnd::rest);
  recording.finish();
}

draw::Scene diagram_scene(const results::ResultsReader& reader, const std::string& name, bool envelope = false) {
  draw::SceneChoice choice;
  choice.diagram = name, choice.envelope = envelope;
  return draw::results_scene(reader, reader.frame_times().back(), choice);
}

}  // namespace

TEST_CASE("the diagrams of a simply supported beam are P L/4 on the lower side, and P/2 of either sign") {
  const Folder folder;
  record_static(simple_beam(), folder / "beam.h5");
  const results::ResultsReader reader(folder / "beam.h5");
  REQUIRE(reader.header().members.size() == 1);
  REQUIRE(reader.header().beams.size() == 8);
  const draw::Scene moments = diagram_scene(reader, "moment");
  REQUIRE(moments.diagrams.size() == 1);
  const draw::SceneDiagram& m = moments.diagrams[0];
  REQUIRE(m.value.size() == 16);
  const auto most = static_cast<std::size_t>(std::max_element(m.value.begin(), m.value.end()) - m.value.begin());
  CHECK(near(m.value[most], force * span / 4, 1e-4));
  CHECK(near(m.axis[most].x(), span / 2, 1e-4));
  CHECK(m.towards[most].y() < -0.999);  // below the axis, in tension
  CHECK(std::abs(m.value.front()) < 1e-4 * force * span);
  const draw::Scene shears = diagram_scene(reader, "shear");
  CHECK(near(shears.diagrams[0].value.front(), force / 2, 1e-4));
  CHECK(near(shears.diagrams[0].value.back(), -force / 2, 1e-4));
  const draw::Scene normals = diagram_scene(reader, "normal");
  for (const double v : normals.diagrams[0].value) CHECK(std::abs(v) < 1e-3 * force);
  CHECK(draw::scene_canvas({moments}, 1).text_boxes().size() > 3);
}

TEST_CASE("the moment diagram of a portal under a lateral force follows the frame formula") {
  // Columns of height h with fixed feet and a beam of length l, all of one E I: with k = h / l the foot moments are
  // F h (3 k + 1) / (2 (6 k + 1)), the corner moments F h 3 k / (2 (6 k + 1)) (A. Kleinlogel, "Rahmenformeln", frame
  // 6).
  YieldingPortal portal;
  portal.side = 1e3, portal.young = 2.1e11;
  Model<2> model = of_frames(elastic_material("steel", 7850, portal.young), {portal.body()});
  add_load(model, "portal", {0, 4}, {portal.side, 0});
  const Folder folder;
  record_static(model, folder / "portal.h5");
  const results::ResultsReader reader(folder / "portal.h5");
  const draw::Scene scene = diagram_scene(reader, "moment");
  REQUIRE(scene.diagrams.size() == 4);
  // k of the formula is I_beam h / (I_column l).
  const double h = 4, k = h / 6, foot = portal.side * h * (3 * k + 1) / (2 * (6 * k + 1)),
               corner = portal.side * h * 3 * k / (2 * (6 * k + 1));
  // Axial strain of the members changes the moments by about 1 %.
  for (const std::size_t column : {0, 3}) {
    CHECK(near(std::abs(scene.diagrams[column].value.front()), foot, 0.02));
    CHECK(near(std::abs(scene.diagrams[column].value.back()), corner, 0.02));
    CHECK(scene.diagrams[column].value.front() * scene.diagrams[column].value.back() < 0);
  }
  CHECK(near(scene.diagrams[1].value.front(), -scene.diagrams[2].value.back(), 0.02));
  CHECK(scene.hinges.size() == 5);
  for (const draw::SceneHinge& hinge : scene.hinges) CHECK(hinge.state == draw::HingeMark::elastic);
}

TEST_CASE("the corners of a frame are filled to the outer edges and nowhere beyond them") {
  const Model<2> model = of_frames(elastic_material("steel", 7850, 2.1e11), {YieldingPortal{}.body()});
  const Folder folder;
  record_static(model, folder / "portal.h5");
  const results::ResultsReader reader(folder / "portal.h5");
  const draw::Scene scene = draw::results_scene(reader, reader.frame_times().back());
  REQUIRE(scene.bodies.size() == 1);
  const auto& parts = scene.bodies[0].parts;
  CHECK(parts.size() == 6);  // four members and two outer corners
  const auto covered = [&](const Vec2& p) {
    return std::any_of(parts.begin(), parts.end(), [&](const std::vector<Vec2>& part) {
      int crossings = 0;
      for (std::size_t i = 0, j = part.size() - 1; i < part.size(); j = i++)
        if ((part[i].y() > p.y()) != (part[j].y() > p.y()) &&
            p.x() < (part[j].x() - part[i].x()) * (p.y() - part[i].y()) / (part[j].y() - part[i].y()) + part[i].x())
          ++crossings;
      return crossings % 2 == 1;
    });
  };
  // Sections are 0.2 m deep: the outer corner of a square joint lies 0.1 m outside of both axes.
  CHECK(covered({-0.099, 4.099}));
  CHECK(covered({6.099, 4.099}));
  CHECK(covered({0.05, 3.95}));
  CHECK_FALSE(covered({-0.101, 4.05}));
  CHECK_FALSE(covered({0.05, 4.101}));
  CHECK_FALSE(covered({0.15, 3.85}));
}

TEST_CASE("yielding members are named in table and verdict, with ductility demand and drift") {
  YieldingPortal portal;
  portal.side = 1e5, portal.young = 2.1e11;
  portal.law.hardening = 5e5;
  Simulation<2> simulation(portal.model(1.4));
  const Folder folder;
  Recording<2> recording(folder / "push.h5", simulation.model(), simulation.state(), quiet_options());
  StageOptions stage = recorded_stage();
  stage.duration = 2.5;
  simulation.run(stage, recording.listener());
  recording.finish();
  const results::ResultsReader reader(folder / "push.h5");
  const std::vector<results::EventRow> events = reader.events();
  const auto yielded =
      std::find_if(events.begin(), events.end(), [](const results::EventRow& e) { return e.type == "member.yielded"; });
  REQUIRE(yielded != events.end());
  CHECK(yielded->second.name == "yield rotation");
  // M L / (6 E I) of a column.
  const double stiffness = 2.1e11 * 0.1 * std::pow(0.2, 3) / 12;
  CHECK(near(yielded->second.value, yield_moment * 4 / (6 * stiffness), 1e-6));
  const std::vector<results::MemberSummary> members = results::member_summaries(reader, events);
  REQUIRE(members.size() == 4);
  CHECK(members[0].yielded == 2);
  REQUIRE(members[0].ductility);
  CHECK(near(*members[0].ductility,
             1 + std::abs(members[0].deformation.value) / reader.header().members[0].yield_rotation[0], 1e-9));
  REQUIRE(members[0].drift);
  const results::Frame last = reader.frame(reader.frame_count() - 1);
  // Node 1 is the top of the left column, 4 m high; the push grows, so the drift is largest near the end.
  CHECK(near(members[0].drift->value, std::abs(last.position[2] - 0) / 4, 0.2));
  CHECK_FALSE(members[2].ductility);
  const std::string page = report::report_page(reader, {});
  CHECK(page.find("members yielded (left") != std::string::npos);
  CHECK(page.find("the largest ductility demand is") != std::string::npos);
  CHECK(page.find("the largest drift is") != std::string::npos);
  CHECK(page.find("nothing failed") == std::string::npos);
  CHECK(page.find("end_hinge: ") == std::string::npos);  // laws of members are under Members, as text
  CHECK(page.find("end_hinge{") != std::string::npos);
  const std::string table = results::csv_table(reader, "members", {reader.frame_times().back()});
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 2 * 4);
  CHECK(table.find("yielded") != std::string::npos);
}

TEST_CASE("an envelope holds the values of every frame, and is needed where a diagram is not") {
  const Folder folder;
  Simulation<2> simulation(simple_beam());  // the load acts at once: the beam vibrates about its deflection
  Recording<2> recording(folder / "beam.h5", simulation.model(), simulation.state(), quiet_options());
  StageOptions stage = recorded_stage();
  stage.duration = 0.1, stage.frame_interval = 0.002;
  simulation.run(stage, recording.listener());
  recording.finish();
  const results::ResultsReader reader(folder / "beam.h5");
  const draw::Scene envelope = diagram_scene(reader, "moment", true);
  REQUIRE(envelope.diagrams.size() == 2);
  double most = 0;
  for (std::size_t f = 0; f < reader.frame_count(); ++f) {
    const results::Frame frame = reader.frame(f);
    const results::MemberValues values(reader.header(), frame);
    for (std::size_t b = 0; b < 8; ++b)
      for (const int end : {0, 1}) {
        const double v = values.force(b, end, results::member_quantity(2, "moment"));
        const std::size_t i = 2 * b + static_cast<std::size_t>(end);
        CHECK(v <= envelope.diagrams[0].value[i] + 1e-9);
        CHECK(v >= envelope.diagrams[1].value[i] - 1e-9);
        most = std::max(most, v);
      }
  }
  // A force applied at once doubles the static moment of the first mode, higher modes add to it.
  CHECK(most > 1.7 * force * span / 4);
  CHECK(most == *std::max_element(envelope.diagrams[0].value.begin(), envelope.diagrams[0].value.end()));
  draw::SceneChoice wrong;
  wrong.envelope = true;
  CHECK_THROWS_AS(draw::results_scene(reader, 0.05, wrong), InputError);
  wrong.diagram = "momment";
  CHECK_THROWS_WITH_AS(draw::results_scene(reader, 0.05, wrong), doctest::Contains("'moment'"), InputError);
}
