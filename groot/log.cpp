#include "groot/log.h"

#include "groot/bytes.h"
#include "groot/statuses.h"

namespace proskill::groot {

namespace {

constexpr std::string_view kMagic = "BTCPP4-FileLogger2";
constexpr std::uint64_t kLogVersion = 1;

std::uint64_t inMicroseconds(std::uint64_t nanoseconds) { return nanoseconds / 1000; }

class Log final : public runtime::Observer {
public:
  Log(Tree of, const runtime::Executable& executable, std::function<void(std::string_view)> to,
      std::uint64_t start)
      : tree(std::move(of)),
        add(std::move(to)),
        statuses(tree, executable, [this](Uid uid, Status status) {
          addChange(changes, time, uid, static_cast<std::uint8_t>(status));
        }) {
    const auto xml = xmlOf(tree);
    std::string head(kMagic);
    addBytes(head, kLogVersion, 1);
    addBytes(head, xml.size(), 4);
    head += xml;
    addBytes(head, inMicroseconds(start), 8);
    add(head + changes);
  }

  void onStep(const runtime::Machine& machine, verify::TransitionId, runtime::Nanoseconds date,
              runtime::Nanoseconds) override {
    changes.clear();
    time = inMicroseconds(static_cast<std::uint64_t>(date));
    statuses.follow(machine.state().data());
    if (!changes.empty()) add(changes);
  }
  void onRemark(const runtime::Remark&) override {}

private:
  const Tree tree;
  const std::function<void(std::string_view)> add;
  std::uint64_t time = 0;
  std::string changes; ///< of the current step
  Statuses statuses;   ///< the last member, since it uses the others
};

} // namespace

std::unique_ptr<runtime::Observer> logOf(Tree tree, const runtime::Executable& executable,
                                         std::function<void(std::string_view)> add,
                                         std::uint64_t start) {
  return std::make_unique<Log>(std::move(tree), executable, std::move(add), start);
}

} // namespace proskill::groot
