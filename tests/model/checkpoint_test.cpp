// A State in a file and back; truncated, damaged and foreign files.
#include "model/io/checkpoint.hpp"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>
#include <vector>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "geometry/plane/random_convex.hpp"
#include "model/io/fingerprint.hpp"
#include "physics/scene.hpp"

namespace trilith {
namespace {

using testing::box;
using testing::Scene;
namespace fs = std::filesystem;

/// A temporary folder for each use, removed at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("trilith_checkpoint_" + std::to_string(::getpid()));
  Folder() {
    fs::remove_all(path);
    fs::create_directory(path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }
};

/// Two blocks on a base, the upper one connected to the lower one by a bearing, sliding.
Model<2> small_model(double mu = 0.3) {
  Scene scene(Frictional{1e7, 5e6, mu, 1e-4});
  scene.fixed("base", box(-1, -0.5, 3, 0));
  scene.block("low", box(0, 0, 1, 0.5), 100, {0.5, 0});
  scene.block("high", box(0.1, 0.5, 0.9, 1), 50, {0.7, 0});
  BearingSpec link;
  link.name = "link", link.body_a = "low", link.body_b = "high";
  link.point_a = link.point_b = {0.5, 0.5};
  link.law[along] = ElasticPlastic{1e5, 50, 0.1, 10};
  scene.builder.add_bearing(link);
  SeatSpec seat;
  seat.name = "seat", seat.body = "high", seat.support = "low", seat.end = {0.9, 0.5}, seat.edge = {0, 0.5};
  scene.builder.add_seat(seat);
  return scene.builder.build();
}

State<2> moved_state(const Model<2>& model, double duration = 0.05) {
  Simulation<2> sim(model);
  testing::run_for(sim, duration);
  return sim.state();
}

std::vector<char> bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const fs::path& path, const std::vector<char>& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Sets the last word to the digest of the words before, as in a file written with these contents.
void sign(std::vector<char>& bytes) {
  Hash hash;
  for (std::size_t i = 0; i + 16 <= bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, 8);
    hash.add(word);
  }
  const std::uint64_t digest = hash.value();
  std::memcpy(bytes.data() + bytes.size() - 8, &digest, 8);
}

std::string message_of(const Model<2>& model, const fs::path& path) {
  try {
    load_state(model, path);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST_CASE("a state saved and loaded has the same digest, and its file the same bytes when saved again") {
  const Folder folder;
  const Model<2> model = small_model();
  for (const double duration : {1e-9, 0.05, 0.3}) {
    const State<2> state = moved_state(model, duration);
    save_state(state, model, folder.path / "a");
    const State<2> loaded = load_state(model, folder.path / "a");
    CHECK(state_hash(loaded) == state_hash(state));
    save_state(loaded, model, folder.path / "b");
    CHECK(bytes_of(folder.path / "a") == bytes_of(folder.path / "b"));
  }
}

TEST_CASE(
    "a checkpoint of another model is rejected, and the message says whether the model or its conditions differ") {
  const Folder folder;
  const fs::path path = folder.path / "state";
  const Model<2> model = small_model();
  save_state(moved_state(model), model, path);
  CHECK(message_of(small_model(0.31), path).find("belongs to another model") != std::string::npos);
  Model<2> other = model;
  other.gravity.field.y() *= 0.5;
  CHECK(message_of(other, path).find("with other supports, motions, gravity") != std::string::npos);
  CHECK(message_of(model, path).empty());
}

TEST_CASE("the fingerprint of a model changes with every part of it") {
  const Model<2> model = small_model();
  const Fingerprint print = model_fingerprint(model);
  CHECK(model_fingerprint(small_model()) == print);
  const auto structure_differs = [&](auto&& change) {
    Model<2> other = model;
    change(other);
    const Fingerprint now = model_fingerprint(other);
    return now.structure != print.structure && now.conditions == print.conditions;
  };
  const auto conditions_differ = [&](auto&& change) {
    Model<2> other = model;
    change(other);
    const Fingerprint now = model_fingerprint(other);
    return now.structure == print.structure && now.conditions != print.conditions;
  };
  CHECK(structure_differs([](Model<2>& m) { m.mass[1] += 1e-9; }));
  CHECK(structure_differs([](Model<2>& m) { m.skin_place[5].x() += 1e-12; }));
  CHECK(structure_differs([](Model<2>& m) { m.bodies[1].name = "lower"; }));
  CHECK(structure_differs([](Model<2>& m) { m.laws[0] = Bonded{1e7, 5e6, 0.3, 1e-4, 0, 0, 0}; }));
  CHECK(structure_differs([](Model<2>& m) { m.law_of[0] = -1; }));
  CHECK(structure_differs([](Model<2>& m) { m.bearings[0].limit[axial] = 0.1; }));
  CHECK(structure_differs([](Model<2>& m) { m.bearings[0].law[along] = Linear{1e5, 10}; }));
  CHECK(structure_differs([](Model<2>& m) { m.bearings[0].law[axial] = Table{{-1, 1}, {-5, 5}, 0}; }));
  CHECK(structure_differs([](Model<2>& m) { m.seats[0].edge.arm[0].x() = 0.2; }));
  CHECK(conditions_differ([](Model<2>& m) { m.gravity.tilt_rate = 0.1; }));
  CHECK(conditions_differ([](Model<2>& m) { m.mass_damping = 0.1; }));
  CHECK(conditions_differ([](Model<2>& m) { set_support(m, 1, 0, Support::fixed); }));
  CHECK(conditions_differ([](Model<2>& m) { m.load[1].x() = 1; }));
  const std::vector<double> up{0, 1, 0}, down{0, -1, 0};
  const auto drive = [](const std::vector<double>& samples) {
    return [&samples](Model<2>& m) { set_drive(m, 0, 0, std::make_shared<GroundMotion>(samples, 0.1), 0, 0); };
  };
  CHECK(conditions_differ(drive(up)));
  Model<2> one = model, two = model;
  drive(up)(one);
  drive(down)(two);
  CHECK(model_fingerprint(one) != model_fingerprint(two));
}

TEST_CASE("a checkpoint cut anywhere is rejected") {
  const Folder folder;
  const fs::path path = folder.path / "state";
  const Model<2> model = small_model();
  save_state(moved_state(model), model, path);
  const std::vector<char> whole = bytes_of(path);
  for (std::size_t length = 0; length < whole.size(); length += 5) {
    write_bytes(path, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    CHECK_FALSE(message_of(model, path).empty());
  }
  std::vector<char> longer = whole;
  longer.resize(whole.size() + 8, '\0');
  write_bytes(path, longer);
  CHECK_FALSE(message_of(model, path).empty());
}

TEST_CASE("a checkpoint with any byte changed is rejected") {
  const Folder folder;
  const fs::path path = folder.path / "state";
  const Model<2> model = small_model();
  save_state(moved_state(model), model, path);
  const std::vector<char> whole = bytes_of(path);
  std::mt19937_64 bits(7);
  for (std::size_t i = 0; i < whole.size(); i += i < 64 ? 1 : 7) {
    std::vector<char> bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ random_count(bits, 1, 255));
    write_bytes(path, bytes);
    CHECK_FALSE(message_of(model, path).empty());
  }
}

TEST_CASE("a damaged checkpoint with a matching digest gives an input error or a valid state, never a crash") {
  const Folder folder;
  const fs::path path = folder.path / "state";
  const Model<2> model = small_model();
  save_state(moved_state(model), model, path);
  const std::vector<char> whole = bytes_of(path);
  std::mt19937_64 bits(11);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<char> bytes = whole;
    const int words = static_cast<int>(bytes.size() / 8);
    for (int k = random_count(bits, 1, 3); k > 0; --k) {
      const auto at = static_cast<std::size_t>(8 * random_count(bits, 5, words - 2));
      const std::uint64_t choices[] = {bits(), 0, 1, ~std::uint64_t{0}, 1000000000ULL, 0x7ff8000000000000ULL};
      std::memcpy(bytes.data() + at, &choices[random_count(bits, 0, 5)], 8);
    }
    sign(bytes);
    write_bytes(path, bytes);
    try {
      const State<2> state = load_state(model, path);
      CHECK(state.position.size() == 3);
      CHECK(std::isfinite(state.time));
    } catch (const InputError&) {
      ++refused;
    }
  }
  MESSAGE(refused << " of 400 refused");
  CHECK(refused > 100);
}

TEST_CASE("foreign files and checkpoints of another version or byte order are rejected with the reason") {
  const Folder folder;
  const fs::path path = folder.path / "state";
  const Model<2> model = small_model();
  CHECK(message_of(model, folder.path / "none").find("No such file") != std::string::npos);
  write_bytes(path, {'h', 'e', 'l', 'l', 'o'});
  CHECK(message_of(model, path).find("is not a checkpoint") != std::string::npos);
  save_state(moved_state(model), model, path);
  const std::vector<char> whole = bytes_of(path);
  std::vector<char> other = whole;
  other[16] = 99;
  write_bytes(path, other);
  CHECK(message_of(model, path).find("version 99") != std::string::npos);
  other = whole;
  std::reverse(other.begin() + 8, other.begin() + 16);
  write_bytes(path, other);
  CHECK(message_of(model, path).find("other byte order") != std::string::npos);
}

TEST_CASE("a checkpoint that cannot be written is an input error, and the previous one is unchanged") {
  const Folder folder;
  const Model<2> model = small_model();
  const State<2> state = moved_state(model);
  CHECK_THROWS_AS(save_state(state, model, folder.path / "no" / "folder"), InputError);
  // A folder with this name exists.
  fs::create_directory(folder.path / "folder");
  CHECK_THROWS_AS(save_state(state, model, folder.path / "folder"), InputError);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}

TEST_CASE("a full disk leaves no part of a checkpoint, and the previous one is unchanged") {
  const Folder folder;
  const Model<2> model = small_model();
  const State<2> state = moved_state(model);
  save_state(state, model, folder.path / "state");
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit then fails, as on a full disk
    const struct rlimit bound = {100, 100};
    ::setrlimit(RLIMIT_FSIZE, &bound);
    try {
      save_state(state, model, folder.path / "state");
    } catch (const InputError&) {
      ::_exit(0);
    }
    ::_exit(1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
  CHECK(state_hash(load_state(model, folder.path / "state")) == state_hash(state));
}

}  // namespace
}  // namespace trilith
