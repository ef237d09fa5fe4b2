// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/instructions/convention.hpp"

#include <algorithm>

#include "bench/chip/simulator/chip.hpp"

namespace machine_code {
namespace {

constexpr int pointer_size = 2, return_address_size = 2;
// Both areas lie across a 256-byte page, where a pointer's low byte wraps.
constexpr std::uint16_t operand_area = 0x01f9, result_area = 0x02fb;

// Operands go from r25 downwards, each to an even register; from the first one that would begin
// below r8 on, all go onto the stack, the first at the lowest address, without padding.
std::vector<Place> places_of(const std::vector<int>& sizes, Convention& convention) {
    std::vector<Place> places;
    int next_register = 26, stack_bytes = 0;
    for (const int size : sizes) {
        next_register -= size + size % 2;
        if (next_register < 8) {
            next_register = 0;
            stack_bytes += size;
        }
        places.push_back({std::uint16_t(next_register), size});
    }
    int address = simulator::Chip::ram_end - stack_bytes;
    convention.entry_stack_pointer = std::uint16_t(address - return_address_size - 1);
    for (Place& place : places) {
        if (place.address) continue;
        place.address = std::uint16_t(address);
        address += place.size;
    }
    return places;
}

Place result_register(int size) { return {std::uint16_t(26 - size - size % 2), size}; }

std::vector<Place> vector_at(std::uint16_t address, std::size_t count, int size) {
    std::vector<Place> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back({std::uint16_t(address + int(i) * size), size});
    return places;
}

}  // namespace

Convention convention_of(const std::vector<int>& operand_sizes, int result_size) {
    Convention convention{};
    convention.operands = places_of(operand_sizes, convention);
    if (result_size) convention.results = {result_register(result_size)};
    return convention;
}

Convention convention_of(const reference::Subject& subject) {
    const reference::OperationShape& shape = reference::shape(subject.operation);
    const int result_size = subject.format.width / 8;
    const int operand_size = subject.operand_format.width / 8;
    const std::size_t vectors = reference::vector_operands(subject.operation);
    const bool returns = shape.results == 1;

    const std::size_t scalars = vectors ? 0 : shape.operands;
    std::vector<int> sizes(scalars, operand_size);
    if (reference::is_shift(subject.operation)) sizes[1] = 1;
    sizes.insert(sizes.end(), vectors + !returns, pointer_size);

    Convention convention{};
    const std::vector<Place> places = places_of(sizes, convention);
    convention.operands.assign(places.begin(), places.begin() + std::ptrdiff_t(scalars));
    if (vectors) {
        convention.operands = vector_at(operand_area, shape.operands, operand_size);
        convention.operand_area = {operand_area, int(shape.operands) * operand_size};
        const std::size_t bytes = shape.operands / vectors * std::size_t(operand_size);
        for (std::size_t i = 0; i < vectors; ++i)
            convention.pointers.push_back({places[i], std::uint16_t(operand_area + i * bytes)});
    }
    if (returns) {
        convention.results = {result_register(result_size)};
    } else {
        convention.results = vector_at(result_area, shape.results, result_size);
        convention.result_area = {result_area, int(shape.results) * result_size};
        convention.pointers.push_back({places.back(), result_area});
    }
    return convention;
}

}  // namespace machine_code
