#include "groot/protocol.h"

#include "groot/bytes.h"
#include "verify/state/evaluate.h"
#include "verify/state/state_layout.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <random>

namespace proskill::groot {

namespace {

using Json = nlohmann::json;

constexpr char kProtocol = 2;
constexpr std::size_t kHead = 6;
constexpr std::size_t kMostChanges = 1000;

Parts error(std::string_view message) { return {"error", std::string(message)}; }

/// The values of variables. \param prefix of their names, which is removed
Json values(const runtime::Executable& executable, const std::vector<verify::Word>& state,
            std::string_view prefix) {
  auto board = Json::object();
  for (std::size_t i = 0; i < executable.shownVariables; ++i) {
    const auto& watched = executable.system.watched[i];
    if (!watched.display.starts_with(prefix)) continue;
    const auto value = verify::readCell(executable.system, watched.cell, state.data());
    const auto word = static_cast<std::size_t>(value - executable.system.cells[watched.cell].low);
    auto& entry = board[watched.display.substr(prefix.size())];
    if (word < watched.words.size())
      entry = watched.words[word];
    else
      entry = value;
  }
  return board;
}

} // namespace

TreeId randomTreeId() {
  std::random_device source;
  TreeId id{};
  for (auto& byte : id) byte = static_cast<std::uint8_t>(source());
  id[6] = (id[6] & 0x0F) | 0x40; // version 4
  id[8] = (id[8] & 0x3F) | 0x80; // its variant
  return id;
}

Protocol::Protocol(const Tree& of, const runtime::Executable& by, Hooks& with, TreeId as)
    : tree(of),
      executable(by),
      hooks(with),
      id(as),
      xml(xmlOf(of)),
      state(verify::initialState(by.system)),
      statuses(of, by, [this](Uid uid, Status status) { record(uid, status); }) {}

void Protocol::follow(const verify::Word* after, Moment moment) {
  std::copy_n(after, state.size(), state.begin());
  now = moment.time;
  if (moment.isAfterGap)
    statuses.jump(after);
  else
    statuses.follow(after);
}

void Protocol::record(Uid uid, Status status) {
  if (!recording) return;
  changes.push_back({now - std::min(now, *recording), uid, status});
  if (changes.size() > kMostChanges) changes.pop_front();
}

Parts Protocol::answer(const Parts& request, std::uint64_t time, std::uint64_t date) {
  if (request.empty() || request.front().size() != kHead) return error("wrong request header");
  hooks.hear(time);
  Parts reply{request.front()};
  reply.front()[0] = kProtocol;
  reply.front().append(id.begin(), id.end());
  const bool hasText = request.size() == 2;
  switch (request.front()[1]) {
  case 'T': reply.push_back(xml); return reply;
  case 'S': return statusReply(std::move(reply));
  case 'B':
    if (!hasText) return error("must be 2 parts message");
    return blackboards(std::move(reply), request[1]);
  case 'r':
    if (!hasText) return error("must be 2 parts message");
    return toggleRecording(std::move(reply), request[1], time, date);
  case 't': return recorded(std::move(reply));
  case 'D':
  case 'A':
  case 'X':
  case 'I':
  case 'R':
  case 'U': return answerOnHooks(request, std::move(reply));
  default: return error("Request not recognized");
  }
}

/// Requests about breakpoints.
Parts Protocol::answerOnHooks(const Parts& request, Parts reply) {
  const auto letter = request.front()[1];
  if (letter == 'D') reply.push_back(hooks.dump());
  if (letter == 'A') hooks.removeAll();
  if (letter == 'X') hooks.disableAll();
  if (letter == 'D' || letter == 'A' || letter == 'X') return reply;
  if (request.size() != 2) return error("must be 2 parts message");
  const auto& text = request[1];
  const auto why = letter == 'I'   ? hooks.insert(text)
                   : letter == 'R' ? hooks.remove(text)
                                   : hooks.unlock(text);
  return why.empty() ? reply : error(why);
}

Parts Protocol::stopMessage(Uid uid, std::uint32_t number) {
  std::string head{kProtocol, 'N'};
  addBytes(head, number, 4);
  return {std::move(head), std::to_string(uid)};
}

Parts Protocol::statusReply(Parts reply) const {
  auto& text = reply.emplace_back();
  Uid uid = 0;
  for (const auto byte : statuses.bytes()) {
    addBytes(text, ++uid, 2);
    addBytes(text, byte, 1);
  }
  return reply;
}

/// The root's blackboard has all variables, that of another instance the fields of its skill.
Parts Protocol::blackboards(Parts reply, std::string_view names) const {
  auto all = Json::object();
  for (const auto& instance : tree.instances) {
    const auto& block = tree.blockOf(instance);
    const bool isRoot = instance.parent == kNoInstance;
    const auto& name = isRoot ? block.name : instance.path;
    for (auto rest = names; !rest.empty();) {
      const auto end = std::min(rest.find(';'), rest.size());
      if (rest.substr(0, end) == name)
        all[name] = values(executable, state, isRoot ? "" : block.name + ".");
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  const auto packed = Json::to_msgpack(all);
  reply.emplace_back(packed.begin(), packed.end());
  return reply;
}

Parts Protocol::toggleRecording(Parts reply, std::string_view word, std::uint64_t time,
                                std::uint64_t date) {
  if (word != "start" && word != "stop") return error("neither `start` nor `stop`");
  recording.reset();
  if (word == "stop") return reply;
  recording = time;
  changes.clear();
  reply.push_back(std::to_string(date));
  return reply;
}

Parts Protocol::recorded(Parts reply) {
  auto& text = reply.emplace_back();
  for (const auto& [at, uid, status] : changes)
    addChange(text, at, uid, static_cast<std::uint8_t>(status));
  changes.clear();
  return reply;
}

} // namespace proskill::groot
