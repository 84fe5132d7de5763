# Sun and sky in Blender's units; glow and lamps scale what shines by itself. Exposure by view transform, in stops.
LIGHT = {"sun": 2.4, "sun_elevation": 52.0, "sun_azimuth": -38.0, "sun_angle": 12.0, "sun_color": (1.0, 0.97, 0.92),
         "sky": 0.92, "sky_color": (0.97, 0.98, 1.0), "background": (0.88, 0.90, 0.92), "glow": 1.0, "lamps": 0.35,
         "exposure": {"Khronos PBR Neutral": 0.0, "Standard": -0.55}}
