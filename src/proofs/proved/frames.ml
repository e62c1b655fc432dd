(* The frames of a motion beside the mesh files of a person, for the option --frames. No answer depends on it; it has to
   be right if a motion must be that of the files.
   SPDX-License-Identifier: MIT *)
open Proved
open Text
open Meshes

(* Whether a name fits a pattern from these places on: * ? [a-z] [!a] and \ have a meaning, as in a shell. *)
let rec fits p i s j =
  let n = String.length p in
  let one is_like next = j < String.length s && is_like s.[j] && fits p next s (j + 1) in
  if i = n then j = String.length s else match p.[i] with
    | '*' -> fits p (i + 1) s j || (j < String.length s && fits p i s (j + 1))
    | '?' -> one (fun _ -> true) (i + 1)
    | '\\' when i + 1 < n -> one (Char.equal p.[i + 1]) (i + 2)
    | '[' ->
      let is_not = i + 1 < n && (p.[i + 1] = '!' || p.[i + 1] = '^') in
      let first = if is_not then i + 2 else i + 1 in
      (match if first < n then String.index_from_opt p (first + 1) ']' else None with
       | None -> one (Char.equal '[') (i + 1)
       | Some last ->
         let rec holds k c =
           if k >= last then false
           else if k + 2 < last && p.[k + 1] = '-' then (p.[k] <= c && c <= p.[k + 2]) || holds (k + 3) c
           else p.[k] = c || holds (k + 1) c in
         one (fun c -> holds first c <> is_not) (last + 1))
    | c -> one (Char.equal c) (i + 1)
(* The files that a pattern names. Digits in their names count as numbers: a-2 comes before a-10. *)
let files_of pattern =
  let starts_class i c = c = '[' && i + 2 < String.length pattern && pattern.[i + 1] = '[' &&
    String.contains ":=." pattern.[i + 2] in
  if List.exists Fun.id (List.mapi starts_class (List.of_seq (String.to_seq pattern))) then
    raise (Bad (pattern ^ ": --frames takes sets such as [0-9] alone"));
  let is_special = String.exists (fun c -> String.contains "*?[\\" c) in
  let rec expand base = function
    | [] -> if Sys.file_exists base then [base] else []
    | word :: rest ->
      let path name = base ^ name ^ if rest = [] then "" else "/" in
      if not (is_special word) then expand (path word) rest
      else
        let names = try Sys.readdir (if base = "" then "." else base) with Sys_error _ -> [||] in
        let is_meant name = (name.[0] <> '.' || word.[0] = '.') && fits word 0 name 0 in
        List.concat_map (fun name -> expand (path name) rest) (List.filter is_meant (Array.to_list names)) in
  let rec tokens s i =  (* numbers without leading zeros, with their lengths, and characters *)
    let n = String.length s in
    let rec after_digits k = if k < n && is_digit s.[k] then after_digits (k + 1) else k in
    let rec after_zeros k last = if k < last && s.[k] = '0' then after_zeros (k + 1) last else k in
    if i = n then []
    else
      let next = after_digits i in
      if next = i then (0, String.make 1 s.[i]) :: tokens s (i + 1)
      else let first = after_zeros i (next - 1) in (next - first, String.sub s first (next - first)) :: tokens s next in
  let compare_tokens (n, s) (m, t) = if n > 0 && m > 0 && n <> m then compare n m else String.compare s t in
  match List.sort String.compare (expand "" (String.split_on_char '/' pattern)) with
  | [] -> raise (Bad (pattern ^ ": no file has such a name"))
  | files -> List.stable_sort (fun a b -> List.compare compare_tokens (tokens a 0) (tokens b 0)) files

(* Coordinates, and the vertices of triangles, lines and points. A polygon of more than three corners stands for the
   triangles that its first corner makes with the sides that it is no end of. *)
type mesh_file = { positions : (Z.t * int) array; triangles : int list list; lines : int list list; points : int list }
let rec fan first = function v :: (w :: _ as rest) -> [first; v; w] :: fan first rest | _ -> []
let rec sides = function v :: (w :: _ as rest) -> [v; w] :: sides rest | _ -> []

