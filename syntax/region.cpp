#include "syntax/region.h"

#include "syntax/diagnostics/codes.h"
#include "syntax/recovery/recover.h"
#include "syntax/text/scan.h"
#include "syntax/tree/build.h"
#include "syntax/tree/form.h"
#include "syntax/tree/words.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace proskill::syntax {
namespace {

// People do not write larger or deeper programs; these would take too much memory and stack.
constexpr std::size_t kLargest = 1 << 20;
constexpr std::size_t kDeepest = 256;
constexpr std::size_t kMostDiagnostics = 200;
// tree-sitter 0.20 counts the children of a node in 16 bits, and consecutive comments are children.
constexpr std::size_t kMostComments = 1 << 14;

/// The parenthesis that exceeds the maximum depth, or null.
const Parenthesis* tooDeep(const Scan& scan) {
  std::size_t depth = 0;
  for (const Parenthesis& parenthesis : scan.parentheses) {
    if (!parenthesis.opens)
      depth -= depth > 0;
    else if (++depth > kDeepest)
      return &parenthesis;
  }
  return nullptr;
}

ReadForm unreadForm(std::string_view text) {
  ReadForm form;
  form.range = {0, static_cast<Offset>(text.size())};
  return form;
}

void blank(std::string& text, const std::vector<Range>& ranges) {
  for (Range range : ranges) std::fill_n(text.begin() + range.begin, range.length(), ' ');
}

void sortByPlace(std::vector<Diagnostic>& diagnostics) {
  std::ranges::stable_sort(diagnostics, {}, [](const Diagnostic& diagnostic) {
    return std::pair(diagnostic.location.range.begin, diagnostic.location.range.end);
  });
  if (diagnostics.size() > kMostDiagnostics)
    diagnostics.erase(diagnostics.begin() + kMostDiagnostics, diagnostics.end());
}

std::size_t problemsOf(Parser& parser, std::string_view text) {
  std::vector<Diagnostic> diagnostics;
  Builder builder{text, diagnostics};
  Tree tree = parser.parse(text);
  formsOf(builder, tree);
  return diagnostics.size();
}

/// Copies the forms to memory without gaps: lists that grow during parsing leave many.
std::vector<ReadForm> compactForms(Builder& builder, ParsedText& parsed) {
  std::pmr::monotonic_buffer_resource scratch;
  const auto grown = [&] {
    const ArenaScope inScratch(scratch);
    return formsOf(builder, parsed.tree);
  }();
  const ArenaScope inArena(parsed.arena);
  return std::vector<ReadForm>(grown);
}

/// Calls `work` in so many threads, the calling one among them, or in as many as the system has.
/// \throw what it has thrown in one of them
template <class Work> void inThreads(std::size_t count, const Work& work) {
  std::mutex guard;
  std::exception_ptr failure;
  const auto attempt = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(guard);
      failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    try {
      while (helpers.size() + 1 < count) helpers.emplace_back(attempt);
    } catch (const std::system_error&) {
      // no thread is left: the others do its part
    }
    attempt();
  }
  if (failure) std::rethrow_exception(failure);
}

} // namespace

ParsedRegion readRegion(Parser& parser, std::string_view text) {
  ParsedRegion region;
  auto owned = std::make_unique<ParsedText>();
  auto* const parsed = owned.get();
  region.parsed = std::move(owned);
  Builder builder{{}, region.diagnostics};
  if (text.size() > kLargest) {
    if (text.size() > kLongestRead)
      builder.report(Code::TextTooLong, {0, 1}, kLongestRead >> 20);
    else
      builder.report(Code::FormTooLarge, {0, 1}, kLargest >> 20);
    region.forms.push_back(unreadForm(text));
    return region;
  }
  parsed->text = text;
  cleanBytes(parsed->text, region.diagnostics);
  Scan scanned = scan(parsed->text);
  bool recovered = recoverStrings(parsed->text, scanned, region.diagnostics);
  if (recovered) scanned = scan(parsed->text);
  region.comments = scanned.comments;
  if (const Parenthesis* place = tooDeep(scanned)) {
    builder.report(Code::NestedTooDeep, {place->at, place->at + 1}, kDeepest);
    region.forms.push_back(unreadForm(text));
    return region;
  }
  if (region.comments.size() > kMostComments) blank(parsed->text, region.comments);
  auto judge = [&](std::string_view attempt) { return problemsOf(parser, attempt); };
  recovered |= recoverParentheses(parsed->text, scanned, judge, region.diagnostics);
  parsed->recovered = recovered;
  parsed->tree = parser.parse(parsed->text);
  parsed->tree.shrink_to_fit();
  checkWords(parsed->text, parsed->tree, region.diagnostics);
  // further errors in recovered forms may be consequences of the same one
  std::vector<Diagnostic> ignored;
  Builder forms{parsed->text, recovered ? ignored : region.diagnostics};
  region.forms = compactForms(forms, *parsed);
  for (ReadForm& form : region.forms) {
    form.recovered = recovered;
    form.bodyIndex = bodyIndexOf(form.node);
  }
  sortByPlace(region.diagnostics);
  return region;
}

std::vector<ParsedRegion> readRegions(const std::vector<std::string_view>& texts) {
  constexpr std::size_t kWorthAThread = 1 << 16; // bytes: some milliseconds of work
  std::size_t bytes = 0;
  for (auto text : texts) bytes += text.size();
  std::vector<ParsedRegion> regions(texts.size());
  std::atomic<std::size_t> next = 0;
  static const std::size_t cores =
      std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
  inThreads(1 + std::min(cores - 1, bytes / kWorthAThread), [&] {
    Parser parser;
    for (std::size_t i = next++; i < texts.size(); i = next++)
      regions[i] = readRegion(parser, texts[i]);
  });
  return regions;
}

} // namespace proskill::syntax
