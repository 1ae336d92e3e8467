#include "contact/joint/setting_shear.hpp"

#include <algorithm>
#include <variant>

#include "contact/joint/intact_joint.hpp"

namespace trilith {
namespace {

/// Largest share of the cohesion that shear beyond friction may use if the joint stays intact.
constexpr double most_cohesion = 0.1;
/// Pressed points within this share of the joint's radius of gyration carry no couple.
constexpr double least_radius = 1e-3;

/// Whether the shear of an intact joint exceeds friction by no more than this share at any corner.
bool is_light(const JointMemory& joint, double kn, double mu, double cohesion) {
  const JointPlan& plan = *joint.plan;
  const Vec2& middle = plan.whole.middle;
  return std::all_of(plan.outline.begin(), plan.outline.end(), [&](const Vec2& p) {
    const double limit = mu * kn * std::max(plan.standing(p), 0.0) + most_cohesion * cohesion;
    return std::max(intact_shear_at(plan, joint.elastic, p - middle).norm(),
                    intact_shear_at(plan, joint.total, p - middle).norm()) <= limit;
  });
}

/// The points of all patches, weighted by their pressure.
struct PressedPlaces {
  std::array<Lanes, most_patches> weight{};
  double sum = 0, polar = 0;  ///< [m3], [m5] about the centre
  Vec2 centre = Vec2::Zero();

  explicit PressedPlaces(const JointPlan& plan) {
    for (std::size_t k = 0; k < plan.patch.size(); ++k) {
      const JointPatch& p = plan.patch[k];
      weight[k] = 0.25 * p.area * larger(at_points(p, p.laid), Lanes{});
      sum += sum_of(weight[k]);
      centre += Vec2(sum_of(weight[k] * lanes_of(p.point_x)), sum_of(weight[k] * lanes_of(p.point_y)));
    }
    if (!(sum > 0)) return;
    centre /= sum;
    for (std::size_t k = 0; k < plan.patch.size(); ++k) {
      const Lanes x = lanes_of(plan.patch[k].point_x) - centre.x(), y = lanes_of(plan.patch[k].point_y) - centre.y();
      polar += sum_of(weight[k] * (x * x + y * y));
    }
  }
};

}  // namespace

void apply_setting_shear(JointMemory& joint, const ContactLaw& law) {
  const auto [kn, mu, cohesion] = std::visit(
      [](const auto& l) {
        if constexpr (requires { l.cohesion; })
          return std::array{l.kn, l.mu, l.cohesion};
        else
          return std::array{l.kn, l.mu, 0.0};
      },
      law);
  if (is_light(joint, kn, mu, cohesion)) return;
  const JointPlan& plan = *joint.plan;
  const PressedPlaces pressed(plan);
  if (!(pressed.polar > least_radius * least_radius * plan.radius * plan.radius * pressed.sum)) return;
  joint.sound = false;
  divide(joint);
  for (std::size_t k = 0; k < plan.patch.size(); ++k) {
    const JointPatch& p = plan.patch[k];
    PatchMemory& m = joint.patch[k];
    m = {};
    m.active = p.area;
    const Lanes x = lanes_of(p.point_x) - pressed.centre.x(), y = lanes_of(p.point_y) - pressed.centre.y();
    const auto lay = [&](const Vec3& shear, PatchNumbers& along_x, PatchNumbers& along_y) {
      const Vec2 force = shear.head<2>() / pressed.sum;
      const double couple = shear.z() - cross(Vec2(pressed.centre - plan.whole.middle), Vec2(shear.head<2>())),
                   twist = couple / pressed.polar;
      store_lanes(pressed.weight[k] * (force.x() - twist * y), along_x);
      store_lanes(pressed.weight[k] * (force.y() + twist * x), along_y);
    };
    lay(joint.elastic, m.elastic_x, m.elastic_y), lay(joint.total, m.total_x, m.total_y);
  }
}

}  // namespace trilith
