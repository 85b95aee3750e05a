#include "bridge/bt/simplify/decided.h"

#include "analysis/flow/inspect.h"
#include "analysis/program/program.h"

#include <map>

namespace proskill::bridge::bt {
namespace {

class OneText : public analysis::FileSystem {
public:
  explicit OneText(std::string text) : text(std::move(text)) {}

  std::expected<std::string, std::string> read(const std::filesystem::path&) const override {
    return text;
  }
  std::filesystem::path canonical(const std::filesystem::path& path) const override { return path; }

private:
  std::string text;
};

const char* valueOf(syntax::Code code) {
  if (code == syntax::Code::TestAlwaysHolds) return "true";
  if (code == syntax::Code::TestNeverHolds || code == syntax::Code::WaitNeverEnds) return "false";
  return nullptr;
}

/// How many lists begin before a place of a text.
std::size_t listsBefore(std::string_view text, std::size_t offset) {
  std::size_t count = 0;
  char within = '\0'; // what ends the string or the comment
  for (std::size_t i = 0; i < offset; ++i) {
    const char c = text[i];
    if (within != '\0') {
      if (within == '"' && c == '\\')
        ++i;
      else if (c == within)
        within = '\0';
    } else if (c == '"' || c == ';') {
      within = c == ';' ? '\n' : '"';
    } else if (c == '(') {
      ++count;
    }
  }
  return count;
}

/// Values of conditions, by the number of their list in the program.
using Decided = std::map<std::size_t, const char*>;

Decided decidedIn(const std::string& text) {
  const auto program = analysis::load(OneText(text), "program");
  const auto analysis = analysis::analyse(program);
  Decided decided;
  if (!analysis::flow::hasFlow(program, analysis)) return decided;
  const analysis::flow::Flow flow(program);
  for (const auto& found : analysis::flow::checkFlow(flow, analysis.index, false))
    if (const auto* value = valueOf(found.code))
      decided[listsBefore(text, found.location.range.begin)] = value;
  return decided;
}

/// \param number of the list, or of the next one
void replaceIn(Form& form, const Decided& decided, std::size_t& number) {
  if (!form.word.empty()) return;
  const auto found = decided.find(number++);
  for (auto& part : form.parts) replaceIn(part, decided, number);
  if (found != decided.end()) form = Form(found->second);
}

} // namespace

bool decideTests(Block& program) {
  const auto decided = decidedIn(write({}, program));
  std::size_t number = 0;
  for (auto& definition : program) replaceIn(definition, decided, number);
  return !decided.empty();
}

} // namespace proskill::bridge::bt
