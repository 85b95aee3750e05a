#pragma once

#include "fiacre/print/print.h"
#include "fiacre/print/writer.h"

#include <string>
#include <vector>

/// Internals of the printer, shared by its files.
namespace proskill::fiacre {

/// In parentheses if it is compound.
std::string printOperand(const Expr& expr);
std::string printList(const std::vector<Expr>& exprs);

std::string printPort(const Port& port);
std::string printVariable(const Variable& variable);
std::string printParameters(const std::vector<Parameter>& parameters);
std::string join(const std::vector<std::string>& parts, std::string_view between);

/// The printed text so far, with the origins of its lines.
struct Output {
  Writer writer;
  std::vector<PrintedRange> ranges;
};

/// Records that the lines printed during its lifetime come from a place.
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
/// \param main the model's main component, with which paths begin
void printComponent(Output& out, const Component& component, const std::string& main);
[[nodiscard]] std::string printObservable(const Observable& observable, const std::string& main);
void printAttachments(Output& out, const Program& program);
void printProperty(Output& out, const Property& property, const std::string& main,
                   const PrintOptions& options);

/// Prints `var`: one variable per line if one has a comment, otherwise as many as fit.
void printVariables(Output& out, const std::vector<Variable>& variables, std::size_t indent);

} // namespace proskill::fiacre
