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

/// Paths of all that is needed.
struct Tools {
  std::filesystem::path frac;    ///< from Fiacre to a net with C
  std::filesystem::path builder; ///< sift or tina: from these to a state graph
  std::filesystem::path selt;    ///< checks formulas on it
  std::filesystem::path ktzio;   ///< writes it as text
  std::filesystem::path cc;      ///< a compiler of C
  std::filesystem::path fraclib; ///< the headers that frac's C includes
};

/// A variable of the environment; nothing where it is not set.
using Environment = std::function<std::optional<std::string>(const std::string&)>;

/// Looks for the tools: as chosen, else by `PROSKILL_FRAC` and so on (`FRACLIB`, `CC` without
/// `PROSKILL_`), else on the `PATH`; and for FRACLIB beside frac. sift is preferred to tina. The
/// error lists missing tools, each with how to get it.
[[nodiscard]] std::expected<Tools, std::vector<std::string>> findTools(const ToolChoice& choice,
                                                                       const Environment& of);

} // namespace proskill::tina
