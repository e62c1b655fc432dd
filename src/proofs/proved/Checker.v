(* The checker of a proof of one query, and the theorem. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Geometry Corners Positions Pieces Meeting Times.
Import ListNotations.
Open Scope R_scope.

(* What a proof says besides its answer. Whatever it is, an accepted answer holds. *)
Record proof := Proof {
  coordinate_unit : Z; turn_unit : Z;   (* common denominators of coordinates, and of quaternions *)
  pieces : list (direction * Q);        (* those with an end of their own, *)
  last_piece : direction;               (* and the last one *)
  mantissa : Z; places : Z;             (* T = mantissa / 2^places *)
  root : poly; lower : Q; upper : Q;    (* g, LOW and HIGH *)
  weights : list poly * list poly       (* of the corners of both elements *)
}.

(* The pieces cover the times from `start` to `finish`, or those before it if it is open. *)
Fixpoint cover (s : separation) (A B : list moving) (is_open : bool) (start : Q) (pieces : list (direction * Q))
    (last : direction) (finish : Q) : bool :=
  match pieces with
  | [] =>
      let i := span_of start finish in
      (Z.ltb (low i) (high i) || Z.eqb (low i) 0) && piece s i is_open A B last
  | (along, next) :: pieces' =>
      let i := span_of start next in
      Z.ltb (low i) (high i) && piece s i false A B along && cover s A B is_open next pieces' last finish
  end.
Lemma cover_sound q A B is_open last finish : not_negative (apart q) -> Forall2 moves_as A (first q) ->
  Forall2 moves_as B (second q) -> Q2R finish <= 1 -> forall pieces start, 0 <= Q2R start ->
  cover (apart q) A B is_open start pieces last finish = true ->
  forall t, Q2R start <= t <= Q2R finish -> (is_open = true -> t < Q2R finish) -> ~ in_contact q t.
Proof.
  intros P FA FB F. induction pieces0 as [|(along, next) pieces' IH]; simpl; intros start S H t T O.
  - apply andb_true_iff in H as [_ H]. destruct (span_of_correct start finish) as (U & E1 & E2).
    apply (piece_sound q (span_of start finish) is_open A B last t); auto; [|split|lra].
    + rewrite <- E1. apply Rmult_le_pos; lra.
    + now apply within_span.
    + intros X. rewrite <- E2. apply Rmult_lt_compat_r; auto.
  - rewrite !andb_true_iff in H. destruct H as [[L H] K]. apply span_not_empty in L.
    destruct (span_of_correct start next) as (U & E1 & E2).
    destruct (Rle_lt_dec t (Q2R next)) as [C|C]; [|apply (IH next); auto; lra].
    apply (piece_sound q (span_of start next) false A B along t); auto; [|split|lra].
    + rewrite <- E1. apply Rmult_le_pos; lra.
    + apply within_span. lra.
    + discriminate.
Qed.

Definition is_valid (s : separation) : bool := match s with Zero => true | Euclidean D | Max D => Z.leb 0 (Qnum D) end.
Lemma is_valid_sound s : is_valid s = true -> not_negative s.
Proof.
  destruct s; simpl; [auto | |]; intros H; apply Z.leb_le, IZR_le in H; destruct (denominator_positive D) as [P E];
    apply Rmult_le_reg_r with (IZR (Zpos (Qden D))); lra.
Qed.

Definition check (q : query) (a : answer) (p : proof) : bool :=
  let u := coordinate_unit p in let h := turn_unit p in
  let A := map (moving_of u h) (first q) in
  let B := map (moving_of u h) (second q) in
  let s := apart q in
  let (ws, us) := weights p in
  forallb (corner_fits u h) (first q) && forallb (corner_fits u h) (second q) && is_valid s
  && match a with
     | No_contact => cover s A B false 0 (pieces p) (last_piece p) 1
     | Contact_at T =>
         double T (mantissa p) (places p) && at_most T 1
         && (if Z.eqb (Qnum T) 0 then true else cover s A B true 0 (pieces p) (last_piece p) T)
         && meeting s (span_of T T) [(- Qnum T)%Z; Zpos (Qden T)] A B ws us
     | Contact_between T U =>
         let i := span_of (lower p) (upper p) in
         next_double T U (mantissa p) (places p) && at_most U 1
         && at_most T (lower p) && Z.ltb (low i) (high i) && at_most (upper p) U
         && cover s A B false 0 (pieces p) (last_piece p) T
         && changes_sign (root p) i && meeting s i (root p) A B ws us
     end.

Lemma all_move u h corners :
  forallb (corner_fits u h) corners = true -> Forall2 moves_as (map (moving_of u h) corners) corners.
Proof.
  induction corners as [|c corners IH]; simpl; [constructor|]. rewrite andb_true_iff; intros [H H'].
  constructor; [now apply moving_of_moves | auto].
Qed.

Theorem check_sound : forall q a p, check q a p = true -> holds q a.
Proof.
  intros q a p H. unfold check in H. destruct (weights p) as [ws us]. cbv zeta in H.
  rewrite !andb_true_iff in H. destruct H as [[[FA FB] P] H].
  apply all_move in FA, FB. apply is_valid_sound in P.
  set (A := map (moving_of (coordinate_unit p) (turn_unit p)) (first q)) in *.
  set (B := map (moving_of (coordinate_unit p) (turn_unit p)) (second q)) in *.
  assert (Z0 : Q2R 0 = 0) by (unfold Q2R; simpl; lra). assert (Z1 : Q2R 1 = 1) by (unfold Q2R; simpl; lra).
  destruct a as [|T|T U]; simpl.
  - intros t I. apply (cover_sound q A B false (last_piece p) 1 P FA FB ltac:(lra) (pieces p) 0); auto;
      rewrite ?Z0, ?Z1; [lra | lra | discriminate].
  - rewrite !andb_true_iff in H. destruct H as [[[D L] C] M].
    destruct (double_sound _ _ _ D) as (E & DT & Hm & Hk). apply at_most_sound in L. rewrite Z1 in L.
    assert (0 <= Q2R T).
    { rewrite E. apply Rmult_le_pos; [apply IZR_le; lia | left; apply Rinv_0_lt_compat, power_positive]. }
    split; [auto|]. split; [lra|]. split.
    + destruct (span_of_correct T T) as (U & _ & _).
      apply (meeting_sound (span_of T T) [(- Qnum T)%Z; Zpos (Qden T)] (Q2R T) U)
        with (A := A) (B := B) (ws := ws) (us := us); auto; [apply within_span; lra |].
      destruct (denominator_positive T) as [Pd En]. simpl. rewrite opp_IZR, En. ring.
    + intros t I. apply orb_true_iff in C as [C|C].
      * apply Z.eqb_eq in C. unfold Q2R in I. rewrite C in I. lra.
      * apply (cover_sound q A B true (last_piece p) T P FA FB L (pieces p) 0); auto; rewrite ?Z0; lra.
  - rewrite !andb_true_iff in H. destruct H as [[[[[[[N L] TL] LH] HU] C] G] M].
    destruct (next_double_sound _ _ _ _ N) as (DT & DU & R & NB).
    apply at_most_sound in L, TL, HU. rewrite Z1 in L. apply span_not_empty in LH.
    split; [auto|]. split; [auto|]. split; [auto|]. split; [lra|]. split; [lra|]. split.
    + intros t I.
      apply (cover_sound q A B false (last_piece p) T P FA FB ltac:(lra) (pieces p) 0); auto;
        rewrite ?Z0; [lra | lra | discriminate].
    + destruct (span_of_correct (lower p) (upper p)) as (Uu & E1 & E2).
      destruct (changes_sign_sound (root p) _ _ _ Uu E1 E2 LH G) as (t & I & Z).
      exists t. split; [lra|].
      apply (meeting_sound (span_of (lower p) (upper p)) (root p) t Uu) with (A := A) (B := B) (ws := ws) (us := us);
        auto; [apply within_span; lra | lra].
Qed.
