#include "cli/terminal/browser.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

namespace proskill::cli {

void openBrowser(const std::string& url) {
  std::string command = "xdg-open";
  std::string address = url;
  char* const words[] = {command.data(), address.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  posix_spawnp(&child, command.c_str(), &actions, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&actions);
}

} // namespace proskill::cli
