// SPDX-License-Identifier: GPL-3.0-or-later
// What a function claims to compute: an operation of the catalogue in a format, "sqrt:q16_16", or a
// formula over raw numbers, "int32(int32,int32)=a*b/2^16". The claim determines how the function is
// called, which operands are worth trying and which results are right.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/operand_class.hpp"
#include "bench/lab/subjects/calling.hpp"
#include "reference/error_statistics.hpp"

namespace judge {

using Raws = std::span<const std::int64_t>;

// A raw is the number's pattern, sign-extended even for an unsigned type.
struct Type {
    reference::NumberFormat format;
    bool is_unsigned = false;

    std::int64_t least() const { return is_unsigned ? 0 : minus_half_turn(); }
    // A 64-bit type is never unsigned.
    std::int64_t greatest() const {
        return is_unsigned ? -2 * minus_half_turn() - 1 : -(minus_half_turn() + 1);
    }
    // The decimal number for a pattern.
    std::int64_t number(std::int64_t raw) const {
        return is_unsigned && raw < 0 ? raw - 2 * minus_half_turn() : raw;
    }

  private:
    std::int64_t minus_half_turn() const {
        return std::int64_t(std::uint64_t(-1) << (format.width - 1));
    }
};

class Claim {
  public:
    virtual ~Claim() = default;

    // One type for each operand, or for each component of a vector.
    const std::vector<Type>& operands() const { return operands_; }
    const Type& result() const { return result_; }
    std::size_t results() const { return results_; }
    const operations::Calling& calling() const { return calling_; }

    virtual std::vector<operands::BoundaryCase> boundary_cases() const = 0;
    // Fills in the next operands; the same seed gives the same ones.
    class Sampler {
      public:
        virtual ~Sampler() = default;
        virtual void next(std::span<std::int64_t> operands) = 0;
    };
    virtual std::unique_ptr<Sampler> sampler(operands::OperandClass operand_class,
                                             std::uint64_t seed) const = 0;
    // The number of bits of all operands together.
    int input_bits() const;
    // The operands of input number i of all 2^input_bits() inputs.
    void input(std::uint64_t i, std::span<std::int64_t> operands) const;

    virtual reference::Judgement judge(Raws operands, Raws results) const = 0;
    // Judges any number of calls, whose raws follow one after the other.
    virtual void judge_all(Raws operands, Raws results,
                           reference::ErrorStatistics& statistics) const;

  protected:
    std::vector<Type> operands_;
    Type result_;
    std::size_t results_ = 1;
    operations::Calling calling_{};
};

// Operands as decimal numbers, separated by spaces.
std::string text_of(const Claim& claim, Raws operands);

// With a bound, a result that is not pinned is right if it is within the bound of the exact one.
// Without, it is right if the operation's definition allows it; for a formula, if it is within half
// an ulp. Throws std::invalid_argument with one line if the text is not a claim.
std::unique_ptr<const Claim> parse_claim(const std::string& text,
                                         std::optional<double> bound_ulp = {});

}  // namespace judge
