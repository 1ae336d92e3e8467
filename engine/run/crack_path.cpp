#include "run/crack_path.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "assembly/evaluate.hpp"
#include "assembly/implicit_turn.hpp"
#include "edit/crack_scratch.hpp"
#include "edit/deactivate.hpp"
#include "model/loads.hpp"

namespace trilith {
namespace {

/// A factor that has changed by less than this share at the start of a part of the path belongs to the same point.
constexpr double same_factor = 1e-6;
/// Sections that wait, see is_waiting_, are divided above this share of their strength. It is as far above 1 as
/// share_at_crack is below, so that the peak of the new joint does not reach it by rounding.
constexpr double share_of_waiting = 1 / share_at_crack;
/// They wait until they use less than this share.
constexpr double least_waiting = 0.99;

template <int D>
std::vector<FollowedFreedom> followed_of(const Model<D>& model, const std::string& loads) {
  std::vector<FollowedFreedom> followed;
  for (const PointLoad<D>& load : loads_of<PointLoad<D>>(model))
    for (int k = 0; k < D; ++k)
      if (load.name == loads && load.force[k] != 0) followed.push_back({{load.at.node[0], k}, load.force[k]});
  return followed;
}

/// The node of a whole body whose displacement a node of its parts continues: the only one, or the nearest at the
/// start.
template <int D>
int node_before(const Model<D>& model, int whole, int node) {
  const Body& body = model.bodies[static_cast<std::size_t>(whole)];
  int nearest = body.first_node;
  const auto distance = [&](int n) {
    return (model.start_position[static_cast<std::size_t>(n)] - model.start_position[static_cast<std::size_t>(node)])
        .squaredNorm();
  };
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
    if (distance(n) < distance(nearest)) nearest = n;
  return nearest;
}

/// A path through cracks: parts that statics/load_path.hpp follows, from one crack to the next.
template <int D>
class PathParts {
 public:
  PathParts(CrackPath<D>& path, LoadPathOptions<D> options)
      : path_(path), options_(std::move(options)), cracking_{path.bodies, {}} {}

  LoadPath follow() {
    for (bool cracks = true; cracks;) {
      LoadPathOptions<D> how = options_;
      how.followed = followed_of(path_.model, options_.loads);
      if (!cracking_.bodies.empty())
        how.strength_used = [this](const Model<D>& model, const State<D>& state, const Work<D>& work) {
          return compared(search_cracks(model, state, work, cracking_, scratch_, unbounded).share);
        };
      how.goes_on = [this](const PathPoint& point, const State<D>& state) { return add(point, state); };
      before_ = out_, begins_ = true;
      const LoadPath part = trilith::follow_loads(path_.model, path_.state, how);
      append(part);
      cracks = part.end == PathEnd::cracks;
      if (cracks) crack();
    }
    return std::move(out_);
  }

 private:
  bool add(const PathPoint& point, const State<D>& state) {
    PathPoint whole = point;
    if (!before_.points.empty()) {
      const PathPoint& last = before_.points.back();
      whole.length += last.length;
      const bool is_same = std::abs(point.factor - last.factor) <= same_factor * std::abs(last.factor);
      if (std::exchange(begins_, false) && is_same) return true;  // reported before the crack
    }
    whole.events += before_.events.size();
    previous_ = std::exchange(latest_, state);
    out_.points.push_back(whole);
    return !options_.goes_on || options_.goes_on(whole, state);
  }

  void append(const LoadPath& part) {
    out_.end = part.end, out_.left = part.left, out_.worst = part.worst;
    out_.iterations += part.iterations, out_.cuts += part.cuts, out_.jumps += part.jumps, out_.missed += part.missed;
    out_.searched += part.searched, out_.snaps += part.snaps;
    out_.events.insert(out_.events.end(), part.events.begin(), part.events.end());
    out_.limits.insert(out_.limits.end(), part.limits.begin(), part.limits.end());
  }

  /// The largest use of a strength as LoadPathOptions::strength_used compares it: of sections that wait a larger share
  /// counts as the one at which bodies are divided.
  double compared(double share) {
    is_waiting_ = is_waiting_ && share >= least_waiting;
    return is_waiting_ ? share * (share_at_crack / share_of_waiting) : share;
  }

  /// The crack that uses the largest share of its strength; of equal ones the first.
  std::vector<Crack<D>> next_crack(const Model<D>& loaded, const Work<D>& work) {
    const double least = is_waiting_ ? share_of_waiting : share_at_crack;
    const double limit = least * (1 - 1e-6);  // the state has been rounded at the end of its part
    CrackSearch<D> found = search_cracks(loaded, path_.state, work, cracking_, scratch_, limit);
    if (found.cracks.size() < 2) return found.cracks;
    const double largest = found.share * (1 - same_factor);
    for (Crack<D>& crack : search_cracks(loaded, path_.state, work, cracking_, scratch_, largest).cracks)
      return {std::move(crack)};
    return {std::move(found.cracks.front())};
  }

