#include "fuzz/targets.h"
#include "report/uri.h"
#include "rpc/framing.h"
#include "rpc/rpc.h"
#include "syntax/text/position.h"

#include <algorithm>
#include <string>
#include <vector>

namespace proskill::fuzz {

namespace {

using namespace rpc;
using namespace report;
using namespace syntax;

/// Bodies longer than this are skipped.
constexpr std::size_t kLimit = 4'096;

std::vector<Frame> framesOf(std::string_view stream, std::size_t piece) {
  FrameReader reader(kLimit);
  std::vector<Frame> frames;
  while (!stream.empty()) {
    reader.feed(stream.substr(0, piece));
    stream.remove_prefix(std::min(piece, stream.size()));
    while (auto frame = reader.next()) frames.push_back(std::move(*frame));
  }
  return frames;
}

std::vector<std::string> bodiesOf(const std::vector<Frame>& frames) {
  std::vector<std::string> bodies;
  for (const auto& frame : frames)
    if (const auto* body = std::get_if<std::string>(&frame)) bodies.push_back(*body);
  return bodies;
}

/// A position that an editor can send survives the round trip, in every encoding.
void placesComeBack(std::string_view text) {
  const syntax::LineIndex lines(text);
  for (auto encoding : {Encoding::Utf8, Encoding::Utf16, Encoding::Utf32})
    for (syntax::Offset at = 0; at <= text.size(); ++at) {
      const auto place = fromEditor(text, lines, toEditor(text, lines, at, encoding), encoding);
      expect(place <= text.size(), "a place is within the text");
      expect(fromEditor(text, lines, toEditor(text, lines, place, encoding), encoding) == place,
             "a place comes back");
    }
}

void messageIsAnswered(const Message& message) {
  if (message.kind == MessageKind::Request)
    expect(parseMessage(request(message.id, message.method, message.params)).has_value(),
           "a request is written as it was read");
  const Json& uri = memberAt(message.params, {"textDocument", "uri"});
  if (!uri.is_string()) return;
  const auto text = uri.get<std::string>();
  expect(normalised(normalised(text)) == normalised(text), "a URI has one spelling");
  if (const auto path = toPath(text))
    expect(toPath(toUri(*path)) == path, "a path comes back from its URI");
}

} // namespace

void protocol(std::string_view bytes) {
  if (bytes.empty()) return;
  const auto piece = std::size_t{1} + static_cast<unsigned char>(bytes.front());
  const auto stream = bytes.substr(1);
  const auto bodies = bodiesOf(framesOf(stream, piece));
  expect(bodies == bodiesOf(framesOf(stream, stream.size() + 1)),
         "messages are the same however the stream is cut");
  for (const auto& body : bodies) {
    expect(bodiesOf(framesOf(frame(body), piece)) == std::vector{body}, "a message can be sent on");
    placesComeBack(std::string_view(body).substr(0, 200));
    if (const auto message = parseMessage(body))
      messageIsAnswered(*message);
    else
      expect(parseMessage(replyError(message.error().id, message.error().error)).has_value(),
             "a message that is none is answered by one");
  }
}

} // namespace proskill::fuzz
