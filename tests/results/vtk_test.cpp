// Files for ParaView: read here by their headers, and by VTK itself if python3 has it.
#include <doctest/doctest.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>

#include "base/error.hpp"
#include "near.hpp"
#include "results/file/placement.hpp"
#include "results/sample_run.hpp"
#include "results/tumbling_boxes.hpp"
#include "results/vtk/vtk_export.hpp"
#include "results/vtk/vtk_file.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::testing;

namespace {

std::string attribute(const std::string& element, const std::string& name) {
  const std::string mark = " " + name + "=\"";
  const std::size_t from = element.find(mark);
  REQUIRE_MESSAGE(from != std::string::npos, element);
  return element.substr(from + mark.size(), element.find('"', from + mark.size()) - from - mark.size());
}

/// The element that opens with `begin`.
std::string element(const std::string& file, const std::string& begin) {
  const std::size_t from = file.find(begin);
  REQUIRE_MESSAGE(from != std::string::npos, begin);
  return file.substr(from, file.find('>', from) - from);
}

/// The numbers of the array `name` of `section`.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& section, const std::string& name) {
  const std::string part = file.substr(file.find("<" + section + ">"));
  const std::size_t mark = part.find(" Name=\"" + name + "\"");
  REQUIRE_MESSAGE(mark != std::string::npos, name);
  const std::string head = element(part.substr(part.rfind('<', mark)), "<");
  const std::string opening = "<AppendedData encoding=\"raw\">\n_";
  const char* at = file.data() + file.find(opening) + opening.size() + std::stoul(attribute(head, "offset"));
  std::uint64_t word[4] = {};
  std::memcpy(word, at, sizeof word);
  if (word[0] == 0) return {};
  CHECK(word[0] == 1);
  std::vector<T> values(word[1] / sizeof(T));
  uLongf bytes = word[1];
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(values.data()), &bytes, reinterpret_cast<const Bytef*>(at + sizeof word),
                     word[3]) == Z_OK);
  CHECK(bytes == values.size() * sizeof(T));
  CHECK(std::stoul(attribute(head, "NumberOfTuples")) * std::stoul(attribute(head, "NumberOfComponents")) ==
        values.size());
  return values;
}

/// Volume of the cell `index`, computed from its faces in the file.
double cell_volume(const std::string& file, std::size_t index) {
  const auto faces = array_of<std::int32_t>(file, "Cells", "faces"),
             ends = array_of<std::int32_t>(file, "Cells", "faceoffsets");
  const auto points = array_of<double>(file, "Points", "Points");
  std::size_t at = index == 0 ? 0 : static_cast<std::size_t>(ends[index - 1]);
  const auto point = [&](std::int32_t i) -> Vec3 { return Eigen::Map<const Vec3>(&points[3 * i]); };
  double volume = 0;
  for (int face = faces[at++]; face > 0; --face) {
    const int corners = faces[at];
    for (int k = 2; k < corners; ++k)
      volume += point(faces[at + 1]).dot(cross(point(faces[at + k]), point(faces[at + k + 1]))) / 6;
    at += static_cast<std::size_t>(corners) + 1;
  }
  CHECK(at == static_cast<std::size_t>(ends[index]));
  return volume;
}

}  // namespace

