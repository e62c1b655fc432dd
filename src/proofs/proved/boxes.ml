(* Boxes of vertices, and an order of elements in which neighbours are near. Nothing here has to be right:
   Proved.check_step accepts no false answer, whatever else it is given.
   SPDX-License-Identifier: MIT *)
open Proved
open Text
open Meshes

(* The greatest double that is at most n / d, and the least one that is at least n / d. *)
let rec double_below n d e =
  let m = Z.fdiv (Z.shift_left n (max (- e) 0)) (Z.shift_left d (max e 0)) in
  if Z.numbits m > 53 then double_below n d (e + 1) else (m, e)
let double_below n d = double_below n d (max (Z.numbits n - Z.numbits d - 53) (-1074))
let double_above n d = let (m, e) = double_below (Z.neg n) d in (Z.neg m, e)

(* Where a corner of a body is during a step, along each axis. *)
let reach_on_body f c =
  let (u, h) = Hints.units [c] in
  let { numerator; weight; _ } = moving_of u h c in
  let w = bernstein step (weight @ [Z.zero]) in  (* as many as there are of each coordinate *)
  if not (List.for_all (fun w -> Z.sign w > 0) w) then
    bad f "a body turns too far in the step that ends before this line";
  let along x =
    let fractions = List.combine (bernstein step x) w in
    let lesser (x, w) (x', w') = if Z.lt (Z.mul x' w) (Z.mul x w') then (x', w') else (x, w) in
    let greater (x, w) (x', w') = if Z.gt (Z.mul x' w) (Z.mul x w') then (x', w') else (x, w) in
    let (n, d) = List.fold_left lesser (List.hd fractions) fractions in
    let (n', d') = List.fold_left greater (List.hd fractions) fractions in
    (double_below n d, double_above n' d') in
  [| along numerator.vx; along numerator.vy; along numerator.vz |]

(* The least and the greatest coordinates of each vertex during the step. *)
let reaches m corners =
  let least a b = if compared a b <= 0 then a else b and greatest a b = if compared a b >= 0 then a else b in
  let reach v = function
    | On_curve _ -> Array.map2 (fun a b -> (least a b, greatest a b)) m.before.rows.(v) m.after.rows.(v)
    | On_body _ as c -> reach_on_body m.f c in
  Array.mapi reach corners

(* The boxes of all vertices, and what else is known of them. *)
let hints m corners =
  let { most; fixed; group; ignored; _ } = m.mesh and reach = reaches m corners in
  let lower low (_, e) = min low e in
  let lowest low r = Array.fold_left (fun low (a, b) -> lower (lower low a) b) low r in
  let low = Array.fold_left lowest (min 0 m.finest) reach in
  let scaled (m, e) = Z.shift_left m (e - low) in
  let margin = scaled (most.qnum, 1 - Z.numbits most.qden) in
  let rec balanced first last =
    if first = last then Nothing
    else
      let v = (first + last) / 2 in
      let (u, h) = Hints.units [corners.(v)] in
      let from k = scaled (fst reach.(v).(k)) and until k = Z.add margin (scaled (snd reach.(v).(k))) in
      let extent = { lx = from 0; ly = from 1; lz = from 2; rx = until 0; ry = until 1; rz = until 2 } in
      let carrier = match corners.(v) with On_body (n, _, _) -> Some n | On_curve _ -> None in
      let kin = let g = group (Z.of_int v) in if ignored g g then Some g else None in
      let known = { extent; still = fixed (Z.of_int v); carrier; kin } in
      Entry (Z.of_int v, u, h, known, balanced first v, balanced (v + 1) last) in
  { box_unit = Z.shift_left Z.one (- low); summaries = balanced 0 (Array.length corners); all_near = m.radii = None }

(* A key for each element: in the order of their keys neighbours are near each other. Those of a body
   come together, and so do those of a group. *)
let keys m elements =
  let reach = reaches m (corners m) in
  let about (m, e) = Float.ldexp (Z.to_float m) e in
  let vertex i = Z.to_int (List.hd elements.(i).vertices) in
  let n = Array.length elements in
  let start = Array.init 3 (fun k -> Array.init n (fun i -> about (fst reach.(vertex i).(k)))) in
  let body_of v = match Hashtbl.find_opt m.on_bodies v with Some (b, _) -> b | None -> -1 in
  let group_of v = Option.value (Hashtbl.find_opt m.groups.of_vertices v) ~default:(-1) in
  let body = Array.init n (fun i -> (body_of (vertex i), group_of (vertex i))) in
  let all = Array.init n Fun.id in
  Array.stable_sort (fun i j -> compare (body.(i) : int * int) body.(j)) all;
  (* Sorts the elements from `first` to `last - 1`: each half is on its side of the longest axis. *)
  let rec halve first last =
    if last - first > 2 then begin
      let width x =
        let least = ref infinity and most = ref neg_infinity in
        for i = first to last - 1 do
          let x = (x : float array).(all.(i)) in
          if x < !least then least := x;
          if x > !most then most := x
        done;
        !most -. !least in
      let longer x y = if width x >= width y then x else y in
      let along = longer start.(0) (longer start.(1) start.(2)) in
      let some = Array.sub all first (last - first) in
      Array.stable_sort (fun i j -> Float.compare along.(i) along.(j)) some;
      Array.blit some 0 all first (last - first);
      let rec half size = if 2 * size < last - first then half (2 * size) else size in
      halve first (first + half 1);
      halve (first + half 1) last
    end in
  let rec by_body first last =
    if last < n && body.(all.(first)) = body.(all.(last)) then by_body first (last + 1)
    else if first < last then begin halve first last; by_body last last end in
  by_body 0 0;
  let keys = Array.make n 0 in
  Array.iteri (fun key i -> keys.(i) <- key) all;
  keys
