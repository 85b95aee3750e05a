#include "verify/graph/spilled_classes.h"

#include "verify/graph/class_graph.h"
#include "verify/model/release.h"
#include "verify/state/state_layout.h"

namespace proskill::verify {

namespace {

// shares of the memory; CandidateRuns has another
constexpr std::uint64_t kShareOfItems = 6;
constexpr std::uint64_t kShareOfDomains = 4;
constexpr std::uint64_t kShareOfNoted = 16;
constexpr std::uint64_t kBytesOfNoted = 48; ///< about, for each entry of a set

} // namespace

/// Whether markings have domains is not known before.
SpilledClasses::SpilledClasses(const System& of, LimitWatch& watch, SpillSpace& in)
    : system(of),
      limits(watch),
      space(in),
      enabling(of),
      domains(of),
      format{.words = of.storedWords, .hasZones = true},
      candidates(in, format, domains.zones()),
      visited(in, format),
      possibleDomains(in, in.memoryBytes() / kShareOfItems) {}

std::expected<Exploration, Unsupported> SpilledClasses::run() {
  try {
    explore();
    countDomains();
  } catch (const LimitMet& limit) {
    result.stopped = limit.which;
  }
  if (!failure.message.empty()) return std::unexpected(failure);
  result.complete = result.stopped.empty();
  result.classes = visited.nodes();
  result.markings = visited.states();
  result.bytes = progress().bytes;
  result.spilledBytes = space.peakOnDisk();
  result.seconds = limits.seconds();
  return result;
}

/// \throw LimitMet
void SpilledClasses::explore() {
  const std::vector<Word> first = initialState(system);
  enabling.compute(first.data(), enabled);
  candidates.add(first.data(), domains.initial(signatureOf(enabled, system, enabling, domains)),
                 {});
  for (Run level = settle(); level->size() != 0 && failure.message.empty(); level = settle())
    expandLevel(*level);
}

SpilledClasses::Run SpilledClasses::settle() {
  candidates.writeRun();
  return visited.add(candidates, [](const StateGroup&, std::size_t) {});
}

/// \throw LimitMet
void SpilledClasses::expandLevel(const VisitedRun& level) {
  constexpr std::uint64_t kBetweenChecks = 64;
  VisitedRun::Cursor cursor(level);
  StateGroup group;
  for (std::uint64_t count = 0; failure.message.empty() && cursor.next(); ++count) {
    if (count % kBetweenChecks == 0)
      if (auto limit = limits.met(progress()); !limit.empty()) throw LimitMet{std::move(limit)};
    group.clear();
    group.state = cursor.entry().state;
    cursor.readZones(group);
    expand(group);
  }
}

void SpilledClasses::expand(const StateGroup& group) {
  forgetIfMany();
  pending.clear();
  for (std::size_t i = 0; i < group.size(); ++i)
    pending.push_back(domains.adopt({group.dimension, group.zone(i)}));
  state = group.state;
  state.resize(system.words);
  enabling.compute(state.data(), enabled);
  const std::uint32_t signature = signatureOf(enabled, system, enabling, domains);
  possible.clear();
  eachIn(enabled, [&](TransitionId transition) {
    if (!enabling.isBlocked(transition, enabled)) follow(signature, transition);
  });
  noteDomains();
}

/// Fires a transition from every pending class.
void SpilledClasses::follow(std::uint32_t signature, TransitionId transition) {
  next = state;
  nextEnabled = enabled;
  log.clear();
  const Outcome outcome = fire(system, transition, next.data(), log);
  if (outcome == Outcome::Failed)
    failure = {log.failure, log.origins.empty() ? 0 : log.origins.back()};
  if (outcome != Outcome::Done) return;
  possible.push_back(transition);
  for (auto part : system.transitions[transition].parts) {
    const auto& instance = system.instances[system.paths[part].instance];
    possible.push_back(
        static_cast<std::uint32_t>(readCell(system, instance.location, next.data())));
  }
  enabling.update(transition, next.data(), nextEnabled);
  const std::uint32_t after = signatureOf(nextEnabled, system, enabling, domains);
  for (const auto domain : pending) {
    const ZoneId there = domains.after(domain, signature, transition, after);
    if (there == kNone) continue;
    ++result.transitions;
    candidates.add(next.data(), there, {});
  }
}

/// Domains are counted with the sets of possible transitions and their targets.
void SpilledClasses::noteDomains() {
  const auto [set, isNew] = possibleSets.add(possible);
  if (isNew) notedBytes += kBytesOfNoted + possible.size() * sizeof possible[0];
  for (const auto domain : pending) noteDomain(set, domain);
}

void SpilledClasses::noteDomain(std::uint32_t set, ZoneId domain) {
  if (!noted.insert(std::uint64_t{set} << 32 | domain).second) return;
  notedBytes += kBytesOfNoted;
  const std::uint32_t dimension = domains.zones().dimension(domain);
  text.bytes.clear();
  text.number(possible.size());
  for (const auto number : possible) text.number(number);
  text.number(dimension);
  writeZone(text, dimension, domains.zones().matrix(domain));
  possibleDomains.add(0, text.bytes);
}

/// What is remembered to save time must not fill the memory.
void SpilledClasses::forgetIfMany() {
  const std::uint64_t bytes = domains.bytes() + domains.growth() + domains.signatureBytes();
  const bool isFull = bytes > space.memoryBytes() / kShareOfDomains;
  if (isFull || notedBytes > space.memoryBytes() / kShareOfNoted) {
    release(noted);
    possibleSets.clear();
    notedBytes = 0;
  }
  if (!isFull) return;
  candidates.writeRun(); // which has domains by their numbers
  domains.forget();
}

void SpilledClasses::countDomains() {
  possibleDomains.each([this](std::string_view) { ++result.domains; });
}

Progress SpilledClasses::progress() const {
  return {visited.nodes(), visited.states(), 0,
          candidates.bytes() + visited.bytes() + domains.bytes() + possibleDomains.bytes() +
              notedBytes,
          limits.seconds()};
}

std::expected<Exploration, Unsupported> countWithSpill(const System& system, LimitWatch& limits,
                                                       const Options& options) {
  auto bytes = options.spillBytes;
  if (!bytes) {
    auto counted = ClassGraph(system, limits).run();
    if (!counted) return counted;
    bytes = limits.bytesForDiskSearch(counted->stopped);
    if (!bytes) return counted;
  }
  SpillSpace space(*options.spill, limits, *bytes);
  return SpilledClasses(system, limits, space).run();
}

} // namespace proskill::verify
