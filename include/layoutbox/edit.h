// A layout changed by words: edit_layout().
#pragma once

#include "layoutbox/edit/edit.h"
