#include "draw/members/scene_diagrams.hpp"

#include <algorithm>
#include <cmath>

#include "base/quantity_text.hpp"

namespace trilith::draw {
namespace {

constexpr double hinge_radius = 2.4, hinge_inset = 4.5;  // [pt]
constexpr double label_size = 6.5;                       // [pt]
/// Texts of values below this share of the largest value of the picture are left out.
constexpr double least_label = 0.04;
/// An extreme value closer than this share of it to the value at an end has no text of its own.
constexpr double alike = 0.03;
constexpr std::size_t most_labels = 60;

/// A value with the tip of its ordinate on the page, and the direction away from the axis.
struct ValueLabel {
  double value;
  PagePoint tip, away;
};

PagePoint tip_of(const SceneDiagram& d, std::size_t i, const SceneView& view, const PageView& page) {
  const double scale = view.longest_ordinate / view.largest_ordinate;
  return page.place(d.axis[i] + scale * d.value[i] * d.towards[i]);
}

/// One strip between two points, which changes its colour where the value changes its sign.
void draw_strip(Canvas& canvas, const PagePoint& a, const PagePoint& b, const PagePoint& tip_a, const PagePoint& tip_b,
                double value_a, double value_b) {
  if (value_a * value_b < 0) {
    const double share = value_a / (value_a - value_b);
    const PagePoint zero = a + share * (b - a);
    draw_strip(canvas, a, zero, tip_a, zero, value_a, 0);
    draw_strip(canvas, zero, b, zero, tip_b, 0, value_b);
    return;
  }
  const double sign = value_a + value_b;
  if (sign == 0) return;
  canvas.polygon({a, tip_a, tip_b, b}, diagram_fill(sign), std::nullopt);
  canvas.line(tip_a, tip_b, {diagram_line(sign), 0.7});
}

void draw_diagram(Canvas& canvas, const SceneDiagram& d, const SceneView& view, const PageView& page) {
  const std::size_t count = d.axis.size();
  for (std::size_t i = 0; i + 1 < count; ++i)
    draw_strip(canvas, page.place(d.axis[i]), page.place(d.axis[i + 1]), tip_of(d, i, view, page),
               tip_of(d, i + 1, view, page), d.value[i], d.value[i + 1]);
  for (const std::size_t end : {std::size_t{0}, count - 1})
    if (d.value[end] != 0)
      canvas.line(page.place(d.axis[end]), tip_of(d, end, view, page), {diagram_line(d.value[end]), 0.7});
  std::vector<PagePoint> axis;
  for (const Vec2& p : d.axis) axis.push_back(page.place(p));
  canvas.polyline(std::move(axis), {palette().ink, 0.5});
}

/// The values at both ends of a diagram and the largest ones of both signs.
void add_labels(const SceneDiagram& d, const SceneView& view, const PageView& page, std::vector<ValueLabel>& labels) {
  const auto [low, high] = std::minmax_element(d.value.begin(), d.value.end());
  std::vector<std::size_t> at{0, d.value.size() - 1};
  for (const auto& extreme : {low, high}) {
    const auto is_told = [&](std::size_t i) { return std::abs(d.value[i] - *extreme) < alike * view.largest_ordinate; };
    if (std::ranges::none_of(at, is_told)) at.push_back(static_cast<std::size_t>(extreme - d.value.begin()));
  }
  for (const std::size_t i : at) {
    if (std::abs(d.value[i]) < least_label * view.largest_ordinate) continue;
    const PagePoint tip = tip_of(d, i, view, page), reach = tip - page.place(d.axis[i]);
    labels.push_back({d.value[i], tip, reach.norm() > 0 ? PagePoint(reach.normalized()) : PagePoint(0, -1)});
  }
}

/// Largest values first; a text that would cover another one, or a mark, is left out.
void draw_labels_of(Canvas& canvas, std::vector<ValueLabel> labels, const Scene& scene, const SceneView& view,
                    const PageView& page, std::vector<PageBox>& marks) {
  std::stable_sort(labels.begin(), labels.end(),
                   [](const ValueLabel& a, const ValueLabel& b) { return std::abs(a.value) > std::abs(b.value); });
  if (labels.size() > most_labels) labels.resize(most_labels);
  const TextStyle style{label_size, false, palette().ink, Align::centre};
  for (const ValueLabel& label : labels) {
    const std::string text = quantity_text(label.value, scene.diagram_unit, view.units);
    const double wide = 0.5 * text_width(text, style) + 1.5, tall = 0.5 * label_size + 1;
    // The text's box touches the tip from outside.
    const double reach =
        std::min(wide / std::max(1e-9, std::abs(label.away.x())), tall / std::max(1e-9, std::abs(label.away.y())));
    const PagePoint middle = label.tip + (reach + 1) * label.away;
    const PageBox box{middle.x() - wide, middle.y() - tall, middle.x() + wide, middle.y() + tall};
    const bool inside = box.x0 > page.box.x0 && box.x1 < page.box.x1 && box.y0 > page.box.y0 && box.y1 < page.box.y1;
    if (!inside || std::ranges::any_of(marks, [&](const PageBox& m) { return m.overlaps(box); })) continue;
    Colour paper = palette().paper;
    paper.opacity = 0.75;
    canvas.rectangle(box, paper, std::nullopt);
    canvas.text(middle + PagePoint(0, 0.36 * label_size), text, style);
    marks.push_back(box);
  }
}

}  // namespace

Colour diagram_line(double sign) {
  return sign >= 0 ? palette().force : hex_colour("#b4541b");
}

Colour diagram_fill(double sign) {
  Colour fill = blend(palette().paper, diagram_line(sign), 0.55);
  fill.opacity = 0.45;
  return fill;
}

void draw_diagrams(Canvas& canvas, const Scene& scene, const SceneView& view, const PageView& page,
                   std::vector<PageBox>& marks) {
  if (!(view.largest_ordinate > 0)) return;
  std::vector<ValueLabel> labels;
  for (const SceneDiagram& d : scene.diagrams) {
    if (d.axis.size() < 2) continue;
    draw_diagram(canvas, d, view, page);
    add_labels(d, view, page, labels);
  }
  draw_labels_of(canvas, std::move(labels), scene, view, page, marks);
}

void draw_hinges(Canvas& canvas, const Scene& scene, const PageView& page, std::vector<PageBox>& marks) {
  for (const SceneHinge& h : scene.hinges) {
    const PagePoint inward(h.inward.x(), -h.inward.y());
    const PagePoint at = page.place(h.at) + hinge_inset * inward;
    draw_hinge_mark(canvas, at, h.state);
    marks.push_back({at.x() - hinge_radius, at.y() - hinge_radius, at.x() + hinge_radius, at.y() + hinge_radius});
  }
}

void draw_hinge_mark(Canvas& canvas, const PagePoint& at, HingeMark state) {
  const Palette& p = palette();
  const double r = hinge_radius;
  const Stroke thin{p.ink, 0.6};
  switch (state) {
    case HingeMark::elastic:
      return canvas.circle(at, r, p.paper, thin);
    case HingeMark::yielded:
      return canvas.circle(at, r, p.yielded, thin);
    case HingeMark::lost:
      return canvas.circle(at, r, p.failed, thin);
    case HingeMark::fibres:
      return canvas.circle(at, 0.6 * r, p.yielded, Stroke{p.ink, 0.35});
    case HingeMark::removed:
      break;
  }
  for (const double slope : {-1.0, 1.0})
    canvas.line(at + PagePoint(-r, slope * r), at + PagePoint(r, -slope * r), {p.failed, 1.3});
}

std::string hinge_text(HingeMark state) {
  switch (state) {
    case HingeMark::elastic:
      return "hinge elastic";
    case HingeMark::yielded:
      return "hinge yielded";
    case HingeMark::lost:
      return "hinge without moment";
    case HingeMark::fibres:
      return "fibres yielded";
    case HingeMark::removed:
      break;
  }
  return "member removed";
}

}  // namespace trilith::draw
