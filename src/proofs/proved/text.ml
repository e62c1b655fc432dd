(* Lines, words and numbers of queries and proofs. What is read here has to be right: see docs/proved.md.
   SPDX-License-Identifier: MIT *)
module Integers = Z
open Proved
module Z = Integers  (* not the names that the extraction gives to the operations *)

exception Rejected of string  (* exit status 1 *)
exception Bad of string  (* exit status 2 *)

(* A text that only shows: bytes that are no printable character of ASCII appear as \x1b. *)
let printable text =
  let shown c = if c >= ' ' && c <= '~' then String.make 1 c else Printf.sprintf "\\x%02x" (Char.code c) in
  String.concat "" (List.map shown (List.of_seq (String.to_seq text)))
let split n l = (List.filteri (fun i _ -> i < n) l, List.filteri (fun i _ -> i >= n) l)

(* Lines of at most 2^20 bytes that are neither blank nor comments. *)
type lines = { name : string; channel : in_channel; line : Buffer.t; sha : Sha256.t; mutable number : int;
               mutable has_end : bool }
let opened name =
  let channel = try open_in_bin name with Sys_error reason -> raise (Bad (reason ^ ": it cannot be read")) in
  { name; channel; line = Buffer.create 4096; sha = Sha256.start (); number = 0; has_end = true }
let bad f reason = raise (Bad (Printf.sprintf "%s:%d: %s" f.name f.number reason))
let reject f reason = raise (Rejected (Printf.sprintf "%s:%d: %s" f.name f.number reason))
let longest = 1 lsl 20
let rec read_bytes f = match input_char f.channel with  (* up to a line feed; false at the end of the file *)
  | '\n' -> true
  | c ->
    if Buffer.length f.line > longest then bad f "the line is too long: at most 2^20 bytes are read";
    Buffer.add_char f.line c;
    read_bytes f
  | exception Sys_error reason -> bad f ("the file cannot be read to its end: " ^ reason)
  | exception End_of_file -> f.has_end <- false; Buffer.length f.line > 0
let rec next_line f =  (* None at the end of the file *)
  Buffer.clear f.line;
  f.number <- f.number + 1;
  if not (read_bytes f) then None else begin
    let s = Buffer.contents f.line in
    Sha256.add f.sha s 0;
    if f.has_end then Sha256.add f.sha "\n" 0;
    let n = String.length s in
    let n = if n > 0 && s.[n - 1] = '\r' then n - 1 else n in
    if n > longest then bad f "the line is too long: at most 2^20 bytes are read";
    let first = if f.number = 1 && n >= 3 && String.sub s 0 3 = "\xEF\xBB\xBF" then 3 else 0 in
    let rec start i = if i < n && (s.[i] = ' ' || s.[i] = '\t') then start (i + 1) else i in
    let i = start first in
    if i = n || s.[i] = '#' then next_line f else Some (String.sub s first (n - first))
  end
let rec digest f =  (* of the whole file *)
  if next_line f = None then Sha256.hexadecimal f.sha else digest f
let words f = match next_line f with
  | None -> []
  | Some line -> List.filter (fun word -> word <> "") (String.split_on_char ' ' line)
let columns f = match next_line f with
  | None -> []
  | Some line when String.exists (fun c -> c < ' ' && c <> '\t') line -> bad f "the line has a control character"
  | Some line ->
    let all = String.split_on_char ',' line in
    if List.compare_length_with all 16 > 0 then bad f "a row has at most 16 columns";
    List.map String.trim all

let is_digit c = c >= '0' && c <= '9'
let is_hex c = is_digit c || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')
let integer s =  (* of at most 4,096 decimal digits, after an optional minus *)
  let n = String.length s in
  let first = if n > 0 && s.[0] = '-' then 1 else 0 in
  let rec small i x =
    if i = n then Some x else if is_digit s.[i] then small (i + 1) (10 * x + Char.code s.[i] - 48) else None in
  if n = first || n > first + 4096 then None
  else if n - first <= 18 then Option.map (fun x -> Z.of_int (if first = 1 then - x else x)) (small first 0)
  else if String.for_all is_digit (String.sub s first (n - first)) then Some (Z.of_string s) else None
let count f most word =  (* a decimal integer without a sign or leading zeros *)
  match integer word with
  | Some x when Z.sign x >= 0 && Z.leq x (Z.of_int most) && Z.to_string x = word -> Z.to_int x
  | _ -> bad f (Printf.sprintf "here must be an integer from 0 to %d" most)
