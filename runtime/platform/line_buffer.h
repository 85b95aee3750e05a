#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace proskill::runtime {

/// Splits a stream of bytes into lines. A line that is too long is dropped, and reported once.
class LineBuffer {
public:
  enum class Next : std::uint8_t { Nothing, Line, TooLong };

  explicit LineBuffer(std::size_t longestLine) : longest(longestLine) {}

  void add(std::string_view bytes) {
    held.erase(0, begin);
    begin = 0;
    held += bytes;
  }

  /// \param line without its end; valid until more bytes are added
  Next next(std::string_view& line) {
    const auto end = held.find('\n', begin + searched);
    if (end == std::string::npos) return unfinished();
    line = std::string_view(held).substr(begin, end - begin);
    begin = end + 1;
    searched = 0;
    if (isSkipping) {
      isSkipping = false;
      return next(line);
    }
    return line.size() > longest ? Next::TooLong : Next::Line;
  }

  void clear() {
    held.clear();
    begin = searched = 0;
    isSkipping = false;
  }

private:
  Next unfinished() {
    searched = held.size() - begin;
    if (searched <= longest) return Next::Nothing;
    const bool isNew = !isSkipping;
    clear();
    isSkipping = true; // the rest of the line is still to come
    return isNew ? Next::TooLong : Next::Nothing;
  }

  std::size_t longest;
  std::string held;
  std::size_t begin = 0;    ///< of the next line
  std::size_t searched = 0; ///< number of its bytes that were searched for a line end
  bool isSkipping = false;
};

} // namespace proskill::runtime