  /// Divides a body at the last point, and prepares the next part of the path.
  void crack() {
    const double factor = out_.points.back().factor;
    const double scale = factor != 0 ? factor : 1;  // at factor 0 the loads must not vanish from the parts
    Model<D> loaded = path_.model;
    scale_loads(loaded, options_.loads, scale);
    Work<D> work;
    evaluate(loaded, path_.state, work, path_.state.last_dt);
    const std::vector<Crack<D>> cracks = next_crack(loaded, work);
    Model<D> grown = with_cracks(path_.builder, loaded, cracking_.bodies, cracks);
    const std::vector<Event> events =
        split<D>(loaded, path_.state, work, StepOptions{}, std::move(grown), cracking_.bodies, cracks);
    hold_left(loaded, path_.state);
    for (const Event& e : events)
      if (e.type == EventType::unit_cracked) out_.events.push_back(e);
    cracking_ = {path_.builder.cracking(loaded), {}};
    scale_loads(loaded, options_.loads, 1 / scale);
    continue_last_step(loaded, cracks);
    path_.model = std::move(loaded), path_.bodies = cracking_.bodies;
    options_.begin = factor, options_.finds_again = true, is_waiting_ = true;
    options_.displacement = out_.points.back().displacement;
    if (path_.on_cracks) path_.on_cracks(cracks);
  }

  /// The displacement of a node in the step that led to the last point. `at`: a place that moves with it if it rotates.
  [[nodiscard]] Dofs<D> step_of(std::size_t n, const Vec<D>& at, bool turns) const {
    if (n >= previous_.position.size() || n >= latest_.position.size()) return {};
    const auto turn = turn_between(previous_.rotation[n], latest_.rotation[n]);
    Vec<D> moved = latest_.position[n] - previous_.position[n];
    if (turns) moved += cross(turn, Vec<D>(at - latest_.position[n]));
    return dofs_of(moved, turn);
  }

  /// The sense of the path: the displacement of the step that led to the last point, which the parts continue.
  void continue_last_step(const Model<D>& grown, const std::vector<Crack<D>>& cracks) {
    options_.last_step.clear();
    if (out_.points.size() < 2 || previous_.position.empty()) return;
    options_.rise = out_.points.back().factor - out_.points[out_.points.size() - 2].factor;
    options_.last_step.resize(grown.mass.size());
    for (std::size_t n = 0; n < grown.mass.size(); ++n) options_.last_step[n] = step_of(n, Vec<D>::Zero(), false);
    const std::size_t first_part = grown.bodies.size() - 2 * cracks.size();
    for (std::size_t part = first_part; part < grown.bodies.size(); ++part) {
      const int whole = cracks[(part - first_part) / 2].body;
      const Body& body = grown.bodies[part];
      for (int n = body.first_node; n < body.first_node + body.nodes; ++n)
        options_.last_step[static_cast<std::size_t>(n)] =
            step_of(static_cast<std::size_t>(node_before(grown, whole, n)),
                    path_.state.position[static_cast<std::size_t>(n)], body.nodes_turn());
    }
  }

  CrackPath<D>& path_;
  LoadPathOptions<D> options_;
  Cracking<D> cracking_;
  CrackScratch<D> scratch_;
  // After a crack, other sections that are as near to their strength wait until the new joint has passed its peak. Then
  // the load falls, and of equal planes one opens.
  bool is_waiting_ = false;
  bool begins_ = false;         // the next point is the first one of a part of the path
  LoadPath out_, before_;       // so far, and up to the last crack
  State<D> previous_, latest_;  // of the last two points
};

}  // namespace

template <int D>
LoadPath follow_loads(CrackPath<D>& path, LoadPathOptions<D> options) {
  return PathParts<D>(path, std::move(options)).follow();
}

template <int D>
std::vector<PushRow<D>> rows_of_loads(const Model<D>& model, const std::string& loads, const Vec<D>& direction) {
  std::vector<PushRow<D>> rows;
  for (const PointLoad<D>& load : loads_of<PointLoad<D>>(model))
    if (load.name == loads)
      rows.push_back({load.at.node[0], load.at.turn[0], load.at.arm[0], load.force.dot(direction)});
  return rows;
}

template LoadPath follow_loads(CrackPath<2>&, LoadPathOptions<2>);
template LoadPath follow_loads(CrackPath<3>&, LoadPathOptions<3>);
template std::vector<PushRow<2>> rows_of_loads(const Model<2>&, const std::string&, const Vec2&);
template std::vector<PushRow<3>> rows_of_loads(const Model<3>&, const std::string&, const Vec3&);

}  // namespace trilith
