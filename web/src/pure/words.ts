// The prompt, cut into the words of the service's answer; neighbours of one meaning are one piece. Places are bytes of UTF-8.
import type {Word} from "../gen/types";

export interface Piece { text: string; word: Word | null }

export function pieces(prompt: string, words: readonly Word[]): Piece[] {
  const bytes = new TextEncoder().encode(prompt);
  const decoder = new TextDecoder();
  const cut = (from: number, to: number) => decoder.decode(bytes.subarray(from, to));
  const out: Piece[] = [];
  let at = 0;
  for (const word of [...words].sort((a, b) => a.begin - b.begin)) {
    if (word.begin < at || word.end > bytes.length) continue;
    const last = out.at(-1);
    const between = cut(at, word.begin);
    if (last?.word && last.word.role === word.role && last.word.use === word.use && between.trim() === "") {
      out[out.length - 1] = {text: last.text + between + cut(word.begin, word.end), word: last.word};
      at = word.end;
      continue;
    }
    if (word.begin > at) out.push({text: between, word: null});
    out.push({text: cut(word.begin, word.end), word});
    at = word.end;
  }
  if (at < bytes.length) out.push({text: cut(at, bytes.length), word: null});
  return out;
}

/** The thing or relation that a word stands for, if its role names one. */
export function named_in_role(role: string, ids: ReadonlySet<string>): string | null {
  return role.split(/[\s,;:()]+/).find((part) => ids.has(part)) ?? null;
}
