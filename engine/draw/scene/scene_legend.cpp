#include "draw/scene/scene_legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/quantity_text.hpp"
#include "draw/chart/axis_ticks.hpp"
#include "draw/members/scene_diagrams.hpp"
#include "draw/scene/scene_faces.hpp"
#include "draw/scene/scene_marks.hpp"

namespace trilith::draw {
namespace {

LegendItem scale_bar(double scale, const PictureStyle& style) {
  const auto own = style.units.unit_for("m");
  const double unit = own ? own->factor : 1, longest = 0.16 * style.width;
  const double shown = nice_at_most(longest / scale / unit), length = shown * unit * scale;
  return {length,
          [=](Canvas& c, const PagePoint& at) {
            const Stroke stroke{palette().ink, 0.8};
            const PagePoint end = at + PagePoint(length, 0);
            c.line(at, end, stroke);
            for (const PagePoint& p : {at, PagePoint(end), PagePoint((at + end) / 2)}) {
              const double tall = p == PagePoint((at + end) / 2) ? 1.3 : 2.6;
              c.line(p - PagePoint(0, tall), p + PagePoint(0, tall), stroke);
            }
          },
          // For a structure 0.5 m is clearer than 500 mm.
          own || (shown >= 0.01 && shown < 1000) ? fmt::format("{:g} {}", shown, style.units.name("m"))
                                                 : quantity_text(shown, "m")};
}

/// The colour of a solid as its faces show it, from full light to shade.
void draw_shades(Canvas& canvas, const PagePoint& at, const Colour& fill) {
  constexpr double lights[] = {1, 0.7, 0.4};
  for (int i = 0; i < 3; ++i)
    canvas.rectangle({at.x() + 13.0 * i / 3, at.y() - 4, at.x() + 13.0 * (i + 1) / 3, at.y() + 4}, lit(fill, lights[i]),
                     std::nullopt);
  canvas.rectangle({at.x(), at.y() - 4, at.x() + 13, at.y() + 4}, std::nullopt, Stroke{palette().outline, 0.5});
}

LegendItem swatch(const SceneView& view, const BodyGroup& group) {
  const Colour fill = group_fill(view, group);
  const bool ground = group.first != BodyRole::free && !view.has_faces;
  const double degrees = hatch_direction(view, group);
  const bool shaded = view.has_faces;
  return {13,
          [=](Canvas& c, const PagePoint& at) {
            const double x = at.x(), y = at.y();
            const std::vector<PagePoint> box = {{x, y - 4}, {x + 13, y - 4}, {x + 13, y + 4}, {x, y + 4}};
            if (ground)
              draw_ground(c, box, degrees, {palette().ground_outline, 0.5});
            else if (shaded)
              draw_shades(c, at, fill);
            else
              c.polygon(box, fill, Stroke{palette().outline, 0.5});
          },
          group_text(group)};
}

/// One for each group; shaded ground has one colour, and so one entry for all of it.
std::vector<LegendItem> swatches(const SceneView& view) {
  std::vector<LegendItem> items;
  std::optional<std::size_t> shaded;
  for (const BodyGroup& group : view.groups) {
    const bool joins = view.has_faces && group.first != BodyRole::free;
    if (joins && shaded) {
      items[*shaded].text += ", " + group_text(group);
      continue;
    }
    if (joins) shaded = items.size();
    items.push_back(swatch(view, group));
  }
  return items;
}

LegendItem bearing_item(BearingMark state) {
  return {7, [=](Canvas& c, const PagePoint& at) { draw_bearing_mark(c, at + PagePoint(3.5, 0), state); },
          bearing_text(state)};
}

LegendItem force_item(const SceneView& view, double scale, const UnitSystem& units) {
  const auto own = units.unit_for("N");
  const double unit = own ? own->factor : 1;
  const double shown = nice_at_most(view.largest_force / unit) * unit;
  const double length = view.longest_arrow * scale * shown / view.largest_force;
  const bool bars = view.bars;
  return {length, [=](Canvas& c, const PagePoint& at) { draw_force(c, at, at + PagePoint(length, 0), bars); },
          fmt::format("contact force {} (largest {})", quantity_text(shown, "N", units),
                      quantity_text(view.largest_force, "N", units))};
}

LegendItem colour_bar(const SceneView& view, const Scene& scene, const PictureStyle& style) {
  const ShownUnit unit =
      engineering_unit(std::max(std::abs(view.low), std::abs(view.high)), scene.value_unit, style.units);
  const TextStyle text{style.font_size - 0.5};
  const std::string low = quantity_text(view.low / unit.size, ""), high = quantity_text(view.high / unit.size, "");
  const double left = text_width(low, text) + 3, bar = 80, width = left + bar + 3 + text_width(high, text);
  return {width,
          [=](Canvas& c, const PagePoint& at) {
            constexpr int steps = 40;
            for (int i = 0; i < steps; ++i) {
              const double share = (i + 0.5) / steps, x = at.x() + left + bar * i / steps;
              // Each step extends below the next: no gaps between them at any resolution.
              const double end = std::min(x + 1.5 * bar / steps, at.x() + left + bar);
              c.rectangle({x, at.y() - 3.5, end, at.y() + 3.5}, value_colour(view, share), std::nullopt);
            }
            c.rectangle({at.x() + left, at.y() - 3.5, at.x() + left + bar, at.y() + 3.5}, std::nullopt,
                        Stroke{palette().outline, 0.4});
            c.text(at + PagePoint(0, 0.36 * text.size), low, text);
            c.text(at + PagePoint(left + bar + 3, 0.36 * text.size), high, text);
          },
          unit.text.empty() ? scene.value_label : fmt::format("{} ({})", scene.value_label, unit.text)};
}

LegendItem hinge_item(HingeMark state) {
  return {7, [=](Canvas& c, const PagePoint& at) { draw_hinge_mark(c, at + PagePoint(3.5, 0), state); },
          hinge_text(state)};
}

/// A swatch of both signs and the largest value.
LegendItem diagram_item(const SceneView& view, const Scene& scene, const UnitSystem& units) {
  return {22,
          [](Canvas& c, const PagePoint& at) {
            for (const double sign : {1.0, -1.0}) {
              const double x = at.x() + (sign > 0 ? 0 : 11);
              const PageBox box{x, at.y() - 4, x + 10, at.y() + 4};
              c.rectangle(box, diagram_fill(sign), Stroke{diagram_line(sign), 0.5});
              c.text({x + 5, at.y() + 2.4}, sign > 0 ? "+" : "−", {7, true, diagram_line(sign), Align::centre});
            }
          },
          fmt::format("{} (largest {})", scene.diagram_label,
                      quantity_text(view.largest_ordinate, scene.diagram_unit, units))};
}

LegendItem ghost_item(const std::string& text) {
  return {13,
          [](Canvas& c, const PagePoint& at) {
            c.rectangle({at.x(), at.y() - 3.5, at.x() + 13, at.y() + 3.5}, std::nullopt, ghost_stroke());
          },
          text};
}

LegendItem crack_item(CrackMark mark) {
  return {13, [=](Canvas& c, const PagePoint& at) { draw_crack(c, at, at + PagePoint(13, 0), mark); },
          crack_text(mark)};
}

LegendItem line_item(const std::string& text) {
  return {13, [](Canvas& c, const PagePoint& at) { c.line(at, at + PagePoint(13, 0), line_stroke()); }, text};
}

bool has_crack(const std::vector<Scene>& scenes, CrackMark mark) {
  const auto is_among = [mark](const std::vector<SceneCrack>& cracks) {
    return std::any_of(cracks.begin(), cracks.end(), [&](const SceneCrack& c) { return c.mark == mark; });
  };
  return std::any_of(scenes.begin(), scenes.end(), [&](const Scene& scene) {
    return is_among(scene.cracks) || std::any_of(scene.faces.begin(), scene.faces.end(),
                                                 [&](const SceneFace& face) { return is_among(face.cracks); });
  });
}

bool occurs(const std::vector<Scene>& scenes, BearingMark state) {
  return std::any_of(scenes.begin(), scenes.end(), [&](const Scene& scene) {
    return std::any_of(scene.bearings.begin(), scene.bearings.end(),
                       [&](const SceneBearing& b) { return b.state == state; });
  });
}

bool occurs(const std::vector<Scene>& scenes, HingeMark state) {
  return std::any_of(scenes.begin(), scenes.end(), [&](const Scene& scene) {
    return std::any_of(scene.hinges.begin(), scene.hinges.end(), [&](const SceneHinge& h) { return h.state == state; });
  });
}

}  // namespace

std::vector<LegendItem> scene_legend(const std::vector<Scene>& scenes, const SceneView& view, double scale,
                                     const PictureStyle& style) {
  std::vector<LegendItem> items = {scale_bar(scale, style)};
  // A single group without a name needs no word.
  const bool plain = view.groups.size() == 1 && view.groups[0].second.empty() && view.groups[0].first == BodyRole::free;
  if (!plain)
    for (LegendItem& item : swatches(view)) items.push_back(std::move(item));
  if (view.has_values) items.push_back(colour_bar(view, scenes[0], style));
  const auto ghosts = std::find_if(scenes.begin(), scenes.end(), [](const Scene& s) { return !s.ghosts.empty(); });
  if (ghosts != scenes.end()) items.push_back(ghost_item(ghosts->ghost_label));
  for (const CrackMark mark : {CrackMark::fine, CrackMark::opened, CrackMark::wide, CrackMark::slid})
    if (has_crack(scenes, mark)) items.push_back(crack_item(mark));
  const auto lines = std::find_if(scenes.begin(), scenes.end(), [](const Scene& s) { return !s.lines.empty(); });
  if (lines != scenes.end()) items.push_back(line_item(lines->line_label));
  for (const BearingMark state : {BearingMark::intact, BearingMark::yielded, BearingMark::changed, BearingMark::failed})
    if (occurs(scenes, state)) items.push_back(bearing_item(state));
  for (const HingeMark state :
       {HingeMark::elastic, HingeMark::fibres, HingeMark::yielded, HingeMark::lost, HingeMark::removed})
    if (occurs(scenes, state)) items.push_back(hinge_item(state));
  const auto drawn = std::find_if(scenes.begin(), scenes.end(), [](const Scene& s) { return !s.diagrams.empty(); });
  if (drawn != scenes.end()) items.push_back(diagram_item(view, *drawn, style.units));
  if (view.largest_force > 0) items.push_back(force_item(view, scale, style.units));
  return items;
}

}  // namespace trilith::draw
