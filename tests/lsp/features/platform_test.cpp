#include "disk/disk.h"
#include "lsp/server/capabilities.h"
#include "tests/lsp/support/session.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>

#include <mutex>

using namespace proskill;

namespace {

namespace fs = std::filesystem;

const std::string kRobotUri = "file:///w/mission.proskill";
const std::string kRobotMission = R"((defplatform "robot.json")
(defskill fly :action (fly) :success there)
(defskill mission :success done :body ((fly) (success done)))
)";

/// A platform file that others write.
class RobotFiles : public analysis::FileSystem {
public:
  std::expected<std::string, std::string> read(const fs::path& path) const override {
    const std::lock_guard lock(mutex);
    if (path != "/w/robot.json" || text.empty()) return std::unexpected("no such file");
    return text;
  }
  fs::path canonical(const fs::path& path) const override { return path.lexically_normal(); }
  std::vector<fs::path> filesBelow(const fs::path& folder, std::string_view) const override {
    return {folder / "a.json", folder / "robot" / "my.platform.json"};
  }
  void write(const std::string& now) {
    const std::lock_guard lock(mutex);
    text = now;
  }

private:
  mutable std::mutex mutex;
  std::string text;
};

struct NamedRobot {
  explicit NamedRobot(const std::string& platform, bool pull = false,
                      Json capabilities = Json::object())
      : session({.disk = files, .pull = pull, .capabilities = std::move(capabilities)}) {
    files->write(platform);
    session.initialize();
    session.open(kRobotUri, kRobotMission);
  }

  Json published() { return session.notified("textDocument/publishDiagnostics")["diagnostics"]; }
  void write(const std::string& platform) {
    files->write(platform);
    session.notify("workspace/didChangeWatchedFiles",
                   {{"changes", Json::array({{{"uri", "file:///w/robot.json"}, {"type", 2}}})}});
  }

  std::shared_ptr<RobotFiles> files = std::make_shared<RobotFiles>();
  test::Session session;
};

Json withRelatedPlaces() {
  return {{"textDocument", {{"publishDiagnostics", {{"relatedInformation", true}}}}}};
}

} // namespace

TEST_CASE("what is wrong with the platform of a program is published at its path") {
  NamedRobot robot("{\n \"actions\": {\"flie\": {}}}", false, withRelatedPlaces());
  const auto found = robot.published();
  REQUIRE(found.size() == 1);
  CHECK(found[0]["code"] == "PS1402");
  CHECK(found[0]["severity"] == 1);
  CHECK(found[0]["message"] == "`robot.json`:2:14: there is no basic skill `flie`");
  CHECK(found[0]["range"] == test::rangeOf(0, 14, 24));
  const auto& related = found[0]["relatedInformation"][0];
  CHECK(related["location"]["uri"] == "file:///w/robot.json");
  CHECK(related["location"]["range"] == test::rangeOf(1, 13, 13));
}

TEST_CASE("diagnostics follow a platform file on the disk") {
  NamedRobot robot("");
  auto found = robot.published();
  REQUIRE(found.size() == 1);
  CHECK(found[0]["message"] == "cannot read the platform `robot.json`: no such file");
  robot.write("{\"kind\": \"robot\"}");
  found = robot.published();
  REQUIRE(found.size() == 1);
  CHECK(found[0]["code"] == "PS1402");
  robot.write("{}");
  CHECK(robot.published().empty());
}

namespace {

const std::string kOpenUri = "file:///w/robot.json";

void openPlatform(NamedRobot& robot, const std::string& text) {
  robot.session.notify(
      "textDocument/didOpen",
      {{"textDocument",
        {{"uri", kOpenUri}, {"languageId", "json"}, {"version", 1}, {"text", text}}}});
}

void editPlatform(NamedRobot& robot, int version, const Json& change) {
  robot.session.notify("textDocument/didChange",
                       {{"textDocument", {{"uri", kOpenUri}, {"version", version}}},
                        {"contentChanges", Json::array({change})}});
}

/// The next diagnostics of the program and of the platform file, in whichever order they come.
struct Both {
  Json program;
  Json platform;
};

Both publishedBoth(NamedRobot& robot) {
  Both both;
  for (int i = 0; i < 2; ++i) {
    auto news = robot.session.notified("textDocument/publishDiagnostics");
    (news["uri"] == kOpenUri ? both.platform : both.program) = std::move(news["diagnostics"]);
  }
  return both;
}

} // namespace

TEST_CASE("diagnostics follow an open platform file while it is edited, in it, too") {
  NamedRobot robot("{}");
  CHECK(robot.published().empty());
  openPlatform(robot, "{\"actions\": {\"é\": {},\n \"flie\": {}}}");
  auto both = publishedBoth(robot);
  REQUIRE(both.program.size() == 2);
  CHECK(both.program[1]["message"] == "`robot.json`:2:2: there is no basic skill `flie`");
  REQUIRE(both.platform.size() == 2);
  CHECK(both.platform[0]["range"] == test::rangeOf(0, 13, 13));
  CHECK(both.platform[1]["range"] == test::rangeOf(1, 1, 1));
  CHECK(both.platform[1]["message"] == "there is no basic skill `flie`");
  CHECK(both.platform[1]["code"] == "PS1402");
  CHECK(both.platform[1]["severity"] == 1);
  editPlatform(robot, 2, {{"text", "{,}"}});
  both = publishedBoth(robot);
  CHECK(both.platform[0]["message"] == "it is not JSON");
  CHECK(both.program[0]["message"] == "`robot.json`:1:2: it is not JSON");
  editPlatform(robot, 3, {{"text", "{}"}});
  both = publishedBoth(robot);
  CHECK(both.platform == Json::array());
  CHECK(both.program == Json::array());
}

