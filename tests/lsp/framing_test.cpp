#include "rpc/framing.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace proskill::rpc;

namespace {

/// Everything that a reader makes of a stream in pieces of this size.
std::vector<rpc::Frame> readAll(std::string_view stream, std::size_t piece,
                                std::size_t limit = 1000) {
  rpc::FrameReader reader(limit);
  std::vector<rpc::Frame> frames;
  while (!stream.empty()) {
    reader.feed(stream.substr(0, piece));
    stream.remove_prefix(std::min(piece, stream.size()));
    while (auto frame = reader.next()) frames.push_back(*frame);
  }
  return frames;
}

std::string body(const rpc::Frame& frame) {
  const auto* text = std::get_if<std::string>(&frame);
  return text ? *text : "error: " + std::get<rpc::FramingError>(frame).message;
}

} // namespace

TEST_CASE("messages are the same however their stream is cut") {
  auto stream = frame("{\"a\":1}") + frame("") + frame("{\"é\":\"\r\n\r\n\"}");
  for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
    auto frames = readAll(stream, piece);
    REQUIRE(frames.size() == 3);
    CHECK(body(frames[0]) == "{\"a\":1}");
    CHECK(body(frames[1]).empty());
    CHECK(body(frames[2]) == "{\"é\":\"\r\n\r\n\"}");
  }
}

TEST_CASE("a header may have other fields, and its words any case") {
  auto frames =
      readAll("content-LENGTH:  2 \r\nContent-Type: application/vscode-jsonrpc\r\n\r\n{}", 5);
  REQUIRE(frames.size() == 1);
  CHECK(body(frames[0]) == "{}");
}

TEST_CASE("a header without a length is an error, and the message after it is read") {
  auto frames = readAll("Hello: you\r\n\r\n" + frame("{}"), 3);
  REQUIRE(frames.size() == 2);
  CHECK(std::holds_alternative<rpc::FramingError>(frames[0]));
  CHECK(body(frames[1]) == "{}");
}

TEST_CASE("a length that is no number is an error") {
  for (auto length : {"-1", "2x", "", "99999999999999999999999"}) {
    auto frames = readAll("Content-Length: " + std::string(length) + "\r\n\r\n" + frame("{}"), 64);
    REQUIRE(frames.size() == 2);
    CHECK(std::holds_alternative<rpc::FramingError>(frames[0]));
    CHECK(body(frames[1]) == "{}");
  }
}

TEST_CASE("a body that is too long is skipped as it comes") {
  auto frames = readAll(frame(std::string(2000, 'x')) + frame("{}"), 100);
  REQUIRE(frames.size() == 2);
  CHECK(std::holds_alternative<rpc::FramingError>(frames[0]));
  CHECK(body(frames[1]) == "{}");
}

TEST_CASE("two gibibytes are announced, and nothing is held for them") {
  rpc::FrameReader reader;
  reader.feed("Content-Length: 2147483648\r\n\r\n");
  auto first = reader.next();
  REQUIRE(first);
  CHECK(std::holds_alternative<rpc::FramingError>(*first));
  reader.feed(std::string(1 << 20, 'x'));
  CHECK(!reader.next());
}

TEST_CASE("what looks like a header only until more of it has come is none") {
  const std::string stream = "noise\r\n\r\nno; content-length: 5, content-Length: 2\r\n"
                             "Content-Length: 4\r\n\r\nabcd" +
                             frame("{}");
  for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
    const auto frames = readAll(stream, piece);
    INFO("pieces of " << piece);
    CHECK(body(frames.back()) == "{}");
    std::vector<std::string> bodies;
    for (const auto& each : frames)
      if (std::holds_alternative<std::string>(each)) bodies.push_back(body(each));
    CHECK(bodies == std::vector<std::string>{"abcd", "{}"});
  }
}

TEST_CASE("a header that is too long is none, however the stream is cut") {
  const auto headerOf = [](std::size_t length) {
    return "X: " + std::string(length - 22, 'x') + "\r\nContent-Length: 2\r\n\r\n{}";
  };
  for (const std::size_t length : {8000u, 8192u, 8193u, 9000u}) {
    const auto stream = headerOf(length);
    const auto whole = readAll(stream, stream.size());
    INFO(length);
    CHECK(readAll(stream, 1).size() == whole.size());
    CHECK(body(whole.back()) == "{}");
    CHECK((whole.size() == 1) == (length <= 8192));
  }
}

TEST_CASE("noise without a header is dropped, and the next message is read") {
  auto frames = readAll(std::string(20000, '\0') + frame("{}"), 777);
  REQUIRE(!frames.empty());
  CHECK(body(frames.back()) == "{}");
}
