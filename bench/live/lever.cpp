// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/lever.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/whole_file.hpp"
#include "bench/live/film.hpp"
#include "bench/live/pace.hpp"
#include "bench/live/panel.hpp"
#include "bench/live/replay.hpp"
#include "bench/live/terminal.hpp"

namespace live {
namespace {

using haptic::degrees;

constexpr int samples_a_picture = 10;  // 25 pictures a second
constexpr double picture_period = samples_a_picture * Replay::sample;
constexpr double longest_alone = 60;  // s

// Nobody at the lever, which rests on its lower stop.
haptic::Scenario by_hand() {
    haptic::Scenario s{"live", "somebody plays with it", 0, {}, 1, {}};
    s.script.dial.from(0);
    return s;
}

// A session and what is recorded of it.
class Show {
  public:
    Show(Session& session, bool recorded) : session_(session) {
        if (recorded) replay_.emplace(session_);
    }

    // Advances time by one sample.
    void sample() {
        session_.run_until(static_cast<double>(++samples_) * Replay::sample);
        if (replay_) replay_->watch(session_);
    }
    bool picture_due() const { return samples_ % samples_a_picture == 0; }
    Picture picture(const std::optional<WallClock>& clock) {
        const Picture picture = panel(session_, clock);
        if (replay_) film_.add(session_.time(), picture);
        return picture;
    }
    void press(Key key) {
        session_.press(key);
        if (key == Key::reset && replay_) replay_.emplace(session_);
    }

    void save(const std::filesystem::path& folder) {
        film_.end(session_.time());
        const std::string title = fmt::format(
            "haptic lever, {}, {}", session_.firmware().arithmetic, session_.scenario().name);
        records::write_whole(folder / "lever.cast", film_.cast(title));
        records::write_whole(folder / "lever.svg", film_.svg(title));
        records::write_whole(folder / "replay.json", replay_->json(session_));
    }

  private:
    Session& session_;
    Film film_;
    std::optional<Replay> replay_;
    long long samples_ = 0;
};

// A folder that cannot take a recording is reported before somebody plays, not after.
void try_folder(const std::filesystem::path& folder) {
    records::write_whole(folder / "lever.trial", "");
    std::filesystem::remove(folder / "lever.trial");
}

double wall_clock() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

// Runs until somebody ends it, or until `end`, in s. Returns the signal that ended it, or 0.
int play(Session& session, Show& show, double end) {
    Terminal terminal;
    const double start = wall_clock();
    Pace pace(0);
    const auto wall = [&] { return wall_clock() - start; };
    double shown = -picture_period;
    while (Terminal::signal() == 0 && session.time() < end) {
        const double due = std::min(pace.due(wall(), session.time()), end);
        const double turn_ends = wall() + picture_period;
        while (session.time() < due && wall() < turn_ends) show.sample();
        if (wall() - shown >= picture_period) {
            shown = wall();
            terminal.show(show.picture(WallClock{wall(), pace.factor()}));
        }
        const bool behind = session.time() < due;
        const auto key = terminal.key(behind ? 0 : shown + picture_period - wall());
        if (key == Key::quit) break;
        if (key) show.press(*key);
    }
    return Terminal::signal();
}

void run_alone(Session& session, Show& show, double end) {
    records::Progress progress("lever", static_cast<std::uint64_t>(end / picture_period));
    show.picture({});
    while (session.time() < end) {
        show.sample();
        if (!show.picture_due()) continue;
        show.picture({});
        progress.advance();
    }
}

haptic::Firmware chosen(const Options& options) {
    for (const haptic::Firmware& firmware : haptic::firmwares(options.firmware))
        if (firmware.arithmetic == options.arithmetic) return firmware;
    throw std::invalid_argument(fmt::format("no arithmetic '{}'", options.arithmetic));
}

haptic::Scenario chosen_scenario(const std::string& name) {
    if (name.empty()) return by_hand();
    if (name == demonstration().name) return demonstration();
    try {
        return haptic::scenario(name);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("{}, {}", error.what(), demonstration().name));
    }
}

}  // namespace

haptic::Scenario demonstration() {
    haptic::Scenario s{"demonstration",
                       "pushed up and held while the dial makes the arm longer; let go, it falls, "
                       "bounces and rests",
                       4,
                       {},
                       1,
                       {}};
    s.script.hand_grip.from(1).step(2, 0);
    s.script.hand_angle.from(0).ramp(0.2, 0.8, degrees(50));
    s.script.dial.from(0).ramp(1, 1.6, 0.6);
    return s;
}

int run_lever(const Options& options) {
    const bool recorded = !options.record.empty(), alone = recorded && !options.scenario.empty();
    Session session(chosen(options), chosen_scenario(options.scenario));
    if (recorded) try_folder(options.record);
    Show show(session, recorded);
    int signal = 0;
    if (alone) {
        run_alone(session, show,
                  options.seconds.value_or(std::min(session.scenario().duration, longest_alone)));
    } else {
        signal =
            play(session, show, options.seconds.value_or(std::numeric_limits<double>::infinity()));
    }
    if (recorded) show.save(options.record);
    // Ctrl-C is a regular way to end; for any other signal, the exit status must show it.
    if (signal != 0 && signal != SIGINT) std::raise(signal);
    return EXIT_SUCCESS;
}

}  // namespace live
