// Result, Status and Error: what every fallible function returns. Nothing here throws, prints or ends the process.
#pragma once

#include "layoutbox/base/result.h"
