// The option for the origin of times, of all verbs that show times.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace trilith::program {

inline void add_since(CLI::App& verb, std::string& since) {
  verb.add_option(
          "--since", since,
          "count times from the beginning of this stage, or from the first event of this type: shake, seat.lost")
      ->type_name("NAME");
}

}  // namespace trilith::program
