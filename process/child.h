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

/// A program that runs beside this one, with its standard input and output at the other end of a
/// socket. It never outlives its object: the destructor kills it and waits for its end. Nor does a
/// child that asks for it (`dieWithParent`) outlive the thread that started it.
class Child {
public:
  /// Starts a program, without a shell; its first word is a path. The error is a sentence.
  [[nodiscard]] static std::expected<Child, std::string>
  start(const std::vector<std::string>& command);
  /// The same in a directory, with a first word that is looked for on the PATH where it has no
  /// slash. The program leads a process group of its own, which a Ctrl-C on the terminal does not
  /// reach, and which is killed as a whole.
  [[nodiscard]] static std::expected<Child, std::string>
  startGroup(const std::vector<std::string>& command, const std::filesystem::path& directory);

  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();

  /// Result of one exchange with the child.
  struct Exchange {
    std::string received;
    std::size_t sent = 0;
    bool ended = false; ///< no more output
  };
  /// Sends as many bytes as the child accepts and receives its output; blocks until one is
  /// possible.
  [[nodiscard]] Exchange exchange(std::string_view toSend, std::chrono::milliseconds patience);

  /// How it ended: "it was ended by signal 9 (Killed)". Kills it where it does not end by itself
  /// within a second after its output has ended.
  [[nodiscard]] std::string ending();
  /// The same, where it has ended already; else nothing, without waiting.
  [[nodiscard]] std::optional<std::string> endingIfOver();
  /// Closes the input of the child.
  void endInput();
  /// Sends a signal to the child, or to its whole group.
  void signal(int number) const;
  [[nodiscard]] pid_t id() const { return pid; }
  /// The socket: readable after output of the child, and after the end of its output.
  [[nodiscard]] int descriptor() const { return socket; }
  /// Can be read when the child has ended.
  [[nodiscard]] int endDescriptor() const { return ended; }

private:
  void signalGroup(int number) const;
  Child(pid_t child, int end, int whenOver, bool leads)
      : pid(child), socket(end), ended(whenOver), isGroup(leads) {}

  pid_t pid = -1; ///< nothing is left to wait for: -1
  int socket = -1;
  int ended = -1;
  bool isGroup = false;
};

/// For the child, at its start: it is killed when the thread that started it ends. False where the
/// parent has ended already.
[[nodiscard]] bool dieWithParent(pid_t parent);

} // namespace proskill::process
