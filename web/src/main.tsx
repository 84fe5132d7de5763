// Where the page begins.
import {render} from "preact";
import {api, take_token} from "./api";
import {App} from "./app";
import {install_keys} from "./state/keys";
import {keep_session, restore_session} from "./state/session";
import {on_change, get, set} from "./state/store";
import {texts} from "./texts";
import "./app.css";

function show_theme(): void {
  const {theme} = get();
  if (theme === "auto") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = theme;
}

document.documentElement.lang = texts.language;
document.title = texts.title;
take_token();
if (location.hash === "#rate") set({rating: true});
show_theme();
on_change(show_theme);
install_keys();
render(<App />, document.body);
void restore_session().finally(keep_session);
void api.health().then(({planners}) => set({planners})).catch(() => undefined);
void api.relations()
  .then((rows) => set({sentences: new Map(rows.map((row) => [row.name, row]))}))
  .catch(() => undefined);
