// A layout changed by words: edit_layout().
#pragma once

#include "layoutbox/pipeline/edit.h"
