// The end of a report: damage by storey, the seal, and commands to repeat the run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/hash.hpp"
#include "report/sections.hpp"
#include "results/reading/frame_values.hpp"

namespace trilith::report {
namespace {

struct Storey {
  int joints = 0, bonded = 0, damaged = 0, lost = 0;
  double damage = 0;
};

void add(const results::JointRow& joint, double damage, Storey& storey) {
  constexpr double whole = 0.999;
  ++storey.joints;
  if (joint.bonded == 0) return;
  ++storey.bonded;
  storey.damage += damage;
  storey.damaged += damage > 0 ? 1 : 0;
  storey.lost += damage >= whole ? 1 : 0;
}

std::vector<std::string> row_of(const std::string& name, const Storey& s) {
  return {name,
          fmt::format("{}", s.joints),
          fmt::format("{}", s.bonded),
          fmt::format("{}", s.damaged),
          fmt::format("{}", s.lost),
          s.bonded == 0 ? "–" : fmt::format("{:.1f} %", 100 * s.damage / s.bonded)};
}

/// Digest of all positions, frame by frame, and of the events.
struct MotionDigest {
  std::uint64_t all, last;
};

void add(const results::Frame& frame, Hash& hash) {
  hash.add(frame.time);
  for (const double v : frame.position) hash.add(v);
  for (const double v : frame.rotation) hash.add(v);
}

MotionDigest motion_digest(const ReportSource& source, const ReportProgress& progress) {
  Hash all, last;
  const std::size_t count = source.reader.frame_count();
  for (std::size_t i = 0; i < count; ++i) {
    const results::Frame frame = source.reader.frame(i);
    add(frame, all);
    if (i + 1 == count) add(frame, last);
    if (progress) progress(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  for (const results::EventRow& e : source.events) {
    all.add(e.time);
    all.add(e.type);
    all.add(e.first.value);
  }
  return {all.value(), last.value()};
}

std::string commit_text(const std::string& commit) {
  if (commit.empty()) return "unknown";
  return commit.ends_with('+') ? commit.substr(0, commit.size() - 1) + ", with changes that were not committed"
                               : commit;
}

}  // namespace

void write_damage(const ReportSource& source, HtmlText& html) {
  if (source.header.joints.empty() || source.reader.frame_count() == 0) return;
  const results::Frame last = source.reader.frame(source.reader.frame_count() - 1);
  const std::vector<double>* const damage = results::values_of(source.header, last, "joint_damage");
  if (damage == nullptr || damage->size() != source.header.joints.size()) return;
  std::map<std::int32_t, Storey> storeys;
  Storey all;
  for (std::size_t j = 0; j < damage->size(); ++j) {
    const results::JointRow& joint = source.header.joints[j];
    add(joint, (*damage)[j], storeys[joint.storey]);
    add(joint, (*damage)[j], all);
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& [number, storey] : storeys)
    rows.push_back(row_of(number == 0 ? "none" : fmt::format("{}", number), storey));
  if (storeys.size() > 1) rows.push_back(row_of("all", all));
  html.element("h2", storeys.rbegin()->first == 0 ? "Damage of joints" : "Damage by storey");
  html.table({"Storey", "Joints", "With a bond at the start", "Of these damaged", "Lost", "Mean damage"}, rows, 1);
  html.element(
      "p",
      fmt::format("At {}. The damage of a joint is the part of its bond that is lost; the mean is over the joints "
                  "that had one.",
                  source.clock(last.time)),
      R"(class="note")");
}

void write_seal(const ReportSource& source, const ReportProgress& progress, HtmlText& html) {
  const results::Provenance& from = source.header.provenance;
  const MotionDigest digest = motion_digest(source, progress);
  html.element("h2", "Seal");
  const std::vector<SealRow> checks = source.reader.seal();
  std::vector<std::vector<std::string>> rows;
  for (const SealRow& row : checks) rows.push_back({row.state, seal_text(row)});
  if (!rows.empty()) html.table({"State", "Check of the run, made while it ran"}, rows, 2);
  html.table({"What", "Value"},
             {{"Digest of motion and events", fmt::format("{:016x} ({} frames, {} events)", digest.all,
                                                          source.reader.frame_count(), source.events.size())},
              {"Digest of the last frame", fmt::format("{:016x}", digest.last)},
              {"Engine", "Trilith " + (from.program_version.empty() ? "of unknown version" : from.program_version)},
              {"Commit", commit_text(from.git_commit)},
              {"Compiler", from.compiler},
              {"Platform", from.platform},
              {"Started", from.start_time},
              {"Results file", source.reader.path().filename().string() +
                                   (source.reader.finished() ? ", finished" : ", NOT finished")}},
             2);
  html.element("p",
               "The digests cover every bit of positions, rotations and events: the same script, run by the same "
               "program on the same platform, gives the same digits.",
               R"(class="note")");
}

void write_reproduction(const ReportSource& source, HtmlText& html) {
  const results::Provenance& from = source.header.provenance;
  html.element("h2", "How to run it again");
  if (from.command_line.empty())
    html.element("p", "The file does not record the command that made it.");
  else
    html.open("pre", R"(class="command")").open("code").verbatim(from.command_line).close().close();
  if (!from.git_commit.empty())
    html.element(
        "p",
        fmt::format("Built from commit {}, with {}. Paths are relative to the folder in which the command was run.",
                    commit_text(from.git_commit), from.compiler),
        R"(class="note")");
  if (from.script.empty()) {
    html.element("p", "The file does not hold the script.");
    return;
  }
  const auto lines = std::count(from.script.begin(), from.script.end(), '\n') + (from.script.back() == '\n' ? 0 : 1);
  html.open("details", R"(class="script")");
  html.open("summary")
      .verbatim(fmt::format("{}, {} lines", from.script_path.empty() ? "Script" : from.script_path, lines))
      .close();
  html.open("pre").open("code").verbatim(from.script).close().close().close();
}

}  // namespace trilith::report
