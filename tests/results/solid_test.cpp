// Solids in results files: their faces, and contact data that only models in space have.
#include <doctest/doctest.h>

#include "near.hpp"
#include "results/reading/info.hpp"
#include "results/sample_run.hpp"
#include "results/tumbling_boxes.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

Header header_of_boxes() {
  Header header;
  header.dim = 3;
  for (const FlyingBox& box : tumbling_boxes()) add_box(header, box);
  return header;
}

}  // namespace

TEST_CASE("faces of solids, areas and normals of contacts are read back as they were written") {
  const Folder folder;
  record_boxes(folder / "run.h5", tumbling_boxes(), 5, 0.1);
  const ResultsReader reader(folder / "run.h5");
  const Header& header = reader.header();
  const Header written = header_of_boxes();
  CHECK(header.face_count() == 24);
  CHECK(header.face_first == written.face_first);
  CHECK(header.face_vertex == written.face_vertex);
  CHECK(header.bodies[2].first_face == 12);
  CHECK(header.bodies[2].face_count == 6);
  const Frame frame = reader.frame(3);
  REQUIRE(frame.contacts.size() == 1);
  CHECK(frame.contacts[0].area == 0.08);
  CHECK(frame.contacts[0].normal[2] == -1);
  CHECK(info_text(reader).find("24, of 32 corners") != std::string::npos);

  repair(folder / "run.h5", folder / "copy.h5");
  CHECK(ResultsReader(folder / "copy.h5").header().face_vertex == written.face_vertex);
}

TEST_CASE("the faces of a written solid bound it from outside: its volume comes out") {
  const Header header = header_of_boxes();
  const BodyRow& body = header.bodies[1];
  Polyhedron solid;
  for (int v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v)
    solid.corners.push_back(Eigen::Map<const Vec3>(&header.vertices[3 * v]));
  for (int f = body.first_face; f < body.first_face + body.face_count; ++f) {
    std::vector<int> loop(header.face_vertex.begin() + header.face_first[f],
                          header.face_vertex.begin() + header.face_first[f + 1]);
    for (int& corner : loop) corner -= body.first_vertex;
    solid.faces.add(loop);
  }
  CHECK(near(solid_moments(solid).volume, 0.4 * 0.2 * 0.1, 1e-12));
}

TEST_CASE("a model in the plane has neither columns nor data sets of faces") {
  const Folder folder;
  const Header header = sample_header();
  ResultsWriter(folder / "run.h5", header).finish();
  const std::string bytes = bytes_of(folder / "run.h5");
  for (const char* word : {"face", "area"}) CHECK(bytes.find(word) == std::string::npos);
  CHECK(ResultsReader(folder / "run.h5").header().face_count() == 0);
}

TEST_CASE("a file in space without faces, as earlier versions wrote them, is still read") {
  const Folder folder;
  const Header header = sample_header(2, 3);
  ResultsWriter(folder / "run.h5", header).finish();
  const ResultsReader reader(folder / "run.h5");
  CHECK(reader.header().face_count() == 0);
  CHECK(reader.header().bodies[1].face_count == 0);
}

TEST_CASE("faces that do not fit their bodies never reach the file") {
  const Folder folder;
  const auto refused = [&](auto change, const char* part) {
    Header header = header_of_boxes();
    change(header);
    CHECK_THROWS_WITH_AS(ResultsWriter(folder / "run.h5", header), doctest::Contains(part), ResultsError);
  };
  refused([](Header& h) { h.face_vertex[30] = 0; }, "a face of body 'stone 1' has corner 0, which is not the body's");
  refused([](Header& h) { h.face_first[3] = 9; }, "face 2 has 1 corners, needs 3");
  refused([](Header& h) { h.face_first.back() = 5; }, "face_first runs from 0 to 5, must be 0 to 96");
  refused([](Header& h) { h.bodies[1].face_count = 60; }, "body 'stone 1' has faces outside the list");
  refused([](Header& h) { h.face_first.clear(); }, "face_vertex has 96 entries, needs 0");
  CHECK(std::filesystem::is_empty(folder.path));
}
