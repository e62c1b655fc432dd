(* The SHA-256 digest of a file, as FIPS 180-4 defines it.
   SPDX-License-Identifier: MIT *)
let word = 0xFFFFFFFF
(* The first 32 bits of the fractions of the square roots (k = 2) or the cube roots (k = 3) of the first n primes. *)
let fractions k n =
  let is_prime p = List.for_all (fun d -> p mod d <> 0) (List.init (p - 2) (fun d -> d + 2)) in
  let primes = List.filter is_prime (List.init 310 (fun p -> p + 2)) in
  let root p = Z.root (Z.shift_left (Z.of_int p) (32 * k)) k in
  Array.init n (fun i -> Z.to_int (Z.logand (root (List.nth primes i)) (Z.of_int word)))
let constants = fractions 3 64

type t = { state : int array; block : Bytes.t; w : int array; mutable bytes : int }
let start () = { state = fractions 2 8; block = Bytes.create 64; w = Array.make 64 0; bytes = 0 }

let turned x n = (x lsr n) lor (x lsl (32 - n)) land word
let add_block t =
  let w = t.w and s = Array.copy t.state in
  for i = 0 to 15 do w.(i) <- Int32.to_int (Bytes.get_int32_be t.block (4 * i)) land word done;
  for i = 16 to 63 do
    let a = w.(i - 15) and b = w.(i - 2) in
    let c = turned a 7 lxor turned a 18 lxor (a lsr 3) and d = turned b 17 lxor turned b 19 lxor (b lsr 10) in
    w.(i) <- (w.(i - 16) + c + w.(i - 7) + d) land word
  done;
  for i = 0 to 63 do
    let a = s.(0) and b = s.(1) and c = s.(2) and e = s.(4) and f = s.(5) and g = s.(6) in
    let choice = (e land f) lxor (lnot e land g) and majority = (a land b) lxor (a land c) lxor (b land c) in
    let one = s.(7) + (turned e 6 lxor turned e 11 lxor turned e 25) + choice + constants.(i) + w.(i) in
    let two = (turned a 2 lxor turned a 13 lxor turned a 22) + majority in
    Array.blit s 0 s 1 7;
    s.(4) <- (s.(4) + one) land word;
    s.(0) <- (one + two) land word
  done;
  Array.iteri (fun i x -> t.state.(i) <- (t.state.(i) + x) land word) s
let rec add t text first =  (* the bytes of the text from `first` on *)
  let filled = t.bytes land 63 in
  let n = min (String.length text - first) (64 - filled) in
  if n > 0 then begin
    Bytes.blit_string text first t.block filled n;
    t.bytes <- t.bytes + n;
    if filled + n = 64 then add_block t;
    add t text (first + n)
  end
let hexadecimal t =  (* of all bytes so far; nothing may be added then *)
  let length = Bytes.create 8 in
  Bytes.set_int64_be length 0 (Int64.of_int (8 * t.bytes));
  add t ("\x80" ^ String.make ((119 - t.bytes land 63) land 63) '\000' ^ Bytes.to_string length) 0;
  String.concat "" (List.map (Printf.sprintf "%08x") (Array.to_list t.state))
