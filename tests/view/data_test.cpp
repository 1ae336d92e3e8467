#include "view/data.hpp"

#include <doctest/doctest.h>

#include <random>

#include "near.hpp"
#include "results/sample_run.hpp"
#include "results/tumbling_boxes.hpp"
#include "view/bytes.hpp"
#include "view/joints.hpp"

using namespace trilith;
using namespace trilith::results;
using namespace trilith::view;
using namespace trilith::testing;

namespace {

std::uint32_t number_at(const std::string& data, std::size_t at) {
  std::uint32_t out = 0;
  for (std::size_t i = 0; i < 4; ++i)
    out |= static_cast<std::uint32_t>(static_cast<unsigned char>(data[at + i])) << 8 * i;
  return out;
}

std::string head_of(const std::string& data) {
  return data.substr(12, number_at(data, 8));
}

/// The number after `key` in `text`, searched from `from` on.
double value_of(const std::string& text, const std::string& key, std::size_t from) {
  return std::stod(text.substr(text.find("\"" + key + "\":", from) + key.size() + 3));
}

/// Block `name` as numbers, as read by the page.
struct Read {
  Read(const std::string& data, const std::string& name) {
    const std::string head = head_of(data);
    std::size_t offset = 12 + head.size(), at = head.find("\"blocks\":[");
    for (;;) {
      at = head.find("{\"name\":\"", at + 1);
      REQUIRE(at != std::string::npos);
      const auto bytes = static_cast<std::size_t>(value_of(head, "bytes", at));
      if (head.compare(at + 9, name.size() + 1, name + "\"") == 0) {
        rows = static_cast<std::size_t>(value_of(head, "rows", at));
        columns = static_cast<std::size_t>(value_of(head, "columns", at));
        quantum = value_of(head, "quantum", at);
        whole = unpacked(std::string_view(data).substr(offset, bytes), rows, columns);
        return;
      }
      offset += bytes;
    }
  }
  double operator()(std::size_t row, std::size_t column) const { return quantum * whole[row * columns + column]; }
  std::size_t rows = 0, columns = 0;
  double quantum = 0;
  std::vector<std::int32_t> whole;
};

void write_sample(const std::filesystem::path& path, int rows) {
  const Header header = sample_header();
  ResultsWriter writer(path, header);
  for (int i = 0; i < rows; ++i) SampleRow(header, i).append_to(writer);
  writer.finish();
}

}  // namespace

TEST_CASE("packed numbers are restored for any value") {
  std::mt19937 random(1);
  for (const int size : {0, 1, 7, 300}) {
    ViewBlock block{"b", 3, 1, {}};
    for (int i = 0; i < 3 * size; ++i) block.values.push_back(static_cast<std::int32_t>(random()) >> (random() % 32));
    CHECK(unpacked(packed(block), block.rows(), 3) == block.values);
  }
  const ViewBlock ends{"b", 1, 1, {INT32_MIN, INT32_MAX, INT32_MIN, 0, -1, 1}};
  CHECK(unpacked(packed(ends), 6, 1) == ends.values);
  CHECK(quantised(std::nan(""), 1) == 0);
  CHECK(quantised(1e300, 1e-3) == 1 << 30);
}

TEST_CASE("gzip and base64 give their bytes back, the same each time") {
  CHECK(base64("") == "");
  CHECK(base64("M") == "TQ==");
  CHECK(base64("Ma") == "TWE=");
  CHECK(base64("Man") == "TWFu");
  std::string bytes;
  for (int i = 0; i < 70000; ++i) bytes += static_cast<char>(i % 251 * (i % 251) % 251);
  for (const std::string& text : {std::string(), std::string("a"), bytes}) {
    CHECK(gunzipped(from_base64(base64(gzipped(text)))) == text);
    CHECK(gzipped(text) == gzipped(text));
  }
}

