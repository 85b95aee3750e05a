#pragma once

#include "analysis/program/program.h"
#include "bridge/text/place.h"

#include <string_view>

namespace proskill::fuzz {

/// The text as every file whose name is not absolute.
class OneText : public analysis::FileSystem {
public:
  explicit OneText(std::string_view text) : text(text) {}
  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override;
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override;

private:
  std::string_view text;
};

/// What an importer must satisfy.
void errorsHavePlaces(const bridge::Errors& errors);
void isProgram(const std::string& text);

} // namespace proskill::fuzz
