(* touchstone-check-proved again and again, each time in a fork of this process, for compare_checkers.py: to start it
   anew costs more than the checks. A line of the input holds the arguments, with tabs between them; a line of the
   output is the exit status, or a signal below zero.
   SPDX-License-Identifier: MIT *)
let () =
  let answers = Unix.out_channel_of_descr (Unix.dup Unix.stdout) in
  let nowhere = Unix.openfile "/dev/null" [Unix.O_WRONLY] 0 in
  Unix.dup2 nowhere Unix.stdout;
  Unix.dup2 nowhere Unix.stderr;
  try
    while true do
      let arguments = String.split_on_char '\t' (input_line stdin) in
      match Unix.fork () with
      | 0 -> Unix._exit (try Reader.main arguments with _ -> 125)
      | child ->
        let status = match snd (Unix.waitpid [] child) with
          | Unix.WEXITED status -> status
          | Unix.WSIGNALED signal | Unix.WSTOPPED signal -> - abs signal in
        Printf.fprintf answers "%d\n%!" status
    done
  with End_of_file -> ()