TEST_CASE("the data of the page equal the results within half a quantum") {
  const Folder folder;
  constexpr int rows = 40;
  write_sample(folder / "run.h5", rows);
  const ResultsReader reader(folder / "run.h5");
  const std::string data = view_data(reader);
  CHECK(data.substr(0, 4) == "TRLV");
  const Read time(data, "time"), position(data, "position"), rotation(data, "rotation"), state(data, "bearing_state");
  const Read force(data, "bearing_force"), first(data, "contact_first"), place(data, "contact_place"),
      push(data, "contact_force"), pair(data, "contact_pair");
  REQUIRE(time.rows == rows);
  const double slack = 0.5 + 1e-6;
  for (std::size_t i = 0; i < rows; ++i) {
    const Frame frame = reader.frame(i);
    CHECK(std::abs(time(i, 0) - frame.time) <= slack * time.quantum);
    for (std::size_t k = 0; k < frame.position.size(); ++k)
      CHECK(std::abs(position(i, k) - frame.position[k]) <= slack * position.quantum);
    for (std::size_t k = 0; k < frame.rotation.size(); ++k)
      CHECK(std::abs(rotation(i, k) - frame.rotation[k]) <= slack * rotation.quantum);
    for (std::size_t k = 0; k < frame.bearing_state.size(); ++k)
      CHECK(state(i, k) == static_cast<double>(frame.bearing_state[k]));
    for (std::size_t k = 0; k < frame.bearing_force.size(); ++k)
      CHECK(std::abs(force(i, k) - frame.bearing_force[k]) <= slack * force.quantum);
    const auto row = static_cast<std::size_t>(first(i, 0));
    REQUIRE(first(i + 1, 0) - first(i, 0) == static_cast<double>(frame.contacts.size()));
    for (std::size_t k = 0; k < frame.contacts.size(); ++k) {
      const ContactForce& c = frame.contacts[k];
      CHECK(std::abs(place(row + k, 1) - c.point[1]) <= slack * place.quantum);
      CHECK(std::abs(push(row + k, 0) - c.force[0]) <= slack * push.quantum);
      CHECK(pair(row + k, 0) == c.body_a);
      CHECK(pair(row + k, 2) == static_cast<double>(c.state));
    }
  }
  CHECK(position.quantum <= 1.2 / 2000);
}

TEST_CASE("a run too long for a page keeps every n-th frame and the last, with a notice") {
  const Folder folder;
  write_sample(folder / "run.h5", 41);
  const ResultsReader reader(folder / "run.h5");
  ViewLimits limits;
  limits.node_frames = 41;  // of 123
  limits.contact_rows = 10;
  limits.event_rows = 5;
  const std::string data = view_data(reader, limits), head = head_of(data);
  const Read time(data, "time");
  REQUIRE(time.rows == 15);
  CHECK(near(time(1, 0), 0.03, 1e-12));
  CHECK(near(time(14, 0), 0.4, 1e-12));
  CHECK(head.find("\"frame_stride\":3") != std::string::npos);
  CHECK(head.find("\"events_left_out\":36") != std::string::npos);
  CHECK(Read(data, "contact_pair").rows <= 16);
}

TEST_CASE("the page of a wall of 400 units over 30 s is below 15 MB for any motion") {
  constexpr int units = 400, frames = 600, contacts = 560;
  const Folder folder;
  std::mt19937 random(7);
  std::normal_distribution<double> push(0, 1);
  Header header = sample_header(units);
  header.with_velocity = false;
  header.bearings.clear();
  header.bodies[0].support = "fixed";
  std::vector<double> position = header.node_position, rotation(units);
  std::vector<ContactForce> touching(contacts);
  {
    ResultsWriter writer(folder / "wall.h5", header);
    for (int i = 0; i < frames; ++i) {
      for (double& x : position) x += 0.02 * push(random);
      for (double& a : rotation) a += 0.01 * push(random);
      for (int c = 0; c < contacts; ++c) {
        const int a = c * units / contacts;
        touching[c] = {{position[2 * a] + push(random), position[2 * a + 1], 0},
                       {5e3 * push(random), 5e3, 0},
                       a,
                       (a + 1) % units,
                       results::ContactState::sticking};
      }
      FrameRow row;
      row.time = 0.05 * i;
      row.position = position;
      row.rotation = rotation;
      row.contacts = touching;
      writer.append_frame(row);
    }
    writer.finish();
  }
  const std::string page = view_page(view_data(ResultsReader(folder / "wall.h5")), "wall");
  MESSAGE("page of ", page.size() / 1000, " kB");
  CHECK(page.size() < 15'000'000);
}

