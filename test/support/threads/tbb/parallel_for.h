// SPDX-License-Identifier: LGPL-3.0-or-later
#include "../tbb_on_threads.h"
