// Expressions: their values, how they are checked, and how they are completed.
#include "debug/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "debug/completion.h"
#include "debug/expression_names.h"
#include "recorded_frames.h"

namespace talus::debug_expression_test {

using testing::ElementsAre;

// Body 1 falls from y = 10 by 2, then stands. Body 3 is to its right. The tests look at the last of three
// frames.
class Expressions : public testing::Test {
 protected:
  Expressions()
      : source_({state_of({body_at(1, 4, 10, {0, 2}), body_at(3, 40, 0)}),
                 state_of({body_at(1, 4, 12, {0, 2}), body_at(3, 40, 0)}),
                 state_of({body_at(1, 4, 14, {4, -3}), body_at(3, 43, 0)})}) {
    Frame& last = source_.frames[2];
    last.state.bodies[0].gait.grounded = true;
    last.input = {.mouse = {5, 6}, .mouse_down = true, .left = false, .right = true, .jump = false};
    ContactRecord floor;
    floor.body = 1;
    floor.other = {.role = TileRole::solid, .cell = {12, 9}, .body = 0, .box = {96, 72, 8, 8}};
    floor.normal = {0, -1};
    floor.handled = true;
    ContactRecord slope = floor;
    slope.other = {.role = TileRole::up_slope, .cell = {3, 4}, .body = 0, .box = {24, 32, 16, 8}};
    slope.normal = {-0.6, -0.8};
    slope.slope = SlopeProbe{slope.other, 0.25, 38, 30, slope.normal, true};
    ContactRecord other = floor;
    other.other = {.role = TileRole::ball, .cell = {}, .body = 3, .box = {}};
    ContactRecord curve = floor;
    curve.other = {.role = TileRole::solid, .cell = {}, .body = 0, .box = {}, .curve = 2};
    ContactRecord crossed = floor;
    crossed.other.cell = {7, 7};
    crossed.response = Response::cross;
    last.record.contacts = {floor, other, curve, crossed, slope};
    last.record.paths = {{.body = 1, .from = {}, .goal = {}, .to = {}, .limited = true, .capped = false}};
    history_.go_to(source_, 2);
  }

  double value(std::string_view text, int body = 1, std::size_t back = 0) const {
    const auto expression = Expression::parse(text);
    if (!expression) {
      ADD_FAILURE() << text << ": " << expression.error().message;
      return -1;
    }
    return expression->evaluate(history_.view(), body, back);
  }

