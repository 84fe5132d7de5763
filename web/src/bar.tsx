// The tools of the head.
import {Icon, type IconName} from "./icons";
import {another, redo, undo, variants} from "./state/actions";
import {get, set, use} from "./state/store";
import {texts} from "./texts";

interface ToolProps { name: IconName; label: string; id: string; on: () => void; off?: boolean; pressed?: boolean; text?: string }

export function Tool({name, label, id, on, off = false, pressed, text}: ToolProps) {
  return (
    <button
      type="button" class="tool" title={label} aria-label={label} data-testid={id} disabled={off}
      {...(pressed === undefined ? {} : {"aria-pressed": pressed})} onClick={on}
    >
      <Icon name={name} />{text && <span class="wide-only">{text}</span>}
    </button>
  );
}

const kNextTheme = {auto: "light", light: "dark", dark: "auto"} as const;

export function Bar() {
  const {rooms, snap, walking, units, theme, busy} = use((state) => state);
  const {bar} = texts;
  return (
    <div class="bar" role="toolbar" aria-label={texts.title}>
      <Tool name="undo" label={bar.undo} id="undo" on={undo} off={rooms.past.filter(Boolean).length === 0} />
      <Tool name="redo" label={bar.redo} id="redo" on={redo} off={rooms.future.length === 0} />
      <span class="gap" />
      <Tool name="again" label={bar.another} id="another" on={() => void another()} off={busy !== null} text={bar.another} />
      <Tool name="grid" label={bar.variants} id="variants" on={() => void variants()} off={busy !== null} />
      <span class="gap" />
      <Tool name="magnet" label={bar.snap} id="snap" pressed={snap} on={() => set({snap: !get().snap})} />
      <Tool name="walk" label={walking ? bar.orbit : bar.walk} id="walk" pressed={walking} on={() => set({walking: !get().walking, pane: "3d"})} />
      <button
        type="button" class="tool text" title={bar.units} aria-label={`${bar.units}: ${units === "m" ? bar.metres : bar.feet}`} data-testid="units"
        onClick={() => set({units: units === "m" ? "ft" : "m"})}
      >
        {units === "m" ? bar.metres : bar.feet}
      </button>
      <Tool name="theme" label={bar.theme[theme]} id="theme" on={() => set({theme: kNextTheme[theme]})} />
      <Tool name="plus" label={bar.start} id="form" on={() => set({form: true})} />
    </div>
  );
}
