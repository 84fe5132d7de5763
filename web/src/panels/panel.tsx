// The side: what was understood, the things, files and pictures, kept rooms.
import {set, use} from "../state/store";
import {texts} from "../texts";
import {About} from "./about";
import {Files} from "./files";
import {Rooms} from "./rooms";
import {Things} from "./things";

const kTabs = ["about", "things", "files", "rooms"] as const;

export function Panel() {
  const panel = use((state) => state.panel);
  const on_key = (event: KeyboardEvent) => {
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (!step) return;
    const next = kTabs[(kTabs.indexOf(panel as "about") + step + kTabs.length) % kTabs.length] as string;
    set({panel: next});
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <div class="panel">
      <div class="switch" role="tablist" onKeyDown={on_key}>
        {kTabs.map((name) => (
          <button
            type="button" role="tab" id={`tab-${name}`} aria-selected={panel === name} aria-controls="tab-panel" tabIndex={panel === name ? 0 : -1}
            data-testid={`tab-${name}`} onClick={() => set({panel: name})}
          >
            {texts.tabs[name]}
          </button>
        ))}
      </div>
      <div id="tab-panel" role="tabpanel" aria-labelledby={`tab-${panel}`} tabIndex={0} class="sheet">
        {panel === "about" && <About />}
        {panel === "things" && <Things />}
        {panel === "files" && <Files />}
        {panel === "rooms" && <Rooms />}
      </div>
    </div>
  );
}
