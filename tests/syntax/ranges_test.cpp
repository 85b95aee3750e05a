#include "tests/support/marked_source.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Document;
using syntax::Range;

namespace {

/// The ranges that a test collects from a typed tree are the marked ones, in order.
struct Marked {
  test::MarkedSource source;
  Document document;
  std::vector<Range> found;

  explicit Marked(std::string_view text) : source(text), document(Document::parse(source.text)) {}
  template <class Node> [[nodiscard]] const Node& form() const {
    return std::get<Node>(document.forms().at(0).node());
  }
  void check() const {
    REQUIRE(test::codesOf(document) == "");
    REQUIRE(found.size() == source.ranges.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      INFO("range " << i << ": " << source.text.substr(found[i].begin, found[i].length()));
      CHECK(found[i].begin == source.ranges[i].begin);
      CHECK(found[i].end == source.ranges[i].end);
    }
  }
};

} // namespace

TEST_CASE("ranges of a state variable") {
  Marked marked("; ranges are absolute\n"
                "(defsv [[battery]] [[:states]] ([[Good]] [[Low]]) :init [[Good]] :transitions "
                "([[(Good Low)]]))");
  const auto& battery = marked.form<syntax::StateVariable>();
  marked.found = {battery.name.range,      battery.fields[0].keyword.range,
                  battery.states[0].range, battery.states[1].range,
                  battery.init.range,      battery.transitions[0].range};
  marked.check();
}

TEST_CASE("ranges of fields, keyword and value") {
  Marked marked("(defskill takeoff\n"
                "  [[[[:input]] ($height float)]]\n"
                "  [[[[:precondition]] (on_ground (flight_status OnGround))]] ; once\n"
                "  [[[[:success]] done (:effects (motion Free))]])");
  for (const auto& field : marked.form<syntax::Skill>().fields) {
    marked.found.push_back(field.range);
    marked.found.push_back(field.keyword.range);
  }
  marked.check();
}

TEST_CASE("ranges of a precondition, an action and an outcome") {
  Marked marked("(defskill takeoff\n"
                "  :precondition ([[on_ground]] [[(flight_status OnGround)]])\n"
                "  :time_interval [[ [1,3] ]]\n"
                "  :action ([[takeoff]] [[$height]])\n"
                "  :success [[done]] (:effects ([[motion]] [[Free]])))");
  const auto& skill = marked.form<syntax::Skill>();
  Range interval = skill.timeInterval->range;
  marked.found = {skill.preconditions[0].tag.range,
                  skill.preconditions[0].condition.range,
                  {interval.begin - 1, interval.end + 1},
                  skill.action->command.range,
                  skill.action->arguments[0].range,
                  skill.successes[0].tag.range,
                  skill.successes[0].effects.items[0].variable.range,
                  skill.successes[0].effects.items[0].value.range};
  marked.check();
}

TEST_CASE("ranges of statements and of their parts") {
  Marked marked("(defskill mission :body (\n"
                "  ([[takeoff]] [[height]] [[3.0]])\n"
                "  ([[if]] (= [[takeoff]].[[status]] [[success]])\n"
                "     [[([[camera]].[[interrupt]])\n"
                "     (landing)]]\n"
                "   [[elseif]] [[(battery Low)]] (landing)\n"
                "   [[else]] [[break]])\n"
                "  (printf \"[[%d]]\" [[level]])\n"
                "  (// [[((x))]] [[((y))]])))");
  const auto& body = marked.form<syntax::Skill>().body->statements;
  const auto& arms = body.at(1).arms;
  const auto& comparison = *arms.at(0).condition;
  const auto& interrupt = arms[0].body.statements.at(0);
  marked.found = {body[0].head.range,
                  body[0].arguments.at(0).name.range,
                  body[0].arguments[0].value.range,
                  body[1].head.range,
                  comparison.operands[0].name.range,
                  comparison.operands[0].member.range,
                  comparison.operands[1].range,
                  arms[0].body.range,
                  interrupt.name.range,
                  interrupt.head.range,
                  arms[1].keyword,
                  arms[1].condition->range,
                  arms[2].keyword,
                  arms[2].body.range,
                  body[2].format.range,
                  body[2].arguments.at(0).value.range,
                  body[3].branches.at(0).range,
                  body[3].branches[1].range};
  marked.check();
}

TEST_CASE("ranges of a property") {
  Marked marked("(defproperty [[p]] [[([[leadsto]] [[(a B)]] (running [[s]]) [[:within]] "
                "[[ [0,1] ]])]])");
  const auto& property = marked.form<syntax::Property>();
  Range within = property.within->range;
  marked.found = {property.name.range,
                  property.bodyRange,
                  property.head.range,
                  property.operands[0].range,
                  property.operands[1].name.range,
                  property.fields[0].keyword.range,
                  {within.begin - 1, within.end + 1}};
  marked.check();
}

TEST_CASE("a form reaches from its parenthesis to its parenthesis") {
  Marked marked("[[(defevent a :effects (x Y))]] ; end\n\n  [[(defevent b :effects (x Z))]]\n");
  for (const auto& form : marked.document.forms()) marked.found.push_back(form.range);
  marked.check();
}
