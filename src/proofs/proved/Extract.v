(* The checker as OCaml over the integers of Zarith. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
From Touchstone Require Import Positions Checker Motions.
Extraction "proved.ml" check turns near_pairs check_step.
