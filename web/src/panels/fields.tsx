// A field whose value is taken with Enter or when it is left.
import {useLayoutEffect, useRef, useState} from "preact/hooks";

interface FieldProps<T> {
  label: string;
  value: string;
  id: string;
  off?: boolean;
  /** What the value is of: another one's value begins anew. */
  of: string;
  read: (text: string) => T | null;
  /** False: it could not be; the field shows the old value again. */
  take: (value: T) => Promise<boolean>;
}

export function Field<T>({label, value, id, off = false, of, read, take}: FieldProps<T>) {
  const [text, put] = useState(value);
  const [wrong, mark] = useState(false);
  const typed = useRef<string | null>(null);  // of `of`, and not taken yet: an answer that comes meanwhile leaves it alone
  const shown_of = useRef(of);
  useLayoutEffect(() => {
    if (shown_of.current === of && typed.current !== null) return;
    shown_of.current = of;
    typed.current = null;
    put(value);
    mark(false);
  }, [value, of]);
  const type = (words: string) => {
    typed.current = words;
    put(words);
  };
  const done = async () => {
    const words = typed.current;
    typed.current = null;
    if (words === null || words === value) return;
    const found = read(words);
    mark(found === null);
    if (found !== null && !(await take(found))) put(value);
  };
  return (
    <label class="field">
      <span>{label}</span>
      <input
        value={text} disabled={off} aria-invalid={wrong} data-testid={id} inputMode="text" onInput={(event) => type(event.currentTarget.value)}
        onBlur={() => void done()} onKeyDown={(event) => event.key === "Enter" && void done()}
      />
    </label>
  );
}
