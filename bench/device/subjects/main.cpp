// SPDX-License-Identifier: GPL-3.0-or-later
// The device program contains subjects for the bench to call; by itself it does nothing.
int main() {
    for (;;) {
    }
}
