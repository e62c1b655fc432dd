(* touchstone-check-proved: reads queries and answers, and asks the checker that is proved in Coq. What is here, and in
   text.ml, has to be right: see docs/proved.md.
   SPDX-License-Identifier: MIT *)
open Proved
open Text
open Meshes

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

let real f word = rational (double f word)
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
      (match List.map (real q.f) numbers with
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
      let y = List.hd (points (List.map (real q.f) y)) in
      advance q;
      read motions ((m, On_body (Z.succ (Z.of_string m), List.assoc m motions, y)) :: known)
    | "curve" :: numbers when List.mem (List.length numbers) [3; 6; 9; 12] ->
      let control = points (List.map (real q.f) numbers) in
      advance q;
      read motions (("", On_curve control) :: known)
    | [] | "query" :: _ ->
      if List.length known <> corners || not (List.for_all (fun (m, _) -> List.mem_assoc m known) motions) then
        bad q.f "the query before this line has too many or too few corners, or a motion without a corner";
      List.rev_map snd known
    | _ -> bad q.f "here must be a row: query, a motion of 14 numbers, body with 3, or curve with up to 12" in
  read [] []

(* The next query of a file, or None at its end. *)
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

let is_digest d = d = "-" || String.length d = 64 && String.for_all (fun c -> is_digit c || (c >= 'a' && c <= 'f')) d

(* Checks proofs about a file, and that it is the file that they name, which is the reason if it is not. *)
let check_bound name lines digest check =
  let compare_digests () =
    if digest <> "-" && Text.digest lines <> digest then
      raise (Rejected (Printf.sprintf "%s: the proofs are about another file: they name the digest %s" name digest)) in
  match check () with
  | result -> compare_digests (); close_in lines.channel; result
  | exception Rejected reason -> compare_digests (); raise (Rejected reason)

(* @returns how many queries and contacts the file has, the next line, and what is said of the file *)
let check_queries f (shape, kind) digest name apart line =
  let q = opened_queries name in
  let rec check_from i contacts line = match next_query q shape apart with
    | None -> (i, contacts, line)
    | Some query ->
      let answer = read_answer f i line in
      let (proof, line) = Hints.read_proof f shape query answer in
      if not (check query answer proof) then
        raise (Rejected (Printf.sprintf "%s: query %d: the proof before line %d does not hold" name i f.number));
      check_from (i + 1) (if answer = No_contact then contacts else contacts + 1) line in
  let (queries, contacts, line) = check_bound name q.f digest (fun () -> check_from 0 0 line) in
  if queries = 0 then raise (Bad (name ^ ": there is nothing to check: the file has no query"));
  let text separation = (if q.is_curved then " with curved motion" else "") ^ separation in
  (queries, contacts, line, counted queries (kind ^ " query") (kind ^ " queries"), text)

let none_near = "no two elements that are asked about come near enough to need a proof"
(* The proofs of the pairs of a step. @returns how many pairs and contacts it has, and the next line *)
let check_pairs f name k near holds m mesh line =
  let what = Printf.sprintf "%s: step %d: " name k in
  let corners = corners m in
  let corner_of v = corners.(Z.to_int v) in
  let hints = Boxes.hints m corners in
  let pairs = match near corner_of hints with
    | Some pairs -> Array.of_list pairs
    | None -> raise (Rejected (what ^ "the boxes do not hold the vertices")) in
  let rank (((sort, a), b) : pair) = (Z.to_int (sort_number sort), Z.to_int a.index, Z.to_int b.index) in
  let order = Array.init (Array.length pairs) Fun.id in
  Array.stable_sort (fun i j -> compare (rank pairs.(i)) (rank pairs.(j))) order;
  let claims = Array.make (Array.length pairs) None and rest = ref line in
  let asked (((sort, a), b) : pair) = query_of mesh corner_of sort a b in
  let read number i =
    let query = asked pairs.(i) in
    let answer = read_answer f number !rest in
    let (proof, line) = Hints.read_proof f (List.length query.first, List.length query.second) query answer in
    claims.(i) <- Some ((pairs.(i), answer), proof);
    rest := line in
  let reject_first number i = match claims.(i) with  (* of those that do not hold *)
    | Some (((((_, a), b) as pair), answer), proof) when not (check (asked pair) answer proof) ->
      let called e = List.nth ["point "; "edge "; "face "] (List.length e.vertices - 1) ^ Z.to_string e.index in
      let pair = Printf.sprintf "pair %d (%s and %s)" number (called a) (called b) in
      raise (Rejected (what ^ pair ^ ": the proof does not hold"))
    | _ -> () in
  (try Array.iteri read order with (Rejected _ | Bad _) as error -> Array.iteri reject_first order; raise error);
  let claims = Array.map Option.get claims in
  if not (holds corner_of hints (Array.to_list claims)) then begin
    Array.iteri reject_first order;
    raise (Rejected (what ^ "the list of its pairs does not hold"))
  end;
  if match !rest with word :: _ -> is_digit word.[0] | [] -> false then
    reject f "a proof too many: the step has no more pairs whose boxes are at most the separation apart";
  let counted_contacts n ((_, answer), _) = if answer = No_contact then n else n + 1 in
  (Array.length pairs, Array.fold_left counted_contacts 0 claims, !rest)
let check_motion f digest name apart parts line =
  let (first, next) = opened_motion name apart in
  let has_radii = first.radii <> None in
  if has_radii && apart <> Zero then
    reject f "before this line: a motion with radii has the separations of its own, but here is another one";
  let in_order l =  (* near elements come one after the other *)
    let elements = Array.of_list l in
    let keyed = Array.map2 (fun key e -> (key, e)) (Boxes.keys first elements) elements in
    Array.stable_sort (fun (k, _) (k', _) -> compare (k : int) k') keyed;
    Array.to_list (Array.map snd keyed) in
  let { points; edges; faces; _ } = first.mesh in
  let mesh = { first.mesh with points = in_order points; edges = in_order edges; faces = in_order faces } in
  let near = near_pairs mesh and holds = check_step mesh and compare_frame = Frames.comparison parts first in
  let rec check_from m k pairs contacts line =
    compare_frame m.after (k + 1);
    if line <> ["step"; string_of_int k] then reject f (Printf.sprintf "here must be \"step %d\" of %s" k name);
    let (p, c, line) = check_pairs f name k near holds m mesh (words f) in
    match next m with
    | Some m -> check_from m (k + 1) (pairs + p) (contacts + c) line
    | None -> (m, k + 1, pairs + p, contacts + c, line) in
  let check () =
    compare_frame first.before 0;
    let (last, _, _, _, _) as checked = check_from first 0 0 0 line in
    Frames.check_count parts last.frames;
    checked in
  let (last, steps, pairs, contacts, line) = check_bound name first.f digest check in
  let contents = contents last in
  if pairs = 0 && not (has_pair last) then
    raise (Bad (Printf.sprintf "%s: there is nothing to check: %s, but no two elements that share no vertex, whose \
      groups are not ignored, and that are neither all fixed nor all on one body" name contents));
  let text separation =
    let separation = if has_radii then " with separation euclidean, the sum of two radii" else separation in
    Printf.sprintf " in %s%s: %s%s%s" (counted steps "step" "steps") separation contents (Frames.summary parts)
    (if pairs = 0 then "; " ^ none_near else "") in
  (pairs, contacts, line, counted pairs "mesh query" "mesh queries", text)

(* The proofs of one file; what is said of it is added to the report.
   @returns how many queries, contacts and motions it has, and the next line *)
let check_file f report parts line name =
  let (apart, separation, line) = match line with
    | ["separation"; ("euclidean" | "max" as metric); word] ->
      let d = rational (number f word) in
      if Z.sign d.qnum <= 0 then reject f "the separation must be above zero";
      let apart = if metric = "max" then Max d else Euclidean d in
      (apart, Printf.sprintf " with separation %s %s" metric word, words f)
    | "separation" :: _ -> reject f "here must be \"separation euclidean D\" or \"separation max D\""
    | _ -> (Zero, "", line) in
  match line with
  | "file" :: kind :: digest :: _ :: _ when (kind = "mesh" || List.mem_assoc kind kinds) && is_digest digest ->
    let is_mesh = kind = "mesh" and line = words f in
    let (queries, contacts, line, number, text) =
      if is_mesh then check_motion f digest name apart parts line
      else check_queries f (List.assoc kind kinds, kind) digest name apart line in
    let unbound = if digest = "-" then "; the proofs name no digest of the file" else "" in
    Buffer.add_string report (Printf.sprintf "%s: %s%s%s\n" (printable name) number (text separation) unbound);
    (queries, contacts, Bool.to_int is_mesh, line)
  | _ -> reject f ("here must be \"file KIND DIGEST NAME\": the proofs for " ^ name)

let run allow_empty parts proofs files =
  let f = opened proofs and report = Buffer.create 256 in
  if words f <> ["touchstone-proofs"; "1"] then bad f "the first line must be \"touchstone-proofs 1\"";
  let check (queries, contacts, motions, line) name =
    let (q, c, m, line) = check_file f report parts line name in (queries + q, contacts + c, motions + m, line) in
  let (queries, contacts, motions, line) = List.fold_left check (0, 0, 0, words f) files in
  if line <> ["end"; string_of_int queries; string_of_int contacts] || words f <> [] then
    reject f (Printf.sprintf "here must be \"end %d %d\", and nothing after it" queries contacts);
  if queries = 0 && not allow_empty then
    raise (Rejected ("no query was checked: " ^ none_near ^ "; --allow-empty accepts this, and the digest of each file \
      must show that it is the right one"));
  if parts <> [] && (motions <> 1 || List.length files <> 1) then
    raise (Bad "--frames goes with one motion file and nothing else");
  let answers = Printf.sprintf "%s, %d without contact" (counted contacts "contact" "contacts") (queries - contacts) in
  print_string (Buffer.contents report);
  Printf.printf "%s checked: %s%s\n%!" (counted queries "query" "queries") (if queries > 0 then answers else none_near)
    (if motions > 0 then "; not asked: whether a first frame intersects itself, and what lines above leave out" else "")

(* The program with its arguments. @returns its exit status *)
let main arguments =
  let finish status text = prerr_endline text; status in
  let usage = "usage: touchstone-check-proved [OPTION]... PROOFS FILE...\n\
    Checks the proofs of `touchstone prove` against their query files or motion files, in their order. Each file must\n\
    have the digest that the proofs name. The checker is proved in Coq.\n\
    \  --allow-empty      accept a motion whose elements never come near enough to need a proof\n\
    \  --frames PATTERN   the frames of the motion must be these files, OBJ or binary PLY, bit by bit, and its\n\
    \                     elements their triangles, lines and points; in quotes, such as 'cloth-*.obj'. Once for\n\
    \                     each part of a scene, in the order of the parts; one file is a part at rest then\n\
    Exit status: 0 every proof holds, 1 some proof does not, is about other files, or none was needed, 2 bad usage, a\n\
    file that cannot be read, or nothing to check: no query, or a motion in which no two elements could meet." in
  let rec run_with allow_empty patterns = function
    | "--allow-empty" :: rest -> run_with true patterns rest
    | "--frames" :: pattern :: rest -> run_with allow_empty (pattern :: patterns) rest
    | ("--help" | "-h") :: _ -> print_endline usage; 0
    | proofs :: (_ :: _ as files) -> run allow_empty (List.rev_map Frames.part patterns) proofs files; 0
    | _ -> finish 2 usage in
  try run_with false [] arguments with
  | Rejected reason -> finish 1 ("rejected: " ^ printable reason)
  | Bad reason -> finish 2 ("touchstone-check-proved: " ^ printable reason)
  | Sys_error reason ->
    close_out_noerr stdout;
    finish 2 ("touchstone-check-proved: standard output cannot be written: " ^ printable reason)
  | Out_of_memory | Stack_overflow -> finish 2 "touchstone-check-proved: the files are too large"
