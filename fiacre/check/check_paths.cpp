#include "fiacre/check/check_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace proskill::fiacre {
namespace {

/// What a path has done so far.
enum Done : unsigned { kNothing = 0, kWaited = 1, kCommunicated = 2 };

/// The open paths, as the set of what each has done; a bit for each value of `Done`.
using Paths = std::uint8_t;
constexpr Paths kNone = 0;
constexpr Paths kStart = 1U << kNothing;

bool someHas(Paths paths, Done done) {
  for (unsigned each = 0; each < 4; ++each)
    if ((paths >> each & 1U) != 0 && (each & done) != 0) return true;
  return false;
}

Paths andThen(Paths paths, Done done) {
  unsigned after = 0;
  for (unsigned each = 0; each < 4; ++each)
    if ((paths >> each & 1U) != 0) after |= 1U << (each | done);
  return static_cast<Paths>(after);
}

bool isCommunication(const Statement& s) {
  return s.kind == StatementKind::Send || s.kind == StatementKind::Receive;
}

bool isNothing(const Statement& s) {
  if (s.kind == StatementKind::Sequence) return std::ranges::all_of(s.children, isNothing);
  return s.kind == StatementKind::Null || s.kind == StatementKind::Comment;
}

bool hasCommunication(const Statement& s) {
  return isCommunication(s) || std::ranges::any_of(s.children, hasCommunication);
}

/// Statements that only compute; loops, functions and `init` may contain no others.
bool isPlain(StatementKind kind) {
  switch (kind) {
  case StatementKind::Null:
  case StatementKind::Comment:
  case StatementKind::Assign:
  case StatementKind::If:
  case StatementKind::Case:
  case StatementKind::Sequence:
  case StatementKind::While:
  case StatementKind::Foreach: return true;
  case StatementKind::Any:
  case StatementKind::On:
  case StatementKind::Wait:
  case StatementKind::To:
  case StatementKind::Loop:
  case StatementKind::Select:
  case StatementKind::Send:
  case StatementKind::Receive:
  case StatementKind::Tag:
  case StatementKind::Start:
  case StatementKind::Sync:
  case StatementKind::Return: return false;
  }
  std::unreachable();
}

template <class Allowed>
void checkPlain(const Statement& s, std::string_view where, const Report& report, Allowed allowed) {
  if (!isPlain(s.kind) && !allowed(s.kind))
    report.from(s.origin)(fmt::format("{} may only compute", where));
  for (const auto& child : s.children) checkPlain(child, where, report, allowed);
}

Paths follow(const Statement& s, Paths paths, const Report& report);

Paths followWait(Paths paths, const Report& report) {
  if (someHas(paths, kWaited)) report("a path waits twice");
  if (someHas(paths, kCommunicated)) report("a path waits and communicates");
  return andThen(paths, kWaited);
}

Paths followPort(Paths paths, const Report& report) {
  if (someHas(paths, kCommunicated)) report("a path communicates twice");
  if (someHas(paths, kWaited)) report("a path waits and communicates");
  return andThen(paths, kCommunicated);
}

Paths followBranches(const Statement& s, Paths paths, const Report& report) {
  Paths after = kNone;
  for (const auto& child : s.children) after |= follow(child, paths, report);
  return after;
}

Paths followSelect(const Statement& s, Paths paths, const Report& report) {
  if (!s.priorityGroups.empty() && hasCommunication(s))
    report("a select with `unless` communicates");
  return followBranches(s, paths, report);
}

Paths followSequence(const Statement& s, Paths paths, const Report& report) {
  for (const auto& child : s.children) paths = follow(child, paths, report);
  return paths;
}

Paths followOne(const Statement& s, Paths paths, const Report& report) {
  switch (s.kind) {
  case StatementKind::To:
  case StatementKind::Loop: return kNone;
  case StatementKind::Wait: return followWait(paths, report);
  case StatementKind::Send:
  case StatementKind::Receive: return followPort(paths, report);
  case StatementKind::Sequence: return followSequence(s, paths, report);
  case StatementKind::Select: return followSelect(s, paths, report);
  case StatementKind::Case: return followBranches(s, paths, report);
  case StatementKind::If: {
    const auto after = followBranches(s, paths, report);
    return s.children.size() < 2 ? after | paths : after;
  }
  case StatementKind::While:
  case StatementKind::Foreach:
    checkPlain(s.children[0], "a loop", report, [](auto) { return false; });
    return paths;
  case StatementKind::Return: report("`return` is only allowed in a function"); return kNone;
  case StatementKind::Null:
  case StatementKind::Comment:
  case StatementKind::Assign:
  case StatementKind::Any:
  case StatementKind::On:
  case StatementKind::Tag:
  case StatementKind::Start:
  case StatementKind::Sync: return paths;
  }
  std::unreachable();
}

Paths follow(const Statement& s, Paths paths, const Report& report) {
  const auto here = report.from(s.origin);
  if (paths == kNone) {
    if (!isNothing(s)) here("unreachable statement after `to` or `loop`");
    return kNone;
  }
  return followOne(s, paths, here);
}

bool alwaysReturns(const Statement& s) {
  switch (s.kind) {
  case StatementKind::Return: return true;
  case StatementKind::Sequence: return std::ranges::any_of(s.children, alwaysReturns);
  case StatementKind::If:
    return s.children.size() == 2 && std::ranges::all_of(s.children, alwaysReturns);
  case StatementKind::Case: return std::ranges::all_of(s.children, alwaysReturns);
  case StatementKind::Null:
  case StatementKind::Comment:
  case StatementKind::Assign:
  case StatementKind::Any:
  case StatementKind::On:
  case StatementKind::Wait:
  case StatementKind::To:
  case StatementKind::Loop:
  case StatementKind::Select:
  case StatementKind::Send:
  case StatementKind::Receive:
  case StatementKind::Tag:
  case StatementKind::Start:
  case StatementKind::Sync:
  case StatementKind::While:
  case StatementKind::Foreach: return false;
  }
  std::unreachable();
}

} // namespace

void checkPaths(const Statement& statement, const Report& report) {
  if (follow(statement, kStart, report) != kNone) report("a path must end with `to` or `loop`");
}

void checkInit(const Statement& statement, const Report& report) {
  checkPlain(statement, "`init`", report,
             [](StatementKind kind) { return kind == StatementKind::To; });
}

void checkReturns(const Statement& body, const Report& report) {
  checkPlain(body, "a function", report,
             [](StatementKind kind) { return kind == StatementKind::Return; });
  if (!alwaysReturns(body)) report("a path ends without `return`");
}

} // namespace proskill::fiacre
