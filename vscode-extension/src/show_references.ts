import * as vscode from 'vscode';
import { locationOf, rangeOf } from './places';
import type { panel } from './protocol';

/** `proskill.showReferences` of the server's lenses: converts the protocol's values to VS Code's. */
export async function showReferences(uri: string, position: panel.Position, locations: panel.Location[]): Promise<void> {
  const { start } = rangeOf({ start: position, end: position });
  await vscode.commands.executeCommand(
    'editor.action.showReferences', vscode.Uri.parse(uri), start, locations.map(locationOf));
}
