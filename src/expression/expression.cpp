// SPDX-License-Identifier: MIT
// The grammar of expression.h in PEGTL's words, and how its matches build the tree.
#include "moivre/expression/expression.h"

#include <iterator>
#include <optional>
#include <tao/pegtl.hpp>
#include <utility>

#include "moivre/expression/lookalikes.h"
#include "moivre/expression/utf8.h"
#include "next_summand.h"
#include "number.h"

namespace moivre {

namespace {

namespace pegtl = tao::pegtl;

// Every rule that must follow another is wrapped in must<>, so nothing is matched twice and the
// first fault is final. What was expected where it failed is `expected<Rule>` below.
namespace grammar {
using namespace tao::pegtl;  // NOLINT(google-build-using-namespace): the grammar's vocabulary

struct gap : star<space> {};
struct digits : plus<digit> {};
struct fraction : seq<one<'.'>, star<digit>> {};
struct exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, digits> {};
struct number : seq<sor<seq<digits, opt<fraction>>, seq<one<'.'>, digits>>, opt<exponent>> {};
// Greek letters are of two bytes in UTF-8, small digits below the line (x\u2081) of three.
struct greek : seq<one<'\xCE', '\xCF'>, range<'\x80', '\xBF'>> {};
struct low_digit : seq<string<'\xE2', '\x82'>, range<'\x80', '\x89'>> {};
struct name
    : seq<sor<alpha, one<'_'>, greek>, star<sor<alnum, one<'_', '[', ']'>, greek, low_digit>>> {};

struct sum;
struct opening : one<'('> {};
struct closing : one<')'> {};
struct group : if_must<opening, gap, sum, closing> {};
struct arguments : if_must<opening, gap, sum, star<if_must<one<','>, gap, sum>>, closing> {};
// On one line: a name above a `(` is no call but two expressions, the first without its end.
struct called_or_name : seq<name, star<blank>, opt<arguments>> {};
struct operand : sor<number, called_or_name, group> {};

struct begin_exponent : success {};
struct end_exponent : success {};
struct signed_power;
struct raised
    : if_must<sor<one<'^'>, string<'*', '*'>>, gap, begin_exponent, signed_power, end_exponent> {};
struct power : seq<must<operand>, gap, opt<raised>> {};
struct negated_power : if_must<one<'-'>, gap, power> {};
struct signed_power : sor<negated_power, power> {};

struct begin_product : success {};
struct end_product : success {};
struct multiplied : if_must<seq<one<'*'>, not_at<one<'*'>>>, gap, signed_power> {};
struct divided : if_must<one<'/'>, gap, signed_power> {};
// 2x, 3(x + 1): a number right before what it multiplies. Behind a `/` it would be read in two
// ways: 1/2x.
struct behind_digit {
  using rule_t = behind_digit;
  using subs_t = empty_list;
  template <class AnyInput>
  static bool match(const AnyInput& in) {
    const char* here = in.current();
    return here != in.begin() && ((here[-1] >= '0' && here[-1] <= '9') || here[-1] == '.');
  }
};
struct multiple : seq<behind_digit, at<sor<alpha, one<'_', '('>, greek>>, power> {};
struct product : seq<begin_product, power, star<multiple>,
                     star<sor<seq<multiplied, star<multiple>>, divided>>, end_product> {};

struct begin_sum : success {};
struct end_sum : success {};
struct negated : if_must<one<'-'>, gap, product> {};
struct signed_product : sor<negated, product> {};
struct added : if_must<one<'+'>, gap, signed_product> {};
struct subtracted : if_must<one<'-'>, gap, signed_product> {};
struct first_product : sor<negated, if_must<one<'+'>, gap, product>, product> {};
struct sum : seq<begin_sum, first_product, star<sor<added, subtracted>>, end_sum> {};

struct end_of_text : eof {};
struct expression : must<gap, sum, end_of_text> {};
}  // namespace grammar

using Input = pegtl::memory_input<pegtl::tracking_mode::eager, pegtl::eol::lf_crlf, const char*>;

Input input_of(std::string_view text, const SourcePosition& begin) {
  return Input(text.data(), text.data() + text.size(), "", begin.offset, begin.line, begin.column);
}

template <class AnyInput>
SourcePosition position_of(const AnyInput& in) {
  const auto& at = in.iterator();
  return {.offset = at.byte, .line = at.line, .column = at.column};
}

constexpr const char* kUnclosed = "unbalanced parenthesis: this `(` is never closed";
constexpr const char* kSecondSign = "`=` has no place in an expression; an equation has one `=`";
constexpr const char* kUnopened = "unbalanced parenthesis: this `)` closes nothing";

struct SyntaxFault {
  Diagnostic diagnostic;
  SourcePosition reached;  ///< where reading stopped; an unclosed `(` stands before
};

/// The tree under construction: finished operands on a stack, and where the unfinished nodes begin
/// on it.
struct Builder {
  std::string_view text;
  SourcePosition begin;
  std::vector<Diagnostic>& faults;
  NumberRange range = NumberRange::of_double;
  /// Takes the summands of the whole text; empty when the text is to become one tree.
  std::function<void(const Expression&)> take = {};
  std::vector<Expression> stack = {};
  std::vector<std::size_t> unfinished = {};
  struct Opening {
    SourcePosition at;
    std::size_t operands;  // height of the stack at the `(`
  };
  std::vector<Opening> openings = {};
  int exponents = 0;