TEST_CASE("solids become polyhedra of VTK with their volume, displacement and velocity") {
  const Folder folder;
  const std::vector<FlyingBox> boxes = tumbling_boxes();
  record_boxes(folder / "run.h5", boxes, 9, 0.125);
  const auto written = export_vtk(ResultsReader(folder / "run.h5"), folder / "out");
  REQUIRE(written.size() == 3);
  CHECK(written[0] == folder / "out" / "run_bodies.pvd");
  const std::string file = bytes_of(folder / "out" / "run_bodies" / "000008.vtu");
  const std::string piece = element(file, "<Piece");
  CHECK(attribute(piece, "NumberOfPoints") == "32");
  CHECK(attribute(piece, "NumberOfCells") == "4");
  CHECK(file.find("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">1<") != std::string::npos);
  CHECK(array_of<std::int8_t>(file, "Cells", "types") == std::vector<std::int8_t>(4, 42));
  CHECK(array_of<std::int32_t>(file, "Cells", "offsets") == std::vector<std::int32_t>{8, 16, 24, 32});
  CHECK(near(cell_volume(file, 0), 2 * 1.6 * 0.2, 1e-12));
  CHECK(near(cell_volume(file, 1), 0.4 * 0.2 * 0.1, 1e-12));

  // Corner 3 of body 1 from its start, velocity and spin; the numbers of data have seven digits.
  const auto points = array_of<double>(file, "Points", "Points");
  const auto moved = array_of<float>(file, "PointData", "displacement");
  const auto velocity = array_of<float>(file, "PointData", "velocity");
  const FlyingBox& box = boxes[1];
  const Vec3 local = box_solid(-box.half, box.half).corners[3];
  const Vec3 now = box.place(1) + turn_of(box.turn(1)).apply(local);
  const Vec3 speed = box.velocity + cross(box.spin, now - box.place(1));
  for (int k = 0; k < 3; ++k) {
    CHECK(near(points[3 * 11 + k], now[k], 1e-12));
    CHECK(near(moved[3 * 11 + k], now[k] - (box.start + local)[k], 1e-6));
    CHECK(near(velocity[3 * 11 + k], speed[k], 1e-6));
  }
  CHECK(array_of<std::int32_t>(file, "CellData", "body") == std::vector<std::int32_t>{0, 1, 2, 3});
  CHECK(array_of<std::int8_t>(file, "CellData", "held") == std::vector<std::int8_t>{1, 0, 0, 0});
  CHECK(array_of<std::int8_t>(file, "CellData", "in stones") == std::vector<std::int8_t>{0, 1, 1, 1});
  CHECK(near(array_of<float>(file, "CellData", "turned")[1], std::sqrt(1 + 4 + 2.25), 1e-6));
  CHECK(near(array_of<float>(file, "CellData", "mass")[1], 16, 1e-6));
}

TEST_CASE("the export has contacts as points and bearings as lines with their forces, and a list of times") {
  const Folder folder;
  record_boxes(folder / "run.h5", tumbling_boxes(), 9, 0.125);
  const ResultsReader reader(folder / "run.h5");
  export_vtk(reader, folder / "out", {1, 6, 2});
  const std::string series = bytes_of(folder / "out" / "run_contacts.pvd");
  CHECK(series.find("timestep=\"0.125\" part=\"0\" file=\"run_contacts/000001.vtp\"") != std::string::npos);
  CHECK(series.find("timestep=\"0.625\" part=\"0\" file=\"run_contacts/000005.vtp\"") != std::string::npos);
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "out/run_contacts"), {}) == 3);

  const std::string contacts = bytes_of(folder / "out" / "run_contacts" / "000003.vtp");
  CHECK(attribute(element(contacts, "<Piece"), "NumberOfVerts") == "1");
  CHECK(array_of<double>(contacts, "Points", "Points") == std::vector<double>{0.3, 0.1, 0});
  CHECK(array_of<float>(contacts, "PointData", "force") == std::vector<float>{5, 0, 80});
  CHECK(array_of<float>(contacts, "PointData", "normal") == std::vector<float>{0, 0, -1});
  CHECK(array_of<float>(contacts, "PointData", "area") == std::vector<float>{0.08F});
  CHECK(array_of<std::int8_t>(contacts, "PointData", "state") == std::vector<std::int8_t>{1});

  const std::string bearings = bytes_of(folder / "out" / "run_bearings" / "000003.vtp");
  CHECK(array_of<float>(bearings, "CellData", "force") == std::vector<float>{1, 2, 3});
  CHECK(array_of<std::int8_t>(bearings, "CellData", "state") == std::vector<std::int8_t>{1});
  const auto ends = array_of<double>(bearings, "Points", "Points");
  const FlyingBox box = tumbling_boxes()[1];
  const Vec3 far = box.place(0.375) + turn_of(box.turn(0.375)).apply(Vec3(0, 0, -0.05));
  CHECK(ends[2] == 0);
  for (int k = 0; k < 3; ++k) CHECK(near(ends[3 + k], far[k], 1e-12));
}

