#include "draw/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/whole_file.hpp"
#include "draw/picture_text.hpp"

namespace trilith::draw {
namespace {

struct EndSurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct EndContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, EndSurface>;
using Context = std::unique_ptr<cairo_t, EndContext>;

void set_source(cairo_t* c, const Colour& colour) {
  cairo_set_source_rgba(c, colour.red, colour.green, colour.blue, colour.opacity);
}

void stroke_path(cairo_t* c, const Stroke& stroke) {
  static constexpr std::array<double, 2> dashed = {4, 2.2}, dotted = {0.9, 1.8};
  static constexpr std::array<double, 4> dash_dot = {5, 1.8, 1, 1.8};
  if (stroke.dash == Dash::solid) cairo_set_dash(c, nullptr, 0, 0);
  if (stroke.dash == Dash::dashed) cairo_set_dash(c, dashed.data(), 2, 0);
  if (stroke.dash == Dash::dotted) cairo_set_dash(c, dotted.data(), 2, 0);
  if (stroke.dash == Dash::dash_dot) cairo_set_dash(c, dash_dot.data(), 4, 0);
  cairo_set_line_width(c, stroke.width);
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(c, CAIRO_LINE_CAP_BUTT);
  set_source(c, stroke.colour);
  cairo_stroke(c);
}

void trace(cairo_t* c, const std::vector<PagePoint>& points) {
  cairo_new_path(c);
  for (const PagePoint& p : points) cairo_line_to(c, p.x(), p.y());
}

/// Fills and outlines the current path and ends it.
void paint_path(cairo_t* c, const std::optional<Colour>& fill, const std::optional<Stroke>& outline) {
  if (fill) {
    set_source(c, *fill);
    cairo_fill_preserve(c);
  }
  if (outline) stroke_path(c, *outline);
  cairo_new_path(c);
}

void select_font(cairo_t* c, const TextStyle& style) {
  cairo_select_font_face(c, "sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(c, style.size);
  // No fitting to pixels: one layout for all formats, whatever the desktop's settings are.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(c, options);
  cairo_font_options_destroy(options);
}

cairo_text_extents_t measure(const std::string& text, const TextStyle& style) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Context context(cairo_create(surface.get()));
  select_font(context.get(), style);
  cairo_text_extents_t extents{};
  cairo_text_extents(context.get(), text.c_str(), &extents);
  return extents;
}

/// Shift from the anchor to the start of the baseline, along the direction of reading.
double align_shift(const TextStyle& style, double advance) {
  if (style.align == Align::centre) return -advance / 2;
  return style.align == Align::right ? -advance : 0;
}

PageBox ink_box(const PagePoint& at, const TextStyle& style, const cairo_text_extents_t& e) {
  const double along = align_shift(style, e.x_advance) + e.x_bearing;
  if (style.upward)
    return {at.x() + e.y_bearing, at.y() - along - e.width, at.x() + e.y_bearing + e.height, at.y() - along};
  return {at.x() + along, at.y() + e.y_bearing, at.x() + along + e.width, at.y() + e.y_bearing + e.height};
}

cairo_status_t append(void* to, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Cairo numbers its surfaces through the whole process and writes the number into the SVG; it is removed here.
std::string without_surface_number(std::string svg) {
  const std::string mark = "id=\"surface";
  for (std::size_t at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + mark.size())) {
    const std::size_t first = at + mark.size();
    std::size_t last = first;
    while (last < svg.size() && svg[last] >= '0' && svg[last] <= '9') ++last;
    svg.erase(first, last - first);
  }
  return svg;
}

}  // namespace

struct Canvas::Content {
  std::vector<std::function<void(cairo_t*)>> acts;
  std::vector<PageBox> texts;

