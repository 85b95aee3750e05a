#include "fiacre/check/check.h"
#include "fiacre/format/format.h"
#include "fiacre/print/print.h"
#include "fiacre/syntax/parse.h"
#include "fuzz/targets.h"

#include <algorithm>
#include <string>

namespace proskill::fuzz {

namespace {

void problemsAreWithin(const fiacre::Parsed& parsed, std::string_view text) {
  for (const auto& problem : parsed.problems)
    expect(problem.begin <= problem.end && problem.end <= text.size(),
           "a problem is within the text");
  for (const auto& origin : parsed.provenance.origins)
    expect(origin.begin <= origin.end && origin.end <= text.size(), "an origin is within the text");
}

void isPrinted(const fiacre::Program& program) {
  const auto once = fiacre::print(program);
  const auto again = fiacre::parse(once);
  expect(again.problems.empty(), "what is printed can be read");
  expect(fiacre::print(again.program) == once, "what is printed is read as it was");
}

void isLaidOutOnce(std::string_view text) {
  const auto once = fiacre::format(text);
  expect(once.has_value(), "what can be read can be laid out");
  expect(std::ranges::equal(fiacre::tokenizeWithComments(text), fiacre::tokenizeWithComments(*once),
                            {}, &fiacre::Token::text, &fiacre::Token::text),
         "laying out changes white space alone");
  const auto again = fiacre::format(*once);
  expect(again == once, "what is laid out stays as it is");
}

} // namespace

void fiacre(std::string_view bytes) {
  const auto parsed = fiacre::parse(bytes);
  problemsAreWithin(parsed, bytes);
  for (const auto& problem : fiacre::check(parsed.program))
    expect(problem.origin < parsed.provenance.origins.size(), "a problem's origin is known");
  if (!parsed.problems.empty()) {
    expect(!fiacre::format(bytes), "what cannot be read is not laid out");
    return;
  }
  isPrinted(parsed.program);
  isLaidOutOnce(bytes);
}

} // namespace proskill::fuzz
