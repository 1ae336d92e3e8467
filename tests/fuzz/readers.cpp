// Readers of text, of checkpoints and of results under libFuzzer: any bytes are read, or rejected with a one-line
// message. TRILITH_READER selects the reader.
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/units.hpp"
#include "build/space/gmsh.hpp"
#include "build/space/solid_file.hpp"
#include "damaged_results.hpp"
#include "geometry/plane/mesh.hpp"
#include "load/motion_plain.hpp"
#include "load/motion_read.hpp"
#include "load/text_lines.hpp"
#include "model/builder/builder.hpp"
#include "model/io/checkpoint.hpp"
#include "results/file/results.hpp"
#include "run/simulation.hpp"
#include "run/study/study_figures.hpp"

namespace {

using trilith::InputError;

void require(bool holds, const char* what) {
  if (holds) return;
  fmt::print(stderr, "{}\n", what);
  std::abort();
}

void read_record(std::string_view text) {
  const trilith::GroundMotion motion = trilith::parse_motion(text, "record");
  require(std::isfinite(motion.duration()), "a record was taken whose duration is not a number");
  for (const double share : {-1.0, 0.0, 0.37, 1.0, 2.0}) {
    const auto [acceleration, velocity, displacement] = motion.at(share * motion.duration());
    require(std::isfinite(acceleration) && std::isfinite(velocity) && std::isfinite(displacement),
            "a record was taken whose motion is not a number");
  }
}

void read_mesh(std::string_view text) {
  const trilith::CheckedMesh checked = trilith::check_mesh(trilith::parse_gmsh(text, "mesh"), "mesh");
  require(checked.outline >= 3, "a mesh was taken that has no outline");
}

/// Columns of numbers: the first line has unit, step, column, number of header lines and decimal sign, or '-' for none.
void read_columns(std::string_view text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::vector<std::string_view> words = trilith::words_of(text.substr(0, end));
  const auto word = [&](std::size_t i) {
    return i < words.size() && words[i] != "-" ? std::string(words[i]) : std::string();
  };
  trilith::PlainForm form;
  form.unit = word(0).empty() ? "g" : word(0);
  form.step = trilith::number_in(word(1));
  form.column = word(2);
  if (const auto skip = trilith::number_in(word(3))) form.skip = static_cast<int>(std::clamp(*skip, 0.0, 1e6));
  form.decimal = word(4).empty() ? '\0' : word(4)[0];
  const trilith::GroundMotion motion =
      trilith::parse_plain_motion(text.substr(std::min(end + 1, text.size())), "record", form);
  require(std::isfinite(motion.samples().back().displacement), "a record was taken whose motion is not a number");
}

/// Accepted parts are bodies: named, closed, with a volume.
void require_sound(const trilith::SolidParts& made) {
  require(!made.parts.empty(), "a file of solids was taken that has none");
  for (const trilith::SolidPart& part : made.parts) {
    require(!part.name.empty() && !part.pieces.empty(), "a solid was taken without a name or a piece");
    const double volume = trilith::volume_of(part);
    require(std::isfinite(volume) && volume > 0, "a solid was taken whose volume is not a number above 0");
  }
}

/// The first byte selects the options of the reader.
trilith::SolidFile way_of(std::string_view text) {
  trilith::SolidFile how;
  const unsigned way = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
  how.name = way & 1 ? "n" : "", how.shells_are_bodies = (way & 2) != 0, how.y_up = (way & 4) != 0;
  if (way & 8) how.weld = 1e-3;
  return how;
}
void read_obj(std::string_view text) {
  require_sound(trilith::parse_obj(text.substr(std::min<std::size_t>(1, text.size())), way_of(text), "solids"));
}
void read_stl(std::string_view text) {
  require_sound(trilith::parse_stl(text.substr(std::min<std::size_t>(1, text.size())), way_of(text), "solids"));
}
void read_space_mesh(std::string_view text) {
  const trilith::CheckedSpaceMesh checked =
      trilith::check_space_mesh(trilith::parse_gmsh_in_space(text, "mesh"), "mesh");
  require(!checked.mesh.cell.empty(), "a mesh was taken that has no element");
}

/// "unit of the declaration, text" as on the command line.
void read_quantity(std::string_view text) {
  const std::size_t comma = text.find(',');
  const std::string_view unit = comma == std::string_view::npos ? "m" : text.substr(0, comma);
  const std::string_view value = comma == std::string_view::npos ? text : text.substr(comma + 1);
  require(std::isfinite(trilith::parse_quantity(value, unit, "value")), "a value was taken that is not a number");
}

void read_unit(std::string_view text) {
  const trilith::UnitProduct unit = trilith::parse_unit(text);
  require(std::isfinite(unit.factor), "a unit was taken whose factor is not a number");
  (void)trilith::si_unit(unit.dimension);
}

void read_figures(std::string_view text) {
  const auto figures = trilith::figures_from(std::string(text));
  require(trilith::figures_from(trilith::figures_text(figures)).size() == figures.size(),
          "figures that were written are not read back");
}

/// Two blocks on a base with a bearing and a seat, after some steps, and the checkpoint of this state.
struct Saved {
  trilith::Model<2> model;
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trilith_fuzz_" + std::to_string(::getpid()) + ".state");
  std::string bytes;

