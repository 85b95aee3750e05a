#include "ide/fiacre/fiacre_names.h"

#include <utility>

namespace proskill::ide {

using fiacre::NameKind;

Look lookOf(NameKind kind) {
  switch (kind) {
  case NameKind::Function:
  case NameKind::Extern:
  case NameKind::Task:
  case NameKind::Process:
  case NameKind::Component:
  case NameKind::Foreign: return {TokenType::Skill, CompletionKind::Skill};
  case NameKind::Port:
  case NameKind::Event: return {TokenType::Event, CompletionKind::Event};
  case NameKind::Parameter: return {TokenType::Parameter, CompletionKind::Parameter};
  case NameKind::Type:
  case NameKind::Channel: return {TokenType::Type, CompletionKind::Type};
  case NameKind::Constant:
  case NameKind::Constructor: return {TokenType::Value, CompletionKind::Value};
  case NameKind::Property: return {TokenType::Property, CompletionKind::Field};
  case NameKind::Field: return {TokenType::Field, CompletionKind::Field};
  case NameKind::State: return {TokenType::Label, CompletionKind::Label};
  case NameKind::Tag: return {TokenType::Tag, CompletionKind::Tag};
  case NameKind::Variable:
  case NameKind::Value: return {TokenType::Variable, CompletionKind::Variable};
  }
  std::unreachable();
}

} // namespace proskill::ide
