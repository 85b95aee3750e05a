#pragma once

#include <chrono>
#include <expected>
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
  [[nodiscard]] pid_t id() const { return pid; }

private:
  Child(pid_t child, int end) : pid(child), socket(end) {}

  pid_t pid = -1; ///< nothing is left to wait for: -1
  int socket = -1;
};

/// For the child, at its start: it is killed when the thread that started it ends. False where the
/// parent has ended already.
[[nodiscard]] bool dieWithParent(pid_t parent);

} // namespace proskill::process
