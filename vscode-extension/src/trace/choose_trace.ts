import * as vscode from 'vscode';
import type { Programs } from '../programs';
import type { panel } from '../protocol';

interface Entry extends vscode.QuickPickItem {
  name?: string;
}

/** Milliseconds; the shorter if the server has not reported whether it verifies. */
const kMost = 60_000;
const kMostUnknown = 3_000;

/** The known traces; if there are none, those that the current verification will find. */
async function tracesOf(programs: Programs, uri: vscode.Uri): Promise<panel.Verdict[]> {
  const known = (): panel.Verdict[] => programs.of(uri).flatMap(({ verdicts }) => verdicts).filter(({ steps }) => steps !== null);
  if (!known().length)
    await vscode.window.withProgress(
      { location: vscode.ProgressLocation.Notification, title: 'ProSkill: waiting for verdicts', cancellable: true },
      (_, token) => programs.settled(uri, token, programs.of(uri).length ? kMost : kMostUnknown));
  return known();
}

/** Asks the user for a property with a trace; bad ones come first. */
export async function chooseTrace(programs: Programs, uri: vscode.Uri, question: string): Promise<string | undefined> {
  const traces = await tracesOf(programs, uri);
  if (!traces.length) throw new Error('No trace: verify the program first. A property that holds has no trace.');
  const section = (label: string, icon: string, of: (verdict: panel.Verdict) => boolean): Entry[] => {
    const entries = traces.filter(of).map(({ name, description, verdict, steps }) => ({
      label: `$(${icon}) ${name}`, description: `${verdict}, ${steps} ${steps === 1 ? 'step' : 'steps'}`, detail: description.replaceAll('`', ''), name,
    }));
    return entries.length ? [{ label, kind: vscode.QuickPickItemKind.Separator }, ...entries] : [];
  };
  const entries = [
    ...section('bad', 'error', ({ good, severity }) => !good && severity === 'error'),
    ...section('warnings', 'warning', ({ good, severity }) => !good && severity !== 'error'),
    ...section('good, with a run that shows it', 'pass', ({ good }) => good),
  ];
  return (await vscode.window.showQuickPick(entries, { placeHolder: question, matchOnDetail: true }))?.name;
}
