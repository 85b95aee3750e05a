#pragma once

#include "fiacre/print/print.h"
#include "fiacre/print/writer.h"

#include <string>
#include <vector>

/// The printer's own pieces, shared by its files.
namespace proskill::fiacre {

/// In parentheses where it is compound.
std::string printOperand(const Expr& expr);
std::string printList(const std::vector<Expr>& exprs);

std::string printPort(const Port& port);
std::string printVariable(const Variable& variable);
std::string printParameters(const std::vector<Parameter>& parameters);
std::string join(const std::vector<std::string>& parts, std::string_view between);

/// What is printed so far, and from where.
struct Output {
  Writer writer;
  std::vector<PrintedRange> ranges;
};

/// Notes that the lines written while it lives come from a place.
class Place {
public:
  Place(Output& output, OriginId origin);
  ~Place();
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

private:
  Output& out;
  std::size_t index;
};

void printStatement(Output& out, const Statement& statement, std::size_t indent);
void printDeclarations(Output& out, const Program& program);
void printProcess(Output& out, const Process& process);
void printFunction(Output& out, const Function& function);
/// \param main the model, with which paths begin
void printComponent(Output& out, const Component& component, const std::string& main);
[[nodiscard]] std::string printObservable(const Observable& observable, const std::string& main);
void printAttachments(Output& out, const Program& program);
void printProperty(Output& out, const Property& property, const std::string& main,
                   const PrintOptions& options);

/// `var` with one variable a line where one has a comment, else as many as fit.
void printVariables(Output& out, const std::vector<Variable>& variables, std::size_t indent);

} // namespace proskill::fiacre
