// SPDX-License-Identifier: GPL-3.0-or-later
// The program that does nothing: what every other one takes too.
int main() {
    for (;;) {
    }
}
