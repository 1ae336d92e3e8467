// Units in which results are shown.
#include "base/unit_system.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>

#include "base/error.hpp"
#include "base/exact_message.hpp"
#include "base/quantity_text.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

TEST_CASE("a system of units names and scales forces, lengths and derived quantities") {
  const UnitSystem metric("kN m"), small("mm N"), american("kip ft s");
  CHECK(metric.name("Pa") == "kN/m2");
  CHECK(metric.name("N*m") == "kN m");
  CHECK(small.name("Pa/m") == "N/mm3");
  CHECK(small.name("m/s2") == "mm/s2");
  CHECK(american.name("J/m2") == "kip/ft");
  CHECK(metric.name("kg") == "t");
  CHECK(UnitSystem("N m").name("kg") == "kg");
  CHECK(american.name("kg") == "kip s2/ft");
  CHECK(metric.name("kg/m3") == "kN s2/m4");
  CHECK(metric.shown(1.5e6, "Pa") == 1500);
  CHECK(small.shown(0.29, "m") == 290);
  CHECK(small.shown(2e9, "Pa/m") == 2);
  CHECK(near(american.shown(4448.2216152605, "N"), 1, 1e-15));
  CHECK(near(american.shown(0.3048, "m"), 1, 1e-15));
}

TEST_CASE("units without force and length, incoherent and unknown units stay as they are") {
  const UnitSystem small("N mm");
  for (const char* unit : {"", "1", "s", "Hz", "rad", "g", "degC", "K", "mm", "flag", "of the script"}) {
    CHECK(!small.unit_for(unit));
    CHECK(small.name(unit) == unit);
    CHECK(small.shown(0.3, unit) == 0.3);
  }
  CHECK(UnitSystem().is_si());
  CHECK(UnitSystem("SI").is_si());
  CHECK(UnitSystem().name("Pa") == "Pa");
  CHECK(UnitSystem().message("0.5 m") == "0.5 m");
}

TEST_CASE("a system needs one force and one length") {
  const auto said = [](const char* text) -> std::string {
    try {
      UnitSystem{text, "model"};
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(said("kN kg").find("must be a unit of force and a unit of length") != std::string::npos);
  CHECK(said("kN mile").find("there is no unit 'mile'") != std::string::npos);
  for (const char* wrong : {"kN", "m", "kN m mm", "kN N m", "Pa m"})
    CHECK(said(wrong).starts_with("model: 'units' is"));
  CHECK(said("m, kN").empty());
}

TEST_CASE("numbers with SI units in texts are converted, and other numbers are not") {
  const UnitSystem small("N mm");
  CHECK(small.message("moved by 0.25 m at 3.2 s") == "moved by 250 mm at 3.2 s");
  CHECK(small.message("3.21 kN/m, 12 MPa") == "3.21 N/mm, 12 N/mm2");
  CHECK(small.message("−2.5 N·m") == "−2500 N·mm");
  CHECK(small.message("-2.5 N m") == "-2500 N mm");
  CHECK(small.message("kn=5e+09 Pa/m, mu=0.6 1") == "kn=5 N/mm3, mu=0.6 1");
  CHECK(small.message("1e-3 m/s² of 5 blocks") == "1 mm/s² of 5 blocks");
  // Part of a word or of a longer number, without a unit, or with letters behind it.
  for (const char* same : {"12,345 m", "x1 m", "5 mortar joints", "5 N/blow", "3 of 4", "0.5 kg/kg", "2.4 GHz", "7 ft"})
    CHECK(small.message(same) == same);
}

TEST_CASE("a converted text stays as it is when it is converted again") {
  for (const char* units : {"kN m", "N mm", "kip ft", "MN cm"}) {
    const UnitSystem system(units);
    const std::string once =
        system.message("2.5 kN at 1.25 m, 3 MPa, 40 kN·m, 7.5 J, 0.125 m/s, 2400 kg/m3, 12.5 kg, 0.5 1/m");
    CHECK(system.message(once) == once);
    CHECK(system.message(quantity_text(1234.5, "N*m", system)) == quantity_text(1234.5, "N*m", system));
  }
}

TEST_CASE("quantities in a system have its unit instead of a prefix") {
  const UnitSystem metric("kN m"), small("N mm");
  CHECK(quantity_text(1.234e6, "N", metric) == "1234 kN");
  CHECK(quantity_text(0.0123, "m", metric) == "0.0123 m");
  CHECK(quantity_text(0.0123, "m", small) == "12.3 mm");
  CHECK(quantity_text(2.5e6, "Pa", small) == "2.5 N/mm²");
  CHECK(quantity_text(2.5e6, "Pa", metric) == "2500 kN/m²");
  CHECK(quantity_text(-2500, "N*m", metric) == "−2.5 kN·m");
  CHECK(quantity_text(3.5e9, "N", metric) == "3.5·10⁶ kN");
  CHECK(quantity_text(0.02, "s", metric) == "20 ms");
  const ShownUnit unit = engineering_unit(8e5, "Pa", metric);
  CHECK(unit.size == 1e3);
  CHECK(unit.text == "kN/m²");
}

TEST_CASE("exact values replace the rounded numbers of a text before the conversion") {
  const UnitSystem small("N mm"), american("kip ft");
  const std::array exact{ExactNumber{136987.6, "N m"}, ExactNumber{-0.0123456, "m"}};
  CHECK(exact_message(small, "yielded under 137 kN m", exact) == "yielded under 136987600 N mm");
  CHECK(exact_message(small, "under -137 kN m at 12.3 mm", exact) == "under -136987600 N mm at 12.3 mm");
  CHECK(exact_message(american, "under 137 kN m", exact) == "under 101 kip ft");
  // Another number, another unit, and a number beyond the rounding are converted as they are.
  CHECK(exact_message(small, "under 138 kN m", exact) == "under 138000000 N mm");
  CHECK(exact_message(small, "137 kN", exact) == "137000 N");
  CHECK(exact_message(small, "137.2 kN m", exact) == "137200000 N mm");
  CHECK(exact_message(UnitSystem(), "137 kN m", exact) == "137 kN m");
}

TEST_CASE("a message asks for a number in the unit of the system") {
  const UnitSystem small("N mm");
  CHECK(small.message("'height' is missing; give a number in m") == "'height' is missing; give a number in mm");
  CHECK(small.message("must be a finite number in Pa/m, above 0") == "must be a finite number in N/mm3, above 0");
  CHECK(small.message("a number in s") == "a number in s");
  CHECK(small.message("the number in metres") == "the number in metres");
  CHECK(small.message(small.message("a number in N m")) == "a number in N mm");
}
