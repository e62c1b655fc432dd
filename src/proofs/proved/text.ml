(* Lines, words and numbers of queries and proofs. What is read here has to be right: see docs/proved.md.
   SPDX-License-Identifier: MIT *)
module Integers = Z
open Proved
module Z = Integers  (* not the names that the extraction gives to the operations *)

exception Rejected of string  (* exit status 1 *)
exception Bad of string  (* exit status 2 *)

(* Lines of at most 2^20 bytes that are neither blank nor comments. *)
type lines = { name : string; channel : in_channel; chunk : Bytes.t; mutable next : int; mutable size : int;
               line : Buffer.t; mutable number : int; mutable has_end : bool }
let bad f reason = raise (Bad (Printf.sprintf "%s:%d: %s" f.name f.number reason))
let reject f reason = raise (Rejected (Printf.sprintf "%s:%d: %s" f.name f.number reason))
(* A text that only shows: bytes that are no printable character of ASCII appear as \x1b. *)
let printable text =
  let shown c = if c >= ' ' && c <= '~' then String.make 1 c else Printf.sprintf "\\x%02x" (Char.code c) in
  String.concat "" (List.map shown (List.of_seq (String.to_seq text)))
let split n l = (List.filteri (fun i _ -> i < n) l, List.filteri (fun i _ -> i >= n) l)
let opened name =
  let channel = try open_in_bin name with Sys_error reason -> raise (Bad (reason ^ ": it cannot be read")) in
  let chunk = Bytes.create 65536 and line = Buffer.create 4096 in
  { name; channel; chunk; next = 0; size = 0; line; number = 0; has_end = true }
let rec read_bytes f =  (* up to a line feed; false at the end of the file *)
  if f.next = f.size then begin
    f.next <- 0;
    f.size <- (try input f.channel f.chunk 0 (Bytes.length f.chunk) with Sys_error reason -> raise (Bad reason))
  end;
  if f.size = 0 then (f.has_end <- false; Buffer.length f.line > 0) else begin
    let stop = try Bytes.index_from f.chunk f.next '\n' with Not_found -> f.size in
    let stop = min stop f.size in
    Buffer.add_subbytes f.line f.chunk f.next (stop - f.next);
    f.next <- min (stop + 1) f.size;
    if Buffer.length f.line > 1048577 then bad f "the line is too long: at most 2^20 bytes are read"
    else if stop < f.size then (f.has_end <- true; true) else read_bytes f
  end
let is_blank c = c = ' ' || c = '\t'
let rec next_line f =  (* None at the end *)
  Buffer.clear f.line;
  f.number <- f.number + 1;
  if not (read_bytes f) then None else begin
    let s = Buffer.contents f.line in
    let n = String.length s in
    let n = if n > 0 && s.[n - 1] = '\r' then n - 1 else n in
    if n > 1048576 then bad f "the line is too long: at most 2^20 bytes are read";
    let first = if f.number = 1 && n >= 3 && String.sub s 0 3 = "\xEF\xBB\xBF" then 3 else 0 in
    let rec start i = if i < n && is_blank s.[i] then start (i + 1) else i in
    let i = start first in
    if i = n || s.[i] = '#' then next_line f else Some (String.sub s first (n - first))
  end
let words f = match next_line f with
  | None -> []
  | Some line -> List.filter (fun word -> word <> "") (String.split_on_char ' ' line)
let trimmed s =
  let rec from i = if i < String.length s && is_blank s.[i] then from (i + 1) else i in
  let rec till i first = if i > first && is_blank s.[i - 1] then till (i - 1) first else i in
  let first = from 0 in
  let stop = till (String.length s) first in
  if stop - first = String.length s then s else String.sub s first (stop - first)
let columns f = match next_line f with None -> [] | Some line -> List.map trimmed (String.split_on_char ',' line)

let is_digit c = c >= '0' && c <= '9'
let integer s =  (* of at most 4,096 decimal digits, after an optional minus *)
  let n = String.length s in
  let first = if n > 0 && s.[0] = '-' then 1 else 0 in
  let rec small i x = if i = n then Some x else
    if is_digit s.[i] then small (i + 1) (10 * x + Char.code s.[i] - 48) else None in
  if n = first || n > first + 4096 then None
  else if n - first <= 18 then Option.map (fun x -> Z.of_int (if first = 1 then - x else x)) (small first 0)
  else if String.for_all is_digit (String.sub s first (n - first)) then Some (Z.of_string s) else None
let hexadecimal s =  (* "1.8p-3", as m 2^e *)
  match String.index_opt s 'p' with
  | None -> None
  | Some mark ->
    let digits = String.concat "" (String.split_on_char '.' (String.sub s 0 mark)) in
    let n = String.length digits in
    let after = match String.index_opt s '.' with Some i when i < mark -> mark - i - 1 | _ -> 0 in
    let power = String.sub s (mark + 1) (String.length s - mark - 1) in
    let signed = String.length power > 1 && power.[0] = '+' && is_digit power.[1] in
    let power = integer (if signed then String.sub power 1 (String.length power - 1) else power) in
    let is_hex c = is_digit c || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F') in
    let good = n > 0 && n <= 16384 && mark - n <= 1 && String.for_all is_hex digits in
    (match power with
     | Some power when good && Z.leq (Z.abs power) (Z.of_int 20000) ->
       let m = Z.of_string_base 16 digits in
       Some (m, if Z.sign m = 0 then 0 else Z.to_int power - 4 * after)
     | _ -> None)
let number f word =
  let negative = word <> "" && word.[0] = '-' in
  let first = if negative then 1 else 0 in
  let n = String.length word in
  let read = if n >= first + 2 && word.[first] = '0' && word.[first + 1] = 'x' then
      let read = hexadecimal (String.sub word (first + 2) (n - first - 2)) in
      if negative then Option.map (fun (m, e) -> (Z.neg m, e)) read else read
    else Option.map (fun m -> (m, 0)) (integer word) in
  match read with Some x -> x | None -> bad f "here must be a number within the limits: an integer or a hexfloat"
let rational (m, e) =
  if e >= 0 then { qnum = Z.shift_left m e; qden = Z.one } else { qnum = m; qden = Z.shift_left Z.one (- e) }
let time f word =  (* m is odd, or 0 *)
  let (m, e) = number f word in
  let zeros = if Z.sign m = 0 then 0 else Z.trailing_zeros m in
  let e = e + zeros in
  if e < -20000 then bad f "a time must be a multiple of 2^-20,000";
  (Z.shift_right m zeros, e)
