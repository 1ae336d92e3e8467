#include "load/motion_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "load/response_spectrum.hpp"

namespace trilith {
namespace {

/// Processing works on samples; a motion that was scaled or delayed by its factors would lose these.
void require_as_read(const GroundMotion& motion, const char* what) {
  if (motion.amplitude_factor() == 1 && motion.start_time() == 0) return;
  throw InputError(fmt::format("{}: motion '{}' is {} already; apply this to the original record, then {} it", what,
                               motion.description(), motion.start_time() == 0 ? "scaled" : "delayed",
                               motion.start_time() == 0 ? "scale" : "delay"));
}

/// Rejects excessive numbers of samples: a step or a pad in a wrong unit requests billions.
void require_samples(double count, const GroundMotion& motion, const std::string& asked) {
  if (count <= most_samples) return;
  throw InputError(fmt::format("{} makes {:.3g} samples of '{}' ({:g} s every {:g} s), at most {:.3g} are made", asked,
                               count, motion.description(), motion.duration(), motion.step(), most_samples));
}

std::vector<double> accelerations(const GroundMotion& motion) {
  std::vector<double> a;
  for (const MotionAt& sample : motion.samples()) a.push_back(sample.acceleration);
  return a;
}

/// A motion with new samples; its description, made of the source's file or title, contains the processing step.
GroundMotion processed(const GroundMotion& motion, const std::vector<double>& a, double step, const std::string& done) {
  MotionSource source = motion.source();
  (source.file.empty() ? source.title : source.file) += ", " + done;
  return {a, step, motion.start(), std::move(source)};
}

/// One section of a filter: y = b0 x + b1 x1 + b2 x2 - a1 y1 - a2 y2.
struct Section {
  double b0, b1, b2, a1, a2;
};

/// Input: order n, corner w_c = tan(pi f dt) of the bilinear transform. Output: the sections of the digital Butterworth
/// filter. Its poles lie on a circle of radius w_c; a pair at angle theta gives s^2 + 2 cos(theta) w_c s + w_c^2, a
/// single one s + w_c. With s = (1 - 1/z) / (1 + 1/z), and for a high-pass s^2 or s instead of w_c^2 or w_c above.
std::vector<Section> butterworth_sections(int order, double wc, bool high_pass) {
  std::vector<Section> sections;
  for (int k = 0; k < order / 2; ++k) {
    // The first pair is at half the angle between neighbours from the axis, or at the whole angle if a single pole is
    // on the axis.
    const double angle = std::numbers::pi * (order % 2 == 0 ? k + 0.5 : k + 1) / order;
    const double damping = 2 * portable::cos(angle) * wc, square = wc * wc, sum = 1 + damping + square;
    const double top = (high_pass ? 1 : square) / sum, middle = high_pass ? -2 * top : 2 * top;
    sections.push_back({top, middle, top, 2 * (square - 1) / sum, (1 - damping + square) / sum});
  }
  if (order % 2 == 1) {
    const double top = (high_pass ? 1 : wc) / (1 + wc);
    sections.push_back({top, high_pass ? -top : top, 0, (wc - 1) / (1 + wc), 0});
  }
  return sections;
}

void pass(std::vector<double>& x, const Section& s) {
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (double& value : x) {
    const double y = s.b0 * value + s.b1 * x1 + s.b2 * x2 - s.a1 * y1 - s.a2 * y2;
    x2 = x1, x1 = value, y2 = y1, y1 = y;
    value = y;
  }
}

/// Forward, then backward.
void pass_both_ways(std::vector<double>& x, const std::vector<Section>& sections) {
  for (int way = 0; way < 2; ++way) {
    for (const Section& s : sections) pass(x, s);
    std::reverse(x.begin(), x.end());
  }
}

/// Ratio of the corner frequency of both passes to the corner of one pass: (sqrt(2) - 1)^(1 / 2n).
double corner_share(int order) {
  return portable::pow(std::numbers::sqrt2 - 1, 1.0 / (2 * order));
}

void filter_side(std::vector<double>& x, double corner, int order, double step, bool high_pass) {
  const double wc = portable::tan(std::numbers::pi * corner * step), share = corner_share(order);
  pass_both_ways(x, butterworth_sections(order, high_pass ? wc * share : wc / share, high_pass));
}

void check_band(const FilterBand& band, double step) {
  const double nyquist = 0.5 / step;
  if (!(band.low > 0 || band.high > 0)) throw InputError("filter: give low, high or both, in Hz");
  for (const double corner : {band.low, band.high})
    if (!(corner >= 0 && corner < nyquist))
      throw InputError(
          fmt::format("filter: a corner of {:g} Hz, must be above 0 and below {:g} Hz, half the rate of the samples",
                      corner, nyquist));
  if (band.low > 0 && band.high > 0 && !(band.low < band.high))
    throw InputError(fmt::format("filter: low is {:g} Hz, must be below high, {:g} Hz", band.low, band.high));
  if (band.order < 1 || band.order > 10)
    throw InputError(fmt::format("filter: order is {}, must be 1 to 10", band.order));
  if (!(band.pad >= 0 && band.pad <= 1e4))
    throw InputError(fmt::format("filter: pad is {:g} s, must be 0 to 10000", band.pad));
}

std::string band_text(const FilterBand& band) {
  const std::string order = fmt::format("Butterworth of order {}", band.order);
  if (band.low > 0 && band.high > 0) return fmt::format("{:g} to {:g} Hz by {}", band.low, band.high, order);
  return band.low > 0 ? fmt::format("above {:g} Hz by {}", band.low, order)
                      : fmt::format("below {:g} Hz by {}", band.high, order);
}

/// Filters `x`, with rest before and after for the ringing time of its slower corner.
std::vector<double> through(std::vector<double> x, const FilterBand& band, double step) {
  const double slowest = band.low > 0 ? band.low : band.high;
  const auto ring =
      std::min<std::size_t>(static_cast<std::size_t>(2.0 * band.order / (slowest * step)) + 1, 10'000'000);
  x.insert(x.begin(), ring, 0.0);
  x.insert(x.end(), ring, 0.0);
  if (band.low > 0) filter_side(x, band.low, band.order, step, true);
  if (band.high > 0) filter_side(x, band.high, band.order, step, false);
  return {x.begin() + static_cast<std::ptrdiff_t>(ring), x.end() - static_cast<std::ptrdiff_t>(ring)};
}

/// Removes the component of `values` along `base`, whose square sums to `square`.
void deactivate(std::vector<double>& values, const std::vector<double>& base, double square) {
  double product = 0;
  for (std::size_t i = 0; i < base.size(); ++i) product += values[i] * base[i];
  for (std::size_t i = 0; i < base.size(); ++i) values[i] -= product / square * base[i];
}

}  // namespace

/// Removes the polynomials that are orthogonal over the samples, each from the two before it (Stieltjes), one by one;
/// twice, so that no rounding error remains.
GroundMotion baseline_corrected(const GroundMotion& motion, int degree) {
  require_as_read(motion, "baseline");
  std::vector<double> a = accelerations(motion);
  const std::size_t n = a.size();
  if (degree < 0 || degree > 10) throw InputError(fmt::format("baseline: degree is {}, must be 0 to 10", degree));
  if (n <= static_cast<std::size_t>(degree) + 1)
    throw InputError(fmt::format("baseline: {} samples are too few for degree {}", n, degree));
  std::vector<double> before(n, 0.0), now(n, 1.0), next(n);
  double square_before = 1;
  for (int k = 0; k <= degree; ++k) {
    double square = 0, middle = 0;
    const auto place = [&](std::size_t i) { return 2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1; };
    for (std::size_t i = 0; i < n; ++i) square += now[i] * now[i], middle += place(i) * now[i] * now[i];
    deactivate(a, now, square);
    deactivate(a, now, square);
    for (std::size_t i = 0; i < n; ++i)
      next[i] = (place(i) - middle / square) * now[i] - (k == 0 ? 0 : square / square_before) * before[i];
    square_before = square;
    std::swap(before, now);
    std::swap(now, next);
  }
  return processed(motion, a, motion.step(), fmt::format("baseline of degree {} removed", degree));
}

/// Filters in both directions, so that no frequency is delayed; the pads contain the ringing beyond the record.
GroundMotion filtered(const GroundMotion& motion, const FilterBand& band) {
  require_as_read(motion, "filter");
  check_band(band, motion.step());
  require_samples((motion.duration() + 2 * band.pad) / motion.step(), motion,
                  fmt::format("filter: pad {:g} s", band.pad));
  std::vector<double> a = accelerations(motion);
  const auto pad = static_cast<std::size_t>(std::llround(band.pad / motion.step()));
  a.insert(a.begin(), pad, 0.0);
  a.insert(a.end(), pad, 0.0);
  return processed(motion, through(std::move(a), band, motion.step()), motion.step(), band_text(band));
}

/// Linear between samples. For a longer step, a low-pass first removes frequencies above 0.8 of half its rate, which it
/// could not represent.
GroundMotion resampled(const GroundMotion& motion, double step) {
  require_as_read(motion, "resample");
  require_positive(step, "resample: step", "s");
  if (!(step <= motion.duration()))
    throw InputError(fmt::format("resample: a step of {:g} s, the motion lasts {:g} s", step, motion.duration()));
  require_samples(motion.duration() / step, motion, fmt::format("resample: a step of {:g} s", step));
  constexpr double slack = 1e-9;  // a step that divides the duration up to rounding reaches its end
  std::vector<double> from = accelerations(motion);
  if (step > motion.step() * (1 + slack)) from = through(std::move(from), {0, 0.4 / step, 8, 0}, motion.step());
  const auto count = static_cast<std::size_t>(motion.duration() / step + slack) + 1;
  std::vector<double> a;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = std::min(static_cast<double>(i) * step / motion.step(), static_cast<double>(from.size() - 1));
    const std::size_t below = std::min(static_cast<std::size_t>(place + slack), from.size() - 2);
    const double part = std::max(0.0, place - static_cast<double>(below));
    a.push_back(from[below] + part * (from[below + 1] - from[below]));
  }
  return processed(motion, a, step, fmt::format("samples every {:g} s", step));
}

