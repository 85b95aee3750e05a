#include "tina/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include <unistd.h>

namespace proskill::tina {

namespace fs = std::filesystem;

namespace {

constexpr auto kToolbox = "of the Tina toolbox, https://projects.laas.fr/tina/";

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

bool isProgram(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

class Finder {
public:
  explicit Finder(const Environment& of) : environment(of) {}

  /// \param what description for users who have to install it
  fs::path need(const std::string& name, const std::string& chosen, std::string_view what) {
    auto found = find(name, chosen);
    if (found.empty()) missing.push_back(complaint(name, wish(name, chosen), what));
    return found;
  }

  fs::path find(const std::string& name, const std::string& chosen) const {
    const auto wanted = wish(name, chosen);
    return search(wanted.empty() ? name : wanted);
  }

  fs::path needBuilder(const ToolChoice& choice) {
    const bool onlyTina = wish("sift", choice.sift).empty() && !wish("tina", choice.tina).empty();
    auto found = onlyTina ? find("tina", choice.tina) : find("sift", choice.sift);
    if (found.empty() && wish("sift", choice.sift).empty() && !onlyTina)
      found = find("tina", choice.tina);
    if (found.empty())
      missing.push_back(
          fmt::format("`sift` and `tina` are missing, one of which is needed: the explorers {}. "
                      "Name one with --sift or --tina, PROSKILL_SIFT or PROSKILL_TINA, or put it "
                      "on the PATH",
                      kToolbox));
    return found;
  }

  fs::path needLibrary(const std::string& chosen, const fs::path& frac) {
    std::error_code error;
    auto said = chosen.empty() ? environment("FRACLIB").value_or("") : chosen;
    if (!said.empty()) {
      if (fs::is_directory(said, error)) return fs::absolute(said);
      missing.push_back(fmt::format("FRACLIB is missing: `{}` is not a directory", said));
      return {};
    }
    const auto real = fs::weakly_canonical(frac, error).parent_path();
    for (const auto& place : {real / ".." / "lib", real / "lib", real})
      if (!frac.empty() && fs::is_directory(place / "avl", error)) return place;
    missing.emplace_back("FRACLIB is missing: the directory `lib` that comes with frac, with the "
                         "headers of the C that it writes. Name it with --fraclib, or set FRACLIB");
    return {};
  }

  std::vector<std::string> missing;

private:
  [[nodiscard]] std::string wish(const std::string& name, const std::string& chosen) const {
    if (!chosen.empty()) return chosen;
    return environment(name == "cc" ? "CC" : "PROSKILL_" + upper(name)).value_or("");
  }

  static std::string complaint(const std::string& name, const std::string& wanted,
                               std::string_view what) {
    if (!wanted.empty())
      return fmt::format("`{}` is missing: `{}` is not an executable program", name, wanted);
    const auto variable = name == "cc" ? "CC" : "PROSKILL_" + upper(name);
    return fmt::format("`{}` is missing: {}. Name it with --{} or {}, or put it on the PATH", name,
                       what, name, variable);
  }

  [[nodiscard]] fs::path search(const std::string& name) const {
    if (name.find('/') != std::string::npos) return isProgram(name) ? fs::absolute(name) : "";
    const auto path = environment("PATH").value_or("");
    for (std::size_t at = 0; at <= path.size();) {
      const auto end = std::min(path.find(':', at), path.size());
      const auto place = fs::path(path.substr(at, end - at)) / name;
      if (end > at && isProgram(place)) return fs::absolute(place);
      at = end + 1;
    }
    return {};
  }

  const Environment& environment;
};

} // namespace

std::expected<Tools, std::vector<std::string>> findTools(const ToolChoice& choice,
                                                         const Environment& of) {
  Finder finder(of);
  Tools tools;
  tools.frac =
      finder.need("frac", choice.frac, "the compiler of Fiacre, https://projects.laas.fr/fiacre/");
  tools.builder = finder.needBuilder(choice);
  tools.selt = finder.need("selt", choice.selt, fmt::format("the model checker {}", kToolbox));
  tools.ktzio = finder.need("ktzio", choice.ktzio, fmt::format("the converter {}", kToolbox));
  tools.cc = finder.need("cc", choice.cc, "a compiler of C, such as the package `gcc`");
  tools.fraclib = finder.needLibrary(choice.fraclib, tools.frac);
  if (!finder.missing.empty()) return std::unexpected(std::move(finder.missing));
  return tools;
}

} // namespace proskill::tina
