#include "bridge/rl/read/read.h"

#include "bridge/text/file_reader.h"

#include <iterator>

namespace proskill::bridge::rl {

std::expected<Parsed, Errors> read(const analysis::FileSystem& files,
                                   const std::filesystem::path& root) {
  Parsed all;
  FileReader reader(files, parse, [&](const Parsed& parsed) {
    std::ranges::copy(parsed.skillsets, std::back_inserter(all.skillsets));
    std::ranges::copy(parsed.composites, std::back_inserter(all.composites));
  });
  reader.root(root);
  for (auto& [message, place] : reader.missing) reader.errors.push_back({place, message});
  if (all.skillsets.empty() && all.composites.empty() && reader.errors.empty())
    reader.errors.push_back({{root, 1, 1}, "there is no `skillset`"});
  if (!reader.errors.empty()) return std::unexpected(std::move(reader.errors));
  return all;
}

} // namespace proskill::bridge::rl