  void play(cairo_surface_t* surface, double scale, double from_left = 0, double from_top = 0) const {
    const Context context(cairo_create(surface));
    set_source(context.get(), palette().paper);
    cairo_paint(context.get());
    cairo_translate(context.get(), from_left, from_top);
    cairo_scale(context.get(), scale, scale);
    for (const auto& act : acts) act(context.get());
    if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error(fmt::format("drawing failed: {}", cairo_status_to_string(cairo_status(context.get()))));
  }
};

double text_width(std::string_view text, const TextStyle& style) {
  return measure(printable_utf8(text), style).x_advance;
}

namespace {

/// The longest start of `word` that, with an ellipsis, is not wider than `width`.
std::string cut_word(std::string word, const TextStyle& style, double width) {
  while (!word.empty() && text_width(word + "…", style) > width) {
    while (word.size() > 1 && (static_cast<unsigned char>(word.back()) & 0xC0U) == 0x80U) word.pop_back();
    word.pop_back();
  }
  return word + "…";
}

}  // namespace

std::vector<std::string> wrap_text(std::string_view text, const TextStyle& style, double width) {
  const std::string clean = printable_utf8(text);
  std::vector<std::string> lines;
  for (std::size_t at = clean.find_first_not_of(' '); at != std::string::npos;) {
    const std::size_t end = std::min(clean.find(' ', at), clean.size());
    std::string word = clean.substr(at, end - at);
    if (text_width(word, style) > width) word = cut_word(word, style, width);
    const bool joins = !lines.empty() && text_width(lines.back() + " " + word, style) <= width;
    if (joins)
      lines.back() += " " + word;
    else
      lines.push_back(word);
    at = clean.find_first_not_of(' ', end);
  }
  return lines;
}

PictureFormat picture_format(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".pdf") return PictureFormat::pdf;
  if (ending == ".png") return PictureFormat::png;
  throw InputError(fmt::format("picture '{}': the extension '{}' is not a picture format, must be .svg, .pdf or .png",
                               path.string(), ending));
}

Canvas::Canvas(double width, double height) : content_(std::make_unique<Content>()), width_(width), height_(height) {
  const double most = 14400;
  for (const double side : {width, height})
    if (!(side > 0 && side <= most))
      throw InputError(
          fmt::format("picture of {:g} x {:g} pt: each side must be above 0 and at most {:g} pt", width, height, most));
}
Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

void Canvas::line(const PagePoint& from, const PagePoint& to, const Stroke& stroke) {
  polyline({from, to}, stroke);
}

void Canvas::polyline(std::vector<PagePoint> points, const Stroke& stroke) {
  content_->acts.emplace_back([points = std::move(points), stroke](cairo_t* c) {
    trace(c, points);
    stroke_path(c, stroke);
  });
}

void Canvas::polygon(std::vector<PagePoint> points, const std::optional<Colour>& fill,
                     const std::optional<Stroke>& outline) {
  content_->acts.emplace_back([points = std::move(points), fill, outline](cairo_t* c) {
    trace(c, points);
    cairo_close_path(c);
    paint_path(c, fill, outline);
  });
}

