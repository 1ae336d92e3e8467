#include "draw/scene/scene_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "draw/scene/scene_faces.hpp"
#include "draw/scene/scene_labels.hpp"
#include "draw/scene/scene_legend.hpp"
#include "draw/scene/scene_marks.hpp"
#include "draw/scene/scene_view.hpp"

namespace trilith::draw {
namespace {

constexpr double column_gap = 14, row_gap = 10, head_gap = 4, legend_gap = 7;
constexpr double least_panel_width = 190, least_plot_height = 46;

TextStyle title_style(const PictureStyle& s, bool single) {
  return {s.font_size + (single ? 1.5 : 0.5), true};
}
TextStyle subtitle_style(const PictureStyle& s) {
  return {s.font_size, false, palette().quiet_ink};
}

std::string subtitle(const Scene& scene, const UnitSystem& units) {
  std::string out = scene.time ? fmt::format("t = {}{}", time_label(*scene.time), scene.since) : "";
  for (const std::string& part : {scene.stage, units.message(scene.event), units.message(scene.verdict)})
    if (!part.empty()) out += (out.empty() ? "" : " · ") + part;
  return out;
}

std::string letter(std::size_t i) {
  std::string out;
  for (std::size_t n = i + 1; n > 0; n = (n - 1) / 26) out.insert(out.begin(), static_cast<char>('a' + (n - 1) % 26));
  return "(" + out + ")";
}

struct Head {
  std::vector<std::string> title, subtitle;
};

/// Sizes of everything on the page.
struct Layout {
  int columns = 1, rows = 1;
  bool single = true;
  double panel_width = 0, plot_width = 0, plot_height = 0, scale = 1;
  WorldBox world;
  std::vector<Head> heads;
  std::vector<double> head_heights;  ///< per row
  double inner_width() const { return columns * panel_width + (columns - 1) * column_gap; }
};

bool has_labels(const Scene& scene, const PictureStyle& style) {
  const auto named =
      std::count_if(scene.bodies.begin(), scene.bodies.end(), [](const SceneBody& body) { return !body.name.empty(); });
  return named > 0 && named <= style.label_limit;
}

/// One scale for all panels: the largest that the page's width and height allow.
void fit_scale(Layout& out, const SceneView& view, bool labels, const PictureStyle& style) {
  const double column = (style.width - 2 * page_margin - (out.columns - 1) * column_gap) / out.columns;
  if (column < 60)
    throw InputError(fmt::format("{} columns leave {:.0f} pt for a panel, needs 60; use fewer or widen the picture",
                                 out.columns, column));
  const double words = 2 * page_margin + 40 + out.rows * (2.6 * style.font_size + row_gap);
  const double height = style.height > 0 ? style.height : out.rows == 1 ? 430 : 660;
  const double tallest = std::max((height - words) / out.rows, least_plot_height);
  out.world = view.world;
  out.scale = std::min(column / view.world.width(), tallest / view.world.height());
  out.plot_width = out.scale * view.world.width();
  out.plot_height = std::max(out.scale * view.world.height(), std::min(least_plot_height, tallest));
  if (labels && !style.view) {  // space for names above the structure
    out.plot_height += 1.3 * style.font_size;
    out.world.y1 += 1.3 * style.font_size / out.scale;
  }
  // A panel higher than its content shows it in its middle.
  const double more = out.plot_height / out.scale - out.world.height();
  out.world.y0 -= more / 2, out.world.y1 += more / 2;
  out.panel_width = std::min(column, std::max(out.plot_width, least_panel_width));
}

void set_heads(Layout& out, const std::vector<Scene>& scenes, const PictureStyle& style) {
  out.head_heights.assign(static_cast<std::size_t>(out.rows), 0);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::string title = out.single ? scenes[i].title : letter(i) + " " + scenes[i].title;
    const Head head{wrap_text(title, title_style(style, out.single), out.panel_width),
                    wrap_text(subtitle(scenes[i], style.units), subtitle_style(style), out.panel_width)};
    const double tall = 1.3 * title_style(style, out.single).size * static_cast<double>(head.title.size()) +
                        1.35 * style.font_size * static_cast<double>(head.subtitle.size()) + head_gap;
    double& row = out.head_heights[i / static_cast<std::size_t>(out.columns)];
    row = std::max(row, tall);
    out.heads.push_back(head);
  }
}

Layout make_layout(const std::vector<Scene>& scenes, const SceneView& view, int columns, const PictureStyle& style) {
  Layout out;
  const int count = static_cast<int>(scenes.size());
  out.columns = std::min(columns, count);
  out.rows = (count + out.columns - 1) / out.columns;
  out.single = count == 1;
  const bool labels = std::any_of(scenes.begin(), scenes.end(), [&](const Scene& s) { return has_labels(s, style); });
  fit_scale(out, view, labels, style);
  set_heads(out, scenes, style);
  return out;
}

void draw_head(Canvas& canvas, const Head& head, PagePoint at, bool single, const PictureStyle& style) {
  const TextStyle title = title_style(style, single);
  for (const std::string& line : head.title) {
    canvas.text(at + PagePoint(0, title.size), line, title);
    at.y() += 1.3 * title.size;
  }
  for (const std::string& line : head.subtitle) {
    canvas.text(at + PagePoint(0, style.font_size), line, subtitle_style(style));
    at.y() += 1.35 * style.font_size;
  }
}

/// View of a panel; `corner`: its upper left corner, below its head.
PageView panel_page(const Layout& layout, const PagePoint& corner) {
  const double x = corner.x() + (layout.panel_width - layout.plot_width) / 2;
  return {layout.world, {x, corner.y(), x + layout.plot_width, corner.y() + layout.plot_height}, layout.scale};
}

void draw_panel(Canvas& canvas, const Scene& scene, const SceneView& view, const Layout& layout,
                const PagePoint& corner, const PictureStyle& style) {
  const PageView page = panel_page(layout, corner);
  std::vector<PageBox> marks = draw_scene_content(canvas, scene, view, page);
  if (has_labels(scene, style))
    draw_labels(canvas, scene, view, page, std::move(marks), {style.font_size - 1.5, false, palette().quiet_ink});
}

}  // namespace

