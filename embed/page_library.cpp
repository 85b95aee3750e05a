#include "embed/page_library.h"

#include "disk/installation.h"
#include "view/page_library.h"

#include <fmt/format.h>

#include <csignal>
#include <dlfcn.h>

namespace proskill::embed {

namespace {

/// The threads that are created meanwhile leave all signals to those of the program.
class BlockedSignals {
public:
  BlockedSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
  }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }

private:
  sigset_t before{};
};

template <class Function> Function* function(void* library, const char* name) {
  return reinterpret_cast<Function*>(::dlsym(library, name));
}

std::unexpected<std::string> notLoaded(const std::string& path) {
  const char* why = ::dlerror();
  return std::unexpected(
      fmt::format("cannot load {}: {}", path, why ? why : "it has no page for runs"));
}

} // namespace

view::OpenedPage openPage(view::ObservedRun run, std::uint16_t port) {
  const auto path = disk::viewLibrary().string();
  if (path.empty())
    return std::unexpected("libproskill_view.so, which shows runs, is not beside libproskill.so");
  const BlockedSignals blocked;
  void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!library) return notLoaded(path);
  auto* const isOf = function<decltype(proskillViewIsOf)>(library, "proskillViewIsOf");
  auto* const open = function<decltype(proskillViewOpen)>(library, "proskillViewOpen");
  if (!isOf || !open) return notLoaded(path);
  if (!isOf({})) return std::unexpected(path + " is of another version than libproskill.so");
  view::OpenedPage opened;
  open(run, port, opened);
  return opened;
}

} // namespace proskill::embed
