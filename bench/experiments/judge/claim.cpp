// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/judge/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "bench/experiments/judge/split.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "reference/formula.hpp"
#include "reference/judge.hpp"

namespace judge {
namespace {

void hold_to(std::optional<double> bound_ulp, reference::Judgement& judgement) {
    if (bound_ulp && !judgement.defined)
        judgement.as_defined = std::abs(judgement.error_ulp) <= *bound_ulp;
}

class OperationClaim : public Claim {
  public:
    OperationClaim(const reference::Subject& subject, std::optional<double> bound_ulp)
        : subject_(subject), bound_ulp_(bound_ulp) {
        const reference::OperationShape& shape = reference::shape(subject.operation);
        operands_.assign(shape.operands, Type{subject.operand_format});
        result_ = {subject.format};
        results_ = shape.results;
        calling_ = operations::calling_of(subject);
        for (const operations::HostSubject& host : operations::host_subjects())
            if (host.subject == subject && !host_) host_ = &host;
        split_ = split_judge(subject);
    }

    std::vector<operands::BoundaryCase> boundary_cases() const override {
        return operands::boundary_cases(subject_.operation, subject_.operand_format);
    }
    std::unique_ptr<Sampler> sampler(operands::OperandClass operand_class,
                                     std::uint64_t seed) const override {
        class Own : public Sampler {
          public:
            explicit Own(operands::Sampler sampler) : sampler_(sampler) {}
            void next(std::span<std::int64_t> operands) override { sampler_.next(operands); }

          private:
            operands::Sampler sampler_;
        };
        return std::make_unique<Own>(
            operands::Sampler(subject_.operation, subject_.operand_format, operand_class, seed));
    }
    reference::Judgement judge(Raws operands, Raws results) const override {
        if (reference::is_shift(subject_.operation) &&
            (operands[1] < 0 || operands[1] >= subject_.format.width))
            return {.excluded = "a shift by so many bits is undefined"};
        reference::Judgement judgement = host_    ? host_->judge(operands, results)
                                         : split_ ? split_(subject_.format, operands, results)
                                                  : reference::judge(subject_, operands, results);
        hold_to(bound_ulp_, judgement);
        return judgement;
    }
    // Functions of the library's own formats are judged in bulk, which is a hundred times faster.
    void judge_all(Raws operands, Raws results,
                   reference::ErrorStatistics& statistics) const override {
        if (host_ && !bound_ulp_)
            host_->judge_all(operands, results, statistics, {});
        else
            Claim::judge_all(operands, results, statistics);
    }

  private:
    reference::Subject subject_;
    std::optional<double> bound_ulp_;
    // The fast judges of the library's own formats and of other splits; null if there is none.
    const operations::HostSubject* host_ = nullptr;
    SplitJudge split_ = nullptr;
};

class FormulaClaim : public Claim {
  public:
    FormulaClaim(std::vector<Type> operands, const Type& result, const std::string& formula,
                 double bound_ulp)
        : formula_(formula, operands.size()), bound_ulp_(bound_ulp) {
        operands_ = std::move(operands);
        result_ = result;
        least_ = reference::Real(result.least()) - reference::Real(0.5);
        beyond_ = reference::Real(result.greatest()) + reference::Real(0.5);
        calling_.signature.result = result.format.width / 8;
        for (const Type& operand : operands_)
            calling_.signature.operands.push_back(operand.format.width / 8);
    }

    // All combinations of the operands' tables, thinned evenly if there are more than a hundred
    // thousand.
    std::vector<operands::BoundaryCase> boundary_cases() const override {
        constexpr std::uint64_t most = 100'000;
        std::vector<std::vector<operands::BoundaryOperand>> tables;
        std::uint64_t count = 1;
        for (const Type& operand : operands_) {
            tables.push_back(operands::boundary_operands(operand.format));
            count *= tables.back().size();
        }
        std::vector<operands::BoundaryCase> cases;
        const std::uint64_t taken = std::min(count, most);
        for (std::uint64_t i = 0; i < taken; ++i) {
            // In an order in which neighbours differ in the first operand.
            std::uint64_t rest = i * (count / taken) + i * (count % taken) / taken;
            operands::BoundaryCase each;
            for (const auto& table : tables) {
                const operands::BoundaryOperand& operand = table[rest % table.size()];
                each.operands.push_back(operand.raw);
                each.what += (each.what.empty() ? "" : "; ") + operand.what;
                rest /= table.size();
            }
            cases.push_back(std::move(each));
        }
        return cases;
    }
    std::unique_ptr<Sampler> sampler(operands::OperandClass operand_class,
                                     std::uint64_t seed) const override {
        class Own : public Sampler {
          public:
            Own(const std::vector<Type>& types, operands::OperandClass operand_class,
                std::uint64_t seed) {
                for (const Type& type : types)
                    samplers_.emplace_back(reference::Operation::negate, type.format, operand_class,
                                           seed + samplers_.size());
            }
            void next(std::span<std::int64_t> operands) override {
                for (std::size_t i = 0; i < operands.size(); ++i)
                    samplers_[i].next(operands.subspan(i, 1));
            }

          private:
            std::vector<operands::Sampler> samplers_;
        };
        return std::make_unique<Own>(operands_, operand_class, seed);
    }
    reference::Judgement judge(Raws operands, Raws results) const override {
        std::array<reference::Real, reference::max_operands> values;
        for (std::size_t i = 0; i < operands.size(); ++i)
            values[i] = value(operands_[i], operands[i]);
        reference::Real exact = formula_(std::span(values).first(operands.size()));
        if (result_.format.fraction != 0) exact = reference::scale(exact, result_.format.fraction);
        if (!isfinite(exact)) return {.excluded = "the formula has no value"};
        if (exact < least_ || exact >= beyond_)
            return {.excluded = "the exact value does not fit the result's type"};
        const auto error =
            double(reference::Real(reference::Real(result_.number(results[0])) - exact));
        return {.error_ulp = error, .as_defined = std::abs(error) <= bound_ulp_};
    }

