// Files to take away, a file to open, the script to read, and the picture.
import {useEffect, useState} from "preact/hooks";
import {Icon} from "../icons";
import {api} from "../api";
import type {ExportRequest, Layout} from "../gen/types";
import {OpenFile} from "../prompt";
import {save} from "../save";
import {show_error} from "../state/actions";
import {use} from "../state/store";
import {texts} from "../texts";
import {Picture} from "./picture";

const kFormats = ["json", "glb", "svg", "pdf", "png", "blender.py"] as const;
type Format = ExportRequest["format"];

export function file_name(format: Format): string {
  if (format === "json") return "layout.json";
  if (format === "blender.py") return "blender.py";
  return format === "glb" ? "scene.glb" : `floorplan.${format}`;
}

async function download(layout: Layout, format: Format): Promise<void> {
  try {
    save(await api.export({layout, format}), file_name(format));
  } catch (error) {
    show_error(error);
  }
}

function Script({layout}: {layout: Layout}) {
  const [text, put] = useState<string | null>(null);
  const [open, show] = useState(false);
  useEffect(() => put(null), [layout]);
  useEffect(() => {
    if (open && text === null) void api.export({layout, format: "blender.py"}).then((blob) => blob.text()).then(put).catch(show_error);
  }, [open, text]);
  return (
    <>
      <button type="button" class="link" aria-expanded={open} data-testid="script-toggle" onClick={() => show(!open)}>{open ? texts.files.script_hide : texts.files.script}</button>
      {open && text !== null && <pre class="script" tabIndex={0} data-testid="script">{text}</pre>}
    </>
  );
}

export function Files() {
  const layout = use((state) => state.rooms.now?.layout);
  if (!layout) return null;
  return (
    <>
      <section>
        <h3>{texts.files.heading}</h3>
        <ul class="downloads">
          {kFormats.map((format) => (
            <li><button type="button" data-testid={`download-${format}`} onClick={() => void download(layout, format)}><Icon name="down" />{texts.files.kinds[format]}</button></li>
          ))}
        </ul>
        <Script layout={layout} />
      </section>
      <Picture layout={layout} />
      <section>
        <h3>{texts.files.import}</h3>
        <p class="quiet">{texts.files.import_hint}</p>
        <OpenFile class="button" />
      </section>
    </>
  );
}
