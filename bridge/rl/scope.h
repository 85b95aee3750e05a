#pragma once

#include "bridge/rl/read/skillset.h"
#include "bridge/text/form.h"
#include "bridge/text/names.h"

namespace proskill::bridge::rl {

/// The resources of one skillset by name, and conditions and effects over them.
class Scope {
public:
  explicit Scope(Errors& errors) : errors(errors) {}

  /// \param name of the state variable that the resource becomes
  void add(const Resource& resource, std::string name);

  /// The name that a state has in the program; reports an unknown one.
  std::string stateOf(const Word& resource, const Word& state);
  Form condition(const Expr& expr);
  Form effects(const Effects& all);

private:
  struct Known {
    std::string name;
    std::map<std::string, std::string> states;
  };
  Known* find(const Word& resource);
  Form comparison(const Expr& expr);

  Errors& errors;
  std::map<std::string, Known> resources;
};

} // namespace proskill::bridge::rl
