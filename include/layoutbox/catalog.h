// What furniture is: the built-in catalogue, one's own articles from CSV or JSON, and how a scene gets what it leaves open.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/catalog/user_catalog.h"
