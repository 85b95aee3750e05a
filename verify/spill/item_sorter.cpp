#include "verify/spill/item_sorter.h"

#include <algorithm>
#include <tuple>

namespace proskill::verify {

namespace {

constexpr std::size_t kMostItemRuns = 32; ///< that are merged at once

} // namespace

ItemSorter::ItemSorter(SpillSpace& of, std::uint64_t bytes)
    : space(of), most(bytes), file(std::make_unique<PagedFile>(of)) {}

void ItemSorter::add(std::uint64_t number, std::string_view text) {
  places.push_back({number, texts.size(), static_cast<std::uint32_t>(text.size())});
  texts += text;
  // vectors that grow need twice as much for a moment
  if (2 * (texts.size() + places.size() * sizeof(Place)) >= most) writeRun();
}

void ItemSorter::sort() {
  const auto key = [&](const Place& it) { return std::tuple(it.number, textOf(it)); };
  std::ranges::sort(places, {}, key);
  const auto doubles = std::ranges::unique(places, {}, key);
  places.erase(doubles.begin(), doubles.end());
}

void ItemSorter::writeRun() {
  sort();
  const std::uint64_t begin = file->size();
  for (const auto& place : places) write(*file, place.number, textOf(place));
  places.clear();
  texts.clear();
  runs.push_back({begin, file->size()});
  if (runs.size() == kMostItemRuns) mergeRuns();
}

/// Replaces the runs by one.
void ItemSorter::mergeRuns() {
  auto merged = std::make_unique<PagedFile>(space);
  eachOfRuns([&](std::uint64_t number, std::string_view text) { write(*merged, number, text); });
  runs.assign(1, {0, merged->size()});
  file = std::move(merged);
}

void ItemSorter::write(PagedFile& to, std::uint64_t number, std::string_view text) {
  to.number(number);
  to.number(text.size());
  to.add(text);
}

void ItemSorter::advance(Cursor& cursor) {
  cursor.atEnd = cursor.reader.isAtEnd();
  if (cursor.atEnd) return;
  cursor.number = cursor.reader.number();
  cursor.text.clear();
  const std::uint64_t length = cursor.reader.number();
  cursor.reader.read(length, cursor.text);
}

void ItemSorter::eachOfRuns(const VisitItem& visit) const {
  std::vector<Cursor> cursors;
  for (const auto& run : runs) {
    cursors.push_back({.reader = PageReader(*file, run.begin, run.end), .text = {}});
    advance(cursors.back());
  }
  const auto key = [](const Cursor& it) {
    return std::tuple(it.atEnd, it.number, std::string_view(it.text));
  };
  std::string text;
  for (;;) {
    const auto first = std::ranges::min_element(cursors, {}, key);
    if (first == cursors.end() || first->atEnd) return;
    const std::uint64_t number = first->number;
    std::swap(text, first->text);
    advance(*first);
    for (auto& it : cursors)
      while (!it.atEnd && it.number == number && it.text == text) advance(it);
    visit(number, text);
  }
}

void ItemSorter::each(const Visit& visit) {
  if (runs.empty()) {
    sort();
    for (const auto& place : places) visit(textOf(place));
  } else {
    writeRun();
    eachOfRuns([&](std::uint64_t, std::string_view text) { visit(text); });
  }
  places.clear();
  texts.clear();
  runs.clear();
  file->clear();
}

} // namespace proskill::verify
