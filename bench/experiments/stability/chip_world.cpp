// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/chip_world.hpp"

#include <fmt/format.h>

#include <fixedpoint/conversion.hpp>
#include <stdexcept>
#include <vector>

namespace stability {
namespace {

constexpr simulator::Cycle longest_step = 50'000'000;

}  // namespace

ChipWorld::ChipWorld(const std::filesystem::path& program, const Description& description)
    : chip_(simulator::Elf(program)),
      step_(chip_, "step", {.result = 0, .operands = {}}),
      error_(chip_, "world_error", {.result = 1, .operands = {}}),
      hash_(chip_, "state_hash", {.result = 4, .operands = {}}) {
    chip_.run_until_function("main");
    step_.set_budget(longest_step);
    simulator::DeviceFunction exponent(chip_, "step_exponent", {.result = 1, .operands = {}});
    const int of_program = exponent().as<std::uint8_t>();
    if (description.dt.seconds > 0 || description.dt.exponent != of_program)
        throw std::runtime_error(fmt::format("{}: its step is 2^-{} s, not that of the scene",
                                             program.string(), of_program));

    const Description& d = description;
    call("set_world",
         {d.gravity.x, d.gravity.y, d.gravity.z, d.restitution, d.restitution_threshold});
    for (const Body& body : d.bodies)
        call("add_particle", {body.position.x, body.position.y, body.position.z, body.velocity.x,
                              body.velocity.y, body.velocity.z, body.inverse_mass, body.radius,
                              body.damping, body.force.x, body.force.y, body.force.z});
    for (const Spring& it : d.springs)
        call("add_spring",
             {it.length, it.anchor.x, it.anchor.y, it.anchor.z, it.stiffness, it.damping}, it.a,
             it.b);
    for (const Link& it : d.rods)
        call("add_rod", {it.length, it.anchor.x, it.anchor.y, it.anchor.z}, it.a, it.b);
    for (const Rope& it : d.ropes)
        call("add_rope", {it.length, it.anchor.x, it.anchor.y, it.anchor.z, it.restitution}, it.a,
             it.b);
    for (const Drag& it : d.drags) call("add_drag", {it.linear, it.quadratic}, it.a);
    for (const Plane& it : d.planes)
        call("add_plane", {it.normal.x, it.normal.y, it.normal.z, it.offset, it.restitution});
}

void ChipWorld::call(const char* function, std::initializer_list<double> numbers, int a, int b) {
    std::vector<std::uint8_t> bytes;
    for (const double number : numbers) {
        const std::int32_t raw = fixedpoint::from_float<fixedpoint::Q16_16>(number).raw();
        const auto* const first = reinterpret_cast<const std::uint8_t*>(&raw);
        bytes.insert(bytes.end(), first, first + sizeof raw);
    }
    const auto address = [this](const char* name) {
        return static_cast<std::uint16_t>(chip_.elf().object(name).address);
    };
    chip_.write(address("numbers"), bytes);
    const std::uint8_t ends[] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
    chip_.write(address("ends"), ends);
    simulator::DeviceFunction(chip_, function, {.result = 0, .operands = {}})();
}

}  // namespace stability
