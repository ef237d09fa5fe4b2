// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/judge/pipe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace judge {
namespace {

using Operands = std::array<std::int64_t, reference::max_operands>;

constexpr std::size_t calls_of_a_batch = 4096;
constexpr std::size_t longest_line = 4096;

class Writer {
  public:
    Writer(const Claim& claim, std::FILE* out) : claim_(claim), out_(out) {}

    void write(std::span<const std::int64_t> operands, const std::string& what = "") {
        text_.clear();
        fmt::format_to(std::back_inserter(text_), "{}", text_of(claim_, operands));
        if (!what.empty()) fmt::format_to(std::back_inserter(text_), " # {}", what);
        text_.push_back('\n');
        if (std::fwrite(text_.data(), 1, text_.size(), out_) != text_.size())
            throw std::runtime_error("cannot write operands: their reader has ended");
    }

  private:
    const Claim& claim_;
    std::FILE* out_;
    fmt::memory_buffer text_;
};

// Lines of a stream, without their ends. Lines that are too long to be meant are refused.
class Lines {
  public:
    explicit Lines(std::FILE* in) : in_(in), buffer_(std::size_t(1) << 20) {}

    bool next(std::string_view& line) {
        for (;;) {
            const char* const begin = buffer_.data() + begin_;
            if (const void* end = std::memchr(begin, '\n', end_ - begin_)) {
                line = {begin, std::size_t(static_cast<const char*>(end) - begin)};
                begin_ += line.size() + 1;
                return true;
            }
            if (end_ - begin_ > longest_line)
                throw std::invalid_argument("the input has a line of over 4096 characters");
            if (ended_) {
                line = {begin, end_ - begin_};
                begin_ = end_;
                return !line.empty();
            }
            std::memmove(buffer_.data(), begin, end_ - begin_);
            end_ -= begin_;
            begin_ = 0;
            const std::size_t read =
                std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, in_);
            ended_ = read == 0;
            end_ += read;
        }
    }

  private:
    std::FILE* in_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0, end_ = 0;
    bool ended_ = false;
};

// The numbers of a line; numbers beyond the available space are counted but not stored. Returns
// false if the line contains anything else.
bool parse(std::string_view line, std::span<std::int64_t> numbers, std::size_t& count) {
    const char* at = line.data();
    const char* const end = at + line.size();
    for (count = 0;; ++count) {
        while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
        if (at == end || *at == '#') return true;
        std::int64_t number;
        const auto [rest, error] = std::from_chars(at, end, number);
        if (error != std::errc()) return false;
        at = rest;
        if (at != end && *at != ' ' && *at != '\t' && *at != '\r' && *at != '#') return false;
        if (count < numbers.size()) numbers[count] = number;
    }
}

}  // namespace

void write_operands(const Claim& claim, const std::string& operand_class, std::uint64_t samples,
                    std::uint64_t seed, std::FILE* out) {
    Writer writer(claim, out);
    Operands operands{};
    const std::span used(operands.data(), claim.operands().size());
    if (operand_class == "boundary") {
        for (const operands::BoundaryCase& each : claim.boundary_cases())
            writer.write(each.operands, each.what);
    } else if (operand_class == "all") {
        if (claim.input_bits() > 32)
            throw std::invalid_argument(fmt::format(
                "--class all is for operands of at most 32 bits together, these have {}",
                claim.input_bits()));
        for (std::uint64_t i = 0; i < std::uint64_t(1) << claim.input_bits(); ++i) {
            claim.input(i, used);
            writer.write(used);
        }
    } else {
        const operands::OperandClass each = operands::parse_class(operand_class);
        const auto sampler = claim.sampler(each, seed);
        for (std::uint64_t i = operands::distinct_samples(each, samples); i > 0; --i) {
            sampler->next(used);
            writer.write(used);
        }
    }
    if (std::fflush(out) != 0)
        throw std::runtime_error("cannot write operands: their reader has ended");
}

Piped judge_lines(const Claim& claim, std::FILE* in) {
    const std::size_t arity = claim.operands().size(), per_call = arity + claim.results();
    std::vector<const Type*> types;
    for (const Type& operand : claim.operands()) types.push_back(&operand);
    types.insert(types.end(), claim.results(), &claim.result());

    Piped piped;
    std::vector<std::int64_t> operands, results;
    const auto judge_batch = [&] {
        claim.judge_all(operands, results, piped.errors);
        operands.clear();
        results.clear();
    };
    Lines lines(in);
    std::array<std::int64_t, reference::max_operands + reference::max_results> numbers;
    std::string_view line;
    for (std::uint64_t number = 1; lines.next(line); ++number) {
        std::size_t count = 0;
        const auto refuse = [&](const std::string& why) {
            throw std::invalid_argument(
                fmt::format("line {}: {}: '{}'", number, why, line.substr(0, 80)));
        };
        if (!parse(line, numbers, count)) refuse("not decimal numbers of 64 bits");
        if (count == 0) continue;
        if (count != per_call)
            refuse(fmt::format("expected {} operands and {} results, got {} numbers", arity,
                               claim.results(), count));
        for (std::size_t i = 0; i < per_call; ++i) {
            const Type& type = *types[i];
            if (numbers[i] < type.least() || numbers[i] > type.greatest())
                refuse(
                    fmt::format("{} is not in {}..{}", numbers[i], type.least(), type.greatest()));
            const std::int64_t raw = type.format.extend(std::uint64_t(numbers[i]));
            (i < arity ? operands : results).push_back(raw);
        }
        if (++piped.calls % calls_of_a_batch == 0) judge_batch();
    }
    judge_batch();
    if (piped.calls == 0) throw std::invalid_argument("no results on the standard input");
    return piped;
}

}  // namespace judge
