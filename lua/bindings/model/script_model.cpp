#include "bindings/model/script_model.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/team.hpp"
#include "base/terminal_text.hpp"

namespace trilith::script {

std::filesystem::path Host::folder() const {
  const std::filesystem::path parent = std::filesystem::path(script).parent_path();
  return parent.empty() ? "." : parent;
}

ThreadChoice Host::threads_for(int wanted) const {
  if (threads > 0) return ThreadChoice::always(threads);
  if (wanted > 0) return ThreadChoice::always(wanted);
  const char* const said = std::getenv("TRILITH_THREADS");
  if (said == nullptr || *said == '\0') return ThreadChoice::up_to(threads_here());
  const std::string text = said;
  const bool whole = text.size() <= 2 && text.find_first_not_of("0123456789") == std::string::npos;
  const int count = whole ? std::stoi(text) : 0;
  if (count < 1 || count > most_threads)
    throw InputError(
        fmt::format("the variable TRILITH_THREADS is '{}', must be a whole number from 1 to {}", text, most_threads));
  return ThreadChoice::always(count);
}

results::Provenance Host::provenance(const std::vector<std::string>& motions) const {
  results::Provenance p;
  p.script = script_text;
  p.script_path = script;
  p.program_version = TRILITH_VERSION;
  p.command_line = command_line;
  p.parameters = parameters;
  p.motions = motions;
  p.units = units.text();
  return p;
}

void Host::finish(const std::string& error) {
  for (const std::string& line : close(error))
    if (observer != nullptr) observer->note(line);
}

std::vector<std::string> Host::close(const std::string& error) {
  std::vector<std::string> lines;
  for (const auto& model : std::exchange(recorded, {})) {
    if (!error.empty() && interrupted != nullptr && interrupted()) model->end_by_signal();
    std::string said = model->finish(error);
    if (!said.empty()) lines.push_back(std::move(said));
  }
  return lines;
}

std::vector<std::string> Host::untrusted_runs() const {
  std::vector<std::string> lines;
  for (const auto& [title, verdict] : verdicts)
    if (!verdict->sound()) lines.push_back(fmt::format("the run of {} is {}", title, units.message(verdict->text())));
  return lines;
}

void ScriptModel::require_present(int body, const std::string& owner) const {
  const std::string why = why_absent(body);
  if (!why.empty())
    throw InputError(fmt::format("{}{}body '{}' {}", owner, owner.empty() ? "" : ": ", body_name(body), why));
}

std::vector<std::string> ScriptModel::body_names() const {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(body_count()));
  for (int b = 0; b < body_count(); ++b) names.push_back(body_name(b));
  return names;
}

int ScriptModel::require_body(const std::string& body, const std::string& owner) const {
  for (int b = 0; b < body_count(); ++b)
    if (body_name(b) == body) return b;
  throw InputError(fmt::format("{}: there is no body '{}'{}", owner, one_line(body), name_hint(body, body_names())));
}

void ScriptModel::note_at_once(const std::string& text, Host& host) {
  add_note(text);
  note(text);
  for (; host.observer != nullptr && notes_shown_ < notes().size(); ++notes_shown_)
    host.observer->note(notes()[notes_shown_]);
}

void ScriptModel::pause(const std::function<void()>& ask) {
  paused_ = true;
  struct Scope {
    bool& paused;
    ~Scope() { paused = false; }
  } scope{paused_};
  ask();
}

}  // namespace trilith::script
