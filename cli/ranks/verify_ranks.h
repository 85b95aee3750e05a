#pragma once

#include "verify/ranks.h"

#include <expected>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace proskill::cli {

/// The processes of `verify --mpi`, of which rank 0 alone prints.
class VerifyRanks {
public:
  /// Loads what connects them. The error is a message.
  [[nodiscard]] static std::expected<std::unique_ptr<VerifyRanks>, std::string> open();
  /// Waits for the other ranks.
  ~VerifyRanks();
  VerifyRanks(const VerifyRanks&) = delete;
  VerifyRanks& operator=(const VerifyRanks&) = delete;

  [[nodiscard]] verify::Ranks& connected() { return *ranks; }
  [[nodiscard]] bool isAssistant() const { return ranks->self() != 0; }
  /// Makes sure that all ranks verify the same. Call this once, when the program has been read; a
  /// rank that cannot read it does not call it. \return an error message, on all ranks if there is
  /// one
  [[nodiscard]] std::optional<std::string> disagreement(const std::string& key);

private:
  explicit VerifyRanks(std::unique_ptr<verify::Ranks> of);
  std::optional<std::string> compare(const std::string& key);

  std::unique_ptr<verify::Ranks> ranks;
  std::ostringstream said;          ///< what an assistant prints until the ranks agree
  std::streambuf* errors = nullptr; ///< where it prints otherwise
  bool isCompared = false;
};

} // namespace proskill::cli
