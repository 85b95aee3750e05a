#pragma once

#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::tina {

/// A new directory in which the tools run. The destructor removes it, unless it must be kept.
class Workspace {
public:
  /// \param keep a directory that does not exist yet or is empty; nullopt: a temporary one. The
  /// error is a message.
  [[nodiscard]] static std::expected<Workspace, std::string>
  make(const std::optional<std::filesystem::path>& keep);

  Workspace(Workspace&& other) noexcept;
  Workspace& operator=(Workspace&&) = delete;
  ~Workspace();

  [[nodiscard]] const std::filesystem::path& path() const { return root; }
  /// Returns an error message, or nothing.
  [[nodiscard]] std::optional<std::string> write(const std::string& name,
                                                 std::string_view text) const;
  /// Nothing if it cannot be read.
  [[nodiscard]] std::optional<std::string> read(const std::string& name) const;

private:
  Workspace(std::filesystem::path at, bool toKeep) : root(std::move(at)), kept(toKeep) {}

  std::filesystem::path root;
  bool kept = false;
};

} // namespace proskill::tina
