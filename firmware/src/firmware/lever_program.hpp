// SPDX-License-Identifier: MIT
/// \file
/// The lever as a program on a Board: steps when they are due, frames in between, and sleep for the
/// rest.
///
///     Program::start();
///     for (;;) Program::pass();
///
/// Any byte received on the serial port requests a full frame.
#pragma once

#include <firmware/frame_clock.hpp>
#include <firmware/lever.hpp>
#include <firmware/profiling.hpp>
#include <firmware/renderer.hpp>

namespace firmware {

/// The lever's configuration of its Board: 60 degrees of the servo, and pins that show when it
/// works.
struct LeverWiring : Configuration {
    /// See Configuration.
    /// @{
    static constexpr uint16_t servo_shortest = 1000;
    static constexpr uint16_t servo_longest = 1667;
    static constexpr uint16_t servo_at_start = 1000;
    static constexpr uint8_t profiled = set_of(Category::step, Category::render);
    /// @}
};

/// \cond internal
// The same choices, with the pin of contacts driven.
template <class Board, class Choices>
struct WatchedSteps : Choices {
    struct Method : Choices::Method {
        using Integrator = ProfiledIntegrator<Board, typename Choices::Method::Integrator>;
    };
};
/// \endcond

/// The program of a board. Everything is static, since there is only one.
template <class Board, class Choices, class Screen = firmware::Screen>
class LeverProgram {
  public:
    /// The lever, watched if its contacts are profiled.
    using Lever = firmware::Lever<
        WhereProfiled<Board, set_of(Category::collision), WatchedSteps<Board, Choices>, Choices>>;

    /// Starts the board and the clocks.
    static void start() {
        Board::start();
        steps = Steps(Board::ticks());
        frames = Frames<>(Board::ticks());
    }

    /// Makes the steps that are due, then sends a part of a frame, then sleeps until the next
    /// interrupt.
    static void pass() {
        uint32_t now = Board::ticks();
        while (const auto length = steps.due(now)) {
            step(length);
            now = Board::ticks();
            steps.done(now);
        }
        render(now);
        Board::idle();
    }

    /// When a step is due.
    using Steps = typename Choices::Steps;
    /// The lever.
    static Lever lever;
    /// The clock of its steps.
    static Steps steps;
    /// The clock of its frames.
    static Frames<> frames;
    /// Shows the lever.
    static Renderer<Board, Screen> renderer;

  private:
    template <class Length>
    static void step(Length length) {
        const Profiled<Board, Category::step> profiled;
        Board::command_servo(lever.step(Board::readings(), Choices::time_step(length)));
    }
    static void render(uint32_t now) {
        const bool idle = renderer.idle();
        if (idle && !frames.due(now)) return;
        const Profiled<Board, Category::render> profiled;
        if (idle) {
            if (Board::read() >= 0) renderer.refresh();
            lever.draw(renderer.begin());
            renderer.finish();
        }
        renderer.transmit();
    }
};

template <class B, class C, class S>
typename LeverProgram<B, C, S>::Lever LeverProgram<B, C, S>::lever;
template <class B, class C, class S>
typename LeverProgram<B, C, S>::Steps LeverProgram<B, C, S>::steps(0);
template <class B, class C, class S>
Frames<> LeverProgram<B, C, S>::frames(0);
template <class B, class C, class S>
Renderer<B, S> LeverProgram<B, C, S>::renderer;

}  // namespace firmware
