#include "runtime/stubs/stub_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::runtime {

namespace {

constexpr std::string_view kMark = "Written by `proskill stubs`, which writes it anew: ";

/// FNV-1a, 64 bits.
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return hash;
}

} // namespace

std::vector<std::string> parameterNames(const StubAction& action, StubNames around) {
  std::vector<std::string> all;
  for (const auto& parameter : action.parameters)
    all.push_back(around.unique(parameter.name.empty() ? fmt::format("argument{}", all.size() + 1)
                                                       : functionName(parameter.name)));
  return all;
}

std::string actionLine(const StubAction& action) {
  auto line = action.action.substr(0, action.action.find('\n'));
  // A backslash at its end would join the next line to the comment.
  while (!line.empty() && line.back() == '\\') line.pop_back();
  return line;
}

std::string textFor(const StubProgram& program, const StubType& type, const ArgumentTexts& texts,
                    const std::function<std::string(std::size_t)>& ofVariable) {
  switch (type.kind) {
  case StubType::Kind::Integer:
  case StubType::Kind::Natural: return texts.integer;
  case StubType::Kind::Float: return texts.number;
  case StubType::Kind::Boolean: return texts.boolean;
  case StubType::Kind::String: return texts.string;
  case StubType::Kind::Value: {
    const auto found =
        std::ranges::find(program.variables, type.variable, &StubProgram::Variable::name);
    return ofVariable(static_cast<std::size_t>(found - program.variables.begin()));
  }
  }
  std::unreachable();
}

std::string withStubMark(std::string_view comment, std::string_view text) {
  return fmt::format("{} {}{:016x}\n{}", comment, kMark, hashOf(text), text);
}

bool isUnchangedStub(std::string_view text) {
  const auto mark = text.find(kMark);
  const auto end = text.find('\n');
  if (mark == std::string_view::npos || end == std::string_view::npos || mark > end) return false;
  const auto written = text.substr(mark + kMark.size(), end - mark - kMark.size());
  return written == fmt::format("{:016x}", hashOf(text.substr(end + 1)));
}

} // namespace proskill::runtime
