// Lengths as people write and read them. Inside, everything is metres.
export type Units = "m" | "ft";

const kInch = 0.0254;

/** 1.2 → "1.20 m"; in feet 3' 11". */
export function length_text(metres: number, units: Units): string {
  if (units === "m") return `${metres.toFixed(2)} m`;
  const inches = Math.round(metres / kInch);
  const feet = Math.trunc(inches / 12);
  const rest = Math.abs(inches % 12);
  return feet === 0 ? `${inches}"` : `${feet}' ${rest}"`;
}

/** Without the unit, for fields and lists of sizes. */
export function length_value(metres: number, units: Units): string {
  return units === "m" ? String(Math.round(metres * 1000) / 1000) : length_text(metres, units);
}

export const size_text = (size: readonly number[], units: Units): string =>
  `${size.map((side) => (units === "m" ? side.toFixed(2) : length_text(side, units))).join(" × ")}${units === "m" ? " m" : ""}`;

export function area_text(square_metres: number, units: Units): string {
  return units === "m" ? `${square_metres.toFixed(1)} m²` : `${(square_metres / 0.09290304).toFixed(0)} sq ft`;
}

const kUnit: Record<string, number> = {
  m: 1, cm: 0.01, mm: 0.001, ft: 0.3048, "'": 0.3048, "′": 0.3048, in: kInch, '"': kInch, "″": kInch,
};

/** "1.2", "1,2 m", "120 cm", "4'", "4' 6\"", "4 ft 6 in" → metres; anything else: null. A bare number is in `units`. */
export function read_length(text: string, units: Units): number | null {
  const pattern = /(-?\d+(?:[.,]\d+)?)\s*(mm|cm|m|ft|in|'|"|′|″)?/gy;
  const rest = text.trim();
  let metres = 0;
  let at = 0;
  while (at < rest.length) {
    pattern.lastIndex = at;
    const found = pattern.exec(rest);
    if (!found) return null;
    const inches_follow = at > 0 && units === "ft" && !found[2];
    metres += Number((found[1] as string).replace(",", ".")) * (inches_follow ? kInch : kUnit[found[2] ?? units] as number);
    at = pattern.lastIndex;
    while (rest[at] === " ") at += 1;
  }
  return rest && Number.isFinite(metres) ? metres : null;
}
