(* The meeting of a proof: two weighted points, one of each element, are near at a root of g. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Geometry Corners Pieces.
Import ListNotations.
Open Scope R_scope.

(* A weight belongs to each corner; [] where the proof has none. *)
Fixpoint sum_of_weights (weights : list poly) (corners : list moving) : poly :=
  match weights, corners with
  | w :: weights', a :: corners' => padd (pmul w (weight a)) (sum_of_weights weights' corners')
  | _, _ => []
  end.
Fixpoint sum_of_corners (weights : list poly) (corners : list moving) : vector :=
  match weights, corners with
  | w :: weights', a :: corners' => vadd (vscale w (numerator a)) (sum_of_corners weights' corners')
  | _, _ => Vector [] [] []
  end.
(* Here and below an `if` in place of || leaves out what is not needed: Coq's virtual machine would compute both. *)
Definition is_weight (i : span) (g w : poly) : bool := if all_positive (bernstein i w) then true else multiple w g.
Definition are_weights (i : span) (g : poly) (weights : list poly) (corners : list moving) : bool :=
  Nat.eqb (length weights) (length corners) && forallb (is_weight i g) weights
  && all_positive (bernstein i (sum_of_weights weights corners)).

(* Whether p is not negative at the roots of g in a span. *)
Definition holds_at_root (i : span) (g p : poly) : bool :=
  if multiple p g then true else none_negative (bernstein i p).
(* Whether c / ab, with ab > 0, is near at these roots. *)
Definition near_at_root (s : separation) (i : span) (g : poly) (c : vector) (ab : poly) : bool :=
  match s with
  | Zero => multiple (vx c) g && multiple (vy c) g && multiple (vz c) g
  | Euclidean D =>
      let d := Zpos (Qden D) in
      Z.leb 0 (Qnum D)
      && holds_at_root i g (psub (pscale (Qnum D * Qnum D) (psquare ab)) (pscale (d * d) (vsquare c)))
  | Max D =>
      let most := pscale (Qnum D) ab in
      forallb (fun x => let y := pscale (Zpos (Qden D)) x in
        holds_at_root i g (psub most y) && holds_at_root i g (padd most y)) [vx c; vy c; vz c]
  end.
Definition meeting (s : separation) (i : span) (g : poly) (A B : list moving) (ws us : list poly) : bool :=
  let a := sum_of_weights ws A in
  let b := sum_of_weights us B in
  are_weights i g ws A && are_weights i g us B
  && near_at_root s i g (vsub (vscale a (sum_of_corners us B)) (vscale b (sum_of_corners ws A))) (pmul a b).

Section At_a_root.
Variables (i : span) (g : poly) (t : R).
Hypothesis U : 0 < IZR (den i).
Hypothesis W : within i t.
Hypothesis G : ev g t = 0.
Hypothesis T : 0 <= t <= 1.

Lemma holds_at_root_sound p : holds_at_root i g p = true -> 0 <= ev p t.
Proof.
  unfold holds_at_root. intros H; apply orb_true_iff in H as [H|H].
  - rewrite (multiple_zero _ _ _ H G). lra.
  - now apply none_negative_sound with i.
Qed.
Lemma weights_value weights : forall A corners, Forall2 moves_as A corners -> length weights = length A ->
  forallb (is_weight i g) weights = true ->
  exists reals, length reals = length (element corners t) /\ (forall w, In w reals -> 0 <= w)
    /\ ev (sum_of_weights weights A) t = total reals
    /\ value (sum_of_corners weights A) t = weighted_sum reals (element corners t).
Proof.
  induction weights as [|w weights IH]; intros A corners F L H; destruct A as [|a A]; try discriminate.
  - inversion F; subst. exists []. repeat split; try reflexivity. intros w [].
  - inversion F as [|? c ? corners' M F']; subst. simpl in H. apply andb_true_iff in H as [H H'].
    destruct (IH A corners' F' ltac:(simpl in L; congruence) H') as (reals & N & P & E & V). destruct (M t T) as [Q X].
    exists (ev w t * ev (weight a) t :: reals). simpl. split; [congruence|]. split; [|split].
    + intros v [<-|I]; [|auto]. apply Rmult_le_pos; [|lra].
      unfold is_weight in H. apply orb_true_iff in H as [H|H].
      * left. now apply all_positive_sound with i.
      * right. symmetry. now apply multiple_zero with g.
    + now rewrite ev_add, ev_mul, E.
    + rewrite value_add, value_scale, X, V. apply point_eq; simpl; ring.
Qed.
Lemma are_weights_sound weights A corners : Forall2 moves_as A corners -> are_weights i g weights A = true ->
  0 < ev (sum_of_weights weights A) t
  /\ in_hull (element corners t) (scale (/ ev (sum_of_weights weights A) t) (value (sum_of_corners weights A) t)).
Proof.
  unfold are_weights. rewrite !andb_true_iff. intros F [[L H] S]. apply Nat.eqb_eq in L.
  apply all_positive_sound with (t := t) in S; auto. split; [auto|].
  destruct (weights_value weights A corners F L H) as (reals & N & P & E & V). rewrite V.
  rewrite E in *. now apply mean_in_hull.
Qed.

Lemma near_sound s c ab k : near_at_root s i g c ab = true -> 0 < k -> ev ab t = / k -> near s (scale k (value c t)).
Proof.
  intros H K E. destruct s as [|D|D]; unfold near_at_root in H; cbv zeta in H.
  - rewrite !andb_true_iff in H. destruct H as [[X Y] Z].
    apply (multiple_zero _ _ t) in X, Y, Z; auto. apply point_eq; simpl; rewrite ?X, ?Y, ?Z; ring.
  - apply andb_true_iff in H as [P H]. apply Z.leb_le, IZR_le in P. destruct (denominator_positive D) as [Dd Dn].
    set (d := IZR (Zpos (Qden D))) in *. apply holds_at_root_sound in H.
    rewrite ev_sub, !ev_scale, ev_square, ev_vsquare, !mult_IZR, E, Dn in H. fold d in H.
    assert (0 <= Q2R D) by (apply Rmult_le_reg_r with d; lra).
    unfold near. rewrite <- (sqrt_Rsqr (Q2R D)) by auto. apply sqrt_le_1_alt. unfold Rsqr.
    apply Rmult_le_reg_l with (/ k * / k * (d * d)).
    { assert (0 < / k) by now apply Rinv_0_lt_compat. repeat apply Rmult_lt_0_compat; auto. }
    replace (/ k * / k * (d * d) * dot (scale k (value c t)) (scale k (value c t)))
      with (d * d * dot (value c t) (value c t)) by (unfold dot, scale; cbn [px py pz]; field; lra). lra.
  - destruct (denominator_positive D) as [Dd Dn]. set (d := IZR (Zpos (Qden D))) in *.
    assert (B : forall x, In x [vx c; vy c; vz c] -> Rabs (k * ev x t) <= Q2R D).
    { intros x I. pose proof (proj1 (forallb_forall _ _) H x I) as J. cbv beta zeta in J.
      apply andb_true_iff in J as [J1 J2]. apply holds_at_root_sound in J1, J2.
      rewrite ev_sub, !ev_scale, E, Dn in J1. rewrite ev_add, !ev_scale, E, Dn in J2. fold d in J1, J2.
      assert (0 < / k) by now apply Rinv_0_lt_compat.
      assert (0 < / k * d) by now apply Rmult_lt_0_compat.
      apply Rabs_le; split; apply Rmult_le_reg_l with (/ k * d); auto;
        replace (/ k * d * (k * ev x t)) with (d * ev x t) by (field; lra); lra. }
    unfold near, scale; cbn [px py pz value]. repeat split; apply B; simpl; tauto.
Qed.

Theorem meeting_sound q A B ws us : Forall2 moves_as A (first q) -> Forall2 moves_as B (second q) ->
  meeting (apart q) i g A B ws us = true -> in_contact q t.
Proof.
  intros FA FB. unfold meeting. rewrite !andb_true_iff. intros [[WA WB] N].
  destruct (are_weights_sound ws A _ FA WA) as [PA HA], (are_weights_sound us B _ FB WB) as [PB HB].
  eexists; eexists; split; [exact HA | split; [exact HB|]].
  set (a := ev (sum_of_weights ws A) t) in *. set (b := ev (sum_of_weights us B) t) in *.
  apply (near_sound _ _ _ (/ (a * b))) in N.
  - rewrite value_sub, !value_scale in N. fold a b in N.
    replace (minus _ _) with (scale (/ (a * b)) (minus (scale a (value (sum_of_corners us B) t))
      (scale b (value (sum_of_corners ws A) t)))); [exact N|].
    apply point_eq; cbn [px py pz scale minus]; field; lra.
  - apply Rinv_0_lt_compat. now apply Rmult_lt_0_compat.
  - rewrite ev_mul, Rinv_inv. reflexivity.
Qed.
End At_a_root.
