// A small room to test with: 4 × 3 m, a bed at the back wall with a lamp on the nightstand beside it.
import type {Layout} from "../src/gen/types";

export const room = (): Layout => ({
  format: "layoutbox/layout@1",
  roomType: "bedroom",
  room: {
    polygon: [[0, 0], [4, 0], [4, 3], [0, 3]],
    height: 2.7,
    walls: [
      {id: "wall1", start: [0, 0], end: [4, 0]}, {id: "wall2", start: [4, 0], end: [4, 3]},
      {id: "wall3", start: [4, 3], end: [0, 3]}, {id: "wall4", start: [0, 3], end: [0, 0]},
    ],
    openings: [{id: "door1", type: "door", wall: "wall1", offset: 0.2, w: 0.9, h: 2, swing: "in-left"}],
  },
  objects: [
    {id: "bed_1", category: "bed", name: "bed", size: [1.6, 2, 0.5], pos: [2, 2, 0], rotation: 0, supportedBy: "floor"},
    {id: "stand_1", category: "nightstand", name: "nightstand", size: [0.4, 0.4, 0.5], pos: [1, 2.8, 0], rotation: 0, supportedBy: "floor"},
    {id: "stand_2", category: "nightstand", name: "nightstand", size: [0.4, 0.4, 0.5], pos: [3, 2.8, 0], rotation: 0, supportedBy: "floor"},
    {id: "lamp_1", category: "table_lamp", size: [0.2, 0.2, 0.4], pos: [1, 2.8, 0.5], rotation: 0, supportedBy: "stand_1"},
  ],
  relations: [
    {id: "c1", type: "againstWall", targets: ["bed_1"], relativeTo: "wall3", hard: true},
    {id: "c2", type: "nextTo", targets: ["stand_1", "stand_2"], relativeTo: "bed_1"},
    {id: "c3", type: "on", targets: ["lamp_1"], relativeTo: "stand_1"},
  ],
});
