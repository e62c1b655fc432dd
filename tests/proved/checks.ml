(* touchstone-check-proved again and again, for compare_checkers.py: to start it anew costs more than the checks. Forks
   of this process do the work, a hundred checks each, so that none of them can end it, or leave many files open. A line
   of the input holds the arguments, with tabs between them; a line of the output is the exit status, or a signal below
   zero. A line comes only after the answer to the one before it.
   SPDX-License-Identifier: MIT *)
let () =
  let answers = Unix.out_channel_of_descr (Unix.dup Unix.stdout) in
  let nowhere = Unix.openfile "/dev/null" [Unix.O_WRONLY] 0 in
  Unix.dup2 nowhere Unix.stdout;
  Unix.dup2 nowhere Unix.stderr;
  let serve () =
    for _ = 1 to 100 do
      let arguments = String.split_on_char '\t' (input_line stdin) in
      Printf.fprintf answers "%d\n%!" (try Reader.main arguments with _ -> 125)
    done in
  let rec go_on () =
    match Unix.fork () with
    | 0 -> Unix._exit (try serve (); 0 with End_of_file -> 1)
    | child ->
      match snd (Unix.waitpid [] child) with
      | Unix.WEXITED 0 -> go_on ()
      | Unix.WEXITED _ -> ()
      | Unix.WSIGNALED signal | Unix.WSTOPPED signal -> Printf.fprintf answers "%d\n%!" (- abs signal); go_on () in
  go_on ()
