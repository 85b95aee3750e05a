#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <string>

namespace proskill::verify {

/// Reads what a CheckpointWriter has written. Nothing is assumed of the bytes: after an error all
/// numbers are 0 and all texts are empty.
class CheckpointReader {
public:
  /// The next piece of the bytes; empty at their end. The error is a message.
  using Next = std::function<std::expected<std::string, std::string>()>;

  explicit CheckpointReader(Next from) : next(std::move(from)) {}

  [[nodiscard]] std::uint8_t byte() {
    if (at == block.size() && !refill()) return 0;
    return static_cast<std::uint8_t>(block[at++]);
  }
  [[nodiscard]] std::uint64_t number();
  /// A number below a limit; another one is an error.
  [[nodiscard]] std::uint64_t numberBelow(std::uint64_t limit);
  [[nodiscard]] std::uint32_t indexBelow(std::uint64_t limit) {
    return static_cast<std::uint32_t>(numberBelow(limit));
  }
  [[nodiscard]] std::int64_t signedNumber();
  [[nodiscard]] bool flag() { return numberBelow(2) != 0; }
  /// A text of no more than so many bytes.
  [[nodiscard]] std::string text(std::size_t most);
  /// Reports an error unless everything has been read.
  void end();

  /// Notes that the content makes no sense.
  void fail();
  [[nodiscard]] bool hasFailed() const { return !problem.empty(); }
  /// The first error; empty if there is none.
  [[nodiscard]] const std::string& message() const { return problem; }

private:
  bool refill();

  Next next;
  std::string block;
  std::size_t at = 0;
  bool isAtEnd = false;
  std::string problem;
};

} // namespace proskill::verify
