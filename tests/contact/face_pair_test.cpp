// Properties of the contact of two faces, for any pose and motion.
#include "contact/plane/face_pair.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>

#include "contact/face_lanes.hpp"
#include "contact/face_scene.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

const Coulomb frictional(Frictional{1e8, 6e7, 0.5, 1e-3}, 1, 1e-4);
const Coulomb elastic(Frictional{1e8, 0, 0, 0}, 1, 1e-4);
const Bonded::Kernel bonded(Bonded{1e8, 6e7, 0.5, 1e-3, 2e5, 1e5, 1}, 1, 1e-4);

template <class M>
double size_of(const FaceResponse<double, M>& r) {
  return std::max({on_a0(r).norm(), on_a1(r).norm(), on_b0(r).norm(), on_b1(r).norm()});
}

/// Calls f(faces, memory) for many random pairs that overlap at least in part.
template <class F>
void for_random(F&& f) {
  std::mt19937_64 bits(5);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Faces faces = random_faces(bits, -5e-3, 1e-3, 0.015);
    const FaceMemory<double> memory = random_memory(bits, 1e4);
    touching += respond_fresh(faces, memory, frictional).touching ? 1 : 0;
    f(faces, memory);
  }
  REQUIRE(touching > 1000);
}

}  // namespace

TEST_CASE("separated faces have no force and no memory") {
  std::mt19937_64 bits(3);
  for (int i = 0; i < 500; ++i) {
    const auto r = respond_fresh(random_faces(bits, 0.05, 0.2, 0.01), no_memory(), frictional);
    CHECK(size_of(r) == 0.0);
    CHECK_FALSE(r.touching);
    CHECK(r.memory.shear_elastic[0] == 0.0);
    CHECK(r.lost_damping == 0.0);
    CHECK(r.lost_friction == 0.0);
  }
}

TEST_CASE("bonded faces without displacement have no force") {
  const Faces f{rigid_face({1, 0}, {0, 0}, Vec2::Zero(), 0), rigid_face({0, 0}, {1, 0}, Vec2::Zero(), 0)};
  const auto r = respond_fresh(f, no_memory(true), bonded);
  CHECK(size_of(r) == 0.0);
  CHECK(r.memory.bonds[0]);
  CHECK(r.memory.bonds[1]);
}

TEST_CASE("the forces on two faces are equal and opposite, in sum and in moment") {
  const auto check = [](const auto& law) {
    for_random([&](const Faces& f, const FaceMemory<double>& memory) {
      const auto r = respond_fresh(f, memory, law);
      const Vec2 sum = on_a0(r) + on_a1(r) + on_b0(r) + on_b1(r);
      const double moment = cross(start_of(f.a), on_a0(r)) + cross(end_of(f.a), on_a1(r)) +
                            cross(start_of(f.b), on_b0(r)) + cross(end_of(f.b), on_b1(r));
      const double arm = start_of(f.a).norm() + end_of(f.a).norm() + start_of(f.b).norm() + end_of(f.b).norm();
      CHECK(sum.norm() <= 1e-12 * size_of(r));
      CHECK(std::abs(moment) <= 1e-12 * size_of(r) * arm);
    });
  };
  check(frictional), check(bonded);
}

TEST_CASE("the order of two faces makes no difference") {
  for_random([](const Faces& f, const FaceMemory<double>& memory) {
    FaceMemory<double> swapped = memory;  // halves are counted from the start of the first face
    for (const int h : {0, 1}) {
      swapped.shear_elastic[h] = memory.shear_elastic[1 - h];
      swapped.shear_total[h] = memory.shear_total[1 - h];
      swapped.active[h] = memory.active[1 - h];
      swapped.bonds[h] = memory.bonds[1 - h];
    }
    swapped.damping_force[1] = -memory.damping_force[1];
    const auto r = respond_fresh(f, memory, bonded), s = respond_fresh({f.b, f.a}, swapped, bonded);
    const double close = 1e-11 * (size_of(r) + 1);
    CHECK((on_a0(r) - on_b0(s)).norm() < close);
    CHECK((on_a1(r) - on_b1(s)).norm() < close);
    CHECK((on_b0(r) - on_a0(s)).norm() < close);
    CHECK((on_b1(r) - on_a1(s)).norm() < close);
    CHECK(std::abs(r.lost_friction - s.lost_friction) < 1e-11 * (1 + std::abs(r.lost_friction)));
    CHECK(std::abs(r.lost_damping - s.lost_damping) < 1e-11 * (1 + std::abs(r.lost_damping)));
    CHECK(r.is_face_pair == s.is_face_pair);
  });
}

