// Bounds of intact bonds in the plane, against each point of these bonds.
#include "integrate/explicit/intact_bonds.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "integrate/explicit/bond_places.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

Cohesive softening_mortar() {
  Cohesive law;
  law.kn = 1e10, law.ks = 4e9, law.mu = 0.6, law.cohesion = 3e5, law.tension = 2e5;
  law.energy_tension = 20, law.energy_shear = 50;
  return law;
}
Bonded brittle_mortar() {
  Bonded law;
  law.kn = 1e10, law.ks = 4e9, law.mu = 0.6, law.cohesion = 3e5, law.tension = 2e5;
  return law;
}

/// One contact with both halves bonded and a memory of zeros.
template <class K>
ContactHistory one_intact_contact() {
  ContactHistory history;
  history.memory.resize(1), history.law_row.resize(1);
  history.law_memory.assign(law_numbers<K>, 0.0);
  history.memory[0].bonds = 3;
  return history;
}

/// The upper face of a block and the lower face of the one above, with random gaps and velocities.
struct TwoFaces {
  FaceEnds<double> a, b;

  explicit TwoFaces(std::mt19937_64& bits) {
    std::uniform_real_distribution<double> part(-1, 1);
    const double low = 2e-5 * part(bits), high = 2e-5 * part(bits), aside = 0.3 * part(bits);
    a = {0.4, 0, 0, 0, part(bits), part(bits), part(bits), part(bits)};
    b = {aside, low, aside + 0.4, high, part(bits), part(bits), part(bits), part(bits)};
  }
};

template <class L>
void check_bounds(const L& law) {
  using K = typename L::Kernel;
  const K kernel(law, 0.3, 1e-5);
  const ContactLaw any(law);
  const IntactBonds bonds = intact_bonds({any, 0.3});
  ContactHistory history = one_intact_contact<K>();
  REQUIRE(is_intact(bonds, history, 0));
  std::mt19937_64 bits(7);
  std::uniform_real_distribution<double> force(-2e4, 2e4);
  int met = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const TwoFaces faces(bits);
    const FaceOverlap<double> overlap(faces.a, faces.b);
    if (!(overlap.shared > 0)) continue;
    const FaceRates<double> rates(overlap, faces.a, faces.b);
    history.memory[0].shear_elastic[0] = force(bits), history.memory[0].shear_elastic[1] = force(bits);
    const IntactPlace place = intact_place(bonds, overlap, rates, history.memory[0]);
    int points = 0;
    bonds_of_row(kernel, history, 0, overlap, rates, 0, {}, [&](const PlacedBond& bond) {
      ++points;
      CHECK(place.room <= bond.curve.peak - bond.at + 1e-12);
      CHECK(place.speed >= std::abs(bond.rate) * (1 - 1e-12));
      CHECK(bonds.whole <= bond.curve.whole * (1 + 1e-12));
    });
    met += points > 0 ? 1 : 0;
  }
  CHECK(met > 1000);
}

}  // namespace

TEST_CASE("bounds of intact bonds are met at each point of their bonds") {
  check_bounds(softening_mortar());
  check_bounds(brittle_mortar());
}

TEST_CASE("an unloaded intact bond is as far from its peak as the opening at the peak less its gap") {
  const Cohesive law = softening_mortar();
  const ContactLaw any(law);
  const IntactBonds bonds = intact_bonds({any, 1});
  const ContactMemory unloaded;
  for (const double gap : {0.0, 5e-6, -5e-6}) {
    const FaceEnds<double> a{0.4, 0, 0, 0, 0, 0, 0, 0}, b{0, gap, 0.4, gap, 0, 0.01, 0, 0.03};
    const FaceOverlap<double> overlap(a, b);
    const IntactPlace place = intact_place(bonds, overlap, FaceRates<double>(overlap, a, b), unloaded);
    CHECK(near(place.room, law.tension / law.kn - gap, 1e-12));
    CHECK(near(place.speed, 0.03, 1e-12));
  }
}

TEST_CASE("contacts whose law remembers something, or whose joints open as they slide, are not examined by bounds") {
  using K = Cohesive::Kernel;
  const Cohesive law = softening_mortar();
  const ContactLaw any(law);
  const IntactBonds bonds = intact_bonds({any, 1});
  for (std::size_t i = 0; i < law_numbers<K>; ++i) {
    ContactHistory history = one_intact_contact<K>();
    history.law_memory[i] = 1e-300;
    CHECK(!is_intact(bonds, history, 0));
  }
  ContactHistory half = one_intact_contact<K>();
  half.memory[0].bonds = 1;
  CHECK(!is_intact(bonds, half, 0));
  Cohesive opens = law;
  opens.dilation = 0.1, opens.dilation_slip = 1e-3;
  const ContactLaw dilating(opens), dry{Frictional{}};
  CHECK(!intact_bonds({dilating, 1}).are_plain);
  CHECK(!intact_bonds({dry, 1}).are_plain);
}
