#include "run/storeys.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace trilith {
namespace {

constexpr std::string_view storey_word = "storey ";

bool is_in(const Body& body, std::string_view group) {
  return std::find(body.groups.begin(), body.groups.end(), group) != body.groups.end();
}

struct Extent {
  double low = unbounded, high = -unbounded;
};

Extent extent_of(const Model<2>& model, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  Extent e;
  for (int s = b.first_skin; s < b.first_skin + b.skins; ++s) {
    const int n = model.skin_node[s];
    const double y = model.start_position[n].y() + Turn(model.start_rotation[n]).apply(model.skin_place[s]).y();
    e.low = std::min(e.low, y);
    e.high = std::max(e.high, y);
  }
  return e;
}

/// From the top of the storey below, or its own lowest point, to its own highest; its top is its slabs or, without,
/// what reaches up to there within a thousandth of its height.
void lay_storey(const Model<2>& model, Storey& storey, double below) {
  constexpr double same_height = 1e-3;  // share of the storey's height
  Extent all;
  for (const int body : storey.bodies) {
    const Extent e = extent_of(model, body);
    all.low = std::min(all.low, e.low);
    all.high = std::max(all.high, e.high);
    const Body& b = model.bodies[static_cast<std::size_t>(body)];
    if (is_in(b, "slabs") || is_in(b, "slab")) storey.top.push_back(body);
  }
  storey.bottom = below > -unbounded ? below : all.low;
  storey.height = all.high - storey.bottom;
  if (!storey.top.empty()) return;
  for (const int body : storey.bodies)
    if (extent_of(model, body).high >= all.high - same_height * storey.height) storey.top.push_back(body);
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

int storey_of(const Model<2>& model, int body) {
  return storey_in(model.bodies[static_cast<std::size_t>(body)].groups);
}

std::vector<Storey> find_storeys(const Model<2>& model) {
  std::map<int, Storey> by_number;
  for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body)
    if (const int number = storey_of(model, body); number > 0) by_number[number].bodies.push_back(body);
  std::vector<Storey> storeys;
  for (auto& [number, storey] : by_number) {
    storey.number = number;
    lay_storey(model, storey, storeys.empty() ? -unbounded : storeys.back().bottom + storeys.back().height);
    storeys.push_back(std::move(storey));
  }
  return storeys;
}

std::vector<int> find_base(const Model<2>& model) {
  std::vector<int> base, held;
  for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body) {
    const Body& b = model.bodies[static_cast<std::size_t>(body)];
    if (is_in(b, "base")) base.push_back(body);
    bool moves = false;
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n) moves = moves || model.support[n][0] == Support::free;
    if (!moves) held.push_back(body);
  }
  return base.empty() ? held : base;
}

/// Each body counts alike, whatever nodes it has.
double mean_sway(const Model<2>& model, const State<2>& state, const std::vector<int>& bodies) {
  double sum = 0;
  for (const int body : bodies) {
    const Body& b = model.bodies[static_cast<std::size_t>(body)];
    double own = 0;
    for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
      own += state.position[n].x() - model.start_position[n].x();
    sum += own / b.nodes;
  }
  return bodies.empty() ? 0 : sum / static_cast<double>(bodies.size());
}

double storey_drift(const Model<2>& model, const State<2>& state, const std::vector<Storey>& storeys,
                    const std::vector<int>& base, std::size_t index) {
  return mean_sway(model, state, storeys[index].top) -
         mean_sway(model, state, index == 0 ? base : storeys[index - 1].top);
}

double top_drift(const Model<2>& model, const State<2>& state, const std::vector<Storey>& storeys,
                 const std::vector<int>& base) {
  return storeys.empty() ? 0 : mean_sway(model, state, storeys.back().top) - mean_sway(model, state, base);
}

}  // namespace trilith
