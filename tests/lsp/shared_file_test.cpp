#include "analysis/flow/inspect.h"
#include "ide/description/diagnostics.h"
#include "lsp/workspace/file_cache.h"
#include "tests/support/memory_files.h"
#include "tests/support/random/random_edits.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <array>
#include <set>

using namespace proskill;

/// Edits a file that many programs include: the findings are those of a fresh check of each
/// program.
namespace {

using Files = std::map<std::string, std::string>;
using Said = std::set<std::string>;

constexpr int kMissions = 12;
constexpr const char* kPlatform = "/w/platform.proskill";
constexpr const char* kText =
    "(defsv lamp :states (On Off) :init Off :transitions ((Off On)))\n"
    "(defevent dusk :effects (lamp On))\n"
    "; Lights it.\n"
    "(defskill light :input ($speed float) :start (lamp On) :time_interval [1,3]\n"
    "  :action (light $speed) :success lit :failure broken)\n"
    "(defskill wait :time_interval [2,2] :action (wait) :success done)\n"
    "(defskill both :success done :body ((light speed 1.5) (wait) (success done)))\n";

std::string missionPath(int i) { return fmt::format("/w/mission_{}.proskill", i); }

/// They use different parts of the platform, and one uses none.
Files files() {
  constexpr std::array kCalls{"(light speed 2.0)", "(wait)", "(both)", ""};
  Files result;
  for (int i = 0; i < kMissions; ++i) {
    const auto* call = kCalls[static_cast<std::size_t>(i) % kCalls.size()];
    result[missionPath(i)] = fmt::format("(include \"platform.proskill\")\n"
                                         "(include \"own_{0}.proskill\")\n"
                                         "(defskill main_{0} :success done :body ({1} (own_{0}) "
                                         "(if (lamp On) (own_{0})) (success done)))\n",
                                         i, call);
    result[fmt::format("/w/own_{}.proskill", i)] =
        fmt::format("(defskill own_{} :action (own) :success done)\n", i);
  }
  return result;
}

std::string said(const syntax::Diagnostic& it) {
  return fmt::format("{} {} {}-{} {}", syntax::info(it.code).id, static_cast<int>(it.severity),
                     it.location.range.begin, it.location.range.end, it.message);
}

/// By checking every program with the file.
Said checked(const Files& files, const std::string& path) {
  Said result;
  for (int i = 0; i < kMissions; ++i) {
    const auto program = analysis::load(test::MemoryFiles(files), missionPath(i));
    for (const auto& each : analysis::flow::inspect(program))
      if (program.files[each.location.file].path == path) result.insert(said(each));
  }
  return result;
}

Said told(const ide::Snapshot& snapshot, const std::string& path) {
  Said result;
  for (const auto& finding : ide::diagnostics(snapshot, path))
    CHECK(result.insert(said(*finding.diagnostic)).second);
  return result;
}

/// An editor that has the platform open, and the missions in its folder.
class Editor {
public:
  explicit Editor(std::size_t room)
      : disk(std::make_shared<lsp::FileCache>(
            std::make_shared<test::MemoryFiles>(::files()),
            [](const auto&) { return lsp::FileStamp{}; }, room)) {
    std::vector<ide::IncludeGraph::File> known;
    for (const auto& [path, text] : ::files())
      known.push_back(std::make_shared<const ide::KnownFile>(
          ide::knownFile(*disk, path, path, syntax::Document::parse(text))));
    graph = std::make_shared<const ide::IncludeGraph>(std::move(known));
    put(syntax::Document::parse(kText));
    current = std::make_shared<const ide::Snapshot>(disk, texts, graph);
  }

  void edit(const syntax::TextEdit& edit) {
    put(document().edit(edit.range, edit.text));
    current = current->with(texts, graph);
  }
  [[nodiscard]] const ide::Snapshot& snapshot() const { return *current; }
  [[nodiscard]] const syntax::Document& document() const { return texts.at(kPlatform).document; }

private:
  void put(syntax::Document document) {
    const auto* known = graph->find(kPlatform);
    if (!known || !ide::includesAsBefore(*known, document))
      graph = graph->with(ide::knownText(*disk, kPlatform, kPlatform, document));
    texts[kPlatform] = {"file:///w/platform.proskill", 1, std::move(document)};
  }

  std::shared_ptr<lsp::FileCache> disk;
  ide::OpenTexts texts;
  std::shared_ptr<const ide::IncludeGraph> graph;
  std::shared_ptr<const ide::Snapshot> current;
};

void compare(const Editor& editor, test::RandomEdits& edits) {
  auto all = files();
  all[kPlatform] = editor.document().text();
  INFO("of\n" << editor.document().text());
  CHECK(told(editor.snapshot(), kPlatform) == checked(all, kPlatform));
  const auto mission = missionPath(static_cast<int>(edits.pick(kMissions)));
  if (edits.pick(4) == 0) CHECK(told(editor.snapshot(), mission) == checked(all, mission));
}

} // namespace

TEST_CASE("what is told of a file of many programs is what a fresh check of each of them tells") {
  // With enough memory for all trees, and with so little that they are read again and again.
  for (const std::size_t room : {std::size_t{1} << 20, std::size_t{500}})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      Editor editor(room);
      test::RandomEdits edits(seed);
      for (int i = 0; i < 40; ++i) {
        const auto& text = editor.document().text();
        auto next = edits.pick(2) == 0 ? edits.touch(text) : edits.any(text);
        if (edits.pick(6) == 0) next = {{0, static_cast<syntax::Offset>(text.size())}, kText};
        INFO("seed " << seed << ", edit " << i << " at " << next.range.begin << "-"
                     << next.range.end << ": " << next.text);
        editor.edit(next);
        if (edits.pick(4) == 0) (void)editor.snapshot().view(kPlatform).owner->flow();
        if (edits.pick(3) != 0) compare(editor, edits);
      }
    }
}

TEST_CASE("of the programs of a file only that one keeps its flow which features look into") {
  Editor editor(1 << 20);
  const auto before = told(editor.snapshot(), kPlatform);
  CHECK_FALSE(before.empty());
  const auto views = editor.snapshot().views(kPlatform);
  REQUIRE(views.size() == kMissions);
  for (const auto& view : views)
    CHECK((view.owner->flowIfKnown() != nullptr) == (&view == &views.front()));
  editor.edit({{0, 0}, "; a comment\n"});
  CHECK(told(editor.snapshot(), kPlatform).size() == before.size());
  for (const auto& view : editor.snapshot().views(kPlatform)) {
    const bool isFirst = view.owner->program.files.front().path == missionPath(0);
    CHECK((view.owner->flowIfKnown() != nullptr) == isFirst);
    CHECK(view.owner->flow()); // clients that request it get it
  }
}
