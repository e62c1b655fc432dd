/**
 * Runs `touchstone ARGUMENTS` in a folder of its own, in memory.
 * @param args  the command and its arguments
 * @param files  the files that it finds there, by their paths
 * @param input  its standard input, the file `-`
 */
export function run(
  args: string[],
  files?: Record<string, string | Uint8Array>,
  input?: string | Uint8Array,
): Promise<{
  /** 0: done, and every claim holds. 1: some claim is refuted, or a contact was found. 2: bad usage or input. */
  status: number;
  out: Uint8Array;
  err: string;
  /** The files that it made or changed. */
  files: Record<string, Uint8Array>;
}>;
