// Time of a step: the running-bond walls of 444 and 1,752 rigid units, shaken at 2 Hz and 0.5 g.
//
// Prints for each: processor seconds per simulated second, nanoseconds per closed contact and step, step length, peak
// memory, and the share of each stage of the step. Times on shared machines are noisy: compare runs made in turn.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <ctime>
#include <map>

#include "assembly/evaluate.hpp"
#include "build/plane/running_bond.hpp"
#include "events/commit.hpp"
#include "integrate/explicit/central_difference.hpp"
#include "integrate/explicit/mass_scaling.hpp"
#include "integrate/explicit/stable_step.hpp"
#include "model/builder/builder.hpp"
#include "run/simulation.hpp"

using namespace trilith;

namespace {

/// Processor time of this thread [s].
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Current benchmark and its progress, on a terminal; the figures replace the line.
void tell(const std::string& what, double share = 0) {
  if (::isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K{}  {:.0f} %", what, 100 * share);
}
void clear_line() {
  if (::isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");
}

Model<2> bench_model(int courses, BodyKind kind = BodyKind::rigid, int divisions = 1) {
  ModelBuilder builder;
  builder.add_material({"stone", 2000, Solid{LinearElastic{10e9, 0.2, 0}}});
  const double kn = 1e10, frequency = 1e4;
  builder.add_law("joint", Frictional{kn, 0.4 * kn, std::tan(35 * M_PI / 180), 2 * 0.1 / frequency});
  builder.set_contact("*", "*", "joint");
  for (Part& part : build_bench_wall(courses)) {
    BodySpec spec;
    spec.name = part.name;
    spec.outline = std::move(part.outline);
    spec.groups = part.groups;
    spec.material = "stone";
    if (part.name != "base") spec.kind = kind, spec.divisions = {divisions, divisions};
    if (part.name == "base") spec.support = {Support::fixed, Support::fixed, Support::fixed};
    builder.add_body(std::move(spec));
  }
  return builder.build();
}

void shake_base(Model<2>& model, double start) {
  const double dt = 0.005, peak = 0.5 * standard_gravity;
  std::vector<double> samples;
  for (int i = 0; i <= 2000; ++i) samples.push_back(peak * std::sin(2 * M_PI * 2 * dt * i));
  const double v0 = -peak / (2 * M_PI * 2);  // no drift
  const int base = model.find_body("base");
  set_drive(model, base, 0, std::make_shared<GroundMotion>(samples, dt, MotionStart{v0, 0}), start,
            model.start_position[model.bodies[base].first_node].x());
}

/// Candidate pairs of pieces with facing faces, close enough to touch before the next search.
int facing(const Work<2>& work) {
  int count = 0;
  for (const NearPair& p : work.pairs) count += p.facing > 0 ? 1 : 0;
  return count;
}

int touching(const Work<2>& work) {
  int count = 0;
  for (const ContactMemory& m : work.contacts.memory) count += (m.state & contact_touching) != 0 ? 1 : 0;
  return count;
}

void bench_wall(int courses, double dt, double seconds) {
  const std::string wall = fmt::format("wall of {} courses", courses);
  tell(wall + ", settling");
  Simulation<2> settle(bench_model(courses));
  StageOptions rest;
  rest.name = "settle";
  rest.duration = 1;
  rest.dt = dt;
  rest.rest_share = 0.8;
  settle.run(rest);
  Model<2> model = settle.model();
  State<2> state = settle.state();
  shake_base(model, state.time);
  Work<2> work;
  const auto steps = static_cast<int>(seconds / dt);
  double pairs = 0, general = 0;
  std::map<std::string, double> stage;
  const double begin = now();
  for (int i = 0; i < steps; ++i) {
    evaluate(model, state, work, state.last_dt);
    if (i % 32 == 0) stable_step(model, state, work);
    if (i % 1000 == 0) tell(wall + ", shaken", static_cast<double>(i) / steps);
    if (i % 100 == 0) pairs += touching(work), general += static_cast<double>(work.general_touching.size());
    add_inertia(model, state, work, {dt, {}});
    commit(model, state, work);
    advance(model, state, work, {dt, {}});
  }
  const double spent = now() - begin;
  const double mean_pairs = pairs / (steps / 100), per_pair = spent / steps / mean_pairs * 1e9;
  // Single stages at the reached state: the same work repeatedly.
  const auto time_stage = [&](const char* name, auto&& f) {
    constexpr int rounds = 2000;
    const double from = now();
    for (int i = 0; i < rounds; ++i) f();
    stage[name] = (now() - from) / rounds / mean_pairs * 1e9;
  };
  evaluate(model, state, work, dt);
  time_stage("1 place", [&] { update_kinematics(model, state, work); });
  time_stage("2 find", [&] { update_contact_pairs(model, state, work); });
  time_stage("3 respond faces", [&] { face_contact_forces(model, state, work, dt); });
  time_stage("4 respond general", [&] {
    face_contact_forces(model, state, work, dt);
    polygon_contact_forces(model, state, work, dt);
  });
  time_stage("5 sum", [&] { assemble_forces(model, state, work); });
  stage["4 respond general"] -= stage["3 respond faces"];
  State<2> copy = state;
  const double whole = spent / steps / mean_pairs * 1e9;
  double rest_of = whole;
  for (const auto& [name, ns] : stage) rest_of -= ns;
  stage["6 advance, notice, step estimate"] = rest_of;
  clear_line();
  const double facing_pairs = facing(work), units = static_cast<double>(model.bodies.size() - 1);
  fmt::print("wall of {:.0f} units, {:.0f} touching pairs ({:.1f} general) of {:.0f} facing, dt {:g} s\n", units,
             mean_pairs, general / (steps / 100), facing_pairs, dt);
  fmt::print("  {:.3f} s per simulated second, peak memory {:.0f} MB\n", spent / seconds, peak_megabytes());
  fmt::print("  per step: {:.1f} ns per touching pair, {:.1f} ns per facing pair, {:.1f} ns per unit\n", per_pair,
             per_pair * mean_pairs / facing_pairs, per_pair * mean_pairs / units);
  for (const auto& [name, ns] : stage) fmt::print("    {:34s} {:6.1f} ns per pair\n", name, ns);
}

/// The wall of 444 units for each kind of body, at its automatic step.
void bench_kinds(double seconds) {
  struct Kind {
    const char* name;
    BodyKind kind;
    int divisions;
  };
  for (const Kind& k :
       {Kind{"rigid", BodyKind::rigid, 1}, Kind{"quad", BodyKind::quad, 1}, Kind{"2 x 2 mesh", BodyKind::mesh, 2}}) {
    tell(fmt::format("wall of 444 units as {}, settling and shaken", k.name));
    Simulation<2> sim(bench_model(24, k.kind, k.divisions));
    StageOptions options;
    options.name = "settle", options.duration = 0.1, options.rest_share = 0.8, options.safety = 0.8;
    sim.run(options);
    shake_base(sim.edit_model(), sim.state().time);
    options.name = "shake", options.duration = seconds, options.rest_share = 0;
    const double begin = now();
    const StageReport report = sim.run(options);
    const double spent = now() - begin;
    clear_line();
    fmt::print("wall of 444 units as {}: {:.2f} s per simulated second, {} steps of {:.3g} s, {:.1f} us a step\n",
               k.name, spent / seconds, report.steps, report.shortest_dt,
               1e6 * spent / static_cast<double>(report.steps));
  }
}

}  // namespace

int main() {
  bench_wall(24, 1e-4, 1.0);
  bench_wall(48, 1e-4, 0.5);
  bench_kinds(0.5);
}
