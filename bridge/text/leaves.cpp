#include "bridge/text/leaves.h"

#include "bridge/text/json_places.h"

#include "syntax/text/utf8.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace proskill::bridge {
namespace {

using Json = nlohmann::json;

constexpr double kLongest = 1e6;         // seconds
constexpr std::size_t kMostErrors = 100; // more of them help nobody
constexpr auto kSeconds = "must be a number of seconds, at most 1e6";

/// Whether a value is a time.
bool isSeconds(const Json& value) {
  return value.is_number() && value.get<double>() >= 0 && value.get<double>() <= kLongest;
}

/// The number as ProSkill writes it: at most three decimals. \pre it is a time
std::string seconds(const Json& value) {
  auto text = fmt::format("{:.3f}", value.get<double>());
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

} // namespace

/// Reads a text to its end, whatever is wrong in it.
class LeavesReader {
public:
  LeavesReader(const Json& json, JsonPlaces places) : json(json), places(std::move(places)) {}

  std::expected<Leaves, Errors> read() {
    for (const auto& [path, place] : places.repeated())
      errors.push_back({place, path + " is there twice"});
    for (const auto& [key, value] : json.items()) member(memberPath("", key), key, value);
    if (errors.empty()) return std::move(leaves);
    std::ranges::stable_sort(errors, {}, [](const Error& error) {
      return std::pair(error.place.line, error.place.column);
    });
    if (hidden > 0)
      errors.push_back({places.of({}), fmt::format("{} more errors are not shown", hidden)});
    return std::unexpected(std::move(errors));
  }

private:
  void member(const std::string& path, const std::string& key, const Json& value) {
    if (key == "tick") return tick(path, value);
    if (key != "leaves") return fail(path, "is not a field of this file");
    if (!value.is_object()) return fail(path, "must be an object");
    for (const auto& [name, fields] : value.items()) leaf(memberPath(path, name), name, fields);
  }

  void tick(const std::string& path, const Json& value) {
    if (!isSeconds(value)) return fail(path, kSeconds);
    leaves.tick = seconds(value);
    if (leaves.tick == "0") fail(path, "must be at least 0.001");
  }

  void leaf(const std::string& path, const std::string& name, const Json& fields) {
    if (!fields.is_object()) return fail(path, "must be an object");
    Leaf leaf;
    for (const auto& [key, value] : fields.items()) field(memberPath(path, key), key, value, leaf);
    leaves.known.emplace(name, leaf);
  }

  void field(const std::string& path, const std::string& key, const Json& value, Leaf& leaf) {
    if (key == "duration") return duration(path, value, leaf);
    if (key == "outcomes") return outcomes(path, value, leaf);
    if (key == "changes") return changes(path, value, leaf);
    if (key == "kind") return kind(path, value, leaf);
    fail(path, "is not a field of a leaf: these are `duration`, `outcomes`, `kind` and `changes`");
  }

  void duration(const std::string& path, const Json& value, Leaf& leaf) {
    if (!value.is_array() || value.size() != 2)
      return fail(path, "must be a list of two numbers, the second one possibly null");
    leaf.hasDuration = true;
    const bool isBounded = !value[1].is_null();
    const bool hasLeast = isSeconds(value[0]);
    const bool hasMost = isBounded && isSeconds(value[1]);
    if (!hasLeast) fail(path + "/0", kSeconds);
    if (isBounded && !hasMost) fail(path + "/1", kSeconds);
    if (hasLeast) leaf.least = seconds(value[0]);
    if (hasMost) leaf.most = seconds(value[1]);
    if (hasLeast && hasMost && value[0].get<double>() > value[1].get<double>())
      fail(path + "/1", "is less than the first number");
  }

  void outcomes(const std::string& path, const Json& value, Leaf& leaf) {
    if (!value.is_array() || value.empty())
      return fail(path, R"(must be a list of "success" and "failure")");
    leaf.succeeds = leaf.fails = false;
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i] == "success")
        leaf.succeeds = true;
      else if (value[i] == "failure")
        leaf.fails = true;
      else
        fail(fmt::format("{}/{}", path, i), R"(must be "success" or "failure")");
  }

  void changes(const std::string& path, const Json& value, Leaf& leaf) {
    if (!value.is_boolean()) return fail(path, "must be true or false");
    leaf.changes = value.get<bool>();
  }

  void kind(const std::string& path, const Json& value, Leaf& leaf) {
    if (value != "action" && value != "condition")
      return fail(path, R"(must be "action" or "condition")");
    leaf.isCondition = value == "condition";
  }

  void fail(const std::string& path, const std::string& message) {
    if (errors.size() >= kMostErrors)
      ++hidden;
    else
      errors.push_back({places.of(path), path + " " + message});
  }

  const Json& json;
  JsonPlaces places;
  Leaves leaves;
  Errors errors;
  std::size_t hidden = 0; ///< errors
};

std::string Leaf::interval() const {
  if (least == "0" && most.empty()) return "";
  return "[" + least + "," + (most.empty() ? "...[" : most + "]");
}

std::expected<Leaves, Errors> Leaves::read(std::string_view content,
                                           const std::filesystem::path& file) {
  const auto text = syntax::withoutByteOrderMark(content);
  const auto wrong = [&](std::size_t byte, const char* message) {
    return std::unexpected(Errors{{placeIn(text, byte, file), message}});
  };
  try {
    // Deep nesting cannot exhaust the stack: the parser has a stack of its own.
    const auto json = Json::parse(text);
    if (const auto end = text.find('\0'); end != std::string_view::npos) // the parser ends there
      return wrong(end, "the file is not JSON");
    if (!json.is_object()) return wrong(0, "the file must contain an object");
    return LeavesReader(json, JsonPlaces(text, file)).read();
  } catch (const Json::parse_error& error) {
    return wrong(error.byte == 0 ? 0 : error.byte - 1, "the file is not JSON");
  } catch (const Json::out_of_range& error) { // its message ends with the number in quotes
    const std::string_view message = error.what();
    const auto begin = message.find('\'') + 1;
    return wrong(text.find(message.substr(begin, message.rfind('\'') - begin)),
                 "the number is too large");
  }
}

void Leaves::assumeInstant(const std::string& type) {
  const auto [leaf, isNew] = known.try_emplace(type);
  if (isNew) used.insert(type); // the file does not have it
  if (!leaf->second.hasDuration) leaf->second.most = "0";
}

const Leaf& Leaves::of(const std::string& name, const std::string& type) const {
  for (const auto* key : {&name, &type})
    if (const auto found = known.find(*key); !key->empty() && found != known.end()) {
      used.insert(*key);
      return found->second;
    }
  return any;
}

std::vector<std::string> Leaves::unused() const {
  std::vector<std::string> names;
  for (const auto& [name, leaf] : known)
    if (!used.contains(name)) names.push_back(name);
  return names;
}

} // namespace proskill::bridge
