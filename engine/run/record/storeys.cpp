#include "run/record/storeys.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "base/portable.hpp"
#include "model/contact/skin_places.hpp"

namespace trilith {
namespace {

constexpr std::string_view storey_word = "storey ";

/// Index of the vertical axis: y in the plane, z in space.
template <int D>
constexpr int upright = D - 1;

bool is_in(const Body& body, std::string_view group) {
  return std::find(body.groups.begin(), body.groups.end(), group) != body.groups.end();
}

bool is_floor(const Body& body) {
  return is_in(body, "slabs") || is_in(body, "slab") || is_in(body, "floors");
}

/// If there are slabs, they are the floor and not the beams below them: the storey above stands on the slab.
std::vector<int> floors_among(const auto& model, const std::vector<int>& bodies) {
  std::vector<int> beams, slabs;
  for (const int body : bodies)
    if (const Body& b = model.bodies[static_cast<std::size_t>(body)]; is_floor(b))
      (is_in(b, "beams") ? beams : slabs).push_back(body);
  return slabs.empty() ? beams : slabs;
}

struct Extent {
  double low = unbounded, high = -unbounded;
};

/// Radius of the spheres of a body in space, whose skin contains only their centres.
double round_reach(const Model<2>& /*model*/, const Body& /*body*/) {
  return 0;
}
double round_reach(const Model<3>& model, const Body& body) {
  double most = 0;
  for (int piece = body.first_piece; piece < body.first_piece + body.pieces; ++piece)
    if (const ConvexSolid& solid = model.piece_solid[piece]; solid.is_sphere()) most = std::max(most, solid.radius);
  return most;
}

template <int D>
Extent extent_of(const Model<D>& model, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const double reach = round_reach(model, b);
  Extent e;
  for (int s = b.first_skin; s < b.first_skin + b.skins; ++s) {
    const double at = skin_start(model, s)[upright<D>];
    e.low = std::min(e.low, at - reach);
    e.high = std::max(e.high, at + reach);
  }
  return e;
}

/// Sets the extent of a storey: from the top of the storey below, or its own lowest point, to its highest point. Its
/// top is its floor; without a floor, all bodies that reach its highest point within a thousandth of its height.
template <int D>
void lay_storey(const Model<D>& model, Storey& storey, double below) {
  constexpr double same_height = 1e-3;  // share of the storey's height
  Extent all;
  for (const int body : storey.bodies) {
    const Extent e = extent_of(model, body);
    all.low = std::min(all.low, e.low);
    all.high = std::max(all.high, e.high);
  }
  storey.top = floors_among(model, storey.bodies);
  storey.bottom = below > -unbounded ? below : all.low;
  storey.height = all.high - storey.bottom;
  if (!storey.top.empty()) return;
  for (const int body : storey.bodies)
    if (extent_of(model, body).high >= all.high - same_height * storey.height) storey.top.push_back(body);
}

/// The highest top of the base that is not above a storey's lowest point, because drift is measured from the base.
/// Bearings or columns without a group may lie between the two. -unbounded if there is none.
template <int D>
double level_of_base(const Model<D>& model, const Storey& storey) {
  double low = unbounded, level = -unbounded;
  for (const int body : storey.bodies) low = std::min(low, extent_of(model, body).low);
  for (const int body : find_base(model))
    if (const double high = extent_of(model, body).high; high <= low) level = std::max(level, high);
  return level;
}

/// True if a node of the body is free along a horizontal axis.
template <int D>
bool moves_sideways(const Model<D>& model, const Body& body) {
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    for (int k = 0; k < upright<D>; ++k)
      if (model.support[n][k] == Support::free) return true;
  return false;
}

}  // namespace

int storey_in(const std::vector<std::string>& groups) {
  for (const std::string& group : groups) {
    if (!std::string_view(group).starts_with(storey_word)) continue;
    int number = 0;
    const char* const end = group.data() + group.size();
    const auto [stop, error] = std::from_chars(group.data() + storey_word.size(), end, number);
    if (error == std::errc() && stop == end && number > 0) return number;
  }
  return 0;
}

template <int D>
int storey_of(const Model<D>& model, int body) {
  return storey_in(model.bodies[static_cast<std::size_t>(body)].groups);
}

template <int D>
int storey_between(const Model<D>& model, int body_a, int body_b) {
  const auto height = [&](int body) {
    return model.start_position[model.bodies[static_cast<std::size_t>(body)].first_node][upright<D>];
  };
  const bool a_is_upper = height(body_a) > height(body_b);
  const int upper = storey_of(model, a_is_upper ? body_a : body_b);
  return upper > 0 ? upper : storey_of(model, a_is_upper ? body_b : body_a);
}

template <int D>
std::vector<Storey> find_storeys(const Model<D>& model) {
  std::map<int, Storey> by_number;
  for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body)
    if (const int number = storey_of(model, body); number > 0) by_number[number].bodies.push_back(body);
  std::vector<Storey> storeys;
  for (auto& [number, storey] : by_number) {
    storey.number = number;
    lay_storey(model, storey,
               storeys.empty() ? level_of_base(model, storey) : storeys.back().bottom + storeys.back().height);
    storeys.push_back(std::move(storey));
  }
  return storeys;
}

