#include "analysis/flow/inspect.h"
#include "codegen/model.h"
#include "tests/where.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

using namespace proskill;

namespace {

namespace fs = std::filesystem;

const fs::path kExamples = fs::path(PROSKILL_SOURCE_DIR) / "examples";

std::string textOf(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Disk : public analysis::FileSystem {
public:
  std::expected<std::string, std::string> read(const fs::path& path) const override {
    return textOf(path);
  }
  fs::path canonical(const fs::path& path) const override { return fs::weakly_canonical(path); }
};

/// The programs of the examples: files that no other file includes.
std::set<fs::path> roots() {
  std::set<fs::path> files;
  std::set<fs::path> included;
  for (const auto& entry : fs::recursive_directory_iterator(kExamples)) {
    if (entry.path().extension() != ".proskill") continue;
    files.insert(fs::weakly_canonical(entry.path()));
    auto program = analysis::load(Disk(), entry.path());
    for (std::size_t i = 1; i < program.files.size(); ++i)
      included.insert(fs::weakly_canonical(program.files[i].path));
  }
  for (const fs::path& path : included) files.erase(path);
  return files;
}

std::vector<syntax::Diagnostic> warnings(const analysis::Program& program) {
  auto found = analysis::flow::inspect(program);
  std::erase_if(found, [](const auto& each) { return each.severity == syntax::Severity::Hint; });
  return found;
}

std::string rowOf(const fs::path& root, const analysis::Program& program,
                  const syntax::Diagnostic& each) {
  const analysis::File& file = program.files[each.location.file];
  auto line = file.document.lines().position(each.location.range.begin).line + 1;
  return fmt::format("| {} | {} | {}:{} | violated |", root.lexically_relative(kExamples).string(),
                     syntax::info(each.code).id, file.path.filename().string(), line);
}

/// "energy" for "(energy (- energy 2))", if the finding is about an effect.
std::string variableAt(const analysis::Program& program, const syntax::Diagnostic& each) {
  const std::string& text = program.files[each.location.file].document.text();
  std::size_t begin = each.location.range.begin + 1;
  return text.substr(begin, text.find(' ', begin) - begin);
}

/// Whether the engine finds a forbidden move of the variable.
bool isConfirmed(const analysis::Program& program, const std::string& variable) {
  auto model = codegen::generate(program);
  REQUIRE(model);
  std::vector<verify::Question> questions;
  for (const auto& check : model->checks)
    if (check.kind == "no_forbidden_transition" && check.subject == variable)
      questions.push_back({check.property});
  REQUIRE(questions.size() == 1);
  auto result = verify::verify(model->fiacre, model->provenance, questions, {});
  REQUIRE(result);
  return result->answers[0].truth == verify::Truth::False;
}

} // namespace

TEST_CASE(
    "The warnings about the examples are those that the manual lists, and the engine agrees") {
  std::set<std::string> listed;
  std::istringstream manual(textOf(fs::path(PROSKILL_SOURCE_DIR) / "docs/checking.md"));
  for (std::string line; std::getline(manual, line);)
    if (line.find(" | violated | ") != std::string::npos)
      listed.insert(line.substr(0, line.find(" | violated |") + 13));
  std::set<std::string> found;
  REQUIRE(roots().size() >= 7);
  for (const fs::path& root : roots()) {
    auto program = analysis::load(Disk(), root);
    for (const auto& each : warnings(program)) {
      std::string row = rowOf(root, program, each);
      INFO(row << each.message);
      found.insert(row);
      std::string_view id = syntax::info(each.code).id;
      REQUIRE(id.starts_with("PS050")); // for another kind, add the question to the engine here
      CHECK(isConfirmed(program, variableAt(program, each)));
    }
  }
  CHECK(found == listed);
}
