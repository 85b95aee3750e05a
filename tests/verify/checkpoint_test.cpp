#include "tests/support/checkpoint_in_memory.h"
#include "tests/support/models.h"
#include "tests/support/random/random_model.h"
#include "verify/checkpoint/checkpoint.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

constexpr std::uint64_t kSeeds = 12;

/// Questions that need nothing but the search.
std::vector<verify::Question> questionsOfStates(const fiacre::Program& program) {
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < program.properties.size(); ++i)
    if (program.properties[i].pattern.kind == fiacre::PatternKind::Absent) questions.push_back({i});
  return questions;
}

std::vector<verify::Question> allQuestions(const fiacre::Program& program) {
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < program.properties.size(); ++i) questions.push_back({i});
  return questions;
}

auto run(const fiacre::Program& program, verify::Options options,
         verify::CheckpointStore& checkpoint, bool onlyStates = false) {
  options.checkpoint = &checkpoint;
  if (!options.limits.classes) options.limits.classes = 20'000;
  return verify::verify(program, {},
                        onlyStates ? questionsOfStates(program) : allQuestions(program), options);
}

auto count(const fiacre::Program& program, verify::CheckpointStore& checkpoint,
           std::optional<std::uint64_t> classes = {}) {
  verify::Options options{.jobs = 2, .classesBeforeThreads = 0, .nodesBeforeThreads = 0};
  options.checkpoint = &checkpoint;
  options.limits.classes = classes;
  return verify::countClasses(program, options);
}

/// Calls a function with the state cut off and changed at every place.
void eachDamage(const std::string& state, const std::function<void(const std::string&)>& attempt) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    attempt(state.substr(0, i));
    for (const char change : {'\x01', '\x10', '\x80', '\xFF'}) {
      std::string damaged = state;
      damaged[i] = static_cast<char>(damaged[i] ^ change);
      attempt(damaged);
    }
  }
}

} // namespace

TEST_CASE("counting classes that is interrupted and resumed has the same counts") {
  std::size_t resumed = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto program = test::randomModel(seed);
    const auto plain = verify::countClasses(program, {.limits = {.classes = 5'000}});
    if (!plain || !plain->complete) continue;
    INFO("seed " << seed);
    std::string state;
    for (std::uint64_t limit = 1 + seed % 7;; limit += 1 + limit / 2 + seed % 5) {
      test::CheckpointInMemory store(static_cast<unsigned>(1 + seed % 3), seed);
      if (!state.empty()) store.give(state);
      const auto counted = count(program, store, limit);
      REQUIRE(counted);
      resumed += store.wasUsed ? 1 : 0;
      if (!store.saved.empty()) state = store.saved.back();
      if (!store.isFinished) continue;
      CHECK(counted->classes == plain->classes);
      CHECK(counted->markings == plain->markings);
      CHECK(counted->domains == plain->domains);
      CHECK(counted->transitions == plain->transitions);
      break;
    }
  }
  CHECK(resumed > 300);
}

// Files have a checksum, so the bytes that a search reads are those that were written. Reading must
// not depend on this; what is explored from a forged state may be anything, so nothing is.
TEST_CASE("reading a damaged state of a search is harmless even without its checksum") {
  std::size_t refused = 0;
  std::size_t tried = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const auto program = test::randomModel(seed);
    test::CheckpointInMemory store(8, seed);
    REQUIRE(run(program, {.classesBeforeSlices = 50}, store, true));
    const auto& states = store.saved;
    const auto largest = std::ranges::max_element(states, {}, &std::string::size);
    if (largest == states.end() || largest->size() > 600) continue;
    eachDamage(*largest, [&](const std::string& damaged) {
      test::CheckpointInMemory again;
      again.give(damaged);
      const auto result =
          run(program, {.classesBeforeSlices = 50, .limits = {.classes = 1}}, again, true);
      refused += result ? 0 : 1;
      ++tried;
    });
  }
  CHECK(tried > 2000);
  CHECK(refused > tried / 3);
}

TEST_CASE("a state with something after its end is refused") {
  test::CheckpointInMemory store(8, 1);
  REQUIRE(run(test::randomModel(1), {}, store));
  REQUIRE_FALSE(store.saved.empty());
  test::CheckpointInMemory other;
  other.give(store.saved.back() + "x");
  const auto result = run(test::randomModel(1), {}, other);
  REQUIRE_FALSE(result);
  CHECK(result.error().message.find("the checkpoint cannot be used") == 0);
}

TEST_CASE("limits may change from one process to the next") {
  const auto program = test::randomModel(3);
  test::CheckpointInMemory store;
  verify::Options options;
  options.limits.classes = 5;
  options.checkpoint = &store;
  REQUIRE(verify::verify(program, {}, allQuestions(program), options));
  REQUIRE_FALSE(store.saved.empty());
  CHECK_FALSE(store.isFinished);
  test::CheckpointInMemory again;
  again.give(store.saved.back());
  const auto second = run(program, {.jobs = 2, .classesBeforeThreads = 0}, again);
  REQUIRE(second);
  CHECK(again.isFinished);
}

TEST_CASE("the reported time includes that of earlier processes") {
  const verify::Options options;
  verify::LimitWatch earlier(options);
  earlier.addEarlier(5000);
  test::CheckpointInMemory store;
  verify::Checkpoint(store, earlier).save({});
  test::CheckpointInMemory again;
  again.give(store.saved.back());
  verify::LimitWatch later(options);
  const verify::Checkpoint resumed(again, later);
  CHECK(later.seconds() >= 5000);
}
