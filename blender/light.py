# Sun, sky and the sun in the windows (`beams`, watts a square metre of window) in Blender's units; glow and lamps scale what shines by
# itself. Exposure by view transform, in stops.
LIGHT = {"sun": 2.8, "sun_elevation": 50.0, "sun_elevation_top": 80.0, "sun_azimuth": -38.0, "sun_angle": 5.0,
         "sun_color": (1.0, 0.97, 0.92), "sky": 0.82, "sky_color": (0.95, 0.97, 1.0), "background": (0.87, 0.89, 0.915),
         "glow": 1.0, "lamps": 0.35, "beams": 5.0, "beam_color": (1.0, 0.98, 0.94), "beam_down": 50.0, "beam_turn": 22.0,
         "pane": (0.70, 0.83, 0.93),
         "exposure": {"Khronos PBR Neutral": 0.0, "Standard": -0.55}}
