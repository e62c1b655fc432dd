(* The checker of a step of a motion, and the theorem. *)
(* SPDX-License-Identifier: MIT *)
From Coq Require Import ZArith QArith Qminmax Qreals Reals Lra Lia List Bool.
From Touchstone Require Import Statement Polynomials Geometry Checker Boxes Trees Wires.
Import ListNotations.
Open Scope R_scope.

(* Summaries of vertices, in a search tree, with the units of their corners. A wrong tree finds nothing. *)
Inductive lookup := Nothing | Entry (v u h : Z) (s : summary) (l r : lookup).
Fixpoint find (v : Z) (p : lookup) : option summary :=
  match p with
  | Nothing => None
  | Entry w _ _ s l r => match Z.compare v w with Eq => Some s | Lt => find v l | Gt => find v r end
  end.
(* The boxes are U times the coordinates. If `all_near`, the pairs whose boxes are near by `most` need a proof; else
   those whose boxes are near by their own separation. *)
Record hints := Hints { box_unit : Z; summaries : lookup; all_near : bool }.

Definition is_true (m : mesh) (c : corner) (U g v u h : Z) (s : summary) : bool :=
  box_holds U g u h (extent s) c && (negb (still s) || fixed m v)
  && match carrier s, c with
     | None, _ => true
     | Some n, On_body k _ _ => Z.eqb n k
     | _, _ => false
     end
  && match kin s with None => true | Some n => Z.eqb n (group m v) && ignored m n n end.
Fixpoint are_true (m : mesh) (corner_of : Z -> corner) (U g : Z) (p : lookup) : bool :=
  match p with
  | Nothing => true
  | Entry v u h s l r =>
      is_true m (corner_of v) U g v u h s && are_true m corner_of U g l && are_true m corner_of U g r
  end.
Lemma find_is_of m corner_of U g v s p : are_true m corner_of U g p = true -> find v p = Some s ->
  is_of m corner_of U g s v.
