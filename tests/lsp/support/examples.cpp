#include "tests/lsp/support/examples.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "tests/where.h"

namespace proskill::test {

namespace {

const std::filesystem::path kExamples = PROSKILL_SOURCE_DIR "/examples";

bool isInWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' || c == ':';
}
bool isWithinCharacter(char c) { return (c & 0xc0) == 0x80; }

} // namespace

std::string contents(const std::filesystem::path& path) {
  std::ostringstream result;
  result << std::ifstream(path).rdbuf();
  return result.str();
}

std::vector<std::string> examples() {
  std::vector<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(kExamples))
    if (entry.is_directory() && !example(entry.path().filename().string()).empty())
      result.push_back(entry.path().filename().string());
  std::ranges::sort(result);
  return result;
}

Files example(const std::string& name) {
  Files result;
  for (const auto& entry : std::filesystem::directory_iterator(kExamples / name))
    if (const auto end = entry.path().extension(); end == ".proskill" || end == ".gen")
      result[entry.path().filename().string()] = contents(entry.path());
  return result;
}

std::vector<syntax::Offset> placesIn(const std::string& text, bool all) {
  std::vector<syntax::Offset> result{0};
  for (syntax::Offset i = 1; i < text.size(); ++i) {
    if (isWithinCharacter(text[i])) continue;
    bool edge = isInWord(text[i - 1]) != isInWord(text[i]) || text[i - 1] == '(';
    if (all || edge) result.push_back(i);
  }
  if (!text.empty()) result.push_back(static_cast<syntax::Offset>(text.size()));
  return result;
}

} // namespace proskill::test
