#include "element/section/section_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Heights of the lowest and the highest fibre [m].
struct Heights {
  double low, high;
};

Heights heights_of(const FibreSection& section) {
  const auto [low, high] = std::minmax_element(section.fibres.begin(), section.fibres.end(),
                                               [](const Fibre& a, const Fibre& b) { return a.height < b.height; });
  return {low->height, high->height};
}

/// A section whose strain only grows: its memory at the last point.
class PushedSection {
 public:
  PushedSection(const FibreSection& section, double normal)
      : section_(section),
        normal_(normal),
        before_(static_cast<std::size_t>(section.memory_size())),
        after_(before_.size()),
        scale_(section.stiffest()(0, 0) * 1e-4 + std::abs(normal)) {}

  /// The axial strain that balances the normal force at a curvature; none if there is none near the last one.
  std::optional<double> balance(double curvature) {
    double axial = axial_;
    for (int i = 0; i < 40; ++i) {
      const SectionResponse r = at(axial, curvature);
      const double off = r.normal - normal_;
      if (std::abs(off) <= 1e-9 * scale_) return axial;
      if (!(r.tangent(0, 0) > 1e-6 * section_.stiffest()(0, 0))) break;
      const double step = off / r.tangent(0, 0);
      axial -= std::clamp(step, -longest_step, longest_step);
    }
    return search(curvature);
  }

  SectionResponse at(double axial, double curvature) { return respond(section_, {axial, curvature}, before_, after_); }

  void accept(double axial, double curvature) {
    at(axial, curvature);
    before_.swap(after_);
    axial_ = axial;
  }

 private:
  static constexpr double longest_step = 1e-3, farthest = 0.05;

  /// Bisection in the interval nearest to the last strain in which the force passes the given one.
  std::optional<double> search(double curvature) {
    constexpr double step = 1e-4;
    const auto off = [&](double axial) { return at(axial, curvature).normal - normal_; };
    double up = axial_, down = axial_, off_up = off(up), off_down = off_up;
    for (double far = step; far <= farthest; far += step) {
      const double next_up = off(axial_ + far), next_down = off(axial_ - far);
      if (next_up * off_up <= 0) return bisect(up, axial_ + far, off_up, off);
      if (next_down * off_down <= 0) return bisect(down, axial_ - far, off_down, off);
      up = axial_ + far, off_up = next_up, down = axial_ - far, off_down = next_down;
    }
    return std::nullopt;
  }

  template <class Off>
  std::optional<double> bisect(double a, double b, double off_a, const Off& off) {
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (a + b), value = off(middle);
      if (std::abs(value) <= 1e-9 * scale_) return middle;
      if (value * off_a > 0)
        a = middle, off_a = value;
      else
        b = middle;
    }
    // A law whose stress jumps (a crack) has no exact balance there.
    return std::abs(off(b)) < 1e-3 * scale_ ? std::optional(b) : std::nullopt;
  }

  const FibreSection& section_;
  double normal_, axial_ = 0;
  std::vector<double> before_, after_;
  double scale_;  // [N]
};

/// The limit that a strain distribution exceeds, or "".
std::string limit_beyond(const Heights& heights, double axial, double curvature, const SectionLimits& limits) {
  for (const double height : {heights.low, heights.high}) {
    const double strain = axial - height * curvature;
    if (strain < -limits.compression) return "compression";
    if (strain > limits.tension) return "tension";
  }
  return "";
}

/// The first point between two curvatures at which a fibre yields.
SectionPoint yield_between(PushedSection& pushed, double low, double high) {
  SectionPoint out;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    const std::optional<double> axial = pushed.balance(middle);
    if (!axial) break;
    const SectionResponse r = pushed.at(*axial, middle);
    (r.yielding ? high : low) = middle;
    if (r.yielding) out = {middle, *axial, r.moment};
  }
  return out;
}

/// Largest normal force of one sign that the section carries without bending, and its strain.
struct AxialPeak {
  double force = 0, strain = 0;
};

AxialPeak axial_peak(const FibreSection& section, double limit) {
  constexpr int steps = 400;
  PushedSection pushed(section, 0);
  AxialPeak out;
  for (int i = 1; i <= steps; ++i) {
    const double strain = limit * i / steps;
    const double force = pushed.at(strain, 0).normal;
    pushed.accept(strain, 0);
    if (std::abs(force) > std::abs(out.force) && force * limit > 0) out = {force, strain};
  }
  return out;
}

}  // namespace

MomentCurvature moment_curvature(const FibreSection& section, double normal, double curvature, int steps,
                                 const SectionLimits& limits) {
  const Heights heights = heights_of(section);
  PushedSection pushed(section, normal);
  MomentCurvature out;
  out.end = "curvature";
  for (int i = 0; i <= steps; ++i) {
    const double now = curvature * i / steps;
    const std::optional<double> axial = pushed.balance(now);
    if (!axial) {
      out.end = "no equilibrium";
      break;
    }
    const std::string limit = limit_beyond(heights, *axial, now, limits);
    if (!limit.empty()) {
      out.end = limit;
      break;
    }
    const SectionResponse r = pushed.at(*axial, now);
    if (r.yielding && !out.yield && i > 0) out.yield = yield_between(pushed, curvature * (i - 1) / steps, now);
    out.points.push_back({now, *axial, r.moment});
    if (!out.largest || std::abs(r.moment) > std::abs(out.largest->moment)) out.largest = out.points.back();
    pushed.accept(*axial, now);
  }
  return out;
}

double longest_curvature(const FibreSection& section, const SectionLimits& limits) {
  const Heights heights = heights_of(section);
  const double depth = heights.high - heights.low;
  return depth > 0 ? (limits.compression + limits.tension) / depth : 0;
}

std::vector<InteractionPoint> interaction(const FibreSection& section, int points, const SectionLimits& limits) {
  constexpr int steps = 400;
  if (points < 3) throw InputError(fmt::format("interaction: points is {}, must be at least 3", points));
  const AxialPeak least = axial_peak(section, -limits.compression), most = axial_peak(section, limits.tension);
  const double longest = longest_curvature(section, limits);
  std::vector<InteractionPoint> out;
  for (int i = 0; i < points; ++i) {
    const double normal = least.force + (most.force - least.force) * i / (points - 1);
    InteractionPoint point{normal, 0, 0};
    if (i == 0 || i + 1 == points) {
      PushedSection pushed(section, normal);
      const double moment = pushed.at(i == 0 ? least.strain : most.strain, 0).moment;
      point.sagging = std::max(0.0, moment), point.hogging = std::min(0.0, moment);
    } else {
      for (const SectionPoint& p : moment_curvature(section, normal, longest, steps, limits).points)
        point.sagging = std::max(point.sagging, p.moment);
      for (const SectionPoint& p : moment_curvature(section, normal, -longest, steps, limits).points)
        point.hogging = std::min(point.hogging, p.moment);
    }
    out.push_back(point);
  }
  return out;
}

}  // namespace trilith
