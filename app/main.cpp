// SPDX-License-Identifier: AGPL-3.0-or-later
#include <iostream>

int main() {
    std::cout << "ameco " AMECO_VERSION "\n";
    return 0;
}
