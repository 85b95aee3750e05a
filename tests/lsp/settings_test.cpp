#include "lsp/protocol/client_settings.h"
#include "lsp/server/announcer.h"
#include "lsp/workspace/file_cache.h"
#include "report/program_settings.h"
#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

using namespace proskill;
using namespace std::chrono_literals;

namespace {

/// One file, and how often it was read.
class CountingFiles : public analysis::FileSystem {
public:
  std::expected<std::string, std::string> read(const std::filesystem::path&) const override {
    ++reads;
    return "(defsv lamp :states (On Off) :init Off)";
  }
  std::filesystem::path canonical(const std::filesystem::path&) const override {
    ++follows;
    return end;
  }
  std::filesystem::path end = "/b";
  mutable int reads = 0;
  mutable int follows = 0;
};

} // namespace

TEST_CASE("settings of an editor are read with or without the name of their section") {
  const Json section = {{"diagnostics", {{"enabled", false}, {"style", true}, {"debounce", 200U}}}};
  for (const Json& json : {section, Json{{"proskill", section}}}) {
    auto settings = lsp::readClientSettings(json);
    CHECK_FALSE(settings.diagnostics);
    CHECK(settings.style);
    CHECK(settings.debounce == 200ms);
  }
}

TEST_CASE("settings of the wrong type are as if they had not been said") {
  for (const Json& json : {Json(), Json::array(), Json{{"diagnostics", 3}},
                           Json{{"diagnostics", {{"enabled", "no"}, {"debounce", -1}}}}}) {
    auto settings = lsp::readClientSettings(json);
    CHECK(settings.diagnostics);
    CHECK_FALSE(settings.style);
    CHECK_FALSE(settings.debounce.has_value());
  }
}

TEST_CASE("the nearest file of settings is the one that holds") {
  const test::MemoryFiles files({{"/w/.proskill.json", R"({"style": true})"},
                                 {"/w/strict/.proskill.json", R"({"style": 3})"}});
  auto outer = report::settingsFor(files, "/w/lax/main.proskill");
  CHECK(outer.settings.style);
  CHECK(outer.file == "/w/.proskill.json");
  CHECK_FALSE(outer.mistake);
  auto inner = report::settingsFor(files, "/w/strict/main.proskill");
  CHECK_FALSE(inner.settings.style);
  REQUIRE(inner.mistake);
  CHECK(inner.mistake->description == "`style` must be `true` or `false`");
  CHECK(report::settingsFor(files, "/v/main.proskill").file.empty());
}

TEST_CASE("a mistake in settings is told where it stands") {
  for (const auto& [text, place, words] :
       {std::tuple{R"({"style": true, "severity": {"PS0708": "loud"}})", R"("loud")",
                   "the severity of `PS0708` must be"},
        std::tuple{R"({"severity": {"PS0708": 3}})", R"("PS0708")",
                   "the severity of `PS0708` must be"},
        std::tuple{R"({"severity": {"PS9999": "off"}})", R"("PS9999")", "not the code"},
        std::tuple{R"({"a\"\\": 1})", R"("a\"\\")", "unknown setting"},
        std::tuple{R"({"severity": "off"})", R"("severity")", "an object of codes"},
        std::tuple{R"({"style": {}})", R"("style")", "`true` or `false`"},
        std::tuple{R"({"style": true,})", "}", "invalid JSON"},
        std::tuple{R"([])", "", "a JSON object"}, std::tuple{"", "", "invalid JSON"}}) {
    INFO(text);
    auto settings = report::parseSettings(text);
    REQUIRE_FALSE(settings);
    const auto& [said, whole, at] = settings.error();
    CHECK(whole.substr(at.begin, at.length()) == place);
    CHECK(said.find(words) != std::string::npos);
  }
}

TEST_CASE("the same words are shown once a minute, and few in all; the log has them all") {
  test::Pipe pipe;
  rpc::Outbox outbox(pipe);
  rpc::Peer peer(outbox);
  lsp::Announcer announcer(peer);
  const lsp::Announcer::Time start{};
  auto shown = [&](const std::string& words, std::chrono::seconds at) {
    announcer.show(lsp::Announcer::Kind::Warning, words, start + at);
    CHECK(pipe.receive()["method"] == "window/logMessage");
    return pipe.hasMore() && pipe.receive()["method"] == "window/showMessage";
  };
  CHECK(shown("a", 0s));
  CHECK_FALSE(shown("a", 59s));
  CHECK(shown("a", 60s));
  CHECK(shown("b", 61s));
  CHECK(shown("c", 62s));
  CHECK_FALSE(shown("d", 63s));
  CHECK(shown("d", 130s));
}

TEST_CASE("a file is parsed again only where it has changed") {
  auto disk = std::make_shared<CountingFiles>();
  std::optional<lsp::FileStamp> stamp = lsp::FileStamp{};
  const lsp::FileCache cache(disk, [&](const auto&) { return stamp; });
  auto first = cache.document("/a");
  CHECK(cache.document("/a")->isSameAs(*first));
  CHECK(disk->reads == 1);
  ++stamp->size;
  CHECK_FALSE(cache.document("/a")->isSameAs(*first));
  CHECK(disk->reads == 2);
  stamp.reset(); // undecided
  (void)cache.document("/a");
  (void)cache.document("/a");
  CHECK(disk->reads == 4);
}

TEST_CASE("of the trees those are kept that were used last, as many as there is room for") {
  auto disk = std::make_shared<CountingFiles>();
  const auto room = 2 * disk->read("")->size();
  disk->reads = 0;
  const lsp::FileCache cache(
      disk, [](const auto&) { return lsp::FileStamp{}; }, room);
  for (const auto* path : {"/a", "/b", "/a", "/c", "/a"}) (void)cache.document(path);
  CHECK(disk->reads == 3);
  (void)cache.document("/b"); // which had to give way to `/c`
  CHECK(disk->reads == 4);
}

TEST_CASE("a file that was changed just now is read again: its clock may be too coarse") {
  auto disk = std::make_shared<CountingFiles>();
  lsp::FileStamp stamp;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  stamp.modified = std::chrono::nanoseconds(now).count();
  const lsp::FileCache cache(disk, [&](const auto&) { return stamp; });
  (void)cache.document("/a");
  (void)cache.document("/a");
  CHECK(disk->reads == 2);
}

TEST_CASE("a link is followed again only where it leads to another file") {
  auto disk = std::make_shared<CountingFiles>();
  std::optional<lsp::FileStamp> stamp = lsp::FileStamp{};
  lsp::FileCache cache(disk, [&](const auto&) { return stamp; });
  CHECK(cache.canonical("/a") == "/b");
  ++stamp->modified;
  disk->end = "/c";
  CHECK(cache.canonical("/a") == "/b");
  CHECK(disk->follows == 1);
  ++stamp->inode;
  CHECK(cache.canonical("/a") == "/c");
  disk->end = "/d"; // the file was moved, and the link with it
  cache.followAnew();
  CHECK(cache.canonical("/a") == "/d");
  CHECK(disk->follows == 3);
  stamp.reset(); // the file does not exist
  CHECK(cache.canonical("/a") == "/d");
  CHECK(disk->follows == 4);
}
