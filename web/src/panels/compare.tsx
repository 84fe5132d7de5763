// A second room beside the first: to look at, not to change.
import {Icon} from "../icons";
import {Plan} from "../plan/plan";
import {set, use} from "../state/store";
import {texts} from "../texts";
import {View3D} from "../view3d/view3d";

export function Compare() {
  const other = use((state) => state.other);
  if (!other) return null;
  return (
    <section class="compare" aria-label={texts.views.other} data-testid="compare">
      <header>
        <h2>{other.name}</h2>
        <button type="button" class="tool" aria-label={texts.views.other_close} data-testid="compare-close" onClick={() => set({other: null})}><Icon name="close" /></button>
      </header>
      <div class="view view-3d"><View3D layout={other.layout} live={false} /></div>
      <div class="view view-plan"><Plan layout={other.layout} live={false} /></div>
    </section>
  );
}
