// Cross-sections of plane beams: their constants and shapes.
//
// A new shape is a struct here with its declared parameters and `numbers()`, and a name in the list below.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "base/schema.hpp"
#include "base/space.hpp"

namespace trilith {

/// Section constants of a plane beam.
struct Section {
  double area = 0;           ///< [m2]
  double second_moment = 0;  ///< about the axis through the centroid, out of plane [m4]
  double shear_area = 0;     ///< area times shear coefficient [m2]
  double above = 0;          ///< from the centroid to the top and the bottom fibre [m]
  double below = 0;

  [[nodiscard]] double depth() const { return above + below; }
};

struct RectangleSection {
  double width = 0, depth = 0;  ///< [m]

  static constexpr std::string_view name = "rectangle_section";
  static constexpr std::string_view sentence = "a solid rectangle";
  static constexpr auto parameters() {
    using P = Parameter<RectangleSection>;
    return std::array{P{&RectangleSection::width, "width", "m", no_default, 0, unbounded, false, "out of plane"},
                      P{&RectangleSection::depth, "depth", "m", no_default, 0, unbounded, false, "in the plane"}};
  }
  /// Shear coefficient 5/6.
  [[nodiscard]] Section numbers() const {
    const double area = width * depth;
    return {area, area * depth * depth / 12, area * 5 / 6, depth / 2, depth / 2};
  }
};

struct CircleSection {
  double diameter = 0, hollow = 0;  ///< [m]

  static constexpr std::string_view name = "circle_section";
  static constexpr std::string_view sentence = "a solid circle, or a pipe";
  static constexpr auto parameters() {
    using P = Parameter<CircleSection>;
    return std::array{P{&CircleSection::diameter, "diameter", "m", no_default, 0, unbounded, false, "outside"},
                      P{&CircleSection::hollow, "hollow", "m", 0, 0, unbounded, true, "diameter of a hole within"}};
  }
  void check() const {
    if (!(hollow < diameter))
      throw InputError(
          fmt::format("circle_section: hollow is {:g} m, must be below the diameter of {:g} m", hollow, diameter));
  }
  /// Shear coefficient 0.9; for a pipe 0.5, which is valid for thin walls.
  [[nodiscard]] Section numbers() const {
    const double area = M_PI / 4 * (diameter * diameter - hollow * hollow);
    const double square = diameter * diameter + hollow * hollow;
    return {area, area * square / 16, area * (hollow > 0 ? 0.5 : 0.9), diameter / 2, diameter / 2};
  }
};

/// Stacked rectangles with centred widths: plane I, T and box sections.
struct SectionLayer {
  double width, depth;  ///< [m]
};

/// From the bottom up; the layer `web` carries shear, over the whole depth.
inline Section layered_section(std::span<const SectionLayer> layers, std::size_t web) {
  Section s;
  double first = 0, depth = 0;
  for (const SectionLayer& l : layers) {
    const double area = l.width * l.depth;
    s.area += area;
    first += area * (depth + l.depth / 2);
    depth += l.depth;
  }
  s.below = first / s.area, s.above = depth - s.below;
  double level = 0;
  for (const SectionLayer& l : layers) {
    const double area = l.width * l.depth, arm = level + l.depth / 2 - s.below;
    s.second_moment += area * (l.depth * l.depth / 12 + arm * arm);
    level += l.depth;
  }
  s.shear_area = layers[web].width * depth;
  return s;
}

struct ISection {
  double depth = 0, web = 0;                      ///< [m]
  double top_width = 0, top_thickness = 0;        ///< [m]
  double bottom_width = 0, bottom_thickness = 0;  ///< [m]

  static constexpr std::string_view name = "i_section";
  static constexpr std::string_view sentence = "two flanges on a web";
  static constexpr auto parameters() {
    using P = Parameter<ISection>;
    return std::array{
        P{&ISection::depth, "depth", "m", no_default, 0, unbounded, false, "over all"},
        P{&ISection::web, "web", "m", no_default, 0, unbounded, false, "thickness of the web"},
        P{&ISection::top_width, "top_width", "m", no_default, 0, unbounded, false, "of the top flange"},
        P{&ISection::top_thickness, "top_thickness", "m", no_default, 0, unbounded, false, "of the top flange"},
        P{&ISection::bottom_width, "bottom_width", "m", no_default, 0, unbounded, false, "of the bottom flange"},
        P{&ISection::bottom_thickness, "bottom_thickness", "m", no_default, 0, unbounded, false,
          "of the bottom flange"}};
  }
  void check() const {
    if (!(top_thickness + bottom_thickness < depth))
      throw InputError(fmt::format("i_section: flanges of {:g} and {:g} m leave no web in a depth of {:g} m",
                                   top_thickness, bottom_thickness, depth));
  }
  [[nodiscard]] Section numbers() const {
    const std::array layers{SectionLayer{bottom_width, bottom_thickness},
                            SectionLayer{web, depth - top_thickness - bottom_thickness},
                            SectionLayer{top_width, top_thickness}};
    return layered_section(layers, 1);
  }
};

struct TSection {
  double depth = 0, web = 0, width = 0, thickness = 0;  ///< [m]

