#include "cli/ranks/verify_ranks.h"

#include <fmt/format.h>

#include <dlfcn.h>
#include <filesystem>
#include <iostream>

namespace proskill::cli {

namespace {

/// Where the library is: installed, or built.
std::filesystem::path libraryOfMpi() {
  std::error_code error;
  const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {"../lib/proskill", "../lib"}) {
    auto found = (folder / place / "libproskill_mpi.so").lexically_normal();
    if (std::filesystem::exists(found, error)) return found;
  }
  return "libproskill_mpi.so";
}

} // namespace

std::expected<std::unique_ptr<VerifyRanks>, std::string> VerifyRanks::open() {
  // Open MPI loads more of itself, which finds its symbols only if they are global. It stays
  // loaded.
  void* const library = ::dlopen(libraryOfMpi().c_str(), RTLD_NOW | RTLD_GLOBAL);
  using Connect = verify::Ranks*();
  auto* const connect =
      library ? reinterpret_cast<Connect*>(::dlsym(library, "proskillMpiRanks")) : nullptr;
  if (!connect)
    return std::unexpected(
        fmt::format("`--mpi` needs Open MPI (apt-get install openmpi-bin), and a build with its "
                    "headers (libopenmpi-dev): {}",
                    ::dlerror()));
  return std::unique_ptr<VerifyRanks>(
      new VerifyRanks(std::unique_ptr<verify::Ranks>(connect()))); // the constructor is private
}

VerifyRanks::VerifyRanks(std::unique_ptr<verify::Ranks> of) : ranks(std::move(of)) {
  if (isAssistant()) errors = std::cerr.rdbuf(said.rdbuf());
}

VerifyRanks::~VerifyRanks() {
  if (!isCompared) (void)compare("");
}

std::optional<std::string> VerifyRanks::disagreement(const std::string& key) {
  return compare(key);
}

/// \param key empty: this rank could not read the program
std::optional<std::string> VerifyRanks::compare(const std::string& key) {
  isCompared = true;
  if (errors) std::cerr.rdbuf(errors);
  const auto keys = ranks->gather(key);
  const auto texts = ranks->gather(said.str());
  for (unsigned rank = 1; rank < keys.size(); ++rank) {
    if (keys[rank] == keys[0]) continue;
    if (keys[rank].empty()) return fmt::format("rank {}: {}", rank, texts[rank]);
    return fmt::format("rank {} has another program, other options or another build", rank);
  }
  return std::nullopt;
}

} // namespace proskill::cli
