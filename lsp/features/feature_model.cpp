#include "codegen/model.h"
#include "fiacre/print/print.h"
#include "ide/snapshot/fiacre_file.h"
#include "lsp/protocol/convert.h"
#include "lsp/verification/verdict_json.h"
#include "report/uri.h"

#include <algorithm>
#include <set>

/// `proskill/model` and `proskill/tests`: the model of a program, and its properties.
namespace proskill::lsp {

namespace {

std::string errorIn(const ide::View& view) {
  for (const auto& diagnostic : view.analysis().diagnostics)
    if (diagnostic.severity == syntax::Severity::Error)
      return "the program has errors: " + diagnostic.message;
  return {};
}

/// The model, or an error message.
std::expected<codegen::Model, std::string> modelOf(const ide::View& view,
                                                   codegen::Edition edition) {
  if (auto error = errorIn(view); !error.empty()) return std::unexpected(error);
  codegen::Options options;
  options.edition = edition;
  auto model = codegen::generate(view.program(), options);
  if (!model) return std::unexpected(model.error().message);
  return std::move(*model);
}

Json placeOf(const fiacre::Origin& origin, const Converter& convert) {
  if (origin.begin == origin.end) return nullptr;
  return convert.location({origin.file, {origin.begin, origin.end}});
}

Json rangesJson(const fiacre::PrintResult& printed, const fiacre::Provenance& provenance,
                const Converter& convert) {
  Json ranges = Json::array();
  for (const auto& range : printed.ranges) {
    const auto& origin = provenance.origins[range.origin];
    ranges.push_back({{"origin", range.origin},
                      {"firstLine", range.firstLine},
                      {"lastLine", range.lastLine},
                      {"location", placeOf(origin, convert)},
                      {"actor", origin.actor},
                      {"description", origin.description}});
  }
  return ranges;
}

std::optional<codegen::Edition> editionIn(const Json& params) {
  const auto edition = params.value("edition", Json("compact"));
  if (edition == "compact") return codegen::Edition::Compact;
  if (edition == "expanded") return codegen::Edition::Expanded;
  if (edition == "runtime") return codegen::Edition::Runtime;
  return std::nullopt;
}

Answer model(const Request& request) {
  auto path = documentFile(request);
  if (!path) return std::unexpected(path.error());
  const auto edition = editionIn(request.params);
  if (!edition)
    return std::unexpected(rpc::RpcError{rpc::ErrorCode::InvalidParams,
                                         "`edition` must be compact, expanded or runtime"});
  const auto view = request.snapshot.view(*path);
  const auto made = modelOf(view, *edition);
  if (!made) return std::unexpected(requestFailed(made.error()));
  const auto printed = fiacre::printWithRanges(made->fiacre);
  const Converter convert(view, request);
  return Json{{"text", printed.text},
              {"language", *edition == codegen::Edition::Runtime ? "hfiacre" : "fiacre"},
              {"ranges", rangesJson(printed, made->provenance, convert)},
              {"texts", textsJson(view.program(), request.snapshot.open())}};
}

/// The subject of checks, and its definition.
struct Subject {
  std::string kind;
  std::optional<analysis::Location> location;
};

template <class Table>
std::optional<analysis::Location> nameIn(const Table& table, const std::string& name) {
  const auto* definition = table.find(name);
  if (!definition) return std::nullopt;
  return definition->at(definition->form->name.range);
}

Subject subjectOf(const analysis::Program& program, const codegen::Check& check) {
  if (check.kind == "property") return {"property", nameIn(program.properties, check.subject)};
  if (check.kind == "no_forbidden_transition")
    return {"sv", nameIn(program.stateVariables, check.subject)};
  if (auto skill = nameIn(program.skills, check.subject)) return {"skill", skill};
  if (auto event = nameIn(program.events, check.subject)) return {"event", event};
  if (auto environment = nameIn(program.environments, check.subject))
    return {"environment", environment};
  return {"program", std::nullopt};
}

Json checkJson(const codegen::Check& check, const codegen::Model& model, const Converter& convert) {
  return {{"id", check.name},
          {"label", check.description},
          {"kind", check.kind},
          {"severity", check.weight == codegen::Weight::Error ? "error" : "warning"},
          {"location", placeOf(model.provenance.origins[check.origin], convert)}};
}

Json subjectsJson(const codegen::Model& model, const analysis::Program& program,
                  const Converter& convert) {
  Json subjects = Json::array();
  for (const auto& check : model.checks) {
    const auto subject = subjectOf(program, check);
    if (subjects.empty() || subjects.back()["id"] != check.subject ||
        subjects.back()["kind"] != subject.kind)
      subjects.push_back(
          {{"id", check.subject},
           {"label", check.subject},
           {"kind", subject.kind},
           {"location", subject.location ? convert.location(*subject.location) : Json()},
           {"properties", Json::array()}});
    subjects.back()["properties"].push_back(checkJson(check, model, convert));
  }
  return subjects;
}

Json programJson(const ide::View& view, const Request& request) {
  const Converter convert(view, request);
  Json json{{"uri", convert.uri(0)},
            {"label", view.program().files.front().path.filename().string()},
            {"main", nullptr},
            {"error", nullptr},
            {"listed", true},
            {"subjects", Json::array()},
            {"texts", textsJson(view.program(), request.snapshot.open())}};
  const auto made = modelOf(view, codegen::Edition::Compact);
  if (!made) {
    json["error"] = made.error();
    return json;
  }
  if (!made->mainSkill.empty()) json["main"] = made->mainSkill;
  json["subjects"] = subjectsJson(*made, view.program(), convert);
  return json;
}

/// A program without an open file. Its properties are listed when it is requested by name, since
/// generating all models of a large workspace takes long.
Json closedJson(const std::filesystem::path& root) {
  return {{"uri", report::toUri(root)},
          {"label", root.filename().string()},
          {"main", nullptr},
          {"error", nullptr},
          {"listed", false},
          {"subjects", Json::array()},
          {"texts", Json::array()}};
}

Answer tests(const Request& request) {
  std::vector<std::filesystem::path> files;
  if (request.params.is_object() && request.params.contains("textDocument")) {
    auto path = documentFile(request);
    if (!path) return std::unexpected(path.error());
    files.push_back(*path);
  } else {
    for (const auto& [path, text] : request.snapshot.open()) files.push_back(path);
  }
  Json programs = Json::array();
  std::set<std::filesystem::path> known; // root files of programs
  for (const auto& file : files)
    for (const auto& view : request.snapshot.views(file)) {
      if (request.cancellation.isCancelled()) break;
      if (known.insert(view.program().files.front().path).second)
        programs.push_back(programJson(view, request));
    }
  if (rpc::memberAt(request.params, {"workspace"}) == true)
    for (const auto& root : request.snapshot.includes()->roots())
      if (!ide::isFiacre(root) && known.insert(root).second) programs.push_back(closedJson(root));
  return Json{{"programs", programs}};
}

} // namespace

void addModel(Registry& registry) {
  registry.add("proskill/model", model, rpc::Priority::Background);
  registry.add("proskill/tests", tests, rpc::Priority::Background);
}

} // namespace proskill::lsp
