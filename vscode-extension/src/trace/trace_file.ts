import { existsSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import * as vscode from 'vscode';
import { open } from '../../../panel/src/model/parse';
import { currentText } from '../writing/current_text';
import type { Client } from '../client';
import * as protocol from '../protocol';
import type { panel } from '../protocol';

interface Read {
  trace: panel.Trace;
  /** a text of its program */
  program: vscode.Uri;
}

/**
 * A trace saved by the trace view or by `proskill verify --save-traces`, or one of a report: that with the `name`, else one that the user chooses;
 * undefined: none. `from`: the time of the part of a recording.
 */
export async function readTrace(client: Client, file: vscode.Uri, name?: string, from?: number): Promise<Read | undefined> {
  if (isRecording(file)) return readPart(client, file, from);
  const traces = tracesIn(file, Buffer.from(await vscode.workspace.fs.readFile(file)).toString('utf8'));
  const trace = traces.length === 1 ? traces[0] : (traces.find((it) => it.name === name) ?? (await choose(traces)));
  return trace && placed(client, trace, file);
}

/** A recording in MCAP, which the server reads: it may have any size. */
export function isRecording(file: vscode.Uri): boolean {
  return file.path.endsWith('.mcap');
}

/** Of a long recording a part, from a time in seconds on; by default the last one. */
export async function readPart(client: Client, file: vscode.Uri, from?: number): Promise<Read> {
  const { trace } = await client.ask(protocol.recording, { uri: file.toString(), ...(from !== undefined && { from }) });
  return placed(client, tracesIn(file, trace)[0]!, file);
}

/** At least one. */
function tracesIn(file: vscode.Uri, text: string): panel.Trace[] {
  const name = vscode.workspace.asRelativePath(file);
  let traces: panel.Trace[];
  try {
    ({ traces } = open(text));
  } catch (error) {
    throw new Error(`${name} contains no trace: ${error instanceof Error ? error.message : String(error)}.`);
  }
  if (!traces.length) throw new Error(`${name} is a report without a trace.`);
  return traces;
}

/** With the places of its steps as URIs. If one of its texts has been edited since, it is outdated. */
async function placed(client: Client, trace: panel.Trace, file: vscode.Uri): Promise<Read> {
  for (const step of trace.steps) if (step.location) step.location.uri = uriOf(step.location.uri, file).toString();
  const sources = Object.entries(trace.sources ?? {}).map(([path, digest]) => [uriOf(path, file).toString(), digest]);
  if (sources.length) trace.stale = (await client.ask(protocol.edited, { sources: Object.fromEntries(sources) })).edited.length > 0;
  const first = trace.steps.find(({ location }) => location)?.location;
  return { trace, program: first ? vscode.Uri.parse(first.uri) : currentText().uri };
}

async function choose(traces: panel.Trace[]): Promise<panel.Trace | undefined> {
  const entries = traces.map((trace) => ({ label: trace.name, description: `${trace.verdict}, ${trace.steps.length} steps`, detail: trace.description, trace }));
  return (await vscode.window.showQuickPick(entries, { placeHolder: 'The trace of which property?', matchOnDetail: true }))?.trace;
}

/** Paths are relative to the directory of the verification: probably the workspace folder of the file, else another one, or the directory of the file. */
function uriOf(place: string, file: vscode.Uri): vscode.Uri {
  if (/^[a-z][a-z0-9+.-]+:/i.test(place)) return vscode.Uri.parse(place);
  const own = vscode.workspace.getWorkspaceFolder(file);
  const folders = [...(own ? [own] : []), ...(vscode.workspace.workspaceFolders ?? [])].map(({ uri }) => uri.fsPath).concat(dirname(file.fsPath));
  const found = folders.map((folder) => resolve(folder, place)).find(existsSync);
  return vscode.Uri.file(found ?? resolve(folders[0]!, place));
}
