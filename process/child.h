#pragma once

#include <chrono>
#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace proskill::process {

/// A child process whose standard input and output are connected to a socket. It never outlives its
/// object: the destructor kills it and waits for its end. A child that calls `dieWithParent` does
/// not outlive the thread that started it either.
class Child {
public:
  /// Starts a program without a shell; the first word is a path. The error is a message.
  [[nodiscard]] static std::expected<Child, std::string>
  start(const std::vector<std::string>& command);
  /// The same in a directory; a first word without a slash is searched on the PATH. The program
  /// leads a process group of its own, so Ctrl-C on the terminal does not reach it, and the whole
  /// group is killed with it.
  [[nodiscard]] static std::expected<Child, std::string>
  startGroup(const std::vector<std::string>& command, const std::filesystem::path& directory);

  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();

  /// Result of one exchange with the child.
  struct Exchange {
    std::string received;
    std::size_t sent = 0;
    bool ended = false; ///< there is no more output
  };
  /// Sends as many bytes as the child accepts and receives its output. Blocks until one of these is
  /// possible.
  [[nodiscard]] Exchange exchange(std::string_view toSend, std::chrono::milliseconds patience);

  /// How it ended: "it was ended by signal 9 (Killed)". Kills it if it does not end within a second
  /// after its output has ended.
  [[nodiscard]] std::string ending();
  /// The same if it has ended already; otherwise nothing. Does not wait.
  [[nodiscard]] std::optional<std::string> endingIfOver();
  /// Closes the input of the child.
  void endInput();
  /// Sends a signal to the child, or to its whole group.
  void signal(int number) const;
  [[nodiscard]] pid_t id() const { return pid; }
  /// The socket: readable when there is output of the child, or its output has ended.
  [[nodiscard]] int descriptor() const { return socket; }
  /// Readable when the child has ended.
  [[nodiscard]] int endDescriptor() const { return ended; }

private:
  void signalGroup(int number) const;
  Child(pid_t child, int end, int whenOver, bool leads)
      : pid(child), socket(end), ended(whenOver), isGroup(leads) {}

  pid_t pid = -1; ///< -1: nothing to wait for
  int socket = -1;
  int ended = -1;
  bool isGroup = false;
};

/// For the child, at its start: it is killed when the thread that started it ends. Returns false if
/// the parent has ended already.
[[nodiscard]] bool dieWithParent(pid_t parent);

} // namespace proskill::process
