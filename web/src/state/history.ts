// A value with its past and its future: undo and redo without end.
export interface History<T> { past: readonly T[]; now: T; future: readonly T[] }

export const begin = <T>(now: T): History<T> => ({past: [], now, future: []});

/** A new present; the old one can be come back to, what was undone cannot. */
export const pushed = <T>(history: History<T>, now: T): History<T> =>
  ({past: [...history.past, history.now], now, future: []});

/** The present is put right without a step of its own (a report that came later). */
export const amended = <T>(history: History<T>, now: T): History<T> => ({...history, now});

export function undone<T>(history: History<T>): History<T> {
  const last = history.past.at(-1);
  if (last === undefined) return history;
  return {past: history.past.slice(0, -1), now: last, future: [history.now, ...history.future]};
}

export function redone<T>(history: History<T>): History<T> {
  const next = history.future[0];
  if (next === undefined) return history;
  return {past: [...history.past, history.now], now: next, future: history.future.slice(1)};
}
