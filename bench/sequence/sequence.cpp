// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sequence/sequence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <list>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "bench/chip/simulator/elf.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/program/output.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/whole_file.hpp"
#include "bench/sequence/comparison.hpp"
#include "bench/sequence/process.hpp"
#include "bench/sequence/times.hpp"
#include "this_build.hpp"

namespace sequence {
namespace {

namespace fs = std::filesystem;
using fixbench::Mode;
using fixbench::Step;

const fs::path state_folder = build_folder() / "bench/sequence";
const fs::path committed_results = source_folder() / "results";
const fs::path committed_header =
    source_folder() / "firmware" / "src" / "firmware" / "calibration_table.hpp";
const fs::path this_program = fs::read_symlink("/proc/self/exe");

volatile std::sig_atomic_t caught = 0;

std::string content_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error(fmt::format("cannot read {}", file.string()));
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string hash_of_text(const std::string& text) {
    return simulator::sha256_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string hash_of(const fs::path& file) { return hash_of_text(content_of(file)); }

// A file of a step: where it was written, and where it belongs.
struct File {
    fs::path made, place, committed;
};

// A step of this run.
struct Job {
    Step step;
    Mode mode;
    fs::path folder;  // its own, in the build folder
    std::vector<std::string> command;
    std::vector<File> files;
    double expected = 0;  // s of one core
    enum { waiting, running, done, failed } state = waiting;
    int status = 0;
};

class Sequence {
  public:
    explicit Sequence(const Options& options)
        : options_(options),
          quick_(options.kind == Kind::quick),
          times_(state_folder / "times.json"),
          pool_(options.threads) {
        results_ = options.results;
        if (results_.empty())
            results_ = options.kind == Kind::full    ? committed_results
                       : options.kind == Kind::quick ? source_folder() / "build" / "quick"
                                                     : source_folder() / "build" / "check";
        for (const Step& step : chosen_steps(options)) jobs_.push_back(job_of(step));
        for (Job& job : jobs_) total_ += job.expected = expected(job.step);
        std::stable_sort(jobs_.begin(), jobs_.end(), [](const Job& a, const Job& b) {
            return std::pair(a.step.times_host, a.expected) >
                   std::pair(b.step.times_host, b.expected);
        });
    }

    int run() {
        fixbench::require_writable(results_ / "data");
        std::set<std::string> targets;
        for (const Job& job : jobs_) {
            const auto& read = quick_ && !job.step.quick_targets.empty() ? job.step.quick_targets
                                                                         : job.step.targets;
            targets.insert(read.begin(), read.end());
        }
        fixbench::build({targets.begin(), targets.end()});
        if (options_.resume) skip_unchanged();
        measure();
        for (Running& each : running_) each.process.stop();
        if (caught != 0) return interrupted();
        const bool sound = std::all_of(jobs_.begin(), jobs_.end(),
                                       [](const Job& job) { return job.state == Job::done; });
        if (!sound) return failures();
        return options_.kind == Kind::check ? compared() : reported();
    }

  private:
    struct Running {
        Job* job;
        Process process;
        double start;
    };

    Job job_of(const Step& step) const {
        Job job{.step = step, .mode = {}, .folder = {}, .command = {}, .files = {}};
        const char* const names[] = {"full", "quick", "check"};
        job.folder = state_folder / names[static_cast<int>(options_.kind)] / step.name;
        const fs::path own_header = job.folder / "header" / committed_header.filename();
        job.mode = {quick_,
                    options_.exhaustive,
                    committed_results / "data",
                    job.folder / "data",
                    job.folder / "figures",
                    own_header};
        job.command = {this_program.string()};
        for (std::string& argument : step.arguments(job.mode))
            job.command.push_back(std::move(argument));
        const auto add = [&](const std::vector<std::string>& names, const char* kind) {
            for (const std::string& name : names)
                job.files.push_back({job.folder / kind / name, results_ / kind / name,
                                     committed_results / kind / name});
        };
        add(step.writes, "data");
        if (!quick_) add(step.full_only, "data");
        add(step.figures, "figures");
        if (step.writes_header)
            job.files.push_back({own_header,
                                 results_ == committed_results
                                     ? committed_header
                                     : results_ / "data" / committed_header.filename(),
                                 committed_header});
        return job;
    }

    double expected(const Step& step) const {
        if (const auto taken = times_.of(step.name, quick_)) return taken->cpu;
        return quick_ ? step.quick_seconds : step.full_seconds;
    }

    // A hash of everything that the results of a step depend on: this program, the call, and its
    // inputs.
    std::string key_of(const Job& job) {
        if (program_hash_.empty()) program_hash_ = hash_of(this_program);
        std::string text = program_hash_;
        for (const std::string& argument : job.step.arguments(job.mode)) text += '\n' + argument;
        for (const fs::path& path : job.step.reads) {
            std::set<fs::path> files;
            if (fs::is_directory(path)) {
                for (const auto& entry : fs::directory_iterator(path))
                    if (entry.path().extension() == ".elf" || entry.path().extension() == ".csv")
                        files.insert(entry.path());
            } else {
                files.insert(path);
            }
            for (const fs::path& file : files) text += '\n' + file.string() + hash_of(file);
        }
        return hash_of_text(text);
    }

    fs::path record_of(const Job& job) const {
        return job.folder.parent_path() / (job.step.name + ".json");
    }

    void remember(const Job& job) {
        nlohmann::json record = {{"key", key_of(job)}};
        for (const File& file : job.files)
            record["files"][file.place.string()] = hash_of(file.place);
        records::write_whole(record_of(job), record.dump(1) + "\n");
    }

    void skip_unchanged() {
        std::vector<std::string> names;
        for (Job& job : jobs_) {
            std::ifstream stream(record_of(job));
            const auto record = nlohmann::json::parse(stream, nullptr, false);
            if (!record.is_object() || record.value("key", "") != key_of(job)) continue;
            const auto files = record.value("files", nlohmann::json::object());
            const bool there =
                std::all_of(job.files.begin(), job.files.end(), [&](const File& file) {
                    return fs::exists(file.place) &&
                           files.value(file.place.string(), "") == hash_of(file.place);
                });
            if (!there) continue;
            job.state = Job::done;
            total_ -= job.expected;
            names.push_back(job.step.name);
        }
        if (!names.empty()) fmt::print(stderr, "fixbench: unchanged: {}\n", fmt::join(names, ", "));
    }

    void start(Job& job) {
        fs::remove_all(job.folder);
        for (const fs::path& folder :
             {job.mode.data, job.mode.figures, job.mode.header.parent_path()})
            fs::create_directories(folder);
        job.state = Job::running;
        running_.push_back(
            {&job, Process(job.command, source_folder(), job.folder / "log", &pool_), elapsed()});
    }

    // Starts as many jobs as there are cores. A job that times this machine goes first and alone.
    void start_more() {
        for (Job& job : jobs_) {
            if (job.state != Job::waiting) continue;
            if (!running_.empty()) {
                if (job.step.times_host || running_.front().job->step.times_host) return;
                if (!pool_.try_take()) return;
            } else {
                // No other job is running: the pool gets all cores but this job's own.
                pool_.refill(options_.threads - 1);
            }
            start(job);
        }
    }

    void measure() {
        struct sigaction action {
        }, former[3];
        action.sa_handler = [](int number) { caught = number; };
        constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
        for (std::size_t i = 0; i < std::size(signals); ++i)
            sigaction(signals[i], &action, &former[i]);
        const auto open = [&] {
            return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& job) {
                return job.state == Job::waiting || job.state == Job::running;
            });
        };
        while (caught == 0 && open()) {
            start_more();
            usleep(50'000);
            for (auto each = running_.begin(); each != running_.end();) {
                if (const auto status = each->process.ended()) {
                    finish(*each, *status);
                    pool_.give_back();
                    each = running_.erase(each);
                } else {
                    ++each;
                }
            }
            show();
        }
        clear_line();
        for (std::size_t i = 0; i < std::size(signals); ++i)
            sigaction(signals[i], &former[i], nullptr);
    }

    void finish(const Running& of, int status) {
        Job& job = *of.job;
        job.status = status;
        job.state = Job::failed;
        clear_line();
        if (status == 0) {
            try {
                publish(job);
                job.state = Job::done;
                const Taken taken{of.process.cpu_seconds(), elapsed() - of.start};
                times_.set(job.step.name, quick_, taken);
                fmt::print(stderr, "{}: {}\n", job.step.name,
                           records::Progress::duration(taken.wall));
            } catch (const std::exception& error) {
                fmt::print(stderr, "{}: {}\n", job.step.name, error.what());
            }
        } else {
            fmt::print(stderr, "{}: failed with exit status {}; its last output:\n{}",
                       job.step.name, status, last_lines(job.folder / "log", 20));
        }
    }

    // Checks that the step wrote exactly what it is registered to write, then moves its files.
    void publish(Job& job) {
        std::set<fs::path> expected;
        for (const File& file : job.files) {
            if (!fs::exists(file.made))
                throw std::runtime_error(
                    fmt::format("did not write {}", file.made.filename().string()));
            expected.insert(file.made);
        }
        for (const auto& entry : fs::recursive_directory_iterator(job.folder))
            if (entry.is_regular_file() && entry.path().filename() != "log" &&
                !expected.contains(entry.path()))
                throw std::runtime_error(
                    fmt::format("wrote {}, which it is not registered to write",
                                entry.path().filename().string()));
        // Copied next to their places and renamed there, since the build folder may be on another
        // disk.
        for (const File& file : job.files) records::write_whole(file.place, content_of(file.made));
        remember(job);
    }

    static std::string last_lines(const fs::path& file, std::size_t count) {
        std::ifstream stream(file);
        std::vector<std::string> lines;
        for (std::string line; std::getline(stream, line);) lines.push_back(line);
        std::string text;
        const std::size_t first = lines.size() > count ? lines.size() - count : 0;
        for (std::size_t i = first; i < lines.size(); ++i) text += "    " + lines[i] + '\n';
        return text;
    }

    double elapsed() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    // For the unfinished jobs: their previous times, less what they have used.
    double core_seconds_left() const {
        double left = 0;
        for (const Job& job : jobs_)
            if (job.state == Job::waiting) left += job.expected;
        for (const Running& each : running_)
            left += std::max(0.05 * each.job->expected,
                             each.job->expected - each.process.cpu_seconds());
        return left;
    }

    void show() {
        const double now = elapsed();
        if (now < next_show_) return;
        next_show_ = now + (terminal_ ? 0.5 : 30);
        const double left = core_seconds_left();
        const double share = total_ > 0 ? std::clamp(1 - left / total_, 0.0, 1.0) : 1;
        std::vector<std::string> names;
        for (const Running& each : running_) names.push_back(each.job->step.name);
        const auto done = std::count_if(jobs_.begin(), jobs_.end(),
                                        [](const Job& job) { return job.state == Job::done; });
        constexpr int width = 20;
        const int filled = static_cast<int>(share * width);
        clear_line();
        fmt::print(stderr, "[{:#<{}}{:.<{}}] {:3.0f}% {} left, {} of {} done: {}{}", "", filled, "",
                   width - filled, 100 * share,
                   records::Progress::duration(left / options_.threads), done, jobs_.size(),
                   fmt::join(names, ", "), terminal_ ? "" : "\n");
        std::fflush(stderr);
        shown_ = terminal_;
    }

    void clear_line() {
        if (shown_) fmt::print(stderr, "\r\033[K");
        shown_ = false;
    }

    int interrupted() const {
        const auto done = std::count_if(jobs_.begin(), jobs_.end(),
                                        [](const Job& job) { return job.state == Job::done; });
        fmt::print(stderr,
                   "fixbench: interrupted; {} of {} steps are done and kept; --resume continues\n",
                   done, jobs_.size());
        std::signal(caught, SIG_DFL);
        std::raise(caught);
        return fixbench::wrong_call;
    }

    int failures() const {
        int code = fixbench::check_failed;
        std::vector<std::string> names;
        for (const Job& job : jobs_) {
            if (job.state != Job::failed) continue;
            names.push_back(job.step.name);
            if (job.status > fixbench::check_failed) code = fixbench::wrong_call;
        }
        fmt::print(stderr,
                   "fixbench: failed: {}; what they wrote is in {}, the other results are "
                   "in place\n",
                   fmt::join(names, ", "), jobs_.front().folder.parent_path().string());
        return code;
    }

    int compared() const {
        std::vector<std::string> differences;
        std::size_t equal = 0;
        for (const Job& job : jobs_)
            for (const File& file : job.files) {
                const std::string difference = first_difference(file.committed, file.place);
                if (difference.empty())
                    ++equal;
                else
                    differences.push_back(difference);
            }
        for (const std::string& name : unclaimed(committed_results / "data"))
            differences.push_back(fmt::format("{}: no experiment writes it", name));
        for (const std::string& difference : differences) fmt::print(stderr, "{}\n", difference);
        if (!differences.empty()) {
            fmt::print(stderr, "fixbench: {} of {} files differ from {}\n", differences.size(),
                       differences.size() + equal, committed_results.string());
            return fixbench::check_failed;
        }
        fmt::print(stderr, "fixbench: all {} deterministic files equal {}\n", equal,
                   committed_results.string());
        return fixbench::held;
    }

    static std::vector<std::string> unclaimed(const fs::path& folder) {
        // Those that the report writes.
        std::set<std::string> claimed = {"bounds.csv", "columns.json", "tools.json"};
        for (const Step& step : all_steps())
            for (const auto* list : {&step.writes, &step.full_only})
                claimed.insert(list->begin(), list->end());
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder))
            if (!claimed.contains(entry.path().filename().string()))
                names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

