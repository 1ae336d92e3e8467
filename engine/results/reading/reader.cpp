#include "results/reading/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "results/file/clean_copy.hpp"
#include "results/file/open_written.hpp"
#include "results/file/part_file.hpp"
#include "results/reading/header_reading.hpp"
#include "results/reading/set_reading.hpp"

namespace trilith::results {
namespace {

void require_hdf5(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw h5::Failure("is a folder");
  std::ifstream stream(path, std::ios::binary);
  char head[8] = {};
  stream.read(head, sizeof head);
  if (!stream && !stream.eof()) throw h5::Failure(fmt::format("cannot be read: {}", std::strerror(errno)));
  if (stream.gcount() == 0) throw h5::Failure("is empty");
  if (stream.gcount() < 8 || std::memcmp(head, "\x89HDF\r\n\x1a\n", 8) != 0)
    throw h5::Failure("is not an HDF5 file, so it is not a results file");
}

void require_ours(hid_t file) {
  if (!h5::has_attribute(file, "format") || h5::read_text(file, "format") != "trilith")
    throw h5::Failure("is an HDF5 file, but not Trilith results (no attribute format = 'trilith')");
  const int version = h5::read_int(file, "format_version");
  if (version > format_version)
    throw h5::Failure(fmt::format("is written by a newer program (format {}, this one reads up to {}); update", version,
                                  format_version));
}

/// Why the part of a run cannot be read. The file contains the model and the tables before its first rows are written.
std::string unfinished_text(const std::filesystem::path& path, const std::string& why) {
  if (is_being_written(path))
    return fmt::format("cannot be read yet, as its run has just begun; try again in a moment ({})", why);
  return fmt::format(
      "cannot be read: its run was stopped before the first rows were written, or the file is damaged; run the script "
      "again ({})",
      why);
}

std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b, double weight) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + weight * (b[i] - a[i]);
  return result;
}

// Normalised linear interpolation along the shorter arc; `a` and `b` hold w, x, y, z of every node.
std::vector<double> between_quaternions(const std::vector<double>& a, const std::vector<double>& b, double weight) {
  std::vector<double> result(a.size());
  for (std::size_t at = 0; at + 4 <= a.size(); at += 4) {
    double dot = 0, square = 0;
    for (std::size_t i = at; i < at + 4; ++i) dot += a[i] * b[i];
    const double sign = dot < 0 ? -1 : 1;
    for (std::size_t i = at; i < at + 4; ++i) {
      result[i] = (1 - weight) * a[i] + sign * weight * b[i];
      square += result[i] * result[i];
    }
    for (std::size_t i = at; i < at + 4 && square > 0; ++i) result[i] /= std::sqrt(square);
  }
  return result;
}

}  // namespace

class ResultsReader::Body {
 public:
  explicit Body(const std::filesystem::path& name) : path(name) {
    std::error_code error;
    if (!std::filesystem::exists(path, error) && std::filesystem::exists(part_path(path), error))
      path = part_path(path);
    if (!std::filesystem::exists(path, error))
      throw ResultsError(fmt::format("results file '{}': there is no such file", path.string()));
    open();
  }

  // Adds the file name to all errors.
  template <class Action>
  auto guarded(Action action) const {
    const h5::Quiet quiet;
    try {
      return action();
    } catch (const h5::Failure& failure) {
      throw ResultsError(fmt::format("results file '{}': {}", path.string(), failure.what()));
    } catch (const std::bad_alloc&) {
      throw ResultsError(fmt::format("results file '{}': is damaged or too large for the memory", path.string()));
    } catch (const std::length_error&) {
      throw ResultsError(fmt::format("results file '{}': is damaged or too large for the memory", path.string()));
    }
  }

  void open() {
    guarded([&] {
      try {
        open_begun();
      } catch (const h5::Failure& failure) {
        if (path.extension() != ".part") throw;
        throw h5::Failure(unfinished_text(path, failure.what()));
      }
    });
  }
  void open_begun() {
    require_hdf5(path);
    file = {};
    file = open_written(path);
    require_ours(file.get());
    finished = h5::read_int(file.get(), "finished") == 1;
    header = read_header(file.get());
    committed = read_committed(file.get());
    times = numbers("/frames/time", committed.frames);
  }

