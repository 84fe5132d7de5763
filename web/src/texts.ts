// Every text of the page. To translate the page, translate this file.
import type {Change, ExportRequest, SceneSwing, StartJobRequest} from "./gen/types";

/** A name for each word that the service has: where one is missing the types do not hold. */
type NameOfEach<Word extends string> = Readonly<Record<Word, string>>;

const plural = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;

export const texts = {
  /** Written in capitals wherever they are a word. */
  capitals: ["tv", "pc", "led", "diy"] as readonly string[],
  language: "en",
  title: "Layout-in-a-Box",
  skip: "Skip to the room",
  prompt: {
    label: "Describe a room",
    placeholder: "A bedroom with a double bed, two nightstands and a desk under the window",
    go: "Furnish",
    stop: "Stop",
    hero: "Describe a room.",
    under: "It is furnished to scale, checked, and yours to change.",
    examples_label: "Or try one of these",
    examples: [
      "A cosy bedroom with a double bed, two nightstands, a wardrobe and a desk under the window",
      "A living room with a sofa facing the TV, a coffee table on a rug and two armchairs",
      "A dining room with a table for six, a sideboard against the left wall and a plant in the corner",
      "A small office, 3 by 4 m, with two desks back to back, two chairs, a bookshelf and a printer on a cabinet",
      "A kids' room with a bunk bed, a toy chest at the foot of the bed and a desk by the window",
    ],
    form: "Fill in a form instead",
    open_file: "Open a layout or scene file",
    read_by: "Read by", readers: {offline: "the program", llm: "a language model"} as Record<string, string>,
  },
  stages: {plan: "Reading…", solve: "Placing the furniture…", verify: "Checking…"} as Record<string, string>,
  busy: {
    furnish: "Furnishing…", another: "Looking for another layout…", variants: "Looking for four layouts…", edit: "Reading the change…",
    add: "Finding a place…", move: "Rearranging…", keep: "Keeping the room…", open: "Opening…", file: "Making the file…",
  },
  said: {
    furnished: (count: number) => `Furnished with ${plural(count, "thing", "things")}.`,
    selected: (name: string) => `${name} selected.`,
  },
  errors: {
    unreachable: "The service does not answer. Is layoutbox serve still running?",
    status: (status: number) => `The service refused this (${status}).`,
    unexpected: "Something unexpected went wrong.",
    no_webgl: "This browser shows no 3D (WebGL is missing). The floor plan has everything.",
    not_a_file: "This is no layout and no scene file.",
    close: "Close",
  },
  bar: {
    undo: "Undo", redo: "Redo", another: "Another layout", variants: "Four variants", snap: "Snap to walls", walk: "Walk through", orbit: "Leave the walk",
    units: "Metres or feet", theme: {auto: "Theme: as the system", light: "Theme: light", dark: "Theme: dark"}, keep: "Keep", start: "New room",
    metres: "m", feet: "ft",
  },
  views: {
    three: "The room in 3D", plan: "Floor plan", tabs: {"3d": "3D", plan: "Plan", about: "Details"}, loading: "Building the 3D view…",
    three_hint: "Drag to turn, wheel to come closer, drag a thing to move it",
    walk_hint: "Drag to look, arrow keys or W A S D to walk",
    walk: {forward: "Forward", back: "Back", left: "Turn left", right: "Turn right"},
    thing: (name: string, size: string) => `${name}, ${size}`,
    thing_help: "Arrow keys move it by 1 cm, with Shift by 10 cm; R turns it; L locks it; Delete removes it.",
    turn: "Turn", resize: "Resize", other: "Beside it", other_close: "Close the comparison", locked: "locked",
    opening: (name: string) => `${name}: arrow keys move it along its wall, Delete removes it`,
    wall: (name: string) => `${name}: arrow keys move it`,
    room_size: (w: string, d: string, area: string) => `${w} × ${d} · ${area}`,
    reset: "Show all",
    outline: {
      begin: "Redraw the outline", end: "Outline is done", hint: "Drag corners and walls; + parts a wall, a double click removes a corner",
      corner: (number: number) => `Corner ${number}: arrow keys move it, Delete takes it away`, split: (wall: string) => `Part ${wall} in two`,
    },
  },
  tabs: {about: "Understood", things: "Things", files: "Files", rooms: "Rooms"},
  about: {
    as_asked: "All as asked", not_as_asked: "Not all as asked", changed: "Changed by hand",
    words: "Your words", not_understood: "Not understood", nothing_said: "This room was not described in words.",
    uses: {used: "used", ignored: "without effect", notUnderstood: "not understood"},
    asked: "Asked for", concluded: "Follows from it", added: "Comes with its use", assumed: "Assumed",
    held: "holds", not_held: "does not hold", unknown: "not checked",
    measured: (length: string) => `${length} apart`,
    conflicts: "These cannot all hold", do_without: (text: string) => `Do without “${text}”`,
    remedies: "What would do", looking_for_remedies: "Looking for what would do…",
    more_outs: (count: number) => `${count} more`, relaxed: "Given up", gave_way: "Gave way to what was asked", by: (amount: string) => `missed by ${amount}`,
    checks: "Checks", checks_passed: (count: number) => `All ${count} checks passed`, remarks: (count: number) => plural(count, "remark", "remarks"), checks_failed: "Failed checks", checking: "Checking…",
    notes: (count: number) => `${plural(count, "note", "notes")} on what was filled in`,
    no_relations: "Nothing was said about where things go.",
    variants: "Variants", variant: (index: number) => `Variant ${index + 1}`,
  },
  remedies: {
    leave_out: (name: string) => `Leave out ${name}`, resize: (name: string, size: string) => `Make ${name} ${size}`,
    drop: (relation: string) => `Do without “${relation}”`, instead: (relation: string) => `Rather “${relation}”`,
    wish: (relation: string) => `Only where it can be: “${relation}”`, room: (size: string) => `Make the room ${size}`,
  },
  edit: {
    label: "Change it in words", placeholder: "Move the desk under the window", go: "Try",
    proposal: "Proposed change", take: "Take it", drop: "Leave it", close: "Close", nothing: "Nothing would change.",
    moved: (length: string) => `moves ${length}`, turned: (degrees: string) => `turns ${degrees}`,
    what: {
      added: "is added", removed: "is removed", resized: "changes its size", moved: "moves", turned: "turns", reshaped: "changes its form",
      recolored: "changes its colour", renamed: "changes its name",
    } satisfies NameOfEach<Change["what"][number]>,
    gives_way: "gives way", dropped: "No longer asked for",
  },
  thing: {
    heading: "Selected", width: "Width", depth: "Depth", height: "Height", x: "From the left", y: "From the front", turn: "Turn",
    turn_left: "Turn left by 90°", turn_right: "Turn right by 90°", lock: "Lock in place", unlock: "Unlock", remove: "Remove",
    stands_on: (name: string) => `on the ${name}`, none: "Click a thing to change it.", name: "Name",
  },
  openings: {
    heading: "Doors and windows", sill: "Sill", swing: "Opens",
    swings: {"in-left": "inwards, left", "in-right": "inwards, right", "out-left": "outwards, left", "out-right": "outwards, right", sliding: "slides", none: "no leaf"} satisfies NameOfEach<SceneSwing>,
    add: {door: "Door", window: "Window", open: "Opening"}, adds: (name: string) => `Add: ${name}`,
  },
  hand: {refused: "It cannot stand there.", gives_way: (names: string) => `${names} ${names.includes(",") ? "give" : "gives"} way`},
  things: {
    add: "Add from the catalogue", add_placeholder: "sofa, lamp, plant…", nothing: "Nothing of that name; it can be added with a size of its own.",
    own: "A piece of your own", own_name: "Name", own_add: "Add", table: "All things",
    columns: {name: "Name", size: "W × D × H", place: "Place", turn: "Turn"},
    hint: "Choose a row to find the thing.",
  },
  files: {
    heading: "Downloads", import: "Open a file", import_hint: "A layout.json or scene.json of before",
    kinds: {
      json: "Layout (JSON)", glb: "3D model (GLB)", svg: "Floor plan (SVG)", pdf: "Floor plan (PDF)", png: "Floor plan (PNG)", "blender.py": "Blender script",
    } satisfies NameOfEach<ExportRequest["format"]>,
    script: "Read the Blender script", script_hide: "Hide the script",
    picture: "Picture", quality: "Quality", qualities: {draft: "Draft", preview: "Preview", final: "Final"} satisfies NameOfEach<NonNullable<StartJobRequest["quality"]>>,
    view: "View", views: {iso: "From a corner", top: "From above", front: "From the front", eye: "At eye level", door: "From the door"} satisfies NameOfEach<NonNullable<StartJobRequest["views"]>[number]>,
    draw: "Draw with Blender", cancel: "Cancel", waiting: "Waits", cancelled: "Cancelled.", failed: "It could not be drawn.",
    progress: (percent: number, stage: string) => `${percent} % ${stage}`, save_picture: "Save the picture", picture_alt: "The room, drawn by Blender",
    no_blender: "Blender is not installed where the service runs.",
  },
  rooms: {
    heading: "Kept rooms", keep: "Keep this room", name: "Name", none: "No room is kept yet.", open: "Open", beside: "Beside", forget: "Forget",
    link: "Link", copied: "Link copied", untitled: "A room",
  },
  rate: {
    open: "Rate pictures of rooms", heading: "Rate rooms", close: "Close", question: "Would you take this room?", scale: "1 useless · 4 something wrong or missing · 7 one small fault · 10 exactly as asked",
    explain: "Pictures are shown one after the other in an order that tells nothing; the files stay in this browser. Keys: 1–9 and 0 for ten, arrows for the next.",
    folder: "A folder of rooms (ID/scene.png, ID/layout.json)", pictures: "Pictures", none: "There is no picture among these files.", alt: (name: string) => `The room to be rated: ${name}`,
    kind: "Main kind of fault", reason: "Why", back: "Back", next: "Next", save: "Save the table",
    kinds: {"": "none", missing: "something is missing", wrong: "a wrong thing", place: "a wrong place", arrangement: "badly arranged", looks: "looks wrong"} as Record<string, string>,
    count: (at: number, all: number, done: number) => `${at} of ${all}, ${done} rated`,
  },
  form: {
    heading: "A room by form", close: "Close the form", kind: "Kind of room", width: "Width", depth: "Depth", height: "Height", room: "Room", openings: "Doors and windows",
    wall: "Wall", any_wall: "anywhere",
    walls: {wall1: "front", wall2: "right", wall3: "back", wall4: "left"} as Record<string, string>,
    offset: "From its left", furniture: "Furniture", count: "Number", search: "Find furniture", own: "Own piece", relations: "Relations",
    add_relation: "Add a relation", subject: "Thing", relation: "Relation", object: "To", remove: "Remove", go: "Furnish", usual: "usual size",
    kinds: ["bedroom", "living room", "dining room", "kitchen", "bathroom", "office", "kids room", "hallway", "classroom", "gym", "library", "shop"],
    shape: "Shape", shapes: {rectangle: "Rectangle", l: "L", t: "T", u: "U"} as const,
    outline: {
      label: "The room's outline", corner: (number: number) => `Corner ${number}: arrow keys move it, Delete removes it`, add: (number: number) => `A corner on side ${number}`,
      hint: "drag the corners; a click on a side's middle makes a new one, a double click removes one",
    },
    wrong_length: (name: string) => `${name}: this is no length.`, empty: "Add at least one piece of furniture.",
  },
  places: {
    room: "room", floor: "floor", ceiling: "ceiling", wall: (side: string) => `${side} wall`, wall_number: (number: number) => `wall ${number}`,
    sides: {front: "front", right: "right", back: "back", left: "left"},
    door: "door", window: "window", open: "opening", the: (name: string) => `the ${name}`,
    and: (first: string, last: string) => `${first} and ${last}`,
    verbs: [
      ["stands", "stand"], ["is", "are"], ["hangs", "hang"], ["keeps", "keep"], ["touches", "touch"], ["faces", "face"], ["looks", "look"], ["has", "have"],
    ] as readonly (readonly string[])[],
    at_least: (length: string) => `at least ${length}`, at_most: (length: string) => `at most ${length}`,
  },
} as const;
