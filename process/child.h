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
  /// Starts a program, without a shell; its first word is a path. What went wrong is in words.
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

  /// What has come and gone within a moment.
  struct Exchange {
    std::string received;
    std::size_t sent = 0;
    bool ended = false; ///< nothing comes any more
  };
  /// Sends of the bytes what the child takes and receives what it has to say, waiting for either.
  [[nodiscard]] Exchange exchange(std::string_view toSend, std::chrono::milliseconds patience);

  /// How it ended: "it was ended by signal 9 (Killed)". Kills it where it does not end by itself
  /// within a second after its output has ended.
  [[nodiscard]] std::string ending();
  /// The same, where it has ended already; else nothing, without waiting.
  [[nodiscard]] std::optional<std::string> endingIfOver();
  /// What is sent is over: the child reads the end of its input.
  void endInput();
  /// Sends a signal to the child, or to its whole group.
  void signal(int number) const;
  [[nodiscard]] pid_t id() const { return pid; }
  /// The socket: it can be read when the child has said something, or nothing comes any more.
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
