// SPDX-License-Identifier: GPL-3.0-or-later
// The command as seen by somebody at a terminal, through a pseudo-terminal.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "this_build.hpp"

namespace {

using testing::HasSubstr;
using testing::Not;

const std::string fixbench = build_folder() / "bench/fixbench";

std::string content(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "live_test.XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path path;
};

// `fixbench lever` in a window of its own.
class Window {
  public:
    Window(const std::vector<std::string>& arguments, unsigned short columns = 80,
           unsigned short rows = 24, const char* type = "xterm-256color") {
        winsize size{rows, columns, 0, 0};
        int slave;
        if (openpty(&master_, &slave, nullptr, nullptr, &size) != 0) throw std::bad_alloc();
        tcgetattr(master_, &before_);
        child_ = fork();
        if (child_ == 0) {
            close(master_);
            login_tty(slave);
            setenv("TERM", type, 1);
            std::vector<char*> list{const_cast<char*>(fixbench.c_str()),
                                    const_cast<char*>("lever")};
            for (const std::string& argument : arguments)
                list.push_back(const_cast<char*>(argument.c_str()));
            list.push_back(nullptr);
            execv(fixbench.c_str(), list.data());
            _exit(127);
        }
        // The slave stays open here, so that its settings can be examined after the child has
        // ended.
        slave_ = slave;
    }
    ~Window() {
        if (!ended_) {
            kill(child_, SIGKILL);
            waitpid(child_, nullptr, 0);
        }
        close(master_);
        close(slave_);
    }

    // Reads until the text has appeared, or fails after ten seconds.
    bool shows(const std::string& text) {
        for (int i = 0; i < 1000 && output.find(text) == std::string::npos; ++i) read_some(10);
        return output.find(text) != std::string::npos;
    }
    void type(const std::string& keys) {
        ASSERT_EQ(write(master_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
    }
    void wait_for(double seconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (std::chrono::steady_clock::now() < end) read_some(10);
    }
    void send_signal(int number) { kill(child_, number); }
    void resize(unsigned short columns, unsigned short rows) {
        const winsize size{rows, columns, 0, 0};
        ioctl(master_, TIOCSWINSZ, &size);
    }
    // The status of waitpid(), or -1 if it did not end within ten seconds.
    int end() {
        int status = -1;
        for (int i = 0; i < 1000; ++i) {
            read_some(10);
            if (waitpid(child_, &status, WNOHANG) == child_) {
                ended_ = true;
                while (read_some(0)) continue;
                return status;
            }
        }
        return -1;
    }
    bool settings_are_as_before() const {
        termios now{};
        tcgetattr(slave_, &now);
        return now.c_lflag == before_.c_lflag && now.c_iflag == before_.c_iflag &&
               now.c_oflag == before_.c_oflag && now.c_cc[VMIN] == before_.c_cc[VMIN];
    }
    bool settings_are_changed() const { return !settings_are_as_before(); }
    void expect_restored() {
        EXPECT_TRUE(settings_are_as_before());
        EXPECT_GT(output.rfind("\x1b[?1049l"), output.rfind("\x1b[?1049h"));  // alternate screen
        EXPECT_NE(output.rfind("\x1b[?1049l"), std::string::npos);
        EXPECT_GT(output.rfind("\x1b[?25h") + 1, output.rfind("\x1b[?25l") + 1);  // cursor
    }

    std::string output;

  private:
    bool read_some(int milliseconds) {
        pollfd wanted{master_, POLLIN, 0};
        if (poll(&wanted, 1, milliseconds) <= 0) return false;
        char bytes[4096];
        const ssize_t count = read(master_, bytes, sizeof bytes);
        if (count <= 0) return false;
        output.append(bytes, static_cast<std::size_t>(count));
        return true;
    }
    int master_ = -1, slave_ = -1;
    pid_t child_ = -1;
    bool ended_ = false;
    termios before_{};
};

nlohmann::json signals_in(const Folder& folder) {
    return nlohmann::json::parse(content(folder.path / "replay.json"))["signals"];
}
double most(const nlohmann::json& list) {
    double value = list[0];
    for (const double each : list) value = std::max(value, each);
    return value;
}

TEST(Window, KeysReachTheDeviceAndTheTerminalIsRestored) {
    Folder folder;
    Window window({"--record", folder.path.string()});
    ASSERT_TRUE(window.shows("\x1b[?1049h"));
    ASSERT_TRUE(window.shows("real time"));
    EXPECT_TRUE(window.settings_are_changed());
    EXPECT_TRUE(window.shows("q quit"));
    window.wait_for(0.5);
    window.type("\x1b[A");  // up
    window.wait_for(0.3);
    for (int i = 0; i < 20; ++i) window.type(i % 2 ? "\x1bOC" : "\x1b[C");  // right, in both modes
    window.wait_for(0.7);
    window.type("q");
    EXPECT_EQ(window.end(), 0);
    window.expect_restored();
    const auto signals = signals_in(folder);
    EXPECT_GT(most(signals["lever"]), 5);
    EXPECT_NEAR(signals["arm"].back().get<double>(), 0.48, 0.02);
    EXPECT_THAT(content(folder.path / "lever.cast"), HasSubstr("real time"));
}

TEST(Window, ReportsATerminalThatShrinks) {
    Window window({});
    ASSERT_TRUE(window.shows("real time"));
    window.resize(40, 10);
    EXPECT_TRUE(window.shows("too small: 80 x 24"));
    window.output.clear();
    window.resize(80, 24);
    EXPECT_TRUE(window.shows("real time"));
    window.type("q");
    EXPECT_EQ(window.end(), 0);
}

// The lever does not lift itself, nor does the arm grow by itself.
TEST(Window, NothingMovesWhereNoKeyIsPressed) {
    Folder folder;
    Window window({"--record", folder.path.string(), "--seconds", "1"});
    EXPECT_EQ(window.end(), 0);
    const auto signals = signals_in(folder);
    EXPECT_LT(most(signals["lever"]), 1);
    EXPECT_LT(most(signals["arm"]), 0.235);
}

TEST(Window, AResetRestartsTheRecordingOfTheDevice) {
    Folder folder;
    Window window({"--record", folder.path.string()});
    ASSERT_TRUE(window.shows("real time"));
    window.wait_for(0.6);
    window.type("r");
    window.wait_for(0.3);
    window.type("q");
    EXPECT_EQ(window.end(), 0);
    EXPECT_LT(signals_in(folder)["lever"].size() * 0.004, 0.55);
}

class Endings : public testing::TestWithParam<int> {};
TEST_P(Endings, RestoreTheTerminal) {
    Window window({});
    ASSERT_TRUE(window.shows("real time"));
    window.send_signal(GetParam());
    const int status = window.end();
    window.expect_restored();
    if (GetParam() == SIGINT) {
        EXPECT_EQ(status, 0);
    } else {
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == GetParam()) << status;
    }
}
INSTANTIATE_TEST_SUITE_P(Signals, Endings, testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT));

TEST(Window, ControlCAndEscapeEndIt) {
    for (const char* const key : {"\x03", "\x1b"}) {
        Window window({});
        ASSERT_TRUE(window.shows("real time"));
        window.type(key);
        EXPECT_EQ(window.end(), 0);
        window.expect_restored();
    }
}

// One line, and nothing that would spoil the window.
void expect_refused(Window& window, const std::string& reason) {
    const int status = window.end();
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) != 0) << status;
    EXPECT_THAT(window.output, HasSubstr("fixbench: "));
    EXPECT_THAT(window.output, HasSubstr(reason));
    EXPECT_THAT(window.output, Not(HasSubstr("\x1b[?1049h")));
    EXPECT_EQ(std::count(window.output.begin(), window.output.end(), '\n'), 1);
    EXPECT_TRUE(window.settings_are_as_before());
}

