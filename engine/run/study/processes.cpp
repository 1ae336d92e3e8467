#include "run/study/processes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <optional>
#include <thread>

namespace trilith {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds look_interval{10};
constexpr std::chrono::seconds patience{10};
constexpr int cannot_begin = 127;

struct Running {
  std::size_t order;
  pid_t id;
  Clock::time_point begun;
};

void redirect(const char* path, int descriptor) {
  const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(cannot_begin);
}

/// Only calls that are permitted between fork and exec; all memory was allocated before.
void settle_in(const char* out, const char* errors, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(cannot_begin);  // the parent died in between
  ::signal(SIGINT, SIG_DFL);
  redirect("/dev/null", STDIN_FILENO);
  redirect(out, STDOUT_FILENO);
  redirect(errors, STDERR_FILENO);
}

/// Buffered output of this program is written by the parent; the child exits without flushing it.
[[noreturn]] void carry_out(const ProcessOrder& order) {
  int code = cannot_begin;
  try {
    code = order.here();
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    code = 1;
  }
  std::fflush(nullptr);
  ::_exit(code);
}

pid_t begin(const ProcessOrder& order) {
  std::vector<char*> arguments;
  for (const std::string& a : order.command) arguments.push_back(const_cast<char*>(a.c_str()));
  arguments.push_back(nullptr);
  const pid_t self = ::getpid();
  if (order.here) std::fflush(nullptr);  // otherwise the child would write it again
  const pid_t id = ::fork();
  if (id == 0) {
    settle_in(order.out.c_str(), order.errors.c_str(), self);
    if (order.here) carry_out(order);
    ::execv(arguments[0], arguments.data());
    ::_exit(cannot_begin);
  }
  if (id > 0) ::setpgid(id, id);
  return id;
}

ProcessEnd end_of(int status, Clock::time_point begun) {
  ProcessEnd end;
  end.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  end.exit = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return end;
}

/// Removes the processes that have ended.
void collect(std::vector<Running>& running, const ProcessWatch* watch) {
  for (std::size_t i = 0; i < running.size();) {
    int status = 0;
    if (::waitpid(running[i].id, &status, WNOHANG) == 0) {
      ++i;
      continue;
    }
    const Running one = running[i];
    running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
    if (watch != nullptr) watch->ended(one.order, end_of(status, one.begun));
  }
}

void stop_all(std::vector<Running>& running) {
  for (const Running& r : running) ::kill(r.id, SIGINT);
  for (const auto until = Clock::now() + patience; !running.empty() && Clock::now() < until;) {
    std::this_thread::sleep_for(look_interval);
    collect(running, nullptr);
  }
  for (const Running& r : running) {
    ::kill(-r.id, SIGKILL);
    ::waitpid(r.id, nullptr, 0);
  }
  running.clear();
}

/// Ends all processes, whatever exception is thrown.
struct Crew {
  std::vector<Running> running;
  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  ~Crew() { stop_all(running); }
};

}  // namespace

std::string ProcessEnd::trouble() const {
  if (signal != 0) return fmt::format("ended by signal {} ({})", signal, ::strsignal(signal));
  if (exit == cannot_begin) return "the program could not be started";
  return exit == 0 ? "" : fmt::format("ended with code {}", exit);
}

int processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? std::max(1, CPU_COUNT(&set)) : 1;
}

namespace {

/// Removes and returns the first waiting order whose turn it is; orders before it that never run are removed too.
std::optional<std::size_t> next_of(std::vector<std::size_t>& waiting, const ProcessWatch& watch) {
  for (auto it = waiting.begin(); it != waiting.end();) {
    const OrderTurn turn = watch.turn ? watch.turn(*it) : OrderTurn::now;
    const std::size_t order = *it;
    if (turn == OrderTurn::later) {
      ++it;
      continue;
    }
    it = waiting.erase(it);
    if (turn == OrderTurn::now) return order;
  }
  return std::nullopt;
}

}  // namespace

bool run_processes(std::span<const ProcessOrder> orders, int at_once, const ProcessWatch& watch) {
  const auto most = static_cast<std::size_t>(std::max(1, at_once));
  Crew crew;
  std::vector<std::size_t> waiting(orders.size());
  std::iota(waiting.begin(), waiting.end(), std::size_t{0});
  for (bool changed = true; !waiting.empty() || !crew.running.empty();) {
    if (!watch.goes_on()) return false;
    while (changed && crew.running.size() < most) {
      const std::optional<std::size_t> next = next_of(waiting, watch);
      if (!next) break;
      watch.begun(*next);
      const pid_t id = begin(orders[*next]);
      if (id > 0)
        crew.running.push_back({*next, id, Clock::now()});
      else
        watch.ended(*next, {.exit = cannot_begin, .signal = 0, .seconds = 0});
    }
    if (crew.running.empty()) return true;
    const std::size_t before = crew.running.size();
    collect(crew.running, &watch);
    changed = crew.running.size() < before;
    if (!changed) std::this_thread::sleep_for(look_interval);
  }
  return true;
}

}  // namespace trilith
