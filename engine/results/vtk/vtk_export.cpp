#include "results/vtk/vtk_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "results/file/presence.hpp"
#include "results/vtk/vtk_bodies.hpp"

namespace trilith::results {
namespace {

void append_triple(std::vector<double>& to, const double (&v)[3]) {
  to.insert(to.end(), v, v + 3);
}

/// A row of dim numbers as three numbers.
void append_row(std::vector<double>& to, const std::vector<double>& rows, std::size_t row, int dim) {
  for (int k = 0; k < 3; ++k) to.push_back(k < dim ? rows[row * static_cast<std::size_t>(dim) + k] : 0);
}

/// Cells of `corners` points each, consecutive.
struct PointCells {
  PointCells(std::size_t cells, std::int32_t corners) {
    std::vector<std::int32_t> at, ends;
    for (std::size_t i = 0; i < cells; ++i) ends.push_back(static_cast<std::int32_t>(i + 1) * corners);
    for (std::size_t i = 0; i < cells * static_cast<std::size_t>(corners); ++i)
      at.push_back(static_cast<std::int32_t>(i));
    connectivity = vtk_integers("connectivity", at);
    offsets = vtk_integers("offsets", ends);
  }
  VtkArray connectivity, offsets;
};

std::vector<const VtkArray*> all_of(const std::vector<VtkArray>& arrays) {
  std::vector<const VtkArray*> out;
  for (const VtkArray& a : arrays) out.push_back(&a);
  return out;
}

/// Contact forces as points.
std::string contacts_file(const Header& header, const Frame& frame) {
  std::vector<double> place, force, area, normal;
  std::vector<std::int32_t> body_a, body_b;
  std::vector<std::int8_t> state;
  for (const ContactForce& c : frame.contacts) {
    append_triple(place, c.point), append_triple(force, c.force), append_triple(normal, c.normal);
    area.push_back(c.area);
    body_a.push_back(c.body_a), body_b.push_back(c.body_b);
    state.push_back(static_cast<std::int8_t>(c.state));
  }
  std::vector<VtkArray> data{vtk_numbers("force", 3, force), vtk_bytes("state", state), vtk_integers("body_a", body_a),
                             vtk_integers("body_b", body_b)};
  if (header.dim == 3) {
    data.push_back(vtk_numbers("area", 1, area));
    data.push_back(vtk_numbers("normal", 3, normal));
  }
  const VtkArray points = vtk_coordinates(place);
  const PointCells cells(frame.contacts.size(), 1);
  return vtk_file(
      "PolyData", {{"NumberOfPoints", frame.contacts.size()}, {"NumberOfVerts", frame.contacts.size()}},
      {{"PointData", all_of(data)}, {"Points", {&points}}, {"Verts", {&cells.connectivity, &cells.offsets}}},
      frame.time);
}

/// Bearings as lines from the point on body a to the point on body b.
std::string bearings_file(const Header& header, const Frame& frame) {
  const Placement at(header, frame);
  std::vector<double> place, force, displacement;
  std::vector<std::int32_t> body_a, body_b;
  std::vector<std::int8_t> state;
  std::vector<std::string> name;
  for (std::size_t i = 0; i < header.bearings.size(); ++i) {
    const BearingRow& b = header.bearings[i];
    for (const Vec3& end :
         {at.end_of(header.bodies[b.body_a], b.point_a), at.end_of(header.bodies[b.body_b], b.point_b)})
      place.insert(place.end(), {end.x(), end.y(), end.z()});
    append_row(force, frame.bearing_force, i, header.dim);
    append_row(displacement, frame.bearing_displacement, i, header.dim);
    body_a.push_back(b.body_a), body_b.push_back(b.body_b);
    state.push_back(static_cast<std::int8_t>(frame.bearing_state[i]));
    name.push_back(b.name);
  }
  const std::vector<VtkArray> data{vtk_numbers("force", 3, force), vtk_numbers("displacement", 3, displacement),
                                   vtk_bytes("state", state),      vtk_integers("body_a", body_a),
                                   vtk_integers("body_b", body_b), vtk_texts("name", name)};
  const VtkArray points = vtk_coordinates(place);
  const PointCells cells(header.bearings.size(), 2);
  return vtk_file("PolyData",
                  {{"NumberOfPoints", 2 * header.bearings.size()}, {"NumberOfLines", header.bearings.size()}},
                  {{"CellData", all_of(data)}, {"Points", {&points}}, {"Lines", {&cells.connectivity, &cells.offsets}}},
                  frame.time);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
}

/// [body] true for an absent body, which is not a cell.
std::vector<bool> absent_at(const Presence& presence, const Header& header, double time) {
  std::vector<bool> absent(header.bodies.size());
  for (std::size_t i = 0; i < absent.size(); ++i) absent[i] = !presence.is_there(i, time);
  return absent;
}

/// The files of one kind, and the list of them.
class Series {
 public:
  Series(std::filesystem::path folder, std::string name, const char* ending)
      : folder_(std::move(folder)), name_(std::move(name)), ending_(ending) {
    make_folder(folder_ / name_);
  }
  /// At the change of stages there are two frames with the same time: the later one counts.
  void add(std::size_t frame, double time, const std::string& bytes) {
    const std::string file = fmt::format("{}/{:06}.{}", name_, frame, ending_);
    write_whole_file(folder_ / file, bytes);
    if (!files_.empty() && files_.back().first == time) files_.pop_back();
    files_.emplace_back(time, file);
  }
  std::filesystem::path finish() const {
    const std::filesystem::path path = folder_ / (name_ + ".pvd");
    write_whole_file(path, vtk_series(files_));
    return path;
  }

