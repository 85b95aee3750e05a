#pragma once

#include "analysis/program/program.h"
#include "codegen/model.h"
#include "fiacre/check/check.h"
#include "fiacre/syntax/parse.h"
#include "ide/snapshot/fiacre_file.h"
#include "syntax/diagnostics/codes.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::ide {

using fiacre::NameKind;
using syntax::Code;
using syntax::Diagnostic;
using syntax::Range;

/// A text that is added to a program: read, its origins among those of the model.
class Addition {
public:
  Addition(codegen::Model& to, analysis::Program& in, const std::filesystem::path& path,
           std::string source, const fiacre::PathSteps& steps)
      : model(to), program(in), file(static_cast<syntax::FileId>(in.files.size())) {
    program.files.push_back({path, syntax::Document::parse(std::move(source))});
    parsed = fiacre::parse(text(), steps);
    for (const auto& problem : parsed.problems)
      diagnostics.push_back(syntax::makeDiagnostic(
          Code::FiacreText, {file, {problem.begin, problem.end}}, problem.message));
    firstOrigin = static_cast<fiacre::OriginId>(model.provenance.origins.size());
    for (std::size_t i = 1; i < parsed.provenance.origins.size(); ++i) {
      model.provenance.origins.push_back(parsed.provenance.origins[i]);
      model.provenance.origins.back().file = file;
    }
    moveOrigins();
  }

  [[nodiscard]] const std::string& text() const { return program.files[file].document.text(); }

  void complain(Range range, std::string_view place, const std::string& message) {
    diagnostics.push_back(syntax::makeDiagnostic(Code::FiacreModel, {file, range}, place, message));
  }

  /// At a name of a kind; at the text's begin where there is none.
  void complainAt(std::string_view name, NameKind kind, std::string_view place,
                  const std::string& message) {
    const auto found = std::ranges::find_if(parsed.mentions, [&](const fiacre::Mention& each) {
      return each.kind == kind &&
             std::string_view(text()).substr(each.begin, each.end - each.begin) == name;
    });
    const bool known = found != parsed.mentions.end();
    complain(known ? Range{found->begin, found->end} : Range{0, 0}, place, message);
  }

  /// What the type checker says of the model with the addition.
  void check() {
    for (const auto& problem : fiacre::check(model.fiacre))
      complain(rangeOf(problem, model.provenance, text()), problem.place, problem.message);
  }

  codegen::Model& model;
  fiacre::Parsed parsed;
  std::vector<Diagnostic> diagnostics;

private:
  void move(fiacre::OriginId& origin) const {
    if (origin != 0) origin += firstOrigin - 1;
  }
  void move(fiacre::Statement& statement) const {
    move(statement.origin);
    for (auto& child : statement.children) move(child);
  }
  void moveOrigins() {
    auto& read = parsed.program;
    for (auto& process : read.processes) {
      move(process.origin);
      for (auto& state : process.states) move(state.origin);
      if (process.init) move(*process.init);
      for (auto& from : process.transitions) move(from.statement);
    }
    for (auto& function : read.functions) move(function.body);
    for (auto& component : read.components)
      if (component.init) move(*component.init);
    for (auto& property : read.properties) move(property.origin);
  }

  analysis::Program& program;
  syntax::FileId file;
  fiacre::OriginId firstOrigin = 0;
};

template <class Element> void append(std::vector<Element>& to, std::vector<Element>& from) {
  std::ranges::move(from, std::back_inserter(to));
  from.clear();
}

} // namespace proskill::ide
