#pragma once

#include "view/run_page.h"

/// The shared library `libproskill_view.so`, with which programs that embed the executor show its
/// runs. They load it only for that, since it needs Graphviz.
namespace proskill::view {

/// What both sides must agree on: their version, and the layout of what they share.
struct PageBuild {
  std::string_view version = PROSKILL_VERSION;
  std::size_t program = sizeof(analysis::Program);
  std::size_t executable = sizeof(runtime::Executable);
  std::size_t machine = sizeof(runtime::Machine);
  std::size_t run = sizeof(ObservedRun);
  std::size_t result = sizeof(runtime::RunResult);

  bool operator==(const PageBuild&) const = default;
};

} // namespace proskill::view

/// \return whether the library was built with the caller; otherwise it must not be used
extern "C" bool proskillViewIsOf(const proskill::view::PageBuild& caller);

/// As proskill::view::openRunPage.
extern "C" void proskillViewOpen(proskill::view::ObservedRun& run, std::uint16_t port,
                                 proskill::view::OpenedPage& opened);