  std::vector<double> numbers(const std::string& set, std::int64_t rows) const {
    return read_rows<double>(file.get(), set, 0, rows, {});
  }

  std::filesystem::path path;
  h5::Handle file;
  bool finished = false;
  Header header;
  Committed committed;
  std::vector<double> times;
};

ResultsReader::ResultsReader(const std::filesystem::path& path) : body_(std::make_unique<Body>(path)) {}
ResultsReader::~ResultsReader() = default;
ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;
ResultsReader& ResultsReader::operator=(ResultsReader&&) noexcept = default;

const std::filesystem::path& ResultsReader::path() const {
  return body_->path;
}
bool ResultsReader::finished() const {
  return body_->finished;
}
bool ResultsReader::running() const {
  return is_being_written(body_->path);
}
bool ResultsReader::newer_part() const {
  const std::filesystem::path part = part_path(body_->path);
  std::error_code error, none;
  const auto written = std::filesystem::last_write_time(part, none);
  return !none && written >= std::filesystem::last_write_time(body_->path, error);
}
bool ResultsReader::newer_part_running() const {
  return newer_part() && is_being_written(part_path(body_->path));
}
void ResultsReader::refresh() {
  body_->open();
}
const Header& ResultsReader::header() const {
  return body_->header;
}
std::size_t ResultsReader::frame_count() const {
  return body_->times.size();
}
const std::vector<double>& ResultsReader::frame_times() const {
  return body_->times;
}

Frame ResultsReader::frame(std::size_t index) const {
  if (index >= frame_count())
    throw ResultsError(
        fmt::format("results file '{}': there is no frame {}; it has {}", path().string(), index, frame_count()));
  return body_->guarded([&] { return read_frame(body_->file.get(), body_->header, body_->committed, index); });
}

std::size_t ResultsReader::nearest_frame(double time) const {
  const std::vector<double>& times = body_->times;
  if (times.empty()) throw ResultsError(fmt::format("results file '{}': there is no frame yet", path().string()));
  const auto after = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
  if (after == 0) return 0;
  if (after == times.size()) return after - 1;
  return time - times[after - 1] <= times[after] - time ? after - 1 : after;
}

Frame ResultsReader::frame_at(double time) const {
  const std::vector<double>& times = body_->times;
  Frame result = frame(nearest_frame(time));
  if (!(time > times.front() && time < times.back())) return result;
  const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  const Frame a = frame(after - 1), b = frame(after);
  const double weight = (time - a.time) / (b.time - a.time);
  result.time = time;
  result.position = between(a.position, b.position, weight);
  result.velocity = between(a.velocity, b.velocity, weight);
  result.spin = between(a.spin, b.spin, weight);
  result.stress = between(a.stress, b.stress, weight);
  result.plastic = between(a.plastic, b.plastic, weight);
  result.rotation =
      header().dim == 2 ? between(a.rotation, b.rotation, weight) : between_quaternions(a.rotation, b.rotation, weight);
  return result;
}

std::vector<double> ResultsReader::history_times() const {
  return body_->guarded([&] { return body_->numbers("/histories/time", body_->committed.histories); });
}

std::vector<double> ResultsReader::history(std::string_view name) const {
  std::vector<std::string> known;
  for (const Quantity& quantity : header().histories) known.push_back(quantity.name);
  if (known.empty()) throw ResultsError(fmt::format("results file '{}': it has no histories", path().string()));
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw ResultsError(
        fmt::format("results file '{}': there is no history '{}'{}", path().string(), name, name_hint(name, known)));
  return body_->guarded([&] { return body_->numbers("/histories/" + std::string(name), body_->committed.histories); });
}

std::vector<EventRow> ResultsReader::events() const {
  return body_->guarded(
      [&] { return read_table<EventRow>(body_->file.get(), "/events", 0, body_->committed.events, header().dim); });
}

