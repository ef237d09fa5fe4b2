// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/formula.hpp"

#include <fmt/format.h>

#include <cctype>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/exact.hpp"

namespace reference {

struct Formula::Node {
    std::function<Real(std::span<const Real>)> function;  // of the parts, or of the operands
    std::vector<std::shared_ptr<const Node>> parts;

    Real value(std::span<const Real> operands) const {
        if (parts.empty()) return function(operands);
        std::vector<Real> values;
        for (const auto& part : parts) values.push_back(part->value(operands));
        return function(values);
    }
};

namespace {

using Node = std::shared_ptr<const Formula::Node>;
using Values = std::span<const Real>;
using Function = std::function<Real(Values)>;

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
    static Node node(Function function, std::vector<Node> parts) {
        return std::make_shared<Formula::Node>(std::move(function), std::move(parts));
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
                left = node([](Values x) { return Real(x[0] / x[1]); }, {left, sign()});
            else
                return left;
        }
    }
    Node sign() {
        // Whoever nests deeper writes no formula, and the stack has an end.
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
        return node([value = Real(digits)](Values) { return value; }, {});
    }
    Node name() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) ++at_;
        const std::string_view name = text_.substr(begin, at_ - begin);
        if (name == "pi") return node([](Values) { return pi(); }, {});
        if (name.size() == 1 && name[0] >= 'a' && std::size_t(name[0] - 'a') < operands_)
            return node([i = std::size_t(name[0] - 'a')](Values x) { return x[i]; }, {});
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
