// SPDX-License-Identifier: MIT
// One sum and one product in every arithmetic: what happens if the result is out of range.
#include <fixedpoint.h>

#include <fixedpoint/arithmetic/checked.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>

using namespace fixedpoint;

static unsigned events = 0;
struct Counting {
    static void notify(Event, Operation) { ++events; }
};

// A class, since Arduino declares a sketch's functions at its top and does not know templates.
template <class Arithmetic>
struct Results {
    using Number = Fixed<16, 16, Arithmetic>;
    static void show(const char* name) {
        const Number large = Number::from_integer(30000), half = from_decimal<Number>(5, 1);
        Serial.print(name);
        Serial.print(": 30000 + 30000 = ");
        Serial.print(printable(large + large));
        Serial.print(", 0.5 * 0.5 = ");
        Serial.print(printable(half * half));
        Serial.print(", sqrt(30000) = ");
        Serial.println(printable(sqrt(large), 3));
    }
};

void setup() {
    Serial.begin(115200);
    Results<Nearest>::show("Nearest");            // the default: rounds, and sums wrap
    Results<Saturating>::show("Saturating");      // stays at the limit of the range
    Results<Checked<Counting>>::show("Checked");  // reports results out of range
    Results<Small>::show("Small");                // functions without tables
    Results<Published>::show("Published");        // the baseline for comparison
    Serial.print(events);
    Serial.println(" results have left the range");
}

void loop() {}
