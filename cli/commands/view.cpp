#include "cli/commands/commands.h"

#include "cli/terminal/browser.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/length_of_time.h"
#include "cli/terminal/number.h"
#include "disk/disk.h"
#include "disk/large_file.h"
#include "report/run/parts/recording_part.h"
#include "view/http_server.h"
#include "view/panel_routes.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace proskill::cli {

namespace {

struct ViewArguments {
  std::string file;
  std::string mainSkill;
  std::uint16_t port = 0;
  bool noOpen = false;
  double timeLimit = 60;
  std::uint64_t memoryLimit = 2048; // in MiB
  std::optional<runtime::Nanoseconds> from;
};

/// A trace or a report: by the extension, or by the first character, which no program begins with.
bool isRecorded(const std::filesystem::path& path, const std::string& text) {
  if (path.extension() == ".json") return true;
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '{';
}

using FoundPart = std::expected<report::TraceOfPart, std::string>;

/// The trace of a part of the file, if it is shown in parts. \param from as of `report::PartOfRun`
std::optional<FoundPart> firstPart(const std::string& path, std::optional<double> from) {
  const auto file = disk::LargeFile::open(path);
  if (!file) return std::nullopt;
  const report::mcap::File recording{file->size(), file->reader()};
  report::PartOfRun part;
  part.from = from;
  if (!isShownInParts(recording, part)) return std::nullopt;
  return traceOfPart(recording, part);
}

FoundPart otherPart(const std::string& path, std::optional<double> from) {
  const auto file = disk::LargeFile::open(path);
  if (!file) return std::unexpected(file.error());
  report::PartOfRun part;
  part.from = from;
  return traceOfPart({file->size(), file->reader()}, part);
}

std::string whyUnreadable(const std::filesystem::path& path, const std::string& reason) {
  const auto file = disk::LargeFile::open(path);
  return file ? report::whyNotShown({file->size(), file->reader()}, reason) : reason;
}

std::expected<std::unique_ptr<view::PanelData>, std::string>
recordedRun(const std::string& file, const report::TraceOfPart& part) {
  if (part.isWhole) return view::savedReport(file, part.text);
  return view::savedReport(file, part.text,
                           [file](auto from) -> std::expected<std::string, std::string> {
                             auto other = otherPart(file, from);
                             if (!other) return std::unexpected(other.error());
                             return std::move(other->text);
                           });
}

std::optional<double> startOf(const ViewArguments& arguments) {
  if (!arguments.from) return std::nullopt;
  return static_cast<double>(*arguments.from) / static_cast<double>(runtime::kSecond);
}

std::expected<std::unique_ptr<view::PanelData>, std::string> dataOf(const ViewArguments& arguments,
                                                                    view::EventFeed& news) {
  const std::filesystem::path path(arguments.file);
  if (const auto part = firstPart(arguments.file, startOf(arguments))) {
    if (!*part) return std::unexpected("`" + arguments.file + "`: " + part->error());
    return recordedRun(arguments.file, **part);
  }
  const auto text = disk::DiskFileSystem().read(path);
  if (!text)
    return std::unexpected("cannot read `" + arguments.file +
                           "`: " + whyUnreadable(path, text.error()));
  if (isRecorded(path, *text)) return view::savedReport(arguments.file, *text);
  verify::Limits limits;
  limits.seconds = arguments.timeLimit;
  limits.bytes = bytesOfMiB(arguments.memoryLimit);
  return liveProgram({arguments.file, arguments.mainSkill, limits}, news);
}

int runView(const ViewArguments& arguments) {
  auto server = view::HttpServer::listen(arguments.port);
  if (!server) return fail("cannot listen on the port: " + server.error());
  view::EventFeed news;
  auto data = dataOf(arguments, news);
  if (!data) return fail(data.error());
  const view::PanelAddress address{(*server)->port(), view::randomToken()};
  std::cout << address.url() << std::endl;
  if (isatty(STDERR_FILENO) != 0) std::cerr << "Ctrl-C ends it\n";
  if (!arguments.noOpen) openBrowser(address.url());
  (*server)->run(
      [&](const view::HttpRequest& request, const view::HttpServer::Reply& reply) {
        answer(request, address, **data, news, reply);
      },
      [&] { news.close(); });
  return kDone;
}

} // namespace

void addView(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<ViewArguments>();
  auto* command =
      app.add_subcommand("view", "Show verdicts, traces and automata in a browser, live");
  command
      ->add_option("file", arguments->file,
                   "Root file of the program, or a saved trace or report (JSON), or a recording "
                   "(JSON or MCAP)")
      ->required();
  addMainSkill(*command, arguments->mainSkill);
  addLengthOfTime(*command, "--from", arguments->from,
                  "Show the part of a long recording that begins at this time of its run, in "
                  "seconds or with m, h, d; default: the last part",
                  group::kOutput, 0);
  show(command->add_flag("--no-open", arguments->noOpen,
                         "Print the address without opening a browser"),
       group::kOutput);
  show(command
           ->add_option("--time-limit", arguments->timeLimit,
                        "Time limit of a verification in seconds (default 60); properties not "
                        "decided by then are inconclusive")
           ->check(positiveSeconds()),
       group::kLimits, "SECONDS");
  show(command
           ->add_option("--memory-limit", arguments->memoryLimit,
                        "Memory limit of a verification in MiB (default 2048)")
           ->check(integerBetween(1)),
       group::kLimits, "MIB");
  show(command
           ->add_option("--port", arguments->port,
                        "Port on the loopback interface (0, the default: any free port)")
           ->check(portNumber()),
       group::kAdvanced, "PORT");
  showBelow(*command, {"proskill view mission.proskill", "proskill view report.json"},
            {{kDone, "ended by Ctrl-C"}, {kFailed, "the file or the port cannot be used"}});
  command->callback([arguments, &exitCode] { exitCode = runView(*arguments); });
}

} // namespace proskill::cli
