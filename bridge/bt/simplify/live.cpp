#include "bridge/bt/simplify/live.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <span>

namespace proskill::bridge::bt {
namespace {

/// A walk through the statements of a body in their order. It is repeated as long as it finds jumps
/// to labels that it has passed.
class Walk {
public:
  /// \param targets labels to which something jumps; gets those that are found
  explicit Walk(std::set<std::string>& targets) : targets(targets) {}

  Block block(std::span<const Form> statements) {
    Block live;
    std::string lost; // the comment of a statement that is omitted, for the one after it
    for (const auto& statement : statements) {
      if (statement.parts[0] == "label") isReached |= targets.contains(statement.parts[1].word);
      if (!isReached) continue;
      auto kept = translated(statement);
      if (kept.empty()) {
        lost += (lost.empty() ? "" : "\n") + statement.comment;
        continue;
      }
      if (kept.front().comment.empty()) kept.front().comment = lost;
      lost.clear();
      append(live, kept);
    }
    return live;
  }

private:
  Block translated(const Form& statement) {
    const auto& head = statement.parts[0];
    if (head == "label")
      return targets.contains(statement.parts[1].word) ? Block{statement} : Block{};
    if (head == "goto") targets.insert(statement.parts[1].word);
    if (head == "goto" || head == "success" || head == "failure") isReached = false;
    if (head == "if") return choice(statement);
    if (head == "//" || head == "race") return branches(statement);
    if (head == "^") return {wait(statement)};
    return {statement};
  }

  /// The arms whose tests can hold; what follows the first test that always holds is omitted.
  Block choice(const Form& statement) {
    Form live = list("if");
    bool isReachedAfter = false;
    bool isDecided = false;
    const auto& parts = statement.parts;
    for (std::size_t i = 0; i < parts.size() && !isDecided;) {
      const bool isElse = parts[i] == "else";
      const auto test = isElse ? Form("true") : parts[i + 1];
      const auto begin = i + (isElse ? 1 : 2);
      i = endOfArm(parts, begin);
      if (test == "false") continue;
      isReached = true;
      const auto inner = block(std::span(parts).subspan(begin, i - begin));
      isReachedAfter |= isReached;
      isDecided = test == "true";
      addArm(live, test, inner);
    }
    isReached = isReachedAfter || !isDecided;
    if (live.parts.size() == 1) return {};
    if (live.parts[1] == "else") return {live.parts.begin() + 2, live.parts.end()};
    live.comment = statement.comment;
    return {live};
  }

  static std::size_t endOfArm(const std::vector<Form>& parts, std::size_t begin) {
    auto end = begin;
    while (end < parts.size() && parts[end] != "elseif" && parts[end] != "else") ++end;
    return end;
  }

  static void addArm(Form& choice, const Form& test, const Block& statements) {
    if (test == "true" && statements.empty()) return;
    if (test == "true")
      choice.parts.emplace_back("else");
    else if (choice.parts.size() > 1)
      choice.parts.emplace_back("elseif");
    if (test != "true") choice.parts.push_back(test);
    append(choice.parts, statements);
  }

  /// `//` ends when all branches have ended, a race when one has.
  Block branches(const Form& statement) {
    Form live{std::vector<Form>{statement.parts[0]}};
    live.comment = statement.comment;
    const bool isRace = statement.parts[0] == "race";
    bool isReachedAfter = !isRace;
    for (std::size_t i = 1; i < statement.parts.size(); ++i) {
      isReached = true;
      live.parts.emplace_back(block(statement.parts[i].parts));
      isReachedAfter = isRace ? isReachedAfter || isReached : isReachedAfter && isReached;
    }
    isReached = isReachedAfter;
    return {live};
  }

  Form wait(const Form& statement) {
    const bool isEndless = statement.parts[1] == "false";
    const auto limit = std::ranges::find(statement.parts, Form(":timeout"));
    isReached = !isEndless;
    if (limit == statement.parts.end())
      return isEndless ? commented(list("^", "false"), statement) : statement;
    isReached = true;
    const auto after = static_cast<std::size_t>(limit - statement.parts.begin()) + 2;
    Form live(Block(statement.parts.begin(), limit + 2));
    append(live.parts, block(std::span(statement.parts).subspan(after)));
    isReached |= !isEndless;
    return commented(std::move(live), statement);
  }

  static Form commented(Form form, const Form& original) {
    form.comment = original.comment;
    return form;
  }

  std::set<std::string>& targets;
  bool isReached = true;
};

} // namespace

Block liveStatements(const Block& body) {
  std::set<std::string> targets;
  while (true) {
    const auto known = targets.size();
    auto live = Walk(targets).block(body);
    if (targets.size() == known) return live;
  }
}

} // namespace proskill::bridge::bt
