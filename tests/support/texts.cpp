#include "tests/support/texts.h"

#include <algorithm>

namespace proskill::test {

namespace {

class NoFiles : public analysis::FileSystem {
public:
  std::expected<std::string, std::string> read(const std::filesystem::path&) const override {
    return std::unexpected("there are no files in this test");
  }
  std::filesystem::path canonical(const std::filesystem::path& path) const override { return path; }
};

} // namespace

analysis::Program programOfText(std::string text) {
  return analysis::load(NoFiles(), "test.proskill", syntax::Document::parse(std::move(text)));
}

bool isWellFormed(const analysis::Program& program) {
  return std::ranges::none_of(analysis::check(program), [](const auto& diagnostic) {
    return diagnostic.severity == syntax::Severity::Error;
  });
}

} // namespace proskill::test
