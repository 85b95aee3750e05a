#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// The constants, types and initial values around `skill[]`, the array with a record for each skill
/// and each parallel branch. A field that nothing in this model needs is left out.
class SkillTypes {
public:
  explicit SkillTypes(Context& context);

  /// The index of each cell, `None` and `root`.
  [[nodiscard]] std::vector<fiacre::Constant> constants() const;
  /// `skill_id`, `skill_status`, `skill_result`, `skill_record`, `skill_array`.
  [[nodiscard]] std::vector<fiacre::TypeDeclaration> types() const;
  /// The array at time 0: the mission and the monitors are called.
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
