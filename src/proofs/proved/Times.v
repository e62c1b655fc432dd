(* Times: rational numbers, spans between them, and neighbouring doubles. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Positions Pieces.
Open Scope R_scope.

(* A common denominator; the greater one where it will do. *)
Definition common (a b : Z) : Z :=
  if Z.eqb (a / b * b) a then a else if Z.eqb (b / a * a) b then b else (a * b)%Z.
Definition span_of (from to : Q) : span :=
  let u := common (Zpos (Qden from)) (Zpos (Qden to)) in Span (times_unit u from) (times_unit u to) u.
Lemma common_multiple a b : (0 < a)%Z -> (0 < b)%Z ->
  (0 < common a b)%Z /\ (common a b / a * a = common a b)%Z /\ (common a b / b * b = common a b)%Z.
Proof.
  intros A B. unfold common. destruct (Z.eqb_spec (a / b * b) a) as [E|_].
  { split; [auto|]. split; [rewrite Z.div_same; lia | exact E]. }
  destruct (Z.eqb_spec (b / a * a) b) as [E|_].
  { split; [auto|]. split; [exact E | rewrite Z.div_same; lia]. }
  split; [lia|]. split; [rewrite (Z.mul_comm a b) | idtac]; rewrite Z.div_mul; lia.
Qed.
Lemma span_of_correct from to : let i := span_of from to in
  0 < IZR (den i) /\ Q2R from * IZR (den i) = IZR (low i) /\ Q2R to * IZR (den i) = IZR (high i).
Proof.
  destruct (common_multiple (Zpos (Qden from)) (Zpos (Qden to)) eq_refl eq_refl) as (P & A & B).
  cbv zeta. unfold span_of; cbn [den low high]. rewrite !times_unit_value by now apply Z.eqb_eq.
  split; [now apply IZR_lt | split; ring].
Qed.
Lemma within_span from to t : Q2R from <= t <= Q2R to <-> within (span_of from to) t.
Proof.
  destruct (span_of_correct from to) as (U & A & B). unfold within. rewrite <- A, <- B. split; intros [L H].
  - split; apply Rmult_le_compat_r; lra.
  - split; apply Rmult_le_reg_r with (IZR (den (span_of from to))); auto.
Qed.
Lemma span_not_empty from to : Z.ltb (low (span_of from to)) (high (span_of from to)) = true -> Q2R from < Q2R to.
Proof.
  destruct (span_of_correct from to) as (U & A & B). intros L. apply Z.ltb_lt, IZR_lt in L. rewrite <- A, <- B in L.
  now apply Rmult_lt_reg_r in L.
Qed.
Definition at_most (a b : Q) : bool := let i := span_of a b in Z.leb (low i) (high i).
Lemma at_most_sound a b : at_most a b = true -> Q2R a <= Q2R b.
Proof.
  destruct (span_of_correct a b) as (U & A & B). intros L. apply Z.leb_le, IZR_le in L. rewrite <- A, <- B in L.
  now apply Rmult_le_reg_r in L.
Qed.

(* T is a double, and U the next one.  T = m / 2^k are hints. *)
Definition is_number (T : Q) (m k : Z) : bool := Z.eqb (Z.shiftl (Qnum T) k) (m * Zpos (Qden T)).
Definition double (T : Q) (m k : Z) : bool :=
  is_number T m k && Z.leb 0 m && Z.ltb m (2 ^ 53) && Z.leb 0 k && Z.leb k 1074.
Definition next_double (T U : Q) (m k : Z) : bool :=
  double T m k && is_number U (m + 1) k && (Z.leb (2 ^ 52) m || Z.eqb k 1074).
Lemma power_positive k : 0 < powerRZ 2 k.
Proof. apply powerRZ_lt; lra. Qed.
Lemma power_opp k : powerRZ 2 (- k) = / powerRZ 2 k.
Proof.
  pose proof (power_positive k). apply Rmult_eq_reg_r with (powerRZ 2 k); [|lra].
  rewrite <- powerRZ_add by lra. rewrite Z.add_opp_diag_l, Rinv_l by lra. reflexivity.
Qed.
Lemma power_IZR k : (0 <= k)%Z -> powerRZ 2 k = IZR (2 ^ k).
Proof.
  intros K. rewrite <- (Z2Nat.id k K). rewrite <- pow_powerRZ, <- pow_IZR. reflexivity.
Qed.
Lemma is_number_value T m k : (0 <= k)%Z -> is_number T m k = true -> Q2R T = IZR m / powerRZ 2 k.
Proof.
  unfold is_number; intros K E. apply Z.eqb_eq in E. rewrite Z.shiftl_mul_pow2 in E by auto. apply (f_equal IZR) in E.
  rewrite !mult_IZR, <- power_IZR in E by auto.
  pose proof (power_positive k). assert (IZR (Zpos (Qden T)) <> 0) by (apply not_0_IZR; discriminate).
  unfold Q2R. apply Rmult_eq_reg_r with (powerRZ 2 k * IZR (Zpos (Qden T)));
    [|apply Rmult_integral_contrapositive; split; lra].
  replace (IZR (Qnum T) * / IZR (Zpos (Qden T)) * (powerRZ 2 k * IZR (Zpos (Qden T))))
    with (IZR (Qnum T) * powerRZ 2 k) by (field; auto). rewrite E. field. lra.
Qed.
Lemma double_sound T m k : double T m k = true ->
  Q2R T = IZR m / powerRZ 2 k /\ is_double (Q2R T) /\ (0 <= m < 2 ^ 53)%Z /\ (0 <= k <= 1074)%Z.
Proof.
  unfold double. rewrite !andb_true_iff. intros [[[[N M0] M1] K0] K1].
  apply Z.leb_le in M0, K0, K1. apply Z.ltb_lt in M1. apply is_number_value in N; auto.
  split; [auto|]. split; [exists m, k; auto | lia].
Qed.
Theorem next_double_sound T U m k : next_double T U m k = true ->
  is_double (Q2R T) /\ is_double (Q2R U) /\ 0 <= Q2R T < Q2R U /\ (forall x, is_double x -> ~ Q2R T < x < Q2R U).
Proof.
  unfold next_double. rewrite !andb_true_iff. intros [[D N] F].
  destruct (double_sound T m k D) as (ET & DT & M & K). apply is_number_value in N; [|lia].
  pose proof (power_positive k) as P. rewrite plus_IZR in N. split; [auto|]. split; [|split].
  - destruct (Z.eq_dec (m + 1) (2 ^ 53)) as [E|E].
    + (* U = 2^53 / 2^k = 2^52 / 2^(k - 1) *)
      exists (2 ^ 52)%Z, (k - 1)%Z. split; [split; [discriminate | reflexivity]|]. split; [lia|].
      rewrite N, <- plus_IZR, E. unfold Z.sub. rewrite powerRZ_add by lra.
      replace (powerRZ 2 (- (1))) with (/ 2) by (simpl; field).
      change (2 ^ 53)%Z with (2 ^ 52 * 2)%Z. rewrite mult_IZR. field. lra.
    + exists (m + 1)%Z, k. split; [lia|]. split; [lia|]. now rewrite plus_IZR.
  - rewrite N, ET. assert (0 <= IZR m) by (apply IZR_le; lia). assert (0 < / powerRZ 2 k) by now apply Rinv_0_lt_compat.
    unfold Rdiv. split; [apply Rmult_le_pos; lra | apply Rmult_lt_compat_r; lra].
  - intros x (m' & k' & M' & K' & ->) [L1 L2]. rewrite ET in L1. rewrite N in L2.
    pose proof (power_positive k') as P'.
    assert (A1 : IZR m * powerRZ 2 (k' - k) < IZR m').
    { unfold Z.sub. rewrite powerRZ_add, power_opp by lra.
      apply Rmult_lt_reg_r with (/ powerRZ 2 k'); [now apply Rinv_0_lt_compat|].
      replace (IZR m * (powerRZ 2 k' * / powerRZ 2 k) * / powerRZ 2 k') with (IZR m / powerRZ 2 k) by (field; lra).
      exact L1. }
    assert (A2 : IZR m' < (IZR m + 1) * powerRZ 2 (k' - k)).
    { unfold Z.sub. rewrite powerRZ_add, power_opp by lra.
      apply Rmult_lt_reg_r with (/ powerRZ 2 k'); [now apply Rinv_0_lt_compat|].
      replace ((IZR m + 1) * (powerRZ 2 k' * / powerRZ 2 k) * / powerRZ 2 k') with ((IZR m + 1) / powerRZ 2 k)
        by (field; lra). exact L2. }
    destruct (Z_le_gt_dec k' k) as [C|C].
    + set (d := (k - k')%Z). replace (k' - k)%Z with (- d)%Z in A1, A2 by (unfold d; lia).
      pose proof (power_positive d) as Pd. rewrite power_opp in A1, A2.
      assert (B1 : IZR m < IZR m' * powerRZ 2 d).
      { apply Rmult_lt_reg_r with (/ powerRZ 2 d); [now apply Rinv_0_lt_compat|].
        replace (IZR m' * powerRZ 2 d * / powerRZ 2 d) with (IZR m') by (field; lra). exact A1. }
      assert (B2 : IZR m' * powerRZ 2 d < IZR m + 1).
      { apply Rmult_lt_reg_r with (/ powerRZ 2 d); [now apply Rinv_0_lt_compat|].
        replace (IZR m' * powerRZ 2 d * / powerRZ 2 d) with (IZR m') by (field; lra). exact A2. }
      rewrite power_IZR, <- mult_IZR in B1, B2 by (unfold d; lia). rewrite <- plus_IZR in B2.
      apply lt_IZR in B1, B2. lia.
    + apply orb_true_iff in F as [F|F]; [|apply Z.eqb_eq in F; lia]. apply Z.leb_le in F.
      rewrite power_IZR, <- mult_IZR in A1 by lia. apply lt_IZR in A1.
      assert (2 ^ 1 <= 2 ^ (k' - k))%Z by (apply Z.pow_le_mono_r; lia). change (2 ^ 1)%Z with 2%Z in H.
      assert (2 ^ 52 * 2 <= m * 2 ^ (k' - k))%Z by (apply Z.mul_le_mono_nonneg; lia).
      change (2 ^ 52 * 2)%Z with (2 ^ 53)%Z in *. lia.
Qed.