    // Makes figures and pages if all their data are there.
    int reported() {
        for (const Step& step : all_steps())
            for (const std::string& name : step.writes)
                if (!step.only_exhaustive && !fs::exists(results_ / "data" / name)) {
                    fmt::print(stderr, "fixbench: no report yet: {} is missing\n", name);
                    return fixbench::held;
                }
        const fs::path log = state_folder / "report.log";
        Process report(
            {this_program.string(), "report", "--measured-here", "--results", results_.string()},
            source_folder(), log, nullptr);
        std::optional<int> status;
        while (!(status = report.ended())) usleep(50'000);
        if (*status != 0) {
            fmt::print(stderr, "report: failed with exit status {}; its last output:\n{}", *status,
                       last_lines(log, 20));
            return *status > fixbench::check_failed ? fixbench::wrong_call : fixbench::check_failed;
        }
        fmt::print(stderr, "fixbench: wrote {} in {}\n", (results_ / "README.md").string(),
                   records::Progress::duration(elapsed()));
        return fixbench::held;
    }

    const Options& options_;
    const bool quick_;
    Times times_;
    lab::Pool pool_;
    fs::path results_;
    std::vector<Job> jobs_;
    std::list<Running> running_;
    std::string program_hash_;
    double total_ = 0, next_show_ = 0;
    const bool terminal_ = isatty(STDERR_FILENO) != 0;
    bool shown_ = false;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

std::vector<Step> all_steps() {
    std::vector<Step> steps;
    for (const fixbench::Experiment& experiment : fixbench::experiments())
        steps.insert(steps.end(), experiment.steps.begin(), experiment.steps.end());
    return steps;
}

std::vector<Step> chosen_steps(const Options& options) {
    std::vector<Step> steps = all_steps();
    std::vector<std::string> known;
    for (const Step& step : steps) known.push_back(step.name);
    fixbench::check_names("--only", options.only, known);
    std::erase_if(steps, [&](const Step& step) {
        const bool named =
            std::find(options.only.begin(), options.only.end(), step.name) != options.only.end();
        if (options.kind == Kind::check && step.times_host) return true;
        if (!options.only.empty()) return !named;
        return step.only_exhaustive && !options.exhaustive;
    });
    if (steps.empty())
        throw std::invalid_argument(
            "--only: these figures differ from run to run, so --check "
            "leaves them out");
    return steps;
}

int run_all(const Options& options) { return Sequence(options).run(); }

std::string readable_list() {
    const Times times(state_folder / "times.json");
    const auto took = [&](const Step& step, bool quick) {
        const auto taken = times.of(step.name, quick);
        return taken ? records::Progress::duration(taken->wall) : std::string("-");
    };
    std::string text =
        fmt::format("{:<16} {:>7} {:>7}  {}\n", "experiment", "full", "quick", "writes");
    for (const Step& step : all_steps()) {
        std::vector<std::string> files = step.writes;
        files.insert(files.end(), step.full_only.begin(), step.full_only.end());
        files.insert(files.end(), step.figures.begin(), step.figures.end());
        text += fmt::format("{:<16} {:>7} {:>7}  {}\n", step.name, took(step, false),
                            took(step, true), fmt::join(files, ", "));
    }
    return text;
}

std::string json_list() {
    const Times times(state_folder / "times.json");
    nlohmann::ordered_json list = nlohmann::json::array();
    for (const Step& step : all_steps()) {
        nlohmann::ordered_json entry = {
            {"name", step.name},       {"command", "fixbench all --only " + step.name},
            {"writes", step.writes},   {"full_only", step.full_only},
            {"figures", step.figures}, {"targets", step.targets}};
        for (const bool quick : {false, true}) {
            const auto taken = times.of(step.name, quick);
            entry[quick ? "quick_seconds" : "full_seconds"] =
                taken ? nlohmann::ordered_json(taken->wall) : nlohmann::ordered_json();
        }
        list.push_back(std::move(entry));
    }
    return list.dump(1) + "\n";
}

}  // namespace sequence
