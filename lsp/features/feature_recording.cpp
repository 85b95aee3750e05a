#include "disk/disk.h"
#include "disk/large_file.h"
#include "lsp/protocol/convert.h"
#include "lsp/protocol/registry.h"
#include "report/run/parts/recording_part.h"
#include "report/sources.h"

#include <fmt/format.h>

/// `proskill/recording`: a part of a recorded run, for clients that cannot read MCAP.
/// `proskill/edited`: whether a trace is about the texts that the editor has.
namespace proskill::lsp {

namespace {

rpc::RpcError failed(const std::string& path, const std::string& why) {
  return requestFailed(fmt::format("`{}`: {}", path, why));
}

Answer answerRecording(const Request& request) {
  const auto uri = rpc::memberAt(request.params, {"uri"});
  if (!uri.is_string())
    return std::unexpected(rpc::RpcError{rpc::ErrorCode::InvalidParams, "`uri` is missing"});
  const auto path = pathOf(uri.get_ref<const std::string&>());
  const auto name = path.filename().string();
  const auto file = disk::LargeFile::open(path);
  if (!file) return std::unexpected(failed(name, file.error()));
  const report::mcap::File recording{file->size(), file->reader()};
  if (!recording.isMcap()) return std::unexpected(failed(name, "it is not an MCAP file"));
  report::PartOfRun part;
  if (const auto from = rpc::memberAt(request.params, {"from"}); from.is_number())
    part.from = from.get<double>();
  auto read = traceOfPart(recording, part);
  if (!read) return std::unexpected(failed(name, read.error()));
  return Json{{"trace", std::move(read->text)},
              {"begin", read->begin},
              {"end", read->end},
              {"length", read->length},
              {"whole", read->isWhole}};
}

/// The editor's text, otherwise the file's, even if it has changed a moment ago.
std::expected<std::string, std::string> presentText(const ide::Snapshot& snapshot,
                                                    const std::filesystem::path& path) {
  const bool isOpen = snapshot.open().contains(snapshot.nameOf(path));
  return isOpen ? snapshot.textOf(path) : disk::DiskFileSystem().read(path);
}

Answer answerEdited(const Request& request) {
  const auto sources = rpc::memberAt(request.params, {"sources"});
  if (!sources.is_object())
    return std::unexpected(rpc::RpcError{rpc::ErrorCode::InvalidParams, "`sources` is missing"});
  const OrderedJson trace{{"sources", sources}};
  return Json{{"edited", report::editedSources(trace, [&](const std::string& uri) {
                 return presentText(request.snapshot, pathOf(uri));
               })}};
}

} // namespace

void addRecording(Registry& registry) {
  registry.add("proskill/recording", answerRecording);
  registry.add("proskill/edited", answerEdited);
}

} // namespace proskill::lsp
