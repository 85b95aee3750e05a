#include "runtime/platform/ros_words.h"

#include <algorithm>

namespace proskill::runtime {

const std::string& wordAt(const Json& value, const std::string& key, const std::string& of) {
  if (!value.contains(key)) throw Wrong{of + ": `" + key + "` is missing", &value};
  const auto& word = stringAt(value, key);
  if (word.empty()) throw Wrong{of + ": `" + key + "` must not be empty", &word};
  return word;
}

const std::string& typeAt(const Json& value, const std::string& of, Ros ros,
                          const std::string& kind) {
  const auto& type = wordAt(value, "type", of);
  const auto middle = ros == Ros::One ? std::string("/") : "/" + kind + "/";
  const auto found = type.find(middle);
  const auto slashes = ros == Ros::One ? 1 : 2;
  if (found == 0 || found == std::string::npos || found + middle.size() == type.size() ||
      (ros == Ros::Two && std::ranges::count(type, '/') != slashes))
    throw Wrong{of + ": the type `" + type + "` must have the form package" + middle + "Type",
                &type};
  return type;
}

Json conditionOf(const Json& value, const std::string& of) {
  Json condition = Json::object();
  for (const char* bound : {"below", "above"}) {
    if (!value.contains(bound)) continue;
    if (!value[bound].is_number())
      throw Wrong{of + ": `" + bound + "` must be a number", &value[bound]};
    condition[bound] = value[bound];
  }
  if (!value.contains("equals")) return condition;
  if (!value["equals"].is_primitive() || value["equals"].is_null())
    throw Wrong{of + ": `equals` must be a number, a string, true or false", &value["equals"]};
  condition["equals"] = value["equals"];
  return condition;
}

double inSeconds(const Json& value, const std::string& of) {
  return static_cast<double>(secondsOf(value, of)) / static_cast<double>(kSecond);
}

} // namespace proskill::runtime
