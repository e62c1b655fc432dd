(* Motion files, and the steps of their motions. What is read here has to be right: see docs/proved.md.
   SPDX-License-Identifier: MIT *)
open Proved
open Text

(* The numbers of each body's pose, and of each vertex; a vertex on a body has none. *)
type frame = { poses : (Z.t * int) array array; rows : (Z.t * int) array array }
(* The radii of elements by their number of vertices and their index, each with its word; and pairs of vertices. *)
type radii = { lengths : (int * Z.t, (Z.t * int) * string) Hashtbl.t; near : (int * int, unit) Hashtbl.t }
(* The groups of vertices, and the pairs of groups that are ignored. *)
type groups = { of_vertices : (int, int) Hashtbl.t; ignored_pairs : (int * int, unit) Hashtbl.t }
(* A motion in the step from one frame to the next one; `line` is the one after them.
   All separations are multiples of 2^finest. *)
type motion = { f : lines; size : int; mesh : mesh; on_bodies : (int, int * rational_point) Hashtbl.t; bodies : int;
                radii : radii option; groups : groups; touching : ((int * Z.t) * (int * Z.t), unit) Hashtbl.t;
                finest : int; fixed_vertices : int; frames : int;
                before : frame; after : frame; line : string list }

let most = 1 lsl 30 - 1
(* How many corners the elements of a kind have. *)
let kinds = ["edge-edge", (2, 2); "vertex-face", (1, 3); "point-edge", (1, 2); "point-point", (1, 1)]
(* The elements of each sort, the fixed vertices, the points of bodies, the radii, the groups, the pairs that only touch,
   and the line after them. *)
let read_elements f size =
  let lines = Hashtbl.create 64 and on_bodies = Hashtbl.create 64 in
  let lengths = Hashtbl.create 64 and near = Hashtbl.create 64 and radius = ref None in
  let of_vertices = Hashtbl.create 64 and ignored_pairs = Hashtbl.create 64 and touching = Hashtbl.create 64 in
  let vertex word =
    let v = count f most word in
    if v < size then v else bad f (Printf.sprintf "here must be a vertex below %d" size) in
  let once sort word =
    let v = vertex word in
    if Hashtbl.mem lines (sort, v) then bad f "the vertex has such a line already";
    Hashtbl.add lines (sort, v) ();
    v in
  let added words all =
    let vertices = List.map vertex words in
    if List.length (List.sort_uniq compare vertices) < List.length words then bad f "an element has a vertex twice";
    let index = match all with [] -> Z.zero | e :: _ -> Z.succ e.index in
    Option.iter (Hashtbl.add lengths (List.length vertices, index)) !radius;
    { index; vertices = List.map Z.of_int vertices } :: all in
  let rec read points edges faces fixed = match words f with
    | ["point"; v] -> ignore (once "point" v); read (added [v] points) edges faces fixed
    | ["edge"; v; w] -> read points (added [v; w] edges) faces fixed
    | ["face"; v; w; x] -> read points edges (added [v; w; x] faces) fixed
    | ["fixed"; v] -> read points edges faces (once "fixed" v :: fixed)
    | ["body"; v; b; x; y; z] ->
      let v = once "body" v and coordinate word = rational (number f word) in
      Hashtbl.add on_bodies v (count f (most - 1) b, { qx = coordinate x; qy = coordinate y; qz = coordinate z });
      read points edges faces fixed
    | ["radius"; word] ->
      let length = number f word in
      if Z.sign (fst length) < 0 then bad f "a radius must not be negative";
      radius := Some (length, word);
      read points edges faces fixed
    | ["near"; v; w] ->
      let v = vertex v and w = vertex w in
      if v = w || Hashtbl.mem near (min v w, max v w) then bad f "here must be two vertices that are not near yet";
      Hashtbl.add near (min v w, max v w) ();
      read points edges faces fixed
    | ["group"; v; g] -> Hashtbl.add of_vertices (once "group" v) (count f most g); read points edges faces fixed
    | ["ignore"; g; h] ->
      let g = count f most g and h = count f most h in
      if Hashtbl.mem ignored_pairs (min g h, max g h) then bad f "here must be two groups that are not ignored yet";
      Hashtbl.add ignored_pairs (min g h, max g h) ();
      read points edges faces fixed
    | ["touching"; kind; i; j] when List.mem_assoc kind kinds ->
      let (n, m) = List.assoc kind kinds and i = count f most i and j = count f most j in
      let key = ((n, Z.of_int i), (m, Z.of_int j)) in
      if (n = m && i >= j) || Hashtbl.mem touching key then
        bad f "here must be two elements in their order, which have no such line";
      Hashtbl.add touching key ();
      read points edges faces fixed
    | ["frame"] | [] as line ->
      let radii = if !radius = None then None else Some { lengths; near } in
      let groups = { of_vertices; ignored_pairs } in
      (List.rev points, List.rev edges, List.rev faces, fixed, on_bodies, radii, groups, touching, line)
    | _ -> bad f "here must be a line of a point, an edge, a face, a fixed vertex, one on a body, a radius, two \
                  vertices that are near, a group, two that are ignored, two elements that touch, or \"frame\"" in
  read [] [] [] []

(* The frame whose first line is `m.line` becomes the one after the step. What is fixed has the same numbers in it. *)
let read_frame is_still m =
  if m.line <> ["frame"] then bad m.f (Printf.sprintf "here must be \"frame\" alone, of frame %d" m.frames);
  let rec read what size n has_row is_fixed old k line rows =
    if k = n then (Array.of_list (List.rev rows), line)
    else if not (has_row k) then read what size n has_row is_fixed old (k + 1) line ([||] :: rows)
    else begin
      if List.length line <> size then
        bad m.f (Printf.sprintf "here must be the %d numbers of %s %d in frame %d" size what k m.frames);
      let row = Array.of_list (List.map (number m.f) line) in
      if m.frames > 0 && is_fixed k && not (Array.for_all2 (fun a b -> compared a b = 0) old.(k) row) then
        bad m.f (Printf.sprintf "%s %d is fixed, but has moved in frame %d" what k m.frames);
      read what size n has_row is_fixed old (k + 1) (words m.f) (row :: rows)
    end in
  let (poses, line) = read "body" 7 m.bodies (fun _ -> true) is_still m.after.poses 0 (words m.f) [] in
  let is_free v = not (Hashtbl.mem m.on_bodies v) and is_fixed v = m.mesh.fixed (Z.of_int v) in
  let (rows, line) = read "vertex" 3 m.size is_free is_fixed m.after.rows 0 line [] in
  { m with before = m.after; after = { poses; rows }; frames = m.frames + 1; line }

(* The separation of two elements: the sum of their radii, rounded up; zero for neighbours. *)
let key_of e = (List.length e.vertices, e.index)
let sum_of_radii { lengths; near } a b =
  let radius e = match Hashtbl.find_opt lengths (key_of e) with
    | Some (length, _) -> length
    | None -> (Z.zero, 0) in
  let are_near v w = Hashtbl.mem near (Z.to_int (Z.min v w), Z.to_int (Z.max v w)) in
  if List.exists (fun v -> List.exists (are_near v) b.vertices) a.vertices then Zero
  else
    let d = rational (rounded_up (sum (radius a) (radius b))) in
    if Z.sign d.qnum = 0 then Zero else Euclidean d

(* @returns the motion in its first step, and the function that leads to the next one: None after the last one *)
let opened_motion name apart =
  let f = opened name in
  if words f <> ["touchstone-motion"; "1"] then bad f "the first line must be \"touchstone-motion 1\"";
  let size = match words f with ["vertices"; n] -> count f most n | _ -> bad f "here must be \"vertices N\"" in
  let (points, edges, faces, all_fixed, on_bodies, radii, groups, touching, line) = read_elements f size in
  let fixed = Hashtbl.create 64 and still = Hashtbl.create 64 in
  let rest v =
    Hashtbl.replace fixed v ();
    Option.iter (fun (b, _) -> Hashtbl.replace still b ()) (Hashtbl.find_opt on_bodies v) in
  List.iter rest all_fixed;
  let bodies = Hashtbl.fold (fun _ (b, _) n -> max (b + 1) n) on_bodies 0 in
  let (asked, (m, e), finest) = match radii, apart with
    | Some radii, _ ->
      let greater _ (x, _) y = if compared x y > 0 then x else y in
      let r = Hashtbl.fold greater radii.lengths (Z.zero, 0) in
      (sum_of_radii radii, rounded_up (sum r r), Hashtbl.fold (fun _ ((_, e), _) e' -> min e e') radii.lengths 0)
    | None, Zero -> ((fun _ _ -> apart), (Z.zero, 0), 0)
    | None, (Euclidean d | Max d) -> let e = 1 - Z.numbits d.qden in ((fun _ _ -> apart), (d.qnum, e), e) in
  let fixed v = Hashtbl.mem fixed (Z.to_int v) in
  let asked a b = if Hashtbl.mem touching (key_of a, key_of b) then Zero else asked a b in
  let group v = Z.of_int (Option.value (Hashtbl.find_opt groups.of_vertices (Z.to_int v)) ~default:(-1)) in
  let ignored g h = Hashtbl.mem groups.ignored_pairs (Z.to_int (Z.min g h), Z.to_int (Z.max g h)) in
  let mesh = { points; edges; faces; fixed; group; ignored; asked; most = rational (m, e) } in
  let none = { poses = [||]; rows = [||] } in
  let m = { f; size; mesh; on_bodies; bodies; radii; groups; touching; finest;
            fixed_vertices = List.length all_fixed; frames = 0; before = none; after = none; line } in
  let read = read_frame (Hashtbl.mem still) in
  (read (read m), fun m -> if m.line = [] then None else Some (read m))

(* The corners of all vertices during the step. *)
let corners m =
  let point row k = { qx = rational row.(k); qy = rational row.(k + 1); qz = rational row.(k + 2) } in
  let motion b =
    let q = m.before.poses.(b) and q' = m.after.poses.(b) in
    { s_0 = rational q.(0); v_0 = point q 1; s_1 = rational q'.(0); v_1 = point q' 1;
      p_0 = point q 4; p_1 = point q' 4 } in
  let motions = Array.init m.bodies motion in
  Array.init m.size (fun v -> match Hashtbl.find_opt m.on_bodies v with
    | Some (b, y) -> On_body (Z.of_int (b + 1), motions.(b), y)
    | None -> On_curve [point m.before.rows.(v) 0; point m.after.rows.(v) 0])

(* Whether an element has a group that is asked about with one of the list. *)
let asked_with { group; ignored; _ } elements =
  let groups_of l = List.sort_uniq compare (List.concat_map (fun e -> List.map group e.vertices) l) in
  let groups = groups_of elements and known = Hashtbl.create 64 in
  let has_partner g = match Hashtbl.find_opt known g with
    | Some known -> known
    | None ->
      let is_asked = List.exists (fun h -> not (ignored g h)) groups in
      Hashtbl.add known g is_asked;
      is_asked in
  fun e -> List.exists has_partner (groups_of [e])

(* Whether two elements could meet at all, however far apart they are. *)
let has_pair m =
  let { points; edges; faces; fixed; _ } = m.mesh and w = wiring_of m.mesh in
  let body v = match Hashtbl.find_opt m.on_bodies (Z.to_int v) with Some (b, _) -> b | None -> -1 in
  let is_still a = List.for_all fixed a.vertices in
  let is_rigid l =
    let bodies = List.sort_uniq compare (List.concat_map (fun a -> List.map body a.vertices) l) in
    List.for_all is_still l || (List.length bodies = 1 && bodies <> [-1]) in
  let meet may_meet (one, other) =
    let moving = List.filter (fun b -> not (is_still b)) other in
    let meets a b = separate (a, b) && is_asked m.mesh (a, b) && not (is_rigid [a; b]) && may_meet a b in
    let has_partner = asked_with m.mesh other in
    let has_other a = has_partner a && List.exists (meets a) (if is_still a then moving else other) in
    not (is_rigid (List.rev_append one other)) && List.exists has_other one in
  List.exists (meet (fun _ _ -> true)) [(edges, edges); (points, faces); (w.alone, edges); (w.alone, w.alone)]
  || meet (are_joined w) (w.ends, w.wires)

let counted n one several = Printf.sprintf "%d %s" n (if n = 1 then one else several)
(* The numbers of corners that are no points, and of sides that are no edges. *)
let undeclared m =
  let { points; edges; faces; _ } = m.mesh in
  let corners = Hashtbl.create 64 and sides = Hashtbl.create 64 in
  let side v w = if Z.lt v w then (v, w) else (w, v) in
  let rec add_sides = function v :: (w :: _ as l) -> Hashtbl.replace sides (side v w) (); add_sides l | _ -> () in
  let corners_of e = List.iter (fun v -> Hashtbl.replace corners v ()) e.vertices in
  List.iter corners_of edges;
  List.iter (fun e -> corners_of e; add_sides (e.vertices @ [List.hd e.vertices])) faces;
  List.iter (fun e -> List.iter (Hashtbl.remove corners) e.vertices) points;
  List.iter (fun e -> Hashtbl.remove sides (side (List.hd e.vertices) (List.nth e.vertices 1))) edges;
  (Hashtbl.length corners, Hashtbl.length sides)
let vertices first last =
  if first = last then Printf.sprintf "vertex %d" first else Printf.sprintf "vertices %d to %d" first last
(* How many pairs are asked about touching alone, and how many of them no edges join. *)
let touching_pairs m =
  let root = Array.init m.size Fun.id in  (* of trees of vertices that edges join *)
  let rec root_of v = if root.(v) = v then v else begin root.(v) <- root.(root.(v)); root_of root.(v) end in
  let join e = match List.map Z.to_int e.vertices with
    | [v; w] -> root.(root_of v) <- root_of w
    | _ -> () in
  List.iter join m.mesh.edges;
  let sorts = Array.map Array.of_list [| m.mesh.points; m.mesh.edges; m.mesh.faces |] in
  let one_of (size, index) =  (* a vertex of the element, which may not exist *)
    let elements = sorts.(size - 1) and i = Z.to_int index in
    if i < Array.length elements then root_of (Z.to_int (List.hd elements.(i).vertices)) else -1 in
  let apart = Hashtbl.fold (fun (a, b) () n -> if one_of a = one_of b then n else n + 1) m.touching 0 in
  counted (Hashtbl.length m.touching) "pair" "pairs" ^ " asked about touching alone"
  ^ if apart > 0 then Printf.sprintf ", %d of them joined by no edges" apart else ""
(* Of groups or bodies, each vertex with its number in ascending order. @returns "0 has vertices 0 to 7 and vertex 9" *)
let text_of_runs members named =
  let runs = Hashtbl.create 64 in
  let add (v, number) = Hashtbl.replace runs number (match Hashtbl.find_opt runs number with
    | Some ((first, last) :: rest) when last + 1 = v -> (first, v) :: rest
    | all -> (v, v) :: Option.value all ~default:[]) in
  List.iter add members;
  let of_number number = match Hashtbl.find_opt runs number with
    | None -> Printf.sprintf "%d has no vertex" number
    | Some all ->
      Printf.sprintf "%d has %s" number
        (String.concat " and " (List.rev_map (fun (first, last) -> vertices first last) all)) in
  String.concat ", " (List.map of_number named)
let in_order table = List.sort compare (List.of_seq table)
(* The pairs of groups that are ignored, and the vertices of these groups. *)
let ignored_groups { of_vertices; ignored_pairs } =
  let members = in_order (Hashtbl.to_seq of_vertices) and pairs = in_order (Hashtbl.to_seq_keys ignored_pairs) in
  let named = List.sort_uniq compare (List.concat_map (fun (g, h) -> [g; h]) pairs) in
  Printf.sprintf "%s of vertices, %s of groups not asked about: %s, where %s"
    (counted (List.length (List.sort_uniq compare (List.map snd members))) "group" "groups")
    (counted (List.length pairs) "pair" "pairs")
    (String.concat " " (List.map (fun (g, h) -> Printf.sprintf "%d-%d" g h) pairs))
    (text_of_runs members named)
let vertices_on_bodies m =
  let members = in_order (Seq.map (fun (v, (b, _)) -> (v, b)) (Hashtbl.to_seq m.on_bodies)) in
  let bodies = List.sort_uniq compare (List.map snd members) in
  Printf.sprintf "%s on %s, where %s" (counted (List.length members) "vertex" "vertices")
    (counted (List.length bodies) "body" "bodies") (text_of_runs members bodies)
let unused m =
  let used = Hashtbl.create 64 in
  let { points; edges; faces; _ } : mesh = m.mesh in
  List.iter (List.iter (fun e -> List.iter (fun v -> Hashtbl.replace used v ()) e.vertices)) [points; edges; faces];
  m.size - Hashtbl.length used
(* What the proofs are about, and what is no element. *)
let contents m =
  let { points; edges; faces; _ } = m.mesh and (corners, sides) = undeclared m in
  let some n text = if n = 0 then [] else [text] in
  let elements l name = counted (List.length l) name (name ^ "s") in
  let with_radii { lengths; near } =
    let of_sort = List.filter_map (fun e -> Hashtbl.find_opt lengths (key_of e)) in
    let above = List.filter (fun ((m, _), _) -> Z.sign m > 0) (List.concat_map of_sort [points; edges; faces]) in
    let first sign = List.fold_left (fun (x, w) (y, v) -> if sign * compared y x > 0 then (y, v) else (x, w)) in
    let from = match above with
      | [] -> ""
      | one :: rest -> Printf.sprintf " from %s to %s" (snd (first (-1) one rest)) (snd (first 1 one rest)) in
    (counted (List.length above) "element" "elements" ^ " with radii" ^ from)
    :: some (Hashtbl.length near) (counted (Hashtbl.length near) "pair of neighbours" "pairs of neighbours") in
  String.concat ", "
    ([counted m.frames "frame" "frames"; counted m.size "vertex" "vertices"; elements points "point";
      elements edges "edge"; elements faces "face"]
     @ Option.fold ~none:[] ~some:with_radii m.radii
     @ some m.fixed_vertices (counted m.fixed_vertices "fixed vertex" "fixed vertices")
     @ (if m.bodies > 0 then [vertices_on_bodies m] else [])
     @ (if Hashtbl.length m.touching > 0 then [touching_pairs m] else [])
     @ (if Hashtbl.length m.groups.ignored_pairs > 0 then [ignored_groups m.groups] else [])
     @ some corners (counted corners "corner is no point" "corners are no points")
     @ some sides (counted sides "side is no edge" "sides are no edges")
     @ some (unused m) (counted (unused m) "vertex is in no element" "vertices are in no element"))
