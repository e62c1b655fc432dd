(* Polynomials with integer coefficients, and the signs of their values. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith Reals Lra Lia List Bool.
Import ListNotations.
Open Scope R_scope.

(* The constant coefficient comes first. *)
Definition poly := list Z.
Fixpoint ev (p : poly) (t : R) : R := match p with [] => 0 | c :: p' => IZR c + t * ev p' t end.

Fixpoint padd (p q : poly) : poly :=
  match p, q with [], _ => q | _, [] => p | a :: p', b :: q' => (a + b)%Z :: padd p' q' end.
Definition pscale (k : Z) (p : poly) : poly := map (fun a => a * k)%Z p.
Definition popp (p : poly) : poly := map Z.opp p.
Fixpoint psub (p q : poly) : poly :=
  match p, q with [], _ => popp q | _, [] => p | a :: p', b :: q' => (a - b)%Z :: psub p' q' end.
(* k p + q *)
Fixpoint padd_scaled (k : Z) (p q : poly) : poly :=
  match p, q with
  | [], _ => q
  | _, [] => pscale k p
  | a :: p', b :: q' => (a * k + b)%Z :: padd_scaled k p' q'
  end.
Fixpoint pmul (p q : poly) : poly :=
  match p, q with a :: p', b :: q' => (a * b)%Z :: padd_scaled a q' (pmul p' q) | _, _ => [] end.