template <int D>
std::vector<int> find_base(const Model<D>& model) {
  std::vector<int> base, held;
  for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body) {
    const Body& b = model.bodies[static_cast<std::size_t>(body)];
    if (is_in(b, "base")) base.push_back(body);
    if (!moves_sideways(model, b)) held.push_back(body);
  }
  return base.empty() ? held : base;
}

/// Every body has the same weight, independent of its number of nodes. A removed body stays where it was: a body that
/// has cracked is replaced by its parts.
template <int D>
Vec<D> mean_displacement(const Model<D>& model, const State<D>& state, const std::vector<int>& bodies) {
  std::vector<int> present;
  for (const int body : bodies)
    if (!state.is_removed(static_cast<std::size_t>(body))) present.push_back(body);
  if (!present.empty() && present.size() < bodies.size()) return mean_displacement(model, state, present);
  Vec<D> sum = Vec<D>::Zero();
  for (const int body : bodies) {
    const Body& b = model.bodies[static_cast<std::size_t>(body)];
    Vec<D> own = Vec<D>::Zero();
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n) own += state.position[n] - model.start_position[n];
    sum += own / static_cast<double>(b.nodes);
  }
  return bodies.empty() ? sum : Vec<D>(sum / static_cast<double>(bodies.size()));
}

template <int D>
Vec<D> storey_drift(const Model<D>& model, const State<D>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index) {
  return mean_displacement(model, state, storeys[index].top) -
         mean_displacement(model, state, index == 0 ? base : storeys[index - 1].top);
}

template <int D>
Vec<D> top_drift(const Model<D>& model, const State<D>& state, const std::vector<Storey>& storeys,
                 const std::vector<int>& base) {
  if (storeys.empty()) return Vec<D>::Zero();
  return mean_displacement(model, state, storeys.back().top) - mean_displacement(model, state, base);
}

double level_part(const Vec2& drift) {
  return drift.x();
}
double level_part(const Vec3& drift) {
  return portable::hypot(drift.x(), drift.y());
}

/// With r from the mean of all points at the start and p from their present mean, seen from above: the rotation that
/// minimises the sum of |p - R r|^2 has tan = sum of r x p / sum of r . p (plane Procrustes problem).
double mean_twist(const Model<3>& model, const State<3>& state, const std::vector<int>& bodies) {
  Vec3 start = Vec3::Zero(), now = Vec3::Zero();
  double count = 0;
  const auto each_point = [&](auto&& take) {
    for (const int body : bodies) {
      const Body& b = model.bodies[static_cast<std::size_t>(body)];
      for (int s = b.first_skin; s < b.first_skin + b.skins; ++s) take(skin_start(model, s), skin_now(model, state, s));
    }
  };
  each_point([&](const Vec3& r, const Vec3& p) { start += r, now += p, ++count; });
  if (count == 0) return 0;
  start /= count, now /= count;
  double across = 0, along = 0;
  each_point([&](const Vec3& r, const Vec3& p) {
    const Vec3 from = r - start, to = p - now;
    across += from.x() * to.y() - from.y() * to.x(), along += from.x() * to.x() + from.y() * to.y();
  });
  return across == 0 && along == 0 ? 0 : portable::atan2(across, along);
}

double storey_twist(const Model<3>& model, const State<3>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index) {
  const double twist = mean_twist(model, state, storeys[index].top) -
                       mean_twist(model, state, index == 0 ? base : storeys[index - 1].top);
  return std::remainder(twist, 2 * std::numbers::pi);
}

template std::vector<Storey> find_storeys(const Model<2>&);
template std::vector<Storey> find_storeys(const Model<3>&);
template std::vector<int> find_base(const Model<2>&);
template std::vector<int> find_base(const Model<3>&);
template int storey_of(const Model<2>&, int);
template int storey_of(const Model<3>&, int);
template int storey_between(const Model<2>&, int, int);
template int storey_between(const Model<3>&, int, int);
template Vec2 mean_displacement(const Model<2>&, const State<2>&, const std::vector<int>&);
template Vec3 mean_displacement(const Model<3>&, const State<3>&, const std::vector<int>&);
template Vec2 storey_drift(const Model<2>&, const State<2>&, const std::vector<Storey>&, const std::vector<int>&,
                           std::size_t);
template Vec3 storey_drift(const Model<3>&, const State<3>&, const std::vector<Storey>&, const std::vector<int>&,
                           std::size_t);
template Vec2 top_drift(const Model<2>&, const State<2>&, const std::vector<Storey>&, const std::vector<int>&);
template Vec3 top_drift(const Model<3>&, const State<3>&, const std::vector<Storey>&, const std::vector<int>&);

}  // namespace trilith
