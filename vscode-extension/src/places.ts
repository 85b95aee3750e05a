import * as vscode from 'vscode';
import type { panel } from './protocol';
import type { Edits } from './writing/edits';

export const rangeOf = ({ start, end }: panel.Range): vscode.Range =>
  new vscode.Range(start.line, start.character, end.line, end.character);

export const locationOf = (location: panel.Location): vscode.Location =>
  new vscode.Location(vscode.Uri.parse(location.uri), rangeOf(location.range));

export const sameUri = (left: string, right: vscode.Uri): boolean =>
  vscode.Uri.parse(left).toString() === right.toString();

/** Where a place of an older text is now. */
export const presentOf = (location: panel.Location, edits: Edits): panel.Location =>
  ({ ...location, range: edits.rangeNow(vscode.Uri.parse(location.uri).toString(), location.range) });

/** The editor that already shows a text, else the group with texts, beside the panel. */
function columnOf(uri: vscode.Uri): vscode.ViewColumn {
  const shown = vscode.window.visibleTextEditors.find((editor) => editor.document.uri.toString() === uri.toString());
  if (shown?.viewColumn) return shown.viewColumn;
  const text = vscode.window.visibleTextEditors.find((editor) => editor.document.languageId === 'proskill');
  return text?.viewColumn ?? vscode.ViewColumn.One;
}

/** Where a panel opens: beside what has the keyboard, or beside the text if that is something else. */
export function besideText(uri: vscode.Uri): vscode.ViewColumn {
  if (vscode.window.activeTextEditor?.viewColumn) return vscode.ViewColumn.Beside;
  const texts = vscode.window.visibleTextEditors.filter(({ viewColumn }) => viewColumn);
  const shown = texts.find(({ document }) => document.uri.toString() === uri.toString()) ?? texts.find(({ document }) => document.languageId === 'proskill');
  return shown?.viewColumn ? shown.viewColumn + 1 : vscode.ViewColumn.Beside;
}

const isOfTexts = ({ input }: vscode.Tab): boolean => input instanceof vscode.TabInputText || input instanceof vscode.TabInputNotebook;

/** Shows a text that is not visible, and does not cover what is not a text, such as a walkthrough or a panel. */
export async function showText(document: vscode.TextDocument): Promise<void> {
  const covered = vscode.window.tabGroups.activeTabGroup.activeTab;
  const viewColumn = !covered || isOfTexts(covered) ? vscode.ViewColumn.Active : vscode.ViewColumn.Beside;
  await vscode.window.showTextDocument(document, { viewColumn });
}

/**
 * Moves the caret to a place for the user, and with `focus` the keyboard focus. Scrolls only if it is not visible.
 * `asking`: the group of the panel in which the user chose the place; no text covers it
 */
export async function goTo(location: panel.Location, focus: boolean, asking?: vscode.ViewColumn): Promise<void> {
  const { uri, range } = locationOf(location);
  const column = columnOf(uri);
  const editor = await vscode.window.showTextDocument(uri, { viewColumn: column === asking ? vscode.ViewColumn.Beside : column, preserveFocus: !focus });
  editor.selection = new vscode.Selection(range.start, range.start);
  editor.revealRange(linesOf(range), vscode.TextEditorRevealType.InCenterIfOutsideViewport);
}

/** Scrolls to a place. Caret, selection and focus stay; nothing happens if the text would cover the panel whose steps it follows. */
export async function bringIntoView(location: panel.Location, followed?: vscode.ViewColumn): Promise<void> {
  const { uri, range } = locationOf(location);
  const shown = vscode.window.visibleTextEditors.find((it) => it.viewColumn && it.document.uri.toString() === uri.toString());
  const column = columnOf(uri);
  if (!shown && column === followed) return;
  const editor = shown ?? (await vscode.window.showTextDocument(uri, { viewColumn: column, preserveFocus: true, preview: true }));
  editor.revealRange(linesOf(range), vscode.TextEditorRevealType.InCenterIfOutsideViewport);
}

/** From the beginning of its first line, to avoid horizontal scrolling. */
const linesOf = ({ start, end }: vscode.Range): vscode.Range => new vscode.Range(start.line, 0, end.line, 0);

/** A program, or a Fiacre model written by hand; a generated model is neither. */
export const isVerified = (document: vscode.TextDocument): boolean =>
  document.languageId === 'proskill' || (document.languageId === 'fiacre' && document.uri.scheme === 'file');

/** The name of a file after some files or folders were renamed. */
export function renamed(uri: vscode.Uri, files: readonly { oldUri: vscode.Uri; newUri: vscode.Uri }[]): vscode.Uri {
  const name = uri.toString();
  const found = files.find(({ oldUri }) => name === oldUri.toString() || name.startsWith(`${oldUri.toString()}/`));
  return found ? vscode.Uri.parse(found.newUri.toString() + name.slice(found.oldUri.toString().length)) : uri;
}
