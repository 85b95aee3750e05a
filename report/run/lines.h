#pragma once

#include "report/run/mcap.h"
#include "report/run/recorded_json.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace proskill::report {

/// The lines of a file one after the other.
class Lines {
public:
  explicit Lines(const mcap::File& of) : file(of) {}

  /// Where the next line begins.
  [[nodiscard]] std::uint64_t position() const { return place - (buffer.size() - used); }
  /// The next line, without its end; nullopt after the last one. Valid until the next call.
  std::optional<std::string_view> next() {
    auto end = buffer.find('\n', used);
    while (end == std::string::npos && readMore()) end = buffer.find('\n', searched);
    if (end == std::string::npos && used == buffer.size()) return std::nullopt;
    const auto line = std::string_view(buffer).substr(used, end - used);
    used = std::min(end, buffer.size() - 1) + 1;
    return line;
  }

private:
  /// Keeps what was not returned yet.
  bool readMore() {
    constexpr std::uint64_t kBlock = std::uint64_t{1} << 20;
    buffer.erase(0, std::exchange(used, 0));
    searched = buffer.size();
    if (searched > kLongest) throw WrongRecording{"it has a line of more than 256 MiB"};
    const auto more = file.read(place, kBlock);
    place += more.size();
    buffer += more;
    return !more.empty();
  }

  static constexpr std::size_t kLongest = std::size_t{256} << 20;

  const mcap::File& file;
  std::uint64_t place = 0; ///< of what is read next
  std::string buffer;
  std::size_t used = 0; ///< what was returned
  std::size_t searched = 0;
};

} // namespace proskill::report