std::pair<GroundMotion, GroundMotion> rotated(const GroundMotion& first, const GroundMotion& second, double angle) {
  require_as_read(first, "rotate");
  require_as_read(second, "rotate");
  require_finite(angle, "rotate: angle");
  if (first.step() != second.step() || first.samples().size() != second.samples().size())
    throw InputError(
        fmt::format("rotate: '{}' has {} samples every {:g} s, '{}' has {} every {:g} s; components of one "
                    "record have the same",
                    first.description(), first.samples().size(), first.step(), second.description(),
                    second.samples().size(), second.step()));
  const auto [sine, cosine] = portable::sine_cosine(angle);
  const auto turned = [&](const GroundMotion& one, double c, const GroundMotion& other, double s) {
    std::vector<double> a = accelerations(one);
    const std::vector<double> b = accelerations(other);
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = c * a[i] + s * b[i];
    const MotionStart from = one.start(), across = other.start();
    MotionSource source = one.source();
    (source.file.empty() ? source.title : source.file) +=
        fmt::format(", rotated by {:g} deg", angle * 180 / std::numbers::pi);
    return GroundMotion(a, one.step(),
                        {c * from.velocity + s * across.velocity, c * from.displacement + s * across.displacement},
                        std::move(source));
  };
  return {turned(first, cosine, second, sine), turned(second, cosine, first, -sine)};
}

double factor_to_spectrum(const GroundMotion& motion, SpectrumPoint target, double damping) {
  return factor_to_spectrum(motion, std::span<const SpectrumPoint>(&target, 1), damping);
}

double factor_to_spectrum(const GroundMotion& motion, std::span<const SpectrumPoint> target, double damping) {
  if (target.empty()) throw InputError("spectrum: the target has no points");
  double sum = 0;
  for (const SpectrumPoint& point : target) {
    require_positive(point.acceleration, "spectrum: acceleration of the target", "m/s2");
    const double own = oscillator_peak(motion, point.period, damping).pseudo_acceleration;
    if (!(own > 0)) throw InputError(fmt::format("spectrum: motion '{}' is zero everywhere", motion.description()));
    sum += portable::log(point.acceleration / own);
  }
  return portable::exp(sum / static_cast<double>(target.size()));
}

}  // namespace trilith