(* What another reader may take for a face, a line or a point is refused. *)
let read_obj name =
  let f = opened name in
  let vertex count word =
    let n = Option.bind (List.nth_opt (String.split_on_char '/' word) 0) integer in
    match Option.map (fun n -> if Z.sign n < 0 then Z.add n (Z.of_int (count + 1)) else n) n with
    | Some n when Z.sign n > 0 && Z.leq n (Z.of_int count) -> Z.to_int n - 1
    | _ -> bad f (Printf.sprintf "\"%s\" is no vertex above this line" (printable word)) in
  let tokens () = match next_line f with
    | None -> []
    | Some line ->
      let is_hidden c = c = '\\' || (c < ' ' && c <> '\t') || c = '\127' in
      if String.exists is_hidden line then bad f "--frames reads no backslash and no control character";
      List.filter ((<>) "") (String.split_on_char ' ' (String.map (fun c -> if c = '\t' then ' ' else c) line)) in
  let rec read count positions triangles lines points =
    let vertices = List.map (vertex count) in
    match tokens () with
    | "v" :: x :: y :: z :: _ ->
      let x = double f x in
      let y = double f y in
      read (count + 1) (double f z :: y :: x :: positions) triangles lines points
    | "f" :: (_ :: _ :: _ :: _ as words) ->
      let face = vertices words in
      read count positions (List.rev_append (fan (List.hd face) (List.tl face)) triangles) lines points
    | "l" :: (_ :: _ :: _ as words) ->
      read count positions triangles (List.rev_append (sides (vertices words)) lines) points
    | "p" :: words -> read count positions triangles lines (List.rev_append (vertices words) points)
    | ("vt" | "vn" | "o" | "g" | "s" | "usemtl" | "mtllib") :: _ -> read count positions triangles lines points
    | [] -> { positions = Array.of_list (List.rev positions); triangles = List.rev triangles; lines; points }
    | ("v" | "f" | "l") :: _ -> bad f "a vertex has three coordinates, a face three vertices and a line two, or more"
    | word :: _ -> bad f (Printf.sprintf "--frames reads no lines \"%s\"" (printable word)) in
  let mesh = read 0 [] [] [] [] in
  close_in f.channel;
  mesh

