import * as vscode from 'vscode';
import type { Client } from './client';
import * as protocol from './protocol';

const kScheme = 'proskill-explain';

/** *Explain PS0301*: the manual's page on a code, as a preview beside the text. */
export class Explanations implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly registration = vscode.workspace.registerTextDocumentContentProvider(kScheme, this);

  constructor(private readonly client: Client) {}

  dispose(): void {
    this.registration.dispose();
  }

  async open(code: string): Promise<void> {
    await vscode.commands.executeCommand('markdown.showPreviewToSide', vscode.Uri.from({ scheme: kScheme, path: `${code}.md` }));
  }

  async provideTextDocumentContent(uri: vscode.Uri): Promise<string> {
    const { markdown } = await this.client.ask(protocol.explain, { code: uri.path.replace(/\.md$/, '') });
    return `# ${markdown}`; // it begins with the code and its title
  }
}
