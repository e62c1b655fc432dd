(* Trees of boxes over the elements of a mesh, and the pairs of elements whose boxes are near. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Geometry Checker Boxes.
Import ListNotations.
Open Scope R_scope.

(* What is known of some vertices: a box, whether all are fixed, the body that all are on, and the group that all are
   in, if that is ignored with itself. *)
Record summary := Summary { extent : box; still : bool; carrier : option Z; kin : option Z }.
Definition same (a b : option Z) : bool := match a, b with Some m, Some n => Z.eqb m n | _, _ => false end.
Definition common (a b : option Z) : option Z := if same a b then a else None.
Definition join (a b : summary) : summary :=
  Summary (join_boxes (extent a) (extent b)) (still a && still b) (common (carrier a) (carrier b))
    (common (kin a) (kin b)).
(* Nothing in them moves against the other or is asked, or their boxes are far from each other. *)
Definition idle (a b : summary) : bool :=
  still a && still b || same (carrier a) (carrier b) || same (kin a) (kin b).
Definition skip (a b : summary) : bool := far (extent a) (extent b) || idle a b.

(* The elements in the order of a list, two by two. *)
Inductive tree := Leaf (s : summary) (e : simplex) | Node (s : summary) (l r : tree).
Definition root_of (t : tree) : summary := match t with Leaf s _ => s | Node s _ _ => s end.
Definition node (l r : tree) : tree := Node (join (root_of l) (root_of r)) l r.
Fixpoint pair_up (l paired : list tree) : list tree :=
  match l with a :: b :: l' => pair_up l' (node a b :: paired) | a :: [] => a :: paired | [] => paired end.
Fixpoint build (fuel : list tree) (a : tree) (l : list tree) : tree :=
  match l, fuel with
  | [], _ => a
  | b :: l', _ :: fuel' => build fuel' (node a b) (pair_up l' [])
  | _, [] => fold_left node l a
  end.

(* Two leaves of which none is skipped; added to a list. *)
Definition pairs := list (simplex * simplex).
Fixpoint one (s : summary) (e : simplex) (b : tree) (found : pairs) : pairs :=
  if skip s (root_of b) then found
  else match b with Leaf _ f => (e, f) :: found | Node _ l r => one s e l (one s e r found) end.
Fixpoint across (a b : tree) (found : pairs) : pairs :=
  if skip (root_of a) (root_of b) then found
  else match a, b with
       | Leaf s e, _ => one s e b found
       | Node _ l r, Leaf _ _ => across l b (across r b found)
       | Node _ l r, Node _ l' r' => across l l' (across l r' (across r l' (across r r' found)))
       end.
Fixpoint among (t : tree) (found : pairs) : pairs :=
  match t with
  | Leaf _ _ => found
  | Node s l r => if idle s s then found else among l (among r (across l r found))
  end.

Section A_step.
Variables (m : mesh) (corner_of : Z -> corner) (U g : Z).

(* A summary is true of a vertex, and a tree of the vertices of its elements. *)
Definition is_of (s : summary) (v : Z) : Prop :=
  (forall t, 0 <= t <= 1 -> inside_box U g (extent s) (position (corner_of v) t))
  /\ (still s = true -> fixed m v = true) /\ (forall n, carrier s = Some n -> exists x y, corner_of v = On_body n x y)
  /\ (forall n, kin s = Some n -> group m v = n /\ ignored m n n = true).
Lemma same_sound a b : same a b = true -> exists n, a = Some n /\ b = Some n.
Proof. destruct a as [k|], b as [n|]; try discriminate. intros E. apply Z.eqb_eq in E. subst k. eauto. Qed.
Lemma same_sym a b : same a b = same b a.
Proof. destruct a, b; auto. apply Z.eqb_sym. Qed.
Lemma common_both a b n : common a b = Some n -> a = Some n /\ b = Some n.
Proof.
  unfold common. destruct (same a b) eqn:E; [|discriminate]. intros ->.
  destruct (same_sound _ _ E) as (k & [= ->] & K). now split.
