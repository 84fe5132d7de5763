// The room without its furniture: walls, floor, doors with their swing, windows.
import type {Layout, LayoutOpening, LayoutWall} from "../gen/types";
import {on_wall} from "../pure/corners";
import {type Frame, leaves} from "./frame";

const kThickness = 0.1;

function Opening({frame, wall, opening}: {frame: Frame; wall: LayoutWall; opening: LayoutOpening}) {
  const thick = wall.thickness ?? kThickness;
  const point = (along: number, out: number) => on_wall(wall, along, out);
  const from = opening.offset;
  const to = opening.offset + opening.w;
  const hole = frame.path([point(from, -0.004), point(to, -0.004), point(to, thick + 0.004), point(from, thick + 0.004)]);
  const line = (along: number, out: number, end: number, end_out: number) =>
    `M${frame.at(point(along, out)).join(" ")}L${frame.at(point(end, end_out)).join(" ")}`;
  return (
    <g>
      <path class="hole" d={hole} />
      {opening.type === "window" && (
        <path class="pane" d={`${hole}${line(from, thick / 2, to, thick / 2)}`} />
      )}
      {leaves(wall, opening).map((leaf) => (
        <path
          class="swing"
          d={`M${frame.at(leaf.hinge).join(" ")}L${frame.at(leaf.open).join(" ")}A${leaf.width * 100} ${leaf.width * 100} 0 0 ${leaf.sweep} ${frame.at(leaf.shut).join(" ")}`}
        />
      ))}
      {opening.type === "door" && opening.swing === "sliding" && <path class="pane" d={line(from, thick / 2, to, thick / 2)} />}
    </g>
  );
}

export function Shell({layout, frame}: {layout: Layout; frame: Frame}) {
  const {room} = layout;
  const floor = frame.path(room.polygon);
  const thick = Math.max(...(room.walls ?? []).map((wall) => wall.thickness ?? kThickness), 0.02);
  return (
    <g>
      <path class="walls" d={floor} stroke-width={thick * 200} />
      <path class="floor" d={floor} />
      {(room.openings ?? []).map((opening) => {
        const wall = room.walls?.find((one) => one.id === opening.wall);
        return wall ? <Opening key={opening.id} frame={frame} wall={wall} opening={opening} /> : null;
      })}
    </g>
  );
}
