// The page: a prompt, the room in 3D beside its plan, and what there is to know of it.
import {useEffect, useState} from "preact/hooks";
import {Bar} from "./bar";
import {Form} from "./form/form";
import {Icon} from "./icons";
import {Compare} from "./panels/compare";
import {EditBox, Proposal} from "./panels/edit";
import {Panel} from "./panels/panel";
import {Rate} from "./panels/rate";
import {Selected} from "./panels/selected";
import {Variants} from "./panels/variants";
import {Plan} from "./plan/plan";
import {Prompt, Start} from "./prompt";
import {area, room_bounds} from "./pure/geometry";
import {area_text, length_text} from "./pure/units";
import {set, shown, use} from "./state/store";
import {texts} from "./texts";
import {View3D} from "./view3d/view3d";

function Messages() {
  const error = use((state) => state.error);
  if (!error) return null;
  return (
    <div class="message" role="alert" data-testid="error">
      <Icon name="warn" />
      <div>
        <p>{error.message}</p>
        {error.hint && <p class="quiet">{error.hint}</p>}
        {error.details && error.details.length > 0 && <ul>{error.details.slice(0, 8).map((detail) => <li>{detail}</li>)}</ul>}
      </div>
      <button type="button" class="tool" aria-label={texts.errors.close} onClick={() => set({error: null})}><Icon name="close" /></button>
    </div>
  );
}

const kLongEnough = 400;

/** What is being done, for the eyes, where it takes long enough to be read; who hears the page is told by `said`. */
function Working() {
  const busy = use((state) => state.busy);
  const share = use((state) => state.share);
  const [late, be_late] = useState(false);
  const works = busy !== null;
  useEffect(() => {
    be_late(false);
    const timer = works ? setTimeout(() => be_late(true), kLongEnough) : 0;
    return () => clearTimeout(timer);
  }, [works]);
  if (!works || !late) return null;
  return (
    <div class="working" aria-hidden="true" data-testid="working">
      {share === null ? <progress /> : <progress value={share} max={1} />}
      <span>{busy}{share !== null && ` ${Math.round(share * 100)} %`}</span>
    </div>
  );
}

function Tabs() {
  const pane = use((state) => state.pane);
  const names = texts.views.tabs;
  return (
    <div class="switch narrow-only" role="group" data-testid="panes">
      {(["3d", "plan", "about"] as const).map((name) => (
        <button type="button" aria-pressed={pane === name} data-testid={`pane-${name}`} onClick={() => set({pane: name})}>{names[name]}</button>
      ))}
    </div>
  );
}

function Studio() {
  const layout = use(shown);
  const pane = use((state) => state.pane);
  const other = use((state) => state.other);
  const walking = use((state) => state.walking);
  const outlining = use((state) => state.outlining);
  const {outline} = texts.views;
  const units = use((state) => state.units);
  if (!layout) return null;
  const box = room_bounds(layout.room);
  return (
    <main id="room" class={`studio pane-${pane}${other ? " two" : ""}`} tabIndex={-1}>
      <Tabs />
      <section class="views">
        <p id="thing-help" class="unseen">{texts.views.thing_help}</p>
        <div class="view view-3d">
          <View3D layout={layout} live={true} />
          <p class="hint wide-only">{walking ? texts.views.walk_hint : texts.views.three_hint}</p>
        </div>
        <div class="view view-plan">
          <Plan layout={layout} live={true} />
          <p class="hint" data-testid="room-size">
            {outlining ? outline.hint : texts.views.room_size(length_text(box.x1 - box.x0, units), length_text(box.y1 - box.y0, units), area_text(area(layout.room.polygon), units))}
          </p>
          <button
            type="button" class="tool corner" title={outlining ? outline.end : outline.begin} aria-label={outlining ? outline.end : outline.begin} aria-pressed={outlining}
            data-testid="outlining" onClick={() => set({outlining: !outlining, selected: null, relation: null})}
          >
            <Icon name="outline" />
          </button>
        </div>
        {other && <Compare />}
      </section>
      <div class="under">
        <Variants />
        <Proposal />
        <EditBox />
      </div>
      <aside class="side">
        <Selected />
        <Panel />
      </aside>
    </main>
  );
}

export function App() {
  const open = use((state) => state.rooms.now !== null);
  const form = use((state) => state.form);
  const rating = use((state) => state.rating);
  const said = use((state) => state.said);
  const busy = use((state) => state.busy);
  return (
    <>
      {open && <a class="skip" href="#room" onClick={(event) => { event.preventDefault(); document.getElementById("room")?.focus(); }}>{texts.skip}</a>}
      {open && !rating && <header class="top"><h1><Icon name="orbit" /><span class="wide-only">{texts.title}</span></h1><Prompt /><Bar /></header>}
      <Messages />
      <Working />
      {rating ? <Rate /> : open ? <Studio /> : <Start />}
      {form && <Form />}
      <p class="unseen" role="status" data-testid="said">{busy ?? said}</p>
    </>
  );
}
