(* Corners as integer polynomials, and their differences. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Geometry.
Import ListNotations.
Open Scope R_scope.

(* Vectors of polynomials. *)
Record vector := Vector { vx : poly; vy : poly; vz : poly }.
Definition value (v : vector) (t : R) : point := Point (ev (vx v) t) (ev (vy v) t) (ev (vz v) t).
Definition vadd a b := Vector (padd (vx a) (vx b)) (padd (vy a) (vy b)) (padd (vz a) (vz b)).
Definition vsub a b := Vector (psub (vx a) (vx b)) (psub (vy a) (vy b)) (psub (vz a) (vz b)).
Definition vscale p a := Vector (pmul p (vx a)) (pmul p (vy a)) (pmul p (vz a)).
Definition vdot a b := padd (padd (pmul (vx a) (vx b)) (pmul (vy a) (vy b))) (pmul (vz a) (vz b)).
Definition vcross a b := Vector
  (psub (pmul (vy a) (vz b)) (pmul (vz a) (vy b)))
  (psub (pmul (vz a) (vx b)) (pmul (vx a) (vz b)))
  (psub (pmul (vx a) (vy b)) (pmul (vy a) (vx b))).
Definition cross a b := Point (py a * pz b - pz a * py b) (pz a * px b - px a * pz b) (px a * py b - py a * px b).

Lemma value_add a b t : value (vadd a b) t = plus (value a t) (value b t).
Proof. apply point_eq; simpl; apply ev_add. Qed.
Lemma value_sub a b t : value (vsub a b) t = minus (value a t) (value b t).
Proof. apply point_eq; simpl; apply ev_sub. Qed.
Lemma value_scale p a t : value (vscale p a) t = scale (ev p t) (value a t).
Proof. apply point_eq; simpl; apply ev_mul. Qed.
Lemma ev_dot a b t : ev (vdot a b) t = dot (value a t) (value b t).
Proof. unfold vdot, dot; simpl. now rewrite !ev_add, !ev_mul. Qed.
Lemma value_cross a b t : value (vcross a b) t = cross (value a t) (value b t).
Proof. apply point_eq; simpl; now rewrite ev_sub, !ev_mul. Qed.

(* A corner is at numerator / weight. Corners of one motion have one weight. *)
Record moving := Moving { numerator : vector; weight : poly; motion : Z }.
Definition moves_as (m : moving) (c : corner) : Prop := forall t, 0 <= t <= 1 ->
  0 < ev (weight m) t /\ value (numerator m) t = scale (ev (weight m) t) (position c t).

(* b - a times factor, which is positive. *)
Definition together (a b : moving) : bool := Z.eqb (motion a) (motion b) && equal (weight a) (weight b).
Definition difference (b a : moving) : vector :=
  if together a b then vsub (numerator b) (numerator a)
  else vsub (vscale (weight a) (numerator b)) (vscale (weight b) (numerator a)).
Definition factor (b a : moving) : poly := if together a b then weight a else pmul (weight a) (weight b).
Lemma difference_value a b c d t : moves_as a c -> moves_as b d -> 0 <= t <= 1 ->
  0 < ev (factor b a) t
  /\ value (difference b a) t = scale (ev (factor b a) t) (minus (position d t) (position c t)).
Proof.
  intros A B T. destruct (A t T) as [PA EA], (B t T) as [PB EB]. unfold factor, difference.
  destruct (together a b) eqn:E.
  - apply andb_true_iff in E as [_ E]. apply equal_eq in E. split; [auto|].
    rewrite value_sub, EA, EB, <- E. apply point_eq; simpl; ring.
  - rewrite ev_mul, value_sub, !value_scale, EA, EB. split; [now apply Rmult_lt_0_compat|].
    apply point_eq; simpl; ring.
Qed.

(* The integers of a query: its rational numbers times `unit`. *)
Definition times_unit (u : Z) (q : Q) : Z := (Qnum q * (u / Zpos (Qden q)))%Z.
Definition is_multiple (u : Z) (q : Q) : bool := Z.eqb (u / Zpos (Qden q) * Zpos (Qden q)) u.
Lemma times_unit_value u q : is_multiple u q = true -> IZR (times_unit u q) = IZR u * Q2R q.
Proof.
  unfold is_multiple, times_unit, Q2R. intros E. apply Z.eqb_eq in E. rewrite mult_IZR, <- E at 1.
  rewrite <- E at 2. rewrite Z.div_mul by discriminate. rewrite mult_IZR.
  assert (IZR (Zpos (Qden q)) <> 0) by (apply not_0_IZR; discriminate). field; auto.
Qed.
Definition point_fits (u : Z) (a : rational_point) : bool :=
  is_multiple u (qx a) && is_multiple u (qy a) && is_multiple u (qz a).
Definition line (u : Z) (a b : Q) : poly := let x := times_unit u a in [x; (times_unit u b - x)%Z].
Definition moving_of (u : Z) (c : corner) : moving :=
  let a := at_start c in let b := at_end c in
  Moving (Vector (line u (qx a) (qx b)) (line u (qy a) (qy b)) (line u (qz a) (qz b))) [u] 0.
Definition corner_fits (u : Z) (c : corner) : bool :=
  Z.ltb 0 u && point_fits u (at_start c) && point_fits u (at_end c).
Lemma ev_line u a b t : is_multiple u a = true -> is_multiple u b = true ->
  ev (line u a b) t = IZR u * (Q2R a + t * (Q2R b - Q2R a)).
Proof.
  intros A B. unfold line; simpl. rewrite minus_IZR, (times_unit_value u a A), (times_unit_value u b B). ring.
Qed.
Lemma moving_of_moves u c : corner_fits u c = true -> moves_as (moving_of u c) c.
Proof.
  unfold corner_fits, point_fits. rewrite !andb_true_iff. intros [[U [[A1 A2] A3]] [[B1 B2] B3]] t _.
  apply Z.ltb_lt, IZR_lt in U. unfold moving_of; simpl weight; simpl numerator. simpl ev at 1. split; [lra|].
  apply point_eq; simpl vx; simpl vy; simpl vz; unfold value; cbn [px py pz vx vy vz];
    rewrite ev_line by auto; simpl; ring.
Qed.
