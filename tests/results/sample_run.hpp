// A small invented run whose numbers follow from the frame alone, so that any reader can check them.
#pragma once

#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "results/file/writer.hpp"
#include "results/reading/reader.hpp"

namespace trilith::testing {

/// A temporary folder, removed at the end.
struct Folder {
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "trilith-results-XXXXXX").string();
    path = ::mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path / name; }
  std::filesystem::path path;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// `bodies` blocks of 1 m x 2 m, a bearing between neighbours, two histories, two energy terms.
inline results::Header sample_header(int bodies = 3, int dim = 2) {
  results::Header header;
  header.dim = dim;
  header.with_velocity = true;
  header.provenance = {"-- bridge.lua\nlocal θ = 3\n",
                       "scripts/bridge.lua",
                       "1.0.0",
                       "abc123",
                       "g++ 12.2",
                       "Linux x86_64",
                       "2025-11-21T09:30:00Z",
                       "trilith run scripts/bridge.lua pga=0.6",
                       {{"pga", "0.6", "g", "0.35", "peak ground acceleration"}},
                       {"ground 1: El Centro 1940 NS, 0.35 g", "ground 2: same, reversed"},
                       "",
                       ""};
  for (int i = 0; i < bodies; ++i) {
    const double place[3] = {2.0 * i, 0.5, 0}, turn[4] = {dim == 2 ? 0.0 : 1.0, 0, 0, 0}, inertia[3] = {8, 9, 10};
    const std::vector<double> outline = dim == 2 ? std::vector<double>{-0.5, -1, 0.5, -1, 0.5, 1, -0.5, 1}
                                                 : std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    header.add_rigid_body(
        {"span " + std::to_string(i + 1), "rigid", "concrete", "spans deck", i == 0 ? "fixed" : "free"},
        {place, static_cast<std::size_t>(dim)}, {turn, static_cast<std::size_t>(results::rotation_width(dim))},
        100.0 + i, {inertia, static_cast<std::size_t>(results::spin_width(dim))}, outline);
  }
  header.laws = {{"concrete", "material", "", "", "density 2400 kg/m^3"},
                 {"friction", "contact", "concrete", "ground", "mu 0.6, Kn 1e10 Pa/m"}};
  for (int i = 0; i + 1 < bodies; ++i)
    header.bearings.push_back(
        {"bearing " + std::to_string(i + 1), i, i + 1, {0.5, 1, 0}, {-0.5, 1, 0}, "fixed, limit 0.05 m"});
  header.histories = {{"top.x", "m", "displacement of the top"}, {"base shear", "N", "sum at the base"}};
  header.energy_terms = {{"kinetic", "J", "kinetic energy"}, {"input", "J", "work of the ground"}};
  return header;
}

/// Row number `i` of all datasets.
struct SampleRow {
  SampleRow(const results::Header& header, int i) : time(0.01 * i) {
    const auto fill = [&](std::vector<double>& to, std::size_t size, double base) {
      for (std::size_t k = 0; k < size; ++k) to.push_back(base + 1000.0 * i + static_cast<double>(k) / 7);
    };
    const auto dim = static_cast<std::size_t>(header.dim);
    const std::size_t nodes = header.node_count(), bearings = header.bearings.size();
    fill(position, nodes * dim, 1);
    fill(rotation, nodes * static_cast<std::size_t>(results::rotation_width(header.dim)), 2);
    fill(velocity, nodes * dim, 3);
    fill(spin, nodes * static_cast<std::size_t>(results::spin_width(header.dim)), 4);
    fill(force, bearings * dim, 5);
    fill(displacement, bearings * dim, 6);
    for (std::size_t b = 0; b < bearings; ++b)
      state.push_back(static_cast<results::BearingState>((i + static_cast<int>(b)) % 4));
    for (int c = 0; c < i % 4; ++c)
      contacts.push_back({{1.0 * i, 2.0 * c, header.dim == 3 ? 3.0 : 0.0},
                          {-1.5 * i, 4, 0},
                          c % 2,
                          1 + c % 2,
                          results::ContactState(c % 3)});
    frame = {time, 10 * i, 0, position, rotation, velocity, spin, contacts, state, force, displacement};
    history = {0.5 * i, -3.0 * i};
    energy = {1.0 * i, 2.0 * i};
    event.id = i;
    event.time = time;
    event.step = 10 * i;
    event.type = "bearing.failed";
    event.body_a = 0;
    event.body_b = 1;
    event.bearing = 0;
    event.has_place = true;
    event.place[0] = 7.5;
    event.first = {"displacement", "m", 0.05 + i};
    event.cause = i - 1;
    event.text = "the bearing reached its limit";
  }

  void append_to(results::ResultsWriter& writer) const {
    writer.append_frame(frame);
    writer.append_history(time, history);
    writer.append_energy(time, energy, 1e-9);
    writer.append_event(event);
  }

  SampleRow(const SampleRow&) = delete;
  SampleRow& operator=(const SampleRow&) = delete;

  double time;
  std::vector<double> position, rotation, velocity, spin, force, displacement;
  std::vector<results::BearingState> state;
  std::vector<results::ContactForce> contacts;
  results::FrameRow frame;
  std::array<double, 2> history, energy;
  results::EventRow event;
};

/// True if the reader returns row `i` of all datasets, to the bit.
inline bool has_row(const results::ResultsReader& reader, int i) {
  const SampleRow row(reader.header(), i);
  const auto at = static_cast<std::size_t>(i);
  const results::Frame frame = reader.frame(at);
  const auto same = [](const results::ContactForce& a, const results::ContactForce& b) {
    return std::equal(a.point, a.point + 3, b.point) && std::equal(a.force, a.force + 3, b.force) &&
           a.body_a == b.body_a && a.body_b == b.body_b && a.state == b.state;
  };
  return frame.time == row.time && frame.step == row.frame.step && frame.position == row.position &&
         frame.rotation == row.rotation && frame.velocity == row.velocity && frame.spin == row.spin &&
         frame.bearing_state == row.state && frame.bearing_force == row.force &&
         frame.bearing_displacement == row.displacement &&
         std::equal(frame.contacts.begin(), frame.contacts.end(), row.contacts.begin(), row.contacts.end(), same);
}

}  // namespace trilith::testing
