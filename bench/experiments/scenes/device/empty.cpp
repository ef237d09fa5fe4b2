// SPDX-License-Identifier: GPL-3.0-or-later
// A program that does nothing: what every program takes.
int main() {
    for (;;) {
    }
}
