#include "build/space/barrel_vault.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace trilith {
namespace {

/// Joints along y are whole numbers of half stones, so that joints of all courses have the same bits.
double joint_of_halves(const BarrelVault& vault, int halves) {
  return vault.from + 0.5 * vault.stone_length * halves;
}

/// Ends of the stones of a course, in half stones from the start.
std::vector<int> course_joints(const BarrelVault& vault, bool shifted) {
  std::vector<int> joints{0};
  for (int at = shifted ? 1 : 2; at < 2 * vault.stones; at += 2) joints.push_back(at);
  joints.push_back(2 * vault.stones);
  return joints;
}

}  // namespace

std::vector<SolidPart> build_barrel_vault(const BarrelVault& vault) {
  const std::string owner = builder_title("vault", vault.name);
  require_positive(vault.stone_length, owner + ": stone length", "m");
  require_count(vault.stones, 1, 10000, owner + ": number of stones in a course");
  require_finite(vault.from, owner + ": from");
  require_place(vault.at, owner);
  const UnitQuaternion rotation = checked_turn(vault.turn, owner);
  require_buildable(static_cast<double>(vault.arch.voussoirs) * vault.stones, owner);
  std::vector<SolidPart> parts;
  const auto add = [&](const std::string& piece, const Part& of, std::vector<std::string> groups, int from, int to) {
    for (const std::string& group : of.groups) groups.insert(groups.begin(), group);
    if (!vault.name.empty()) groups.push_back(vault.name);
    parts.push_back(
        {part_name(vault.name, piece),
         prisms_between(of.outline, OutlinePlane::upright, joint_of_halves(vault, from), joint_of_halves(vault, to)),
         std::move(groups)});
    place_part(parts.back(), rotation, vault.at);
  };
  int course = 0;
  for (const Part& part : build_profile(vault.arch, owner)) {
    if (std::count(part.groups.begin(), part.groups.end(), "voussoirs") == 0) {
      add(part.name, part, {}, 0, 2 * vault.stones);
      continue;
    }
    ++course;
    const std::vector<int> joints = course_joints(vault, vault.bond && (course % 2 == 0) != vault.half_first);
    for (std::size_t s = 1; s < joints.size(); ++s)
      add(fmt::format("c{}.s{}", course, s), part, {fmt::format("course {}", course)}, joints[s - 1], joints[s]);
  }
  return parts;
}

SolidParts BarrelVault::parts() const {
  check_keys(*this, builder_title(kind, name));
  BarrelVault vault = *this;
  vault.arch = with_span_and_rise(arch);
  return {build_barrel_vault(vault), {}};
}

}  // namespace trilith
