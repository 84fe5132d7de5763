#include "layoutbox/experiment/pictures.h"

#include <gtest/gtest.h>

namespace layoutbox::experiment {
namespace {

TEST(ExperimentPictures, AreTakenFromTheAzimuthOfThePaper) {
  for (const bool all_walls : {false, true}) {
    const RenderOptions options = picture_options(all_walls);
    EXPECT_DOUBLE_EQ(azimuth_from(Layout{}, Catalog::builtin(), options), 45);
    EXPECT_DOUBLE_EQ(options.elevation_deg, 65);
    EXPECT_EQ(options.all_walls, all_walls);
  }
}

}  // namespace
}  // namespace layoutbox::experiment
