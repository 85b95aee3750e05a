#include "bridge/bt/simplify/decided.h"

#include "analysis/flow/inspect.h"
#include "analysis/program/program.h"

#include <algorithm>
#include <map>

namespace proskill::bridge::bt {
namespace {

const char* valueOf(syntax::Code code) {
  if (code == syntax::Code::TestAlwaysHolds) return "true";
  if (code == syntax::Code::TestNeverHolds || code == syntax::Code::WaitNeverEnds) return "false";
  return nullptr;
}

/// Where the lists of a text begin, in order.
std::vector<std::size_t> listsIn(std::string_view text) {
  std::vector<std::size_t> begins;
  char within = '\0'; // what ends the string or the comment
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (within != '\0') {
      if (within == '"' && c == '\\')
        ++i;
      else if (c == within)
        within = '\0';
    } else if (c == '"' || c == ';') {
      within = c == ';' ? '\n' : '"';
    } else if (c == '(') {
      begins.push_back(i);
    }
  }
  return begins;
}

/// Values of conditions, by the number of their list in the program.
using Decided = std::map<std::size_t, const char*>;

Decided decidedIn(const std::string& text) {
  const auto program =
      analysis::load(analysis::NoFiles(), "program", syntax::Document::parse(text));
  const auto analysis = analysis::analyse(program);
  Decided decided;
  if (!analysis::flow::hasFlow(program, analysis)) return decided;
  const auto begins = listsIn(text);
  const analysis::flow::Flow flow(program);
  for (const auto& found : analysis::flow::checkFlow(flow, analysis.index, false))
    if (const auto* value = valueOf(found.code)) {
      const auto begin = found.location.range.begin;
      const auto list = std::ranges::lower_bound(begins, begin);
      if (list == begins.end() || *list != begin) continue; // a word is decided already
      decided[static_cast<std::size_t>(list - begins.begin())] = value;
    }
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