(* A binary PLY file, of either order of bytes, with the elements vertex, face and edge. *)
type number = { size : int; is_float : bool; is_signed : bool }
type property = { called : string; number : number; length : number option }  (* of a list *)
let read_ply name =
  let bad reason = raise (Bad (name ^ ": " ^ reason)) in
  let text =
    try
      let channel = open_in_bin name in
      Fun.protect ~finally:(fun () -> close_in channel) (fun () ->
        really_input_string channel (in_channel_length channel))
    with Sys_error reason -> bad ("it cannot be read: " ^ reason) in
  let at = ref 0 and is_big = ref false and has_format = ref false in
  let line () =
    let last = match String.index_from_opt text !at '\n' with Some i -> i | None -> String.length text in
    if !at >= String.length text || last - !at > 1000 then
      bad "the header has no end within 1,000 lines of 1,000 bytes";
    let s = String.sub text !at (last - !at) in
    at := min (last + 1) (String.length text);
    let n = String.length s in
    if n > 0 && s.[n - 1] = '\r' then String.sub s 0 (n - 1) else s in
  let number_of = function
    | "char" | "int8" -> { size = 1; is_float = false; is_signed = true }
    | "uchar" | "uint8" -> { size = 1; is_float = false; is_signed = false }
    | "short" | "int16" -> { size = 2; is_float = false; is_signed = true }
    | "ushort" | "uint16" -> { size = 2; is_float = false; is_signed = false }
    | "int" | "int32" -> { size = 4; is_float = false; is_signed = true }
    | "uint" | "uint32" -> { size = 4; is_float = false; is_signed = false }
    | "float" | "float32" -> { size = 4; is_float = true; is_signed = true }
    | "double" | "float64" -> { size = 8; is_float = true; is_signed = true }
    | word -> bad (Printf.sprintf "\"%s\" is no type of a property" (printable word)) in
  let rec header number elements =
    let text = line () in
    if number >= 1000 then bad "the header has too many lines";
    let is_blank c = c = ' ' || ('\t' <= c && c <= '\r') in
    let words = String.split_on_char ' ' (String.map (fun c -> if is_blank c then ' ' else c) text) in
    match List.filter ((<>) "") words, elements with
    | _ when number = 0 && text <> "ply" -> bad "the first line must be \"ply\""
    | _ when number = 0 -> header 1 elements
    | [], _ | ("comment" | "obj_info") :: _, _ -> header (number + 1) elements
    | "end_header" :: _, _ -> List.rev_map (fun (name, count, reversed) -> (name, count, List.rev reversed)) elements
    | ["format"; ("binary_little_endian" | "binary_big_endian" as order); _], _ ->
      is_big := order = "binary_big_endian";
      has_format := true;
      header (number + 1) elements
    | "format" :: _, _ -> bad "--frames reads binary PLY alone, and OBJ"
    | ["element"; name; count], _ ->
      (match integer count with
       | Some n when Z.sign n >= 0 && Z.leq n (Z.of_int most) && Z.to_string n = count ->
         header (number + 1) ((name, Z.to_int n, []) :: elements)
       | _ -> bad "an element has a number")
    | ["property"; "list"; length; number_word; called], (name, count, properties) :: rest ->
      let property = { called; number = number_of number_word; length = Some (number_of length) } in
      if (number_of length).is_float then bad "the size of a list is a whole number";
      header (number + 1) ((name, count, property :: properties) :: rest)
    | ["property"; number_word; called], (name, count, properties) :: rest ->
      let property = { called; number = number_of number_word; length = None } in
      header (number + 1) ((name, count, property :: properties) :: rest)
    | _ -> bad (Printf.sprintf "\"%s\" is no line of a header" (printable text)) in
  let elements = header 0 [] in
  (* Another reader must see no other elements: each property has its place, once, and is read. *)
  let names = List.map (fun (name, _, _) -> name) elements in
  let is_once l = List.length (List.sort_uniq compare l) = List.length l in
  if not (is_once names) then bad "an element is there twice";
  if not !has_format then bad "the header has no format";
  let check (name, count, properties) =
    let among holds = List.length (List.filter holds properties) in
    let is_end called p = p.called = called && not p.number.is_float in
    let is_list_of_vertices p =
      p.length <> None && not p.number.is_float && (p.called = "vertex_index" || p.called = "vertex_indices") in
    if not (List.mem name ["vertex"; "face"; "edge"]) then
      bad (Printf.sprintf "--frames reads no element \"%s\"" (printable name));
    if properties = [] && count > 0 then bad "an element has no property";
    if among (fun p -> p.length <> None) <> (if name = "face" then 1 else 0) then
      bad "faces have one list, of their vertices, and nothing else has one";
    if name = "face" && among is_list_of_vertices <> 1 then bad "faces have a list vertex_index or vertex_indices";
    if not (is_once (List.map (fun p -> p.called) properties)) then bad "a property is there twice";
    if name = "edge" && (among (is_end "vertex1") <> 1 || among (is_end "vertex2") <> 1) then
      bad "edges have vertex1 and vertex2" in
  List.iter check elements;
  let taken size = let first = !at in
    if size > String.length text - first then bad "the file is cut off";
    at := first + size;
    first in
  let index { size; is_signed; _ } =  (* of a vertex; one that is none becomes too great *)
    let i = taken size in
    let byte k = Char.code text.[i + if !is_big then k else size - 1 - k] in
    let bits = List.fold_left (fun bits k -> bits lsl 8 lor byte k) 0 (List.init size Fun.id) in
    if is_signed && bits lsr (8 * size - 1) <> 0 then most else min bits most in
  let coordinate { size; _ } =
    let i = taken size in
    let x =
      if size = 4 then Int32.float_of_bits ((if !is_big then String.get_int32_be else String.get_int32_le) text i)
      else Int64.float_of_bits ((if !is_big then String.get_int64_be else String.get_int64_le) text i) in
    if Float.is_nan x || Float.abs x = infinity then bad "a coordinate is not finite";
    let (m, e) = Float.frexp x in
    (Z.of_float (Float.ldexp m 53), e - 53) in
  let positions = ref [] and triangles = ref [] and lines = ref [] in
  let read_face p = match p.length with
    | None -> ignore (taken p.number.size)
    | Some length ->
      let n = index length in
      if n < 3 || n >= most then bad "a face has three vertices, or more";
      let first = index p.number in
      let rec read k v =
        if k < n then begin
          let w = index p.number in
          triangles := [first; v; w] :: !triangles;
          read (k + 1) w
        end in
      read 2 (index p.number) in
  let read_some called read properties =  (* those of these names, in the order of the names *)
    let found = List.filter_map (fun p ->
      if List.mem p.called called then Some (p.called, read p.number) else (ignore (taken p.number.size); None))
      properties in
    List.filter_map (fun name -> List.assoc_opt name found) called in
  let read_item name properties = match name with
    | "face" -> List.iter read_face properties
    | "edge" -> lines := read_some ["vertex1"; "vertex2"] index properties :: !lines
    | _ ->
      let coordinate number = if number.is_float then coordinate number else bad "coordinates are floats or doubles" in
      (match read_some ["x"; "y"; "z"] coordinate properties with
       | [x; y; z] -> positions := z :: y :: x :: !positions
       | _ -> bad "vertices need x, y and z") in
  List.iter (fun (name, count, properties) -> for _ = 1 to count do read_item name properties done) elements;
  if !at < String.length text then bad "there are bytes after the last element";
  let positions = Array.of_list (List.rev !positions) in
  let check v = if v >= Array.length positions / 3 then bad "an element names a vertex that is not there" in
  List.iter (List.iter check) !triangles;
  List.iter (List.iter check) !lines;
  { positions; triangles = List.rev !triangles; lines = !lines; points = [] }

let read_mesh name =
  if Filename.check_suffix name ".obj" then read_obj name
  else if Filename.check_suffix name ".ply" then read_ply name
  else raise (Bad (name ^ ": --frames reads .obj and binary .ply"))

