import * as vscode from 'vscode';
import { chooseTrace } from './choose_trace';
import type { Client } from '../client';
import { currentText } from '../writing/current_text';
import type { Programs } from '../programs';

/** A configuration of `launch.json`; see docs/vscode.md. */
interface Launch extends vscode.DebugConfiguration {
  program?: string;
  property?: string;
  trace?: string;
}

/** Replays traces, and simulates: `proskill dap`. */
export class Debugging implements vscode.DebugConfigurationProvider, vscode.DebugAdapterDescriptorFactory, vscode.Disposable {
  private readonly subscriptions = [
    vscode.debug.registerDebugConfigurationProvider('proskill', this),
    vscode.debug.registerDebugAdapterDescriptorFactory('proskill', this),
  ];

  constructor(private readonly client: Client, private readonly programs: Programs) {}

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  /** Without `launch.json`: a simulation of the visible program. */
  resolveDebugConfiguration(_folder: vscode.WorkspaceFolder | undefined, configuration: Launch): Launch {
    if (!configuration.type)
      return { type: 'proskill', request: 'launch', name: 'Simulate', program: currentText().uri.fsPath, simulate: true };
    return { ...configuration, program: configuration.program ?? currentText().uri.fsPath };
  }

  createDebugAdapterDescriptor(): vscode.DebugAdapterDescriptor {
    const { server } = this.client;
    if (!server) throw new Error('The ProSkill server is not running. See the output "ProSkill".');
    return new vscode.DebugAdapterExecutable(server.command, ['dap'], { env: server.env as { [name: string]: string } });
  }

  /** Replays the trace of a property. */
  async replay(uri: vscode.Uri, name?: string): Promise<void> {
    const property = name ?? (await chooseTrace(this.programs, uri, 'Replay the trace of which property?'));
    if (!property) return;
    const program = this.programs.of(uri)[0]?.program;
    await vscode.debug.startDebugging(vscode.workspace.getWorkspaceFolder(uri), {
      type: 'proskill', request: 'launch', name: property,
      program: program ? vscode.Uri.parse(program).fsPath : uri.fsPath, property,
    });
  }
}
