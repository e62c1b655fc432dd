(* The corners of a query as integer polynomials. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Geometry Corners.
Import ListNotations.
Open Scope R_scope.

(* A rational number times u, which is a multiple of its denominator. *)
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

(* A coordinate of a curve, times u. *)
Definition curve (u : Z) (control : list Q) : poly :=
  match map (times_unit u) control with
  | [a] => [a]
  | [a; b] => [a; b - a]%Z
  | [a; b; c] => [a; 2 * (b - a); a - 2 * b + c]%Z
  | [a; b; c; d] => [a; 3 * (b - a); 3 * (a - 2 * b + c); d - a + 3 * (b - c)]%Z
  | _ => []
  end.
Definition curve_fits (u : Z) (control : list rational_point) : bool :=
  Nat.leb 1 (length control) && Nat.leb (length control) 4 && forallb (point_fits u) control.
Lemma curve_value u control t : curve_fits u control = true ->
  value (Vector (curve u (map qx control)) (curve u (map qy control)) (curve u (map qz control))) t
  = scale (IZR u) (position (On_curve control) t).
Proof.
  unfold curve_fits, point_fits. rewrite !andb_true_iff. intros [[L M] F].
  destruct control as [|a [|b [|c [|d [|]]]]]; try discriminate; simpl in F; rewrite ?andb_true_iff in F;
    apply point_eq; unfold curve, value, scale; simpl map; cbn [px py pz vx vy vz ev];
    repeat (rewrite ?plus_IZR, ?minus_IZR, ?mult_IZR); rewrite !times_unit_value by tauto; simpl; ring.
Qed.

(* A linear polynomial, times u. *)
Definition line (u : Z) (a b : Q) : poly := let x := times_unit u a in [x; (times_unit u b - x)%Z].
Lemma ev_line u a b t : is_multiple u a = true -> is_multiple u b = true ->
  ev (line u a b) t = IZR u * ((1 - t) * Q2R a + t * Q2R b).
Proof.
  intros A B. unfold line; simpl. rewrite minus_IZR, (times_unit_value u a A), (times_unit_value u b B). ring.
Qed.

(* A corner of a body: h is the unit of quaternions, and u that of coordinates. *)
Definition body_weight (h : Z) (m : motion) : poly * poly :=  (* s s and v . v *)
  let s := line h (s_0 m) (s_1 m) in
  let x := line h (qx (v_0 m)) (qx (v_1 m)) in
  let y := line h (qy (v_0 m)) (qy (v_1 m)) in
  let z := line h (qz (v_0 m)) (qz (v_1 m)) in
  (pmul s s, padd (padd (pmul x x) (pmul y y)) (pmul z z)).
Definition body_corner (u h : Z) (m : motion) (y : rational_point) : vector * poly :=
  let s := line h (s_0 m) (s_1 m) in
  let v1 := line h (qx (v_0 m)) (qx (v_1 m)) in
  let v2 := line h (qy (v_0 m)) (qy (v_1 m)) in
  let v3 := line h (qz (v_0 m)) (qz (v_1 m)) in
  let y1 := times_unit u (qx y) in
  let y2 := times_unit u (qy y) in
  let y3 := times_unit u (qz y) in
  let (ss, vv) := body_weight h m in
  let w := padd ss vv in
  let less := psub ss vv in
  let along := pscale 2 (padd (padd (pscale y1 v1) (pscale y2 v2)) (pscale y3 v3)) in
  let twice := pscale 2 s in
  let coordinate (y : Z) (v : poly) (turn : poly) (p0 p1 : Q) :=
    padd (padd (padd (pscale y less) (pmul along v)) (pmul twice turn)) (pmul w (line u p0 p1)) in
  (Vector (coordinate y1 v1 (psub (pscale y3 v2) (pscale y2 v3)) (qx (p_0 m)) (qx (p_1 m)))
          (coordinate y2 v2 (psub (pscale y1 v3) (pscale y3 v1)) (qy (p_0 m)) (qy (p_1 m)))
          (coordinate y3 v3 (psub (pscale y2 v1) (pscale y1 v2)) (qz (p_0 m)) (qz (p_1 m))),
   pscale u w).

(* The quaternion is not zero at any time in [0, 1]. *)
Definition turn_fits (h : Z) (m : motion) : bool :=
  Z.ltb 0 h && is_multiple h (s_0 m) && is_multiple h (s_1 m) && point_fits h (v_0 m) && point_fits h (v_1 m).
Definition turns (h : Z) (m : motion) : bool :=
  let s := times_unit h (s_0 m) in let s' := times_unit h (s_1 m) in
  let x := times_unit h (qx (v_0 m)) in let x' := times_unit h (qx (v_1 m)) in
  let y := times_unit h (qy (v_0 m)) in let y' := times_unit h (qy (v_1 m)) in
  let z := times_unit h (qz (v_0 m)) in let z' := times_unit h (qz (v_1 m)) in
  let product := (s * s' + x * x' + y * y' + z * z')%Z in
  turn_fits h m
  && (Z.ltb 0 product
      || negb (Z.eqb (product * product)
                 ((s * s + x * x + y * y + z * z) * (s' * s' + x' * x' + y' * y' + z' * z')))).
Lemma turn_not_zero (s x y z s' x' y' z' t : R) : 0 <= t <= 1 ->
  let product := s * s' + x * x' + y * y' + z * z' in
  0 < product \/ product * product <> (s * s + x * x + y * y + z * z) * (s' * s' + x' * x' + y' * y' + z' * z') ->
  let mix a b := (1 - t) * a + t * b in
  0 < mix s s' * mix s s' + (mix x x' * mix x x' + mix y y' * mix y y' + mix z z' * mix z z').
Proof.
  intros T product H mix.
  assert (Q : forall a, 0 <= a * a) by (intros; apply Rle_0_sqr).
  pose proof (Q (mix s s')) as S. pose proof (Q (mix x x')) as X. pose proof (Q (mix y y')) as Y.
  pose proof (Q (mix z z')) as Z.
  destruct (Rlt_le_dec 0 (mix s s' * mix s s' + (mix x x' * mix x x' + mix y y' * mix y y' + mix z z' * mix z z')))
    as [|N]; [auto|]. exfalso.
  assert (zero : forall a, a * a = 0 -> a = 0) by (intros a E; apply Rmult_integral in E; tauto).
  assert (ES : mix s s' = 0) by (apply zero; lra). assert (EX : mix x x' = 0) by (apply zero; lra).
  assert (EY : mix y y' = 0) by (apply zero; lra). assert (EZ : mix z z' = 0) by (apply zero; lra).
  unfold mix in ES, EX, EY, EZ. destruct (Req_dec t 0) as [->|T0].
  - assert (s = 0) by lra. assert (x = 0) by lra. assert (y = 0) by lra. assert (z = 0) by lra.
    unfold product in H. subst s x y z. destruct H as [H|H]; [lra | apply H; ring].
  - assert (K : forall a b, (1 - t) * a + t * b = 0 -> b = - ((1 - t) / t) * a).
    { intros a b E. apply Rmult_eq_reg_l with t; [|auto]. field_simplify; auto. lra. }
    apply K in ES, EX, EY, EZ. set (k := (1 - t) / t) in *. unfold product in H. subst s' x' y' z'.
    destruct H as [H|H]; [|apply H; ring].
    assert (0 <= k) by (unfold k; apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
    assert (0 <= k * (s * s + x * x + y * y + z * z)).
    { apply Rmult_le_pos; [lra|]. pose proof (Q s). pose proof (Q x). pose proof (Q y). pose proof (Q z). lra. }
    lra.
Qed.
Lemma turns_sound h m t : turns h m = true -> 0 <= t <= 1 ->
  let v := between (v_0 m) (v_1 m) t in
  let s := (1 - t) * Q2R (s_0 m) + t * Q2R (s_1 m) in 0 < s * s + dot v v.
Proof.
  unfold turns, turn_fits, point_fits. cbv zeta. rewrite !andb_true_iff, orb_true_iff, negb_true_iff. intros [F H] T.
  unfold between, plus, scale, dot, real; cbn [px py pz]. apply turn_not_zero; [exact T|].
  destruct F as [[[[U S0] S1] [[X0 Y0] Z0]] [[X1 Y1] Z1]]. apply Z.ltb_lt, IZR_lt in U.
  pose proof (times_unit_value _ _ S0) as E1. pose proof (times_unit_value _ _ S1) as E2.
  pose proof (times_unit_value _ _ X0) as E3. pose proof (times_unit_value _ _ X1) as E4.
  pose proof (times_unit_value _ _ Y0) as E5. pose proof (times_unit_value _ _ Y1) as E6.
  pose proof (times_unit_value _ _ Z0) as E7. pose proof (times_unit_value _ _ Z1) as E8.
  assert (HH : 0 < IZR h * IZR h) by (apply Rmult_lt_0_compat; lra).
  destruct H as [H|H].
  - left. apply Z.ltb_lt, IZR_lt in H. rewrite !plus_IZR, !mult_IZR, E1, E2, E3, E4, E5, E6, E7, E8 in H.
    apply Rmult_lt_reg_l with (IZR h * IZR h); [auto|]. lra.
  - right. intros E. apply Z.eqb_neq in H. apply H. apply eq_IZR.
    rewrite !mult_IZR, !plus_IZR, !mult_IZR, E1, E2, E3, E4, E5, E6, E7, E8.
    apply (f_equal (Rmult (IZR h * IZR h * (IZR h * IZR h)))) in E. lra.
Qed.

(* The units of coordinates and of quaternions fit a corner. All corners of a query are multiplied by u h h. *)
Definition corner_fits (u h : Z) (c : corner) : bool :=
  Z.ltb 0 u && Z.ltb 0 h
  && match c with
     | On_curve control => curve_fits (u * (h * h)) control
     | On_body _ m y => turns h m && point_fits u (p_0 m) && point_fits u (p_1 m) && point_fits u y
     end.
Definition moving_of (u h : Z) (c : corner) : moving :=
  match c with
  | On_curve control =>
      let k := (u * (h * h))%Z in
      Moving (Vector (curve k (map qx control)) (curve k (map qy control)) (curve k (map qz control))) [k] 0
  | On_body number m y => let (x, w) := body_corner u h m y in Moving x w number
  end.
Theorem moving_of_moves u h c : corner_fits u h c = true -> moves_as (moving_of u h c) c.
Proof.
  unfold corner_fits. rewrite !andb_true_iff. intros [[U V] F] t T. apply Z.ltb_lt, IZR_lt in U, V.
  destruct c as [control|number m y].
  - unfold moving_of. cbn [numerator weight]. rewrite (curve_value _ _ t F). simpl ev. rewrite !mult_IZR.
    assert (0 < IZR u * (IZR h * IZR h)) by (repeat apply Rmult_lt_0_compat; lra). split; [lra|].
    f_equal. ring.
  - rewrite !andb_true_iff in F. destruct F as [[[F P0] P1] PY]. pose proof (turns_sound h m t F T) as W. cbv zeta in W.
    unfold turns, turn_fits in F. cbv zeta in F. rewrite !andb_true_iff in F.
    destruct F as [[[[[_ S0] S1] V0] V1] _]. unfold point_fits in *. rewrite !andb_true_iff in *.
    unfold moving_of, body_corner, body_weight. cbn [numerator weight].
    assert (EW : forall a b, ev (pscale u (padd a b)) t = IZR u * (ev a t + ev b t))
      by (intros; now rewrite ev_scale, ev_add).
    set (s := (1 - t) * Q2R (s_0 m) + t * Q2R (s_1 m)) in *.
    set (x := (1 - t) * Q2R (qx (v_0 m)) + t * Q2R (qx (v_1 m))).
    set (y' := (1 - t) * Q2R (qy (v_0 m)) + t * Q2R (qy (v_1 m))).
    set (z := (1 - t) * Q2R (qz (v_0 m)) + t * Q2R (qz (v_1 m))).
    assert (EV : between (v_0 m) (v_1 m) t = Point x y' z) by reflexivity.
    unfold position. fold s. rewrite EV in W |- *. unfold dot in W; cbn [px py pz] in W.
    rewrite EW, ?ev_add, ?ev_mul, !ev_line by tauto. fold s x y' z.
    replace (IZR u * (IZR h * s * (IZR h * s)
      + (IZR h * x * (IZR h * x) + IZR h * y' * (IZR h * y') + IZR h * z * (IZR h * z))))
      with (IZR u * (IZR h * IZR h) * (s * s + (x * x + y' * y' + z * z))) by ring.
    set (k := IZR u * (IZR h * IZR h)). set (d := s * s + (x * x + y' * y' + z * z)).
    assert (0 < k) by (repeat apply Rmult_lt_0_compat; lra). assert (D : 0 < d) by (unfold d; lra).
    assert (times : forall a p, k * d * (/ d * a + p) = k * (a + d * p)) by (intros; field; lra).
    split; [now apply Rmult_lt_0_compat|].
    apply point_eq; unfold value, turned_by;
      cbn [px py pz vx vy vz plus scale dot cross between real];
      change (dot (Point x y' z) (Point x y' z)) with (x * x + y' * y' + z * z); fold d; rewrite times;
      repeat (rewrite ?ev_add, ?ev_sub, ?ev_mul, ?ev_scale, ?ev_line by tauto); fold s x y' z;
      rewrite !times_unit_value by tauto; unfold k, d, dot; clearbody s x y' z; cbn [px py pz real]; ring.
Qed.