Qed.
Lemma is_of_join a b v : is_of a v \/ is_of b v -> is_of (join a b) v.
Proof.
  intros H. unfold is_of, join; cbn [extent still carrier kin]. split; [|split; [|split]].
  - intros t T. apply inside_join. destruct H as [(H & _)|(H & _)]; auto.
  - rewrite andb_true_iff. intros [A B]. destruct H as [(_ & H & _)|(_ & H & _)]; auto.
  - intros n C. apply common_both in C as [A B]. destruct H as [(_ & _ & H & _)|(_ & _ & H & _)]; now apply H.
  - intros n C. apply common_both in C as [A B]. destruct H as [(_ & _ & _ & H)|(_ & _ & _ & H)]; now apply H.
Qed.
Inductive is_in (e : simplex) : tree -> Prop :=
  | at_leaf s : is_in e (Leaf s e)
  | on_left s l r : is_in e l -> is_in e (Node s l r)
  | on_right s l r : is_in e r -> is_in e (Node s l r).
Fixpoint fits (t : tree) : Prop :=
  (forall e v, is_in e t -> In v (vertices e) -> is_of (root_of t) v)
  /\ match t with Leaf _ _ => True | Node _ l r => fits l /\ fits r end.
Lemma fits_root t : fits t -> forall e v, is_in e t -> In v (vertices e) -> is_of (root_of t) v.
Proof. destruct t; simpl; tauto. Qed.
Lemma fits_node l r : fits l -> fits r -> fits (node l r).
Proof.
  intros L R. split; [|tauto]. intros e v I V. apply is_of_join.
  inversion I; subst; [left | right]; eapply fits_root; eauto.
Qed.

(* The tree has all of the elements that its leaves have. *)
Lemma pair_up_fits l paired : Forall fits l -> Forall fits paired -> Forall fits (pair_up l paired)
  /\ forall e t, In t l \/ In t paired -> is_in e t -> exists t', In t' (pair_up l paired) /\ is_in e t'.
