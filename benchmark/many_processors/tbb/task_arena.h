// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../tbb_in_turn.h"
