// Layout to report: verify(), which shares no arithmetic with solve().
#pragma once

#include "layoutbox/verify/verify.h"