EnergyTable ResultsReader::energy() const {
  return body_->guarded([&] {
    const std::int64_t rows = body_->committed.energy;
    EnergyTable table;
    table.time = body_->numbers("/energy/time", rows);
    for (const Quantity& term : header().energy_terms)
      table.terms.push_back(body_->numbers("/energy/" + term.name, rows));
    table.residual = body_->numbers("/energy/residual", rows);
    return table;
  });
}

std::vector<StageRow> ResultsReader::stages() const {
  return body_->guarded(
      [&] { return read_table<StageRow>(body_->file.get(), "/stages", 0, body_->committed.stages, header().dim); });
}

std::vector<Note> ResultsReader::notes() const {
  return body_->guarded([&] {
    std::vector<Note> notes;
    for (NoteRow& row :
         read_table<NoteRow>(body_->file.get(), "/provenance/notes", 0, body_->committed.notes, header().dim))
      notes.push_back({row.time, std::move(row.text)});
    return notes;
  });
}

std::vector<SealRow> ResultsReader::seal() const {
  return body_->guarded([&]() -> std::vector<SealRow> {
    const hid_t file = body_->file.get();
    if (H5Lexists(file, "/seal", H5P_DEFAULT) <= 0) return {};
    return read_table<SealRow>(file, "/seal", header().dim);
  });
}

std::vector<ModeRow> ResultsReader::modes() const {
  return body_->guarded([&]() -> std::vector<ModeRow> {
    const hid_t file = body_->file.get();
    if (H5Lexists(file, "/modes", H5P_DEFAULT) <= 0) return {};
    const Header& h = header();
    auto rows = read_table<ModeRow>(file, "/modes/list", 0, body_->committed.modes, h.dim);
    const auto block = [&](const char* set, std::size_t row, int width) {
      std::vector<hsize_t> shape = {h.node_count()};
      if (width > 1) shape.push_back(static_cast<hsize_t>(width));
      return read_rows<double>(file, set, static_cast<std::int64_t>(row), 1, shape);
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].position = block("/modes/position", i, h.dim);
      rows[i].rotation = block(h.dim == 2 ? "/modes/angle" : "/modes/quaternion", i, rotation_width(h.dim));
      rows[i].displacement = block("/modes/displacement", i, h.dim);
      rows[i].turn = block("/modes/rotation", i, spin_width(h.dim));
    }
    return rows;
  });
}

std::string ResultsReader::title() const {
  const std::string& name = header().provenance.model;
  return name.empty() ? (finished() ? path() : path().stem()).stem().string() : name;
}

UnitSystem ResultsReader::units() const {
  try {
    return UnitSystem(header().provenance.units, "provenance");
  } catch (const InputError& e) {
    throw ResultsError(fmt::format("results file '{}': {}", path().string(), e.what()));
  }
}

std::vector<MotionRow> ResultsReader::motions() const {
  return body_->guarded([&]() -> std::vector<MotionRow> {
    const hid_t file = body_->file.get();
    if (H5Lexists(file, "/motions", H5P_DEFAULT) <= 0) return {};
    const Committed& safe = body_->committed;
    auto rows = read_table<MotionRow>(file, "/motions/list", 0, safe.motions, header().dim);
    for (MotionRow& row : rows) {
      if (row.first_sample < 0 || row.sample_count < 0 || row.sample_count > safe.motion_samples - row.first_sample)
        throw h5::Failure("a motion has samples that do not exist");
      row.acceleration = read_rows<double>(file, "/motions/acceleration", row.first_sample, row.sample_count, {});
    }
    return rows;
  });
}

void repair(const std::filesystem::path& from, const std::filesystem::path& to) {
  const ResultsReader reader(from);
  require_writable(to);
  std::error_code error;
  if (std::filesystem::equivalent(reader.path(), to, error))
    throw ResultsError(fmt::format("results file '{}': cannot be repaired in place; name another file", to.string()));
  reader.body_->guarded([&] { write_clean_copy(reader.body_->file.get(), to, reader.finished()); });
}

}  // namespace trilith::results
