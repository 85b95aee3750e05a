import * as vscode from 'vscode';
import { isVerified } from '../places';

/** URI of the program that had the keyboard last */
let last: string | undefined;

function note(editor: vscode.TextEditor | undefined): void {
  if (editor && isVerified(editor.document)) last = editor.document.uri.toString();
}

/** Notes which program the user turns to. */
export function followTexts(): vscode.Disposable {
  note(vscode.window.activeTextEditor);
  return vscode.window.onDidChangeActiveTextEditor(note);
}

/** Programs in tabs that others cover. */
function covered(): vscode.TextDocument[] {
  const tabs = vscode.window.tabGroups.all.flatMap((group) => group.tabs.map(({ input }) => (input instanceof vscode.TabInputText ? input.uri.toString() : '')));
  return vscode.workspace.textDocuments.filter(({ languageId, uri }) => languageId === 'proskill' && tabs.includes(uri.toString()));
}

/** The text that a command without arguments refers to: while a panel or a walkthrough has the keyboard, the last one. */
export function currentText(): vscode.TextDocument {
  const active = vscode.window.activeTextEditor?.document;
  if (active && isVerified(active)) return active;
  const isLast = ({ uri }: vscode.TextDocument): boolean => uri.toString() === last;
  const visible = vscode.window.visibleTextEditors.map(({ document }) => document).filter(({ languageId }) => languageId === 'proskill');
  const others = active ? [] : covered();
  const found = visible.find(isLast) ?? visible[0] ?? others.find(isLast) ?? others[0];
  if (!found) throw new Error('Open a ProSkill program first.');
  return found;
}
