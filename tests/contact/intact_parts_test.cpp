// A softening bond without damage takes a shorter way through its step, with the same bits.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "contact/face_lanes.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

using Softening = Cohesive::Kernel;

/// All numbers of a response, in one order.
std::vector<Lanes> lanes_of_response(FaceResponse<Lanes, Softening::Memory<Lanes>> r) {
  std::vector<Lanes> out{r.ax0, r.ay0, r.ax1,          r.ay1,           r.bx0,           r.by0,
                         r.bx1, r.by1, r.lost_damping, r.lost_friction, r.lost_fracture, r.memory.slip};
  for (const int h : {0, 1})
    for (const Lanes& v : {r.memory.shear_elastic[h], r.memory.shear_total[h], r.memory.damping_force[h],
                           r.memory.active[h], std::bit_cast<Lanes>(r.memory.bonds[h])})
      out.push_back(v);
  out.push_back(std::bit_cast<Lanes>(r.touching));
  r.own.fields([&](const Lanes& first, const Lanes& second) { out.push_back(first), out.push_back(second); });
  return out;
}

bool same_words(const std::vector<Lanes>& a, const std::vector<Lanes>& b) {
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i)
    for (int k = 0; k < lane_count; ++k) {
      const double one = a[i][k], other = b[i][k];
      same = same && std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
    }
  return same;
}

/// Mortar of random strengths, with or without dilation, crushing and its softening.
Cohesive random_mortar(std::mt19937_64& bits) {
  Cohesive law;
  law.kn = random_between(bits, 1e7, 1e8), law.ks = random_between(bits, 1e7, 1e8);
  law.mu = random_between(bits, 0.1, 1), law.beta = random_between(bits, 0, 1e-3);
  law.tension = random_between(bits, 1e4, 1e5), law.cohesion = random_between(bits, 1e4, 2e5);
  law.energy_tension = law.tension * law.tension / law.kn * random_between(bits, 0.6, 5);
  law.energy_shear = law.cohesion * law.cohesion / law.ks * random_between(bits, 0.6, 5);
  if (random_count(bits, 0, 2) == 0) law.dilation = 0.3, law.dilation_slip = 1e-3;
  if (random_count(bits, 0, 2) == 0) law.compression = random_between(bits, 1e4, 3e5), law.crushing_depth = 2e-3;
  return law;
}

struct FourContacts {
  std::array<Faces, lane_count> faces;
  std::array<FaceMemory<double>, lane_count> memory;
  std::array<LawMemory<Softening>, lane_count> own;

  /// Without damage; set with or without a gap, crushed or not.
  explicit FourContacts(std::mt19937_64& bits, double widest) {
    for (std::size_t i = 0; i < lane_count; ++i) {
      faces[i] = random_faces(bits, -3e-3, widest, 1e-3);
      memory[i] = random_memory(bits, 1e4);
      if (random_count(bits, 0, 1) == 0) own[i].set[0] = random_between(bits, 0, 1e-3);
      if (random_count(bits, 0, 1) == 0) own[i].crushed[1] = random_between(bits, 0, 1e-3);
      if (random_count(bits, 0, 1) == 0) own[i].worn = random_between(bits, -1e-4, 0);
    }
  }
  /// `known`: it is known that no part is damaged.
  [[nodiscard]] FaceResponse<Lanes, Softening::Memory<Lanes>> respond(const Softening& law, bool known) const {
    Softening::Memory<Lanes> memories = pack<Softening>(own);
    memories.set_damaged(!known);
    return respond_face_pair<Softening>(pack(faces, false), pack(faces, true), Lanes{} + 1.0, pack(memory), memories,
                                        law);
  }
};

}  // namespace

TEST_CASE("parts that are known to be intact give the bits of parts whose damage is read") {
  std::mt19937_64 bits(31);
  int kept = 0, softened = 0;
  for (int round = 0; round < 3000; ++round) {
    const FourContacts contacts(bits, round % 2 == 0 ? 0 : 4e-3);
    const Softening law(random_mortar(bits), 1, 1e-4);
    const auto read = contacts.respond(law, false), known = contacts.respond(law, true);
    CHECK(same_words(lanes_of_response(read), lanes_of_response(known)));
    const LaneMask changes =
                       Softening::changes(pack(contacts.memory), pack<Softening>(contacts.own), read.memory, read.own),
                   changes_known = Softening::changes(pack(contacts.memory), pack<Softening>(contacts.own),
                                                      known.memory, known.own);
    CHECK_FALSE(any(changes ^ changes_known));
    ++(known.own.may_be_damaged() ? softened : kept);
  }
  // Both ways were taken.
  CHECK(kept > 300);
  CHECK(softened > 300);
}

TEST_CASE("a bond that is not damaged in a step is known to be intact after it, and only then") {
  std::mt19937_64 bits(32);
  for (int round = 0; round < 1000; ++round) {
    const FourContacts contacts(bits, round % 2 == 0 ? 0 : 4e-3);
    const Softening law(random_mortar(bits), 1, 1e-4);
    auto after = contacts.respond(law, true).own;
    LaneMask damage{};
    for (const Lanes& part : after.damage) damage |= part > 0.0;
    if (any(damage)) CHECK(after.may_be_damaged());
  }
}