TEST_CASE("contact does not depend on the axes: rotated faces have rotated forces") {
  std::mt19937_64 bits(8);
  for_random([&](const Faces& f, const FaceMemory<double>& memory) {
    const Turn turn(random_between(bits, -M_PI, M_PI));
    const auto r = respond_fresh(f, memory, frictional), s = respond_fresh(turned(f, turn), memory, frictional);
    const double close = 1e-10 * (size_of(r) + 1);
    CHECK((turn.apply(on_a0(r)) - on_a0(s)).norm() < close);
    CHECK((turn.apply(on_a1(r)) - on_a1(s)).norm() < close);
    CHECK((turn.apply(on_b0(r)) - on_b0(s)).norm() < close);
    CHECK((turn.apply(on_b1(r)) - on_b1(s)).norm() < close);
  });
}

TEST_CASE("a velocity and a spin that both faces share make no damping and no friction") {
  for_random([](const Faces& f, const FaceMemory<double>&) {
    const auto with = [](const Faces& g, const Vec2& velocity, double spin) {
      return Faces{rigid_face(start_of(g.a), end_of(g.a), velocity, spin),
                   rigid_face(start_of(g.b), end_of(g.b), velocity, spin)};
    };
    const auto still = respond_fresh(with(f, Vec2::Zero(), 0), no_memory(), frictional);
    const auto moving = respond_fresh(with(f, {3, -2}, 0.7), no_memory(), frictional);
    CHECK((on_b0(still) - on_b0(moving)).norm() <= 1e-9 * size_of(still));
    CHECK((on_b1(still) - on_b1(moving)).norm() <= 1e-9 * size_of(still));
    CHECK(std::abs(moving.lost_friction + moving.lost_damping) <= 1e-12 * size_of(still));
  });
}

namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Many, class One>
void check_lane(const FaceResponse<Lanes, Many>& many, const FaceResponse<double, One>& one, int i) {
  CHECK((many.is_face_pair[i] != 0) == one.is_face_pair);
  CHECK((many.touching[i] != 0) == one.touching);
  using R = FaceResponse<double, One>;
  using S = FaceResponse<Lanes, Many>;
  const std::pair<double R::*, Lanes S::*> numbers[] = {{&R::ax0, &S::ax0},
                                                        {&R::ay0, &S::ay0},
                                                        {&R::ax1, &S::ax1},
                                                        {&R::ay1, &S::ay1},
                                                        {&R::bx0, &S::bx0},
                                                        {&R::by0, &S::by0},
                                                        {&R::bx1, &S::bx1},
                                                        {&R::by1, &S::by1},
                                                        {&R::lost_damping, &S::lost_damping},
                                                        {&R::lost_friction, &S::lost_friction},
                                                        {&R::lost_fracture, &S::lost_fracture}};
  for (const auto& [single, lanes] : numbers) CHECK(same_bits(one.*single, (many.*lanes)[i]));
  for (const int h : {0, 1}) {
    CHECK(same_bits(one.memory.shear_elastic[h], many.memory.shear_elastic[h][i]));
    CHECK(same_bits(one.memory.shear_total[h], many.memory.shear_total[h][i]));
    CHECK(same_bits(one.memory.damping_force[h], many.memory.damping_force[h][i]));
    CHECK(same_bits(one.memory.active[h], many.memory.active[h][i]));
    CHECK(one.memory.bonds[h] == (many.memory.bonds[h][i] != 0));
  }
  CHECK(same_bits(one.memory.slip, many.memory.slip[i]));
  std::vector<double> kept;
  One own = one.own;
  own.fields([&](double first, double second) { kept.push_back(first), kept.push_back(second); });
  Many lanes = many.own;
  auto next = kept.begin();
  lanes.fields([&](const Lanes& first, const Lanes& second) {
    CHECK(same_bits(*next++, first[i]));
    CHECK(same_bits(*next++, second[i]));
  });
}

}  // namespace

