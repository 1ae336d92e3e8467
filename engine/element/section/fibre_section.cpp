#include "element/section/fibre_section.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "element/section/fibre_lanes.hpp"

namespace trilith {

namespace {

/// Levels nearer to each other than this times the depth are one.
constexpr double same_level = 1e-9;

/// Equal layers, cut further where the width of shape or core is discontinuous, from the bottom up.
std::vector<double> levels_of(const FibreSpec& spec, double depth, const FibreShape* core) {
  std::vector<double> all = borders_of(spec.shape);
  for (int i = 1; i < spec.layers; ++i) all.push_back(depth * i / spec.layers);
  if (core != nullptr)
    for (const double level : borders_of(*core)) all.push_back(spec.cover + level);
  std::sort(all.begin(), all.end());
  std::vector<double> out;
  for (const double level : all)
    if (out.empty() || level - out.back() > same_level * depth) out.push_back(level);
  return out;
}

/// Two fibres for a layer with moments about the bottom, which is `below` under the centroid of the whole.
void add_layer(const StripMoments& layer, double below, double least_area, std::vector<Fibre>& out) {
  if (layer.area <= least_area) return;
  const double centroid = layer.first / layer.area;
  const double gyration = std::sqrt(std::max(0.0, layer.second / layer.area - centroid * centroid));
  // Half of the area at plus and minus the radius of gyration conserves area, centroid and second moment.
  for (const double way : {-1.0, 1.0}) out.push_back({layer.area / 2, centroid - below + way * gyration});
}

/// Fibres with one law are stored together, for one loop over them.
void add_part(const UniaxialLaw& law, const std::vector<Fibre>& fibres, FibreSection& section) {
  if (fibres.empty()) return;
  section.parts.push_back({law, static_cast<int>(section.fibres.size()), static_cast<int>(fibres.size())});
  section.fibres.insert(section.fibres.end(), fibres.begin(), fibres.end());
}

void check_law(const UniaxialLaw& law) {
  std::visit(
      [](const auto& l) {
        check_parameters(l);
        if constexpr (requires { l.check(); }) l.check();
      },
      law);
}

void check_fibre_spec(const FibreSpec& spec, double depth) {
  if (spec.layers < 1 || spec.layers > 1000)
    throw InputError(fmt::format("fibres: layers is {}, must be 1 to 1000", spec.layers));
  if (!(spec.cover >= 0)) throw InputError(fmt::format("fibres: cover is {:g} m, must not be below 0", spec.cover));
  check_law(spec.law);
  if (spec.cover > 0 || spec.core) check_law(spec.cover_law);
  if (!spec.bars.empty()) check_law(spec.bar_law);
  for (const FibreBars& bar : spec.bars)
    if (!(bar.area > 0) || !(bar.height >= 0 && bar.height <= depth))
      throw InputError(fmt::format("fibres: bars of {:g} m2 at a height of {:g} m; the section is {:g} m deep",
                                   bar.area, bar.height, depth));
  for (const FibreBars& bar : spec.bars)
    if (bar.count < 1 || bar.count > 1000 || !(bar.spread >= 0))
      throw InputError(fmt::format(
          "fibres: bars at a height of {:g} m: count is {} and spread {:g} m, must be 1 to 1000 and not below 0",
          bar.height, bar.count, bar.spread));
}

/// Adds the response of the fibres with one law to `out`. Strain e = e_0 - y k of each fibre; N += s A, M -= s A y, and
/// their derivatives by e_0 and k.
template <UniaxialLawType L>
void respond_one_by_one(const L& given, std::span<const Fibre> fibres, const SectionStrain& strain,
                        const double* before, double* after, SectionResponse& out) {
  const L law = given;  // `after` cannot point into a copy, so its constants leave the loop
  double normal = out.normal, moment = out.moment, axial = out.tangent(0, 0), coupled = out.tangent(0, 1),
         bending = out.tangent(1, 1), stored = out.stored, dissipated = out.dissipated;
  bool yielding = out.yielding;
  for (const Fibre& f : fibres) {
    typename L::Memory memory;
    for (double& m : memory) m = *before++;
    const UniaxialResponse<L::memory_size> r = law.respond(strain.axial - f.height * strain.curvature, memory);
    for (const double m : r.memory) *after++ = m;
    const double force = r.stress() * f.area, stiffness = r.tangent * f.area, arm = -f.height;
    normal += force, moment += arm * force;
    axial += stiffness, coupled += arm * stiffness, bending += arm * arm * stiffness;
    stored += r.stored * f.area, dissipated += r.dissipated * f.area;
    yielding = yielding || r.yielding;
  }
  out.normal = normal, out.moment = moment, out.stored = stored, out.dissipated = dissipated, out.yielding = yielding;
  out.tangent(0, 0) = axial, out.tangent(0, 1) = coupled, out.tangent(1, 1) = bending;
}

/// The sums of respond_one_by_one over four fibres at a time.
struct PlaneSums {
  const SectionStrain& given;
  FourSums forces, rest;
  LaneMask yielding;

