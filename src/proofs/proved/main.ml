(* SPDX-License-Identifier: MIT *)
let () = exit (Reader.main (List.tl (Array.to_list Sys.argv)))
