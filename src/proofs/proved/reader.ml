(* touchstone-check-proved: reads queries and answers, and asks the checker that is proved in Coq. What is here, and in
   text.ml, has to be right: see docs/proved.md.
   SPDX-License-Identifier: MIT *)
open Proved
open Text

(* How many corners the elements of a kind have; and a query of a file, or None at its end. *)
let kinds = ["edge-edge", (2, 2); "vertex-face", (1, 3); "point-edge", (1, 2); "point-point", (1, 1)]
let point f truth row =
  let q n d = match integer n, integer d with
    | Some qnum, Some qden when Z.sign qden > 0 -> { qnum; qden }
    | _ -> bad f "here must be integers of at most 4,096 digits, and the denominators positive" in
  match row with
  | a :: b :: c :: d :: e :: g :: last when last = truth -> { qx = q a b; qy = q c d; qz = q e g }
  | _ -> bad f "a query has rows of 6 columns, or of 7 of which the last one is 0 or 1, the same in all of its rows"
let next_query f (first, second) apart =
  match columns f with
  | [] -> None
  | "touchstone-curved" :: _ -> bad f "queries with curved motion are not covered: touchstone-check checks them"
  | row ->
    let (_, truth) = split 6 row in
    if not (List.mem truth [[]; ["0"]; ["1"]]) then bad f "a row has 6 columns, or 7 of which the last one is 0 or 1";
    let corners = first + second in
    let points = List.init (2 * corners) (fun i -> point f truth (if i = 0 then row else columns f)) in
    let (starts, ends) = split corners points in
    let (first, second) = split first (List.map2 (fun at_start at_end -> { at_start; at_end }) starts ends) in
    Some { first; second; apart }

(* The answer of a line. *)
let read_answer f i line = match line with
  | [n; "none"] when n = string_of_int i -> No_contact
  | [n; "contact"; t; u] when n = string_of_int i ->
    let t = rational (time f t) and u = rational (time f u) in
    if Z.equal t.qnum u.qnum && Z.equal t.qden u.qden then Contact_at t else Contact_between (t, u)
  | _ -> reject f (Printf.sprintf "here must be \"%d none\" or \"%d contact T U\"" i i)

let counted n one several = Printf.sprintf "%d %s" n (if n = 1 then one else several)
let is_digest d = d = "-" || String.length d = 64 && String.for_all (fun c -> is_digit c || (c >= 'a' && c <= 'f')) d

(* The proofs of one query file. @returns how many queries and contacts it has, and the next line *)
let check_file f line name =
  let (apart, text, line) = match line with
    | ["separation"; ("euclidean" | "max" as metric); word] ->
      let d = rational (number f word) in
      if Z.sign d.qnum <= 0 then reject f "the separation must be above zero";
      let apart = if metric = "max" then Max d else Euclidean d in
      (apart, Printf.sprintf " with separation %s %s" metric word, words f)
    | "separation" :: _ -> reject f "here must be \"separation euclidean D\" or \"separation max D\""
    | _ -> (Zero, "", line) in
  match line with
  | "file" :: "mesh" :: _ -> raise (Bad (name ^ ": proofs of motions are not covered: touchstone-check checks them"))
  | "file" :: kind :: digest :: _ :: _ when List.mem_assoc kind kinds && is_digest digest ->
    let shape = List.assoc kind kinds and q = opened name in
    let rec check_from i contacts line = match next_query q shape apart with
      | None -> (i, contacts, line)
      | Some query ->
        let answer = read_answer f i line in
        let (proof, line) = Hints.read_proof f shape query answer in
        if not (check query answer proof) then
          raise (Rejected (Printf.sprintf "%s: query %d: the proof before line %d does not hold" name i f.number));
        check_from (i + 1) (if answer = No_contact then contacts else contacts + 1) line in
    let (queries, contacts, line) = check_from 0 0 (words f) in
    if queries = 0 then raise (Bad (name ^ ": there is nothing to check: the file has no query"));
    close_in q.channel;
    Printf.printf "%s: %s%s\n" (printable name) (counted queries (kind ^ " query") (kind ^ " queries")) text;
    (queries, contacts, line)
  | _ -> reject f ("here must be \"file KIND DIGEST NAME\": the proofs for " ^ name)

let run proofs files =
  let f = opened proofs in
  if words f <> ["touchstone-proofs"; "1"] then bad f "the first line must be \"touchstone-proofs 1\"";
  let check (queries, contacts, line) name =
    let (q, c, line) = check_file f line name in (queries + q, contacts + c, line) in
  let (queries, contacts, line) = List.fold_left check (0, 0, words f) files in
  if line <> ["end"; string_of_int queries; string_of_int contacts] || words f <> [] then
    reject f (Printf.sprintf "here must be \"end %d %d\", and nothing after it" queries contacts);
  Printf.printf "%s checked: %s, %d without contact\n%!" (counted queries "query" "queries")
    (counted contacts "contact" "contacts") (queries - contacts)

let () =
  let finish status text = prerr_endline text; exit status in
  let usage = "usage: touchstone-check-proved PROOFS FILE...\n\
    Checks the proofs of `touchstone prove` against their query files, in their order. The checker is proved in Coq.\n\
    Exit status: 0 every proof holds, 1 some proof does not, 2 bad usage, a file that cannot be read, one with\n\
    nothing to check, or one that is not covered: queries with curved motion, and motions of meshes." in
  match List.tl (Array.to_list Sys.argv) with
  | ("--help" | "-h") :: _ -> print_endline usage
  | proofs :: (_ :: _ as files) ->
    (try run proofs files with
     | Rejected reason -> finish 1 ("rejected: " ^ printable reason)
     | Bad reason | Sys_error reason -> finish 2 ("touchstone-check-proved: " ^ printable reason)
     | Out_of_memory | Stack_overflow -> finish 2 "touchstone-check-proved: the files are too large")
  | _ -> finish 2 usage
