// The option --units of the verbs that show numbers of a results file.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

#include "base/error.hpp"
#include "base/unit_system.hpp"
#include "results/reading/reader.hpp"

namespace trilith::program {

/// "si", "us", or a unit of force and a unit of length. Throws InputError for an unknown unit.
inline UnitSystem named_units(const std::string& text) {
  return text == "si" ? UnitSystem() : UnitSystem(text == "us" ? "kip ft" : text, "");
}

inline void add_units(CLI::App& verb, std::string& units) {
  verb.add_option(
          "--units", units,
          "units of the numbers: a force and a length such as \"kN m\", \"N mm\" or \"kip ft\", or si, or us for "
          "kip and ft; default the units of the model")
      ->type_name("UNITS")
      ->check(CLI::Validator(
          [](const std::string& text) {
            try {
              named_units(text);
              return std::string();
            } catch (const InputError& e) {
              return std::string(e.what());
            }
          },
          "", ""));
}

/// The units of the option, or of the model.
inline UnitSystem shown_units(const std::string& given, const results::ResultsReader& reader) {
  return given.empty() ? reader.units() : named_units(given);
}

}  // namespace trilith::program
