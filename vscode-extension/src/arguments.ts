import * as vscode from 'vscode';
import type { panel } from './protocol';

/** The subject of a command, from any source: a lens, a link, the Testing view, or a user. */
export interface Subject {
  uri?: vscode.Uri;
  name?: string;
  names?: string[];
  picture?: { kind: panel.PictureKind; name: string };
}

const kKinds = new Set(['sv', 'event', 'skill', 'body', 'calls']);

/** A lens passes an object with `program` or `uri`, and `name` or `names`; a menu passes a URI or a test. */
export function subjectOf(first?: unknown, second?: unknown): Subject {
  if (typeof first === 'string') return { uri: vscode.Uri.parse(first), ...namesOf(second) };
  if (first instanceof vscode.Uri) return { uri: first, ...namesOf(second) };
  if (!first || typeof first !== 'object') return {};
  const given = first as Record<string, unknown>;
  if (given['test'] && typeof given['test'] === 'object') return ofTest(given['test'] as vscode.TestItem);
  if ('children' in given && 'canResolveChildren' in given) return ofTest(first as vscode.TestItem);
  const uri = uriOf(given);
  const kind = given['kind'];
  const picture = typeof kind === 'string' && kKinds.has(kind)
    ? { picture: { kind: kind as panel.PictureKind, name: String(given['name'] ?? '') } } : {};
  return { ...(uri && { uri }), ...namesOf(given['names'] ?? given['name']), ...picture };
}

function uriOf(given: Record<string, unknown>): vscode.Uri | undefined {
  const document = given['textDocument'] as { uri?: unknown } | undefined;
  const text = given['program'] ?? given['uri'] ?? document?.uri;
  return typeof text === 'string' ? vscode.Uri.parse(text) : undefined;
}

function namesOf(value: unknown): { name?: string; names?: string[] } {
  if (typeof value === 'string') return { name: value, names: [value] };
  if (!Array.isArray(value)) return {};
  const names = value.filter((it): it is string => typeof it === 'string');
  return { names, ...(names[0] !== undefined && { name: names[0] }) };
}

/** The ids are those of `Testing`: `program#skill`, `program##property`. */
function ofTest(item: vscode.TestItem): Subject {
  const [program, , property] = item.id.split('#');
  const uri = program ? { uri: vscode.Uri.parse(program) } : {};
  return { ...uri, ...namesOf(property) };
}
