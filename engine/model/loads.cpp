#include "model/loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "model/builder/bearing_spec.hpp"
#include "model/contact/skin_places.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

std::string owner_of(const char* kind, const std::string& name, const Model<2>& model, int body) {
  return fmt::format("{} '{}' on '{}'", kind, name, model.bodies[body].name);
}

void check_finite(const Vec2& v, const std::string& what) {
  require_finite(v.x(), what + " along x");
  require_finite(v.y(), what + " along y");
}

/// On a deformable body by mass, like weight.
std::vector<PointLoad<2>> spread_load(const Model<2>& model, int body, const PointLoad<2>& whole) {
  const Body& b = model.bodies[body];
  const double mass = body_mass(model, body);
  std::vector<PointLoad<2>> loads;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n) {
    loads.push_back(whole);
    loads.back().at = Attachment<2>::to_node(n, Vec2::Zero());
    loads.back().force *= model.mass[n] / mass;
  }
  return loads;
}

}  // namespace

/// At a point: one load attached there. On a whole deformable body: shares at all its nodes.
std::vector<PointLoad<2>> make_point_load(const Model<2>& model, int body, const PointLoadSpec& spec) {
  const std::string owner = owner_of("load", spec.name, model, body);
  check_finite(spec.force, owner + ": force");
  require_finite(spec.moment, owner + ": moment");
  check_load_curve(spec.curve, owner);
  const Body& b = model.bodies[body];
  PointLoad<2> load;
  load.name = spec.name, load.body = body, load.curve = spec.curve;
  load.force = spec.force, load.moment = spec.moment, load.follows = spec.follows;
  if (spec.at) {
    check_finite(*spec.at, owner + ": place");
    if (b.is_rigid()) {
      const double size = 2 * model.body_radius[body];
      require_near<2>(*spec.at, (*spec.at - body_start(model, body)).norm() - 0.5 * size, size, b.name, owner);
    }
    load.at = tie_point(model, body, *spec.at, owner);
    return {load};
  }
  load.at = Attachment<2>::to_node(b.first_node, Vec2::Zero());
  if (b.is_rigid()) return {load};
  if (spec.moment != 0 || spec.follows)
    throw InputError(fmt::format("{}: the body deforms; give 'at', the point where the {} acts", owner,
                                 spec.moment != 0 ? "moment" : "force that follows"));
  return spread_load(model, body, load);
}

/// The depth of contacts, or of the elements of the body.
double depth_of(const Model<2>& model, int body) {
  for (const Element& e : model.elements)
    if (e.body == body) return e.thickness;
  return model.thickness;
}

std::vector<FaceLoad<2>> make_pressure(const Model<2>& model, int body, const std::vector<FacePart>& faces,
                                       const PressureSpec& spec) {
  const std::string owner = owner_of("pressure", spec.name, model, body);
  require_finite(spec.value, owner + ": value");
  check_load_curve(spec.curve, owner);
  if (spec.direction && (spec.follows || !(spec.direction->norm() > 0) || !spec.direction->allFinite()))
    throw InputError(fmt::format(
        "{}: a direction must be a nonzero vector, and is only for pressure that does not follow the face", owner));
  const double depth = depth_of(model, body);
  std::vector<FaceLoad<2>> loads;
  for (const FacePart& face : faces) {
    FaceLoad<2> load;
    load.name = spec.name, load.body = body, load.curve = spec.curve;
    load.skin_a = face.skin_a, load.skin_b = face.skin_b;
    // Over the part of a face from s = from to s = to, with shape functions 1 - s and s: the integral of s is (to^2 -
    // from^2)/2.
    load.share[1] = 0.5 * (face.to * face.to - face.from * face.from);
    load.share[0] = face.to - face.from - load.share[1];
    load.pressure = spec.value, load.depth = depth, load.follows = spec.follows;
    const Vec2 along = skin_start(model, face.skin_b) - skin_start(model, face.skin_a);
    const Vec2 way = spec.direction ? Vec2(along.norm() * spec.direction->normalized()) : left_of(along);
    // Pressure that does not follow keeps its initial force.
    if (!spec.follows) load.dead = spec.value * depth * way;
    loads.push_back(std::move(load));
  }
  return loads;
}

/// Loads without a name replace a released support.
template <int D>
void drop_faded(Model<D>& model, double now) {
  model.loads.erase_if([now](const auto& load) { return load.name.empty() && load.curve.spent(now); });
}

template <int D>
int drop_loads(Model<D>& model, const std::string& name) {
  return model.loads.erase_if([&](const auto& load) { return load.name == name; });
}

template <int D>
int change_loads(Model<D>& model, const std::string& name, double now, double share, double duration) {
  int count = 0;
  model.loads.for_each([&]<class L>(L& load) {
    if (has_level<L> || load.name != name) return;
    // Starts smoothly from the present share.
    load.curve = ramp_curve(now, load.curve.at(now), share, duration, true);
    ++count;
  });
  return count;
}

template <int D>
int scale_loads(Model<D>& model, const std::string& name, double factor) {
  int count = 0;
  model.loads.for_each([&](auto& load) {
    if (!name.empty() && load.name != name) return;
    load.scale(factor);
    ++count;
  });
  return count;
}

template <int D>
std::vector<std::string> load_names(const Model<D>& model) {
  std::vector<std::string> names;
  const auto add = [&](const auto& named) {
    if (!named.name.empty() && std::find(names.begin(), names.end(), named.name) == names.end())
      names.push_back(named.name);
  };
  model.loads.for_each(add);
  for (const Push<D>& push : model.pushes) add(push);
  return names;
}

template void drop_faded(Model<2>&, double);
template void drop_faded(Model<3>&, double);
template int drop_loads(Model<2>&, const std::string&);
template int drop_loads(Model<3>&, const std::string&);
template int scale_loads(Model<2>&, const std::string&, double);
template int scale_loads(Model<3>&, const std::string&, double);
template int change_loads(Model<2>&, const std::string&, double, double, double);
template int change_loads(Model<3>&, const std::string&, double, double, double);
template std::vector<std::string> load_names(const Model<2>&);
template std::vector<std::string> load_names(const Model<3>&);

}  // namespace trilith
