#pragma once

#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace proskill::tina {

/// Names or paths of the tools chosen by the user; empty if not chosen.
struct ToolChoice {
  std::string frac;
  std::string sift;
  std::string tina;
  std::string selt;
  std::string ktzio;
  std::string cc;
  std::string fraclib;
};

/// Paths of all required programs.
struct Tools {
  std::filesystem::path frac;    ///< from Fiacre to a net and C code
  std::filesystem::path builder; ///< sift or tina: from these to a state graph
  std::filesystem::path selt;    ///< checks formulas on the graph
  std::filesystem::path ktzio;   ///< prints the graph as text
  std::filesystem::path cc;      ///< a C compiler
  std::filesystem::path fraclib; ///< the headers for frac's C code
};

/// An environment variable; nothing if it is not set.
using Environment = std::function<std::optional<std::string>(const std::string&)>;

/// Finds the tools: the chosen ones, otherwise by `PROSKILL_FRAC` and so on (`FRACLIB` and `CC`
/// without `PROSKILL_`), otherwise on the `PATH`; FRACLIB also next to frac. Prefers sift to tina.
/// The error lists the missing tools, each with how to get it.
[[nodiscard]] std::expected<Tools, std::vector<std::string>> findTools(const ToolChoice& choice,
                                                                       const Environment& of);

} // namespace proskill::tina
