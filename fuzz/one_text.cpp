#include "fuzz/one_text.h"

#include "fuzz/targets.h"
#include "syntax/format/format.h"

namespace proskill::fuzz {

std::expected<std::string, std::string> OneText::read(const std::filesystem::path& /*path*/) const {
  return std::string(text);
}

std::filesystem::path OneText::canonical(const std::filesystem::path& path) const {
  return path.lexically_normal();
}

void errorsHavePlaces(const bridge::Errors& errors) {
  expect(!errors.empty(), "what is not imported has an error");
  for (const auto& [place, message] : errors)
    expect(place.line > 0 && place.column > 0 && !message.empty(), "an error has a place");
}

void isProgram(const std::string& text) {
  const auto document = syntax::Document::parse(text);
  expect(syntax::format(document).empty(), "an imported program is formatted");
  const auto program = analysis::load(OneText(text), "program.proskill");
  for (const auto& finding : analysis::check(program))
    expect(finding.severity != syntax::Severity::Error, "an imported program has no errors");
}

} // namespace proskill::fuzz
