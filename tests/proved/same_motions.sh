#!/usr/bin/env bash
# The checker that is proved in Coq accepts the proofs of motions of meshes, and prints what touchstone-check prints. It
# says what touchstone-check says of changed motions and of changed proofs, refuses another file than the one that the
# proofs name, and prints nothing then. With wrong boxes it accepts no proofs that leave out pairs.
#
#   same_motions.sh PROGRAM CHECKER PROVED CHECKS PROVED_CHECKS THEORIES OCAMLFIND SORT
#
# SORT: straight, radii, bodies or boxes. CHECKS and PROVED_CHECKS are the programs of ../proofs/checks.cpp and checks.ml.
# THEORIES is the folder of the checker's OCaml, compiled. All of them are absolute paths.
# SPDX-License-Identifier: MIT
set -euo pipefail
program=$1 checker=$2 proved=$3 checks=$4 proved_checks=$5 theories=$6 ocamlfind=$7 sort=$8
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"

both_accept() { # ARGUMENT...: both checkers print the same
  "$checker" "$@" >checker.txt
  "$proved" "$@" >proved.txt
  diff checker.txt proved.txt
  tail -n 2 proved.txt
}
joined() { # PROOFS...: their files' proofs as one
  echo 'touchstone-proofs 1'
  grep -hvE '^(touchstone-proofs|end) ' "$@"
  awk '/^end / { n += $2; m += $3 } END { print "end", n, m }' "$@"
}
both_check() { # MUTANTS NAME...: the proofs of these motions, and changed ones
  local names=("${@:2}")
  joined "${names[@]/%//proofs.txt}" >joined.txt
  both_accept joined.txt "${names[@]/%//motion.txt}"
  python3 -B "$here/compare_checkers.py" --checker "$checker" --many "$checks" --proved "$proved" \
    --many-proved "$proved_checks" --mutants "$1" joined.txt "${names[@]/%//motion.txt}"
}
prove_mesh() { # NAME ARGUMENT...: the exit status is 1 where the motion has contacts
  "$program" mesh --prove "$1" "${@:2}" >/dev/null || [[ $? == 1 ]]
}
both_end_with() { # STATUS REASON ARGUMENT...: both say so, and print nothing on standard output
  local one status
  for one in "$checker" "$proved"; do
    status=0
    "$one" "${@:3}" >output.txt 2>reason.txt || status=$?
    if [[ $status != "$1" || -s output.txt ]] || ! grep -q -- "$2" reason.txt; then
      echo "$one ${*:3}: status $status in place of $1, or it prints what does not hold, or not \"$2\":"
      cat output.txt reason.txt
      exit 1
    fi
  done
}

case $sort in
  straight)
    "$program" generate --meshes --size 400 --steps 6 --crossing 3 --out meshes
    "$program" generate --meshes --scene cables --scene sheets --size 150 --out meshes
    prove_mesh cloth meshes/drape/*.obj
    grep -q ' contact ' cloth/proofs.txt
    prove_mesh cables meshes/cables/frame-000[0-4].obj
    prove_mesh sheets --separation 0.02 meshes/sheets/frame-000[0-2].obj
    prove_mesh max --separation 0.02 --metric max meshes/cables/frame-000[0-2].obj
    prove_mesh between --separation 0.08 --between-parts meshes/sheets/frame-000[0-3].obj
    prove_mesh only --separation 0.01 --only-between upper,upper meshes/sheets/frame-000[0-2].obj
    prove_mesh self --separation 0.08 --self 0.3 meshes/sheets/frame-000[0-1].obj
    grep -q '^touching ' self/motion.txt
    grep -q '^ignore ' between/motion.txt
    grep -q '^ignore ' only/motion.txt
    both_check 700 cloth cables sheets max between only self

    # The digests, of a motion and of queries; and several files.
    cloth=(cloth/proofs.txt cloth/motion.txt)
    { cat "${cloth[1]}"; echo '# a comment'; } >other.txt
    both_end_with 1 'the proofs are about another file' "${cloth[0]}" other.txt
    "$program" generate --count 50 --scene cloth --out queries >/dev/null
    queries=(queries/cloth/*/*.csv)
    "$program" prove --out queries.txt "${queries[@]}" >/dev/null
    both_accept queries.txt "${queries[@]}"
    { cat "${queries[-1]}"; echo '# a comment'; } >other.csv
    both_end_with 1 'the proofs are about another file' queries.txt "${queries[@]:0:${#queries[@]}-1}" \
      other.csv
    joined "${cloth[0]}" queries.txt >all.txt
    sed 's/^end .*/end 0 0/' all.txt >another_end.txt
    both_end_with 1 'here must be "end' another_end.txt "${cloth[1]}" "${queries[@]}"
    both_accept all.txt "${cloth[1]}" "${queries[@]}"

    # Nothing to check, and nothing near.
    printf 'touchstone-motion 1\nvertices 2\npoint 0\npoint 1\nframe\n0 0 0\n5 0 0\nframe\n0 0 0\n4 0 0\n' >far.txt
    printf 'touchstone-proofs 1\nfile mesh - far.txt\nstep 0\nend 0 0\n' >nothing.txt
    both_end_with 1 'no query was checked' nothing.txt far.txt
    both_accept --allow-empty nothing.txt far.txt
    grep -v point far.txt >bare.txt
    both_end_with 2 'there is nothing to check' --allow-empty nothing.txt bare.txt
    ;;
  radii)
    # A hoop, and a sphere on a cable with segments shorter than its radius.
    cat >scene.json <<'END'
{"touchstone_scene": 1, "particles": [
  {"position": [0, 0, 0], "pinned": true}, {"position": [0.25, 0, 0]}, {"position": [0.5, 0, 0]},
  {"position": [0.75, 0, 0]}, {"position": [1, 0, 0], "pinned": true},
  {"position": [0.5, 0.1, 0.875], "mass": 1, "radius": 0.5}],
 "cables": [{"particles": [0, 1, 2, 3, 4], "radius": 0.25, "solid": true, "density": 1000, "young": 1e6}]}
