#include "cli/commands/commands.h"

#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "dap/adapter.h"
#include "disk/disk.h"

#include <CLI/CLI.hpp>

#include <csignal>
#include <iostream>
#include <memory>
#include <optional>

namespace proskill::cli {

namespace {

int serve(rpc::Connection& connection) {
  const disk::DiskFileSystem disk;
  dap::Adapter adapter(connection, disk, {});
  return adapter.run();
}

int runDap(std::optional<std::uint16_t> port) {
  std::signal(SIGPIPE, SIG_IGN); // if the client disconnects, writing must fail, not kill this
                                 // process
  if (!port) return serve(*rpc::standardStreams());
  auto connection = rpc::acceptLoopback(*port, [](std::uint16_t opened) {
    std::cerr << "listening on port " << opened << std::endl;
  });
  if (connection) return serve(**connection);
  return fail("cannot listen on the port: " + connection.error());
}

} // namespace

void addDap(CLI::App& app, int& exitCode) {
  auto port = std::make_shared<std::optional<std::uint16_t>>();
  auto* command = app.add_subcommand(
      "dap", "Step through traces and simulations in a debugger (Debug Adapter Protocol)");
  show(command
           ->add_option("--port", *port,
                        "Wait for one client on this port of the loopback interface (0: any free "
                        "port) instead of standard input")
           ->check(portNumber()),
       group::kAdvanced, "PORT");
  showBelow(*command, {"proskill dap"},
            {{kDone, "the client disconnected"},
             {kAbandoned, "the client went away without disconnecting"},
             {kFailed, "the command line is wrong, or the port cannot be used"}});
  command->callback([port, &exitCode] { exitCode = runDap(*port); });
}

} // namespace proskill::cli
