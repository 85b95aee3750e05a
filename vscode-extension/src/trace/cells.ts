import * as vscode from 'vscode';
import type { panel } from '../protocol';

/** `cell 3` for a cell of an open notebook, as the status bar counts them. */
function cellLabel(uri: vscode.Uri): string | undefined {
  const text = uri.toString();
  for (const notebook of vscode.workspace.notebookDocuments) {
    const cell = notebook.getCells().find(({ document }) => document.uri.toString() === text);
    if (cell) return `cell ${cell.index + 1}`;
  }
  return undefined;
}

/** The trace with labels for its places in cells of a notebook, whose URIs are not readable. */
export function withCells(trace: panel.Trace): panel.Trace {
  const labels = new Map<string, string | undefined>();
  const labelOf = (uri: string): string | undefined => {
    if (!labels.has(uri)) labels.set(uri, uri.startsWith('vscode-notebook-cell:') ? cellLabel(vscode.Uri.parse(uri)) : undefined);
    return labels.get(uri);
  };
  const steps = trace.steps.map((step) => {
    const label = step.location && labelOf(step.location.uri);
    return step.location && label ? { ...step, location: { ...step.location, label } } : step;
  });
  return { ...trace, steps };
}
