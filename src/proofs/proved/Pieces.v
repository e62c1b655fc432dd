(* The pieces of a proof: during each one a plane separates the elements. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Geometry Corners.
Import ListNotations.
Open Scope R_scope.

(* The last piece of a contact at a double may be `open`: then nothing is said about its end. *)
Definition inside (i : span) (is_open : bool) (t : R) : Prop :=
  within i t /\ (is_open = true -> t * IZR (den i) < IZR (high i)).
Definition is_positive (i : span) (is_open : bool) (p : poly) : bool :=
  if is_open then first_positive (bernstein i p) else all_positive (bernstein i p).
Lemma positive_sound i is_open p t : 0 < IZR (den i) -> inside i is_open t ->
  is_positive i is_open p = true -> 0 < ev p t.
Proof.
  intros U [W O] H.
  destruct is_open; [now apply first_positive_sound with i; auto | now apply all_positive_sound with i].
Qed.

Definition signs : list (Z * Z * Z) :=
  [(1, 1, 1); (1, 1, -1); (1, -1, 1); (1, -1, -1); (-1, 1, 1); (-1, 1, -1); (-1, -1, 1); (-1, -1, -1)]%Z.
Definition with_signs (s : Z * Z * Z) (n : vector) : poly :=
  let '(a, b, c) := s in padd (padd (pscale a (vx n)) (pscale b (vy n))) (pscale c (vz n)).

(* Whether the corner b is beyond the corner a along n, or along -n for `negative`, with the separation between them. *)
Definition beyond (s : separation) (i : span) (is_open negative : bool) (n : vector) : moving -> moving -> bool :=
  let square := match s with Euclidean _ => vsquare n | _ => [] end in
  fun b a =>
  let product := vdot n (difference b a) in
  let p := if negative then popp product else product in
  match s with
  | Zero => is_positive i is_open p
  | Euclidean D =>
      let f := factor b a in
      let d := Zpos (Qden D) in
      Z.ltb 0 (value_at (low i) (den i) p)
      && is_positive i is_open (psub (pscale (d * d) (psquare p))
                                  (pscale (Qnum D * Qnum D) (pmul (psquare f) square)))
  | Max D =>
      let f := factor b a in
      let q := pscale (Zpos (Qden D)) p in
      forallb (fun s => is_positive i is_open (psub q (pscale (Qnum D) (pmul f (with_signs s n))))) signs
  end.

Definition turned (negative : bool) (a : point) : point := if negative then scale (-1) a else a.
Lemma reach_turned s negative n : reach s (turned negative n) = reach s n.
Proof.
  destruct negative; [|reflexivity]. destruct s; simpl; [reflexivity | |].
  - f_equal. f_equal. unfold dot, scale; simpl. ring.
  - now replace (-1 * px n) with (- px n) by ring; replace (-1 * py n) with (- py n) by ring;
      replace (-1 * pz n) with (- pz n) by ring; rewrite !Rabs_Ropp.
Qed.
Lemma abs_sign r : Rabs r = IZR 1 * r \/ Rabs r = IZR (-1) * r.
Proof. unfold Rabs; destruct (Rcase_abs r); [right | left]; lra. Qed.
Lemma signs_of n : exists s, In s signs /\ forall v t, value v t = n ->
  ev (with_signs s v) t = Rabs (px n) + Rabs (py n) + Rabs (pz n).
Proof.
  destruct (abs_sign (px n)) as [-> | ->], (abs_sign (py n)) as [-> | ->], (abs_sign (pz n)) as [-> | ->];
  [ exists (1, 1, 1)%Z | exists (1, 1, -1)%Z | exists (1, -1, 1)%Z | exists (1, -1, -1)%Z
  | exists (-1, 1, 1)%Z | exists (-1, 1, -1)%Z | exists (-1, -1, 1)%Z | exists (-1, -1, -1)%Z ];
  (split; [simpl; tauto | intros v t <-; unfold with_signs; rewrite !ev_add, !ev_scale; reflexivity]).
Qed.
Lemma denominator_positive D : 0 < IZR (Zpos (Qden D)) /\ IZR (Qnum D) = Q2R D * IZR (Zpos (Qden D)).
Proof.
  assert (0 < IZR (Zpos (Qden D))) by (apply IZR_lt; reflexivity). split; [auto|].
  unfold Q2R. field. lra.
Qed.

Section A_piece.
Variables (s : separation) (i : span) (is_open : bool) (n : vector) (t : R).
Hypothesis P : not_negative s.
Hypothesis U : 0 < IZR (den i).
Hypothesis L : 0 <= IZR (low i).
Hypothesis I : inside i is_open t.
Hypothesis T : t <= 1.

Lemma start_of_span : exists start, start * IZR (den i) = IZR (low i) /\ 0 <= start <= t.
Proof.
  exists (IZR (low i) / IZR (den i)).
  assert (E : IZR (low i) / IZR (den i) * IZR (den i) = IZR (low i)) by (field; lra).
  destruct I as [[I1 _] _]. split; [exact E|]. split; apply Rmult_le_reg_r with (IZR (den i)); lra.
Qed.
Lemma inside_before start r : start * IZR (den i) = IZR (low i) -> start <= r <= t -> inside i is_open r.
Proof.
  intros S R. destruct I as [[I1 I2] I3]. unfold inside, within.
  assert (start * IZR (den i) <= r * IZR (den i)) by (apply Rmult_le_compat_r; lra).
  assert (r * IZR (den i) <= t * IZR (den i)) by (apply Rmult_le_compat_r; lra).
  repeat split; try lra. intros O. specialize (I3 O). lra.
Qed.
Lemma beyond_sound negative a b c d : moves_as a c -> moves_as b d -> beyond s i is_open negative n b a = true ->
  reach s (turned negative (value n t)) < dot (turned negative (value n t)) (minus (position d t) (position c t)).
Proof.
  intros A B H. unfold beyond in H. rewrite reach_turned. destruct start_of_span as (start & S0 & S1 & S2).
  set (p := if negative then popp (vdot n (difference b a)) else vdot n (difference b a)) in H.
  set (gap := fun r => dot (turned negative (value n r)) (minus (position d r) (position c r))).
  assert (E : forall r, 0 <= r <= 1 -> 0 < ev (factor b a) r /\ ev p r = ev (factor b a) r * gap r).
  { intros r R. destruct (difference_value a b c d r A B R) as [F V]. split; [exact F|].
    unfold p, gap, turned. destruct negative; rewrite ?ev_opp, ev_dot, V; unfold dot, scale; simpl; ring. }
  destruct (E t) as [F V]; [lra|]. fold (gap t). destruct s as [|D|D]; simpl reach in *.
  - apply positive_sound with (t := t) in H; auto. rewrite V in H.
    apply Rmult_lt_reg_l with (ev (factor b a) t); lra.
  - apply andb_true_iff in H as [H0 H]. apply Z.ltb_lt, IZR_lt in H0.
    destruct (denominator_positive D) as [Dd Dn]. simpl in P. set (dd := IZR (Zpos (Qden D))) in *.
    assert (K : forall r, start <= r <= t -> Q2R D * Q2R D * dot (value n r) (value n r) < gap r * gap r).
    { intros r R. destruct (E r) as [Fr Vr]; [lra|].
      apply positive_sound with (t := r) in H; [|auto|now apply inside_before with start].
      rewrite ev_sub, !ev_scale, ev_mul, !ev_square, ev_vsquare, !mult_IZR in H. fold dd in H. rewrite Vr, Dn in H.
      set (f := ev (factor b a) r) in *. set (nn := dot (value n r) (value n r)) in *.
      assert (0 < f * f * (dd * dd)) by (repeat apply Rmult_lt_0_compat; lra).
      apply Rmult_lt_reg_l with (f * f * (dd * dd)); [auto|]. lra. }
    assert (G : 0 < gap t).
    { assert (0 < ev p t).
      { apply keeps_sign with start; auto.
        - destruct (value_sign (low i) (den i) p start U S0) as (k & Pk & Ek).
          change (0%Z) with 0%Z in H0. rewrite <- Ek. apply Rmult_lt_0_compat; lra.
        - intros r R Z. destruct (E r) as [Fr Vr]; [lra|]. rewrite Vr in Z.
          assert (gap r = 0) by (apply Rmult_integral in Z as [Z|Z]; [lra | exact Z]).
          specialize (K r R). rewrite H1 in K. pose proof (dot_self (value n r)).
          assert (0 <= Q2R D * Q2R D * dot (value n r) (value n r)); [|lra].
          apply Rmult_le_pos; [apply Rmult_le_pos; exact P | lra]. }
      rewrite V in H1. apply Rmult_lt_reg_l with (ev (factor b a) t); lra. }
    specialize (K t ltac:(lra)). pose proof (sqrt_pos (dot (value n t) (value n t))) as Q.
    pose proof (sqrt_sqrt _ (dot_self (value n t))) as QQ. rewrite <- QQ in K.
    set (q := sqrt (dot (value n t) (value n t))) in *.
    destruct (Rlt_le_dec (Q2R D * q) (gap t)) as [|X]; [auto|]. exfalso.
    assert (gap t * gap t <= Q2R D * q * (Q2R D * q)) by (apply Rmult_le_compat; lra). lra.
  - destruct (signs_of (value n t)) as (e & Ie & Se). rewrite forallb_forall in H. specialize (H e Ie).
    apply positive_sound with (t := t) in H; auto.
    destruct (denominator_positive D) as [Dd Dn]. set (dd := IZR (Zpos (Qden D))) in *.
    rewrite ev_sub, !ev_scale, ev_mul, (Se n t eq_refl), V in H. fold dd in H. rewrite Dn in H.
    set (f := ev (factor b a) t) in *.
    apply Rmult_lt_reg_l with (f * dd); [apply Rmult_lt_0_compat; lra|]. cbn [value px py pz] in *. lra.
Qed.
End A_piece.

(* The direction of a piece: perpendicular to edges of both elements, or any. *)
Inductive direction := Normal | Along (n : vector).
Definition normal (A B : list moving) : option vector :=
  match A, B with
  | [a; b], [c; d] => Some (vcross (difference b a) (difference d c))
  | [_], [b; c; d] => Some (vcross (difference c b) (difference d b))
  | _, _ => None
  end.
Definition is_negative (i : span) (n : vector) (b a : moving) : bool :=
  Z.ltb (value_at (low i) (den i) (vdot n (difference b a))) 0.
Definition piece (s : separation) (i : span) (is_open : bool) (A B : list moving) (along : direction) : bool :=
  match A, B with
  | a :: _, b :: _ =>
      match along with
      | Along n =>
          let negative := is_negative i n b a in
          let is_beyond := beyond s i is_open negative n in
          forallb (fun a => forallb (fun b => is_beyond b a) B) A
      | Normal =>
          match normal A B with
          | Some n => beyond s i is_open (is_negative i n b a) n b a
          | None => false
          end
      end
  | _, _ => false
  end.

Lemma normal_same A B n t a b a' b' : Forall2 moves_as A a -> Forall2 moves_as B b -> normal A B = Some n ->
  0 <= t <= 1 ->
  forall c d c' d', a = c :: a' -> b = d :: b' -> In c' a -> In d' b ->
  dot (value n t) (minus (position d' t) (position c' t)) = dot (value n t) (minus (position d t) (position c t)).
Proof.
  intros FA FB N T c d c' d' -> -> IA IB. unfold normal in N.
  destruct A as [|m1 [|m2 [|]]]; try discriminate; destruct B as [|m3 [|m4 [|m5 [|]]]]; try discriminate;
    injection N as <-;
    repeat match goal with H : Forall2 _ (_ :: _) _ |- _ => inversion H; clear H; subst
                         | H : Forall2 _ [] _ |- _ => inversion H; clear H; subst end;
    rewrite value_cross.
  - destruct (difference_value m3 m4 _ _ t ltac:(eassumption) ltac:(eassumption) T) as [_ ->].
    destruct (difference_value m3 m5 _ _ t ltac:(eassumption) ltac:(eassumption) T) as [_ ->].
    simpl in IA, IB. intuition subst; unfold dot, cross, minus, scale; simpl; ring.
  - destruct (difference_value m1 m2 _ _ t ltac:(eassumption) ltac:(eassumption) T) as [_ ->].
    destruct (difference_value m3 m4 _ _ t ltac:(eassumption) ltac:(eassumption) T) as [_ ->].
    simpl in IA, IB. intuition subst; unfold dot, cross, minus, scale; simpl; ring.
Qed.
Lemma Forall2_in {X Y} (R : X -> Y -> Prop) l m y : Forall2 R l m -> In y m -> exists x, In x l /\ R x y.
Proof.
  induction 1 as [|x z l m H F IH]; simpl; [tauto|]. intros [->|J]; [eauto|].
  destruct (IH J) as (w & W & K). eauto.
Qed.

Theorem piece_sound q i is_open A B along t : not_negative (apart q) ->
  Forall2 moves_as A (first q) -> Forall2 moves_as B (second q) -> 0 < IZR (den i) -> 0 <= IZR (low i) ->
  piece (apart q) i is_open A B along = true -> inside i is_open t -> 0 <= t <= 1 -> ~ in_contact q t.
Proof.
  intros P FA FB U L H I T. unfold piece in H. destruct q as [corners_a corners_b s]. simpl in P, FA, FB, H.
  destruct A as [|a A], B as [|b B]; try discriminate.
  inversion FA as [|? c ? corners_a' MA FA']; subst. inversion FB as [|? d ? corners_b' MB FB']; subst.
  destruct along as [|n].
  - destruct (normal (a :: A) (b :: B)) as [n|] eqn:N; [|discriminate].
    set (negative := is_negative i n b a) in *.
    apply (beyond_sound _ i is_open n t P U L I (proj2 T) negative a b c d MA MB) in H.
    apply apart_no_contact with (turned negative (value n t)); auto. simpl. intros c' d' IA IB.
    pose proof (normal_same _ _ n t _ _ _ _ FA FB N T c d c' d' eq_refl eq_refl IA IB) as E.
    rewrite <- dot_minus.
    replace (dot (turned negative (value n t)) (minus (position d' t) (position c' t)))
      with (dot (turned negative (value n t)) (minus (position d t) (position c t))); [exact H|].
    unfold turned. destruct negative; [|now symmetry]. unfold dot, scale, minus in *; simpl in *. lra.
  - set (negative := is_negative i n b a) in *.
    apply apart_no_contact with (turned negative (value n t)); auto. simpl. intros c' d' IA IB.
    destruct (Forall2_in _ _ _ _ FA IA) as (a' & JA & MA'), (Forall2_in _ _ _ _ FB IB) as (b' & JB & MB').
    rewrite forallb_forall in H. specialize (H _ JA). rewrite forallb_forall in H. specialize (H _ JB).
    rewrite <- dot_minus. now apply (beyond_sound _ i is_open n t P U L I (proj2 T) negative a' b' c' d').
Qed.
