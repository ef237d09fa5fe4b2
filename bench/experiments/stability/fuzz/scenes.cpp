// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: worlds with any numbers, links and capacities, in every scalar and method. Nothing may
// trap, hang or read out of bounds; the sanitizers detect it.
#include <cstdint>
#include <cstring>

#include "bench/experiments/stability/subject.hpp"

namespace {

// Numbers from the remaining bytes; zeros when there are none left.
class Source {
  public:
    Source(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
    std::uint8_t byte() {
        if (left_ == 0) return 0;
        --left_;
        return *data_++;
    }
    // Of every magnitude, including values that are difficult for formats.
    double number() {
        const std::uint8_t kind = byte();
        const auto small = static_cast<std::int8_t>(byte());
        if (kind < 64) return small;
        if (kind < 128) return small / 64.0;
        if (kind < 200) return small * std::ldexp(1.0, kind - 164);
        if (kind < 230) return std::ldexp(small < 0 ? -1.0 : 1.0, small);
        std::uint64_t bits = 0;
        for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
        double any;
        std::memcpy(&any, &bits, sizeof any);
        return any;
    }
    stability::Point point() {
        const double x = number();
        return {x, number()};
    }

  private:
    const std::uint8_t* data_;
    std::size_t left_;
};

stability::Link link(Source& source) {
    stability::Link made;
    made.a = source.byte() % 24;  // may be beyond the bodies
    made.b = source.byte() % 24 - 1;
    made.anchor = source.point();
    made.length = source.number();
    return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Source source(data, size);
    const auto& all = stability::subjects();
    const stability::Subject& subject = all[source.byte() % all.size()];
    stability::Description made;
    for (int i = source.byte() % 22; i > 0; --i)
        made.bodies.push_back({source.point(), source.point(), source.number(), source.number(),
                               source.point(), source.number()});
    for (int i = source.byte() % 5; i > 0; --i)
        made.springs.push_back({link(source), source.number(), source.number()});
    for (int i = source.byte() % 20; i > 0; --i) made.rods.push_back(link(source));
    for (int i = source.byte() % 5; i > 0; --i)
        made.ropes.push_back({link(source), source.number()});
    for (int i = source.byte() % 4; i > 0; --i)
        made.drags.push_back({source.byte() % 24, source.number(), source.number()});
    for (int i = source.byte() % 6; i > 0; --i)
        made.planes.push_back({source.point(), source.number(), source.number()});
    made.gravity = source.point();
    made.restitution = source.number();
    made.restitution_threshold = source.number();
    made.dt = source.byte() % 2 == 0 ? stability::TimeStep::binary(source.byte() % 36)
                                     : stability::TimeStep::of_seconds(source.number());
    made.steps = 8;
    subject.run(made, [](const stability::State&, unsigned) { return true; });
    return 0;
}
