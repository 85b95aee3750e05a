import * as vscode from 'vscode';
import { subjectOf } from './arguments';
import { AutomatonPreview } from './automaton';
import { Client } from './client';
import { currentText, followTexts } from './writing/current_text';
import { Debugging } from './trace/debug';
import { DiskChanges } from './disk_changes';
import { Explanations } from './explain';
import { Imports } from './bridge/import';
import { FiacreView } from './model';
import { isVerified, showText } from './places';
import { Programs } from './programs';
import { Missions } from './run/run_mission';
import * as protocol from './protocol';
import { toggleStatementMarks } from './settings';
import { showReferences } from './show_references';
import { Simulations } from './simulation';
import { Definitions } from './writing/snippets';
import { Status } from './status';
import { Testing } from './testing/testing';
import { TraceView } from './trace/trace';
import { isRecording } from './trace/trace_file';
import { Typing } from './writing/typing';
import { verify } from './verify_command';

let client: Client | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  client = new Client(context.extensionPath);
  const server = client;
  const programs = new Programs(server);
  const fiacre = new FiacreView(server);
  const typing = new Typing();
  const disk = new DiskChanges(server);
  const explanations = new Explanations(server);
  server.explaining = (code) => explanations.open(code);
  const automaton = new AutomatonPreview(server, programs, typing, context);
  const trace = new TraceView(server, programs, typing, context, fiacre);
  const simulations = new Simulations(server, programs, typing, context);
  const debugging = new Debugging(server, programs);
  const missions = new Missions(server, context);
  const imports = new Imports(server);
  context.subscriptions.push(
    server, programs, typing, disk, followTexts(), explanations, new Status(server, programs), new Testing(server, programs, typing, disk, context.workspaceState), fiacre, automaton, trace, simulations, debugging, missions, imports);

  /** An error of a command is shown as a message, never as a stack trace. */
  const command = (name: string, action: (...args: unknown[]) => unknown): void => {
    context.subscriptions.push(vscode.commands.registerCommand(name, async (...args: unknown[]) => {
      try {
        await action(...args);
      } catch (error) {
        void vscode.window.showErrorMessage(`ProSkill: ${error instanceof Error ? error.message : String(error)}`);
      }
    }));
  };
  command('proskill.restartServer', () => server.restart());
  command('proskill.showOutput', () => server.output.show());
  command('proskill.statementMarks', toggleStatementMarks);
  command('proskill.status', () => statusMenu(server));
  command('proskill.newProgram', newProgram);
  command('proskill.verify', (...args) => verify(server, subjectOf(...args)));
  command('proskill.showAutomaton', (...args) => {
    const { uri, picture } = subjectOf(...args);
    return automaton.open(uri, picture);
  });
  command('proskill.openTrace', (...args) => {
    const { uri, name } = subjectOf(...args);
    return trace.open(uri, name);
  });
  command('proskill.openTraceFile', (file) => openTraceFile(trace, simulations, file instanceof vscode.Uri ? file : undefined));
  command('proskill.simulate', (...args) => simulations.open(subjectOf(...args).uri));
  command('proskill.run', (...args) => missions.run(subjectOf(...args).uri));
  command('proskill.import', (...args) => imports.open(subjectOf(...args).uri));
  command('proskill.nextStep', () => trace.go(1));
  command('proskill.previousStep', () => trace.go(-1));
  command('proskill.showModel', (...args) => fiacre.open(subjectOf(...args).uri));
  command('proskill.debugTrace', (...args) => {
    const { uri, name } = subjectOf(...args);
    return debugging.replay(uri ?? currentText().uri, name);
  });
  command('proskill.showReferences', (uri, position, locations) =>
    showReferences(uri as string, position as protocol.panel.Position, locations as protocol.panel.Location[]));

  context.subscriptions.push(
    vscode.window.onDidChangeActiveTextEditor((editor) => tellInView(server, editor)),
    vscode.window.onDidChangeTextEditorVisibleRanges(({ textEditor }) => soonInView(server, textEditor)),
    server.onLife((life) => {
      if (life === 'running') tellInView(server, vscode.window.activeTextEditor);
    }),
    vscode.workspace.onDidGrantWorkspaceTrust(() => server.restart()),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration('proskill.server')) void server.restart();
    }));
  context.subscriptions.push(
    vscode.languages.registerCompletionItemProvider('proskill', new Definitions(context.extensionPath)),
    vscode.window.registerWebviewPanelSerializer('proskill.trace', trace),
    vscode.window.registerWebviewPanelSerializer('proskill.automaton', automaton),
    vscode.window.registerWebviewPanelSerializer('proskill.simulation', simulations));
  await server.start();
}

