#include "program/local_server.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>

#include "base/error.hpp"

namespace trilith::program {
namespace {

constexpr std::size_t longest_request = 16384;                  // [bytes]
constexpr std::chrono::milliseconds longest_request_time{300};  // browsers open connections without a request

/// Closes a connection at its end.
class Connection {
 public:
  explicit Connection(int descriptor) : descriptor_(descriptor) {}
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() { ::close(descriptor_); }

  /// The lines up to the empty one; "" if they do not arrive in time.
  [[nodiscard]] std::string request() const {
    const auto end = std::chrono::steady_clock::now() + longest_request_time;
    std::string text;
    std::array<char, 2048> block;
    while (text.find("\r\n\r\n") == std::string::npos && text.size() < longest_request) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      pollfd wanted{descriptor_, POLLIN, 0};
      if (left.count() <= 0 || ::poll(&wanted, 1, static_cast<int>(left.count())) <= 0) return "";
      const ssize_t got = ::recv(descriptor_, block.data(), block.size(), 0);
      if (got <= 0) return "";
      text.append(block.data(), static_cast<std::size_t>(got));
    }
    return text;
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
};

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

LocalServer::LocalServer(int port) : listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
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
  while (true) {
    const int descriptor = ::accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
    if (descriptor < 0) continue;
    const Connection connection(descriptor);
    const std::string request = connection.request();
    if (request.empty()) continue;
    Reply reply = read_request(request, port_);
    if (reply.status == 200) reply = answer(reply.body);
    connection.send(header_of(reply));
    connection.send(reply.body);
  }
}

}  // namespace trilith::program