END
    "$program" simulate scene.json --steps 20 --prove cable >/dev/null
    "$program" simulate hoop --steps 5 --prove hoop >/dev/null
    grep -q '^near ' cable/motion.txt
    both_check 400 cable hoop

    # Longer radii ask for more than the proofs show, shorter ones for fewer proofs; and other faults.
    sed 's/^\(file mesh\) [^ ]*/\1 -/' cable/proofs.txt >unbound.txt
    refuse_changed() { # STATUS REASON SED: the motion of the cable, changed
      sed "$3" cable/motion.txt >changed.txt
      ! cmp -s cable/motion.txt changed.txt || { echo "no effect: $3"; exit 1; }
      both_end_with "$1" "$2" unbound.txt changed.txt
    }
    refuse_changed 1 rejected 's/^radius 0x1p-1$/radius 1/'
    refuse_changed 1 'a proof too many' 's/^radius .*/radius 0/'
    refuse_changed 1 rejected '/^near /d'
    refuse_changed 2 'a radius must not be negative' 's/^radius 0x1p-1$/radius -1/'
    refuse_changed 2 'changed.txt:' 's/^near 0 1$/near 1 1/'
    refuse_changed 2 'changed.txt:' 's/^near 0 2$/near 1 0/'
    { head -n 1 unbound.txt; echo 'separation max 1'; tail -n +2 unbound.txt; } >another.txt
    both_end_with 1 'has the separations of its own' another.txt cable/motion.txt

    # 1 + 2^-1100 is rounded up to the next double after 1.
    one=0x1.0000000000001p0
    motion_at() { # X: two points at this distance
      printf '%s\n' 'touchstone-motion 1' 'vertices 2' 'radius 0x1p-1100' 'point 0' 'radius 1' 'point 1' \
        frame '0 0 0' "$1 0 0" frame '0 0 0' "$1 0 0"
    }
    motion_at "$one" >near.txt
    motion_at 0x1.00000000000011p0 >far.txt
    printf '%s\n' 'touchstone-proofs 1' 'file mesh - f' 'step 0' '0 contact 0 0' 'w 0 1' 'w 1 1' 'end 1 1' >meet.txt
    both_accept meet.txt near.txt
    both_end_with 1 rejected meet.txt far.txt
    ;;
  bodies)
    "$program" simulate link-chain --size 3 --steps 152 --checkpoint chain.json >/dev/null
    "$program" simulate --resume chain.json --steps 4 --prove chain >/dev/null
    "$program" simulate nut-and-bolt --size 24 --steps 1 --prove nut >/dev/null
    "$program" simulate hoop-rim --steps 2 --prove rim >/dev/null
    for name in chain nut rim; do grep -q '^body ' "$name/motion.txt"; done
    both_check 150 chain nut rim
    ;;
  boxes)
    "$program" generate --meshes --scene sheets --size 150 --out meshes >/dev/null
    prove_mesh sheets --separation 0.02 meshes/sheets/frame-000[0-2].obj
    "$program" simulate hoop --steps 1 --prove hoop >/dev/null
    # The same motions, as if no pair needed a proof.
    for name in sheets hoop; do
      { grep -E '^(touchstone|separation|file|step)' "$name/proofs.txt"; echo 'end 0 0'; } >"$name/none.txt"
      both_end_with 1 rejected --allow-empty "$name/none.txt" "$name/motion.txt"
    done
    cp "$theories"/*.{ml,cm*,o} .
    rebuilt() { # SED: the checker with another boxes.ml
      sed "$1" "$theories/boxes.ml" >boxes.ml
      [[ -z $1 ]] || ! cmp -s "$theories/boxes.ml" boxes.ml || { echo "no effect: $1"; exit 1; }
      "$ocamlfind" ocamlopt -package zarith -linkpkg {proved,sha256,text,hints,meshes,frames}.cmx boxes.ml reader.ml main.ml \
        -o rebuilt
    }
    rebuilt ''
    for name in sheets hoop; do ./rebuilt "$name/proofs.txt" "$name/motion.txt" >/dev/null; done
    while IFS= read -r fault; do
      rebuilt "$fault"
      for name in sheets hoop; do
        status=0
        ./rebuilt --allow-empty "$name/none.txt" "$name/motion.txt" >/dev/null 2>reason.txt || status=$?
        [[ $status == 1 ]] || { echo "status $status of $name with $fault"; cat reason.txt; exit 1; }
      done
      echo "$fault: $(tail -c 60 reason.txt)"
    done <<'END'
s/and until k = Z.add margin (\(.*\)) in/and until k = \1 in/
s/let from k = scaled (fst/let from k = scaled (snd/
s/still = fixed (Z.of_int v)/still = true/
s/if ignored g g then Some g else None/Some g/
s/| On_curve _ -> None in/| On_curve _ -> Some Z.one in/
s/box_unit = Z.shift_left Z.one (- low)/box_unit = Z.minus_one/
s/box_unit = Z.shift_left Z.one (- low)/box_unit = Z.one/
s/Entry (Z.of_int v, u, h/Entry (Z.of_int (v + 1), u, h/
s/balanced 0 (Array.length corners)/Nothing/
s/all_near = m.radii = None/all_near = true/
s/lowest (min 0 m.finest) reach/lowest 0 reach/
END
    ;;
  *)
    echo "same_motions.sh: '$sort' is none of straight, radii, bodies and boxes" >&2
    exit 2
    ;;
esac
