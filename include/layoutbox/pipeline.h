// The whole way from text to a furnished, checked room in a folder: generate(), and many of them: run_batch().
#pragma once

#include "layoutbox/pipeline/batch.h"
#include "layoutbox/pipeline/generate.h"