namespace {

/// A law of kind L with random allowed numbers.
template <class L>
L random_law(std::mt19937_64& bits) {
  L law;
  for (const Parameter<L>& p : L::parameters()) law.*(p.member) = std::min(p.most, random_between(bits, 0.1, 1));
  for (double L::*stiffness : {&L::kn, &L::ks}) law.*stiffness *= 1e8;
  law.beta *= 1e-3;
  if constexpr (L::Kernel::bonds) law.cohesion *= 2e5, law.tension *= 1e5;
  return law;
}

}  // namespace

TEST_CASE("four faces at once give the bits of one at a time, whatever the law") {
  std::mt19937_64 bits(11);
  for (int round = 0; round < 500; ++round) {
    std::array<Faces, lane_count> faces;
    std::array<FaceMemory<double>, lane_count> memory;
    for (int i = 0; i < lane_count; ++i) {
      faces[i] = random_faces(bits, -5e-3, 1e-3, 0.03);
      memory[i] = random_memory(bits, 1e4);
    }
    const Lanes corner = Lanes{} + 1.0;
    const auto with = [&]<class K>(const K& law) {
      std::array<LawMemory<K>, lane_count> own;
      for (LawMemory<K>& m : own)
        m.fields([&](double& first, double& second) {
          first = random_between(bits, 0, 1e-3), second = random_between(bits, 0, 1e-3);
        });
      const auto many =
          respond_face_pair<K>(pack(faces, false), pack(faces, true), corner, pack(memory), pack<K>(own), law);
      for (int i = 0; i < lane_count; ++i)
        check_lane(many, respond_face_pair<K>(faces[i].a, faces[i].b, 1.0, memory[i], own[i], law), i);
    };
    ContactLaws::for_each([&]<class L>() { with(typename L::Kernel(random_law<L>(bits), 1, 1e-4)); });
  }
}

TEST_CASE("the power of the forces at the face ends is the power of the stresses") {
  for_random([](const Faces& f, const FaceMemory<double>&) {
    const auto r = respond_fresh(f, no_memory(), frictional);
    const double power = on_a0(r).dot(start_speed(f.a)) + on_a1(r).dot(end_speed(f.a)) +
                         on_b0(r).dot(start_speed(f.b)) + on_b1(r).dot(end_speed(f.b));
    // Stresses between the zeros of gap and stress, each segment by Simpson's rule, which is exact here.
    const FaceOverlap<double> o(f.a, f.b);
    const FaceRates<double> rates(o, f.a, f.b);
    const auto gap_at = [&](double x) { return o.gap_lo + x * (o.gap_hi - o.gap_lo); };
    const auto rate_at = [&](double x) { return rates.gap_lo + x * (rates.gap_hi - rates.gap_lo); };
    const auto stress_at = [&](double x) { return -gap_at(x) - frictional.beta * rate_at(x); };
    std::vector<double> cuts{0, 1};
    for (const double cut : {gap_at(0) / (gap_at(0) - gap_at(1)), stress_at(0) / (stress_at(0) - stress_at(1))})
      if (cut > 0 && cut < 1) cuts.push_back(cut);
    std::sort(cuts.begin(), cuts.end());
    double expected = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double x0 = cuts[i - 1], x1 = cuts[i], mid = 0.5 * (x0 + x1);
      if (!(gap_at(mid) < 0 && stress_at(mid) > 0)) continue;
      const auto power_at = [&](double x) { return stress_at(x) * rate_at(x) * frictional.kn * o.shared; };
      expected += (x1 - x0) / 6 * (power_at(x0) + 4 * power_at(mid) + power_at(x1));
    }
    for (const int h : {0, 1})
      expected -= r.memory.shear_total[h] * (rates.slip_lo + (h == 0 ? 0.25 : 0.75) * (rates.slip_hi - rates.slip_lo));
    if (r.touching) CHECK(std::abs(power - expected) <= 1e-10 * size_of(r));
  });
}

