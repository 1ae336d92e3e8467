#include "base/quantity_text.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace trilith;

TEST_CASE("quantities are written with engineering prefixes") {
  CHECK(quantity_text(1.234e6, "N") == "1.23 MN");
  CHECK(quantity_text(0.0032, "m/s2") == "3.2 mm/s²");
  CHECK(quantity_text(1500, "m") == "1500 m");
  CHECK(quantity_text(-2500, "N*m") == "−2.5 kN·m");
  CHECK(quantity_text(21474, "ft") == "21474 ft");
  CHECK(quantity_text(12, "ft") == "12 ft");
  CHECK(quantity_text(1000, "N") == "1 kN");
  CHECK(quantity_text(0, "N") == "0 N");
  CHECK(quantity_text(1193, "1") == "1193");
  CHECK(engineering_unit(3, "1").text.empty());
  CHECK(engineering_unit(1e120, "N").text == "10¹²⁰ N");
  CHECK(quantity_text(std::nan(""), "N") == "–");
  CHECK(engineering_unit(2.5e6, "lbf").text == "10⁶ lbf");
}

TEST_CASE("small quantities have a prefix, and rounding noise is 0") {
  CHECK(quantity_text(4.18e-12, "J") == "4.18 pJ");
  CHECK(quantity_text(1.001e-12, "J") == "1 pJ");
  CHECK(quantity_text(0.999e-12, "J") == "0 J");
  CHECK(quantity_text(-5.88e-16, "J") == "0 J");
  CHECK(quantity_text(3e-17, "1") == "0");
}

TEST_CASE("percentages have no exponent, and rounding noise is 0 %") {
  CHECK(percent_text(0.00012) == "0.012 %");
  CHECK(percent_text(0.123) == "12 %");
  CHECK(percent_text(1.234) == "123 %");
  CHECK(percent_text(0.005) == "0.5 %");
  CHECK(percent_text(-0.1) == "-10 %");
  CHECK(percent_text(1.2e-8) == "0.0000012 %");
  CHECK(percent_text(0.99e-8) == "0 %");
  CHECK(percent_text(std::nan("")) == "–");
}
