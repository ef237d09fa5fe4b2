// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/calibration/command.hpp"

#include <memory>

#include "bench/experiments/calibration/calibrate.hpp"

namespace calibration {

void add_calibrate_command(CLI::App& app, fixbench::Action& action) {
    const auto options = std::make_shared<Options>();
    options->output = "results/data";
    options->header = "firmware/src/firmware/calibration_table.hpp";
    options->program = {CALIBRATION_ELF, CALIBRATION_FOOTPRINTS};
    CLI::App* command = app.add_subcommand(
        "calibrate",
        "The curve of a force sensor from its readings under known weights.\n"
        "Writes the firmware's header, calibration.csv, calibration_candidates.csv and\n"
        "calibration_verdicts.csv (whether the published readings give the published curve).\n\n"
        "READINGS is a CSV file of 5 rows or more with the columns adc_reading (0 to 1023) and\n"
        "actual_g, both rising. Families of curves are fitted by least squares; each is run on\n"
        "the simulated chip for all 1024 readings. Of those within one standard error of the\n"
        "least leave-one-out error the one of fewest cycles is taken.\n\n"
        "Example: fixbench calibrate reference/published/table_d_1.csv");
    command->add_option("readings", options->readings, "the readings")
        ->required()
        ->check(CLI::ExistingFile);
    command->add_option("--output", options->output, "folder that the data files are written to")
        ->capture_default_str();
    command->add_option("--header", options->header, "the header to write")->capture_default_str();
    command->callback([options, &action] {
        action = [options] {
            calibrate(*options);
            return EXIT_SUCCESS;
        };
    });
}

}  // namespace calibration
