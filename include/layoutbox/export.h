// Layout to other tools' files: glTF, floor plans, and the table of formats.
#pragma once

#include "layoutbox/export/export.h"
#include "layoutbox/export/formats.h"
