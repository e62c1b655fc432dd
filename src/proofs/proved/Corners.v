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
Definition vsquare a := padd (padd (psquare (vx a)) (psquare (vy a))) (psquare (vz a)).
Definition vcross a b := Vector
  (psub (pmul (vy a) (vz b)) (pmul (vz a) (vy b)))
  (psub (pmul (vz a) (vx b)) (pmul (vx a) (vz b)))
  (psub (pmul (vx a) (vy b)) (pmul (vy a) (vx b))).

Lemma value_add a b t : value (vadd a b) t = plus (value a t) (value b t).
Proof. apply point_eq; simpl; apply ev_add. Qed.
Lemma value_sub a b t : value (vsub a b) t = minus (value a t) (value b t).
Proof. apply point_eq; simpl; apply ev_sub. Qed.
Lemma value_scale p a t : value (vscale p a) t = scale (ev p t) (value a t).
Proof. apply point_eq; simpl; apply ev_mul. Qed.
Lemma ev_vsquare a t : ev (vsquare a) t = dot (value a t) (value a t).
Proof. unfold vsquare. rewrite !ev_add, !ev_square. reflexivity. Qed.
Lemma ev_dot a b t : ev (vdot a b) t = dot (value a t) (value b t).
Proof. unfold vdot, dot; simpl. now rewrite !ev_add, !ev_mul. Qed.
Lemma value_cross a b t : value (vcross a b) t = cross (value a t) (value b t).
Proof. apply point_eq; simpl; now rewrite ev_sub, !ev_mul. Qed.

(* A corner is at numerator / weight. Corners of one motion have one weight. *)
Record moving := Moving { numerator : vector; weight : poly; body : Z }.
Definition moves_as (m : moving) (c : corner) : Prop := forall t, 0 <= t <= 1 ->
  0 < ev (weight m) t /\ value (numerator m) t = scale (ev (weight m) t) (position c t).

(* b - a times factor, which is positive. *)
Definition together (a b : moving) : bool := Z.eqb (body a) (body b) && equal (weight a) (weight b).
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
