// SPDX-License-Identifier: GPL-3.0-or-later
// fixbench calibrate.
#include <memory>

#include "bench/experiments/calibration/calibrate.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/experiment.hpp"

namespace calibration {
namespace {

const fixbench::Registration registration({
    .name = "calibrate",
    .description =
        "Fits the curve of a force sensor to its readings under known weights. Files:\n"
        "calibration_candidates.csv, calibration.csv and calibration_verdicts.csv (whether the\n"
        "published readings give the published curve); with --header, also the firmware's\n"
        "header.\n\n"
        "READINGS is a CSV file with the columns adc_reading (0 to 1023) and actual_g, as\n"
        "spreadsheets write it: separated by commas or, with decimal commas, by semicolons. At\n"
        "least 5 weights are needed, in any order, and readings must rise with them; repeated\n"
        "readings of a weight are averaged. Families of curves are fitted by least squares, and\n"
        "each runs on the simulated chip for all 1024 readings. Of those within one standard\n"
        "error of the smallest leave-one-out error, the one with the fewest cycles is chosen.\n\n"
        "Example: fixbench calibrate reference/published/table_d_1.csv",
    .prints = {"calibration_candidates.csv"},
    .add =
        [](CLI::App& command) {
            const auto options = std::make_shared<Options>();
            command.add_option("readings", options->readings, "the readings")
                ->required()
                ->check(CLI::ExistingFile);
            command.add_option("--header", options->header,
                               "the header to write, e.g. "
                               "firmware/src/firmware/calibration_table.hpp");
            return [options](const fixbench::Call& call) {
                fixbench::build({"calibration_curves"});
                options->output = call.output;
                calibrate(*options);
                return fixbench::held;
            };
        },
    .steps = {{.name = "calibrate",
               .arguments = [](const fixbench::Mode& mode) -> std::vector<std::string> {
                   return {"calibrate", "reference/published/table_d_1.csv",
                           "--output",  mode.data,
                           "--header",  mode.header};
               },
               .writes = {"calibration.csv", "calibration_candidates.csv",
                          "calibration_verdicts.csv"},
               .targets = {"calibration_curves"},
               .reads = {DeviceProgram().elf},
               .full_seconds = 1,
               .quick_seconds = 5,
               .writes_header = true}},
});

}  // namespace
}  // namespace calibration
