// SPDX-License-Identifier: MIT
/// \file
/// Profiling by pins: a pin is high while its category runs. A category that the board's
/// configuration does not list in `profiled` compiles to nothing.
#pragma once

#include <engine/choice.hpp>
#include <firmware/configuration.hpp>

namespace firmware {

/// Profiles a category from here to the end of the block. A category nested in itself ends with the
/// inner block.
template <class Board, Category category>
class Profiled {
  public:
    /// Raises the pin, and lowers it at the end of the block.
    /// @{
    Profiled() { Board::template raise<category>(); }
    ~Profiled() { Board::template lower<category>(); }
    /// @}
    Profiled(const Profiled&) = delete;
    Profiled& operator=(const Profiled&) = delete;
};

/// Like Profiled, but the compiler keeps the operation between the edges: otherwise it might
/// compute inlined operations before the pin rises or after it falls. `operands` are the inputs of
/// the operation.
template <class Board, Category category>
class ProfiledOperation {
  public:
    /// Raises the pin, and lowers it at the end of the block.
    /// @{
    template <class... Values>
    explicit ProfiledOperation(Values&... operands) {
        Board::template raise<category>();
        fence();
        const bool settled[] = {true, settle(operands)...};
        static_cast<void>(settled);
    }
    ~ProfiledOperation() {
        fence();
        Board::template lower<category>();
    }
    /// @}
    ProfiledOperation(const ProfiledOperation&) = delete;
    ProfiledOperation& operator=(const ProfiledOperation&) = delete;

    /// The value, computed before the pin falls.
    template <class Value>
    Value result(Value value) const {
        settle(value);
        return value;
    }

  private:
    static constexpr bool on = contains(Board::Configuration::profiled, category);

    static void fence() {
        if (on) asm volatile("" ::: "memory");
    }
    template <class Value>
    static bool settle(Value& value) {
        if (on) asm volatile("" : "+r"(value));
        return true;
    }
};

/// Watched if one of the categories is profiled, otherwise Plain itself: the same program as
/// without.
template <class Board, uint8_t categories, class Watched, class Plain>
using WhereProfiled = typename engine::Either<(Board::Configuration::profiled & categories) != 0,
                                              Watched, Plain>::Type;

/// \cond internal
template <class Board, class Arithmetic>
struct WatchedArithmetic : Arithmetic {
    template <class Raw, int F>
    static Raw multiply(Raw a, Raw b) {
        const Operation profiled(a, b);
        return profiled.result(Arithmetic::template multiply<Raw, F>(a, b));
    }
    template <class Raw, int F>
    static Raw divide(Raw a, Raw b) {
        const Operation profiled(a, b);
        return profiled.result(Arithmetic::template divide<Raw, F>(a, b));
    }
    template <class Raw, int F, class A = Arithmetic>
    static auto multiply_add(Raw a, Raw b, Raw c)
        -> decltype(A::template multiply_add<Raw, F>(a, b, c)) {
        const Operation profiled(a, b, c);
        return profiled.result(Arithmetic::template multiply_add<Raw, F>(a, b, c));
    }
    template <class Raw, int F, class A = Arithmetic>
    static auto dot2(const Raw* a, const Raw* b) -> decltype(A::template dot2<Raw, F>(a, b)) {
        const Operation profiled(a, b);
        return profiled.result(Arithmetic::template dot2<Raw, F>(a, b));
    }
    template <class Raw, int F, class A = Arithmetic>
    static auto dot3(const Raw* a, const Raw* b) -> decltype(A::template dot3<Raw, F>(a, b)) {
        const Operation profiled(a, b);
        return profiled.result(Arithmetic::template dot3<Raw, F>(a, b));
    }
    template <class Raw, int F>
    static Raw sqrt(Raw a) {
        const SquareRoot profiled(a);
        return profiled.result(Arithmetic::template sqrt<Raw, F>(a));
    }
    template <class Raw, int F, class A = Arithmetic>
    static auto length2(const Raw* v) -> decltype(A::template length2<Raw, F>(v)) {
        const SquareRoot profiled(v);
        return profiled.result(Arithmetic::template length2<Raw, F>(v));
    }
    template <class Raw, int F, class A = Arithmetic>
    static auto length3(const Raw* v) -> decltype(A::template length3<Raw, F>(v)) {
        const SquareRoot profiled(v);
        return profiled.result(Arithmetic::template length3<Raw, F>(v));
    }

  private:
    using Operation = ProfiledOperation<Board, Category::operation>;
    using SquareRoot = ProfiledOperation<Board, Category::square_root>;
};
/// \endcond

/// An arithmetic for Fixed that raises the pin of `operation` for products, quotients and sums of
/// products, and the pin of `square_root` for square roots and lengths. It lacks the operations
/// that the arithmetic lacks.
template <class Board, class Arithmetic>
using ProfiledArithmetic = WhereProfiled<Board, set_of(Category::operation, Category::square_root),
                                         WatchedArithmetic<Board, Arithmetic>, Arithmetic>;

/// \cond internal
template <class Board, class Integrator>
struct WatchedIntegrator : Integrator {
    template <class World, class TimeStep>
    static void step(World& world, TimeStep dt) {
        Parts<World> parts{world};
        Integrator::step(parts, dt);
    }

  private:
    using Collision = ProfiledOperation<Board, Category::collision>;

    // The part of a world that an integrator uses.
    template <class World>
    struct Parts {
        World& world;

        void accumulate_forces() { world.accumulate_forces(); }
        template <class TimeStep>
        void integrate_velocities(TimeStep dt) {
            world.integrate_velocities(dt);
        }
        template <class TimeStep>
        void integrate_positions(TimeStep dt) {
            world.integrate_positions(dt);
        }
        void damp() { world.damp(); }
        template <class TimeStep>
        void collect_constraints(TimeStep dt) {
            const Collision profiled;
            world.collect_constraints(dt);
        }
        void solve_constraints() {
            const Collision profiled;
            world.solve_constraints();
        }
    };
};
/// \endcond

/// An integrator of the engine that raises the pin of `collision` twice a step: while it finds
/// contacts and constraints, and while it solves them.
template <class Board, class Integrator>
using ProfiledIntegrator = WhereProfiled<Board, set_of(Category::collision),
                                         WatchedIntegrator<Board, Integrator>, Integrator>;

}  // namespace firmware
