#include "cache/this_program.h"

#include "disk/disk.h"
#include "syntax/text/source.h"

namespace proskill::cache {

const std::string& digestOfThisProgram() {
  static const std::string digest = [] {
    const auto bytes = disk::DiskFileSystem().read("/proc/self/exe");
    return bytes ? syntax::digestOf(*bytes) : "";
  }();
  return digest;
}

} // namespace proskill::cache
