#include "verify/verify.h"

#include "verify/assistants.h"
#include "verify/explore/conclude.h"
#include "verify/ranks.h"
#include "verify/verification.h"

namespace proskill::verify {

namespace {

std::expected<Result, Unsupported> verifyAll(const fiacre::Program& program,
                                             const fiacre::Provenance& provenance,
                                             const std::vector<Question>& questions,
                                             const Options& options) {
  LimitWatch limits(options);
  Result result;
  result.answers.resize(questions.size());
  try {
    const auto compiled = compile(program, provenance, questions, &limits);
    if (!compiled) return std::unexpected(compiled.error());
    Verification verification(*compiled, provenance, questions, options, limits, result);
    if (auto failure = verification.run()) return std::unexpected(*failure);
  } catch (const LimitMet& limit) {
    giveUp(limit, result);
  }
  result.exploration.seconds = limits.seconds();
  return result;
}

} // namespace

std::expected<Result, Unsupported> verify(const fiacre::Program& program,
                                          const fiacre::Provenance& provenance,
                                          const std::vector<Question>& questions,
                                          const Options& options) {
  if (options.ranks && options.ranks->self() != 0)
    return assist(program, provenance, questions, options);
  auto result = verifyAll(program, provenance, questions, options);
  if (options.ranks) dismissAssistants(*options.ranks);
  return result;
}

} // namespace proskill::verify
