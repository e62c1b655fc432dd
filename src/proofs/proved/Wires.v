(* Which points are alone, and which wires are joined: of a mesh, once for all of its steps. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith List Bool FMapAVL FMapFacts OrderedTypeEx.
From Touchstone Require Import Statement.
Import ListNotations.

Module M := FMapAVL.Make Z_as_OT.
Module F := FMapFacts.WFacts_fun Z_as_OT M.

(* The second ones of pairs by the first ones. *)
Definition graph := M.t (list Z).
Definition seconds (g : graph) (v : Z) : list Z := match M.find v g with Some l => l | None => [] end.
Definition link (g : graph) (p : Z * Z) : graph := M.add (fst p) (snd p :: seconds g (fst p)) g.
Lemma link_seconds g p v w : In w (seconds (link g p) v) <-> In w (seconds g v) \/ p = (v, w).
Proof.
  destruct p as [a b]. unfold link, seconds at 1; cbn [fst snd]. rewrite F.add_o.
  destruct (Z_as_OT.eq_dec a v) as [E|E].
  - cbv in E. subst v. simpl. split; [intros [->|I]; auto | intros [I|[= ->]]; auto].
  - fold (seconds g v). split; [auto|]. intros [I|[= -> ->]]; [auto | now contradiction E].
Qed.
(* All pairs of vertices of some elements. *)
Definition link_all (g : graph) (e : simplex) : graph := fold_left link (list_prod (vertices e) (vertices e)) g.
Definition neighbours (l : list simplex) : graph :=
  fold_left link_all l (M.empty _).
Lemma neighbours_seconds l v w :
  In w (seconds (neighbours l) v) <-> exists e, In e l /\ In v (vertices e) /\ In w (vertices e).
Proof.
  assert (L : forall l g, In w (seconds (fold_left link l g) v) <-> In w (seconds g v) \/ In (v, w) l).
  { clear l. induction l as [|p l IH]; intros g; simpl; [tauto|]. rewrite IH, link_seconds. tauto. }
  assert (K : forall l g, In w (seconds (fold_left link_all l g) v)
    <-> In w (seconds g v) \/ exists e, In e l /\ In v (vertices e) /\ In w (vertices e)).
  { clear l. induction l as [|e l IH]; intros g; simpl; [firstorder|]. rewrite IH. unfold link_all.
    rewrite L, in_prod_iff.
    split.
    - intros [[I|I]|(x & I)]; [now left | right; exists e; tauto | right; exists x; tauto].
    - intros [I|(x & [<-|I] & J)]; [now left; left | now left; right | right; exists x; tauto]. }
  unfold neighbours. rewrite K. unfold seconds at 1. rewrite F.empty_o. simpl. tauto.
Qed.

(* Those that pass a test, in the opposite order. *)
Definition kept {A} (test : A -> bool) (l : list A) : list A :=
  fold_left (fun found a => if test a then a :: found else found) l [].
Lemma kept_in {A} test l (a : A) : In a (kept test l) <-> In a l /\ test a = true.
Proof.
  assert (K : forall found, In a (fold_left (fun found a => if test a then a :: found else found) l found)
    <-> In a found \/ In a l /\ test a = true).
  { induction l as [|b l IH]; intros found; simpl; [tauto|]. rewrite IH.
    destruct (test b) eqn:E; simpl; intuition (subst; auto; congruence). }
  unfold kept. rewrite K. simpl. tauto.
Qed.

Definition mem (v : Z) (l : list Z) : bool := existsb (Z.eqb v) l.
Lemma mem_in v l : mem v l = true <-> In v l.
Proof.
  unfold mem. rewrite existsb_exists. split.
  - intros (w & I & E). apply Z.eqb_eq in E. now subst w.
  - intros I. exists v. split; [auto | apply Z.eqb_refl].
Qed.
Definition is_nil (l : list Z) : bool := match l with [] => true | _ => false end.
Definition all_of (test : list Z -> bool) (g : graph) (p : simplex) : bool :=
  match vertices p with v :: _ => test (seconds g v) | [] => true end.
Definition is_wire (sides : graph) (e : simplex) : bool :=
  match vertices e with [v; w] => negb (mem w (seconds sides v)) | _ => true end.

(* Points of no edge, wires, points of wires, and the vertices that wires join. *)
Record wiring := Wiring { alone : list simplex; wires : list simplex; ends : list simplex; joins : graph }.
Definition wiring_of (m : mesh) : wiring :=
  let used := neighbours (edges m) in
  let sides := neighbours (faces m) in
  let wires := kept (is_wire sides) (edges m) in
  let joins := neighbours wires in
  Wiring (kept (all_of is_nil used) (points m)) wires (kept (all_of (fun l => negb (is_nil l)) joins) (points m)) joins.
Definition are_joined (w : wiring) (a b : simplex) : bool :=
  match vertices a with [] => true | v :: _ => existsb (fun x => mem x (vertices b)) (seconds (joins w) v) end.

Lemma alone_complete m p : lone m p -> In p (alone (wiring_of m)).
Proof.
  intros [I L]. apply kept_in. split; [auto|]. unfold all_of.
  destruct (vertices p) as [|v l] eqn:V; [auto|].
  destruct (seconds (neighbours (edges m)) v) as [|w s] eqn:S; [auto|].
  exfalso. assert (J : In w (seconds (neighbours (edges m)) v)) by (rewrite S; now left).
  apply neighbours_seconds in J as (e & E & J & _). apply (L e E v); [rewrite V; now left | auto].
Qed.
Lemma wires_complete m e : wire m e -> In e (wires (wiring_of m)).
Proof.
  intros [I W]. apply kept_in. split; [auto|]. unfold is_wire.
  destruct (vertices e) as [|v [|w [|]]] eqn:V; auto. apply negb_true_iff.
  destruct (mem w (seconds (neighbours (faces m)) v)) eqn:E; [|auto]. exfalso.
  apply mem_in, neighbours_seconds in E as (f & F & J & K). apply (W f F).
  intros x [<-|[<-|[]]]; auto.
Qed.
Lemma fold_complete m a b : are_pair m Fold a b ->
  In a (ends (wiring_of m)) /\ In b (wires (wiring_of m)) /\ are_joined (wiring_of m) a b = true.
Proof.
  intros (A & B & c & v & C & L & V). apply wires_complete in C.
  assert (J : forall p, In p (vertices a) -> In v (seconds (joins (wiring_of m)) p)).
  { intros p I. apply neighbours_seconds. exists c. split; [auto|]. split; apply L; [now right | now left]. }
  split; [|split; [now apply wires_complete|]].
  - apply kept_in. split; [auto|]. unfold all_of. destruct (vertices a) as [|p l]; [auto|].
    specialize (J p (or_introl eq_refl)). unfold wiring_of in J; cbn [joins] in J.
    destruct (seconds _ p); [destruct J | auto].
  - unfold are_joined. destruct (vertices a) as [|p l]; [auto|]. apply existsb_exists. exists v.
    split; [apply J; now left | now apply mem_in].
Qed.
