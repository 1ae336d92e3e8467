// Availability of a font for the texts of pictures.
#pragma once

namespace trilith::draw {

/// False if the system has no font: texts are then drawn with simple strokes, and letters other than Latin ones are
/// lost.
bool has_picture_font();

}  // namespace trilith::draw
