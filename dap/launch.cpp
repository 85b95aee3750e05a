#include "dap/launch.h"

#include "disk/large_file.h"
#include "report/ordered_json.h"
#include "report/run/parts/recording_part.h"
#include "report/run/read_recording.h"
#include "report/sources.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::dap {

namespace {

using Source = std::expected<std::unique_ptr<StepSource>, std::string>;

std::string textIn(const Json& json, const char* name) {
  auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

std::filesystem::path below(const std::filesystem::path& directory,
                            const std::filesystem::path& path) {
  return path.empty() ? path : (directory / path).lexically_normal();
}

bool selects(const std::string& wanted, const std::string& name) {
  return wanted.empty() || name == wanted || name.starts_with(wanted + ".");
}

bool isBad(const OrderedJson& property) {
  return property.at("good") == false && property.at("verdict") != "inconclusive";
}

/// The property with this name. If several have it, or no name is given: the first violated one.
std::expected<const OrderedJson*, std::string> chosen(const OrderedJson& report,
                                                      const std::string& wanted) {
  const OrderedJson* first = nullptr;
  for (const auto& property : report.at("properties")) {
    const auto name = property.at("name").get<std::string>();
    if (!selects(wanted, name)) continue;
    if (name == wanted) return &property;
    if (!first && (isBad(property) || (!wanted.empty() && !property.at("trace").is_null())))
      first = &property;
  }
  if (first) return first;
  if (wanted.empty())
    return std::unexpected("no property is violated: choose a trace with `property`");
  return std::unexpected(fmt::format("there is no trace of a property `{}`", wanted));
}

std::string wordsOf(const std::string& verdict) {
  return verdict == "holds" ? verdict : "is " + verdict;
}

/// \param json a trace, or a property with a trace
/// \param base directory for its relative paths
Source replay(const OrderedJson& json, const OrderedJson& trace, const std::filesystem::path& base,
              const LaunchContext& around) {
  auto read = readTrace(json, base);
  if (!read) return std::unexpected(read.error());
  const auto textOf = [&](const std::string& file) { return around.disk.read(below(base, file)); };
  for (const auto& file : report::editedSources(trace, textOf))
    around.note(
        fmt::format("{} has been edited since this trace was made: its lines may be others", file));
  return recorded(std::move(*read));
}

Source sourceIn(const OrderedJson& report, const std::string& wanted,
                const std::filesystem::path& base, const LaunchContext& around) {
  try {
    auto property = chosen(report, wanted);
    if (!property) return std::unexpected(property.error());
    const auto& json = **property;
    if (json.at("trace").is_null())
      return std::unexpected(fmt::format("`{}` {}: there is no trace to replay",
                                         json.at("name").get<std::string>(),
                                         wordsOf(json.at("verdict").get<std::string>())));
    return replay(json, json.at("trace"), base, around);
  } catch (const OrderedJson::exception& error) {
    return std::unexpected(fmt::format("not a report of a verification: {}", error.what()));
  }
}

/// The text of the trace file. Of a long recording only a part is read.
std::expected<std::string, std::string> textOf(const LaunchArguments& arguments,
                                               const analysis::FileSystem& disk) {
  const auto file = disk::LargeFile::open(arguments.trace);
  if (!file) return disk.read(arguments.trace); // for its error
  const report::mcap::File recording{file->size(), file->reader()};
  const report::PartOfRun wanted{.from = arguments.from};
  if (!isShownInParts(recording, wanted)) {
    auto text = disk.read(arguments.trace);
    if (!text) return std::unexpected(report::whyNotShown(recording, text.error()));
    return text;
  }
  auto part = report::traceOfPart(recording, wanted);
  if (!part) return std::unexpected(part.error());
  return std::move(part->text);
}

/// Reads a single trace, or a report with many.
Source fromFile(const LaunchArguments& arguments, const LaunchContext& around) {
  auto text = textOf(arguments, around.disk);
  if (!text)
    return std::unexpected(
        fmt::format("cannot read `{}`: {}", arguments.trace.string(), text.error()));
  auto json = parsedJson(*text);
  if (json.is_discarded()) json = parsedJson(report::completed(*text));
  if (!json.is_object())
    return std::unexpected(fmt::format("`{}` is not valid JSON", arguments.trace.string()));
  if (json.contains("properties"))
    return sourceIn(json, arguments.property, arguments.directory, around);
  return replay(json, json, arguments.directory, around);
}

std::expected<analysis::Program, std::string> programOf(const LaunchArguments& arguments,
                                                        const analysis::FileSystem& disk) {
  auto document = disk.document(arguments.program);
  if (!document)
    return std::unexpected(
        fmt::format("cannot read `{}`: {}", arguments.program.string(), document.error()));
  auto program = analysis::load(disk, arguments.program, std::move(*document));
  for (const auto& diagnostic : analysis::check(program))
    if (diagnostic.severity == syntax::Severity::Error)
      return std::unexpected("the program has errors: " + diagnostic.message);
  return program;
}

} // namespace

std::expected<LaunchArguments, std::string> readLaunch(const Json& json) {
  if (!json.is_object()) return std::unexpected("`launch` has no arguments");
  LaunchArguments arguments;
  std::error_code ignored;
  arguments.directory = std::filesystem::current_path(ignored);
  if (auto directory = textIn(json, "cwd"); !directory.empty())
    arguments.directory = below(arguments.directory, directory);
  arguments.program = below(arguments.directory, textIn(json, "program"));
  arguments.trace = below(arguments.directory, textIn(json, "trace"));
  arguments.property = textIn(json, "property");
  arguments.mainSkill = textIn(json, "main");
  if (const auto from = json.value("from", Json()); from.is_number() && from.get<double>() >= 0)
    arguments.from = from.get<double>();
  arguments.simulate = json.value("simulate", Json()) == true;
  arguments.stopOnEntry = json.value("stopOnEntry", Json()) != false;
  if (auto limit = json.value("seconds", Json()); limit.is_number() && limit.get<double>() > 0)
    arguments.budget.seconds = limit.get<double>();
  if (auto limit = json.value("megabytes", Json()); limit.is_number_unsigned())
    arguments.budget.megabytes = limit.get<std::uint64_t>();
  if (arguments.program.empty() && arguments.trace.empty())
    return std::unexpected("`launch` needs a `program` or a `trace`");
  return arguments;
}

Source openSource(const LaunchArguments& arguments, const LaunchContext& around) {
  if (!arguments.trace.empty()) return fromFile(arguments, around);
  auto program = programOf(arguments, around.disk);
  if (!program) return std::unexpected(program.error());
  if (arguments.simulate) return simulated(std::move(*program), arguments.mainSkill);
  auto job = worker::jobFor(*program);
  if (!arguments.property.empty()) job.names = {arguments.property};
  job.mainSkill = arguments.mainSkill;
  job.budget = arguments.budget;
  auto report = worker::runWorker(around.worker, job, around.cancellation, around.progress);
  if (!report) return std::unexpected(report.error().message);
  return sourceIn(*report, arguments.property, {}, around);
}

} // namespace proskill::dap