 private:
  std::filesystem::path folder_;
  std::string name_;
  const char* ending_;
  std::vector<std::pair<double, std::string>> files_;
};

}  // namespace

std::vector<std::filesystem::path> export_vtk(const ResultsReader& reader, const std::filesystem::path& folder,
                                              const FrameRange& range, const std::function<void(double)>& progress) {
  const Header& header = reader.header();
  if (reader.frame_count() == 0)
    throw ResultsError(fmt::format("results file '{}': there is no frame to export", reader.path().string()));
  const std::size_t last = std::min(range.to, reader.frame_count() - 1);
  if (range.from > last || range.every == 0)
    throw ResultsError(fmt::format("results file '{}': no frame is in the range; frames count from 0 to {}",
                                   reader.path().string(), reader.frame_count() - 1));
  std::string name = reader.path().filename().string();
  name.resize(name.find(".h5") == std::string::npos ? name.size() : name.rfind(".h5"));
  const Presence presence(reader.events(), header.bodies.size());
  std::vector<bool> left_out = absent_at(presence, header, reader.frame_times()[range.from]);
  VtkBodies cells(header, left_out);
  Series bodies(folder, name + "_bodies", "vtu"), contacts(folder, name + "_contacts", "vtp");
  std::optional<Series> bearings;
  if (!header.bearings.empty()) bearings.emplace(folder, name + "_bearings", "vtp");
  for (std::size_t i = range.from; i <= last; i += range.every) {
    const Frame frame = reader.frame(i);
    if (const std::vector<bool> now = absent_at(presence, header, frame.time); now != left_out) {
      left_out = now;
      cells = VtkBodies(header, left_out);
    }
    bodies.add(i, frame.time, cells.file(frame));
    contacts.add(i, frame.time, contacts_file(header, frame));
    if (bearings) bearings->add(i, frame.time, bearings_file(header, frame));
    if (progress) progress(static_cast<double>(i - range.from + 1) / static_cast<double>(last - range.from + 1));
    if (last - i < range.every) break;  // a large `every` must not overflow
  }
  std::vector<std::filesystem::path> written{bodies.finish(), contacts.finish()};
  if (bearings) written.push_back(bearings->finish());
  return written;
}

}  // namespace trilith::results
