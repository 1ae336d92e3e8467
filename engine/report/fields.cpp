// Temperatures, and water in joints, at the end of a run.
#include <algorithm>
#include <array>

#include "draw/results/results_picture.hpp"
#include "report/sections.hpp"
#include "results/file/field_names.hpp"

namespace trilith::report {
namespace {

struct FieldPicture {
  std::string_view field, colour, caption;
};
constexpr std::array<FieldPicture, 2> field_pictures{
    {{results::node_temperature, "temperature", "Temperatures at the end."},
     {results::water_cell, "water", "Pressure of the water in joints at the end."}}};

/// True where the last frame has a temperature, or a cell of a joint with a place.
bool has_values(const ReportSource& source, const FieldPicture& picture) {
  const auto& fields = source.header.fields;
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const results::Field& f) { return f.name == picture.field; });
  if (found == fields.end() || source.reader.frame_count() == 0) return false;
  if (picture.field == results::water_cell && source.header.dim == 3) return false;
  const results::Frame last = source.reader.frame(source.reader.frame_count() - 1);
  const std::vector<double>& values = last.fields[static_cast<std::size_t>(found - fields.begin())];
  const double none = picture.field == results::node_temperature ? results::no_temperature : 0;
  return std::any_of(values.begin(), values.end(), [&](double v) { return v != none; });
}

}  // namespace

void write_fields(const ReportSource& source, HtmlText& html) {
  bool is_first = true;
  for (const FieldPicture& picture : field_pictures) {
    if (!has_values(source, picture)) continue;
    if (is_first) html.element("h2", "Temperatures and water");
    is_first = false;
    draw::SceneChoice choice;
    choice.origin = source.origin, choice.colour = std::string(picture.colour);
    write_figure(html, picture.colour, std::string(picture.caption), [&] {
      draw::PictureStyle style;
      style.units = source.units;
      return draw::scene_canvas({draw::results_scene(source.reader, source.reader.frame_times().back(), choice)}, 1,
                                style);
    });
  }
}

}  // namespace trilith::report
