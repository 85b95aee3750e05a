#include "tests/lsp/support/desk.h"
#include "tests/lsp/support/examples.h"
#include "tests/where.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace proskill;
using syntax::Encoding;
using syntax::Offset;
using test::Desk;
using test::example;
using test::examples;
using test::Files;

/// Requests every feature at every place of every example: as it is, partly typed, and with all
/// kinds of characters. No request may fail, every answer must fit its text, and scan/answers.txt
/// has the number of answers; `PROSKILL_UPDATE=1 test_lsp "scan*"` writes it. `PROSKILL_SCAN=full`
/// requests at every byte and for every prefix, which takes minutes.
namespace {

bool isSet(const char* name) { return std::getenv(name) != nullptr; }
const bool kFull = isSet("PROSKILL_SCAN");

std::vector<Offset> places(const std::string& text) { return test::placesIn(text, kFull); }

bool isNothing(const Json& answer) {
  if (answer.is_object() && answer.contains("error")) return true;
  const auto& items = rpc::memberAt(answer, {"items"});
  return answer.is_null() || answer.empty() || (items.is_array() && items.empty());
}

/// What distinguishes an answer from earlier ones: for lists of choices the labels, not their
/// targets.
std::string essenceOf(const Json& answer) {
  const auto& items = rpc::memberAt(answer, {"items"});
  if (!items.is_array() || items.empty() || !items[0].contains("label")) return answer.dump();
  std::string result;
  for (const auto& item : items) result += item["label"].dump();
  return result;
}

/// Counts requests to a method about a text, and the answers.
struct Tally {
  std::size_t asked = 0;
  std::size_t answered = 0;
  std::set<std::size_t> distinct;

  /// Whether this is the first answer of its kind.
  bool add(const Json& answer) {
    ++asked;
    if (isNothing(answer)) return false;
    ++answered;
    return distinct.insert(std::hash<std::string>()(essenceOf(answer))).second;
  }
};

using Tallies = std::map<std::string, Tally>;

/// Calls a method, and those that follow from each new answer.
void askAll(const Desk& desk, const std::string& file, const std::string& method, Offset at,
            Tallies& tallies) {
  INFO(file << ", byte " << at << ": " << method);
  try {
    if (!tallies[method].add(desk.ask(method, file, at))) return;
    for (const auto& [next, answer] : desk.followUps(method, file, at)) tallies[next].add(answer);
  } catch (const std::exception& problem) {
    FAIL(problem.what());
  }
}

Tallies scan(const Desk& desk, const std::string& file) {
  Tallies tallies;
  for (const auto& method : desk.methodsOfPlaces())
    for (auto at : places(desk.text(file))) askAll(desk, file, method, at, tallies);
  for (const auto& method : desk.methodsOfDocuments()) askAll(desk, file, method, 0, tallies);
  return tallies;
}

std::string linesOf(const std::string& name, const Tallies& tallies) {
  std::string result;
  for (const auto& [method, tally] : tallies)
    result += fmt::format("{:24} {:40} asked {:5}  answered {:5}  distinct {:5}\n", name, method,
                          tally.asked, tally.answered, tally.distinct.size());
  return result;
}

std::set<std::string> linesIn(const std::string& text) {
  std::set<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.insert(line);
  return result;
}

/// Replaces some letters in comments and strings by characters of two, three and four bytes, and
/// puts a message with such characters before the first statement of every body, on its line.
std::string widened(const std::string& text) {
  std::string result;
  bool inComment = false;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') inComment = inString = false;
    if (c == ';' && !inString) inComment = true;
    if (c == '"' && !inComment) inString = !inString;
    const bool prose = inComment || (inString && text[i - 1] != '%');
    if (prose && c == 'e')
      result += "é";
    else if (prose && c == 'a')
      result += "€";
    else if (prose && c == 't')
      result += "😀";
    else
      result += c;
    if (c == '(' && result.ends_with(":body\n    (")) result += "(printf \"😀é€𝄞\") ";
  }
  return result;
}

/// Puts each definition on one line, so that much follows wide characters. Removes comments.
std::string joined(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (auto comment = line.find(';'); comment != std::string::npos) line.resize(comment);
    result += line.starts_with('(') ? '\n' + line : line.empty() ? "" : ' ' + line;
  }
  return result;
}

} // namespace

TEST_CASE("scan: every feature at every place of every example") {
  std::string found;
  for (const auto& name : examples()) {
    const Desk desk(example(name), Encoding::Utf16);
    for (const auto& [file, text] : example(name))
      found += linesOf(name + "/" + file, scan(desk, file));
    Tallies ofWorkspace;
    for (const auto& method : desk.methodsOfWorkspaces())
      askAll(desk, example(name).begin()->first, method, 0, ofWorkspace);
    found += linesOf(name, ofWorkspace);
  }
  if (kFull) return;
  const auto* kept = PROSKILL_SOURCE_DIR "/tests/lsp/scan/answers.txt";
  if (isSet("PROSKILL_UPDATE")) std::ofstream(kept) << found;
  INFO("right? then PROSKILL_UPDATE=1 test_lsp \"scan*\" keeps it");
  const auto now = linesIn(found);
  const auto before = linesIn(test::contents(kept));
  std::vector<std::string> gone;
  std::vector<std::string> come;
  std::ranges::set_difference(before, now, std::back_inserter(gone));
  std::ranges::set_difference(now, before, std::back_inserter(come));
  CHECK(gone == std::vector<std::string>());
  CHECK(come == std::vector<std::string>());
}

TEST_CASE("scan: every feature while the examples are typed") {
  const std::size_t stride = kFull ? 1 : 41;
  for (const auto& name : examples())
    for (const auto& [file, text] : example(name)) {
      const auto all = places(text);
      for (std::size_t i = stride / 2; i < all.size(); i += stride) {
        auto files = example(name);
        files[file].resize(all[i]);
        const Desk desk(files, Encoding::Utf8);
        Tallies tallies;
        for (const auto& method : desk.methodsOfPlaces())
          askAll(desk, file, method, all[i], tallies);
        for (const auto& method : desk.methodsOfDocuments()) askAll(desk, file, method, 0, tallies);
      }
    }
}

TEST_CASE("scan: answers are the same bytes in every encoding") {
  for (const auto& name : {"arm", "drone"}) {
    Files files = example(name);
    for (auto& [file, text] : files) text = widened(file == "cell.proskill" ? text : joined(text));
    const Desk utf8(files, Encoding::Utf8);
    const Desk utf16(files, Encoding::Utf16);
    const Desk utf32(files, Encoding::Utf32);
    for (const auto& [file, text] : files) {
      auto same = [&](const std::string& method, Offset at) {
        const auto wanted = utf8.ask(method, file, at).dump();
        INFO(file << ", byte " << at << ": " << method);
        REQUIRE(utf16.ask(method, file, at).dump() == wanted);
        REQUIRE(utf32.ask(method, file, at).dump() == wanted);
      };
      const auto all = places(text);
      for (const auto& method : utf8.methodsOfPlaces())
        for (std::size_t i = 0; i < all.size(); i += kFull ? 1 : 3) same(method, all[i]);
      for (const auto& method : utf8.methodsOfDocuments()) same(method, 0);
    }
  }
}
