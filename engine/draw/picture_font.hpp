// Whether texts of pictures have a font.
#pragma once

namespace trilith::draw {

/// False where the system has no font: texts are then drawn in bare strokes, and other letters than Latin ones are
/// lost.
bool has_picture_font();

}  // namespace trilith::draw