namespace {

/// Position of B on a closed path, and its velocity.
struct Path {
  double size[3][4], phase[3][4];
  explicit Path(std::mt19937_64& bits) {
    const double most[3] = {3e-3, 1e-3, 2e-3};  // along, across, rotation
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 4; ++j)
        size[k][j] = random_between(bits, 0, most[k] / (j + 1)), phase[k][j] = random_between(bits, 0, 2 * M_PI);
  }
  [[nodiscard]] std::array<double, 6> at(double t) const {
    std::array<double, 6> out{};
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 4; ++j) {
        const double w = 2 * M_PI * (j + 1);
        out[k] += size[k][j] * std::sin(w * t + phase[k][j]);
        out[k + 3] += size[k][j] * w * std::cos(w * t + phase[k][j]);
      }
    return out;
  }
};

struct Lap {
  double work, lost;     // work put in over the loop; dissipation by the law's own ledger [J]
  double pressed, path;  // largest normal force [N], and sliding distance [m]
};

/// Work put in by moving face B along a closed path over face A, in the second lap.
Lap lead_round(const Path& path, const Coulomb& law) {
  constexpr int steps = 20000;
  Coulomb stepped = law;
  stepped.dt = 1.0 / steps;
  FaceMemory<double> memory = no_memory();
  Lap lap{0, 0, 0, 0};
  for (int i = 0; i <= 2 * steps; ++i) {
    const std::array<double, 6> now = path.at(i * stepped.dt);
    const Turn turn(now[2]);
    const Vec2 place(now[0], now[1] - 5e-4), speed(now[3], now[4]);
    const auto point = [&](double x) { return turn.apply(Vec2(x, 0)); };
    const auto corner_speed = [&](double x) { return Vec2(speed + cross(now[5], point(x))); };
    const Faces f{rigid_face({0.6, 0}, {-0.6, 0}, Vec2::Zero(), 0),
                  face(place + point(-0.5), place + point(0.5), corner_speed(-0.5), corner_speed(0.5))};
    const auto r = respond_fresh(f, memory, stepped);
    memory = r.memory;
    const Vec2 force = on_b0(r) + on_b1(r);
    const double power = force.dot(speed) + (cross(point(-0.5), on_b0(r)) + cross(point(0.5), on_b1(r))) * now[5];
    if (i > steps) {
      lap.work -= power * stepped.dt;
      lap.lost += r.lost_damping + r.lost_friction;
      lap.pressed = std::max(lap.pressed, force.y());
      lap.path += std::abs(speed.x()) * stepped.dt;
    }
  }
  return lap;
}

}  // namespace

TEST_CASE("a closed path of two faces dissipates the damping and friction of the law, never a negative energy") {
  std::mt19937_64 bits(17);
  for (int i = 0; i < 20; ++i) {
    const Path path(bits);
    const Lap kept = lead_round(path, elastic), lost = lead_round(path, frictional);
    Coulomb only_damping = frictional;
    only_damping.ks = only_damping.mu = 0;
    const Lap damped = lead_round(path, only_damping);
    // The pressure acts normal to the mean of both faces, not to the face that ends: correct except for their tilt.
    CHECK(std::abs(kept.work) < 0.5 * face_pair_max_tilt * kept.pressed * kept.path);
    CHECK(kept.lost == 0.0);
    CHECK(damped.work > 0);
    CHECK(lost.work > 0);
    CHECK(near(damped.lost, damped.work - kept.work, 0.001));
    CHECK(near(lost.lost, lost.work, 0.02));
  }
}

TEST_CASE("faces that reach their limits of tilt or depth are left to the general contact") {
  const auto faces = [](double tilt, double depth) {
    return Faces{rigid_face({1, 0}, {0, 0}, Vec2::Zero(), 0),
                 rigid_face({0, -depth}, {1, -depth + tilt}, Vec2::Zero(), 0)};
  };
  const auto is_pair = [&](double tilt, double depth) {
    return respond_fresh(faces(tilt, depth), no_memory(), frictional).is_face_pair;
  };
  CHECK(is_pair(0.98 * face_pair_max_tilt, 1e-6));
  CHECK_FALSE(is_pair(1.02 * face_pair_max_tilt, 1e-6));
  CHECK(is_pair(0, 0.98 * face_pair_max_depth));
  CHECK_FALSE(is_pair(0, 1.02 * face_pair_max_depth));
  CHECK(respond_fresh(faces(2 * face_pair_max_tilt, 1e-6), no_memory(true), bonded)
            .is_face_pair);  // bonds exist between faces only
}
