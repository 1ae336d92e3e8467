// Readers of text under libFuzzer: whatever the bytes are, they are read or refused with one line. TRILITH_READER names
// the reader.
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/units.hpp"
#include "build/gmsh.hpp"
#include "load/motion_read.hpp"
#include "run/study_figures.hpp"
#include "shape/mesh.hpp"

namespace {

using trilith::InputError;

void require(bool holds, const char* what) {
  if (holds) return;
  fmt::print(stderr, "{}\n", what);
  std::abort();
}

void read_record(std::string_view text) {
  const trilith::GroundMotion motion = trilith::parse_motion(text, "record");
  require(std::isfinite(motion.duration()), "a record was taken whose duration is no number");
  for (const double share : {-1.0, 0.0, 0.37, 1.0, 2.0}) {
    const auto [acceleration, velocity, displacement] = motion.at(share * motion.duration());
    require(std::isfinite(acceleration) && std::isfinite(velocity) && std::isfinite(displacement),
            "a record was taken whose motion is no number");
  }
}

void read_mesh(std::string_view text) {
  const trilith::CheckedMesh checked = trilith::check_mesh(trilith::parse_gmsh(text, "mesh"), "mesh");
  require(checked.outline >= 3, "a mesh was taken that has no outline");
}

/// "unit of the declaration, text": what stands on the command line.
void read_quantity(std::string_view text) {
  const std::size_t comma = text.find(',');
  const std::string_view unit = comma == std::string_view::npos ? "m" : text.substr(0, comma);
  const std::string_view value = comma == std::string_view::npos ? text : text.substr(comma + 1);
  require(std::isfinite(trilith::parse_quantity(value, unit, "value")), "a value was taken that is no number");
}

void read_unit(std::string_view text) {
  const trilith::UnitProduct unit = trilith::parse_unit(text);
  require(std::isfinite(unit.factor), "a unit was taken whose factor is no number");
  (void)trilith::si_unit(unit.dimension);
}

void read_figures(std::string_view text) {
  const auto figures = trilith::figures_from(std::string(text));
  require(trilith::figures_from(trilith::figures_text(figures)).size() == figures.size(),
          "figures that were written are not read back");
}

struct Reader {
  std::string_view name;
  void (*read)(std::string_view);
};
constexpr Reader readers[] = {{"record", read_record},
                              {"mesh", read_mesh},
                              {"quantity", read_quantity},
                              {"unit", read_unit},
                              {"figures", read_figures}};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Reader* const chosen = [] {
    const char* const name = std::getenv("TRILITH_READER");
    for (const Reader& reader : readers)
      if (name != nullptr && reader.name == name) return &reader;
    fmt::print(stderr, "TRILITH_READER names no reader\n");
    std::exit(2);
  }();
  try {
    chosen->read({reinterpret_cast<const char*>(data), size});
  } catch (const InputError& refused) {
    require(!std::string_view(refused.what()).empty(), "a refusal without a word");
  }
  return 0;
}
