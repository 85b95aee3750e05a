#include "view/page_library.h"

using namespace proskill;

extern "C" bool proskillViewIsOf(const view::PageBuild& caller) {
  return caller == view::PageBuild();
}

extern "C" void proskillViewOpen(view::ObservedRun& run, std::uint16_t port,
                                 view::OpenedPage& opened) {
  opened = openRunPage(std::move(run), port);
}