  /// As before the first character.
  void restart() {
    stack.clear();
    unfinished.clear();
    openings.clear();
    exponents = 0;
  }

  void check_depth(const SourcePosition& at) const {
    if (openings.size() + static_cast<std::size_t>(exponents) <= kMaximumDepth) return;
    throw SyntaxFault{{at, "parentheses, calls and exponents stand more than " +
                               std::to_string(kMaximumDepth) + " deep in one another"},
                      at};
  }

  /// The top of the stack becomes the operand of a new node.
  void wrap(Expression::Kind kind, const SourcePosition& at) {
    Expression node{.kind = kind, .at = at, .number = {}, .name = {}, .operands = {}};
    node.operands.push_back(std::move(stack.back()));
    stack.back() = std::move(node);
  }

  /// The stack from `height` up becomes the operands of `node`.
  void gather(Expression& node, std::size_t height) {
    const auto first = stack.begin() + static_cast<std::ptrdiff_t>(height);
    node.operands.assign(std::make_move_iterator(first), std::make_move_iterator(stack.end()));
    stack.erase(first, stack.end());
  }

  /// A summand is complete; one of the whole text may be wanted at once.
  void hand_on() {
    const bool is_of_whole_text = unfinished.size() == 1;
    if (!take || !is_of_whole_text) return;
    take(stack.back());
    stack.pop_back();
  }

