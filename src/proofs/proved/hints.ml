(* What a proof says besides its answer. Nothing here has to be right: Proved.check accepts no false answer, whatever
   else it is given.
   SPDX-License-Identifier: MIT *)
open Proved
open Text

let coefficients f words =
  if List.length words > 33 then bad f "a polynomial has too many coefficients: at most 33 are read";
  List.map (number f) words
(* All of them times one power of two that makes them integers. *)
let scaled groups =
  let low = List.fold_left (List.fold_left (fun low (_, e) -> min low e)) max_int groups in
  List.map (List.map (fun (m, e) -> Z.shift_left m (e - low))) groups

let direction f corners = function
  | ["n"] when corners = 4 -> Normal
  | "d" :: words when words <> [] && List.length words mod 3 = 0 ->
    let along k = coefficients f (List.filteri (fun i _ -> i mod 3 = k) words) in
    (match scaled [along 0; along 1; along 2] with [vx; vy; vz] -> Along { vx; vy; vz } | _ -> assert false)
  | _ -> reject f "here must be a piece: \"n\" for four corners, or \"d\" and three numbers for each coefficient"
let rec read_pieces f corners line pieces =
  match List.rev line with
  | last :: "to" :: rest when rest <> [] ->
    let piece = (direction f corners (List.rev rest), time f last) in
    read_pieces f corners (words f) (piece :: pieces)
  | _ -> let last = direction f corners line in (List.rev pieces, last, words f)

let read_root f line t u = match line with
  | "root" :: rest ->
    let (rest, lower, upper) = match List.rev rest with
      | h :: l :: "between" :: rest when rest <> [] -> (List.rev rest, time f l, time f h)
      | _ -> (rest, t, u) in
    let g = List.hd (scaled [coefficients f rest]) in
    let n = List.length g in
    if n < 2 || Z.sign (List.nth g (n - 1)) = 0 then reject f "the polynomial must have a degree of at least 1";
    let factor = List.fold_left Z.gcd Z.zero g in
    (List.map (fun c -> Z.divexact c factor) g, lower, upper)
  | _ -> reject f "here must be \"root\" and the coefficients of a polynomial"

(* Those of both elements, and the line after them. *)
let read_weights f (first, second) line =
  let corners = first + second in
  let rec read line known = match line with
    | "w" :: i :: (_ :: _ as rest) ->
      let known_corner = List.exists (fun k -> string_of_int k = i) (List.init corners Fun.id) in
      if not known_corner || List.mem_assoc i known then reject f "here must be a corner that has no weight yet";
      read (words f) ((i, coefficients f rest) :: known)
    | "w" :: _ -> reject f "here must be \"w\", a corner and the coefficients of a polynomial"
    | _ ->
      let weight i = Option.value (List.assoc_opt (string_of_int i) known) ~default:[] in
      (split first (scaled (List.init corners weight)), line) in
  read line []

(* T = mantissa / 2^places, with a mantissa of 53 bits if there is one. *)
let mantissa_of (m, e) =
  let low = if Z.sign m = 0 then -1074 else max (e + Z.numbits m - 53) (-1074) in
  if e < low then (Z.minus_one, Z.zero) else (Z.shift_left m (e - low), Z.of_int (- low))

(* Common denominators: of quaternions, and of coordinates. *)
let unit_of u (x : q) = if Z.divisible u x.qden then u else Z.lcm u x.qden
let unit_of_point u a = unit_of (unit_of (unit_of u a.qx) a.qy) a.qz
let turn_unit_of u m = unit_of_point (unit_of_point (unit_of (unit_of u m.s_0) m.s_1) m.v_0) m.v_1
let units corners =
  let add (u, h) = function
    | On_curve control -> (List.fold_left unit_of_point u control, h)
    | On_body (_, m, y) -> (unit_of_point (unit_of_point (unit_of_point u m.p_0) m.p_1) y, turn_unit_of h m) in
  List.fold_left add (Z.one, Z.one) corners

(* The lines after that of the answer, as far as they belong to it. @returns the proof, and the next line *)
let read_proof f (first, second) query answer =
  let corners = first + second and zero = rational (Z.zero, 0) in
  let (coordinate_unit, turn_unit) = units (query.first @ query.second) in
  let p = { coordinate_unit; turn_unit; pieces = []; last_piece = Normal; mantissa = Z.zero; places = Z.zero;
            root = []; lower = zero; upper = zero; weights = ([], []) } in
  let pieces_of p line =
    let (pieces, last_piece, line) = read_pieces f corners line [] in ({ p with pieces; last_piece }, line) in
  let dyadic (t : q) = let k = Z.numbits t.qden - 1 in (t.qnum, - k) in
  let timed t = let (mantissa, places) = mantissa_of (dyadic t) in { p with mantissa; places } in
  let line = words f in
  match answer with
  | No_contact -> pieces_of p line
  | Contact_at t ->
    let (p, line) = if Z.sign t.qnum = 0 then (timed t, line) else pieces_of (timed t) line in
    let (weights, line) = read_weights f (first, second) line in
    ({ p with weights }, line)
  | Contact_between (t, u) ->
    let (p, line) = pieces_of (timed t) line in
    let (root, lower, upper) = read_root f line t u in
    let (weights, line) = read_weights f (first, second) (words f) in
    ({ p with root; lower; upper; weights }, line)
