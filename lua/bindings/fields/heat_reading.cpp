#include "bindings/fields/heat_reading.hpp"

#include <algorithm>

#include "bindings/core/lua_api.hpp"
#include "model/contact/contact_frame.hpp"
#include "model/pose.hpp"

namespace trilith::script {
namespace {

constexpr const char* course_form = "a number, or { {time, value}, ..., period = seconds }";

/// Points of the list on top of the stack.
void read_course_points(Keys& keys, const char* key, FieldCourse& course) {
  lua_State* L = keys.lua();
  for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(L, -1)); ++i) {
    lua_rawgeti(L, -1, i);
    const auto point = point_at(L, -1);
    if (!point)
      keys.problem(fmt::format("point {} of '{}' is {}, must be {{time, value}}", i, key, what_is(L, -1)));
    else
      course.time.push_back(point->x()), course.value.push_back(point->y());
    lua_pop(L, 1);
  }
  if (course.time.empty()) keys.problem(fmt::format("'{}' has no point, must be {}", key, course_form));
}

/// Adds a cell with a weight to the mean of a body.
struct TemperatureSum {
  const FieldValues& heat;
  double weight = 0;
  BodyTemperature out = {};

  void add(int cell, double share) {
    const double t = heat.at(cell);
    out.lowest = weight == 0 ? t : std::min(out.lowest, t), out.highest = weight == 0 ? t : std::max(out.highest, t);
    out.value += share * t, weight += share;
  }
  void add_node(const FieldBody& row, int node, double share) {
    if (row.layout != CellLayout::sections) return add(row.cell_of(node), share);
    const int low = row.cell_of(node, 0), high = row.cell_of(node, 1);
    add(low, 0.5 * share), add(high, 0.5 * share);
    out.difference += share * (heat.at(high) - heat.at(low));
  }
  [[nodiscard]] BodyTemperature mean() const {
    BodyTemperature mean = out;
    mean.value /= weight, mean.difference /= weight;
    return mean;
  }
};

const FieldBody& require_row(const FieldValues& heat, int body, const std::string& owner) {
  const FieldBody* row = heat ? heat.field().find(body) : nullptr;
  if (row == nullptr)
    throw InputError(owner +
                     ": it has no thermal properties; give them by m:heat { body =, conductivity =, "
                     "heat_capacity = }");
  return *row;
}

void add_body(const FieldBody& row, TemperatureSum& sum) {
  const auto capacity = [&](int cell) { return sum.heat.field().capacity[static_cast<std::size_t>(cell)]; };
  if (row.layout != CellLayout::sections)
    for (int cell = row.first_cell; cell < row.first_cell + row.cells; ++cell) sum.add(cell, capacity(cell));
  else
    for (int n = 0; 2 * n < row.cells; ++n) sum.add_node(row, row.first_node + n, 2 * capacity(row.first_cell + 2 * n));
}

/// The node of a body nearest to a point at the start.
template <int D>
int node_near(const Model<D>& model, int body, const Vec<D>& at) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  int nearest = b.first_node;
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    if ((model.start_position[static_cast<std::size_t>(n)] - at).norm() <
        (model.start_position[static_cast<std::size_t>(nearest)] - at).norm())
      nearest = n;
  return nearest;
}

}  // namespace

void finish_between_stages(Keys& keys, ScriptModel& m, const char* what) {
  if (m.running()) keys.problem(fmt::format("a stage runs; declare {} before it, or between stages", what));
  keys.finish();
  m.build();
  m.catch_up();
}

FieldCourse read_course(Keys& keys, const char* key, double clock) {
  lua_State* L = keys.lua();
  FieldCourse course;
  course.start = clock;
  const int type = keys.push(key);
  if (type == LUA_TNUMBER) {
    course.value = {lua_tonumber(L, -1)};
  } else if (type == LUA_TTABLE) {
    try {
      Keys own(L, -1, key);
      own.allow_list();
      course.period = own.number("period", "s", 0);
      if (course.period < 0) own.problem(fmt::format("'period' is {:g} s, must be above 0", course.period));
      own.finish();
    } catch (const InputError& e) {
      keys.problem(e.what());
    }
    read_course_points(keys, key, course);
  } else if (type == LUA_TNIL) {
    keys.missing(key, course_form);
  } else {
    keys.wrong(key, course_form);
  }
  lua_pop(L, 1);
  return course;
}

std::vector<int> parts_of(const ScriptModel& m, int body) {
  const int first = m.first_part(body);
  if (first < 0) return {body};
  std::vector<int> out = parts_of(m, first);
  for (const int part : parts_of(m, first + 1)) out.push_back(part);
  return out;
}

BodyTemperature temperature_of(const FieldValues& heat, const std::vector<int>& bodies, const std::string& owner) {
  TemperatureSum sum{heat};
  for (const int body : bodies) add_body(require_row(heat, body, owner), sum);
  return sum.mean();
}

BodyTemperature temperature_of(const Model<2>& model, const FieldValues& heat, int body, const Vec2& at,
                               const std::string& owner) {
  const FieldBody& row = require_row(heat, body, owner);
  if (row.layout == CellLayout::one) return temperature_of(heat, {body}, owner);
  TemperatureSum sum{heat};
  if (row.layout == CellLayout::sections) {
    sum.add_node(row, node_near(model, body, at), 1);
    return sum.mean();
  }
  const Attachment<2> point = tie_point(model, body, at, owner);
  for (int i = 0; i < point.nodes; ++i)
    sum.add_node(row, point.node[static_cast<std::size_t>(i)], point.weight[static_cast<std::size_t>(i)]);
  return sum.mean();
}

BodyTemperature temperature_of(const Model<3>& model, const FieldValues& heat, int body, const Vec3& at,
                               const std::string& owner) {
  const FieldBody& row = require_row(heat, body, owner);
  if (row.layout == CellLayout::one) return temperature_of(heat, {body}, owner);
  TemperatureSum sum{heat};
  sum.add_node(row, node_near(model, body, at), 1);
  return sum.mean();
}

}  // namespace trilith::script
