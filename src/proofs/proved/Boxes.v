(* Boxes of the motion of vertices, and what they exclude. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Geometry Corners Positions Pieces Checker.
Import ListNotations.
Open Scope R_scope.

(* Coordinates times U, from l on. Those that are at most g above the greatest one end at r. *)
Record box := Box { lx : Z; ly : Z; lz : Z; rx : Z; ry : Z; rz : Z }.
Definition inside_box (U g : Z) (b : box) (a : point) : Prop :=
  (IZR (lx b) <= IZR U * px a <= IZR (rx b) - IZR g) /\ (IZR (ly b) <= IZR U * py a <= IZR (ry b) - IZR g)
  /\ (IZR (lz b) <= IZR U * pz a <= IZR (rz b) - IZR g).
Definition join_boxes (a b : box) : box :=
  Box (Z.min (lx a) (lx b)) (Z.min (ly a) (ly b)) (Z.min (lz a) (lz b))
      (Z.max (rx a) (rx b)) (Z.max (ry a) (ry b)) (Z.max (rz a) (rz b)).
Lemma inside_join U g a b p : inside_box U g a p \/ inside_box U g b p -> inside_box U g (join_boxes a b) p.
Proof.
  unfold inside_box, join_boxes; cbn [lx ly lz rx ry rz].
  pose proof (IZR_le _ _ (Z.le_min_l (lx a) (lx b))). pose proof (IZR_le _ _ (Z.le_min_r (lx a) (lx b))).
  pose proof (IZR_le _ _ (Z.le_min_l (ly a) (ly b))). pose proof (IZR_le _ _ (Z.le_min_r (ly a) (ly b))).
  pose proof (IZR_le _ _ (Z.le_min_l (lz a) (lz b))). pose proof (IZR_le _ _ (Z.le_min_r (lz a) (lz b))).
  pose proof (IZR_le _ _ (Z.le_max_l (rx a) (rx b))). pose proof (IZR_le _ _ (Z.le_max_r (rx a) (rx b))).
  pose proof (IZR_le _ _ (Z.le_max_l (ry a) (ry b))). pose proof (IZR_le _ _ (Z.le_max_r (ry a) (ry b))).
  pose proof (IZR_le _ _ (Z.le_max_l (rz a) (rz b))). pose proof (IZR_le _ _ (Z.le_max_r (rz a) (rz b))).
  intros [H'|H']; lra.
Qed.

(* A box holds a corner during the step: U x - l and r - g - U x are not negative, by their Bernstein coefficients. *)
Definition step : span := Span 0 1 1.
Definition coordinate_in (U : Z) (x w : poly) (l r : Z) : bool :=
  let y := pscale U x in
  none_negative (bernstein step (psub y (pscale l w))) && none_negative (bernstein step (psub (pscale r w) y)).
Definition box_holds (U g u h : Z) (b : box) (c : corner) : bool :=
  let m := moving_of u h c in
  let (v, w) := (numerator m, weight m) in
  corner_fits u h c && coordinate_in U (vx v) w (lx b) (rx b - g) && coordinate_in U (vy v) w (ly b) (ry b - g)
  && coordinate_in U (vz v) w (lz b) (rz b - g).
Lemma coordinate_in_sound U x w l r t y : 0 <= t <= 1 -> 0 < ev w t -> ev x t = ev w t * y ->
  coordinate_in U x w l r = true -> IZR l <= IZR U * y <= IZR r.
Proof.
  intros T W E. unfold coordinate_in. rewrite andb_true_iff. intros [L R].
  assert (S : within step t) by (unfold within, step; cbn [low high den]; lra).
  assert (P : 0 < IZR (den step)) by (cbn; lra). apply (none_negative_sound _ _ t P S) in L, R.
  rewrite ev_sub, !ev_scale, E in L, R.
  split; apply Rmult_le_reg_l with (ev w t); lra.
Qed.
Lemma box_holds_sound U g u h b c t : box_holds U g u h b c = true -> 0 <= t <= 1 -> inside_box U g b (position c t).
Proof.
  unfold box_holds. cbv zeta. rewrite !andb_true_iff. intros [[[F X] Y] Z] T.
  destruct (moving_of_moves u h c F t T) as [W V].
  assert (E : forall f : point -> R, f (value (numerator (moving_of u h c)) t)
    = f (scale (ev (weight (moving_of u h c)) t) (position c t))) by (intros; now rewrite V).
  apply (coordinate_in_sound _ _ _ _ _ t (px (position c t)) T W (E px)) in X.
  apply (coordinate_in_sound _ _ _ _ _ t (py (position c t)) T W (E py)) in Y.
  apply (coordinate_in_sound _ _ _ _ _ t (pz (position c t)) T W (E pz)) in Z.
  rewrite minus_IZR in X, Y, Z. unfold inside_box. lra.
Qed.

(* At least the separation times U. *)
Definition size (s : separation) : R := match s with Zero => 0 | Euclidean D | Max D => Q2R D end.
Definition margin (U : Z) (s : separation) : Z :=
  match s with Zero => 0 | Euclidean D | Max D => - (- (Qnum D * U) / Zpos (Qden D)) end.
Lemma margin_sound U s : IZR U * size s <= IZR (margin U s).
Proof.
  assert (H : forall D, IZR U * Q2R D <= IZR (- (- (Qnum D * U) / Zpos (Qden D)))).
  { intros D. destruct (denominator_positive D) as [P E].
    assert (L : (Zpos (Qden D) * (- (Qnum D * U) / Zpos (Qden D)) <= - (Qnum D * U))%Z)
      by (apply Z.mul_div_le; reflexivity).
    apply IZR_le in L. rewrite mult_IZR, opp_IZR, mult_IZR, E in L. rewrite opp_IZR.
    apply Rmult_le_reg_l with (IZR (Zpos (Qden D))); lra. }
  destruct s; simpl; auto. lra.
Qed.
Lemma reach_axis s n : dot n n = 1 -> Rabs (px n) + Rabs (py n) + Rabs (pz n) = 1 -> reach s n = size s.
Proof. intros E A. destruct s; simpl; rewrite ?E, ?A, ?sqrt_1; ring. Qed.

(* A negative separation is that of no two points. *)
Lemma negative_not_near s v : size s < 0 -> ~ near s v.
Proof.
  destruct s as [|D|D]; simpl; intros N; [lra | |].
  - pose proof (sqrt_pos (dot v v)). lra.
  - intros [H _]. pose proof (Rabs_pos (px v)). lra.
Qed.

(* Boxes for a g that is less by k. *)
Definition shrink (k : Z) (b : box) : box := Box (lx b) (ly b) (lz b) (rx b - k) (ry b - k) (rz b - k).
Lemma inside_shrink U g k b a : inside_box U g b a -> inside_box U (g - k) (shrink k b) a.
Proof. unfold inside_box, shrink; cbn [lx ly lz rx ry rz]. rewrite !minus_IZR. lra. Qed.

(* Boxes that are farther apart than g along an axis. *)
Definition far (a b : box) : bool :=
  Z.ltb (rx a) (lx b) || Z.ltb (rx b) (lx a) || Z.ltb (ry a) (ly b) || Z.ltb (ry b) (ly a)
  || Z.ltb (rz a) (lz b) || Z.ltb (rz b) (lz a).
Theorem far_no_contact q a b U g t : 0 < IZR U -> IZR U * size (apart q) <= IZR g ->
  (forall c, In c (first q) -> inside_box U g a (position c t)) ->
  (forall c, In c (second q) -> inside_box U g b (position c t)) -> far a b = true -> ~ in_contact q t.
Proof.
  intros P G A B F. destruct (Rlt_le_dec (size (apart q)) 0) as [S|S].
  { intros (x & y & _ & _ & H). now apply negative_not_near in H. }
  assert (N : not_negative (apart q)) by (destruct (apart q); simpl in *; auto).
  assert (axis : forall n, dot n n = 1 -> Rabs (px n) + Rabs (py n) + Rabs (pz n) = 1 ->
    (forall c d, In c (first q) -> In d (second q) -> IZR g < IZR U * (dot n (position d t) - dot n (position c t))) ->
    ~ in_contact q t).
  { intros n E O H. apply apart_no_contact with n; [exact N|]. intros c d C D. rewrite (reach_axis _ _ E O).
    specialize (H c d C D). apply Rmult_lt_reg_l with (IZR U); lra. }
  assert (one : Rabs 1 = 1) by apply Rabs_R1. assert (zero : Rabs 0 = 0) by apply Rabs_R0.
  assert (minus_one : Rabs (-1) = 1) by (rewrite Rabs_left; lra).
  unfold far in F. rewrite !orb_true_iff, !Z.ltb_lt in F.
  destruct F as [[[[[F|F]|F]|F]|F]|F]; apply IZR_lt in F;
    [ apply (axis (Point 1 0 0)) | apply (axis (Point (-1) 0 0)) | apply (axis (Point 0 1 0))
    | apply (axis (Point 0 (-1) 0)) | apply (axis (Point 0 0 1)) | apply (axis (Point 0 0 (-1))) ];
    unfold dot; cbn [px py pz]; rewrite ?one, ?zero, ?minus_one; try ring;
    intros c d C D; specialize (A c C); specialize (B d D); unfold inside_box in A, B; lra.
Qed.