  private:
    static reference::Real value(const Type& type, std::int64_t raw) {
        const reference::Real number(type.number(raw));
        return type.format.fraction == 0 ? number : reference::scale(number, -type.format.fraction);
    }

    reference::Formula formula_;
    double bound_ulp_;
    reference::Real least_, beyond_;  // in ulp: what rounds to numbers of the result's type
};

std::string without_blanks(std::string text) {
    std::erase(text, ' ');
    return text;
}

Type parse_type(const std::string& name) {
    Type type;
    type.is_unsigned = name.starts_with("uint");
    type.format = reference::parse_format(type.is_unsigned ? name.substr(1) : name);
    if (type.format.is_float() || (type.is_unsigned && type.format.width == 64))
        throw std::invalid_argument(fmt::format(
            "a formula cannot use {}: its types are int8 to int64, uint8 to uint32 and fixed-point "
            "formats such as q16_16",
            name));
    return type;
}

std::unique_ptr<const Claim> parse_formula(const std::string& text, double bound_ulp) {
    const std::size_t equals = text.find('=');
    const std::string head = without_blanks(text.substr(0, equals));
    const std::size_t open = head.find('(');
    if (open == head.npos || !head.ends_with(')'))
        throw std::invalid_argument(fmt::format(
            "'{}' is not <type>(<type>,...)=<formula>, e.g. int32(int32,int32)=a*b/2^16", text));
    std::vector<Type> operands;
    const std::string list = head.substr(open + 1, head.size() - open - 2);
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        operands.push_back(parse_type(list.substr(begin, end - begin)));
        begin = end + 1;
    }
    if (operands.size() > reference::max_operands)
        throw std::invalid_argument(fmt::format("a formula has at most {} operands, this one {}",
                                                reference::max_operands, operands.size()));
    const Type result = parse_type(head.substr(0, open));
    return std::make_unique<FormulaClaim>(std::move(operands), result, text.substr(equals + 1),
                                          bound_ulp);
}

// "sqrt:q16_16" or "convert:q8_24:q16_16", optionally followed by the arithmetic: ":published".
reference::Subject parse_operation(const std::string& text) {
    std::string symbol = text;
    std::replace(symbol.begin(), symbol.end(), ':', '_');
    // Without an arithmetic, the default.
    for (const std::string& each : {symbol + "_default", symbol}) {
        try {
            const reference::NamedSubject named = reference::parse_symbol(each);
            if (named.implementation == "default" || named.implementation == "published" ||
                named.implementation == "saturating")
                return named.subject;
        } catch (const std::invalid_argument&) {
            continue;
        }
    }
    const std::size_t colon = text.find(':');
    reference::parse_operation(text.substr(0, colon));  // its message lists what exists
    if (colon != text.npos)
        reference::parse_format(text.substr(colon + 1, text.find(':', colon + 1) - colon - 1));
    throw std::invalid_argument(fmt::format(
        "'{}' is not <operation>:<format>, e.g. sqrt:q16_16, or convert:<from>:<to>, either with "
        ":published or :saturating appended",
        text));
}

}  // namespace

int Claim::input_bits() const {
    int bits = 0;
    for (const Type& operand : operands_) bits += operand.format.width;
    return bits;
}

void Claim::input(std::uint64_t i, std::span<std::int64_t> operands) const {
    for (std::size_t k = 0; k < operands.size(); ++k) {
        operands[k] = operands_[k].format.extend(i);
        i >>= operands_[k].format.width;
    }
}

void Claim::judge_all(Raws operands, Raws results, reference::ErrorStatistics& statistics) const {
    const std::size_t arity = operands_.size();
    for (std::size_t i = 0; i < results.size() / results_; ++i) {
        const Raws each = operands.subspan(i * arity, arity);
        statistics.add(judge(each, results.subspan(i * results_, results_)), each);
    }
}

std::string text_of(const Claim& claim, Raws operands) {
    std::string text;
    for (std::size_t i = 0; i < operands.size(); ++i)
        text += fmt::format("{}{}", i ? " " : "", claim.operands()[i].number(operands[i]));
    return text;
}

std::unique_ptr<const Claim> parse_claim(const std::string& text, std::optional<double> bound_ulp) {
    if (text.find('=') != text.npos) return parse_formula(text, bound_ulp.value_or(0.5));
    return std::make_unique<OperationClaim>(parse_operation(text), bound_ulp);
}

}  // namespace judge
