import { existsSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import * as vscode from 'vscode';
import { open } from '../../../panel/src/model/parse';
import { currentText } from '../places';
import type { Client } from '../client';
import * as protocol from '../protocol';
import type { panel } from '../protocol';

interface Read {
  trace: panel.Trace;
  /** a text of its program */
  program: vscode.Uri;
}

/** A trace saved by the trace view or by `proskill verify --save-traces`, or one of a report; undefined: the user chose none. */
export async function readTrace(client: Client, file: vscode.Uri): Promise<Read | undefined> {
  const name = vscode.workspace.asRelativePath(file);
  const text = isRecording(file) ? await readRecording(client, file) : Buffer.from(await vscode.workspace.fs.readFile(file)).toString('utf8');
  if (text === undefined) return undefined;
  let traces: panel.Trace[];
  try {
    ({ traces } = open(text));
  } catch (error) {
    throw new Error(`${name} contains no trace: ${error instanceof Error ? error.message : String(error)}.`);
  }
  if (!traces.length) throw new Error(`${name} is a report without a trace.`);
  const trace = traces.length === 1 ? traces[0] : await choose(traces);
  if (!trace) return undefined;
  for (const step of trace.steps) if (step.location) step.location.uri = uriOf(step.location.uri, file).toString();
  const first = trace.steps.find(({ location }) => location)?.location;
  return { trace, program: first ? vscode.Uri.parse(first.uri) : currentText().uri };
}

/** A recording in MCAP, which the server reads: it may have any size. */
export function isRecording(file: vscode.Uri): boolean {
  return file.path.endsWith('.mcap');
}

/** The user chooses the part of a long recording; undefined: none. */
async function readRecording(client: Client, file: vscode.Uri): Promise<string | undefined> {
  const uri = file.toString();
  const last = await client.ask(protocol.recording, { uri });
  if (last.whole) return last.trace;
  const from = await vscode.window.showInputBox({
    title: `A run of ${Math.round(last.length)} s, of which a part is shown`,
    prompt: 'Seconds from the start of the run to the start of the part',
    value: String(Math.floor(last.begin)),
    validateInput: (text) => (/^\d+(\.\d+)?$/.test(text) ? undefined : 'A number of seconds'),
  });
  if (from === undefined) return undefined;
  return Number(from) === Math.floor(last.begin) ? last.trace : (await client.ask(protocol.recording, { uri, from: Number(from) })).trace;
}

async function choose(traces: panel.Trace[]): Promise<panel.Trace | undefined> {
  const entries = traces.map((trace) => ({ label: trace.name, description: `${trace.verdict}, ${trace.steps.length} steps`, detail: trace.description, trace }));
  return (await vscode.window.showQuickPick(entries, { placeHolder: 'The trace of which property?', matchOnDetail: true }))?.trace;
}

/** Paths are relative to the directory of the verification: probably the workspace, otherwise that of the file. */
function uriOf(place: string, file: vscode.Uri): vscode.Uri {
  if (/^[a-z][a-z0-9+.-]+:/i.test(place)) return vscode.Uri.parse(place);
  const folders = [...(vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.fsPath), dirname(file.fsPath)];
  const found = folders.map((folder) => resolve(folder, place)).find(existsSync);
  return vscode.Uri.file(found ?? resolve(folders[0]!, place));
}
