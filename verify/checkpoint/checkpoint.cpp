#include "verify/checkpoint/checkpoint.h"

namespace proskill::verify {

Checkpoint::Checkpoint(CheckpointStore& of, LimitWatch& watch) : store(of), limits(watch) {
  if (!store.hasState()) return;
  reader.emplace([this] { return store.next(); });
  limits.addEarlier(static_cast<double>(reader->number()) / 1000);
}

void Checkpoint::save(const Write& search) {
  store.replace([&](const CheckpointStore::Put& put) {
    CheckpointWriter to(put);
    to.number(static_cast<std::uint64_t>(limits.seconds() * 1000));
    if (head) head(to);
    to.number(search ? 1 : 0);
    if (search) search(to);
    to.flush();
  });
}

std::string Checkpoint::endEarlier(std::uint64_t classes) {
  reader->end();
  std::string message = reader->message();
  reader.reset();
  if (!message.empty()) return cannotResume(message);
  store.resumed(classes);
  return {};
}

std::string cannotResume(const std::string& message) {
  return "the checkpoint cannot be used: " + message;
}

} // namespace proskill::verify