TEST_CASE("a platform file that is closed is that of the disk") {
  NamedRobot robot("{}");
  CHECK(robot.published().empty());
  openPlatform(robot, "[]");
  CHECK(publishedBoth(robot).platform.size() == 1);
  robot.session.notify("textDocument/didClose", {{"textDocument", {{"uri", kOpenUri}}}});
  const auto both = publishedBoth(robot);
  CHECK(both.platform == Json::array());
  CHECK(both.program == Json::array());
}

TEST_CASE("an edit of a part of a platform file, which was not asked for, ends its editing") {
  NamedRobot robot("{}");
  CHECK(robot.published().empty());
  openPlatform(robot, "[]");
  CHECK(publishedBoth(robot).program.size() == 1);
  editPlatform(robot, 2, {{"range", test::rangeOf(0, 0, 1)}, {"text", "{"}});
  CHECK(publishedBoth(robot).program == Json::array());
}

TEST_CASE("the texts of platform files are registered alone, as a whole") {
  const Json sync{{"dynamicRegistration", true}};
  const auto client = lsp::readClientFeatures({{"textDocument", {{"synchronization", sync}}}});
  const auto asked = lsp::registrationsFor(client);
  std::vector<std::string> methods;
  for (const auto& each : asked) {
    methods.push_back(each["method"]);
    CHECK(each["registerOptions"]["documentSelector"][0]["pattern"] ==
          "**/{platform,*.platform}.json");
  }
  CHECK(methods == std::vector<std::string>{"textDocument/didOpen", "textDocument/didChange",
                                            "textDocument/didClose"});
  CHECK(asked[1]["registerOptions"]["syncKind"] == 1);
}

TEST_CASE("diagnostics that are pulled have the platform's, too") {
  NamedRobot robot("[]", true);
  const auto answer =
      robot.session.result("textDocument/diagnostic", {{"textDocument", {{"uri", kRobotUri}}}});
  REQUIRE(answer["items"].size() == 1);
  CHECK(answer["items"][0]["message"] == "`robot.json`:1:1: it is not an object");
}

TEST_CASE("a JSON file on which nothing depends is ignored") {
  NamedRobot robot("{}");
  CHECK(robot.published().empty());
  robot.session.notify(
      "workspace/didChangeWatchedFiles",
      {{"changes", Json::array({{{"uri", "file:///w/other.json"}, {"type", 1}}})}});
  const auto symbols = robot.session.result("workspace/symbol", {{"query", ""}});
  for (const auto& symbol : symbols) CHECK(symbol["location"]["uri"] == kRobotUri);
  CHECK_FALSE(robot.session.wasNotified("textDocument/publishDiagnostics"));
}

TEST_CASE("the path of a platform leads to its file") {
  NamedRobot robot("{}");
  const auto links =
      robot.session.result("textDocument/documentLink", {{"textDocument", {{"uri", kRobotUri}}}});
  REQUIRE(links.size() == 1);
  CHECK(links[0]["target"] == "file:///w/robot.json");
  const auto definition = robot.session.at("textDocument/definition", kRobotUri, 0, 20);
  REQUIRE(definition.size() == 1);
  CHECK(definition[0]["uri"] == "file:///w/robot.json");
  CHECK(definition[0]["range"] == test::rangeOf(0, 0, 0));
  const auto skill = robot.session.at("textDocument/definition", kRobotUri, 2, 41);
  REQUIRE(skill.size() == 1);
  CHECK(skill[0]["uri"] == kRobotUri);
}

TEST_CASE("the hover of a platform's path says who performs the actions") {
  NamedRobot robot(R"({"kind": "ros1", "actions": {"fly": {"service": "/fly"}}})");
  const auto hover = robot.session.at("textDocument/hover", kRobotUri, 0, 16);
  CHECK(hover["range"] == test::rangeOf(0, 14, 24));
  const auto text = hover["contents"]["value"].get<std::string>();
  CHECK(text.find("An adapter to ROS 1 performs the actions.") != std::string::npos);
  CHECK(text.find("service") != std::string::npos);
  CHECK(text.find("/fly") != std::string::npos);
  robot.files->write("[]");
  CHECK(robot.session.at("textDocument/hover", kRobotUri, 0, 16).is_null());
}

TEST_CASE("the path of a platform is completed, platforms first") {
  NamedRobot robot("{}");
  robot.session.change(kRobotUri, 2, test::rangeOf(0, 14, 24), "");
  const auto items = robot.session.at("textDocument/completion", kRobotUri, 0, 14)["items"];
  REQUIRE(items.size() == 2);
  CHECK(items[0]["label"] == "robot/my.platform.json");
  CHECK(items[1]["label"] == "a.json");
}

TEST_CASE("files below a folder are those that the disk has, without hidden folders") {
  const test::TemporaryDirectory files;
  for (const auto* name : {"b.json", "a/c.json", "a/b/deep.json", ".git/d.json", "e.txt"}) {
    fs::create_directories(fs::path(files.path(name)).parent_path());
    files.write(name, "{}");
  }
  fs::create_directory(files.path("folder.json"));
  const disk::DiskFileSystem disk;
  CHECK(disk.filesBelow(files.path(), ".json") ==
        std::vector<fs::path>{files.path("a/c.json"), files.path("b.json")});
  CHECK(disk.filesBelow(files.path("nowhere"), ".json").empty());
}
