#include "embed/shared_platform.h"

#include <algorithm>

namespace proskill::embed {

using runtime::Nanoseconds;
using runtime::Report;
using runtime::RunNumber;

SharedPlatform::SharedPlatform(FunctionPlatform& functions) : own(functions) {
  watch.add(own.wakeUp.descriptor());
}

void SharedPlatform::add(std::unique_ptr<runtime::Platform> platform) {
  other = std::move(platform);
  std::vector<int> all;
  other->addDescriptors(all);
  for (const int each : all) watch.add(each);
}

runtime::Platform& SharedPlatform::performer(std::uint32_t action) {
  if (own.performs(action) || !other) return own;
  return *other;
}

void SharedPlatform::start(const runtime::Start& start, Nanoseconds date) {
  performer(start.action).start(start, date);
}

bool SharedPlatform::stop(std::uint32_t action, RunNumber run, Nanoseconds date) {
  return performer(action).stop(action, run, date);
}

void SharedPlatform::abandon(std::uint32_t action, RunNumber run, Nanoseconds date) {
  performer(action).abandon(action, run, date);
}

std::optional<Nanoseconds> SharedPlatform::next() const {
  const auto mine = own.next();
  const auto its = other ? other->next() : std::nullopt;
  return mine && its ? std::min(mine, its) : mine ? mine : its;
}

bool SharedPlatform::poll(Nanoseconds date, Report& report) {
  if (own.poll(date, report)) return true;
  if (!other || !other->poll(date, report)) return false;
  // The functions go on without the platform, whose actions fail from then on.
  return report.kind != runtime::ReportKind::Lost || !own.performsAny() || poll(date, report);
}

bool SharedPlatform::mayReport() const { return own.mayReport() || (other && other->mayReport()); }

void SharedPlatform::close() {
  own.close();
  if (other) other->close();
}

bool SharedPlatform::isClosed() const { return !other || other->isClosed(); }

} // namespace proskill::embed
