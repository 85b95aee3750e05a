#include "cli/output/report.h"

#include "disk/output.h"
#include "report/verify_report.h"
#include "view/panel_bundle.h"
#include "view/panel_json.h"

#include <fmt/format.h>

namespace proskill::cli {

namespace {

/// The policy allows only the page's own script and style.
constexpr std::string_view kReportPage = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="UTF-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src '{script}'; style-src '{style}'; img-src blob: data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="proskill {version}">
<title>ProSkill</title>
<link rel="icon" href="data:,">
<style>{css}</style>
</head>
<body><div id="panel"></div>
<script type="application/json" id="proskill-report">{data}</script>
<script>{js}</script>
</body>
</html>
)";

/// Escapes `</`, so that no text of a program can end the element.
std::string withinScript(const OrderedJson& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace))
    out += c == '<' ? "\\u003c" : std::string(1, c);
  return out;
}

/// Adds the unfolded picture and, if it differs, the folded one, each for light and dark
/// background.
void addPicture(OrderedJson& all, const analysis::Program& program, const viz::Request& request) {
  view::PictureParams params{request, viz::Format::Dot, false, std::vector<std::string>{}};
  const auto dot = view::pictureJson(program, params, false);
  if (!dot) return;
  std::vector<std::string> clusters;
  for (const auto& it : (*dot)["foldable"]) clusters.push_back(it["key"]);
  params.format = viz::Format::Svg;
  for (const bool dark : {false, true}) {
    for (const auto& fold : {std::vector<std::string>{}, clusters}) {
      params.dark = dark;
      params.fold = fold;
      if (auto svg = view::pictureJson(program, params, false))
        all.push_back({{"params", view::paramsJson(params)},
                       {"svg", std::move(*svg)},
                       {"dot", dark ? OrderedJson() : (*dot)["content"]}});
      if (clusters.empty()) break;
    }
  }
}

/// Says why a trace is missing: see ide::kTracesOfPage.
void explainMissingTraces(OrderedJson& properties) {
  for (auto& property : properties) {
    if (!property["trace"].is_null() || property["steps"].is_null()) continue;
    property["steps"] = nullptr;
    property["reason"] =
        "this page would be too large with all traces; make it with --traces all to see this one";
  }
}

OrderedJson dataOf(const report::VerifyReport& report) {
  const auto& program = report.program;
  auto verdicts = report::reportJson(report);
  explainMissingTraces(verdicts["properties"]);
  verdicts.update({{"label", program.files.front().path.filename().generic_string()},
                   {"state", "done"},
                   {"stale", false},
                   {"message", ""},
                   {"progress", nullptr},
                   {"pictures", view::picturesJson(program)},
                   {"files", view::filesJson(program)}});
  OrderedJson sources = OrderedJson::object();
  for (const auto& file : program.files) sources[file.path.generic_string()] = file.document.text();
  OrderedJson pictures = OrderedJson::array();
  for (auto request : viz::allPictures(program)) {
    addPicture(pictures, program, request);
    if (request.kind != viz::Kind::StateVariable) continue;
    request.forbidden = true;
    addPicture(pictures, program, request);
  }
  return {{"report", std::move(verdicts)},
          {"sources", std::move(sources)},
          {"pictures", std::move(pictures)}};
}

} // namespace

std::optional<std::string> writeReport(const std::filesystem::path& directory,
                                       const report::VerifyReport& report) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return fmt::format("cannot create the directory {}: {}", directory.string(), error.message());
  const auto hashes = OrderedJson::parse(view::bundle::hashesJson);
  const auto page = fmt::format(
      kReportPage, fmt::arg("script", hashes["script"].get<std::string>()),
      fmt::arg("style", hashes["style"].get<std::string>()), fmt::arg("version", PROSKILL_VERSION),
      fmt::arg("css", view::bundle::panelCss), fmt::arg("js", view::bundle::panelJs),
      fmt::arg("data", withinScript(dataOf(report))));
  return disk::writeOutput(directory / "index.html", page);
}

} // namespace proskill::cli
