// Sections of concrete fibres, computed four at a time, against a loop over their fibres, bit by bit.
#include <doctest/doctest.h>

#include <bit>
#include <random>

#include "element/section/fibre_section_3d.hpp"
#include "geometry/plane/random_convex.hpp"

namespace trilith {
namespace {

constexpr KentPark cracked_concrete{30e6, 0.002, 0.006, 0.2, 1.1, 2e6, 4e-4};

/// `count` fibres of concrete at random places.
template <class Section, class MakeFibre>
Section concrete_section(int count, const MakeFibre& fibre) {
  Section out;
  for (int i = 0; i < count; ++i) out.fibres.push_back(fibre());
  out.parts.push_back({cracked_concrete, 0, count});
  return out;
}

/// The response of each fibre, with the memory written to `after`.
UniaxialResponse<concrete_memory> fibre_alone(double strain, std::size_t i, const std::vector<double>& before,
                                              std::vector<double>& after) {
  KentPark::Memory memory;
  std::copy_n(before.begin() + static_cast<std::ptrdiff_t>(i * concrete_memory), concrete_memory, memory.begin());
  const auto r = cracked_concrete.respond(strain, memory);
  std::copy(r.memory.begin(), r.memory.end(), after.begin() + static_cast<std::ptrdiff_t>(i * concrete_memory));
  return r;
}

bool all_bits_equal(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

}  // namespace

TEST_CASE("a plane section of any number of concrete fibres has the bits of a loop over them") {
  std::mt19937_64 bits(5);
  for (int count = 1; count < 14; ++count) {
    const auto section = concrete_section<FibreSection>(count, [&] {
      return Fibre{random_between(bits, 1e-4, 1e-2), random_between(bits, -0.3, 0.3)};
    });
    std::vector<double> memory(static_cast<std::size_t>(section.memory_size())), next = memory, expected = memory;
    for (int i = 0; i < 200; ++i) {
      const SectionStrain strain{random_between(bits, -3e-3, 1e-3), random_between(bits, -1e-2, 1e-2)};
      const SectionResponse r = respond(section, strain, memory, next);
      SectionResponse sum;
      for (std::size_t k = 0; k < section.fibres.size(); ++k) {
        const Fibre& f = section.fibres[k];
        const auto one = fibre_alone(strain.axial - f.height * strain.curvature, k, memory, expected);
        const double force = one.stress() * f.area, stiffness = one.tangent * f.area, arm = -f.height;
        sum.normal += force, sum.moment += arm * force;
        sum.tangent(0, 0) += stiffness, sum.tangent(0, 1) += arm * stiffness;
        sum.tangent(1, 1) += arm * arm * stiffness;
        sum.stored += one.stored * f.area, sum.dissipated += one.dissipated * f.area;
        sum.yielding = sum.yielding || one.yielding;
      }
      REQUIRE(all_bits_equal({r.normal, r.moment, r.tangent(0, 0), r.tangent(0, 1), r.tangent(1, 0), r.tangent(1, 1),
                              r.stored, r.dissipated},
                             {sum.normal, sum.moment, sum.tangent(0, 0), sum.tangent(0, 1), sum.tangent(0, 1),
                              sum.tangent(1, 1), sum.stored, sum.dissipated}));
      REQUIRE(r.yielding == sum.yielding);
      REQUIRE(all_bits_equal(next, expected));
      if (i % 3 == 0) memory = next;
    }
  }
}

TEST_CASE("a section in space of any number of concrete fibres has the bits of a loop over them") {
  std::mt19937_64 bits(6);
  for (int count = 1; count < 14; ++count) {
    const auto section = concrete_section<FibreSection3>(count, [&] {
      return Fibre3{random_between(bits, 1e-4, 1e-2), random_between(bits, -0.3, 0.3), random_between(bits, -0.2, 0.2)};
    });
    std::vector<double> memory(static_cast<std::size_t>(section.memory_size())), next = memory, expected = memory;
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d strain(random_between(bits, -3e-3, 1e-3), random_between(bits, -1e-2, 1e-2),
                                   random_between(bits, -1e-2, 1e-2));
      const SectionResponse3 r = respond(section, strain, memory, next);
      SectionResponse3 sum;
      for (std::size_t k = 0; k < section.fibres.size(); ++k) {
        const Fibre3& f = section.fibres[k];
        const Eigen::Vector3d arm(1, f.across, -f.up);
        const auto one = fibre_alone(arm.dot(strain), k, memory, expected);
        sum.stress += one.stress() * f.area * arm;
        sum.tangent += one.tangent * f.area * (arm * arm.transpose());
        sum.stored += one.stored * f.area, sum.dissipated += one.dissipated * f.area;
        sum.yielding = sum.yielding || one.yielding;
      }
      std::vector<double> is{r.stored, r.dissipated}, should{sum.stored, sum.dissipated};
      is.insert(is.end(), r.stress.data(), r.stress.data() + 3),
          is.insert(is.end(), r.tangent.data(), r.tangent.data() + 9);
      should.insert(should.end(), sum.stress.data(), sum.stress.data() + 3);
      should.insert(should.end(), sum.tangent.data(), sum.tangent.data() + 9);
      REQUIRE(all_bits_equal(is, should));
      REQUIRE(r.yielding == sum.yielding);
      REQUIRE(all_bits_equal(next, expected));
      if (i % 3 == 0) memory = next;
    }
  }
}

}  // namespace trilith