  /// Closes a sum or product; one operand alone needs no node, and none is left when all are handed
  /// on.
  void finish(Expression::Kind kind) {
    const std::size_t height = unfinished.back();
    unfinished.pop_back();
    if (stack.size() - height <= 1) return;
    Expression node{.kind = kind, .at = stack[height].at, .number = {}, .name = {}, .operands = {}};
    gather(node, height);
    stack.push_back(std::move(node));
  }
};

template <class Rule>
struct Action : pegtl::nothing<Rule> {};

template <>
struct Action<grammar::number> {
  template <class Match>
  static void apply(const Match& in, Builder& b) {
    ParsedNumber parsed = parse_number(in.string_view(), b.range);
    if (!parsed.refusal.empty()) {
      b.faults.push_back({position_of(in), parsed.refusal});
      parsed.value = 1;  // so that what stands around it is judged by itself
    }
    b.stack.push_back({.kind = Expression::Kind::number,
                       .at = position_of(in),
                       .number = std::move(parsed.value),
                       .name = {},
                       .operands = {}});
  }
};

template <>
struct Action<grammar::name> {
  template <class Match>
  static void apply(const Match& in, Builder& b) {
    b.stack.push_back({.kind = Expression::Kind::name,
                       .at = position_of(in),
                       .number = {},
                       .name = in.string(),
                       .operands = {}});
  }
};

template <>
struct Action<grammar::opening> {
  template <class Match>
  static void apply(const Match& in, Builder& b) {
    b.openings.push_back({position_of(in), b.stack.size()});
    b.check_depth(b.openings.back().at);
  }
};

template <>
struct Action<grammar::group> {
  static void apply0(Builder& b) { b.openings.pop_back(); }
};

template <>
struct Action<grammar::arguments> {
  static void apply0(Builder& b) {
    const std::size_t height = b.openings.back().operands;
    b.openings.pop_back();
    Expression& call = b.stack[height - 1];
    call.kind = Expression::Kind::call;
    b.gather(call, height);
  }
};

template <>
struct Action<grammar::begin_exponent> {
  template <class Match>
  static void apply(const Match& in, Builder& b) {
    ++b.exponents;
    b.check_depth(position_of(in));
  }
};

template <>
struct Action<grammar::end_exponent> {
  static void apply0(Builder& b) { --b.exponents; }
};

template <>
struct Action<grammar::raised> {
  static void apply0(Builder& b) {
    const std::size_t height = b.stack.size() - 2;
    Expression node{.kind = Expression::Kind::power,
                    .at = b.stack[height].at,
                    .number = {},
                    .name = {},
                    .operands = {}};
    b.gather(node, height);
    b.stack.push_back(std::move(node));
  }
};

template <Expression::Kind kind>
struct Wrap {
  template <class Match>
  static void apply(const Match& in, Builder& b) {
    b.wrap(kind, position_of(in));
  }
};
template <>
struct Action<grammar::negated_power> : Wrap<Expression::Kind::negate> {};
template <>
struct Action<grammar::negated> : Wrap<Expression::Kind::negate> {};
template <>
struct Action<grammar::subtracted> {
  template <class Match>
  static void apply(const Match& in, Builder& b) {
    b.wrap(Expression::Kind::negate, position_of(in));
    b.hand_on();
  }
};
template <>
struct Action<grammar::divided> : Wrap<Expression::Kind::reciprocal> {};

struct HandOn {
  static void apply0(Builder& b) { b.hand_on(); }
};
template <>
struct Action<grammar::first_product> : HandOn {};
template <>
struct Action<grammar::added> : HandOn {};

struct Begin {
  static void apply0(Builder& b) { b.unfinished.push_back(b.stack.size()); }
};
template <>
struct Action<grammar::begin_sum> : Begin {};
template <>
struct Action<grammar::begin_product> : Begin {};

template <Expression::Kind kind>
struct Finish {
  static void apply0(Builder& b) { b.finish(kind); }
};
template <>
struct Action<grammar::end_sum> : Finish<Expression::Kind::sum> {};
template <>
struct Action<grammar::end_product> : Finish<Expression::Kind::product> {};

enum class Expected { operand, closing, end };
template <class Rule>
inline constexpr Expected expected = Expected::operand;
template <>
inline constexpr Expected expected<grammar::closing> = Expected::closing;
template <>
inline constexpr Expected expected<grammar::end_of_text> = Expected::end;

bool is_blank(char c) { return std::string_view(" \t\n\v\f\r").find(c) != std::string_view::npos; }

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '[' || c == ']';
}

/// A character as a message quotes it.
std::string quoted(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte > 0x20 && byte < 0x7F) return std::string("`") + c + '`';
  constexpr const char* kHex = "0123456789ABCDEF";
  return std::string("the byte 0x") + kHex[byte >> 4U] + kHex[byte & 0xFU];
}

/// The whole character at text[at]; of one that is no expression's, also what is meant by it.
std::string quoted_character(std::string_view text, std::size_t at) {
  const std::size_t length = utf8_length(text.substr(at));
  const std::string character =
      length < 2 ? quoted(text[at]) : '`' + std::string(text.substr(at, length)) + '`';
  return character + lookalike_advice(text, at);
}

/// The number or name that begins `text`, or its first character, as a message quotes it.
std::string first_word(std::string_view text) {
  constexpr std::size_t kLongestWord = 40;
  std::size_t end = 0;
  while (end < text.size() && end < kLongestWord &&
         (is_name_character(text[end]) || text[end] == '.')) {
    ++end;
  }
  return end == 0 ? quoted(text.front()) : '`' + std::string(text.substr(0, end)) + '`';
}

/// Two operands side by side; across a line end the sign of a lost end of the expression.
std::string juxtaposition(std::string_view text, std::size_t at, std::size_t line) {
  std::string message = "an operator is missing before " + first_word(text.substr(at));
  std::size_t end = at;
  std::size_t breaks = 0;
  while (end > 0 && is_blank(text[end - 1])) {
    if (text[--end] == '\n') ++breaks;
  }
  if (breaks > 0) {
    message += "; or is a `;` missing at the end of line " + std::to_string(line - breaks) + '?';
  } else {
    message += " (a product is written with `*`)";
  }
  return message;
}

/// Why the expression does not go on with text[at].
std::string unexpected(std::string_view text, std::size_t at, std::size_t line) {
  const char c = text[at];
  if (c == ')') return kUnopened;
  if (c == '(' || c == '.' || is_name_character(c)) return juxtaposition(text, at, line);
  if (c == '=') return kSecondSign;
  return "unexpected character: " + quoted_character(text, at);
}

std::string missing_operand(std::string_view text, std::size_t at) {
  const std::string wanted = "expected a number, a name or `(`";
  if (at == text.size()) return wanted + ", but the expression ends here";
  const char c = text[at];
  const bool is_operator = std::string_view("+-*/^").find(c) != std::string_view::npos;
  return wanted + ", found " + (is_operator ? "the operator " : "") + quoted_character(text, at);
}