  TRILITH_INLINE PlaneSums(const SectionStrain& strain, const SectionResponse& out)
      : given(strain),
        forces{Lanes{out.normal, out.moment, out.tangent(0, 0), out.tangent(0, 1)}},
        rest{Lanes{out.tangent(1, 1), out.stored, out.dissipated, 0}},
        yielding{} {}
  TRILITH_INLINE static Lanes height(const Fibre* f) {
    return Lanes{f[0].height, f[1].height, f[2].height, f[3].height};
  }
  TRILITH_INLINE Lanes strain(const Fibre* f) const { return given.axial - height(f) * given.curvature; }
  TRILITH_INLINE void add(const Fibre* f, const ConcreteFourResponse& r) {
    const Lanes area{f[0].area, f[1].area, f[2].area, f[3].area}, arm = -height(f);
    const Lanes force = r.memory.stress * area, stiffness = r.tangent * area;
    forces.add(force, arm * force, stiffness, arm * stiffness);
    rest.add(arm * arm * stiffness, r.stored * area, r.dissipated * area, Lanes{});
    yielding |= r.yielding;
  }
  TRILITH_INLINE void take(SectionResponse& out) const {
    out.normal = forces.sum[0], out.moment = forces.sum[1];
    out.tangent(0, 0) = forces.sum[2], out.tangent(0, 1) = forces.sum[3], out.tangent(1, 1) = rest.sum[0];
    out.stored = rest.sum[1], out.dissipated = rest.sum[2];
    out.yielding = out.yielding || any(yielding);
  }
};

template <UniaxialLawType L>
void respond_part(const L& law, std::span<const Fibre> fibres, const SectionStrain& strain, const double* before,
                  double* after, SectionResponse& out) {
  const std::size_t done = respond_in_lanes<PlaneSums>(law, fibres, strain, before, after, out);
  const std::size_t place = done * L::memory_size;
  respond_one_by_one(law, fibres.subspan(done), strain, before + place, after + place, out);
}

/// The laws of the parts that the section has; null for the others.
template <class Spec>
auto used_laws(Spec& spec) -> std::array<decltype(&spec.law), 3> {
  return {&spec.law, spec.cover > 0 || spec.core ? &spec.cover_law : nullptr,
          spec.bars.empty() ? nullptr : &spec.bar_law};
}

}  // namespace

int FibreSection::memory_size() const {
  int size = 0;
  for (const FibrePart& p : parts) size += p.count * trilith::memory_size(p.law);
  return size;
}

/// Sum of E A (1, -y)(1, -y)', with the largest slope E of each law.
Eigen::Matrix2d FibreSection::stiffest() const {
  Eigen::Matrix2d out = Eigen::Matrix2d::Zero();
  for (const FibrePart& p : parts) {
    const double young = trilith::stiffest(p.law);
    for (const Fibre& f : std::span(fibres).subspan(p.first, p.count)) {
      const Eigen::Vector2d arm(1, -f.height);
      out += young * f.area * arm * arm.transpose();
    }
  }
  return out;
}

bool depends_on_length(const FibreSpec& spec) {
  const auto laws = used_laws(spec);
  return std::ranges::any_of(laws, [](const UniaxialLaw* law) { return law && trilith::depends_on_length(*law); });
}

FibreSpec for_length(FibreSpec spec, double length) {
  for (UniaxialLaw* const law : used_laws(spec))
    if (law) check_law(*law), *law = law_for_length(*law, length);
  return spec;
}

/// For each layer the core part, and the rest as cover. Bars are added at their height.
FibreSection make_fibres(const FibreSpec& spec) {
  const Section whole = section_of(spec.shape);
  check_fibre_spec(spec, whole.depth());
  std::optional<FibreShape> core = spec.core;
  if (!core && spec.cover > 0) core = core_of(spec.shape, spec.cover);
  const std::vector<double> levels = levels_of(spec, whole.depth(), core ? &*core : nullptr);
  const double least = 1e-12 * whole.area;
  std::vector<Fibre> inside, outside;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    StripMoments layer = strip_of(spec.shape, levels[i], levels[i + 1]);
    if (core) {
      const StripMoments low = strip_of(*core, levels[i] - spec.cover, levels[i + 1] - spec.cover);
      // The core's moments are about its own bottom.
      const StripMoments held{low.area, low.first + spec.cover * low.area,
                              low.second + spec.cover * (2 * low.first + spec.cover * low.area)};
      layer -= held;
      if (layer.area < -1e-9 * whole.area) throw InputError("fibres: the core reaches beyond the shape");
      add_layer(held, whole.below, least, inside);
    }
    add_layer(layer, whole.below, least, core ? outside : inside);
  }
  std::vector<Fibre> bars;
  for (const FibreBars& bar : spec.bars) bars.push_back({bar.area, bar.height - whole.below});
  FibreSection out;
  add_part(spec.law, inside, out);
  add_part(spec.cover_law, outside, out);
  add_part(spec.bar_law, bars, out);
  return out;
}

/// Part by part, in the order of fibres and memories.
SectionResponse respond(const FibreSection& section, const SectionStrain& strain, std::span<const double> before,
                        std::span<double> after) {
  assert(before.size() == after.size() && static_cast<int>(after.size()) == section.memory_size());
  SectionResponse out;
  std::size_t place = 0;
  for (const FibrePart& p : section.parts)
    std::visit(
        [&](const auto& law) {
          respond_part(law, std::span(section.fibres).subspan(p.first, p.count), strain, before.data() + place,
                       after.data() + place, out);
          place += static_cast<std::size_t>(p.count) * std::decay_t<decltype(law)>::memory_size;
        },
        p.law);
  out.tangent(1, 0) = out.tangent(0, 1);
  return out;
}

}  // namespace trilith