  static void add_block(trilith::ModelBuilder& builder, const char* name, double y, double half, bool fixed) {
    trilith::BodySpec spec;
    spec.name = name, spec.material = "stone";
    spec.outline = {{-half, y}, {half, y}, {half, y + 0.5}, {-half, y + 0.5}};
    if (fixed) spec.support.fill(trilith::Support::fixed);
    builder.add_body(std::move(spec));
  }
  static trilith::Model<2> made() {
    trilith::ModelBuilder builder;
    builder.add_material({"stone", 2000});
    builder.add_law("joint", trilith::Frictional{1e7, 5e6, 0.3, 1e-4});
    builder.set_contact("*", "*", "joint");
    builder.gravity = {0, -9.81};
    add_block(builder, "base", -0.5, 3, true);
    add_block(builder, "low", 0, 0.5, false);
    add_block(builder, "high", 0.5, 0.4, false);
    trilith::BearingSpec link;
    link.name = "link", link.body_a = "low", link.body_b = "high";
    link.point_a = link.point_b = {0.2, 0.5};
    link.law[trilith::along] = trilith::ElasticPlastic{1e5, 50, 0.1, 10};
    builder.add_bearing(link);
    trilith::SeatSpec seat;
    seat.name = "seat", seat.body = "high", seat.support = "low", seat.end = {0.4, 0.5}, seat.edge = {-0.5, 0.5};
    builder.add_seat(seat);
    return builder.build();
  }
  static std::string contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  Saved() : model(made()) {
    trilith::Simulation<2> sim(model);
    trilith::StageOptions options;
    options.duration = 0.02;
    sim.run(options);
    trilith::save_state(sim.state(), model, path);
    bytes = contents(path);
  }
};

/// Nine bytes each: index of a word of a valid checkpoint, and its new value (index 256: the length of the file). The
/// result gets a new digest, because otherwise the digest check would reject nearly all of them.
void read_checkpoint(std::string_view text) {
  static const Saved saved;
  std::string bytes = saved.bytes;
  for (std::size_t at = 0; at + 9 <= text.size(); at += 9) {
    const std::size_t word = static_cast<std::uint8_t>(text[at]) * (bytes.size() / 8) / 255;
    if (8 * word + 8 <= bytes.size())
      std::memcpy(bytes.data() + 8 * word, text.data() + at + 1, 8);
    else
      bytes.resize(static_cast<std::uint8_t>(text[at + 1]) * bytes.size() / 255 / 8 * 8);
  }
  if (bytes.size() >= 16) {
    trilith::Hash hash;
    std::uint64_t word = bytes.size() / 8 - 7;
    std::memcpy(bytes.data() + 40, &word, bytes.size() > 56 ? 8 : 0);
    for (std::size_t i = 0; i + 16 <= bytes.size(); i += 8) {
      std::memcpy(&word, bytes.data() + i, 8);
      hash.add(word);
    }
    word = hash.value();
    std::memcpy(bytes.data() + bytes.size() / 8 * 8 - 8, &word, 8);
  }
  std::ofstream(saved.path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const trilith::State<2> state = trilith::load_state(saved.model, saved.path);
  trilith::save_state(state, saved.model, saved.path);
  require(Saved::contents(saved.path) == bytes, "a checkpoint that was read is written in another way");
}

struct Reader {
  std::string_view name;
  void (*read)(std::string_view);
};
constexpr Reader readers[] = {{"record", read_record},
                              {"columns", read_columns},
                              {"mesh", read_mesh},
                              {"space_mesh", read_space_mesh},
                              {"obj", read_obj},
                              {"stl", read_stl},
                              {"quantity", read_quantity},
                              {"unit", read_unit},
                              {"figures", read_figures},
                              {"checkpoint", read_checkpoint},
                              {"results", trilith::fuzz::read_damaged_results}};

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
  } catch (const trilith::results::ResultsError& refused) {
    require(!std::string_view(refused.what()).empty(), "a refusal without a word");
  }
  return 0;
}
