#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace proskill;
using test::Finished;

namespace {

/// Names that a terminal, a URI or XML would misinterpret.
const std::vector<std::string> kNames{"per%41cent",
                                      "two words",
                                      "a#b?c",
                                      "co:lon",
                                      "\x1b]0;owned\x07",
                                      "\x1b[31mred",
                                      "line\nbreak",
                                      "\xff\xfe",
                                      "\xc2\x9b"
                                      "31m",
                                      "quo\"te'<&>",
                                      "\xef\xbf\xbf",
                                      "ta\tb"};

/// It violates a property, so that the reports contain places.
constexpr const char* kProgram =
    "(defsv lamp :states (On Off) :init Off :transitions ((On Off)))\n"
    "(defskill s :start (lamp On) :action (a) :success ok)\n"
    "(defskill m :time_interval [5,6] :success ok :body ((s) (success ok)))\n";
constexpr const char* kMistaken = "(defskill s :start (lamp On))\n";

/// Control characters that a terminal obeys, as one byte or UTF-8; line ends are not among them.
bool obeyed(const std::string& text) {
  const bool c0 = std::ranges::any_of(
      text, [](char c) { return (c >= 0 && c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; });
  return c0 || text.find("\xc2\x9b") != std::string::npos;
}

std::string decoded(const std::string& uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    path +=
        uri[i] == '%' ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (uri[i] == '%') i += 2;
  }
  return path;
}

bool isPlainUri(const std::string& uri) {
  constexpr std::string_view kAllowed = "-._~/!$&'()*+,;=@%:";
  return std::ranges::all_of(uri, [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           kAllowed.contains(c);
  });
}

void collectUris(const nlohmann::json& json, std::vector<std::string>& uris) {
  if (json.is_object() && json.contains("artifactLocation"))
    uris.push_back(json["artifactLocation"]["uri"]);
  if (json.is_structured())
    for (const auto& part : json) collectUris(part, uris);
}

/// What a command prints on a terminal, on both streams.
std::string onTerminal(std::vector<std::string> words) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  REQUIRE(child >= 0);
  if (child == 0) {
    words.insert(words.begin(), PROSKILL_PROGRAM);
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    setenv("NO_COLOR", "1", 1);
    execv(PROSKILL_PROGRAM, arguments.data());
    _exit(127);
  }
  std::string text;
  char buffer[4096];
  for (ssize_t count; (count = read(terminal, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(count));
  close(terminal);
  waitpid(child, nullptr, 0);
  std::erase(text, '\r');
  return text;
}

} // namespace

TEST_CASE("SARIF names each file by a URI that leads back to it") {
  const test::TemporaryDirectory files;
  for (const auto& name : kNames)
    for (const char* command : {"check", "verify"}) {
      INFO(command << " " << name);
      const bool check = std::string(command) == "check";
      const auto path = files.write(name + ".proskill", check ? kMistaken : kProgram);
      const auto done = test::run({PROSKILL_PROGRAM, command, "--format", "sarif", path});
      CHECK(done.exitCode == 1);
      std::vector<std::string> uris;
      collectUris(nlohmann::json::parse(done.out), uris);
      CHECK_FALSE(uris.empty());
      for (const auto& uri : uris) {
        CHECK(isPlainUri(uri));
        CHECK(decoded(uri) == "file://" + path);
      }
    }
}

TEST_CASE("JUnit is XML whatever the file is called") {
  const test::TemporaryDirectory files;
  for (const auto& name : kNames) {
    INFO(name);
    const auto path = files.write(name + ".proskill", kProgram);
    const auto done = test::run({PROSKILL_PROGRAM, "verify", "--format", "junit", path});
    CHECK(done.exitCode == 1);
    const auto report = files.write("report.xml", done.out);
    const auto read =
        test::run({"/usr/bin/python3", "-c",
                   "import sys, xml.etree.ElementTree as x; x.parse(sys.argv[1])", report});
    CHECK(read.exitCode == 0);
    CHECK(read.err.empty());
  }
}

TEST_CASE("no name of a file and no argument reaches a terminal as a command to it") {
  const test::TemporaryDirectory files;
  for (const auto& name : kNames) {
    const auto good = files.write(name + ".proskill", kProgram);
    const auto bad = files.write(name + "bad.proskill", kMistaken);
    const auto model = files.write(name + ".fcr", "type t is");
    for (const auto& words :
         std::vector<std::vector<std::string>>{{"check", bad},
                                               {"check", "--format", "short", bad},
                                               {"check", good + "x"},
                                               {"check", model},
                                               {"fmt", "--check", good},
                                               {"fmt", "--diff", good},
                                               {"fmt", model},
                                               {"emit", "fiacre", good},
                                               {"emit", "fiacre", "-o", good + "/x", good},
                                               {"verify", good},
                                               {"verify", model},
                                               {"verify", "--property", name, good},
                                               {"graph", "--out-dir", files.path(name), good},
                                               {"graph", "--name", name, good},
                                               {"explain", name},
                                               {name},
                                               {"check", "--format", name, good},
                                               {"verify", "--time-limit", name, good},
                                               {"verify", "--" + name}}) {
      INFO(words.front() << " " << name);
      CHECK_FALSE(obeyed(onTerminal(words)));
      CHECK_FALSE(obeyed(test::run({PROSKILL_PROGRAM, "explain", name}).err));
    }
  }
}

TEST_CASE("the name of a file cannot end the comment that a model begins with") {
  const test::TemporaryDirectory files;
  const auto path = files.write("line\nbreak.proskill", kProgram);
  const auto done = test::run({PROSKILL_PROGRAM, "emit", "fiacre", path});
  CHECK(done.exitCode == 0);
  CHECK(test::run({PROSKILL_PROGRAM, "check", files.write("model.fcr", done.out)}).exitCode == 0);
}

TEST_CASE("a limit of time is a number of seconds") {
  const test::TemporaryDirectory files;
  const auto path = files.write("main.proskill", kProgram);
  for (const char* word : {"nan", "inf", "-inf", "-1", "0", "1e999", "1e10", "", "1s", "0x1p3x"}) {
    INFO(word);
    CHECK(test::run({PROSKILL_PROGRAM, "verify", std::string("--time-limit=") + word, path})
              .exitCode == 2);
  }
  CHECK(test::run({PROSKILL_PROGRAM, "verify", "--time-limit", "2.5e1", path}).exitCode == 1);
}

TEST_CASE("memory that is exhausted is reported as that, with what to do") {
  const test::TemporaryDirectory files;
  std::string text;
  while (text.size() < 100'000'000) text += "(defevent some_event_with_a_name) ; and why\n";
  const auto path = files.write("large.proskill", text);
  for (const char* command : {"check", "verify", "fmt --check"}) {
    INFO(command);
    const auto done =
        test::run({"/bin/sh", "-c",
                   "ulimit -v 120000; exec " PROSKILL_PROGRAM " " + (command + (" " + path))});
    CHECK(done.exitCode == 71);
    CHECK(done.err.find("error: out of memory") != std::string::npos);
    CHECK(done.err.find("--memory-limit") != std::string::npos);
  }
}