Proof.
  induction p as [|w u h s' l IHl r IHr]; simpl; [discriminate|]. rewrite !andb_true_iff. intros [[T L] R].
  destruct (Z.compare_spec v w) as [->|_|_]; auto. intros [= ->]. unfold is_true in T. rewrite !andb_true_iff in T.
  destruct T as [[[B S] C] K]. split; [|split; [|split]].
  - intros t I. now apply box_holds_sound with u h.
  - intros E. rewrite E in S. exact S.
  - intros n E. rewrite E in C. destruct (corner_of w) as [|k x y]; [discriminate|].
    apply Z.eqb_eq in C. subst k. eauto.
  - intros n E. rewrite E in K. apply andb_true_iff in K as [G K]. apply Z.eqb_eq in G. now split.
Qed.

(* The summaries of elements, and a tree of those in a list: none, or one. *)
Fixpoint summary_of (p : lookup) (l : list Z) : option summary :=
  match l with
  | [] => None
  | [v] => find v p
  | v :: l' => match find v p, summary_of p l' with Some a, Some b => Some (join a b) | _, _ => None end
  end.
Fixpoint leaves (p : lookup) (l : list simplex) (found : list tree) : option (list tree) :=
  match l with
  | [] => Some found
  | e :: l' => match summary_of p (vertices e) with Some s => leaves p l' (Leaf s e :: found) | None => None end
  end.
Definition tree_of (p : lookup) (l : list simplex) : option (list tree) :=
  match leaves p l [] with Some (a :: l') => Some [build l' a l'] | x => x end.

Section A_step.
Variables (m : mesh) (corner_of : Z -> corner) (U g : Z) (p : lookup).
Hypothesis T : are_true m corner_of U g p = true.
Lemma summary_of_is_of l : forall s, summary_of p l = Some s -> forall v, In v l -> is_of m corner_of U g s v.
Proof.
  induction l as [|a l IH]; intros s E v I; [discriminate|]. simpl in E. destruct l as [|b l].
  - destruct I as [<-|[]]. now apply find_is_of with p.
  - destruct (find a p) as [x|] eqn:A; [|discriminate]. destruct (summary_of p (b :: l)) as [y|]; [|discriminate].
    injection E as <-. apply is_of_join. destruct I as [<-|I]; [left; now apply find_is_of with p | right; auto].
Qed.
Lemma leaves_fit l : forall found t, Forall (fits m corner_of U g) found -> leaves p l found = Some t ->
  Forall (fits m corner_of U g) t /\ incl found t /\ forall e, In e l -> exists x, In x t /\ is_in e x.
Proof.
  induction l as [|e l IH]; intros found t F E; simpl in E.
  - injection E as <-. split; [auto|]. split; [apply incl_refl | simpl; tauto].
  - destruct (summary_of p (vertices e)) as [s|] eqn:S; [|discriminate].
    assert (L : fits m corner_of U g (Leaf s e)).
    { split; [|auto]. intros f v I V. inversion I; subst. now apply summary_of_is_of with (vertices e). }
    destruct (IH (Leaf s e :: found) t ltac:(auto) E) as (H & K & J). split; [auto|]. split.
    + intros x X. apply K. now right.
    + intros f [<-|I]; [|auto]. exists (Leaf s e). split; [apply K; now left | constructor].
Qed.
Lemma tree_of_fits l t : tree_of p l = Some t -> Forall (fits m corner_of U g) t
  /\ forall e, In e l -> exists x, t = [x] /\ is_in e x.
Proof.
  unfold tree_of. intros E. destruct (leaves p l []) as [[|a t']|] eqn:L; try discriminate;
    injection E as <-; destruct (leaves_fit l [] _ ltac:(auto) L) as (H & _ & K).
  - split; [constructor|]. intros e I. destruct (K e I) as (x & [] & _).
  - inversion H as [|? ? A F]; subst.
    destruct (build_fits m corner_of U g t' a t' A F) as [B C]. split; [repeat constructor; auto|].
    intros e I. destruct (K e I) as (x & X & Y). eexists. split; [reflexivity|]. now apply (C e x).
Qed.
End A_step.

(* The pairs that are not skipped, have no common vertex and are asked, in the order of their indices if they are of one
   sort. *)
Definition from_two (a b : list tree) : pairs := match a, b with [x], [y] => across x y [] | _, _ => [] end.
Definition from_one (a : list tree) : pairs := match a with [x] => among x [] | _ => [] end.
Definition separate (p : simplex * simplex) : bool :=
  forallb (fun v => negb (mem v (vertices (snd p)))) (vertices (fst p)).
Definition is_asked (m : mesh) (p : simplex * simplex) : bool :=
  let may v w := negb (ignored m (group m v) (group m w) && ignored m (group m w) (group m v)) in
  existsb (fun v => existsb (may v) (vertices (snd p))) (vertices (fst p)).
Definition in_order (p : simplex * simplex) : simplex * simplex :=
  if Z.ltb (index (fst p)) (index (snd p)) then p else (snd p, fst p).
Definition pair := (sort * simplex * simplex)%type.
Definition of_sort (s : sort) (test : simplex * simplex -> bool) (l : pairs) (found : list pair) : list pair :=
  let p_of p := match s with Two_edges | Two_points => in_order p | _ => p end in
  fold_left (fun found p => if separate p && test p then (s, fst (p_of p), snd (p_of p)) :: found else found) l found.

(* The pairs that need a proof: g is a bound for all separations. *)
Definition reach_margin (m : mesh) (h : hints) : Z := margin (box_unit h) (Euclidean (most m)).
Definition pairs_in_reach (m : mesh) : (Z -> corner) -> hints -> option (list pair) :=
  let w := wiring_of m in
  fun corner_of h =>
    let p := summaries h in
    if Z.ltb 0 (box_unit h) && is_valid (Euclidean (most m))
       && are_true m corner_of (box_unit h) (reach_margin m h) p then
      match tree_of p (points m), tree_of p (edges m), tree_of p (faces m), tree_of p (alone w), tree_of p (ends w),
            tree_of p (wires w) with
      | Some points, Some edges, Some faces, Some alone, Some ends, Some wires =>
          let asked := is_asked m in
          Some (of_sort Two_edges asked (from_one edges)
               (of_sort Point_face asked (from_two points faces)
               (of_sort Point_edge asked (from_two alone edges)
               (of_sort Two_points asked (from_one alone)
               (of_sort Fold (fun p => are_joined w (fst p) (snd p) && asked p) (from_two ends wires) [])))))
      | _, _, _, _, _, _ => None
      end
    else None.
Definition is_near (m : mesh) (h : hints) (p : pair) : bool :=
  let '(s, a, b) := p in
  match summary_of (summaries h) (vertices a), summary_of (summaries h) (vertices b) with
  | Some x, Some y =>
      let k := (reach_margin m h - margin (box_unit h) (separation_of m s a b))%Z in
      negb (far (shrink k (extent x)) (shrink k (extent y)))
  | _, _ => true
  end.
Definition near_pairs (m : mesh) : (Z -> corner) -> hints -> option (list pair) :=
  let in_reach := pairs_in_reach m in
  fun corner_of h =>
    match in_reach corner_of h with
    | Some found => Some (if all_near h then found else kept (is_near m h) found)
    | None => None
    end.

Lemma of_sort_keeps s test l : forall found, incl found (of_sort s test l found).
Proof.
  unfold of_sort. cbv zeta. induction l as [|p l IH]; intros found; simpl; [apply incl_refl|].
  eapply incl_tran; [|apply IH]. destruct (separate p && test p); [apply incl_tl|]; apply incl_refl.
Qed.
Lemma of_sort_in s test l a b found : In (a, b) l -> separate (a, b) && test (a, b) = true ->
  let (a', b') := match s with Two_edges | Two_points => in_order (a, b) | _ => (a, b) end in
  In (s, a', b') (of_sort s test l found).
Proof.
  intros I T. destruct (match s with Two_edges | Two_points => in_order (a, b) | _ => (a, b) end) as [a' b'] eqn:E.
  revert found. induction l as [|p l IH]; intros found; [destruct I|]. destruct I as [->|I]; [|now apply IH].
  change (of_sort s test ((a, b) :: l) found) with (of_sort s test l
    (if separate (a, b) && test (a, b) then
      (s, fst (match s with Two_edges | Two_points => in_order (a, b) | _ => (a, b) end),
       snd (match s with Two_edges | Two_points => in_order (a, b) | _ => (a, b) end)) :: found else found)).
  rewrite T, E. apply of_sort_keeps. now left.
Qed.
Lemma separate_sym a b : separate (a, b) = true <-> forall v, In v (vertices a) -> ~ In v (vertices b).
Proof.
  unfold separate; cbn [fst snd]. rewrite forallb_forall. split; intros H v V.
  - specialize (H v V). apply negb_true_iff in H. rewrite <- mem_in. congruence.
  - apply negb_true_iff. destruct (mem v (vertices b)) eqn:E; [|auto]. apply mem_in in E. now destruct (H v V).
Qed.
Lemma separation_of_size m s a b : 0 <= Q2R (most m) -> size (separation_of m s a b) <= Q2R (most m).
Proof.
  intros P. assert (M : forall D, Q2R (Qmin D (most m)) <= Q2R (most m)) by (intros; apply Qle_Rle, Q.le_min_r).
  unfold separation_of. destruct s, (asked m a b); simpl; auto.
Qed.
Lemma in_reach_true m corner_of h found : pairs_in_reach m corner_of h = Some found ->
  0 < IZR (box_unit h) /\ 0 <= Q2R (most m)
  /\ are_true m corner_of (box_unit h) (reach_margin m h) (summaries h) = true.
Proof.
  unfold pairs_in_reach. cbv zeta. intros E.
  destruct (Z.ltb 0 (box_unit h) && is_valid (Euclidean (most m))
    && are_true m corner_of (box_unit h) (reach_margin m h) (summaries h)) eqn:V; [|discriminate].
  rewrite !andb_true_iff in V. destruct V as [[L N] T]. apply is_valid_sound in N. now apply Z.ltb_lt, IZR_lt in L.
Qed.
Lemma in_reach_complete m corner_of h found : pairs_in_reach m corner_of h = Some found ->
  forall s a b, are_pair m s a b -> can_meet m corner_of a b ->
  In (s, a, b) found \/ holds (query_of m corner_of s a b) No_contact.
Proof.
  intros E s a b P C. destruct (in_reach_true m corner_of h found E) as (L & N & T).
  unfold pairs_in_reach in E. cbv zeta in E.
  set (U := box_unit h) in *. set (g := reach_margin m h) in *. set (p := summaries h) in *.
  set (w := wiring_of m) in *.
  destruct (Z.ltb 0 U && is_valid (Euclidean (most m)) && are_true m corner_of U g p); [|discriminate].
  assert (G : IZR U * Q2R (most m) <= IZR g) by apply (margin_sound U (Euclidean (most m))).
  destruct (tree_of p (points m)) as [tp|] eqn:Tp; [|discriminate].
  destruct (tree_of p (edges m)) as [te|] eqn:Te; [|discriminate].
  destruct (tree_of p (faces m)) as [tf|] eqn:Tf; [|discriminate].
  destruct (tree_of p (alone w)) as [ta|] eqn:Ta; [|discriminate].
  destruct (tree_of p (ends w)) as [tn|] eqn:Tn; [|discriminate].
  destruct (tree_of p (wires w)) as [tw|] eqn:Tw; [|discriminate]. injection E as <-.
  assert (K : skipped m corner_of U g a b -> holds (query_of m corner_of s a b) No_contact).
  { intros S. apply (skipped_no_contact m corner_of U g a b); auto.
    pose proof (separation_of_size m s a b N). apply Rle_trans with (IZR U * Q2R (most m)); [|exact G].
    apply Rmult_le_compat_l; lra. }
  assert (S : separate (a, b) = true) by (apply separate_sym, C).
  assert (S' : separate (b, a) = true) by (apply separate_sym; intros v V W; now apply (proj1 C v W)).
  assert (Q : is_asked m (a, b) = true /\ is_asked m (b, a) = true).
  { destruct C as (_ & _ & _ & x & y & X & Y & E).
    split; apply existsb_exists; cbn [fst snd]; [exists x | exists y]; (split; [auto|]);
      apply existsb_exists; [exists y | exists x]; (split; [auto|]); rewrite E, ?andb_false_r; auto. }
  destruct Q as [Q Q'].
  assert (two : forall A B x y test, tree_of p A = Some x -> tree_of p B = Some y -> In a A -> In b B ->
    s <> Two_edges -> s <> Two_points -> test (a, b) = true ->
    (forall f, In (s, a, b) (of_sort s test (from_two x y) f)) \/ skipped m corner_of U g a b).
  { intros A B x y test EA EB IA IB NE NP E. destruct (tree_of_fits m corner_of U g p T A x EA) as [FA HA].
    destruct (tree_of_fits m corner_of U g p T B y EB) as [FB HB].
    destruct (HA a IA) as (r & -> & JA), (HB b IB) as (r' & -> & JB). inversion FA; inversion FB; subst.
    destruct (across_all m corner_of U g r r' [] ltac:(auto) ltac:(auto)) as [_ H].
    destruct (H a b JA JB) as [I|I]; auto.
    left. intros f. pose proof (of_sort_in s test _ a b f I ltac:(now rewrite S, E)) as K'. now destruct s. }
  assert (one : forall A x, tree_of p A = Some x -> In a A -> In b A -> (index a < index b)%Z ->
    s = Two_edges \/ s = Two_points ->
    (forall f, In (s, a, b) (of_sort s (is_asked m) (from_one x) f)) \/ skipped m corner_of U g a b).
  { intros A x EA IA IB I E. destruct (tree_of_fits m corner_of U g p T A x EA) as [FA HA].
    destruct (HA a IA) as (r & -> & JA), (HA b IB) as (r' & [= <-] & JB). inversion FA; subst.
    assert (O : in_order (a, b) = (a, b) /\ in_order (b, a) = (a, b)).
    { unfold in_order; cbn [fst snd]. destruct (Z.ltb_spec (index a) (index b)), (Z.ltb_spec (index b) (index a));
        [lia | auto | lia | lia]. }
    destruct O as [O O']. destruct (among_all m corner_of U g r [] ltac:(auto)) as [_ H].
    destruct (H a b JA JB) as [J|[J|[J|J]]]; auto.
    - subst b. lia.
    - left. intros f. pose proof (of_sort_in s (is_asked m) _ a b f J ltac:(now rewrite S, Q)) as K'.
      destruct E as [-> | ->]; rewrite O in K'; auto.
    - left. intros f. pose proof (of_sort_in s (is_asked m) _ b a f J ltac:(now rewrite S', Q')) as K'.
      destruct E as [-> | ->]; rewrite O' in K'; auto. }
  destruct s; simpl in P.
  - destruct P as (A & B & I). destruct (one _ _ Te A B I); auto.
  - destruct P as (A & B). destruct (two _ _ _ _ (is_asked m) Tp Tf A B); auto; try discriminate.
    left. apply of_sort_keeps. auto.
  - destruct P as (A & B). apply alone_complete in A.
    destruct (two _ _ _ _ (is_asked m) Ta Te A B); auto; try discriminate.
    left. do 2 apply of_sort_keeps. auto.
  - destruct P as (A & B & I). apply alone_complete in A, B. destruct (one _ _ Ta A B I); auto.
    left. do 3 apply of_sort_keeps. auto.
  - destruct (fold_complete m a b P) as (A & B & J).
    destruct (two _ _ _ _ (fun p => are_joined w (fst p) (snd p) && is_asked m p) Tn Tw A B); auto; try discriminate.
    { cbn [fst snd]. apply andb_true_iff. now split. }
    left. do 4 apply of_sort_keeps. auto.
Qed.
Theorem near_pairs_complete m corner_of h found : near_pairs m corner_of h = Some found ->
  forall s a b, are_pair m s a b -> can_meet m corner_of a b ->
  In (s, a, b) found \/ holds (query_of m corner_of s a b) No_contact.
Proof.
  unfold near_pairs. cbv zeta. intros E s a b P C.
  destruct (pairs_in_reach m corner_of h) as [all|] eqn:A; [|discriminate]. injection E as <-.
  destruct (in_reach_complete m corner_of h all A s a b P C) as [I|I]; [|now right].
  destruct (all_near h); [now left|]. destruct (is_near m h (s, a, b)) eqn:F; [left; now apply kept_in | right].
  destruct (in_reach_true m corner_of h all A) as (L & _ & T). unfold is_near in F.
  destruct (summary_of (summaries h) (vertices a)) as [x|] eqn:X; [|discriminate].
  destruct (summary_of (summaries h) (vertices b)) as [y|] eqn:Y; [|discriminate].
  cbv zeta in F. apply negb_false_iff in F. set (k := (reach_margin m h - _)%Z) in F. intros t I'.
  apply far_no_contact with (shrink k (extent x)) (shrink k (extent y)) (box_unit h) (reach_margin m h - k)%Z; auto.
  - replace (reach_margin m h - k)%Z with (margin (box_unit h) (separation_of m s a b)) by (unfold k; lia).
    apply margin_sound.
  - intros c J. apply in_map_iff in J as (v & <- & J). apply inside_shrink.
    apply (summary_of_is_of m corner_of _ _ _ T _ x X v J); auto.
  - intros c J. apply in_map_iff in J as (v & <- & J). apply inside_shrink.
    apply (summary_of_is_of m corner_of _ _ _ T _ y Y v J); auto.
Qed.

(* Answers with proofs for the pairs, in the order of their list. *)
Definition sort_number (s : sort) : Z :=
  match s with Two_edges => 0 | Point_face => 1 | Point_edge => 2 | Two_points => 3 | Fold => 4 end.
Definition same_simplex (a b : simplex) : bool := Z.eqb (index a) (index b) && equal (vertices a) (vertices b).
Definition same_pair (p q : pair) : bool :=
  let '(s, a, b) := p in let '(s', a', b') := q in
  Z.eqb (sort_number s) (sort_number s') && same_simplex a a' && same_simplex b b'.
Lemma same_simplex_eq a b : same_simplex a b = true -> a = b.
Proof.
  unfold same_simplex. destruct a as [i v], b as [j w]; simpl. rewrite andb_true_iff. intros [I V].
  apply Z.eqb_eq in I. apply equal_eq in V. now subst.
Qed.
Lemma same_pair_eq p q : same_pair p q = true -> p = q.
Proof.
  destruct p as [[s a] b], q as [[s' a'] b']. unfold same_pair. rewrite !andb_true_iff. intros [[S A] B].
  apply same_simplex_eq in A, B. apply Z.eqb_eq in S. destruct s, s'; try discriminate; now subst.
Qed.
Definition claim := (pair * answer * proof)%type.
Fixpoint are_claimed (found : list pair) (claims : list claim) : bool :=
  match found, claims with
  | [], [] => true
  | p :: found', (q, _, _) :: claims' => same_pair p q && are_claimed found' claims'
  | _, _ => false
  end.
Definition check_claim (m : mesh) (corner_of : Z -> corner) (c : claim) : bool :=
  let '(s, a, b, x, p) := c in check (query_of m corner_of s a b) x p.
Definition check_step (m : mesh) : (Z -> corner) -> hints -> list claim -> bool :=
  let near := near_pairs m in
  fun corner_of h claims =>
    match near corner_of h with
    | Some found => are_claimed found claims && forallb (check_claim m corner_of) claims
    | None => false
    end.
Theorem step_sound : forall m corner_of h l, check_step m corner_of h l = true -> step_holds m corner_of (map fst l).
Proof.
  intros m corner_of h claims H. unfold check_step in H. cbv zeta in H.
  destruct (near_pairs m corner_of h) as [found|] eqn:N; [|discriminate]. apply andb_true_iff in H as [A C].
  rewrite forallb_forall in C. split.
  - intros s a b x I. apply in_map_iff in I as ([[[[s' a'] b'] x'] p] & [= -> -> -> ->] & I).
    now apply check_sound with p, (C _ I).
  - intros s a b P M. destruct (near_pairs_complete m corner_of h found N s a b P M) as [I|I]; [left | now right].
    clear C N. revert claims A. induction found as [|q found IH]; [destruct I|].
    intros [|[[q' x] p] claims] A; [discriminate|]. simpl in A. apply andb_true_iff in A as [E A].
    apply same_pair_eq in E. subst q'. destruct I as [->|I].
    + exists x. now left.
    + destruct (IH I claims A) as (y & J). exists y. now right.
Qed.
