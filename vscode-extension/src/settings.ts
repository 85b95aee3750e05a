import * as vscode from 'vscode';

export const kStatements = 'proskill.testing.statements';

/** Whether the gutter marks statements, and not only definitions. */
export const marksStatements = (): boolean => vscode.workspace.getConfiguration().get(kStatements, false);

/** In the settings of the workspace if they have it, else in those of the user. */
export async function toggleStatementMarks(): Promise<void> {
  const settings = vscode.workspace.getConfiguration();
  const isOfWorkspace = settings.inspect(kStatements)?.workspaceValue !== undefined;
  await settings.update(kStatements, !marksStatements(), isOfWorkspace ? vscode.ConfigurationTarget.Workspace : vscode.ConfigurationTarget.Global);
}

/** Options that the server receives at its start. */
export function initializationOptions(): object {
  const { live, durations, delay, seconds, megabytes, requestSeconds, requestMegabytes } =
    vscode.workspace.getConfiguration('proskill').get<Record<string, unknown>>('verify', {});
  return {
    trusted: vscode.workspace.isTrusted,
    verify: { live, durations, delay, seconds, megabytes, requestSeconds, requestMegabytes },
  };
}
