#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The constants, types and initial values for `skill[]`, the array with a record for each skill
/// and each parallel branch. Fields that the model does not need are omitted.
class SkillTypes {
public:
  explicit SkillTypes(Context& context);

  /// The index of each record, and `None` and `root`.
  [[nodiscard]] std::vector<fiacre::Constant> constants() const;
  /// `skill_id`, `skill_status`, `skill_result`, `skill_record`, `skill_array`.
  [[nodiscard]] std::vector<fiacre::TypeDeclaration> types() const;
  /// The initial array, in which the mission and the monitors are called.
  [[nodiscard]] fiacre::Expr initial() const;

private:
  struct Field {
    std::string name;
    fiacre::Type type;
    fiacre::Expr initial;
    std::string comment;
  };
  struct Cell {
    std::string name;
    bool root = false;
  };

  void findCells();
  void findFields();
  [[nodiscard]] fiacre::Type idType() const;

  Context& context;
  std::vector<Cell> cells;
  std::vector<Field> fields;
};

} // namespace proskill::codegen
