// Ways out of a conflict that the solver has tried: each changes the scene a little and gives a room as asked.
import {useEffect, useState} from "preact/hooks";
import {api} from "../api";
import type {Layout, RemediesAnswer, Scene} from "../gen/types";
import {only_gives_up, remedy_text} from "../pure/remedies";
import {furnish_scene} from "../state/actions";
import {use} from "../state/store";
import {texts} from "../texts";

export function Remedies({layout}: {layout: Layout}) {
  const now = use((state) => state.rooms.now);
  const sentences = use((state) => state.sentences);
  const units = use((state) => state.units);
  const [ways, put] = useState<RemediesAnswer["ways"] | null>(null);
  const scene = now && !now.by_hand && now.layout === layout ? now.scene : null;
  const wanted = scene !== null && ((layout.conflicts?.length ?? 0) > 0 || (layout.relaxed?.length ?? 0) > 0);
  useEffect(() => {
    put(null);
    if (!wanted || !scene) return undefined;
    const gone = new AbortController();
    // To do without one of what is in conflict is offered there.
    const offered = (layout.conflicts ?? []).flatMap((conflict) => conflict.relations ?? []);
    const further = (found: RemediesAnswer["ways"]) => found.filter((way) => !only_gives_up(scene, way.scene, offered));
    api.remedies({scene, layout}, gone.signal).then((found) => put(further(found))).catch(() => !gone.signal.aborted && put([]));
    return () => gone.abort();
  }, [layout, wanted]);
  if (!wanted || ways?.length === 0) return null;
  return (
    <section class="help" data-testid="remedies">
      <h3>{texts.about.remedies}</h3>
      {ways === null ? <p class="quiet">{texts.about.looking_for_remedies}</p> : (
        <p class="outs">
          {ways.map((way, i) => (
            <button key={way.sentence} type="button" class="small" data-testid={`remedy-${i}`} onClick={() => void furnish_scene(way.scene, now?.prompt)}>
              {remedy_text(scene as Scene, way.scene, layout, sentences, units) || way.sentence}
            </button>
          ))}
        </p>
      )}
    </section>
  );
}
