#include "tests/ide/marked_program.h"

#include "tests/support/memory_files.h"

namespace proskill::test {

namespace {

const std::filesystem::path kFolder = "/w";

} // namespace

MarkedProgram::MarkedProgram(const std::map<std::string, std::string>& files) {
  ide::OpenTexts texts;
  std::string asked = files.begin()->first;
  for (const auto& [name, marked] : files) {
    const auto& source = sources.emplace(name, MarkedSource(marked)).first->second;
    auto document = syntax::Document::parse(source.text);
    texts[kFolder / name] = {"file:///w/" + name, 1, std::move(document)};
    if (!source.points.empty()) asked = name;
  }
  const auto& source = sources.at(asked);
  if (!source.points.empty())
    cursor = source.points.front();
  else if (!source.ranges.empty())
    cursor = source.ranges.front().begin;
  auto disk = std::make_shared<MemoryFiles>();
  auto graph = ide::graphOf(*disk, texts);
  current = std::make_shared<ide::Snapshot>(std::move(disk), std::move(texts), std::move(graph));
  seen = current->view(kFolder / asked);
}

std::vector<analysis::Location> MarkedProgram::marked() const {
  std::vector<analysis::Location> result;
  const auto& files = seen.program().files;
  for (analysis::FileId file = 0; file < files.size(); ++file)
    for (auto range : sources.at(files[file].path.filename().string()).ranges)
      result.push_back({file, range});
  return result;
}

std::string MarkedProgram::textAt(analysis::Location place) const {
  const auto& file = seen.program().files[place.file];
  return file.path.filename().string() + ":" +
         file.document.text().substr(place.range.begin, place.range.length());
}

} // namespace proskill::test
