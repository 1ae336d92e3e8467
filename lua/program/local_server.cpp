#include "program/local_server.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace trilith::program {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_request = 16384;       // [bytes]
constexpr std::size_t most_connections = 64;         // waiting for a request; the oldest one is closed for a new one
constexpr std::chrono::seconds longest_silence{60};  // browsers open connections long before their request, if any
constexpr timeval longest_sending{.tv_sec = 30, .tv_usec = 0};  // without progress, to a browser that reads nothing

/// A connection and the part of its request that has arrived. Closes it at its end.
class Connection {
 public:
  explicit Connection(int descriptor) : descriptor_(descriptor) {
    ::setsockopt(descriptor_, SOL_SOCKET, SO_SNDTIMEO, &longest_sending, sizeof longest_sending);
  }
  Connection(Connection&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)), since_(other.since_), request_(std::move(other.request_)) {}
  Connection& operator=(Connection&& other) noexcept {
    std::swap(descriptor_, other.descriptor_), std::swap(since_, other.since_), std::swap(request_, other.request_);
    return *this;
  }
  ~Connection() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] const std::string& request() const { return request_; }
  [[nodiscard]] bool is_complete() const { return request_.find("\r\n\r\n") != std::string::npos; }
  [[nodiscard]] bool is_too_late() const { return Clock::now() - since_ > longest_silence; }
  /// Takes the part that has arrived. False at the end of the connection, or if the request is too long.
  bool receive() {
    std::array<char, 2048> block;
    const ssize_t got = ::recv(descriptor_, block.data(), block.size(), MSG_DONTWAIT);
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    request_.append(block.data(), static_cast<std::size_t>(got));
    return got > 0 && request_.size() < longest_request;
  }
  /// A browser that has gone is not an error.
  void send(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t sent = ::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) return;
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
  }

 private:
  int descriptor_;
  Clock::time_point since_ = Clock::now();
  std::string request_;
};

/// Waits until something arrives, or for a second. The first row is the listening socket, the others the connections.
std::vector<pollfd> wait_for_input(int listening, const std::vector<Connection>& open) {
  std::vector<pollfd> rows{{listening, POLLIN, 0}};
  for (const Connection& c : open) rows.push_back({c.descriptor(), POLLIN, 0});
  ::poll(rows.data(), rows.size(), 1000);
  return rows;
}

std::string_view words_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    default:
      return "Bad Request";
  }
}

std::string header_of(const Reply& reply) {
  return fmt::format(
      "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nCache-Control: no-store\r\n"
      "X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n",
      reply.status, words_of(reply.status), reply.type, reply.body.size());
}

/// The value of a line such as "Host: localhost:8000" of a request; names of lines have no case.
std::string line_value(const std::string& request, std::string_view name) {
  std::size_t at = request.find("\r\n");
  while (at != std::string::npos && at + 2 < request.size()) {
    const std::size_t begin = at + 2, end = std::min(request.find("\r\n", begin), request.size());
    const std::string line = request.substr(begin, end - begin);
    const bool same =
        line.size() > name.size() && line[name.size()] == ':' &&
        std::equal(name.begin(), name.end(), line.begin(), [](char a, char b) {
          return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
        });
    if (same) {
      const std::size_t first = line.find_first_not_of(' ', name.size() + 1);
      return first == std::string::npos ? "" : line.substr(first);
    }
    at = end < request.size() ? end : std::string::npos;
  }
  return "";
}

}  // namespace

Reply read_request(const std::string& request, int port) {
  const std::size_t space = request.find(' '), next = request.find(' ', space + 1);
  const std::size_t line = request.find("\r\n");
  if (space == std::string::npos || next == std::string::npos || line == std::string::npos || next > line)
    return {400, "text/plain; charset=utf-8", "this is not a request of a browser\n"};
  const std::string host = line_value(request, "host");
  if (host != fmt::format("127.0.0.1:{}", port) && host != fmt::format("localhost:{}", port))
    return {403, "text/plain; charset=utf-8", "only pages of this machine are answered\n"};
  if (request.substr(0, space) != "GET") return {405, "text/plain; charset=utf-8", "only GET is answered\n"};
  std::string path = request.substr(space + 1, next - space - 1);
  return {200, "", path.substr(0, path.find('?'))};
}

LocalServer::LocalServer(int port) : listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int yes = 1;
  ::setsockopt(listening_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  socklen_t size = sizeof address;
  auto* const plain = reinterpret_cast<sockaddr*>(&address);
  if (listening_ < 0 || ::bind(listening_, plain, size) != 0 || ::listen(listening_, 16) != 0 ||
      ::getsockname(listening_, plain, &size) != 0) {
    const std::string why = std::strerror(errno);
    ::close(listening_);
    throw InputError(fmt::format("port {} cannot be used: {}; leave --port out for a free one", port, why));
  }
  port_ = ntohs(address.sin_port);
}

LocalServer::~LocalServer() {
  ::close(listening_);
}

void LocalServer::serve(const std::function<Reply(const std::string& path)>& answer) const {
  std::vector<Connection> open;
  while (true) {
    const std::vector<pollfd> rows = wait_for_input(listening_, open);
    std::vector<Connection> waiting;
    for (std::size_t i = 0; i < open.size(); ++i) {
      Connection& c = open[i];
      if (rows[i + 1].revents != 0 ? !c.receive() : c.is_too_late()) continue;
      if (!c.is_complete()) {
        waiting.push_back(std::move(c));
        continue;
      }
      Reply reply = read_request(c.request(), port_);
      if (reply.status == 200) reply = answer(reply.body);
      c.send(header_of(reply));
      c.send(reply.body);
    }
    open = std::move(waiting);
    if (rows[0].revents == 0) continue;
    const int descriptor = ::accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
    if (descriptor < 0) continue;
    if (open.size() == most_connections) open.erase(open.begin());
    open.emplace_back(descriptor);
  }
}

}  // namespace trilith::program
