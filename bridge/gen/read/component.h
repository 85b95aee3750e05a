#pragma once

#include "bridge/text/word.h"

#include <map>

/// Components of GenoM3, as their `.gen` files declare them.
namespace proskill::bridge::gen {

/// What matters of a type of the IDL: its scalar as ProSkill writes it (`int`, `nat`, `float`,
/// `bool`, or `string` for all that has no equivalent), and the members of a structure.
struct Type {
  std::string scalar = "string";
  std::map<std::string, Type, std::less<>> members;
  std::string element = "string"; ///< of an array, its scalar
};

struct Parameter {
  Word name;
  bool isInput = true; ///< `in` or `inout`
  std::string scalar;
};

/// A state to which a codel may lead: at once, or after a pause.
struct Step {
  Word state;
  bool pauses = false;
};

/// A codel with its states, which a function has none of.
struct Codel {
  Word function;
  std::vector<Word> states;
  std::vector<Step> steps;
};

enum class ServiceKind : std::uint8_t { Attribute, Function, Activity };

struct Service {
  ServiceKind kind = ServiceKind::Function;
  Word name;
  std::vector<Parameter> parameters;
  std::vector<Codel> codels;
  std::vector<Word> exceptions;
  std::vector<Word> interrupts; ///< the services that it ends when it starts
  std::vector<Word> before;     ///< the services that it must come before
  std::vector<Word> after;      ///< the services that it must come after
};

/// A component, or an interface that components provide.
struct Component {
  Word name;
  bool isInterface = false;
  std::vector<Word> provides; ///< with the interfaces that it extends
  std::vector<Service> services;
  std::vector<Word> exceptions; ///< that it declares
  std::size_t ports = 0;
  std::size_t tasks = 0;
};

} // namespace proskill::bridge::gen