void Canvas::rectangle(const PageBox& box, const std::optional<Colour>& fill, const std::optional<Stroke>& outline) {
  polygon({{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}, fill, outline);
}

void Canvas::circle(const PagePoint& centre, double radius, const std::optional<Colour>& fill,
                    const std::optional<Stroke>& outline) {
  content_->acts.emplace_back([=](cairo_t* c) {
    cairo_new_path(c);
    cairo_arc(c, centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
    cairo_close_path(c);
    paint_path(c, fill, outline);
  });
}

void Canvas::ball(const PagePoint& centre, double radius, const Colour& lit, const Colour& shade) {
  content_->acts.emplace_back([=](cairo_t* c) {
    cairo_pattern_t* pattern = cairo_pattern_create_radial(centre.x() - 0.4 * radius, centre.y() - 0.45 * radius, 0,
                                                           centre.x(), centre.y(), radius);
    cairo_pattern_add_color_stop_rgba(pattern, 0, lit.red, lit.green, lit.blue, lit.opacity);
    cairo_pattern_add_color_stop_rgba(pattern, 0.45, 0.8 * lit.red + 0.2 * shade.red,
                                      0.8 * lit.green + 0.2 * shade.green, 0.8 * lit.blue + 0.2 * shade.blue,
                                      lit.opacity);
    cairo_pattern_add_color_stop_rgba(pattern, 1, shade.red, shade.green, shade.blue, shade.opacity);
    cairo_new_path(c);
    cairo_arc(c, centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
    cairo_close_path(c);
    cairo_set_source(c, pattern);
    cairo_fill(c);
    cairo_pattern_destroy(pattern);
  });
}

void Canvas::hatch(std::vector<PagePoint> points, double degrees, double spacing, const Stroke& stroke) {
  assert(spacing > 0);
  if (points.empty()) return;
  const double angle = -degrees * std::numbers::pi / 180;  // page y runs downwards
  const PagePoint along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  double a0 = points[0].dot(along), a1 = a0, b0 = points[0].dot(across), b1 = b0;
  for (const PagePoint& p : points) {
    a0 = std::min(a0, p.dot(along)), a1 = std::max(a1, p.dot(along));
    b0 = std::min(b0, p.dot(across)), b1 = std::max(b1, p.dot(across));
  }
  content_->acts.emplace_back([=, points = std::move(points)](cairo_t* c) {
    cairo_save(c);
    trace(c, points);
    cairo_close_path(c);
    cairo_clip(c);
    // Lines are at multiples of the spacing, so hatches of neighbours continue across their border.
    for (double b = std::ceil(b0 / spacing) * spacing; b <= b1; b += spacing) {
      const PagePoint from = a0 * along + b * across, to = a1 * along + b * across;
      cairo_move_to(c, from.x(), from.y());
      cairo_line_to(c, to.x(), to.y());
    }
    stroke_path(c, stroke);
    cairo_restore(c);
  });
}

void Canvas::text(const PagePoint& at, std::string_view text, const TextStyle& style) {
  const std::string clean = printable_utf8(text);
  if (clean.find_first_not_of(' ') == std::string::npos) return;
  const cairo_text_extents_t extents = measure(clean, style);
  content_->texts.push_back(ink_box(at, style, extents));
  content_->acts.emplace_back([=](cairo_t* c) {
    cairo_save(c);
    select_font(c, style);
    set_source(c, style.colour);
    cairo_translate(c, at.x(), at.y());
    if (style.upward) cairo_rotate(c, -std::numbers::pi / 2);
    cairo_move_to(c, align_shift(style, extents.x_advance), 0);
    cairo_show_text(c, clean.c_str());
    cairo_restore(c);
  });
}

void Canvas::clipped(const PageBox& box, const std::function<void()>& draw) {
  content_->acts.emplace_back([box](cairo_t* c) {
    cairo_save(c);
    cairo_rectangle(c, box.x0, box.y0, box.width(), box.height());
    cairo_clip(c);
  });
  draw();
  content_->acts.emplace_back([](cairo_t* c) { cairo_restore(c); });
}

const std::vector<PageBox>& Canvas::text_boxes() const {
  return content_->texts;
}

std::string Canvas::bytes(PictureFormat format, double pixels_per_inch) const {
  std::string out;
  if (format == PictureFormat::svg) {
    const Surface surface(cairo_svg_surface_create_for_stream(append, &out, width_, height_));
    content_->play(surface.get(), 1);
    cairo_surface_finish(surface.get());
    return without_surface_number(std::move(out));
  }
  if (format == PictureFormat::pdf) {
    const Surface surface(cairo_pdf_surface_create_for_stream(append, &out, width_, height_));
    // A fixed date: the file shows its content, not the hour it was drawn.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    content_->play(surface.get(), 1);
    cairo_surface_finish(surface.get());
    return out;
  }
  if (!(pixels_per_inch >= 36 && pixels_per_inch <= 1200))
    throw InputError(fmt::format("picture resolution is {:g} pixels per inch, must be 36 to 1200", pixels_per_inch));
  const double scale = pixels_per_inch / 72;
  const double most = 20000;
  if (std::max(width_, height_) * scale > most)
    throw InputError(
        fmt::format("picture of {:g} x {:g} pt at {:g} pixels per inch is above {:g} pixels; lower the "
                    "resolution or save as .svg or .pdf",
                    width_, height_, pixels_per_inch, most));
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width_ * scale)),
                                                   static_cast<int>(std::ceil(height_ * scale))));
  content_->play(surface.get(), scale);
  cairo_surface_write_to_png_stream(surface.get(), append, &out);
  return out;
}

std::string Canvas::pixels(int columns, int rows) const {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows));
  const double scale = std::min(columns / width_, rows / height_);
  content_->play(surface.get(), scale, (columns - scale * width_) / 2, (rows - scale * height_) / 2);
  cairo_surface_flush(surface.get());
  const unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  std::string out;
  out.reserve(4 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row)  // a pixel is a 32-bit word; on little-endian machines its first byte is blue
    out.append(reinterpret_cast<const char*>(data) + static_cast<std::ptrdiff_t>(row) * stride,
               4 * static_cast<std::size_t>(columns));
  return out;
}

void Canvas::save(const std::filesystem::path& path, double pixels_per_inch) const {
  write_whole_file(path, bytes(picture_format(path), pixels_per_inch));
}

}  // namespace trilith::draw
