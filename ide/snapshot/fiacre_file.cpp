#include "ide/snapshot/fiacre_file.h"

#include "fiacre/check/check.h"
#include "fiacre/check/lone_ports.h"
#include "fiacre/format/format.h"
#include "fiacre/print/print.h"
#include "fiacre/syntax/parse.h"
#include "ide/snapshot/fiacre_join.h"
#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::ide {

namespace {

using syntax::Code;
using syntax::Diagnostic;
using syntax::Offset;
using syntax::Range;

bool isWord(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The position of a name in a range; the whole range if it does not occur.
Range narrowed(std::string_view text, Range range, std::string_view name) {
  const auto within = text.substr(0, range.end);
  for (auto at = within.find(name, range.begin); at != std::string_view::npos;
       at = within.find(name, at + 1)) {
    const auto end = at + name.size();
    if ((at == 0 || !isWord(text[at - 1])) && (end == text.size() || !isWord(text[end])))
      return {static_cast<Offset>(at), static_cast<Offset>(end)};
  }
  return range;
}

/// The first word in backquotes in a message.
std::string_view inBackquotes(std::string_view message) {
  const auto open = message.find('`');
  const auto close = open == std::string_view::npos ? open : message.find('`', open + 1);
  return close == std::string_view::npos ? "" : message.substr(open + 1, close - open - 1);
}

/// The name at the end of "process P, state run" or of "type cell".
std::string_view lastWord(std::string_view place) {
  const auto space = place.rfind(' ');
  return space == std::string_view::npos ? place : place.substr(space + 1);
}

/// Adds the check for run-time errors, unless the model has a property of this name.
void addErrorCheck(fiacre::Program& program) {
  constexpr std::string_view kName = "no_runtime_error";
  if (std::ranges::find(program.properties, kName, &fiacre::Property::name) !=
      program.properties.end())
    return;
  program.properties.push_back({.name = std::string(kName),
                                .pattern = {.kind = fiacre::PatternKind::NoError},
                                .asserted = true});
}

void addChecks(codegen::Model& model) {
  addErrorCheck(model.fiacre);
  const auto& properties = model.fiacre.properties;
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (!properties[i].asserted) continue;
    model.checks.push_back(
        {.name = properties[i].name,
         .kind = "property",
         .subject = model.fiacre.main,
         .description = fiacre::printPattern(properties[i].pattern, model.fiacre.main),
         .property = i,
         .origin = properties[i].origin});
  }
}

/// The place at which a component declares a port.
Range declarationOf(const fiacre::Parsed& parsed, std::string_view text,
                    const fiacre::LonePort& of) {
  bool inComponent = false;
  for (const auto& mention : parsed.mentions) {
    if (!mention.declares) continue;
    const auto name = text.substr(mention.begin, mention.end - mention.begin);
    if (mention.kind == fiacre::NameKind::Component) inComponent = name == of.component;
    if (inComponent && mention.kind == fiacre::NameKind::Port && name == of.port)
      return {mention.begin, mention.end};
  }
  return {0, 0};
}

void warnOfLonePorts(FiacreFile& file, const fiacre::Parsed& parsed) {
  const std::string& text = file.program.files[0].document.text();
  for (const auto& port : fiacre::lonePorts(file.model.fiacre)) {
    const auto who = port.only.empty()
                         ? fmt::format("no two instances wait for each other on `{}`", port.port)
                         : fmt::format("only {} has the port `{}`", port.only, port.port);
    file.diagnostics.push_back(
        syntax::makeDiagnostic(Code::FiacreLonePort, {0, declarationOf(parsed, text, port)}, who));
  }
}

} // namespace

bool FiacreFile::hasErrors() const {
  return std::ranges::any_of(diagnostics, [](const Diagnostic& diagnostic) {
    return diagnostic.severity == syntax::Severity::Error;
  });
}

/// The range of a problem: that of its statement, or of the declaration that it names.
Range rangeOf(const fiacre::Problem& problem, const fiacre::Provenance& provenance,
              std::string_view text) {
  const auto& origin = provenance.origins[problem.origin];
  const auto name = inBackquotes(problem.message);
  if (problem.origin != 0) {
    const Range range{origin.begin, origin.end};
    return name.empty() ? range : narrowed(text, range, name);
  }
  const Range whole{0, static_cast<Offset>(text.size())};
  const bool ofAll = problem.place.empty() || problem.place == "model";
  const Range declared = ofAll ? whole : narrowed(text, whole, lastWord(problem.place));
  return declared == whole ? Range{0, 0} : declared;
}

bool isFiacre(const std::filesystem::path& path) { return path.extension() == ".fcr"; }

bool isFiacre(const View& view) { return isFiacre(view.program().files[view.file].path); }

std::optional<std::vector<syntax::TextEdit>> formatFiacre(std::string_view text) {
  const auto changes = fiacre::formatChanges(text);
  if (!changes) return std::nullopt;
  std::vector<syntax::TextEdit> edits;
  for (const auto& change : *changes) edits.push_back({{change.begin, change.end}, change.text});
  return edits;
}

FiacreFile readFiacre(const std::filesystem::path& path, std::string text) {
  FiacreFile result;
  result.program.files.push_back({path, syntax::Document::parse(std::move(text))});
  const std::string& source = result.program.files[0].document.text();
  auto parsed = fiacre::parse(source);
  for (const auto& problem : parsed.problems)
    result.diagnostics.push_back(syntax::makeDiagnostic(
        Code::FiacreText, {0, {problem.begin, problem.end}}, problem.message));
  result.model = {.fiacre = std::move(parsed.program), .provenance = std::move(parsed.provenance)};
  result.model.provenance.byHand = true;
  if (!result.diagnostics.empty())
    return result; // what was not parsed would be reported as
                   // missing everywhere
  for (const auto& problem : fiacre::check(result.model.fiacre)) {
    if (!result.isModel() && problem.place == "model") continue;
    result.diagnostics.push_back(syntax::makeDiagnostic(
        Code::FiacreModel, {0, rangeOf(problem, result.model.provenance, source)}, problem.place,
        problem.message));
    if (auto fix = joinedFrom(result.model, problem.origin, source))
      result.diagnostics.back().fixes.push_back(std::move(*fix));
  }
  if (result.isModel() && result.diagnostics.empty()) warnOfLonePorts(result, parsed);
  addChecks(result.model);
  return result;
}

} // namespace proskill::ide
