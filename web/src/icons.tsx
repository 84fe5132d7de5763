// Small pictures for buttons, drawn on a grid of 24; they take the colour of the text.
const paths = {
  undo: "M9 14 4 9l5-5M4 9h10a6 6 0 0 1 0 12h-3",
  redo: "m15 14 5-5-5-5M20 9H10a6 6 0 0 0 0 12h3",
  again: "M20 11a8 8 0 1 0-.6 4M20 5v6h-6",
  grid: "M4 4h7v7H4zM13 4h7v7h-7zM4 13h7v7H4zM13 13h7v7h-7z",
  magnet: "M5 4v8a7 7 0 0 0 14 0V4h-4v8a3 3 0 0 1-6 0V4zM5 8h4M15 8h4",
  walk: "M13 4.5a1.5 1.5 0 1 1-3 0 1.5 1.5 0 0 1 3 0M8 12l3-4 3 2 1 3h3M11 8l-1 7-3 5M10 15l4 2 1 4",
  orbit: "M12 3 4 7v10l8 4 8-4V7zM4 7l8 4 8-4M12 11v10",
  outline: "M6 6h7v6h5v6H6zM4 4h4v4H4zM16 16h4v4h-4z",
  theme: "M12 3a9 9 0 1 0 0 18zM12 3a9 9 0 0 1 0 18",
  keep: "M6 3h12v18l-6-4-6 4z",
  lock: "M6 11h12v9H6zM9 11V7a3 3 0 0 1 6 0v4",
  unlock: "M6 11h12v9H6zM9 11V7a3 3 0 0 1 5.8-1",
  remove: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13",
  left: "M7 8a7 7 0 1 1-1.6 6M7 3v5h5",
  right: "M17 8a7 7 0 1 0 1.6 6M17 3v5h-5",
  close: "m6 6 12 12M18 6 6 18",
  tick: "m5 12 5 5L19 7",
  cross: "m7 7 10 10M17 7 7 17",
  plus: "M12 5v14M5 12h14",
  down: "M12 4v11m-5-5 5 5 5-5M5 20h14",
  file: "M6 3h8l4 4v14H6zM14 3v4h4",
  link: "M10 14a4 4 0 0 0 6 0l3-3a4 4 0 0 0-6-6l-1 1M14 10a4 4 0 0 0-6 0l-3 3a4 4 0 0 0 6 6l1-1",
  warn: "M12 4 2.5 20h19zM12 10v5M12 17.5v.5",
} as const;

export type IconName = keyof typeof paths;

export const Icon = ({name}: {name: IconName}) => (
  <svg class="icon" viewBox="0 0 24 24" aria-hidden="true" fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" stroke-linejoin="round">
    <path d={paths[name]} />
  </svg>
);
