#include "run/record/recorded_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <type_traits>
#include <variant>

#include "model/pose.hpp"

namespace trilith {
namespace {

/// The axes of the degrees of freedom of a node, translations first.
template <int D>
constexpr auto dof_names = [] {
  if constexpr (D == 2)
    return std::array{"x", "y", "rotation"};
  else
    return std::array{"x", "y", "z", "turn about x", "turn about y", "turn about z"};
}();

template <int D, std::size_t count>
std::string held_text(const std::array<Support, count>& support) {
  const auto word = [](Support s) { return s == Support::free ? "free" : s == Support::fixed ? "fixed" : "moved"; };
  const auto all = [&](Support s) { return std::count(support.begin(), support.end(), s) == count; };
  for (const Support s : {Support::free, Support::fixed})
    if (all(s)) return word(s);
  if (std::count(support.begin(), support.end(), Support::free) == 0) return "moved";
  std::string text;
  for (std::size_t k = 0; k < count; ++k)
    text += fmt::format("{}{} {}", k == 0 ? "" : ", ", dof_names<D>[k], word(support[k]));
  return text;
}

}  // namespace

std::string support_text(const std::array<Support, 3>& support) {
  return held_text<2>(support);
}
std::string support_text(const std::array<Support, 6>& support) {
  return held_text<3>(support);
}

/// True for the first node of a body among the nodes that follow a motion along one degree of freedom.
template <int D>
bool leads(const Model<D>& model, const Drive& drive) {
  const auto body_of = [&](const Drive& d) { return body_of_node(model, d.node); };
  return std::none_of(model.drives.data(), &drive, [&](const Drive& earlier) {
    return earlier.dof == drive.dof && earlier.start == drive.start && body_of(earlier) == body_of(drive);
  });
}

template <int D>
std::string drive_text(const Model<D>& model, const Drive& drive) {
  const auto body = std::find_if(model.bodies.begin(), model.bodies.end(), [&](const Body& b) {
    return b.first_node <= drive.node && drive.node < b.first_node + b.nodes;
  });
  return fmt::format("{} on '{}' ({}), from t = {:g} s", drive.motion->description(),
                     body == model.bodies.end() ? "?" : body->name, dof_names<D>[static_cast<std::size_t>(drive.dof)],
                     drive.start);
}

template <int D>
results::MotionRow motion_row(const Model<D>& model, const Drive& drive) {
  const GroundMotion& motion = *drive.motion;
  results::MotionRow row;
  row.body = body_of_node(model, drive.node), row.node = drive.node;
  row.direction = dof_names<D>[static_cast<std::size_t>(drive.dof)];
  row.begin = drive.start, row.origin = drive.origin;
  row.step = motion.step(), row.start_time = motion.start_time();
  row.start_velocity = motion.start().velocity, row.start_displacement = motion.start().displacement;
  row.record = std::filesystem::path(motion.source().file).filename().string();
  row.title = motion.source().title, row.text = motion.description();
  row.acceleration.reserve(motion.samples().size());
  for (const MotionAt& sample : motion.samples()) row.acceleration.push_back(sample.acceleration);
  return row;
}

namespace {

std::string direction_text(const DirectionLaw& law) {
  return std::visit(
      [](const auto& l) -> std::string {
        using Law = std::decay_t<decltype(l)>;
        if constexpr (std::is_same_v<Law, std::monostate>) {
          return "free";
        } else {
          std::string out = describe(l);
          if constexpr (TabulatedLaw<Law>)
            for (std::size_t i = 0; i < l.displacement.size(); ++i)
              out += fmt::format(" ({:g}, {:g})", l.displacement[i], l.force[i]);
          return out;
        }
      },
      law);
}

/// Adds the law and the limit of one direction, or of both horizontal directions.
void add_direction(std::string& out, const char* name, const DirectionLaw& law, double limit, const char* unit) {
  out += fmt::format("{}{}: {}", out.empty() ? "" : "; ", name, direction_text(law));
  if (limit < unbounded) out += fmt::format(", limit {:g} {}", limit, unit);
}

bool is_free(const DirectionLaw& law) {
  return std::holds_alternative<std::monostate>(law);
}

std::string directions_text(const Bearing<2>& b) {
  std::string out;
  for (std::size_t k = 0; k < 3; ++k)
    add_direction(out, Directions<2>::names[k], b.law[k], b.limit[k], unit_of_direction<2>(static_cast<int>(k)));
  if (b.angle != 0) out += fmt::format("; axes rotated by {:g} rad", b.angle);
  return out;
}
/// Directions without law and limit are omitted.
std::string directions_text(const Bearing<3>& b) {
  std::string out;
  if (b.has_horizontal() || b.horizontal_limit < unbounded)
    add_direction(out, "horizontal", b.horizontal, b.horizontal_limit, "m");
  for (std::size_t k = 0; k < 6; ++k)
    if (!is_free(b.law[k]) || b.limit[k] < unbounded)
      add_direction(out, Directions<3>::names[k], b.law[k], b.limit[k], unit_of_direction<3>(static_cast<int>(k)));
  return out;
}

/// Lists the directions in which the displacement of the successor counts from the point of the change.
template <int D>
std::string from_here_text(const Bearing<D>& b) {
  std::string out;
  for (std::size_t k = 0; k < b.next_from_here.size(); ++k)
    if (b.next_from_here[k]) out += fmt::format("{}{}", out.empty() ? " from here " : ", ", Directions<D>::names[k]);
  return std::count(b.next_from_here.begin(), b.next_from_here.end(), false) == 0 ? " from here" : out;
}

}  // namespace

template <int D>
std::string bearing_text(const Model<D>& model, const Bearing<D>& bearing) {
  std::string out = directions_text(bearing);
  if (bearing.starts_waiting) out += "; waits for the failure of another bearing";
  if (bearing.replaces_contact) out += "; no contact of its bodies while it acts";
  if (bearing.contact_after >= 0) out += fmt::format("; becomes contact {}", model.law_names[bearing.contact_after]);
  if (bearing.becomes_bearing >= 0)
    out += fmt::format("; becomes bearing {}{}", model.bearings[bearing.becomes_bearing].name, from_here_text(bearing));
  return out;
}

template std::string bearing_text(const Model<2>&, const Bearing<2>&);
template std::string bearing_text(const Model<3>&, const Bearing<3>&);
template bool leads(const Model<2>&, const Drive&);
template bool leads(const Model<3>&, const Drive&);
template std::string drive_text(const Model<2>&, const Drive&);
template std::string drive_text(const Model<3>&, const Drive&);
template results::MotionRow motion_row(const Model<2>&, const Drive&);
template results::MotionRow motion_row(const Model<3>&, const Drive&);

}  // namespace trilith
