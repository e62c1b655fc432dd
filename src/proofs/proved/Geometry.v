(* What separates two elements, and which sums of corners are points of an element. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import QArith Qreals Reals Lra Lia List.
From Touchstone Require Import Statement.
Import ListNotations.
Open Scope R_scope.

Lemma point_eq a b : px a = px b -> py a = py b -> pz a = pz b -> a = b.
Proof. destruct a, b; simpl; intros; subst; reflexivity. Qed.
Lemma dot_minus n a b : dot n (minus a b) = dot n a - dot n b.
Proof. unfold dot, minus; simpl; ring. Qed.
Lemma dot_self n : 0 <= dot n n.
Proof. unfold dot. pose proof (Rle_0_sqr (px n)). pose proof (Rle_0_sqr (py n)). pose proof (Rle_0_sqr (pz n)).
  unfold Rsqr in *. lra. Qed.
Lemma cauchy_schwarz n v : dot n v * dot n v <= dot n n * dot v v.
Proof.
  unfold dot.
  assert (0 <= (px n * py v - py n * px v) * (px n * py v - py n * px v)) by apply Rle_0_sqr.
  assert (0 <= (py n * pz v - pz n * py v) * (py n * pz v - pz n * py v)) by apply Rle_0_sqr.
  assert (0 <= (pz n * px v - px n * pz v) * (pz n * px v - px n * pz v)) by apply Rle_0_sqr. nra.
Qed.

(* A half-space that holds all corners holds their hull. *)
Lemma sum_below n K points : (forall a, In a points -> dot n a < K) -> forall weights,
  length weights = length points -> (forall w, In w weights -> 0 <= w) ->
  0 <= total weights /\ dot n (weighted_sum weights points) <= K * total weights
  /\ (0 < total weights -> dot n (weighted_sum weights points) < K * total weights).
Proof.
  induction points as [|a points IH]; intros H [|w weights] L W; try discriminate.
  - unfold dot; simpl. lra.
  - simpl in L. injection L as L. destruct (IH (fun b I => H b (or_intror I)) weights L) as (T & S1 & S2).
    { intros v I. apply W. now right. }
    pose proof (H a (or_introl eq_refl)) as A. pose proof (W w (or_introl eq_refl)) as P. simpl total.
    replace (dot n (weighted_sum (w :: weights) (a :: points))) with (w * dot n a + dot n (weighted_sum weights points))
      by (unfold dot, plus, scale; simpl; ring).
    assert (w * dot n a <= w * K) by (apply Rmult_le_compat_l; lra).
    split; [lra|]. split; [lra|]. intros Q. destruct P as [P|<-].
    + assert (w * dot n a < w * K) by (apply Rmult_lt_compat_l; lra). lra.
    + assert (0 < total weights) by lra. specialize (S2 H1). lra.
Qed.
Lemma hull_below n K points x : (forall a, In a points -> dot n a < K) -> in_hull points x -> dot n x < K.
Proof.
  intros H (weights & L & W & T & ->). destruct (sum_below n K points H weights L W) as (_ & _ & S).
  rewrite T in S. lra.
Qed.
Lemma hulls_apart n K A B : (forall a b, In a A -> In b B -> K < dot n b - dot n a) ->
  forall x y, in_hull A x -> in_hull B y -> K < dot n (minus y x).
Proof.
  intros H x y HA HB.
  assert (E : forall b, In b B -> dot n x < dot n b - K).
  { intros b I. apply (hull_below n _ A); auto. intros a J. specialize (H a b J I). lra. }
  assert (F : dot (scale (-1) n) y < - (dot n x + K)).
  { apply (hull_below _ _ B); auto. intros b I. specialize (E b I).
    replace (dot (scale (-1) n) b) with (- dot n b) by (unfold dot, scale; simpl; ring). lra. }
  replace (dot (scale (-1) n) y) with (- dot n y) in F by (unfold dot, scale; simpl; ring).
  rewrite dot_minus. lra.
Qed.

(* Points that are farther apart than this along n are not near. *)
Definition reach (s : separation) (n : point) : R :=
  match s with
  | Zero => 0
  | Euclidean D => Q2R D * sqrt (dot n n)
  | Max D => Q2R D * (Rabs (px n) + Rabs (py n) + Rabs (pz n))
  end.
Definition not_negative (s : separation) : Prop :=
  match s with Zero => True | Euclidean D | Max D => 0 <= Q2R D end.
Lemma beyond_reach s n v : not_negative s -> reach s n < dot n v -> ~ near s v.
Proof.
  destruct s as [|D|D]; simpl; intros P L N.
  - subst v. unfold dot in L; simpl in L. lra.
  - pose proof (sqrt_pos (dot n n)). pose proof (sqrt_pos (dot v v)).
    pose proof (sqrt_sqrt _ (dot_self n)) as E. pose proof (sqrt_sqrt _ (dot_self v)) as F.
    pose proof (cauchy_schwarz n v) as C. rewrite <- E, <- F in C.
    set (a := sqrt (dot n n)) in *. set (b := sqrt (dot v v)) in *.
    assert (0 <= a * b) by (apply Rmult_le_pos; lra).
    assert (a * b <= Q2R D * a) by (rewrite (Rmult_comm _ a); apply Rmult_le_compat_l; lra).
    assert (a * b * (a * b) < dot n v * dot n v) by (apply Rmult_le_0_lt_compat; lra). lra.
  - destruct N as (X & Y & Z).
    assert (B : forall a b, Rabs b <= Q2R D -> a * b <= Q2R D * Rabs a).
    { intros a b H. apply Rle_trans with (Rabs (a * b)); [apply Rle_abs|]. rewrite Rabs_mult, Rmult_comm.
      apply Rmult_le_compat_r; [apply Rabs_pos | exact H]. }
    pose proof (B (px n) _ X). pose proof (B (py n) _ Y). pose proof (B (pz n) _ Z). unfold dot in L. lra.
Qed.
Theorem apart_no_contact q n t : not_negative (apart q) ->
  (forall a b, In a (first q) -> In b (second q) -> reach (apart q) n < dot n (position b t) - dot n (position a t)) ->
  ~ in_contact q t.
Proof.
  intros P H (x & y & X & Y & N). apply (beyond_reach (apart q) n (minus y x)); auto.
  apply (hulls_apart n _ (element (first q) t) (element (second q) t)); auto.
  unfold element. intros a b A B. apply in_map_iff in A as (c & <- & A). apply in_map_iff in B as (d & <- & B). auto.
Qed.

(* Weights with a positive sum have a mean in the hull. *)
Lemma sum_of_scaled k weights : forall points,
  weighted_sum (map (Rmult k) weights) points = scale k (weighted_sum weights points).
Proof.
  induction weights as [|w weights IH]; intros [|a points]; simpl; rewrite ?IH; apply point_eq; simpl; ring.
Qed.
Lemma total_of_scaled k weights : total (map (Rmult k) weights) = k * total weights.
Proof. induction weights as [|w weights IH]; simpl; [ring | rewrite IH; ring]. Qed.
Lemma mean_in_hull points weights : length weights = length points -> (forall w, In w weights -> 0 <= w) ->
  0 < total weights -> in_hull points (scale (/ total weights) (weighted_sum weights points)).
Proof.
  intros L W T. exists (map (Rmult (/ total weights)) weights). pose proof (Rinv_0_lt_compat _ T).
  rewrite map_length, sum_of_scaled, total_of_scaled. repeat split; auto; [|field; lra].
  intros w I. apply in_map_iff in I as (v & <- & I). apply Rmult_le_pos; [lra | auto].
Qed.