  static constexpr std::string_view name = "t_section";
  static constexpr std::string_view sentence = "a flange on a web";
  static constexpr auto parameters() {
    using P = Parameter<TSection>;
    return std::array{P{&TSection::depth, "depth", "m", no_default, 0, unbounded, false, "over all"},
                      P{&TSection::web, "web", "m", no_default, 0, unbounded, false, "thickness of the web"},
                      P{&TSection::width, "width", "m", no_default, 0, unbounded, false, "of the flange"},
                      P{&TSection::thickness, "thickness", "m", no_default, 0, unbounded, false, "of the flange"}};
  }
  void check() const {
    if (!(thickness < depth))
      throw InputError(
          fmt::format("t_section: a flange of {:g} m leaves no web in a depth of {:g} m", thickness, depth));
  }
  [[nodiscard]] Section numbers() const {
    const std::array layers{SectionLayer{web, depth - thickness}, SectionLayer{width, thickness}};
    return layered_section(layers, 0);
  }
};

struct BoxSection {
  double width = 0, depth = 0, webs = 0, top = 0, bottom = 0;  ///< [m]

  static constexpr std::string_view name = "box_section";
  static constexpr std::string_view sentence = "a hollow box of two webs and two slabs";
  static constexpr auto parameters() {
    using P = Parameter<BoxSection>;
    return std::array{
        P{&BoxSection::width, "width", "m", no_default, 0, unbounded, false, "outside"},
        P{&BoxSection::depth, "depth", "m", no_default, 0, unbounded, false, "outside"},
        P{&BoxSection::webs, "webs", "m", no_default, 0, unbounded, false, "thickness of both together"},
        P{&BoxSection::top, "top", "m", no_default, 0, unbounded, false, "thickness of the top slab"},
        P{&BoxSection::bottom, "bottom", "m", no_default, 0, unbounded, false, "thickness of the bottom slab"}};
  }
  void check() const {
    if (!(webs < width) || !(top + bottom < depth))
      throw InputError(
          fmt::format("box_section: walls of {:g} m in a width of {:g} m, or slabs of {:g} m in a depth "
                      "of {:g} m, leave no hollow",
                      webs, width, top + bottom, depth));
  }
  [[nodiscard]] Section numbers() const {
    const std::array layers{SectionLayer{width, bottom}, SectionLayer{webs, depth - top - bottom},
                            SectionLayer{width, top}};
    return layered_section(layers, 1);
  }
};

struct GivenSection {
  double area = 0, second_moment = 0, depth = 0, below = 0, shear_area = 0;
  double inertia_across = 0, torsion = 0, width = 0, shear_area_across = 0;  ///< of members in space

  static constexpr std::string_view name = "section";
  static constexpr std::string_view sentence = "a section of any shape, given by its properties";
  static constexpr auto parameters() {
    using P = Parameter<GivenSection>;
    return std::array{
        P{&GivenSection::area, "area", "m2", no_default, 0, unbounded, false, "of the section"},
        P{&GivenSection::second_moment, "inertia", "m4", no_default, 0, unbounded, false,
          "second moment of area about the centroid, for bending in the plane"},
        P{&GivenSection::depth, "depth", "m", no_default, 0, unbounded, false, "from the bottom fibre to the top one"},
        P{&GivenSection::below, "below", "m", 0, 0, unbounded, true,
          "from the bottom fibre to the centroid; 0: in the middle"},
        P{&GivenSection::shear_area, "shear_area", "m2", 0, 0, unbounded, true,
          "area times shear coefficient; 0: 5/6 of the area"},
        P{&GivenSection::inertia_across, "inertia_across", "m4", 0, 0, unbounded, true,
          "second moment of area for bending across; needed in space"},
        P{&GivenSection::torsion, "torsion", "m4", 0, 0, unbounded, true, "torsion constant; needed in space"},
        P{&GivenSection::width, "width", "m", 0, 0, unbounded, true, "across, of its profile; needed in space"},
        P{&GivenSection::shear_area_across, "shear_area_across", "m2", 0, 0, unbounded, true,
          "... across; 0: 5/6 of the area"}};
  }
  void check() const {
    if (!(below < depth))
      throw InputError(fmt::format("section: below is {:g} m, must be less than the depth of {:g} m", below, depth));
  }
  [[nodiscard]] Section numbers() const {
    const double low = below > 0 ? below : depth / 2;
    return {area, second_moment, shear_area > 0 ? shear_area : area * 5 / 6, depth - low, low};
  }
};

using SectionShapes = TypeList<RectangleSection, CircleSection, ISection, TSection, BoxSection, GivenSection>;

/// A simple polygon, given in its own axes: x out of plane, y up [m].
Section polygon_section(std::span<const Vec2> outline);

}  // namespace trilith
