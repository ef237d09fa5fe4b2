// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/exact.hpp"

namespace reference {

// An operand, a constant, or a function of one or two parts.
struct Formula::Node {
    Real (*function)(std::span<const Real>) = nullptr;
    std::vector<std::shared_ptr<const Node>> parts{};
    std::size_t operand = 0;
    std::optional<Real> constant{};

    bool is_leaf() const { return parts.empty(); }
    const Real& leaf(std::span<const Real> operands) const {
        return constant ? *constant : operands[operand];
    }
    Real value(std::span<const Real> operands) const {
        if (is_leaf()) return leaf(operands);
        // Not a vector, for speed: a formula is evaluated for millions of operands.
        std::array<Real, max_parts> values;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i]->is_leaf())
                values[i] = parts[i]->leaf(operands);
            else
                values[i] = parts[i]->value(operands);
        }
        return function(std::span(values).first(parts.size()));
    }
    static constexpr std::size_t max_parts = 2;
};

namespace {

using Node = std::shared_ptr<const Formula::Node>;
using Values = std::span<const Real>;
using Function = Real (*)(Values);

struct Row {
    std::size_t operands;
    Function function;
};

const std::map<std::string, Row, std::less<>>& functions() {
#define OF_ONE(name)                                     \
    {                                                    \
#name, {                                         \
            1, [](Values x) { return Real(name(x[0])); } \
        }                                                \
    }
    static const std::map<std::string, Row, std::less<>> rows = {
        OF_ONE(sqrt),
        OF_ONE(cbrt),
        OF_ONE(sin),
        OF_ONE(cos),
        OF_ONE(tan),
        OF_ONE(asin),
        OF_ONE(acos),
        OF_ONE(atan),
        OF_ONE(sinh),
        OF_ONE(cosh),
        OF_ONE(tanh),
        OF_ONE(exp),
        OF_ONE(exp2),
        OF_ONE(log),
        OF_ONE(log2),
        OF_ONE(log10),
        OF_ONE(abs),
        OF_ONE(floor),
        OF_ONE(ceil),
        OF_ONE(trunc),
        OF_ONE(round),
        {"atan2", {2, [](Values x) { return Real(atan2(x[0], x[1])); }}},
        {"min", {2, [](Values x) { return x[0] < x[1] ? x[0] : x[1]; }}},
        {"max", {2, [](Values x) { return x[0] < x[1] ? x[1] : x[0]; }}},
        {"mod", {2, [](Values x) { return Real(fmod(x[0], x[1])); }}},
    };
#undef OF_ONE
    return rows;
}

class Parser {
  public:
    Parser(std::string_view text, std::size_t operands) : text_(text), operands_(operands) {}

    Node formula() {
        const Node node = sum();
        if (peek() != '\0') fail("an operator or the end");
        return node;
    }

  private:
    char peek() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    [[noreturn]] void fail(const std::string& wanted) {
        throw std::invalid_argument(
            fmt::format("the formula '{}' needs {} at character {}", text_, wanted, at_ + 1));
    }
    // A function of constants is a constant, and computed only once.
    static Node node(Function function, std::vector<Node> parts) {
        const bool known = std::all_of(parts.begin(), parts.end(),
                                       [](const Node& part) { return part->constant.has_value(); });
        const Formula::Node made{function, std::move(parts)};
        return known ? constant(made.value({})) : std::make_shared<Formula::Node>(made);
    }
    static Node constant(const Real& value) {
        return std::make_shared<Formula::Node>(Formula::Node{.constant = value});
    }

    Node sum() {
        Node left = product();
        for (;;) {
            if (take('+'))
                left = node([](Values x) { return Real(x[0] + x[1]); }, {left, product()});
            else if (take('-'))
                left = node([](Values x) { return Real(x[0] - x[1]); }, {left, product()});
            else
                return left;
        }
    }
    Node product() {
        Node left = sign();
        for (;;) {
            if (take('*'))
                left = node([](Values x) { return Real(x[0] * x[1]); }, {left, sign()});
            else if (take('/'))
                left = quotient(left, sign());
            else
                return left;
        }
    }
    // A product with the reciprocal of a power of two is as accurate, and takes a third of the
    // time.
    static Node quotient(const Node& a, const Node& b) {
        if (b->constant && isfinite(*b->constant) && *b->constant != 0 &&
            scale(Real(1), binade(*b->constant)) == *b->constant)
            return node([](Values x) { return Real(x[0] * x[1]); },
                        {a, constant(Real(1) / *b->constant)});
        return node([](Values x) { return Real(x[0] / x[1]); }, {a, b});
    }
    Node sign() {
        // No real formula nests deeper, and the stack is finite.
        if (++depth_ > 200) fail("fewer levels");
        const Node result =
            take('-') ? node([](Values x) { return Real(-x[0]); }, {sign()}) : power();
        --depth_;
        return result;
    }
    Node power() {
        const Node base = primary();
        if (!take('^')) return base;
        return node([](Values x) { return Real(pow(x[0], x[1])); }, {base, sign()});
    }
    Node primary() {
        const char c = peek();
        if (take('(')) return closed(sum());
        if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') return number();
        if (std::isalpha(static_cast<unsigned char>(c))) return name();
        fail("a number, an operand, a function or '('");
    }
    Node closed(Node inner) {
        if (!take(')')) fail("')'");
        return inner;
    }
    Node number() {
        const std::size_t end = text_.find_first_not_of("0123456789.", at_);
        const std::string digits(text_.substr(at_, end - at_));
        if (digits.find('.') != digits.rfind('.') || digits == ".") fail("a number");
        at_ = end == text_.npos ? text_.size() : end;
        return constant(Real(digits));
    }
    Node name() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) ++at_;
        const std::string_view name = text_.substr(begin, at_ - begin);
        if (name == "pi") return constant(pi());
        if (name.size() == 1 && name[0] >= 'a' && std::size_t(name[0] - 'a') < operands_)
            return std::make_shared<Formula::Node>(
                Formula::Node{.operand = std::size_t(name[0] - 'a')});
        const auto row = functions().find(name);
        if (row == functions().end()) {
            at_ = begin;
            fail(operands_ == 1
                     ? "the operand a, or a function"
                     : fmt::format("an operand a..{}, or a function", char('a' + operands_ - 1)));
        }
        if (!take('(')) fail("'('");
        std::vector<Node> parts = {sum()};
        while (take(',')) parts.push_back(sum());
        if (parts.size() != row->second.operands)
            fail(fmt::format("{} operand{} of {}", row->second.operands,
                             row->second.operands == 1 ? "" : "s", name));
        return closed(node(row->second.function, std::move(parts)));
    }

    std::string_view text_;
    std::size_t operands_, at_ = 0;
    int depth_ = 0;
};

}  // namespace

Formula::Formula(std::string_view text, std::size_t operands)
    : root_(Parser(text, operands).formula()) {}

Real Formula::operator()(std::span<const Real> operands) const { return root_->value(operands); }

}  // namespace reference
