// SPDX-License-Identifier: GPL-3.0-or-later
// What a function is said to compute: an operation of the catalogue in a format, "sqrt:q16_16", or
// a formula over raw numbers, "int32(int32,int32)=a*b/2^16". From it follow how the function is
// called, which operands are worth trying and what is right.
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

// A raw is the number's pattern, sign-extended; of an unsigned type too.
struct Type {
    reference::NumberFormat format;
    bool is_unsigned = false;

    std::int64_t least() const { return is_unsigned ? 0 : minus_half_turn(); }
    // A 64-bit type is never unsigned.
    std::int64_t greatest() const {
        return is_unsigned ? -2 * minus_half_turn() - 1 : -(minus_half_turn() + 1);
    }
    // The number that a pattern is read and written as in decimal.
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

    // One for each operand, vectors one component after the other.
    const std::vector<Type>& operands() const { return operands_; }
    const Type& result() const { return result_; }
    std::size_t results() const { return results_; }
    const operations::Calling& calling() const { return calling_; }

    virtual std::vector<operands::BoundaryCase> boundary_cases() const = 0;
    // Fills in the operands that come next; the same seed gives the same ones.
    class Sampler {
      public:
        virtual ~Sampler() = default;
        virtual void next(std::span<std::int64_t> operands) = 0;
    };
    virtual std::unique_ptr<Sampler> sampler(operands::OperandClass operand_class,
                                             std::uint64_t seed) const = 0;
    // All bits of all operands.
    int input_bits() const;
    // The operands of the i-th of all 2^input_bits() inputs.
    void input(std::uint64_t i, std::span<std::int64_t> operands) const;

    virtual reference::Judgement judge(Raws operands, Raws results) const = 0;
    // Of any number of calls, their raws one after the other.
    virtual void judge_all(Raws operands, Raws results,
                           reference::ErrorStatistics& statistics) const;

  protected:
    std::vector<Type> operands_;
    Type result_;
    std::size_t results_ = 1;
    operations::Calling calling_{};
};

// Operands as their decimal numbers, with blanks between.
std::string text_of(const Claim& claim, Raws operands);

// With a bound, a result that is not pinned is right where it is so near to the exact one; without,
// where the operation's definition allows it, and of a formula within half an ulp. Throws
// std::invalid_argument of one line.
std::unique_ptr<const Claim> parse_claim(const std::string& text,
                                         std::optional<double> bound_ulp = {});

}  // namespace judge
