// A server of pages for browsers on the same machine.
#pragma once

#include <functional>
#include <string>

namespace trilith::program {

/// The answer to a browser: a status such as 200, the type of the content, and the content.
struct Reply {
  int status = 200;
  std::string type = "text/plain; charset=utf-8", body;
};

/// Listens on 127.0.0.1 alone, so no other machine reaches it. It answers one GET at a time. A request whose Host is
/// another name than 127.0.0.1 or localhost is refused, so that no page of the internet reads the answers.
class LocalServer {
 public:
  /// `port` 0: a free one. Throws InputError if the port cannot be used.
  explicit LocalServer(int port);
  LocalServer(const LocalServer&) = delete;
  LocalServer& operator=(const LocalServer&) = delete;
  ~LocalServer();

  [[nodiscard]] int port() const { return port_; }
  /// Answers requests by path, such as "/", until the program is ended by a signal.
  [[noreturn]] void serve(const std::function<Reply(const std::string& path)>& answer) const;

 private:
  int listening_ = -1, port_ = 0;
};

/// The path of a request to this port, or the refusal of it: 400, 403 or 405. `request`: its lines up to the empty one.
Reply read_request(const std::string& request, int port);

}  // namespace trilith::program