  MadeFrames source_;
  FrameHistory history_{2};
};

TEST_F(Expressions, OperatorsBindAsInC) {
  EXPECT_EQ(value("1 + 2 * 3"), 7);
  EXPECT_EQ(value("(1 + 2) * 3"), 9);
  EXPECT_EQ(value("10 - 4 - 3"), 3);
  EXPECT_EQ(value("16 / 4 / 2"), 2);
  EXPECT_EQ(value("7 % 4 * 2"), 6);
  EXPECT_EQ(value("-7 % 4"), -3);
  EXPECT_EQ(value("--2 - -1"), 3);
  EXPECT_EQ(value("1 < 2 == 3 > 2"), 1);
  EXPECT_EQ(value("true || true && false"), 1);
  EXPECT_EQ(value("(true || true) && false"), 0);
  EXPECT_EQ(value("!false && !(1 >= 2)"), 1);
  EXPECT_EQ(value("1 <= 1 && 1 != 2 && !(1 != 1)"), 1);
  EXPECT_EQ(value("true != false"), 1);
  EXPECT_EQ(value(" .5e1\n+\t1. "), 6);
}

TEST_F(Expressions, Functions) {
  EXPECT_EQ(value("abs(-3)"), 3);
  EXPECT_EQ(value("min(2, 1) + max(2, 5)"), 6);
  EXPECT_EQ(value("floor(-0.5)"), -1);
  EXPECT_EQ(value("ceil(0.1)"), 1);
  EXPECT_EQ(value("round(-2.5)"), -3);
  EXPECT_EQ(value("sqrt(9)"), 3);
}

TEST_F(Expressions, NamesOfTheBodyStandAloneOrAfterIt) {
  EXPECT_EQ(value("x"), 4);
  EXPECT_EQ(value("body.x"), 4);
  EXPECT_EQ(value("body.x", 3), 43);
  EXPECT_EQ(value("body(3).x"), 43);
  EXPECT_EQ(value("body(id + 2).x - x"), 39);
  EXPECT_EQ(value("right"), 12);
  EXPECT_EQ(value("bottom"), 22);
  EXPECT_EQ(value("w + h"), 16);
  EXPECT_EQ(value("vx"), 4);
  EXPECT_EQ(value("body.vy"), -3);
  EXPECT_EQ(value("speed"), 5);
  EXPECT_EQ(value("id"), 1);
  EXPECT_EQ(value("grounded"), 1);
  EXPECT_EQ(value("contacts"), 4);
  EXPECT_EQ(value("normal.x"), -0.6);
  EXPECT_EQ(value("body.normal.y"), -0.8);
  EXPECT_NEAR(value("normal.angle"), -36.87, 0.01);
  EXPECT_EQ(value("slope_delta"), 0.25);
  EXPECT_EQ(value("limited && !capped"), 1);
}

TEST_F(Expressions, FrameAndInput) {
  EXPECT_EQ(value("frame"), 2);
  EXPECT_EQ(value("input.right && input.mouse && !input.left && !input.jump"), 1);
  EXPECT_EQ(value("input.mouse.x * 10 + input.mouse.y"), 56);
}

TEST_F(Expressions, Contacts) {
  EXPECT_EQ(value("touches(12, 9)"), 1);
  EXPECT_EQ(value("touches(9, 12)"), 0);
  EXPECT_EQ(value("touches(12, 9)", 3), 0) << "of another body";
  EXPECT_EQ(value("body(1).touches(12, 9)", 3), 1);
  EXPECT_EQ(value("touches(7, 7)"), 0) << "only crossed";
  EXPECT_EQ(value("touches(4, 4)"), 1) << "the second cell of a wide slope";
  EXPECT_EQ(value("touches(5, 4)"), 0) << "beside the slope";
  EXPECT_EQ(value("touches(0, 0)"), 0) << "bodies and curves have no cell";
  EXPECT_EQ(value("touches_body(3)"), 1);
  EXPECT_EQ(value("touches_body(0)"), 0);
  EXPECT_EQ(value("touches_curve(2)"), 1);
  EXPECT_EQ(value("touches_curve(-1)"), 0);
}

TEST_F(Expressions, Places) {
  EXPECT_EQ(value("in_cell(0, 1)"), 1);
  EXPECT_EQ(value("in_cell(1, 2)"), 1);
  EXPECT_EQ(value("in_cell(2, 2)"), 0);
  EXPECT_EQ(value("in_rect(12, 14, 5, 5)"), 0) << "touching sides do not overlap";
  EXPECT_EQ(value("in_rect(11.5, 14, 5, 5)"), 1);
  EXPECT_EQ(value("in_cell(5, 0) && body(3).enters_cell(6, 0)", 3), 1);
  EXPECT_EQ(value("body(3).in_cell(5, 0) && !body(3).enters_cell(5, 0)"), 1);
  EXPECT_EQ(value("enters_rect(50, 0, 10, 10)", 3), 1);
  EXPECT_EQ(value("enters_rect(50, 0, 10, 10)", 3, 1), 0);
}

TEST_F(Expressions, LookBack) {
  EXPECT_EQ(value("y - before(y)"), 2);
  EXPECT_EQ(value("before(before(y))"), 10);
  EXPECT_EQ(value("before(before(before(y)))"), 10) << "before frame 0 there is frame 0";
  EXPECT_EQ(value("changed(vy)"), 1);
  EXPECT_EQ(value("before(changed(vy))"), 0);
  EXPECT_EQ(value("changed(grounded) && before(!grounded)"), 1);
  EXPECT_EQ(value("vy", 1, 1), 2);
  EXPECT_EQ(value("before(vy)", 1, 2), 2);
}

TEST_F(Expressions, AMissingValueMakesComparisonsFalse) {
  EXPECT_TRUE(std::isnan(value("normal.x", 3)));
  EXPECT_TRUE(std::isnan(value("body(2).x + 1")));
  EXPECT_TRUE(std::isnan(value("body(1.5).x")));
  EXPECT_TRUE(std::isnan(value("min(body(2).x, 1)")));
  EXPECT_TRUE(std::isnan(value("max(1, body(2).x)")));
  EXPECT_TRUE(std::isnan(value("x", 0)));
  EXPECT_TRUE(std::isnan(value("parting"))) << "nothing to compare with";
  for (const char* comparison : {"<", "<=", ">", ">=", "==", "!="})
    EXPECT_EQ(value("body(2).x " + std::string(comparison) + " 1"), 0) << comparison;
  EXPECT_EQ(value("body(2).grounded"), 0);
  EXPECT_EQ(value("changed(slope_delta)"), 1) << "from nothing to a number";
  EXPECT_EQ(value("before(changed(slope_delta))"), 0) << "nothing stays nothing";
  EXPECT_EQ(value("1 / 0"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(value("0 / 0")));
  EXPECT_TRUE(std::isnan(value("sqrt(-1)")));
}

TEST_F(Expressions, KnowWhichValuesTheyNeed) {
  EXPECT_TRUE(Expression::parse("vy > 3")->asks_body());
  EXPECT_TRUE(Expression::parse("body(id).vy > 3")->asks_body());
  EXPECT_FALSE(Expression::parse("body(3).vy > frame")->asks_body());
  EXPECT_EQ(Expression::parse("1")->frames_before(), 0);
  EXPECT_EQ(Expression::parse("before(x) + before(before(x))")->frames_before(), 2);
  EXPECT_EQ(Expression::parse("changed(enters_cell(1, 1))")->frames_before(), 2);
  EXPECT_EQ(Expression::parse("before(grounded)")->type(), ValueType::truth);
  EXPECT_EQ(Expression::parse("before(x)")->type(), ValueType::number);
}

// "POSITION: MESSAGE" of a wrong expression.
std::string problem(std::string_view text) {
  const auto expression = Expression::parse(text);
  if (expression) return "none";
  return std::to_string(expression.error().position) + ": " + expression.error().message;
}

TEST(ExpressionErrors, NameThePlaceAndTheMistake) {
  EXPECT_EQ(problem(""), "0: the expression is empty");
  EXPECT_EQ(problem("  "), "0: the expression is empty");
  EXPECT_EQ(problem("1 +"), "3: expected a value at the end");
  EXPECT_EQ(problem("1 + * 2"), "4: expected a value before '*'");
  EXPECT_EQ(problem("(1 + 2"), "6: expected ')'");
  EXPECT_EQ(problem("1 2"), "2: '2' comes after the end of the expression");
  EXPECT_EQ(problem("x = 1"), "2: '=' is not a comparison; write '=='");
  EXPECT_EQ(problem("grounded & capped"), "9: '&' is not an operator; write '&&'");
  EXPECT_EQ(problem("grounded | capped"), "9: '|' is not an operator; write '||'");
  EXPECT_EQ(problem("x @ 1"), "2: unexpected character '@'");
  EXPECT_EQ(problem("x > \xc3\xbc"), "4: unexpected character");
  EXPECT_EQ(problem("1e999"), "0: the number is too large or too small for a double");
  EXPECT_EQ(problem("3x"), "1: a letter follows the number directly");
  EXPECT_EQ(problem(std::string(1001, '1')), "1000: the expression is longer than 1000 bytes");
}

TEST(ExpressionErrors, CoverNames) {
  EXPECT_EQ(problem("body.vz > 1"), "0: unknown name 'body.vz'; did you mean 'body.vy'?");
  EXPECT_EQ(problem("1 < gruonded"), "4: unknown name 'gruonded'; did you mean 'grounded'?");
  EXPECT_EQ(problem("body(2).spede > 1"), "8: unknown name 'spede'; did you mean 'speed'?");
  EXPECT_EQ(problem("banana"), "0: unknown name 'banana'");
  EXPECT_EQ(problem("body.frame"), "0: unknown name 'body.frame'");
  EXPECT_EQ(problem("body"), "0: 'body' needs a name after it, as in 'body.x'");
  EXPECT_EQ(problem("body(1)"), "7: expected a name of the body, as in 'body(1).x'");
  EXPECT_EQ(problem("body(true).x"), "0: 'body' needs a number, not a truth value");
  EXPECT_EQ(problem("touches"), "0: 'touches' needs arguments: touches(column, row)");
  EXPECT_EQ(problem("touches(1)"), "0: 'touches' takes 2 arguments, not 1");
  EXPECT_EQ(problem("abs(1, 2)"), "0: 'abs' takes 1 argument, not 2");
  EXPECT_EQ(problem("abs()"), "0: 'abs' takes 1 argument, not 0");
  EXPECT_EQ(problem("min(1 2)"), "6: expected ')' or ','");
  EXPECT_EQ(problem("vy(1)"), "2: 'vy' takes no arguments");
}

TEST(ExpressionErrors, CoverTypes) {
  EXPECT_EQ(problem("grounded + 1"),
            "9: '+' needs a number on both sides, but has a truth value on its left");
  EXPECT_EQ(problem("vy && grounded"),
            "3: '&&' needs a truth value on both sides, but has a number on its left");
  EXPECT_EQ(problem("1 < vy < 2"), "7: '<' needs a number on both sides, but has a truth value on its left");
  EXPECT_EQ(problem("grounded || vy"),
            "9: '||' needs a truth value on both sides, but has a number on its right");
  EXPECT_EQ(problem("grounded == 1"), "9: '==' compares a truth value with a number");
  EXPECT_EQ(problem("!vy"), "0: '!' needs a truth value, not a number");
  EXPECT_EQ(problem("-grounded"), "0: '-' needs a number, not a truth value");
  EXPECT_EQ(problem("body(grounded || vy > 1).x"), "0: 'body' needs a number, not a truth value");
  EXPECT_EQ(problem("body(vy || vx).x"),
            "8: '||' needs a truth value on both sides, but has a number on its left");
  EXPECT_EQ(problem("max(1, grounded)"), "7: 'max' takes numbers, but this is a truth value");
  const auto condition = Expression::parse_condition("vy");
  ASSERT_FALSE(condition);
  EXPECT_EQ(condition.error().message,
            "a condition must be true or false, but this is a number; compare it, as in 'speed > 3'");
  EXPECT_TRUE(Expression::parse_condition("vy > 1"));
}

TEST(ExpressionErrors, CoverDepth) {
  const auto nested = [](int depth) {
    std::string text = "x";
    for (int i = 0; i < depth; ++i) text = "before(" + text + ")";
    return text;
  };
  EXPECT_EQ(problem(nested(8)), "none");
  EXPECT_EQ(problem(nested(9)), "0: this looks back more than 8 frames");
  EXPECT_EQ(problem(std::string(499, '(') + "1" + std::string(499, ')')), "none");
  EXPECT_EQ(problem(std::string(1000, '(')), "1000: expected a value at the end");
  EXPECT_EQ(problem(std::string(999, '-') + "1"), "none");
}

std::vector<std::string> candidates(std::string_view text, std::size_t cursor) {
  std::vector<std::string> texts;
  for (const Candidate& candidate : complete(text, cursor).candidates) texts.push_back(candidate.text);
  return texts;
}

TEST(ExpressionCompletion, OffersNamesThatBeginWithTheTypedLetters) {
  EXPECT_THAT(candidates("gr", 2), ElementsAre("grounded"));
  EXPECT_THAT(candidates("1 + body.v", 10), ElementsAre("vx", "vy"));
  EXPECT_THAT(candidates("body(2).in_", 11), ElementsAre("in_cell(", "in_rect("));
  EXPECT_THAT(candidates("body(body(1).id).normal.", 24),
              ElementsAre("normal.x", "normal.y", "normal.angle"));
  EXPECT_THAT(candidates("abs(1).v", 8), ElementsAre());
  EXPECT_THAT(candidates("body.fra", 8), ElementsAre()) << "no name of a body";
  EXPECT_THAT(candidates("bod", 3), ElementsAre("body.", "body("));
  EXPECT_THAT(candidates("3", 1), ElementsAre());
  EXPECT_EQ(candidates("", 0).size(), expression_names().size() + 2);
  EXPECT_EQ(candidates("x > ", 99).size(), expression_names().size() + 2);
}

TEST(ExpressionCompletion, ReplacesTheWordUnderTheCursor) {
  const Completion whole = complete("1 < body.vxyz + 1", 10);
  EXPECT_EQ(whole.from, 9u);
  EXPECT_EQ(whole.to, 13u);
  ASSERT_EQ(whole.candidates.size(), 2u);
  EXPECT_EQ(whole.candidates[1].label, "vy");
  EXPECT_EQ(whole.candidates[1].help, "velocity downwards");
  EXPECT_EQ(complete("tou", 3).candidates[0].label, "touches(column, row)");
}

TEST(ExpressionNames, AreUniqueAndHaveHelp) {
  for (const ExpressionName& name : expression_names()) {
    EXPECT_EQ(find_expression_name(name.name), &name);
    EXPECT_FALSE(name.help.empty()) << name.name;
    EXPECT_EQ(name.arguments > 0, !name.parameters.empty()) << name.name;
  }
  for (std::size_t i = 0; i < metric_infos().size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(metric_infos()[i].metric), i);
}

}  // namespace talus::debug_expression_test
