#pragma once

#include "verify/spill_store.h"

#include <algorithm>
#include <functional>
#include <string>

namespace proskill::test {

/// A disk in memory, which may fail.
class SpillInMemory : public verify::SpillStore {
public:
  /// What may go wrong: returns the message of an error, or nothing.
  std::function<std::string(std::uint64_t operation)> problem = [](std::uint64_t) { return ""; };
  /// May change what is read.
  std::function<void(std::span<char>)> onRead = [](std::span<char>) {};
  std::uint64_t operations = 0; ///< so far: a file was created, written, read or cleared
  std::uint64_t written = 0;    ///< bytes
  std::size_t files = 0;        ///< that exist

  [[nodiscard]] std::expected<std::unique_ptr<verify::SpillFile>, std::string> create() override {
    if (auto error = problem(operations++); !error.empty()) return std::unexpected(error);
    return std::make_unique<File>(*this);
  }

private:
  class File : public verify::SpillFile {
  public:
    explicit File(SpillInMemory& of) : disk(of) { ++disk.files; }
    ~File() override { --disk.files; }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    [[nodiscard]] Done append(std::string_view bytes) override {
      if (auto error = disk.problem(disk.operations++); !error.empty())
        return std::unexpected(error);
      content += bytes;
      disk.written += bytes.size();
      return {};
    }
    [[nodiscard]] Done read(std::uint64_t at, std::span<char> to) override {
      if (auto error = disk.problem(disk.operations++); !error.empty())
        return std::unexpected(error);
      if (at + to.size() > content.size()) return std::unexpected("read beyond the end");
      std::copy_n(content.begin() + static_cast<std::ptrdiff_t>(at), to.size(), to.begin());
      disk.onRead(to);
      return {};
    }
    [[nodiscard]] Done clear() override {
      if (auto error = disk.problem(disk.operations++); !error.empty())
        return std::unexpected(error);
      content.clear();
      return {};
    }

  private:
    SpillInMemory& disk;
    std::string content;
  };
};

} // namespace proskill::test
