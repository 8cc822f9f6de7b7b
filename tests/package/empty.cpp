// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/abi.h"

int main() {}
