import type * as vscode from 'vscode';
import type { panel } from '../protocol';
import type { TextVersion } from '../protocol';

interface Replacement {
  range: panel.Range;
  /** end of the inserted text */
  end: panel.Position;
}

interface Edit extends Replacement {
  version: number;
}

const isBefore = (a: panel.Position, b: panel.Position): boolean => a.line < b.line || (a.line === b.line && a.character < b.character);

const endOf = ({ line, character }: panel.Position, text: string): panel.Position => {
  const lines = text.split(/\r\n|\r|\n/);
  const last = lines.at(-1)!.length;
  return lines.length === 1 ? { line, character: character + last } : { line: line + lines.length - 1, character: last };
};

/** A position before an edit; inserted text maps to its beginning. */
function before(place: panel.Position, { range: { start, end }, end: now }: Replacement): panel.Position {
  if (isBefore(place, start)) return place;
  if (isBefore(place, now)) return start;
  return { line: place.line - now.line + end.line, character: place.line === now.line ? place.character - now.character + end.character : place.character };
}

/** A position after an edit; replaced text maps to the end of what replaces it. */
function after(place: panel.Position, { range: { start, end }, end: now }: Replacement): panel.Position {
  if (isBefore(place, start)) return place;
  if (isBefore(place, end)) return now;
  return { line: place.line - end.line + now.line, character: place.line === end.line ? place.character - end.character + now.character : place.character };
}

/** Changes of one event all refer to the text before it; applied from the end backwards, they do not move each other. */
export const backwards = (changes: readonly vscode.TextDocumentContentChangeEvent[]): vscode.TextDocumentContentChangeEvent[] =>
  [...changes].sort((a, b) => b.rangeOffset - a.rangeOffset);

/** Where a position is after a change; nothing if its surroundings were replaced. What is inserted at the position comes after it. */
export function moved(place: panel.Position, { range, text }: vscode.TextDocumentContentChangeEvent): panel.Position | undefined {
  if (!isBefore(range.start, place)) return place;
  return isBefore(place, range.end) ? undefined : after(place, { range, end: endOf(range.start, text) });
}

/** Edits since something was computed, such as a picture: maps positions in the current text to those in its text, and back. */
export class Edits {
  private readonly known = new Map<string, Edit[]>();

  note({ document, contentChanges }: vscode.TextDocumentChangeEvent): void {
    const uri = document.uri.toString();
    const list = this.known.get(uri) ?? [];
    for (const { range, text } of backwards(contentChanges)) list.push({ version: document.version, range, end: endOf(range.start, text) });
    this.known.set(uri, list);
  }

  /** A picture of these texts is shown now. */
  forget(texts: TextVersion[]): void {
    for (const [uri, list] of this.known) {
      const version = texts.find((text) => text.uri === uri)?.version;
      this.known.set(uri, list.filter((edit) => version === undefined || version === null || edit.version > version));
    }
  }

  /** What was computed is up to date with this text. */
  forgetAll(uri: string): void {
    this.known.delete(uri);
  }

  /** All texts are as they were for what is shown now. */
  clear(): void {
    this.known.clear();
  }

  /** Where a position of the older text is now. */
  now(uri: string, place: panel.Position): panel.Position {
    return (this.known.get(uri) ?? []).reduce(after, place);
  }

  /** Where a part of the older text is now; empty if it was removed. */
  rangeNow(uri: string, { start, end }: panel.Range): panel.Range {
    return { start: this.now(uri, start), end: this.now(uri, end) };
  }

  former(location: panel.Location): panel.Location {
    const list = this.known.get(location.uri) ?? [];
    const place = list.reduceRight(before, location.range.start);
    return { uri: location.uri, range: { start: place, end: place } };
  }
}
