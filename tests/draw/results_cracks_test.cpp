// Cracks in pictures: joints that have lost their bond, and dry joints that are open or have slid.
#include <doctest/doctest.h>

#include "draw/results/results_picture.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using namespace trilith::draw;
using namespace trilith::testing;

namespace {

struct SampleJoint {
  bool bonded;
  double opening, slip, damage;
};

/// The crack marks of these joints, all between the first two bodies.
std::vector<CrackMark> cracks_of(const std::vector<SampleJoint>& joints) {
  const Folder folder;
  results::Header header = sample_header();
  std::vector<std::vector<double>> fields(3);
  for (const SampleJoint& joint : joints) {
    header.joints.push_back({0, 1, 0, joint.bonded ? 1 : 0, {0.5, 0, 0}, {0.5, 1, 0}});
    fields[0].push_back(joint.opening), fields[1].push_back(joint.slip), fields[2].push_back(joint.damage);
  }
  for (const char* name : {"joint_opening", "joint_slip", "joint_damage"})
    header.fields.push_back({name, "m", "of each joint", joints.size(), 1});
  results::ResultsWriter writer(folder / "run.h5", header);
  writer.begin_stage("rest", "dynamic", 0);
  SampleRow row(header, 0);
  row.frame.fields = fields;
  row.append_to(writer);
  writer.finish();
  SceneChoice choice;
  choice.cracks = true;
  std::vector<CrackMark> marks;
  for (const SceneCrack& crack : results_scene(results::ResultsReader(folder / "run.h5"), 0, choice).cracks)
    marks.push_back(crack.mark);
  return marks;
}

}  // namespace

TEST_CASE("dry joints are drawn as cracks by their opening from a tenth of a millimetre on and bonded ones once lost") {
  using Marks = std::vector<CrackMark>;
  CHECK(cracks_of({{false, 5e-5, 2e-5, 0}, {true, 4e-3, 0, 0}}) == Marks{});
  CHECK(cracks_of({{false, 5e-4, 0, 0}}) == Marks{CrackMark::fine});
  CHECK(cracks_of({{false, 3e-3, 1e-3, 0}}) == Marks{CrackMark::opened});
  CHECK(cracks_of({{false, 3e-2, 0, 0}}) == Marks{CrackMark::wide});
  CHECK(cracks_of({{false, 1e-4, -2e-3, 0}}) == Marks{CrackMark::slid});
  CHECK(cracks_of({{true, 5e-5, 2e-5, 0.5}}) == Marks{CrackMark::fine});
  CHECK(cracks_of({{false, 1.5, 0, 0}}) == Marks{});  // no neighbours
}