std::string time_label(double time) {
  constexpr double shows_zero = 0.005;
  return time != 0 && std::abs(time) < shows_zero ? fmt::format("{:.3g} s", time) : fmt::format("{:.2f} s", time);
}

Canvas scene_canvas(const std::vector<Scene>& scenes, int columns, const PictureStyle& style) {
  if (columns < 1) throw InputError(fmt::format("columns of panels is {}, must be at least 1", columns));
  SceneView view = scene_view(scenes, style);
  const Layout layout = make_layout(scenes, view, columns, style);
  view.axes = corner_for_axes(scenes, panel_page(layout, {0, 0}));
  const TextStyle legend_style{style.font_size - 0.5};
  const std::vector<LegendItem> legend = scene_legend(scenes, view, layout.scale, style);
  const double inner = layout.inner_width(), legend_tall = legend_height(legend, legend_style, inner);
  double tall = 2 * page_margin + legend_gap + legend_tall + (layout.rows - 1) * row_gap;
  for (const double head : layout.head_heights) tall += head + layout.plot_height;

  Canvas canvas(inner + 2 * page_margin, tall);
  double y = page_margin;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto column = static_cast<int>(i) % layout.columns;
    const double head = layout.head_heights[i / static_cast<std::size_t>(layout.columns)];
    const double x = page_margin + column * (layout.panel_width + column_gap);
    draw_head(canvas, layout.heads[i], {x, y}, layout.single, style);
    draw_panel(canvas, scenes[i], view, layout, {x, y + head}, style);
    if (column + 1 == layout.columns || i + 1 == scenes.size()) y += head + layout.plot_height + row_gap;
  }
  draw_legend(canvas, legend, legend_style, {page_margin, y - row_gap + legend_gap}, inner);
  return canvas;
}

namespace {

/// Common data of the pictures of a series.
struct SeriesPage {
  PictureStyle style;
  SceneView view;
  Layout layout;
  double head = 0, legend_tall = 0;
  TextStyle legend_style;
  std::vector<LegendItem> legend;
};

constexpr double usual_height = 430;  // [pt]

/// The first line of `text`, marked where it continues.
std::vector<std::string> first_line(const std::string& text, const TextStyle& style, double width) {
  std::vector<std::string> lines = wrap_text(text, style, width - style.size);
  if (lines.size() > 1) lines = {lines[0] + " …"};
  return lines;
}

SeriesPage series_page(const std::vector<Scene>& samples, const PictureStyle& style) {
  SeriesPage page{style, scene_view(samples, style), {}, 0, 0, {style.font_size - 0.5}, {}};
  if (style.height == 0) page.style.height = usual_height;
  page.head = 1.3 * title_style(style, true).size + 1.35 * style.font_size + head_gap;
  const bool labels = std::ranges::any_of(samples, [&](const Scene& s) { return has_labels(s, style); });
  const double inner = style.width - 2 * page_margin;
  PictureStyle fitted = page.style;
  for (int pass = 0; pass < 3; ++pass) {  // the legend contains the scale bar, so its height depends on the scale
    page.layout = {};
    fit_scale(page.layout, page.view, labels, fitted);
    page.legend = scene_legend(samples, page.view, page.layout.scale, style);
    page.legend_tall = legend_height(page.legend, page.legend_style, inner);
    const double excess = 2 * page_margin + legend_gap + page.legend_tall + page.head + page.layout.plot_height;
    if (excess <= page.style.height) break;
    fitted.height = std::max(100.0, fitted.height - (excess - page.style.height));
  }
  page.layout.panel_width = inner;
  page.view.axes = corner_for_axes(samples, panel_page(page.layout, {0, 0}));
  return page;
}

Canvas series_picture(const SeriesPage& page, const Scene& scene) {
  const double width = page.layout.panel_width;
  Canvas canvas(page.style.width, page.style.height);
  const Head head{first_line(scene.title, title_style(page.style, true), width),
                  first_line(subtitle(scene, page.style.units), subtitle_style(page.style), width)};
  draw_head(canvas, head, {page_margin, page_margin}, true, page.style);
  draw_panel(canvas, scene, page.view, page.layout, {page_margin, page_margin + page.head}, page.style);
  draw_legend(canvas, page.legend, page.legend_style, {page_margin, canvas.height() - page_margin - page.legend_tall},
              width);
  return canvas;
}

}  // namespace

SceneSeries::SceneSeries(const std::vector<Scene>& samples, const PictureStyle& style)
    : draw_([page = series_page(samples, style)](const Scene& scene) { return series_picture(page, scene); }) {}

void draw_scene(const Scene& scene, const PictureStyle& style, const std::filesystem::path& path) {
  draw_panels({scene}, 1, style, path);
}

void draw_panels(const std::vector<Scene>& scenes, int columns, const PictureStyle& style,
                 const std::filesystem::path& path) {
  picture_format(path);  // reports a wrong extension before any work
  scene_canvas(scenes, columns, style).save(path, style.pixels_per_inch);
}

}  // namespace trilith::draw