TEST_CASE("unusual files give data: no frame, no event, an unfinished run") {
  const Folder folder;
  write_sample(folder / "none.h5", 0);
  CHECK(head_of(view_data(ResultsReader(folder / "none.h5"))).find("\"state\":\"finished\"") != std::string::npos);
  {
    const Header header = sample_header();
    ResultsWriter writer(folder / "cut.h5", header);
    SampleRow(header, 0).append_to(writer);
    writer.flush();
    const std::string data = view_data(ResultsReader(folder / "cut.h5"));
    CHECK(head_of(data).find("\"state\":\"running\"") != std::string::npos);
    CHECK(Read(data, "time").rows == 1);
  }
  CHECK(head_of(view_data(ResultsReader(folder / "cut.h5"))).find("\"state\":\"stopped\"") != std::string::npos);
  { ResultsWriter(folder / "deep.h5", sample_header(2, 3)).finish(); }
  CHECK_THROWS(view_data(ResultsReader(folder / "deep.h5")));
}

TEST_CASE("text of any kind leaves data and page valid") {
  const Folder folder;
  Header header = sample_header();
  header.bodies[0].name = "a \"b\" \\ </script> \n\t\x01 θ";
  { ResultsWriter(folder / "odd.h5", header).finish(); }
  const std::string data = view_data(ResultsReader(folder / "odd.h5"));
  CHECK(head_of(data).find("a \\\"b\\\" \\\\ </script> \\u000a\\u0009\\u0001 θ") != std::string::npos);
  const std::string page = view_page(data, "<b> & co");
  CHECK(page.find("<title>&lt;b&gt; &amp; co") != std::string::npos);
  CHECK(page.find("import ") == std::string::npos);
  CHECK(page.find("\nexport ") == std::string::npos);
  for (const char* outside : {"http:", "https:", "src="}) CHECK(page.find(outside) == std::string::npos);
}

TEST_CASE("a crack lies on the initial joint of two bodies") {
  Header header;
  const std::vector<double> brick{-0.2, -0.1, 0.2, -0.1, 0.2, 0.1, -0.2, 0.1}, none{0.0}, inertia{1.0};
  const auto add = [&](double x, double y) {
    const std::vector<double> at{x, y};
    header.add_rigid_body({"b", "rigid", "brick", "", "free"}, at, none, 1, inertia, brick);
  };
  add(0, 0), add(0.2, 0.2), add(0.4, 0), add(3, 3), add(0.4, 0.2 + 0.4);
  const auto bed = joint_of(header, 0, 1), head = joint_of(header, 0, 2);
  REQUIRE(bed.size() == 1);
  CHECK(bed[0].edge == 2);  // the top, from right to left: its right half
  CHECK(near_zero(bed[0].from, 1e-9));
  CHECK(near(bed[0].to, 0.5, 1e-12));
  REQUIRE(head.size() == 1);
  CHECK(head[0].edge == 1);
  CHECK(near(head[0].to - head[0].from, 1, 1e-12));
  CHECK(joint_of(header, 0, 3).empty());
  CHECK(joint_of(header, 0, 4).empty());
}