TEST(Window, OfTooFewCellsIsRefused) {
    Window narrow({}, 79, 24), low({}, 80, 23);
    expect_refused(narrow, "the window has 79 x 24 cells, at least 80 x 24 are needed");
    expect_refused(low, "80 x 23");
}

TEST(Window, OfAnUnknownTypeIsRefused) {
    Window window({}, 80, 24, "nonsense");
    expect_refused(window, "TERM='nonsense'");
}

// Standard output and error, and the exit code, without any input.
struct Result {
    int status;
    std::string text;
};
Result run(const std::string& arguments) {
    FILE* const pipe = popen((fixbench + " lever " + arguments + " 2>&1 </dev/null").c_str(), "r");
    Result result{};
    for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) result.text += static_cast<char>(c);
    result.status = WEXITSTATUS(pclose(pipe));
    return result;
}

TEST(Lever, SaysThatItNeedsATerminal) {
    const Result result = run("");
    EXPECT_NE(result.status, 0);
    EXPECT_THAT(result.text, HasSubstr("needs a terminal"));
    EXPECT_EQ(std::count(result.text.begin(), result.text.end(), '\n'), 1);
}

TEST(Lever, RefusesAnUnknownScenario) {
    const Folder folder;
    const std::filesystem::path unmade = folder.path / "unmade";
    const Result result = run("--scenario nonsense --record " + unmade.string());
    EXPECT_NE(result.status, 0);
    EXPECT_THAT(result.text, HasSubstr("demonstration"));
    EXPECT_THAT(result.text, HasSubstr("release_and_fall"));
    EXPECT_FALSE(std::filesystem::exists(unmade));
}

TEST(Lever, RefusesAFolderThatIsNotWritableBeforeItStarts) {
    const Result result = run("--record /proc/recording");
    EXPECT_NE(result.status, 0);
    EXPECT_THAT(result.text, HasSubstr("/proc/recording"));
    EXPECT_THAT(result.text, Not(HasSubstr("needs a terminal")));
    EXPECT_EQ(std::count(result.text.begin(), result.text.end(), '\n'), 1);
}

TEST(Lever, RecordsTheSameTwice) {
    Folder first, second;
    const std::string arguments = "--scenario release_and_fall --record ";
    ASSERT_EQ(run(arguments + first.path.string()).status, 0);
    ASSERT_EQ(run(arguments + second.path.string()).status, 0);
    for (const char* const name : {"lever.cast", "lever.svg", "replay.json"}) {
        const std::string bytes = content(first.path / name);
        EXPECT_EQ(bytes, content(second.path / name)) << name;
        EXPECT_GT(bytes.size(), 1000u) << name;
        EXPECT_LT(bytes.size(), 500000u) << name;
    }
    const auto servo = signals_in(first)["servo"];
    EXPECT_NEAR(servo[200].get<double>(), 60, 3);  // held at the top
    EXPECT_NEAR(servo.back().get<double>(), 0, 3);
}

}  // namespace
