#!/usr/bin/env bash
# Both checkers accept the proofs of the bundled queries and of some motions, with and without a separation, and neither
# accepts a changed proof of another answer.
#
#   second_checker.sh PROGRAM CHECKER CHECKS QUERIES PROOFS
#
# CHECKS is the program of checks.cpp, and QUERIES the folder of the bundled queries. PROOFS: those of queries, of
# curved queries, of separations, of motions or of bodies.
# SPDX-License-Identifier: MIT
set -euo pipefail
program=$1 checker=$2 checks=$3 queries=$4 proofs=$5
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
here=$(dirname -- "${BASH_SOURCE[0]}")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

# Both checkers print the same, and no changed proof is accepted whose answer is false.
both_accept() { # PROOFS FILE...
  local by_us by_page
  by_us=$("$checker" "$@")
  by_page=$(python3 -B "$here/check_proofs.py" "$@")
  [[ $by_us == "$by_page" ]] || { diff <(echo "$by_us") <(echo "$by_page"); exit 1; }
  tail -n 1 <<<"$by_us"
}
both_check() { # PROOFS FILE...
  both_accept "$@"
  python3 -B "$here/mutate_proofs.py" --cases 300 "$@"
  python3 -B "$here/mutate_proofs.py" --cases 60 --checker "$checker" --many "$checks" "$@"
}

prove_motion() { # NAME ARGUMENT...: the exit status is 1 where the motion has contacts
  "$program" mesh --prove "$folder/$1" "${@:2}" || [[ $? == 1 ]]
  both_check "$folder/$1/proofs.txt" "$folder/$1/motion.txt"
}
# Recorded poses: a tetrahedron that turns through another one, in steps of which the second one goes to -q.
prove_poses() { # NAME ARGUMENT...
  local name=$1 one=$folder/one.obj two=$folder/two.obj
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' | tee "$two" >"$one"
  printf '%s\n' time,body,x,y,z,qw,qx,qy,qz 0,one,2,0,0,1,0,0,0 1,one,1,0,0,0.5,0.5,0,0 2,one,0,0.25,0,-1,-1,-0.5,0 \
    0,two,0,0,0,1,0,0,1 1,two,0,0,0,1,1,0,1 2,two,0,0,0.25,1,1,0.5,1 >"$folder/poses.csv"
  "$program" bodies "$one" "$two" --poses "$folder/poses.csv" --prove "$folder/$name" "${@:2}" || [[ $? == 1 ]]
  both_accept "$folder/$name/proofs.txt" "$folder/$name/motion.txt"
}
# Bodies that turn: links that meet late, a nut on a fixed bolt, and a rim with a ball of particles.
prove_bodies() { # NAME ARGUMENT...
  "$program" simulate "${@:2}" --prove "$folder/$1"
  grep -q '^body ' "$folder/$1/motion.txt"
  grep -q ' none$' "$folder/$1/proofs.txt"
  # Fewer mutants: their truth is about polynomials of high degrees.
  both_accept "$folder/$1/proofs.txt" "$folder/$1/motion.txt"
  python3 -B "$here/mutate_proofs.py" --cases 40 --parts 6 "$folder/$1/proofs.txt" "$folder/$1/motion.txt"
  python3 -B "$here/mutate_proofs.py" --cases 20 --parts 6 --checker "$checker" --many "$checks" \
    "$folder/$1/proofs.txt" "$folder/$1/motion.txt"
}

mapfile -t files < <(grep -L '^touchstone-curved' "$queries"/{edge-edge,vertex-face,point-edge,point-point}/*.csv)
case $proofs in
  curved)
    mapfile -t curved < <(grep -l '^touchstone-curved' "$queries"/{edge-edge,vertex-face,point-edge,point-point}/*.csv)
    "$program" prove --out "$folder/curved.txt" "${curved[@]}"
    both_check "$folder/curved.txt" "${curved[@]}"
    ;;
  queries)
    "$program" prove --out "$folder/touching.txt" "${files[@]}"
    both_check "$folder/touching.txt" "${files[@]}"
    ;;
  separations)
    for separation in "euclidean 0.125" "max 1"; do
      read -r metric distance <<<"$separation"
      "$program" prove --separation "$distance" --metric "$metric" --out "$folder/$metric.txt" "${files[@]}"
      both_check "$folder/$metric.txt" "${files[@]}"
    done
    ;;
  motions)
    "$program" generate --meshes --scene cables --scene sheets --size 150 --out "$folder/meshes"
    prove_motion cables "$folder"/meshes/cables/frame-000[0-4].obj
    prove_motion sheets --separation 0.02 "$folder"/meshes/sheets/frame-000[0-2].obj
    prove_motion between --separation 0.08 --between-parts "$folder"/meshes/sheets/frame-000[0-3].obj
    prove_motion self --separation 0.08 --self 0.3 "$folder"/meshes/sheets/frame-000[0-1].obj
    prove_motion max --separation 0.02 --metric max "$folder"/meshes/cables/frame-000[0-2].obj
    "$program" simulate hoop --steps 5 --prove "$folder/hoop"
    both_check "$folder/hoop/proofs.txt" "$folder/hoop/motion.txt"
    ;;
  bodies)
    "$program" simulate link-chain --size 3 --steps 152 --checkpoint "$folder/chain.json"
    prove_bodies chain --resume "$folder/chain.json" --steps 4
    prove_bodies nut nut-and-bolt --size 24 --steps 1
    prove_bodies rim hoop-rim --steps 2
    prove_poses poses
    prove_poses apart --separation 0.125 --metric max
    ;;
  *)
    echo "second_checker.sh: '$proofs' is none of queries, curved, separations, motions and bodies" >&2
    exit 2
    ;;
esac
