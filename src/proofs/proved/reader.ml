(* touchstone-check-proved: reads queries and answers, and asks the checker that is proved in Coq. What is here, and in
   text.ml, has to be right: see docs/proved.md.
   SPDX-License-Identifier: MIT *)
open Proved
open Text

(* A query file, and its next row; it is empty at the end. *)
type file = { f : lines; is_curved : bool; mutable row : string list }
let advance q =
  q.row <- columns q.f;
  if q.is_curved && q.row <> [] && not q.f.has_end then bad q.f "the line's end is missing: the file may be cut off"
let opened_queries name =
  let f = opened name in
  match columns f with
  | ["touchstone-curved"; "1"] -> let q = { f; is_curved = true; row = [] } in advance q; q
  | "touchstone-curved" :: _ -> bad f "the version of a file of curved queries must be 1"
  | row -> { f; is_curved = false; row }

(* Straight motion: a row for each corner at the start, and then for each one at the end. *)
let straight q corners =
  let (_, truth) = split 6 q.row in
  if not (List.mem truth [[]; ["0"]; ["1"]]) then bad q.f "a row has 6 columns, or 7 of which the last one is 0 or 1";
  let fraction n d = match integer n, integer d with
    | Some qnum, Some qden when Z.sign qden > 0 -> { qnum; qden }
    | _ -> bad q.f "here must be integers of at most 4,096 digits, and the denominators positive" in
  let point _ = match q.row with
    | a :: b :: c :: d :: e :: g :: last when last = truth ->
      let x = { qx = fraction a b; qy = fraction c d; qz = fraction e g } in advance q; x
    | _ -> bad q.f "a query has two rows for each corner, of 6 or 7 columns, with the same last one of 7" in
  let (starts, ends) = split corners (List.init (2 * corners) point) in
  List.map2 (fun a b -> On_curve [a; b]) starts ends

(* Curved motion: a row for each corner, and for each body's motion before its corners. *)
let curved q corners =
  (match q.row with
   | ["query"; ("0" | "1")] -> advance q
   | _ -> bad q.f "a query starts with a row query,0 or query,1");
  let rec points = function
    | x :: y :: z :: rest -> let a = { qx = x; qy = y; qz = z } in a :: points rest
    | _ -> [] in
  let rec read motions known = match q.row with
    | "motion" :: ("0" | "1" | "2" | "3" as m) :: numbers
      when List.length numbers = 14 && not (List.mem_assoc m motions) ->
      (match List.map (double q.f) numbers with
       | s_0 :: a :: b :: c :: s_1 :: d :: e :: g :: rest ->
         let v_0 = { qx = a; qy = b; qz = c } and v_1 = { qx = d; qy = e; qz = g } in
         let (p_0, p_1) = match points rest with [p_0; p_1] -> (p_0, p_1) | _ -> assert false in
         let motion = { s_0; v_0; s_1; v_1; p_0; p_1 } in
         if not (turns (Hints.turn_unit_of Z.one motion) motion) then
           bad q.f "the quaternion must not be zero at a time in [0, 1]";
         advance q;
         read ((m, motion) :: motions) known
       | _ -> assert false)
    | "body" :: m :: ([_; _; _] as y) when List.mem_assoc m motions ->
      let y = List.hd (points (List.map (double q.f) y)) in
      advance q;
      read motions ((m, On_body (Z.succ (Z.of_string m), List.assoc m motions, y)) :: known)
    | "curve" :: numbers when List.mem (List.length numbers) [3; 6; 9; 12] ->
      let control = points (List.map (double q.f) numbers) in
      advance q;
      read motions (("", On_curve control) :: known)
    | [] | "query" :: _ ->
      if List.length known <> corners || not (List.for_all (fun (m, _) -> List.mem_assoc m known) motions) then
        bad q.f "the query before this line has too many or too few corners, or a motion without a corner";
      List.rev_map snd known
    | _ -> bad q.f "here must be a row: query, a motion of 14 numbers, body with 3, or curve with up to 12" in
  read [] []

(* How many corners the elements of a kind have; and the next query of a file, or None at its end. *)
let kinds = ["edge-edge", (2, 2); "vertex-face", (1, 3); "point-edge", (1, 2); "point-point", (1, 1)]
let next_query q (first, second) apart =
  if q.row = [] then None else
    let corners = (if q.is_curved then curved else straight) q (first + second) in
    let (first, second) = split first corners in
    Some { first; second; apart }

(* The answer of a line. *)
let read_answer f i line = match line with
  | [n; "none"] when n = string_of_int i -> No_contact
  | [n; "contact"; t; u] when n = string_of_int i ->
    let t = time f t and u = time f u in
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
    let shape = List.assoc kind kinds and q = opened_queries name in
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
    close_in q.f.channel;
    let text = (if q.is_curved then " with curved motion" else "") ^ text in
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
    nothing to check, or a motion of meshes, which is not covered." in
  let words = match List.tl (Array.to_list Sys.argv) with
    | "--allow-empty" :: rest -> rest  (* touchstone-check has it, for motions *)
    | words -> words in
  match words with
  | ("--help" | "-h") :: _ -> print_endline usage
  | proofs :: (_ :: _ as files) ->
    (try run proofs files with
     | Rejected reason -> finish 1 ("rejected: " ^ printable reason)
     | Bad reason -> finish 2 ("touchstone-check-proved: " ^ printable reason)
     | Sys_error reason ->
       close_out_noerr stdout;
       finish 2 ("touchstone-check-proved: standard output cannot be written: " ^ printable reason)
     | Out_of_memory | Stack_overflow -> finish 2 "touchstone-check-proved: the files are too large")
  | _ -> finish 2 usage
