// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: CSV tables, readings of a sensor, and the published figures.
#include "bench/experiments/calibration/readings.hpp"
#include "bench/experiments/stability/fuzz/refusal.hpp"
#include "bench/lab/records/csv.hpp"
#include "reference/published.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 3) {
        case 0: {
            const auto path = fuzz::file("table.csv", text);
            fuzz::takes([&] {
                const std::string csv = records::Table::load(path).to_csv();
                const auto saved = fuzz::file("saved.csv", csv);
                fuzz::check(records::Table::load(saved).to_csv() == csv,
                            "a table saved is another one");
            });
            break;
        }
        case 1: {
            const auto path = fuzz::file("readings.csv", text);
            fuzz::takes([&] {
                int before = -1;
                for (const calibration::Reading& reading : calibration::load_readings(path)) {
                    fuzz::check(reading.adc > before && reading.adc <= 1023 && reading.grams >= 0,
                                "readings that do not rise within their range");
                    before = reading.adc;
                }
            });
            break;
        }
        case 2:
            for (const char* name : {"table_3_2.csv", "functions.csv", "workload.csv",
                                     "table_d_1.csv", "table_d_2.csv"})
                fuzz::file(name, text);
            fuzz::takes([] { reference::load_table_3_2(fuzz::folder()); });
            fuzz::takes([] { reference::load_functions(fuzz::folder()); });
            fuzz::takes([] { reference::load_workload(fuzz::folder()); });
            fuzz::takes([] { reference::load_table_d_1(fuzz::folder()); });
            fuzz::takes([] { reference::load_table_d_2(fuzz::folder()); });
            break;
    }
    return 0;
}
