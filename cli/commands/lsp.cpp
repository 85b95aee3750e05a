#include "cli/commands/commands.h"

#include "cache/verdict_cache.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "disk/disk.h"
#include "lsp/server/server.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace proskill::cli {

namespace {

struct LspArguments {
  std::optional<std::uint16_t> port;
  std::string log;
  unsigned debounce = 50;
  std::string cache = cache::usersDirectory();
  bool noCache = false;
};

/// A log file for all threads. Each line is written at once.
class LogFile {
public:
  explicit LogFile(const std::string& path) : file(path, std::ios::app) {}

  [[nodiscard]] bool isOpen() const { return file.is_open(); }
  void write(std::string_view line) {
    const std::lock_guard lock(mutex);
    file << line << std::endl;
  }

private:
  std::mutex mutex;
  std::ofstream file;
};

/// Threads free what others have allocated, so with many heaps each would keep its maximum. Large
/// answers reuse memory, since returning it to the system and getting it back takes as long as the
/// answer itself.
void tuneHeaps() {
#ifdef __GLIBC__
  constexpr int kMiB = 1 << 20;
  mallopt(M_ARENA_MAX, 2);
  mallopt(M_MMAP_THRESHOLD, 4 * kMiB);
  mallopt(M_TRIM_THRESHOLD, 8 * kMiB);
#endif
}

/// The path of the manual: installed, in an editor's extension, or in the source tree.
std::filesystem::path manual() {
  std::error_code error;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* docs : {"../share/doc/proskill/docs", "docs", "../../docs"})
    if (auto page = (folder / docs / "diagnostics.md").lexically_normal();
        std::filesystem::exists(page, error))
      return page;
  return {};
}

int serve(rpc::Connection& connection, lsp::ServerOptions options) {
  lsp::Server server(connection, std::make_shared<disk::DiskFileSystem>(), std::move(options));
  return server.run();
}

int runLsp(const LspArguments& arguments) {
  tuneHeaps();
  std::signal(SIGPIPE, SIG_IGN); // if the client disconnects, writing must fail, not kill this
                                 // process
  lsp::ServerOptions options;
  options.version = PROSKILL_VERSION;
  options.manual = manual();
  if (!arguments.noCache && !arguments.cache.empty())
    options.worker.insert(options.worker.end(), {"--cache", arguments.cache});
  options.debounce = std::chrono::milliseconds(arguments.debounce);
  if (!arguments.log.empty()) {
    auto log = std::make_shared<LogFile>(arguments.log);
    if (!log->isOpen()) return fail("cannot write to `" + arguments.log + "`");
    options.log = [log](std::string_view line) { log->write(line); };
  }
  if (!arguments.port) return serve(*rpc::standardStreams(), std::move(options));
  auto connection = rpc::acceptLoopback(*arguments.port, [](std::uint16_t port) {
    std::cerr << "listening on port " << port << std::endl;
  });
  if (!connection) return fail("cannot listen on the port: " + connection.error());
  return serve(**connection, std::move(options));
}

} // namespace

void addLsp(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<LspArguments>();
  auto* command = app.add_subcommand("lsp", "Serve an editor (Language Server Protocol)");
  show(command
           ->add_option("--port", arguments->port,
                        "Wait for one client on this port of the loopback interface (0: any free "
                        "port) instead of standard input")
           ->check(portNumber()),
       group::kAdvanced, "PORT");
  show(command->add_option("--log", arguments->log, "Append one line per request to this file"),
       group::kAdvanced, "FILE");
  show(command
           ->add_option("--debounce", arguments->debounce,
                        "Wait this long after the last edit before reporting (default 50)")
           ->check(integerBetween(0, 60'000)),
       group::kAdvanced, "MILLISECONDS");
  show(command->add_option("--cache", arguments->cache,
                           "Keep verdicts in this directory (default: proskill/verdicts in the "
                           "user's cache directory)"),
       group::kAdvanced, "DIRECTORY");
  show(command->add_flag("--no-cache", arguments->noCache, "Keep no verdicts"), group::kAdvanced);
  show(command->add_flag("--stdio")->description("Use standard input and output, as by default"),
       group::kAdvanced);
  showBelow(*command, {"proskill lsp", "proskill lsp --log server.log"},
            {{kDone, "the client shut the server down"},
             {kAbandoned, "the client went away without shutting it down"},
             {kFailed, "the command line is wrong, or the port or the log cannot be used"}});
  command->callback([arguments, &exitCode] { exitCode = runLsp(*arguments); });
}

} // namespace proskill::cli
