// Rooms that were kept: to open, to put beside this one, to link to.
import {useEffect, useState} from "preact/hooks";
import {Tool} from "../bar";
import {api} from "../api";
import type {KeptRoom} from "../gen/types";
import {show_error} from "../state/actions";
import {keep_room, list_rooms, open_room, room_address} from "../state/session";
import {set, use} from "../state/store";
import {texts} from "../texts";

function Keep() {
  const prompt = use((state) => state.rooms.now?.prompt ?? "");
  const kind = use((state) => state.rooms.now?.layout.roomType ?? "");
  const [name, put] = useState("");
  const usual = (kind || prompt.slice(0, 60) || texts.rooms.untitled).replaceAll("_", " ");
  const go = async (event: Event) => {
    event.preventDefault();
    const room = await keep_room(name.trim() || usual);
    if (room) {
      put("");
      history.replaceState(null, "", `#room=${room.id}`);
    }
  };
  return (
    <form class="prompt edit" onSubmit={(event) => void go(event)}>
      <input value={name} placeholder={usual} aria-label={texts.rooms.name} maxLength={200} data-testid="keep-name" onInput={(event) => put(event.currentTarget.value)} />
      <button type="submit" class="small" data-testid="keep">{texts.rooms.keep}</button>
    </form>
  );
}

function Row({room}: {room: KeptRoom}) {
  const beside = async () => {
    try {
      const found = await api.room(room.id);
      if (found.layout) set({other: {name: room.name, layout: found.layout}});
    } catch (error) {
      show_error(error);
    }
  };
  const copy = () => {
    set({said: texts.rooms.copied});
    void navigator.clipboard?.writeText(room_address(room.id)).catch(() => undefined);
  };
  const forget = () => api.forget(room.id).then(list_rooms).catch(show_error);
  return (
    <li data-testid={`room-${room.id}`}>
      <a href={room_address(room.id)} onClick={(event) => { event.preventDefault(); history.replaceState(null, "", `#room=${room.id}`); void open_room(room.id); }}>
        <b>{room.name}</b>
        <small>{new Date(room.created).toLocaleString(texts.language)}</small>
      </a>
      <Tool name="grid" label={texts.rooms.beside} id={`beside-${room.id}`} on={() => void beside()} />
      <Tool name="link" label={texts.rooms.link} id={`link-${room.id}`} on={copy} />
      <Tool name="remove" label={texts.rooms.forget} id={`forget-${room.id}`} on={() => void forget()} />
    </li>
  );
}

export function Rooms() {
  const kept = use((state) => state.kept);
  useEffect(() => void list_rooms(), []);
  return (
    <section>
      <h3>{texts.rooms.heading}</h3>
      <Keep />
      {kept.length === 0 ? <p class="quiet">{texts.rooms.none}</p> : <ul class="kept">{kept.map((room) => <Row key={room.id} room={room} />)}</ul>}
      <p class="outs"><button type="button" class="link" data-testid="open-rate" onClick={() => set({rating: true})}>{texts.rate.open}</button></p>
    </section>
  );
}