(* The files of a part of the mesh, and the one that was read last. *)
type part = { files : string array; mutable name : string; mutable file : mesh_file }
let part pattern =
  { files = Array.of_list (files_of pattern); name = "";
    file = { positions = [||]; triangles = []; lines = []; points = [] } }

let is_at_rest parts p = Array.length p.files = 1 && List.length parts > 1
(* @returns a function of a frame and its number: it raises Rejected unless that is the files of the parts, bit by bit,
   and the elements are their triangles, lines and points, with the sides and corners of these; other vertices may be
   points, too *)
let comparison parts m =
  let require holds reason = if not holds then raise (Rejected (reason ())) in
  let sorted e = List.sort compare (List.map Z.to_int e.vertices) in
  let table elements =
    let table = Hashtbl.create 64 in
    List.iter (fun e -> Hashtbl.replace table (sorted e) ()) elements;
    table in
  let points = table m.mesh.points and edges = table m.mesh.edges and faces = table m.mesh.faces in
  let compare_part (frame : frame) number of_files first p =
    require (number < Array.length p.files || is_at_rest parts p) (fun () ->
      "the motion has more frames than --frames names files");
    let name = p.files.(if is_at_rest parts p then 0 else number) in
    if p.name <> name then begin
      let file = read_mesh name in
      let count = Array.length file.positions in
      require (p.name = "" || count = Array.length p.file.positions) (fun () ->
        Printf.sprintf "%s: %s, and %s has another number" name (counted (count / 3) "vertex" "vertices") p.name);
      p.file <- file
    end;
    p.name <- name;
    let what reason () = Printf.sprintf "%s and frame %d: %s" name number reason in
    let { positions; triangles; lines; points = some } = p.file in
    let count = Array.length positions / 3 in
    require (first + count <= m.size) (what (Printf.sprintf "%d vertices, and %d" count (m.size - first)));
    Array.iteri (fun i x ->
      require (compared x frame.rows.(first + i / 3).(i mod 3) = 0) (fun () ->
        what (Printf.sprintf "the coordinates of vertex %d, counted from 0, differ" (i / 3)) ())) positions;
    let is_in table vertices =
      let key = List.sort compare (List.map ((+) first) vertices) in
      Hashtbl.replace of_files key ();
      Hashtbl.mem table key in
    List.iteri (fun i face -> require (is_in faces face) (fun () ->
      what (Printf.sprintf "face %d of the file, counted from 0, is none of the motion" i) ());
      List.iter (fun side -> ignore (is_in edges side)) (sides (face @ [List.hd face]))) triangles;
    List.iter (fun line -> require (is_in edges line) (what "a line of the file is no edge of the motion")) lines;
    let some = if triangles = [] && lines = [] && some = [] then List.init count Fun.id else some in
    List.iter (fun v -> require (is_in points [v]) (what "a point of the file is none of the motion")) some;
    first + count in
  fun frame number -> if parts <> [] then begin
    require (m.bodies = 0) (fun () -> "a motion with bodies has poses; --frames compares vertices");
    let of_files = Hashtbl.create 64 in
    let count = List.fold_left (compare_part frame number of_files) 0 parts in
    require (count = m.size) (fun () ->
      Printf.sprintf "the files and frame %d: %d vertices, and %d" number count m.size);
    let (corners, sides) = undeclared m in
    require (corners = 0) (fun () -> "the files: " ^ counted corners "corner is no point" "corners are no points");
    require (sides = 0) (fun () -> "the files: " ^ counted sides "side is no edge" "sides are no edges");
    (* Another edge would take its ends out of the loose points, and another face its sides out of the wires. *)
    let are_known what = List.iter (fun e -> require (Hashtbl.mem of_files (sorted e)) (fun () ->
      Printf.sprintf "the files and frame %d: %s %s of the motion is none of theirs" number what
        (Z.to_string e.index))) in
    are_known "face" m.mesh.faces;
    are_known "edge" m.mesh.edges
  end
let check_count parts frames =
  if List.exists (fun p -> Array.length p.files > frames) parts then
    raise (Rejected "--frames names more files than the motion has frames")
let summary parts =
  let describe (first, texts) p =
    let count = Array.length p.files and size = Array.length p.file.positions / 3 in
    let last = if count > 1 then " to " ^ printable p.files.(count - 1) else "" in
    let rest = if is_at_rest parts p then " at rest" else "" in
    let which = if size = 0 then "no vertex" else vertices first (first + size - 1) in
    (first + size, Printf.sprintf "%s%s%s (%s)" (printable p.files.(0)) last rest which :: texts) in
  let count = List.fold_left (fun n p -> n + Array.length p.files) 0 parts in
  let texts = List.rev (snd (List.fold_left describe (0, []) parts)) in
  if parts = [] then ""
  else ", whose frames are those of the " ^ counted count "file" "files" ^ ": " ^ String.concat ", " texts