SyntaxFault fault_at(const SourcePosition& at, Expected what, const Builder& b) {
  const std::size_t index = at.offset - b.begin.offset;
  if (what == Expected::operand) return {{at, missing_operand(b.text, index)}, at};
  if (index == b.text.size()) return {{b.openings.back().at, kUnclosed}, at};
  return {{at, unexpected(b.text, index, at.line)}, at};
}

template <class Rule>
struct Control : pegtl::normal<Rule> {
  template <class AnyInput>
  [[noreturn]] static void raise(const AnyInput& in, Builder& b) {
    throw fault_at(position_of(in), expected<Rule>, b);
  }
};

namespace grammar {
struct skipped : any {};
struct words : star<sor<number, name, skipped>> {};
}  // namespace grammar

template <class Rule>
struct NameAction : pegtl::nothing<Rule> {};
template <>
struct NameAction<grammar::name> {
  template <class Match>
  static void apply(const Match& in, std::vector<NamePlace>& names) {
    names.push_back({in.string_view(), position_of(in)});
  }
};

/// Reads from `from` to the end of the text; the fault that stopped it, if any.
std::optional<SyntaxFault> build_from(const SourcePosition& from, Builder& builder) {
  Input input = input_of(builder.text.substr(from.offset - builder.begin.offset), from);
  try {
    pegtl::parse<grammar::expression, Action, Control>(input, builder);
    return std::nullopt;
  } catch (const SyntaxFault& fault) {
    return fault;
  }
}

/// Notes `fault` and what it hides of parentheses. Where reading goes on, in a builder as new;
/// none: the text is done.
std::optional<SourcePosition> recover(const SyntaxFault& fault, Builder& builder) {
  const std::size_t begin = builder.begin.offset;
  std::size_t from = fault.reached.offset - begin;
  std::vector<std::size_t> open;
  for (const Builder::Opening& opening : builder.openings)
    open.push_back(opening.at.offset - begin);
  // A parenthesis is on its way to the stack only when it is the fault itself, beyond the depth
  // allowed.
  if (!open.empty() && open.back() == from) ++from;
  builder.faults.push_back(fault.diagnostic);
  const bool is_told = fault.diagnostic.message == kUnopened;
  const NextSummand next = next_summand(builder.text, is_told ? from + 1 : from, open);

  SourcePosition here = fault.reached;
  const auto walk_to = [&](std::size_t index) {
    here = after(here, builder.text.substr(here.offset - begin, index - (here.offset - begin)));
  };
  for (const std::size_t index : next.unopened) {
    walk_to(index);
    builder.faults.push_back({here, kUnopened});
  }
  if (next.unclosed && fault.diagnostic.message != kUnclosed) {
    builder.faults.push_back(
        {after(builder.begin, builder.text.substr(0, *next.unclosed)), kUnclosed});
  }
  builder.restart();
  if (!next.begin) return std::nullopt;
  walk_to(*next.begin);
  return here;
}

/// False after faults of the grammar, which are then among the faults.
bool build(Builder& builder) {
  std::optional<SyntaxFault> fault = build_from(builder.begin, builder);
  const bool is_sound = !fault;
  while (fault) {
    const std::optional<SourcePosition> from = recover(*fault, builder);
    if (!from) break;
    fault = build_from(*from, builder);
  }
  return is_sound;
}

}  // namespace

Expression parse_expression(std::string_view text, SourcePosition begin,
                            std::vector<Diagnostic>& faults, NumberRange range) {
  Builder builder{.text = text, .begin = begin, .faults = faults, .range = range};
  return build(builder) ? std::move(builder.stack.back()) : Expression{};
}

void parse_summands(std::string_view text, SourcePosition begin, std::vector<Diagnostic>& faults,
                    const std::function<void(const Expression&)>& take) {
  Builder builder{
      .text = text, .begin = begin, .faults = faults, .range = NumberRange::any, .take = take};
  build(builder);
}

std::vector<NamePlace> names_in(std::string_view text, SourcePosition begin) {
  std::vector<NamePlace> names;
  Input input = input_of(text, begin);
  pegtl::parse<grammar::words, NameAction>(input, names);
  const auto is_called = [&](const NamePlace& place) {
    std::size_t next = place.at.offset - begin.offset + place.name.size();
    while (next < text.size() && (text[next] == ' ' || text[next] == '\t')) ++next;
    return next < text.size() && text[next] == '(';
  };
  std::erase_if(names, is_called);
  return names;
}

}  // namespace moivre
