(* What an accepted proof says. Nothing else has to be read to know it, so docs/proved.md shows this file. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import QArith Qminmax Qreals Reals List. Import ListNotations. Open Scope R_scope.

Record point := Point { px : R; py : R; pz : R }.  (* of space; or a vector *)
Definition plus (a b : point) : point := Point (px a + px b) (py a + py b) (pz a + pz b).
Definition minus (a b : point) : point := Point (px a - px b) (py a - py b) (pz a - pz b).
Definition scale (k : R) (a : point) : point := Point (k * px a) (k * py a) (k * pz a).
Definition dot (a b : point) : R := px a * px b + py a * py b + pz a * pz b.
Definition cross (a b : point) : point :=
  Point (py a * pz b - pz a * py b) (pz a * px b - px a * pz b) (px a * py b - py a * px b).

(* Sums and means with weights, over points in the order of the weights. *)
Fixpoint total (weights : list R) : R := match weights with w :: rest => w + total rest | [] => 0 end.
Fixpoint weighted_sum (weights : list R) (points : list point) : point :=
  match weights, points with
  | w :: weights', a :: points' => plus (scale w a) (weighted_sum weights' points')
  | _, _ => Point 0 0 0
  end.

(* Points with rational coordinates. A corner is on a Bezier curve with one to four control points, straight if they are
   two, or at the point y of a body that turns and moves; its number decides nothing. *)
Record rational_point := Rational { qx : Q; qy : Q; qz : Q }.
Definition real (a : rational_point) : point := Point (Q2R (qx a)) (Q2R (qy a)) (Q2R (qz a)).
Record motion := Motion { s_0 : Q; v_0 : rational_point; s_1 : Q; v_1 : rational_point;  (* quaternions *)
                          p_0 : rational_point; p_1 : rational_point }.
Inductive corner := On_curve (control : list rational_point) | On_body (number : Z) (m : motion) (y : rational_point).
Definition between (a b : rational_point) (t : R) : point := plus (scale (1 - t) (real a)) (scale t (real b)).
Definition curve_weights (control : nat) (t : R) : list R :=
  match control with
  | 1%nat => [1] | 2%nat => [1 - t; t] | 3%nat => [(1 - t) ^ 2; 2 * (1 - t) * t; t ^ 2]
  | 4%nat => [(1 - t) ^ 3; 3 * (1 - t) ^ 2 * t; 3 * (1 - t) * t ^ 2; t ^ 3] | _ => []
  end.
Definition turned_by (s : R) (v y : point) : point := scale (/ (s * s + dot v v))
  (plus (scale (s * s - dot v v) y) (plus (scale (2 * dot v y) v) (scale (2 * s) (cross v y)))).
Definition position (c : corner) (t : R) : point :=
  match c with
  | On_curve control => weighted_sum (curve_weights (length control) t) (map real control)
  | On_body _ m y =>
      plus (turned_by ((1 - t) * Q2R (s_0 m) + t * Q2R (s_1 m)) (between (v_0 m) (v_1 m) t) (real y))
        (between (p_0 m) (p_1 m) t)
  end.

(* The convex hull of some points: their means, with weights that are not negative and have the sum 1. *)
Definition in_hull (points : list point) (x : point) : Prop :=
  exists weights, length weights = length points /\ (forall w, In w weights -> 0 <= w) /\ total weights = 1
    /\ x = weighted_sum weights points.

(* Two elements are in contact if a point of one and a point of the other are equal, or at most D apart. *)
Inductive separation := Zero | Euclidean (D : Q) | Max (D : Q).
Definition near (s : separation) (v : point) : Prop :=
  match s with Zero => v = Point 0 0 0 | Euclidean D => sqrt (dot v v) <= Q2R D
  | Max D => Rabs (px v) <= Q2R D /\ Rabs (py v) <= Q2R D /\ Rabs (pz v) <= Q2R D end.
Record query := Query { first : list corner; second : list corner; apart : separation }.
Definition element (corners : list corner) (t : R) : list point := map (fun c => position c t) corners.
Definition in_contact (q : query) (t : R) : Prop :=
  exists x y, in_hull (element (first q) t) x /\ in_hull (element (second q) t) y /\ near (apart q) (minus y x).

Definition is_double (x : R) : Prop :=  (* and not negative *)
  exists m k, (0 <= m < 2 ^ 53)%Z /\ (k <= 1074)%Z /\ x = IZR m / powerRZ 2 k.

Inductive answer := No_contact | Contact_at (T : Q) | Contact_between (T U : Q).
Definition holds (q : query) (a : answer) : Prop :=  (* what the answers mean *)
  match a with
  | No_contact => forall t, 0 <= t <= 1 -> ~ in_contact q t
  | Contact_at T =>
      is_double (Q2R T) /\ 0 <= Q2R T <= 1 /\ in_contact q (Q2R T) /\ forall t, 0 <= t < Q2R T -> ~ in_contact q t
  | Contact_between T U =>
      is_double (Q2R T) /\ is_double (Q2R U) /\ (forall x, is_double x -> ~ Q2R T < x < Q2R U)
      /\ 0 <= Q2R T < Q2R U /\ Q2R U <= 1 /\ (forall t, 0 <= t <= Q2R T -> ~ in_contact q t)
      /\ exists t, Q2R T < t < Q2R U /\ in_contact q t
  end.

(* One step of a motion of a mesh. `corner_of` gives the corner of each vertex, a number. Elements have an index among
   those of their sort. A wire is an edge of no face. In a fold another wire joins a point to a wire. A fold has the
   separation zero, other pairs have the one that is asked, or `most` if that is less. Vertices have groups. Nothing is
   asked of two elements if all groups of one are `ignored` with all groups of the other. *)
Record simplex := Simplex { index : Z; vertices : list Z }.
Record mesh := Mesh { points : list simplex; edges : list simplex; faces : list simplex; fixed : Z -> bool;
                      group : Z -> Z; ignored : Z -> Z -> bool; asked : simplex -> simplex -> separation; most : Q }.
Definition disjoint (a b : simplex) : Prop := forall v, In v (vertices a) -> ~ In v (vertices b).
Definition lone m p : Prop := In p (points m) /\ forall e, In e (edges m) -> disjoint p e.
Definition wire m e : Prop := In e (edges m) /\ forall f, In f (faces m) -> ~ incl (vertices e) (vertices f).
Inductive sort := Two_edges | Point_face | Point_edge | Two_points | Fold.
Definition are_pair (m : mesh) (s : sort) (a b : simplex) : Prop :=
  match s with
  | Two_edges => In a (edges m) /\ In b (edges m) /\ (index a < index b)%Z
  | Point_face => In a (points m) /\ In b (faces m)
  | Point_edge => lone m a /\ In b (edges m)
  | Two_points => lone m a /\ lone m b /\ (index a < index b)%Z
  | Fold => In a (points m) /\ wire m b
      /\ exists c v, wire m c /\ incl (v :: vertices a) (vertices c) /\ In v (vertices b)
  end.
Definition can_meet m (corner_of : Z -> corner) a b : Prop :=
  disjoint a b /\ ~ (forall v, In v (vertices a ++ vertices b) -> fixed m v = true)
  /\ (~ exists n, forall v, In v (vertices a ++ vertices b) -> exists x y, corner_of v = On_body n x y)
  /\ exists v w, In v (vertices a) /\ In w (vertices b) /\ ignored m (group m v) (group m w) = false.
Definition separation_of (m : mesh) (s : sort) (a b : simplex) : separation :=
  match s, asked m a b with
  | Fold, _ | _, Zero => Zero | _, Euclidean D => Euclidean (Qmin D (most m)) | _, Max D => Max (Qmin D (most m))
  end.
Definition query_of (m : mesh) (corner_of : Z -> corner) (s : sort) (a b : simplex) : query :=
  Query (map corner_of (vertices a)) (map corner_of (vertices b)) (separation_of m s a b).

(* The answers hold, and the pairs without an answer are not in contact. *)
Definition step_holds m corner_of (answers : list (sort * simplex * simplex * answer)) : Prop :=
  (forall s a b x, In (s, a, b, x) answers -> holds (query_of m corner_of s a b) x)
  /\ forall s a b, are_pair m s a b -> can_meet m corner_of a b ->
     (exists x, In (s, a, b, x) answers) \/ holds (query_of m corner_of s a b) No_contact.