(* Digits with at most one point, and a power behind one of the marks: "1.8p-3" is m = 0x18 and e = -3 - 4. *)
let digits base marks most s =
  let earlier i c = min i (Option.value (String.index_opt s c) ~default:i) in
  let mark = List.fold_left earlier (String.length s) marks in
  let after = match String.index_opt s '.' with Some i when i < mark -> mark - i - 1 | _ -> 0 in
  let all = String.concat "" (String.split_on_char '.' (String.sub s 0 mark)) in
  let n = String.length all in
  let rest = String.sub s mark (String.length s - mark) in
  let signed = String.length rest > 2 && rest.[1] = '+' && is_digit rest.[2] in
  let first = if signed then 2 else 1 in
  let power = if rest = "" then Some Z.zero else integer (String.sub rest first (String.length rest - first)) in
  match power with
  | Some power when Z.leq (Z.abs power) (Z.of_int 20000) && n > 0 && n <= most && mark - n <= 1
                    && String.for_all (if base = 16 then is_hex else is_digit) all ->
    let m = Z.of_string_base base all in
    Some (m, if Z.sign m = 0 then 0 else Z.to_int power - after * if base = 16 then 4 else 1)
  | _ -> None
let without_sign s = if s <> "" && s.[0] = '-' then (true, String.sub s 1 (String.length s - 1)) else (false, s)
let with_sign negative (m, e) = ((if negative then Z.neg m else m), e)
let has_prefix s prefix = String.length s >= 2 && String.sub s 0 2 = prefix
let after_prefix s = String.sub s 2 (String.length s - 2)
let number f word =  (* of a proof, as m 2^e *)
  let (negative, s) = without_sign word in
  let read =
    if not (has_prefix s "0x") then Option.map (fun m -> (m, 0)) (integer s)
    else if String.contains s 'p' then digits 16 ['p'] 16384 (after_prefix s) else None in
  match read with
  | Some x -> with_sign negative x
  | None -> bad f "here must be a number within the limits: an integer or a hexfloat such as 0x1.8p-3"
let compared (m, e) (n, k) = Z.compare (Z.shift_left m (max (e - k) 0)) (Z.shift_left n (max (k - e) 0))
let sum (m, e) (n, k) = (Z.add (Z.shift_left m (max (e - k) 0)) (Z.shift_left n (max (k - e) 0)), min e k)
(* The least number m' 2^e' that is at least m 2^e, with |m'| <= 2^53 and e' >= -1074. *)
let rounded_up (m, e) =
  let least = max (Z.numbits m - 53 + e) (-1074) in
  if least <= e then (m, e) else (Z.cdiv m (Z.shift_left Z.one (least - e)), least)
let rational (m, e) =
  if e >= 0 then { qnum = Z.shift_left m e; qden = Z.one } else { qnum = m; qden = Z.shift_left Z.one (- e) }
let time f word =
  let (m, e) = number f word in
  let zeros = if Z.sign m = 0 then 0 else Z.trailing_zeros m in
  if e + zeros < -20000 then bad f "a time must be a multiple of 2^-20,000";
  rational (Z.shift_right m zeros, e + zeros)
(* The double that is nearest to m / d, as m' 2^e; of two, the one with an even m'. *)
let rec nearest m d e =
  let below = Z.shift_left d (max e 0) in
  let (quotient, rest) = Z.ediv_rem (Z.shift_left m (max (- e) 0)) below in
  let half = Z.compare (Z.shift_left rest 1) below in
  if Z.numbits quotient > 53 then nearest m d (e + 1)
  else ((if half > 0 || (half = 0 && Z.is_odd quotient) then Z.succ quotient else quotient), e)
let double f word =  (* of a row of curved motion, or of a mesh file, as m 2^e *)
  let (negative, s) = without_sign word in
  let is_hex = has_prefix s "0x" || has_prefix s "0X" in
  let read = if is_hex then digits 16 ['p'; 'P'] 4096 (after_prefix s) else digits 10 ['e'; 'E'] 4096 s in
  let rounded (m, e) =
    let unit = if is_hex then Z.shift_left Z.one (abs e) else Z.pow (Z.of_int 10) (abs e) in
    let (m, d) = if e > 0 then (Z.mul m unit, Z.one) else (m, unit) in
    if Z.sign m = 0 then Some (m, 0) else
      let (m, e) = nearest m d (max (Z.numbits m - Z.numbits d - 53) (-1074)) in
      if Z.sign m = 0 || Z.numbits m + e > 1024 then None else Some (m, e) in
  match Option.bind read rounded with
  | Some x -> with_sign negative x
  | None -> bad f "here must be a finite double, such as 0.25 or 0x1p-2"
