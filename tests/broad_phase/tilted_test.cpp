// Pairs cached as too tilted for face contact: correct for as long as they are cached, and cached long enough.
#include "broad_phase/face_tilt_cache.hpp"

#include <random>

#include "assembly/evaluate.hpp"
#include "broad_phase/pairs.hpp"
#include "geometry/plane/random_convex.hpp"
#include "law/contact/face_overlap.hpp"
#include "physics/scene.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Two polygons of any shape and rotation, and their pair.
struct TwoStones {
  Model<2> model;
  State<2> state;
  Work<2> work;
  NearPair pair{0, 1, 0, 0, 0, 0, 0, 0, 1.0, false};

  explicit TwoStones(std::mt19937_64& bits) : model(build(bits)), state(initial_state(model)) {
    // Overlapping, which a model would reject at its start.
    state.position[1] = state.position[0] + random_between(bits, 0, 1.5) * random_direction(bits);
    evaluate(model, state, work, 1e-3);
  }

 private:
  static Model<2> build(std::mt19937_64& bits) {
    Scene scene(Frictional{1e8, 5e7, 0.6, 0});
    for (const double x : {0.0, 10.0}) {
      RandomConvex wanted;
      wanted.slenderest = 3;
      BodySpec spec;
      spec.name = "stone" + std::to_string(static_cast<int>(x)), spec.floating = true;
      spec.outline = placed(random_convex(bits, wanted), random_direction(bits), {x, 0});
      scene.add(spec);
    }
    return scene.builder.build();
  }
};

/// Smallest angle by which two faces of the pair miss being opposed [rad], from their directions.
double least_angle(const Work<2>& work, const Model<2>& model) {
  double least = M_PI;
  const auto way = [&](int piece, int e) {
    const int first = model.piece_first[piece], count = model.corners_of(piece);
    const SkinMotion<2>&p = work.skin[model.corner_skin[first + e]],
          &q = work.skin[model.corner_skin[first + (e + 1) % count]];
    return std::atan2(q.y - p.y, q.x - p.x);
  };
  for (int i = 0; i < model.corners_of(0); ++i)
    for (int j = 0; j < model.corners_of(1); ++j)
      least = std::min(least, std::abs(std::remainder(way(0, i) - way(1, j) - M_PI, 2 * M_PI)));
  return least;
}

}  // namespace

TEST_CASE("a pair stays in the cache of tilted pairs only while none of its faces can oppose each other") {
  std::mt19937_64 bits(11);
  int remembered = 0, asked = 0, wrong = 0, chosen = 0, faces = 0, found = 0;
  for (int k = 0; k < 60; ++k) {
    TwoStones stones(bits);
    auto& [model, state, work, pair] = stones;
    // Many full turns away from the start, where floats are coarse.
    if (k % 3 == 0) state.rotation[1] = random_between(bits, -3000, 3000);
    for (int turn = 0; turn < 400; ++turn) {
      const double most = std::pow(10.0, random_between(bits, -4, 0));
      for (int n = 0; n < 2; ++n) state.rotation[n] += random_between(bits, -most, most);
      update_kinematics(model, state, work);
      ++asked;
      const bool opposed = least_angle(work, model) <= face_pair_max_tilt;
      faces += opposed ? 1 : 0;
      if (is_tilted(model, state, work, pair)) {
        ++remembered;
        NearPair free = pair, bonded = pair;
        wrong += opposed ? 1 : 0;
        chosen += choose_face_pair(model, work, false, free) || choose_face_pair(model, work, true, bonded) ? 1 : 0;
      } else {
        NearPair bonded = pair;
        found += choose_face_pair(model, work, true, bonded) ? 1 : 0;
        remember_tilt(model, state, work, pair);
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(chosen == 0);
  CHECK(faces > 300);             // some faces become opposed ...
  CHECK(found > 100);             // ... and are chosen
  CHECK(remembered > asked / 4);  // the cache is effective
}

TEST_CASE("a tilted pair is cached up to the angle at which its next faces oppose each other, and not beyond") {
  std::mt19937_64 bits(12);
  int ends = 0;
  for (int k = 0; k < 200; ++k) {
    TwoStones stones(bits);
    auto& [model, state, work, pair] = stones;
    remember_tilt(model, state, work, pair);
    if (!(pair.tilted_from < pair.tilted_to)) continue;
    const double start = state.rotation[1];
    const double left = least_angle(work, model) - face_pair_max_tilt;
    double nearest = M_PI;
    for (const double way : {-1.0, 1.0}) {
      state.rotation[1] = start + way * (left - 1e-5);
      update_kinematics(model, state, work);
      CHECK(is_tilted(model, state, work, pair));
      state.rotation[1] = start + way * (left + 1e-5);
      update_kinematics(model, state, work);
      CHECK(!is_tilted(model, state, work, pair));
      nearest = std::min(nearest, least_angle(work, model));
    }
    CHECK(nearest <= face_pair_max_tilt);  // in one of the two directions of rotation they become opposed at this angle
    ++ends;
  }
  CHECK(ends > 50);
}
