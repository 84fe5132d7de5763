// Layouts of one answer, small, to pick from.
import {Plan} from "../plan/plan";
import {pick} from "../state/actions";
import {use} from "../state/store";
import {texts} from "../texts";

export function Variants() {
  const layouts = use((state) => state.rooms.now?.layouts);
  const chosen = use((state) => state.rooms.now?.pick);
  if (!layouts || layouts.length < 2) return null;
  return (
    <div class="variants" role="group" aria-label={texts.about.variants} data-testid="variant-list">
      {layouts.map((layout, i) => (
        <button type="button" aria-pressed={i === chosen} aria-label={texts.about.variant(i)} data-testid={`variant-${i}`} onClick={() => pick(i)}>
          <Plan layout={layout} live={false} />
        </button>
      ))}
    </div>
  );
}
