#include "view/data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "view/model.hpp"
#include "view/modes.hpp"

namespace trilith::view {
namespace {

constexpr std::uint32_t data_version = 1;

void put_number(std::uint32_t number, std::string& out) {
  for (int shift = 0; shift < 32; shift += 8)
    out += static_cast<char>(static_cast<unsigned char>(number >> shift & 255));
}

/// One column of samples with the given stride, and the last; 50,000 steps over its range, `no_sample` for NaN.
ViewBlock samples(const std::string& name, const std::vector<double>& values, std::size_t stride) {
  constexpr double parts = 50000;
  double largest = 0;
  for (const double v : values) largest = std::isfinite(v) ? std::max(largest, std::abs(v)) : largest;
  ViewBlock block{name, 1, largest > 0 ? largest / parts : 1, {}};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % stride == 0 || i + 1 == values.size())
      block.values.push_back(std::isnan(values[i]) ? no_sample : quantised(values[i], block.quantum));
  return block;
}

/// Histories and energy: descriptions in `json`, numbers in blocks.
class Series {
 public:
  Series(const ViewLimits& limits, JsonText& json, std::vector<ViewBlock>& blocks)
      : limits_(limits), json_(json), blocks_(blocks) {}

  void begin(const std::string& group, const std::vector<double>& time) {
    group_ = group;
    stride_ = std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(time.size()) / limits_.samples));
    blocks_.push_back(samples(group + ".time", time, stride_));
    blocks_.back().quantum = 1e-6;
    blocks_.back().values.clear();
    for (std::size_t i = 0; i < time.size(); ++i)
      if (i % stride_ == 0 || i + 1 == time.size()) blocks_.back().values.push_back(quantised(time[i], 1e-6));
  }

  void add(const results::Quantity& quantity, const std::vector<double>& values) {
    const std::string block = fmt::format("{}.{}", group_, blocks_.size());
    json_.begin_object().text("group", group_).text("name", quantity.name).text("unit", quantity.unit);
    json_.text("text", quantity.description).text("block", block).end();
    blocks_.push_back(samples(block, values, stride_));
  }

 private:
  const ViewLimits& limits_;
  JsonText& json_;
  std::vector<ViewBlock>& blocks_;
  std::string group_;
  std::size_t stride_ = 1;
};

void write_series(const results::ResultsReader& reader, const ViewLimits& limits, JsonText& json,
                  std::vector<ViewBlock>& blocks) {
  const results::Header& header = reader.header();
  json.key("series").begin_list();
  Series series(limits, json, blocks);
  if (!header.histories.empty()) series.begin("history", reader.history_times());
  for (const results::Quantity& q : header.histories) series.add(q, reader.history(q.name));
  const results::EnergyTable energy = reader.energy();
  if (!energy.time.empty()) series.begin("energy", energy.time);
  if (!energy.time.empty())
    for (std::size_t i = 0; i < header.energy_terms.size(); ++i) series.add(header.energy_terms[i], energy.terms[i]);
  if (!energy.time.empty()) series.add({"residual", "J", "error of the energy balance"}, energy.residual);
  json.end();
}

/// For each unit of the page and of the histories its SI value in the units of the page, and its name there.
void write_units(const results::ResultsReader& reader, const UnitSystem& units, JsonText& json) {
  if (units.is_si()) return;
  std::set<std::string> names{"m", "m/s", "m/s2", "N", "N m", "N/m", "N*m", "Pa", "J", "kg", "1/m"};
  for (const results::Quantity& q : reader.header().histories) names.insert(q.unit);
  json.key("units").begin_object();
  for (const std::string& name : names)
    if (const auto own = units.unit_for(name))
      json.key(name).begin_list().number(own->factor).text(printed_unit(own->name)).end();
  json.end();
}

}  // namespace

std::string view_data(const results::ResultsReader& reader, const ViewLimits& limits, const ViewProgress& progress,
                      const results::TimeOrigin& origin, const UnitSystem& units) {
  if (reader.header().dim == 3 && reader.header().face_count() == 0 && reader.header().sphere_vertex.empty())
    throw InputError(
        fmt::format("'{}' contains no faces of solids, so there is nothing to show", reader.path().string()));
  ViewFrames frames = view_frames(reader, limits, progress);
  JsonText json;
  json.begin_object();
  json.key("origin").begin_object().number("zero", origin.zero).text("since", origin.since).end();
  write_units(reader, units, json);
  write_view_model(reader, frames, limits, units, json);
  std::vector<ViewBlock>& blocks = frames.blocks;
  write_series(reader, limits, json, blocks);
  write_modes(reader, json, blocks);
  json.key("blocks").begin_list();
  std::string bytes;
  for (const ViewBlock& block : blocks) {
    const std::string piece = packed(block);
    json.begin_object().text("name", block.name).number("rows", static_cast<double>(block.rows()));
    json.number("columns", static_cast<double>(block.columns)).number("quantum", block.quantum);
    json.number("bytes", static_cast<double>(piece.size())).end();
    bytes += piece;
  }
  json.end().end();
  const std::string head = json.take();
  std::string out = "TRLV";
  put_number(data_version, out);
  put_number(static_cast<std::uint32_t>(head.size()), out);
  return out + head + bytes;
}

}  // namespace trilith::view