(* As many coefficients as pmul p p, with half of its multiplications. *)
Fixpoint psquare (p : poly) : poly :=
  match p with [] => [] | [a] => [(a * a)%Z] | a :: p' => (a * a)%Z :: padd_scaled (2 * a) p' (0%Z :: psquare p') end.
Definition is_zero (p : poly) : bool := forallb (fun c => Z.eqb c 0) p.
Fixpoint equal (p q : poly) : bool :=
  match p, q with [], [] => true | a :: p', b :: q' => Z.eqb a b && equal p' q' | _, _ => false end.

Lemma ev_add p : forall q t, ev (padd p q) t = ev p t + ev q t.
Proof. induction p as [|a p IH]; destruct q; simpl; intros; try lra. rewrite plus_IZR, IH; lra. Qed.
Lemma ev_scale k p t : ev (pscale k p) t = IZR k * ev p t.
Proof. induction p as [|a p IH]; simpl; [lra|]. rewrite mult_IZR, IH; lra. Qed.
Lemma ev_opp p t : ev (popp p) t = - ev p t.
Proof. induction p as [|a p IH]; simpl; [lra|]. rewrite opp_IZR, IH; lra. Qed.
Lemma ev_sub p : forall q t, ev (psub p q) t = ev p t - ev q t.
Proof.
  induction p as [|a p IH]; destruct q; simpl; intros; rewrite ?opp_IZR, ?ev_opp; try lra.
  rewrite minus_IZR, IH; lra.
Qed.
Lemma ev_add_scaled k p : forall q t, ev (padd_scaled k p q) t = IZR k * ev p t + ev q t.
Proof.
  induction p as [|a p IH]; destruct q; simpl; intros; rewrite ?mult_IZR, ?ev_scale, ?plus_IZR, ?mult_IZR, ?IH; lra.
Qed.
Lemma ev_mul p : forall q t, ev (pmul p q) t = ev p t * ev q t.
Proof.
  induction p as [|a p IH]; destruct q; simpl; intros; try lra.
  rewrite mult_IZR, ev_add_scaled, IH; simpl; ring.
Qed.
Lemma is_zero_ev p t : is_zero p = true -> ev p t = 0.
Proof.
  induction p as [|c p IH]; simpl; [auto|]. rewrite andb_true_iff; intros [A B].
  apply Z.eqb_eq in A; subst c. rewrite (IH B). lra.
Qed.
Lemma equal_eq p : forall q, equal p q = true -> p = q.
Proof.
  induction p as [|a p IH]; destruct q; simpl; try discriminate; [auto|].
  rewrite andb_true_iff; intros [A B]. apply Z.eqb_eq in A. now rewrite A, (IH q B).
Qed.
Lemma ev_continuous p : continuity (ev p).
Proof.
  induction p as [|c p IH].
  - apply continuity_const. intros x y; reflexivity.
  - change (continuity (plus_fct (fct_cte (IZR c)) (mult_fct id (ev p)))).
    apply continuity_plus; [apply continuity_const; intros x y; reflexivity|].
    apply continuity_mult; [apply derivable_continuous, derivable_id | exact IH].
Qed.

(* Multiples of g. The quotient is computed from the highest coefficients on. It need not be right, because it is
   checked by a multiplication. It is right where g divides p and has no common factor, by Gauss's lemma. *)
Fixpoint quotient (steps p g : poly) : poly :=
  match steps, p, g with
  | _ :: steps', a :: p', b :: g' => let f := (a / b)%Z in f :: quotient steps' (padd_scaled (- f) g' p') g
  | _, _, _ => []
  end.
Definition multiple (p g : poly) : bool :=
  is_zero (psub p (pmul g (rev (quotient (skipn (length g - 1) p) (rev p) (rev g))))).
Lemma multiple_zero p g t : multiple p g = true -> ev g t = 0 -> ev p t = 0.
Proof. unfold multiple; intros M G. apply (is_zero_ev _ t) in M. rewrite ev_sub, ev_mul, G in M. lra. Qed.

(* The times from low / den to high / den. *)
Record span := Span { low : Z; high : Z; den : Z }.
Definition within (i : span) (t : R) : Prop := IZR (low i) <= t * IZR (den i) <= IZR (high i).

(* The Bernstein coefficients of p over a span, times positive numbers: coefficient i is C(d, i) den^d b_i, for d + 1
   coefficients. These are the coefficients of the polynomial den^d (1 + u)^d p(t) in u with t = (low + high u) / (den
   (1 + u)). Both it and den^d (1 + u)^d are computed by Horner's scheme. *)
Fixpoint times_line (a b carry : Z) (p : poly) : poly :=  (* (a + b u) p, and carry b *)
  match p with [] => [(b * carry)%Z] | c :: p' => (a * c + b * carry)%Z :: times_line a b c p' end.
Fixpoint bernstein_and_power (i : span) (p : poly) : poly * poly :=
  match p with
  | [] => ([], [1%Z])
  | [c] => ([c], [1%Z])
  | c :: p' =>
      let (b, power) := bernstein_and_power i p' in
      let power' := times_line (den i) (den i) 0 power in
      (padd_scaled c power' (times_line (low i) (high i) 0 b), power')
  end.
Definition bernstein (i : span) (p : poly) : poly := Datatypes.fst (bernstein_and_power i p).
Definition all_positive (b : poly) : bool := match b with [] => false | _ => forallb (Z.ltb 0) b end.
Definition first_positive (b : poly) : bool :=
  match b with [] => false | c :: b' => Z.ltb 0 c && forallb (Z.leb 0) b' end.
Definition none_negative (b : poly) : bool := forallb (Z.leb 0) b.

(* The sum of the p_i x^(d - i) y^i. *)
Fixpoint ev2 (p : poly) (x y : R) : R :=
  match p with [] => 0 | c :: p' => IZR c * x ^ length p' + y * ev2 p' x y end.
Lemma ev2_ev p x t : x * ev2 p x (x * t) = x ^ length p * ev p t.
Proof.
  induction p as [|c p IH]; simpl; [lra|].
  replace (x * (IZR c * x ^ length p + x * t * ev2 p x (x * t)))
    with (IZR c * (x * x ^ length p) + x * t * (x * ev2 p x (x * t))) by ring.
  rewrite IH; ring.
Qed.
Lemma ev_square p t : ev (psquare p) t = ev p t * ev p t.
Proof.
  induction p as [|a [|b p] IH]; [simpl; lra | simpl; rewrite mult_IZR; lra |].
  change (psquare (a :: b :: p)) with ((a * a)%Z :: padd_scaled (2 * a) (b :: p) (0%Z :: psquare (b :: p))).
  cbn [ev]. rewrite ev_add_scaled, !mult_IZR. cbn [ev]. cbn [ev] in IH. rewrite IH. ring.
Qed.
Lemma ev2_add_scaled k p : forall q x y, length p = length q ->
  ev2 (padd_scaled k p q) x y = IZR k * ev2 p x y + ev2 q x y /\ length (padd_scaled k p q) = length q.
Proof.
  induction p as [|a p IH]; destruct q; simpl; intros x y L; try discriminate; [split; [lra | reflexivity]|].
  injection L as L. destruct (IH q x y L) as [E N]. rewrite E, N, L, plus_IZR, mult_IZR. split; [ring | reflexivity].
Qed.
Lemma ev2_times_line a b p x y : forall carry,
  ev2 (times_line a b carry p) x y = IZR b * IZR carry * x ^ length p + (IZR a * x + IZR b * y) * ev2 p x y
  /\ length (times_line a b carry p) = S (length p).
Proof.
  induction p as [|c p IH]; simpl; intros carry; [rewrite mult_IZR; split; [ring | reflexivity]|].
  destruct (IH c) as [E N]. rewrite E, N, plus_IZR, !mult_IZR. split; [simpl; ring | reflexivity].
Qed.
Lemma bernstein_correct i p x y : p <> [] ->
  let u := IZR (den i) * (x + y) in let v := IZR (low i) * x + IZR (high i) * y in
  let (b, power) := bernstein_and_power i p in
  ev2 b x y = ev2 p u v /\ length b = length p /\ ev2 power x y = u ^ (length p - 1) /\ length power = length p.
Proof.
  intros NE u v; induction p as [|c p IH]; [contradiction|]. destruct p as [|c' p]; [simpl; repeat split; ring|].
  specialize (IH ltac:(discriminate)). change (bernstein_and_power i (c :: c' :: p)) with
    (let (b, power) := bernstein_and_power i (c' :: p) in
     let power' := times_line (den i) (den i) 0 power in
     (padd_scaled c power' (times_line (low i) (high i) 0 b), power')).
  destruct (bernstein_and_power i (c' :: p)) as [b power]. destruct IH as (Eb & Nb & Ew & Nw). cbv zeta.
  destruct (ev2_times_line (den i) (den i) power x y 0) as [E1 N1].
  destruct (ev2_times_line (low i) (high i) b x y 0) as [E2 N2].
  destruct (ev2_add_scaled c (times_line (den i) (den i) 0 power) (times_line (low i) (high i) 0 b) x y) as [E3 N3];
    [congruence|].
  rewrite E3, E1, E2, N1, N3, N2, Nb, Nw, Eb, Ew. simpl length.
  replace (S (S (length p)) - 1)%nat with (S (length p)) by lia. replace (S (length p) - 1)%nat with (length p) by lia.
  repeat split.
  - change (ev2 (c :: c' :: p) u v) with (IZR c * u ^ S (length p) + v * ev2 (c' :: p) u v).
    fold v. simpl pow. fold u. unfold u. ring.
  - simpl pow. unfold u. ring.
Qed.

(* Each time in a span is a mean of its ends. *)
Lemma weights_of_time i t : within i t ->
  exists x y, 0 <= x /\ 0 <= y /\ 0 < x + y /\ IZR (low i) * x + IZR (high i) * y = IZR (den i) * (x + y) * t
    /\ (t * IZR (den i) < IZR (high i) -> 0 < x).
Proof.
  intros [L H]. destruct (Req_dec (IZR (low i)) (IZR (high i))) as [E|N].
  - exists 1, 0. repeat split; lra.
  - exists (IZR (high i) - t * IZR (den i)), (t * IZR (den i) - IZR (low i)). repeat split; lra.
Qed.
Lemma bernstein_sign i p t x y : 0 < IZR (den i) -> 0 < x + y ->
  IZR (low i) * x + IZR (high i) * y = IZR (den i) * (x + y) * t ->
  exists k, 0 < k /\ k * ev2 (bernstein i p) x y = ev p t.
Proof.
  intros U S E. destruct p as [|c p]; [exists 1; simpl; lra|].
  pose proof (bernstein_correct i (c :: p) x y ltac:(discriminate)) as B. unfold bernstein. cbv zeta in B.
  destruct (bernstein_and_power i (c :: p)) as [b power]. destruct B as (B & _). simpl Datatypes.fst. rewrite B, E.
  set (u := IZR (den i) * (x + y)) in *. assert (0 < u) by (apply Rmult_lt_0_compat; lra).
  pose proof (ev2_ev (c :: p) u t) as F. assert (0 < u ^ length (c :: p)) by (apply pow_lt; lra).
  exists (u / u ^ length (c :: p)). split; [apply Rdiv_lt_0_compat; lra|].
  replace (u / u ^ length (c :: p) * ev2 (c :: p) u (u * t))
    with (u * ev2 (c :: p) u (u * t) / u ^ length (c :: p)) by (field; lra).
  rewrite F. field; lra.
Qed.

Lemma ev2_not_negative b x y : 0 <= x -> 0 <= y -> none_negative b = true -> 0 <= ev2 b x y.
Proof.
  intros X Y; induction b as [|c b IH]; simpl; [lra|]. rewrite andb_true_iff; intros [A B].
  apply Z.leb_le, IZR_le in A. specialize (IH B).
  assert (0 <= IZR c * x ^ length b) by (apply Rmult_le_pos; [lra | apply pow_le; lra]).
  assert (0 <= y * ev2 b x y) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma positive_none_negative b : forallb (Z.ltb 0) b = true -> none_negative b = true.
Proof.
  unfold none_negative. rewrite !forallb_forall. intros H c I. apply Z.leb_le.
  specialize (H c I). apply Z.ltb_lt in H. lia.
Qed.
Lemma ev2_positive b x y : 0 <= x -> 0 <= y -> 0 < x + y -> all_positive b = true -> 0 < ev2 b x y.
Proof.
  intros X Y S. destruct b as [|c b]; [discriminate|]. unfold all_positive. revert c.
  induction b as [|c' b IH]; intros c; cbn [forallb]; rewrite !andb_true_iff; intros H.
  - destruct H as [A _]. apply Z.ltb_lt, IZR_lt in A. simpl. lra.
  - destruct H as [A H]. apply Z.ltb_lt, IZR_lt in A. specialize (IH c'). cbn [forallb] in IH.
    rewrite andb_true_iff in IH. specialize (IH H).
    change (ev2 (c :: c' :: b) x y) with (IZR c * x ^ length (c' :: b) + y * ev2 (c' :: b) x y).
    destruct X as [X|<-].
    + assert (0 < IZR c * x ^ length (c' :: b)) by (apply Rmult_lt_0_compat; [lra | apply pow_lt; lra]).
      assert (0 <= y * ev2 (c' :: b) x y) by (apply Rmult_le_pos; lra). lra.
    + simpl length. rewrite pow_ne_zero by discriminate.
      assert (0 < y * ev2 (c' :: b) 0 y) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma ev2_first_positive b x y : 0 < x -> 0 <= y -> first_positive b = true -> 0 < ev2 b x y.
Proof.
  intros X Y. destruct b as [|c b]; [discriminate|]. simpl. rewrite andb_true_iff; intros [A B].
  apply Z.ltb_lt, IZR_lt in A. pose proof (ev2_not_negative b x y ltac:(lra) Y B).
  assert (0 < IZR c * x ^ length b) by (apply Rmult_lt_0_compat; [lra | apply pow_lt; lra]).
  assert (0 <= y * ev2 b x y) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem all_positive_sound i p t : 0 < IZR (den i) -> within i t ->
  all_positive (bernstein i p) = true -> 0 < ev p t.
Proof.
  intros U W B. destruct (weights_of_time i t W) as (x & y & X & Y & S & E & _).
  destruct (bernstein_sign i p t x y U S E) as (k & K & <-).
  apply Rmult_lt_0_compat; [lra | now apply ev2_positive].
Qed.
Theorem first_positive_sound i p t : 0 < IZR (den i) -> within i t -> t * IZR (den i) < IZR (high i) ->
  first_positive (bernstein i p) = true -> 0 < ev p t.
Proof.
  intros U W L B. destruct (weights_of_time i t W) as (x & y & X & Y & S & E & F).
  destruct (bernstein_sign i p t x y U S E) as (k & K & <-).
  apply Rmult_lt_0_compat; [lra | apply ev2_first_positive; auto].
Qed.
Theorem none_negative_sound i p t : 0 < IZR (den i) -> within i t ->
  none_negative (bernstein i p) = true -> 0 <= ev p t.
Proof.
  intros U W B. destruct (weights_of_time i t W) as (x & y & X & Y & S & E & _).
  destruct (bernstein_sign i p t x y U S E) as (k & K & <-).
  apply Rmult_le_pos; [lra | now apply ev2_not_negative].
Qed.

(* The value at m / u, times u^d, and u^(d + 1). *)
Fixpoint value_and_power (m u : Z) (p : poly) : Z * Z :=
  match p with
  | [] => (0%Z, 1%Z)
  | [c] => (c, u)
  | c :: p' => let (v, power) := value_and_power m u p' in ((c * power + m * v)%Z, (u * power)%Z)
  end.
Definition value_at (m u : Z) (p : poly) : Z := Datatypes.fst (value_and_power m u p).
Lemma value_sign m u p t : 0 < IZR u -> t * IZR u = IZR m -> exists k, 0 < k /\ k * IZR (value_at m u p) = ev p t.
Proof.
  intros U T. destruct p as [|c p]; [exists 1; unfold value_at; simpl; lra|].
  assert (E : let (v, power) := value_and_power m u (c :: p) in
    IZR u * IZR v = IZR u ^ length (c :: p) * ev (c :: p) t /\ IZR power = IZR u ^ length (c :: p)).
  { revert c; induction p as [|c' p IH]; intros c; [simpl; split; ring|].
    change (value_and_power m u (c :: c' :: p)) with
      (let (v, power) := value_and_power m u (c' :: p) in ((c * power + m * v)%Z, (u * power)%Z)).
    specialize (IH c'). destruct (value_and_power m u (c' :: p)) as [v power]. destruct IH as [E F].
    change (ev (c :: c' :: p) t) with (IZR c + t * ev (c' :: p) t).
    change (IZR u ^ length (c :: c' :: p)) with (IZR u * IZR u ^ length (c' :: p)).
    rewrite plus_IZR, !mult_IZR, F, <- T. split; [|ring].
    replace (IZR u * (IZR c * IZR u ^ length (c' :: p) + t * IZR u * IZR v))
      with (IZR u * IZR c * IZR u ^ length (c' :: p) + t * IZR u * (IZR u * IZR v)) by ring. rewrite E. ring. }
  unfold value_at. destruct (value_and_power m u (c :: p)) as [v power]. destruct E as [E _]. simpl Datatypes.fst.
  assert (0 < IZR u ^ length (c :: p)) by (apply pow_lt; lra).
  exists (IZR u / IZR u ^ length (c :: p)). split; [apply Rdiv_lt_0_compat; lra|].
  replace (IZR u / IZR u ^ length (c :: p) * IZR v) with (IZR u * IZR v / IZR u ^ length (c :: p)) by (field; lra).
  rewrite E. field; lra.
Qed.

(* A polynomial of this sign at a, and of the other one at b, has a root between them. *)
Lemma root_between p a b : a < b -> ev p a * ev p b < 0 -> exists t, a < t < b /\ ev p t = 0.
Proof.
  intros L N.
  assert (K : exists t, a <= t <= b /\ ev p t = 0).
  { destruct (Rlt_le_dec (ev p a) 0) as [S|S].
    - destruct (IVT (ev p) a b) as (z & Z & E); auto using ev_continuous; [nra | now exists z].
    - assert (0 < ev p a) by (destruct S as [S|S]; [lra | rewrite <- S in N; lra]).
      destruct (IVT (ev (popp p)) a b) as (z & Z & E); auto using ev_continuous; rewrite ?ev_opp in *; [lra | nra |].
      exists z; split; [auto | lra]. }
  destruct K as (t & T & E). exists t; split; [|auto].
  destruct (Req_dec t a) as [->|]; [rewrite E in N; lra|]. destruct (Req_dec t b) as [->|]; [rewrite E in N; lra|]. lra.
Qed.
Lemma keeps_sign p a b : a <= b -> 0 < ev p a -> (forall s, a <= s <= b -> ev p s <> 0) -> 0 < ev p b.
Proof.
  intros L A N. destruct (Rlt_le_dec 0 (ev p b)) as [|B]; [auto|]. exfalso.
  destruct (Req_dec (ev p b) 0) as [Z|Z]; [apply (N b); lra|].
  destruct L as [L| ->]; [|lra]. destruct (root_between p a b L) as (t & T & E); [nra|]. apply (N t); lra.
Qed.
Definition changes_sign (g : poly) (i : span) : bool :=
  Z.ltb (value_at (low i) (den i) g * value_at (high i) (den i) g) 0.
Theorem changes_sign_sound g i a b : 0 < IZR (den i) -> a * IZR (den i) = IZR (low i) ->
  b * IZR (den i) = IZR (high i) -> a < b -> changes_sign g i = true -> exists t, a < t < b /\ ev g t = 0.
Proof.
  unfold changes_sign; intros U A B L C. apply Z.ltb_lt, IZR_lt in C. rewrite mult_IZR in C.
  destruct (value_sign _ _ g a U A) as (k & K & E), (value_sign _ _ g b U B) as (l & M & F).
  apply root_between; auto. rewrite <- E, <- F.
  assert (0 < k * l) by (apply Rmult_lt_0_compat; lra).
  replace (k * IZR (value_at (low i) (den i) g) * (l * IZR (value_at (high i) (den i) g)))
    with (k * l * (IZR (value_at (low i) (den i) g) * IZR (value_at (high i) (den i) g))) by ring. nra.
Qed.
