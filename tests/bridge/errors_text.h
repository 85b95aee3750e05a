#pragma once

#include "bridge/text/imported.h"
#include "bridge/text/place.h"

#include <fmt/format.h>

#include <expected>
#include <string>

namespace proskill::test {

/// All errors of an import, one per line, or "none".
template <class Result>
std::string errorsText(const std::expected<Result, bridge::Errors>& imported) {
  if (imported) return "none";
  std::string text;
  for (const auto& [place, message] : imported.error())
    text += fmt::format("{}:{}:{}: {}\n", place.file.generic_string(), place.line, place.column,
                        message);
  return text;
}

} // namespace proskill::test
