#include "bridge/bt/import.h"
#include "fuzz/targets.h"
#include "syntax/format/format.h"

#include <algorithm>

namespace proskill::fuzz {

namespace {

/// The text as every file whose name is not absolute.
class OneText : public analysis::FileSystem {
public:
  explicit OneText(std::string_view text) : text(text) {}
  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& /*path*/) const override {
    return std::string(text);
  }
  [[nodiscard]] std::filesystem::path canonical(const std::filesystem::path& path) const override {
    return path.lexically_normal();
  }

private:
  std::string_view text;
};

void errorsHavePlaces(const bridge::bt::Errors& errors) {
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

} // namespace

void bt(std::string_view bytes) {
  const auto imported = bridge::bt::importTree(OneText(bytes), "tree.xml", bridge::bt::Leaves());
  if (!imported) return errorsHavePlaces(imported.error());
  isProgram(imported->text);
}

} // namespace proskill::fuzz