TEST_CASE("a model in the plane becomes polygons at z = 0") {
  const Folder folder;
  const Header header = sample_header();
  {
    ResultsWriter writer(folder / "run.h5", header);
    for (int i = 0; i < 3; ++i) SampleRow(header, i).append_to(writer);
    writer.finish();
  }
  const ResultsReader reader(folder / "run.h5");
  export_vtk(reader, folder / "out");
  const std::string file = bytes_of(folder / "out" / "run_bodies" / "000002.vtu");
  CHECK(array_of<std::int8_t>(file, "Cells", "types") == std::vector<std::int8_t>(3, 7));
  const auto points = array_of<double>(file, "Points", "Points");
  const Frame frame = reader.frame(2);
  const Placement at(reader.header(), frame);
  REQUIRE(points.size() == 36);
  for (int v = 0; v < 12; ++v) {
    CHECK(points[3 * v] == at.vertex(v).x());
    CHECK(points[3 * v + 2] == 0);
  }
  const Vec2 corner = Vec2(frame.position[0], frame.position[1]) + Turn(frame.rotation[0]).apply({-0.5, -1});
  CHECK(near(points[0], corner.x(), 1e-12));
  CHECK(near(points[1], corner.y(), 1e-12));
  CHECK(array_of<float>(bytes_of(folder / "out" / "run_contacts" / "000002.vtp"), "PointData", "force").size() == 6);
}

TEST_CASE("missing frames are rejected, and a single last frame is accepted") {
  const Folder folder;
  record_boxes(folder / "run.h5", tumbling_boxes(), 3, 0.1);
  const ResultsReader reader(folder / "run.h5");
  CHECK_THROWS_WITH_AS(export_vtk(reader, folder / "out", {3, 9, 1}), doctest::Contains("frames count from 0 to 2"),
                       ResultsError);
  export_vtk(reader, folder / "out", {2, 9, std::size_t{1} << 63});
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "out/run_bodies"), {}) == 1);
  std::ofstream(folder / "file") << "x";
  CHECK_THROWS_WITH_AS(export_vtk(reader, folder / "file"), doctest::Contains("cannot make the folder"), InputError);
}

TEST_CASE("special characters in texts keep XML valid") {
  CHECK(xml_text("a <b> & \"c\"\n") == "a &lt;b&gt; &amp; &quot;c&quot; ");
}

TEST_CASE("VTK reads the export for ParaView") {
  if (std::system("/usr/bin/python3 -c 'import vtkmodules.vtkIOXML' >/dev/null 2>&1") != 0) {
    MESSAGE("skipped: /usr/bin/python3 has no vtk");
    return;
  }
  const Folder folder;
  record_boxes(folder / "run.h5", tumbling_boxes(), 5, 0.25);
  const ResultsReader reader(folder / "run.h5");
  export_vtk(reader, folder / "out");
  std::ofstream(folder / "read.py") << R"(
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLPolyDataReader
from vtkmodules.vtkCommonCore import reference

def read(reader, name):
    failed = []
    reader.AddObserver("ErrorEvent", lambda *_: failed.append(1))
    reader.SetFileName(name)
    reader.Update()
    assert not failed
    return reader.GetOutput()

grid = read(vtkXMLUnstructuredGridReader(), "out/run_bodies/000004.vtu")
assert grid.GetNumberOfPoints() == 32 and grid.GetNumberOfCells() == 4
cell = grid.GetCell(1)
assert cell.GetClassName() == "vtkPolyhedron" and cell.GetNumberOfFaces() == 6 and cell.GetFace(0).GetNumberOfPoints() == 4
data = grid.GetCellData()
assert [data.GetAbstractArray("name").GetValue(i) for i in range(4)] == ["stone 0", "stone 1", "stone 2", "stone 3"]
assert data.GetAbstractArray("group").GetValue(3) == "upper" and data.GetArray("in stones").GetTuple1(2) == 1
assert grid.GetFieldData().GetArray("TimeValue").GetTuple1(0) == 1
c = [sum(grid.GetPoint(8 + i)[k] for i in range(8)) / 8 for k in range(3)]
assert all(abs(a - b) < 1e-12 for a, b in zip(c, (-0.3, 0.2, 0.8))), c
points = read(vtkXMLPolyDataReader(), "out/run_contacts/000004.vtp")
assert points.GetNumberOfVerts() == 1 and points.GetPointData().GetArray("force").GetTuple(0) == (5, 0, 80)
lines = read(vtkXMLPolyDataReader(), "out/run_bearings/000004.vtp")
assert lines.GetNumberOfLines() == 1 and lines.GetCellData().GetArray("force").GetTuple(0) == (1, 2, 3)
)";
  std::fflush(nullptr);
  CHECK(std::system(("cd " + folder.path.string() + " && /usr/bin/python3 read.py").c_str()) == 0);
}
