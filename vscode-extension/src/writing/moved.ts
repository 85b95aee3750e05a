import type { panel } from '../protocol';

interface Change {
  range: panel.Range;
  text: string;
}

const isBefore = (a: panel.Position, b: panel.Position): boolean => a.line < b.line || (a.line === b.line && a.character < b.character);

/** Where a position is after a change; nothing if its surroundings were replaced. What is inserted at the position comes after it. */
export function moved(at: panel.Position, { range: { start, end }, text }: Change): panel.Position | undefined {
  if (!isBefore(start, at)) return at;
  if (isBefore(at, end)) return undefined;
  const lines = text.split(/\r\n|\r|\n/);
  const line = at.line - end.line + start.line + lines.length - 1;
  if (at.line > end.line) return { line, character: at.character };
  return { line, character: at.character - end.character + lines.at(-1)!.length + (lines.length === 1 ? start.character : 0) };
}