TEST_CASE("a crack is drawn on both of its bodies, and each half moves with its body") {
  const Folder folder;
  const auto joints_of = [&](const char* name, const Header& header) {
    {
      ResultsWriter writer(folder / name, header);
      EventRow event;
      event.type = "bond.broken", event.text = "broke", event.body_a = 0, event.body_b = 1;
      writer.append_event(event);
      writer.finish();
    }
    const std::string head = head_of(view_data(ResultsReader(folder / name)));
    const std::size_t from = head.find("\"joints\":");
    REQUIRE(from != std::string::npos);
    return head.substr(from, head.find("\"palette\"") - from);
  };
  Header flat = sample_header(0), solid = sample_header(0, 3);
  const std::vector<double> brick{-0.2, -0.1, 0.2, -0.1, 0.2, 0.1, -0.2, 0.1}, none{0.0}, inertia{1.0};
  for (const double y : {0.0, 0.2}) {
    const std::vector<double> at{0, y};
    flat.add_rigid_body({"b", "rigid", "brick", "", "free"}, at, none, 1, inertia, brick);
    add_box(solid, {{0.2, 0.1, 0.1}, {0, 0, y}});
  }
  for (const std::string& joints : {joints_of("flat.h5", flat), joints_of("solid.h5", solid)}) {
    CHECK(joints.find("[0,0,") != std::string::npos);
    CHECK(joints.find("[0,1,") != std::string::npos);
  }
}

TEST_CASE("the page of a model in space has three coordinates, quaternions, and the faces of each body") {
  const Folder folder;
  record_boxes(folder / "solids.h5", tumbling_boxes(), 6, 0.1);
  const ResultsReader reader(folder / "solids.h5");
  const std::string data = view_data(reader);
  const Read position(data, "position"), rotation(data, "rotation"), force(data, "contact_force");
  REQUIRE(position.columns == 12);
  REQUIRE(rotation.columns == 16);
  const Frame frame = reader.frame(5);
  for (std::size_t k = 0; k < 12; ++k) CHECK(std::abs(position(5, k) - frame.position[k]) <= 0.51 * position.quantum);
  for (std::size_t k = 0; k < 16; ++k) CHECK(std::abs(rotation(5, k) - frame.rotation[k]) <= 0.51 * rotation.quantum);
  CHECK(near(force(0, 2), 80, 1e-3));
  const std::string head = head_of(data);
  CHECK(head.find("\"faces\":[[4,") != std::string::npos);
  CHECK(head.find("\"az\":0.1") != std::string::npos);
}

TEST_CASE("a long history keeps every n-th sample and the last") {
  const Folder folder;
  write_sample(folder / "run.h5", 40);
  ViewLimits limits;
  limits.samples = 10;
  const std::string data = view_data(ResultsReader(folder / "run.h5"), limits), head = head_of(data);
  const std::size_t block = head.find("\"block\":\"") + 9;
  const std::string name = head.substr(block, head.find('"', block) - block);
  const Read time(data, name.substr(0, name.find('.')) + ".time"), values(data, name);
  REQUIRE(values.rows == time.rows);
  CHECK(values.rows == 11);  // 0, 4, ..., 36 and 39
  CHECK(near(time(10, 0), 0.39, 1e-9));
  CHECK(near(values(10, 0), 0.5 * 39, 1e-4));
}

TEST_CASE("rotations are accurate at the far end of the longest body, in any order of bodies") {
  for (const std::array<double, 2>& lengths : {std::array{10.0, 0.2}, std::array{0.2, 10.0}}) {
    const Folder folder;
    Header header = sample_header(0);
    const std::vector<double> none{0.0}, inertia{1.0};
    for (const double l : lengths) {
      const std::vector<double> at{l, 0}, outline{-l / 2, -0.05, l / 2, -0.05, l / 2, 0.05, -l / 2, 0.05};
      header.add_rigid_body({"b", "rigid", "stone", "", "free"}, at, none, 1, inertia, outline);
    }
    {
      ResultsWriter writer(folder / "run.h5", header);
      writer.append_frame(SampleRow(header, 0).frame);
      writer.finish();
    }
    const std::string data = view_data(ResultsReader(folder / "run.h5"));
    const Read position(data, "position"), rotation(data, "rotation");
    CHECK(rotation.quantum * std::hypot(5, 0.05) <= 1.0001 * position.quantum);
  }
}
