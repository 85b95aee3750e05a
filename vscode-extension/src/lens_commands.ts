import * as vscode from 'vscode';
import type { Middleware } from 'vscode-languageclient/node';

/** Commands beyond this number are forgotten, the least recently listed first. */
const kMost = 20_000;

/**
 * Commands of lenses, without arguments. VS Code keeps the arguments of a lens only until it has shown the next list of lenses, but a lens that scrolls
 * back into view shows its old commands for a quarter of a second. A click on it would fail with "Actual command not found". A command without
 * arguments is executed by its name, which stays the same for the same lens.
 */
export class LensCommands implements vscode.Disposable {
  private readonly known = new Map<string, { id: string; command: vscode.Command; registered: vscode.Disposable }>();
  private count = 0;

  readonly middleware: Middleware = {
    provideCodeLenses: async (document, token, next) => {
      const lenses = await this.request(document, token, next);
      for (const lens of lenses ?? []) this.replace(lens, lens.command?.arguments);
      this.forget();
      return lenses;
    },
    resolveCodeLens: async (lens, token, next) => {
      const { data } = lens as { data?: unknown }; // names the definition, whose references change
      const resolved = await next(lens, token);
      if (resolved) this.replace(resolved, data);
      return resolved;
    },
  };

  /** \param request passes requests on */
  constructor(private readonly request: NonNullable<Middleware['provideCodeLenses']>) {}

  dispose(): void {
    for (const { registered } of this.known.values()) registered.dispose();
    this.known.clear();
  }

  /** `identity`: what makes the command of this lens different from others; the last arguments are used. */
  private replace(lens: vscode.CodeLens, identity: unknown): void {
    const { command } = lens;
    if (!command?.command || !command.arguments?.length) return;
    const key = JSON.stringify([command.command, identity]);
    const entry = this.known.get(key) ?? this.register(key);
    entry.command = command;
    this.known.delete(key);
    this.known.set(key, entry); // the last one listed is the last in the order
    lens.command = { title: command.title, ...(command.tooltip && { tooltip: command.tooltip }), command: entry.id };
  }

  private register(key: string): { id: string; command: vscode.Command; registered: vscode.Disposable } {
    const id = `_proskill.lens.${++this.count}`; // the underscore hides it from lists of commands
    const registered = vscode.commands.registerCommand(id, () => {
      const { command, arguments: args } = this.known.get(key)!.command;
      return vscode.commands.executeCommand(command, ...(args ?? []));
    });
    return { id, command: { title: '', command: '' }, registered };
  }

  private forget(): void {
    for (const [key, { registered }] of this.known) {
      if (this.known.size <= kMost) return;
      registered.dispose();
      this.known.delete(key);
    }
  }
}