Proof.
  assert (K : forall n l paired, (length l <= n)%nat -> Forall fits l -> Forall fits paired ->
    Forall fits (pair_up l paired)
    /\ forall e t, In t l \/ In t paired -> is_in e t -> exists t', In t' (pair_up l paired) /\ is_in e t');
    [|now apply (K (length l))].
  clear l paired. induction n as [|n IH]; intros l paired L F P.
  - destruct l; [split; [auto | intros e t [[]|I]; eauto] | simpl in L; lia].
  - destruct l as [|a [|b l]].
    + split; [auto | intros e t [[]|I]; eauto].
    + inversion F; subst. split; [constructor; auto|]. intros e t [[<-|[]]|I] J; simpl; eauto.
    + inversion F as [|? ? A F']; subst. inversion F' as [|? ? B F'']; subst. simpl in L.
      destruct (IH l (node a b :: paired) ltac:(lia) F'' ltac:(constructor; auto using fits_node)) as [G H].
      split; [auto|]. intros e t I J.
      assert (N : is_in e a \/ is_in e b -> is_in e (node a b)) by (intros [X|X]; constructor; auto).
      destruct I as [[<-|[<-|I]]|I]; [apply (H e (node a b)) | apply (H e (node a b)) | apply (H e t) | apply (H e t)];
        simpl; auto.
Qed.
Lemma build_fits fuel : forall a l, fits a -> Forall fits l -> fits (build fuel a l)
  /\ forall e t, In t (a :: l) -> is_in e t -> is_in e (build fuel a l).
Proof.
  assert (K : forall l a, fits a -> Forall fits l -> fits (fold_left node l a)
    /\ forall e t, In t (a :: l) -> is_in e t -> is_in e (fold_left node l a)).
  { induction l as [|b l IH]; intros a A F; simpl.
    - split; [auto|]. intros e t [<-|[]] J; auto.
    - inversion F as [|? ? B F']; subst. destruct (IH (node a b) (fits_node _ _ A B) F') as [G H]. split; [auto|].
      intros e t [<-|[<-|I]] J.
      + apply (H e (node a b)); [now left | now apply on_left].
      + apply (H e (node a b)); [now left | now apply on_right].
      + apply (H e t); [now right | auto]. }
  induction fuel as [|x fuel IH]; intros a l A F; destruct l as [|b l].
  - simpl. split; [auto|]. intros e t [<-|[]] J; auto.
  - apply K; auto.
  - simpl. split; [auto|]. intros e t [<-|[]] J; auto.
  - inversion F as [|? ? B F']; subst. destruct (pair_up_fits l [] F' ltac:(constructor)) as [P Q].
    simpl build.
    destruct (IH (node a b) (pair_up l []) (fits_node _ _ A B) P) as [G H]. split; [auto|].
    intros e t [<-|[<-|I]] J.
    + apply (H e (node a b)); [now left | now apply on_left].
    + apply (H e (node a b)); [now left | now apply on_right].
    + destruct (Q e t (or_introl I) J) as (t' & I' & J'). apply (H e t'); [now right | auto].
Qed.

(* Two elements that are skipped: what is asked of them holds without a proof. *)
Definition skipped (a b : simplex) : Prop := exists s s',
  (forall v, In v (vertices a) -> is_of s v) /\ (forall v, In v (vertices b) -> is_of s' v) /\ skip s s' = true.
Lemma skipped_sym a b : skipped a b -> skipped b a.
Proof.
  intros (s & s' & A & B & S). exists s', s. split; [auto|]. split; [auto|].
  unfold skip, idle, far in *. rewrite (same_sym (carrier s')), (same_sym (kin s')).
  rewrite !orb_true_iff, !andb_true_iff in *. tauto.
Qed.
Lemma skipped_no_contact a b s : 0 < IZR U -> IZR U * size s <= IZR g ->
  skipped a b -> can_meet m corner_of a b ->
  holds (Query (map corner_of (vertices a)) (map corner_of (vertices b)) s) No_contact.
Proof.
  intros P G (x & y & A & B & S) (_ & moves & turns & asked). unfold skip, idle in S.
  rewrite !orb_true_iff, andb_true_iff in S. destruct S as [F|[[[S S']|C]|K]].
  - intros t T. apply far_no_contact with (extent x) (extent y) U g; auto; simpl; intros c I;
      apply in_map_iff in I as (v & <- & I); [apply (A v I) | apply (B v I)]; auto.
  - exfalso. apply moves. intros v I. apply in_app_or in I as [I|I]; [apply (A v I) | apply (B v I)]; auto.
  - exfalso. destruct (same_sound _ _ C) as (n & E & E'). apply turns. exists n.
    intros v I. apply in_app_or in I as [I|I]; [apply (A v I) | apply (B v I)]; auto.
  - exfalso. destruct (same_sound _ _ K) as (n & E & E'), asked as (v & w & I & J & N).
    destruct (A v I) as (_ & _ & _ & V), (B w J) as (_ & _ & _ & W).
    destruct (V n E) as [X Y], (W n E') as [X' _]. congruence.
Qed.

Lemma root_skipped a b : fits a -> fits b -> skip (root_of a) (root_of b) = true ->
  forall e f, is_in e a -> is_in f b -> skipped e f.
Proof.
  intros A B S e f I J. exists (root_of a), (root_of b). split; [|split; [|exact S]]; intros v V.
  - now apply (fits_root a A e).
  - now apply (fits_root b B f).
Qed.
Lemma one_all s e b : forall found, (forall v, In v (vertices e) -> is_of s v) -> fits b ->
  incl found (one s e b found) /\ forall f, is_in f b -> In (e, f) (one s e b found) \/ skipped e f.
Proof.
  intros found E F. revert found.
  assert (A : fits (Leaf s e)) by (split; [intros e' v I; inversion I; subst; auto | auto]).
  induction b as [s' f'|s' l IHl r IHr]; intros found; simpl.
  - destruct (skip s s') eqn:S.
    + split; [apply incl_refl|]. intros f I. right. apply (root_skipped (Leaf s e) _ A F S); [constructor | auto].
    + split; [apply incl_tl, incl_refl|]. intros f I. inversion I; subst. left. now left.
  - destruct (skip s s') eqn:S.
    + split; [apply incl_refl|]. intros f I. right. apply (root_skipped (Leaf s e) _ A F S); [constructor | auto].
    + destruct F as (_ & L & R). destruct (IHr R found) as [KR HR]. destruct (IHl L (one s e r found)) as [KL HL].
      split; [eapply incl_tran; eauto|]. intros f I. inversion I; subst; [auto|].
      destruct (HR f ltac:(auto)); auto.
Qed.
Lemma across_all a : forall b found, fits a -> fits b -> incl found (across a b found)
  /\ forall e f, is_in e a -> is_in f b -> In (e, f) (across a b found) \/ skipped e f.
Proof.
  induction a as [s e'|s l IHl r IHr]; intros b found A B; pose proof (root_skipped _ _ A B) as H0; cbn [root_of] in H0.
  - simpl. destruct (skip s (root_of b)) eqn:S; [split; [apply incl_refl | right; now apply H0]|].
    destruct (one_all s e' b found) as [K H]; [intros v V; apply (fits_root _ A e'); [constructor | auto] | auto |].
    split; [auto|]. intros e f I J. inversion I; subst. auto.
  - destruct (skip s (root_of b)) eqn:S.
    + replace (across (Node s l r) b found) with found by (simpl; now rewrite S).
      split; [apply incl_refl | right; now apply H0].
    + destruct A as (_ & L & R). destruct b as [s' f'|s' l' r'].
      * replace (across (Node s l r) (Leaf s' f') found) with (across l (Leaf s' f') (across r (Leaf s' f') found))
          by (simpl in *; now rewrite S).
        set (b := Leaf s' f') in *. destruct (IHr b found R B) as [KR HR].
        destruct (IHl b (across r b found) L B) as [KL HL]. split; [eapply incl_tran; eauto|].
        intros e f I J. inversion I; subst; [auto|]. destruct (HR e f ltac:(auto) J); auto.
      * replace (across (Node s l r) (Node s' l' r') found)
          with (across l l' (across l r' (across r l' (across r r' found)))) by (simpl in *; now rewrite S).
        destruct B as (_ & L' & R').
        destruct (IHr r' found R R') as [K1 H1]. set (f1 := across r r' found) in *.
        destruct (IHr l' f1 R L') as [K2 H2]. set (f2 := across r l' f1) in *.
        destruct (IHl r' f2 L R') as [K3 H3]. set (f3 := across l r' f2) in *.
        destruct (IHl l' f3 L L') as [K4 H4].
        split; [repeat (eapply incl_tran; [eassumption|]); apply incl_refl|].
        intros e f I J. inversion I; subst; inversion J; subst.
        -- auto.
        -- destruct (H3 e f); auto.
        -- destruct (H2 e f); auto.
        -- destruct (H1 e f); auto.
Qed.
Lemma among_all t : forall found, fits t -> incl found (among t found)
  /\ forall e f, is_in e t -> is_in f t ->
      e = f \/ In (e, f) (among t found) \/ In (f, e) (among t found) \/ skipped e f.
Proof.
  induction t as [s e'|s l IHl r IHr]; intros found F; simpl.
  - split; [apply incl_refl|]. intros e f I J. inversion I; inversion J; subst. now left.
  - destruct (idle s s) eqn:S.
    + split; [apply incl_refl|]. intros e f I J. do 3 right. apply (root_skipped _ _ F F); auto.
      unfold skip; cbn [root_of]. rewrite S. apply orb_true_r.
    + destruct F as (_ & L & R). destruct (across_all l r found L R) as [K1 H1].
      set (f1 := across l r found) in *. destruct (IHr f1 R) as [K2 H2]. set (f2 := among r f1) in *.
      destruct (IHl f2 L) as [K3 H3]. split; [repeat (eapply incl_tran; [eassumption|]); apply incl_refl|].
      intros e f I J. inversion I; subst; inversion J; subst.
      * auto.
      * destruct (H1 e f); auto 6.
      * destruct (H1 f e); auto 6. do 3 right. now apply skipped_sym.
      * destruct (H2 e f) as [|[|[|]]]; auto 6.
Qed.
End A_step.
