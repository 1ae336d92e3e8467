// A drawing: a list of strokes, fills and texts on a page, which can be saved as SVG, PDF or PNG.
//
// Page coordinates are in points (1/72 inch) from the top left corner, y downwards. Cairo does the drawing and is named
// only in the .cpp file.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/palette.hpp"

namespace trilith::draw {

/// A point on the page [pt].
using PagePoint = Eigen::Vector2d;

/// A rectangle on the page [pt], x0 <= x1, y0 <= y1, y downwards.
struct PageBox {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  bool contains(const PagePoint& p) const { return p.x() >= x0 && p.x() <= x1 && p.y() >= y0 && p.y() <= y1; }
  bool overlaps(const PageBox& o) const { return x0 < o.x1 && o.x0 < x1 && y0 < o.y1 && o.y0 < y1; }
};

/// Margin on each side of a picture [pt].
inline constexpr double page_margin = 8;

enum class Dash { solid, dashed, dotted, dash_dot };
enum class Align { left, centre, right };

/// Style of a line; width in pt.
struct Stroke {
  Colour colour = palette().ink;
  double width = 0.5;
  Dash dash = Dash::solid;
};

/// Style of a text; size in pt. `upward`: read from bottom to top.
struct TextStyle {
  double size = 8;
  bool bold = false;
  Colour colour = palette().ink;
  Align align = Align::left;
  bool upward = false;
};

/// Advance width of `text` in the style's font and size [pt].
double text_width(std::string_view text, const TextStyle& style);

/// Breaks `text` into lines of at most `width` [pt] at blanks; a single word that is too wide is cut and ends in an
/// ellipsis. Empty text gives no line.
std::vector<std::string> wrap_text(std::string_view text, const TextStyle& style, double width);

enum class PictureFormat { svg, pdf, png };

/// The format named by the file's ending (.svg, .pdf, .png in any case). Throws InputError for any other ending.
PictureFormat picture_format(const std::filesystem::path& path);

/// A page for drawing. It can be moved, not copied.
class Canvas {
 public:
  /// `width`, `height` in pt, each above 0 and at most 14,400 (200 in; else InputError).
  Canvas(double width, double height);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  double width() const { return width_; }
  double height() const { return height_; }

  void line(const PagePoint& from, const PagePoint& to, const Stroke& stroke);
  void polyline(std::vector<PagePoint> points, const Stroke& stroke);
  void polygon(std::vector<PagePoint> points, const std::optional<Colour>& fill, const std::optional<Stroke>& outline);
  void rectangle(const PageBox& box, const std::optional<Colour>& fill, const std::optional<Stroke>& outline);
  void circle(const PagePoint& centre, double radius, const std::optional<Colour>& fill,
              const std::optional<Stroke>& outline);
  /// A disc shaded as a sphere with light from the upper left, from `lit` to `shade` at the rim.
  void ball(const PagePoint& centre, double radius, const Colour& lit, const Colour& shade);
  /// Parallel lines within a polygon: direction `degrees` from the x axis (anticlockwise as seen), `spacing` in pt.
  void hatch(std::vector<PagePoint> points, double degrees, double spacing, const Stroke& stroke);
  /// Text with its baseline's left end, middle or right end (by `align`) at `at`. Bytes that are not UTF-8 and control
  /// characters are shown as a question mark and a blank.
  void text(const PagePoint& at, std::string_view text, const TextStyle& style);
  /// Restricts the drawing of `draw` to `box`.
  void clipped(const PageBox& box, const std::function<void()>& draw);

  /// Boxes of the ink of all texts so far, in order of drawing [pt].
  const std::vector<PageBox>& text_boxes() const;

  /// The finished file's bytes: the same drawing gives the same bytes. `pixels_per_inch` (36 to 1200) is for PNG only.
  std::string bytes(PictureFormat format, double pixels_per_inch = 220) const;

  /// The page as a film frame of `columns` x `rows` pixels, both at least 1, scaled to fit, centred, on paper: rows
  /// from the top, 4 bytes per pixel: blue, green, red, unused.
  std::string pixels(int columns, int rows) const;

  /// Writes the file in the format of its extension, completely or not at all. Throws InputError with the system's
  /// message if it cannot be written.
  void save(const std::filesystem::path& path, double pixels_per_inch = 220) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
  double width_ = 0, height_ = 0;
};

}  // namespace trilith::draw
