#include "draw/picture_font.hpp"

#include <cairo.h>

namespace trilith::draw {

bool has_picture_font() {
  cairo_surface_t* const surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  cairo_t* const context = cairo_create(surface);
  cairo_select_font_face(context, "sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  // Without a font in fontconfig, Cairo uses its own strokes, which it reports as a user font.
  cairo_scaled_font_t* const font = cairo_get_scaled_font(context);
  const bool found =
      cairo_scaled_font_status(font) == CAIRO_STATUS_SUCCESS && cairo_scaled_font_get_type(font) == CAIRO_FONT_TYPE_FT;
  cairo_destroy(context);
  cairo_surface_destroy(surface);
  return found;
}

}  // namespace trilith::draw
