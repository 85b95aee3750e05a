#include "tina/workspace.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace proskill::tina {

namespace fs = std::filesystem;

std::expected<Workspace, std::string> Workspace::make(const std::optional<fs::path>& keep) {
  std::error_code error;
  if (!keep) {
    std::string name = (fs::temp_directory_path(error) / "proskill-tina-XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr)
      return std::unexpected(
          fmt::format("a temporary directory cannot be made: {}", std::strerror(errno)));
    return Workspace(name, false);
  }
  fs::create_directories(*keep, error);
  if (error)
    return std::unexpected(
        fmt::format("cannot create the directory {}: {}", keep->string(), error.message()));
  if (!fs::is_empty(*keep, error) || error)
    return std::unexpected(
        fmt::format("{} is not empty; the tools run in a fresh directory", keep->string()));
  return Workspace(fs::absolute(*keep), true);
}

Workspace::Workspace(Workspace&& other) noexcept
    : root(std::exchange(other.root, {})), kept(other.kept) {}

Workspace::~Workspace() {
  std::error_code ignored;
  if (!root.empty() && !kept) fs::remove_all(root, ignored);
}

std::optional<std::string> Workspace::write(const std::string& name, std::string_view text) const {
  std::ofstream out(root / name, std::ios::binary);
  out << text;
  out.close();
  if (out) return std::nullopt;
  return fmt::format("{} cannot be written: {}", (root / name).string(), std::strerror(errno));
}

std::optional<std::string> Workspace::read(const std::string& name) const {
  std::ifstream in(root / name, std::ios::binary);
  if (!in) return std::nullopt;
  std::string text{std::istreambuf_iterator<char>(in), {}};
  return in.bad() ? std::nullopt : std::optional(std::move(text));
}

} // namespace proskill::tina
