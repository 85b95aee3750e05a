#include "runtime/control/signal_inbox.h"

namespace proskill::runtime {

namespace {

class WithInbox final : public Platform {
public:
  WithInbox(Platform& of, SignalInbox& with, bool mayWait)
      : inner(of), inbox(with), waits(mayWait) {}

  void start(const Start& start, Nanoseconds date) override { inner.start(start, date); }
  bool stop(std::uint32_t action, RunNumber run, Nanoseconds date) override {
    return inner.stop(action, run, date);
  }
  void abandon(std::uint32_t action, RunNumber run, Nanoseconds date) override {
    inner.abandon(action, run, date);
  }

  [[nodiscard]] std::optional<Nanoseconds> next() const override {
    return inbox.waiting() > 0 ? 0 : inner.next();
  }

  bool poll(Nanoseconds date, Report& report) override {
    if (!inbox.take(report.signal)) return inner.poll(date, report);
    report.kind = ReportKind::Signal;
    report.date = date;
    return true;
  }

  [[nodiscard]] bool mayReport() const override { return waits || inner.mayReport(); }
  void close() override { inner.close(); }
  [[nodiscard]] bool isClosed() const override { return inner.isClosed(); }
  void addDescriptors(std::vector<int>& all) const override { inner.addDescriptors(all); }

private:
  Platform& inner;
  SignalInbox& inbox;
  bool waits;
};

} // namespace

bool SignalInbox::send(std::uint32_t signal) {
  const std::lock_guard lock(senders);
  const bool sent = queue.push([&](std::uint32_t& to) { to = signal; });
  wakeUp.ring();
  return sent;
}

bool SignalInbox::take(std::uint32_t& signal) {
  return queue.pop([&](std::uint32_t from) { signal = from; });
}

std::unique_ptr<Platform> withInbox(Platform& inner, SignalInbox& inbox, bool waits) {
  return std::make_unique<WithInbox>(inner, inbox, waits);
}

} // namespace proskill::runtime