export async function deactivate(): Promise<void> {
  await client?.stop();
}

function tellInView(server: Client, editor: vscode.TextEditor | undefined): void {
  if (!editor || !isVerified(editor.document) || !server.ready) return;
  const [first, last] = [editor.visibleRanges[0], editor.visibleRanges.at(-1)];
  const range = first && last && { start: { line: first.start.line, character: 0 }, end: { line: last.end.line, character: 0 } };
  void server.running.sendNotification(protocol.inView, { textDocument: { uri: editor.document.uri.toString() }, ...(range && { range }) });
}

let scrolled: NodeJS.Timeout | undefined;

/** What is visible is verified first: the server is notified when scrolling stops. */
function soonInView(server: Client, editor: vscode.TextEditor): void {
  if (editor !== vscode.window.activeTextEditor) return;
  clearTimeout(scrolled);
  scrolled = setTimeout(() => tellInView(server, editor), 200);
}

/** A trace to show, or a run to replay. */
async function openTraceFile(trace: TraceView, simulations: Simulations, file?: vscode.Uri): Promise<void> {
  const chosen = file ?? (await vscode.window.showOpenDialog({ filters: { 'Trace or run': ['json', 'mcap'] }, openLabel: 'Open' }))?.[0];
  if (!chosen || (!isRecording(chosen) && (await simulations.openFile(chosen)))) return;
  await trace.openFile(chosen);
}

async function newProgram(): Promise<void> {
  const document = await vscode.workspace.openTextDocument({ language: 'proskill', content: '' });
  await showText(document);
}

async function statusMenu(server: Client): Promise<void> {
  const entries = [
    { label: '$(play) Verify the program', command: 'proskill.verify' },
    { label: '$(type-hierarchy) Show the automaton', command: 'proskill.showAutomaton' },
    { label: '$(list-ordered) Open a trace', command: 'proskill.openTrace' },
    { label: '$(run-all) Simulate: choose what happens next', command: 'proskill.simulate' },
    { label: '$(debug-start) Run the mission', command: 'proskill.run' },
    { label: '$(debug-alt) Replay a trace in the debugger', command: 'proskill.debugTrace' },
    { label: '$(beaker) Show the properties', command: 'workbench.view.testing.focus' },
    { label: '$(list-tree) Show or hide marks of statements', command: 'proskill.statementMarks' },
    { label: '$(code) Show the Fiacre model', command: 'proskill.showModel' },
    { label: '$(folder-opened) Open a trace from a file', command: 'proskill.openTraceFile' },
    { label: '$(arrow-down) Import a behavior tree, a component or a skillset', command: 'proskill.import' },
    { label: '$(new-file) Begin a new program', command: 'proskill.newProgram' },
    { label: '$(debug-restart) Restart the server', command: 'proskill.restartServer' },
    { label: '$(output) Show the output', command: 'proskill.showOutput' },
  ];
  const title = server.server ? `ProSkill: ${server.server.version}` : 'ProSkill: no server';
  const chosen = await vscode.window.showQuickPick(entries, { title });
  if (chosen) await vscode.commands.executeCommand(chosen.command);
}
