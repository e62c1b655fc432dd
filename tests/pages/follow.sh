#!/usr/bin/env bash
# Follows one page as a reader does: from its top, every command of it, in one shell that begins in the project's
# folder.
#   follow.sh PAGE ROOT HOME_FOLDER CMAKE      PAGE: relative to ROOT; HOME_FOLDER: stands for the reader's home
# Prints each command with its output, or the reason why it is not run here. Exit status 0 when the page is right.
#
# The marks on a page, and the checks:
#   ```sh                    commands, one a line, or more lines with a \ at their ends; each must exit with 0, or with N
#                            when it ends in the comment `# exit status N`
#   ```text                  right after ```sh: the output of these commands; `...` stands for any text within a line, and a
#                            line of `...` alone for any number of lines
#   ```LANGUAGE ~/FILE       a file that the reader makes; it is written there when the page comes to it
#   ```cpp                   with a main(): a program, built against the touchstone in ~/touchstone; a ```text right after
#                            it is its output
# SPDX-License-Identifier: MIT
set -uo pipefail
page=$1 root=$2 cmake=$4
# The README is followed first, and in a new home: folders of an earlier run would be in the way.
[[ $page != README.md || ! -d $3/.follow ]] || rm -rf -- "$3"
mkdir -p -- "$3"
HOME=$(cd -- "$3" && pwd -P)
export HOME
unset DESTDIR
scratch=$HOME/.follow/${page//\//_}
rm -rf -- "$scratch"
mkdir -p -- "$scratch/programs"
command -v cmake >/dev/null || PATH=$(dirname -- "$cmake"):$PATH
wrong=0

fail() {
  printf 'WRONG: %s: %s\n' "$page" "$*"
  wrong=$((wrong + 1))
}

# Why a command is not run here; nothing when it is. The commands that this test leaves out, all of them:
reason_not_to_run() {
  case $1 in
    tests/run-all.sh*) echo 'it runs every test, this one among them' ;;
    .ci/run*) echo 'it runs every test, this one among them' ;;
    fuzz/run.sh*) echo 'it builds with clang and fuzzes for minutes; tests/heavy.sh runs it' ;;
    tests/heavy.sh\ --list) ;;
    src/bindings/browser/build.sh*) echo 'it compiles to WebAssembly, for minutes; tests/heavy.sh runs it' ;;
    tests/release.sh*) echo 'it builds the library and the module anew, for minutes; tests/heavy.sh runs it' ;;
    'cmake '*by_archive*) echo 'it needs the archive; tests/release.sh builds this project with it' ;;
    tests/heavy.sh*) echo 'it builds anew, and tests for many minutes' ;;
    fuzz/weaken-constants.py*) echo 'it builds the library dozens of times' ;;
    *' --target docs') echo 'tests/doxygen runs Doxygen' ;;
    'cmake --preset '*) echo 'it configures a build for developers; building that takes many minutes' ;;
    'cmake --build --preset '*) echo 'it builds everything, for many minutes' ;;
    'ctest '*) echo 'it runs every test, this one among them' ;;
    *touchstone_check_proved* | *touchstone-check-proved\ * | *coqc*)
      [[ $(coqc --print-version 2>/dev/null) == 8.16.* ]] && ocamlfind query zarith >/dev/null 2>&1 ||
        echo 'Coq 8.16, OCaml or Zarith is not installed'
      ;;
    'sudo '* | 'apt-get '*) echo 'it changes the machine' ;;
    'git archive '*touchstone* | *'dpkg-buildpackage '* | *'brew '* | conan\ * | rattler-build\ * | spack\ * | vcpkg\ *)
      echo 'a package manager builds the library anew, for minutes; tests/packaging checks the recipes'
      ;;
    mmdebstrap* | 'git archive'* | 'mount '* | 'chroot '*) echo 'it needs root and makes a whole system' ;;
    'touchstone report --out '*) echo 'it measures for minutes; the same command with --quick is run by tests/report' ;;
    "python3 -c 'import touchstone"* | 'python3 ~/python/'*)
      python3 -c 'import touchstone' 2>/dev/null ||
        echo 'python3 in PATH does not import touchstone; tests/python runs the programs where the module is built'
      ;;
    'python3 -m venv '* | */pip' install '*) echo 'it builds the library anew, for minutes' ;;
    *'cpack '*) echo 'tests/packaging makes the packages, installs and removes them' ;;
    *pkg-config*) command -v pkg-config >/dev/null || echo 'pkg-config is not installed; tests/packaging uses it' ;;
    */by_pkg_config) [[ -x $HOME/first_touch/by_pkg_config ]] || echo 'it was not built, without pkg-config' ;;
    *sbatch*) echo 'it hands jobs to a cluster' ;;
    'touchstone audit --out audit --html'*) echo 'it asks millions of queries, for minutes; tests/audit asks fewer' ;;
    'npm install '*) echo 'it changes the machine' ;;
    'touchstone stress --out '*) echo 'it measures for half a minute; tests/stress runs it smaller' ;;
    *)
      local tool
      for tool in python3 clang++ clang-format doxygen valgrind ninja parallel; do
        if [[ " $1 " =~ [[:space:]\"\'/]"$tool"[[:space:]\"\'] ]] && ! command -v "$tool" >/dev/null; then
          echo "$tool is not installed"
          return
        fi
      done
      ;;
  esac
}

# Whether the lines of file $1, with `...`, describe those of file $2.
matches() {
  awk '
    function escaped(text) { gsub(/[][\\.^$*+?(){}|]/, "\\\\&", text); return text }
    NR == FNR { expected[++count] = $0; next }
    { shown[++lines] = $0 }
    # Whether expected[i..] describes shown[j..]; reached[i, j] is remembered.
    function describes(i, j,   k, pattern) {
      if ((i, j) in known) return known[i, j]
      if (i > count) return known[i, j] = (j > lines)
      if (expected[i] == "...") {
        for (k = j; k <= lines + 1; ++k) if (describes(i + 1, k)) return known[i, j] = 1
        return known[i, j] = 0
      }
      if (j > lines) return known[i, j] = 0
      if (expected[i] != shown[j]) {
        pattern = expected[i]
        gsub(/\.\.\./, "\001", pattern)
        pattern = escaped(pattern)
        gsub(/\001/, ".*", pattern)
        if (shown[j] !~ ("^" pattern "$")) return known[i, j] = 0
      }
      return known[i, j] = describes(i + 1, j + 1)
    }
    END { exit !describes(1, 1) }' "$1" "$2"
}

run_commands() {
  local text=$1 line command='' status expected why
  : >"$scratch/output"
  some_not_run=''
  while IFS= read -r line; do
    command+=$line
    if [[ $command == *\\ ]]; then
      command=${command%\\}
      continue
    fi
    if [[ -n ${command//[[:space:]]/} && ! $command =~ ^[[:space:]]*# ]]; then
      expected=0
      [[ ! $command =~ \#\ exit\ status\ ([0-9]+) ]] || expected=${BASH_REMATCH[1]}
      why=$(reason_not_to_run "$command")
      if [[ -n $why ]]; then
        printf '$ %s\n  not run here: %s\n' "$command" "$why"
        some_not_run=yes
      else
        printf '$ %s\n' "$command"
        # The page's reader makes the folder for the first time. An earlier run of this test may have left it.
        [[ ! $command =~ ^mkdir\ -p\ ~/([a-z_-]+)\ \&\&\ cd ]] || rm -rf -- "$HOME/${BASH_REMATCH[1]}"
        eval "$command" >"$scratch/printed" 2>&1 </dev/null
        status=$?
        head -n 60 "$scratch/printed"
        cat "$scratch/printed" >>"$scratch/output"
        ((status == expected)) || fail "exit status $status, not $expected, from: $command"
      fi
    fi
    command=''
  done <<<"$text"
}

programs=()

# A block of the page: its language, the file it makes (or nothing) and its text. `after` is the kind of block before
# it.
after=''
take_block() {
  local language=$1 file=$2 text=$3
  if [[ -n $file ]]; then
    file=${file/#\~/$HOME}
    mkdir -p -- "$(dirname -- "$file")"
    # The page's reader builds the project for the first time. An earlier run of this test may have left a build.
    [[ ${file##*/} != CMakeLists.txt ]] || rm -rf -- "$(dirname -- "$file")/build"
    printf '%s' "$text" >"$file"
    printf '(%s is made)\n' "$file"
  fi
  case $language in
    sh)
      run_commands "$text"
      after=sh
      ;;
    text)
      if [[ $after == sh && -n $some_not_run ]]; then
        printf '(its output is not compared: see above)\n'
      elif [[ $after == sh ]]; then
        printf '%s' "$text" >"$scratch/expected"
        matches "$scratch/expected" "$scratch/output" ||
          { fail "the page shows another output than this:"; cat "$scratch/output"; echo '-- the page shows:'; printf '%s' "$text"; }
      elif [[ $after == program ]]; then
        printf '%s' "$text" >"$scratch/programs/${programs[-1]}.txt"
      fi
      after=''
      ;;
    cpp)
      after=''
      if [[ $text == *'int main('* ]]; then
        programs+=("program_$((${#programs[@]} + 1))")
        printf '%s' "$text" >"$scratch/programs/${programs[-1]}.cpp"
        after=program
      fi
      ;;
    *) after='' ;;
  esac
}

build_and_run_programs() {
  local name
  cat >"$scratch/programs/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.18)
project(programs LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(touchstone REQUIRED OPTIONAL_COMPONENTS tight_inclusion)
find_package(Eigen3 3.3 QUIET NO_MODULE)
file(GLOB sources ${CMAKE_CURRENT_SOURCE_DIR}/program_*.cpp)
foreach(source ${sources})
  get_filename_component(name ${source} NAME_WE)
  file(READ ${source} text)
  string(FIND "${text}" "touchstone/eigen.hpp" eigen)
  string(FIND "${text}" "<tight_inclusion/" tight_inclusion)
  if(NOT tight_inclusion EQUAL -1)
    if(TARGET tight_inclusion::tight_inclusion)
      add_executable(${name} ${source})
      target_link_libraries(${name} PRIVATE tight_inclusion::tight_inclusion)
    endif()
    continue()
  endif()
  if(NOT eigen EQUAL -1 AND NOT TARGET Eigen3::Eigen)
    continue()
  endif()
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE touchstone::touchstone touchstone::fuzz)
  if(NOT eigen EQUAL -1)
    target_link_libraries(${name} PRIVATE Eigen3::Eigen)
  endif()
endforeach()
END
  if ! { "$cmake" -S "$scratch/programs" -B "$scratch/programs/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$HOME/touchstone" -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' &&
    "$cmake" --build "$scratch/programs/build"; } >"$scratch/built" 2>&1; then
    fail 'its programs cannot be built:'
    cat "$scratch/built"
    return
  fi
  for name in "${programs[@]}"; do
    if [[ ! -x $scratch/programs/build/$name ]]; then
      printf '(%s is not run here: Eigen is not installed)\n' "$name"
      continue
    fi
    printf '(%s)\n' "$name"
    "$scratch/programs/build/$name" >"$scratch/printed" 2>&1 || fail "exit status $? from $name"
    cat "$scratch/printed"
    if [[ ! -e $scratch/programs/$name.txt ]]; then
      fail "it does not say what $name prints"
    elif ! matches "$scratch/programs/$name.txt" "$scratch/printed"; then
      fail "it shows another output of $name:"
      cat "$scratch/programs/$name.txt"
    fi
  done
}

cd -- "$root" || exit 2
[[ -r $page ]] || { fail 'there is no such page'; exit 2; }
blocks=0 commands=0
fenced='' language='' file='' text=''
while IFS= read -r line <&3; do
  if [[ -z $fenced && $line =~ ^\`\`\`([a-z]*)\ ?(.*)$ ]]; then
    fenced=yes language=${BASH_REMATCH[1]} file=${BASH_REMATCH[2]} text=''
  elif [[ -n $fenced && $line == '```' ]]; then
    fenced=''
    blocks=$((blocks + 1))
    [[ $language != sh ]] || commands=$((commands + 1))
    take_block "$language" "$file" "$text"
  elif [[ -n $fenced ]]; then
    text+=$line$'\n'
  fi
done 3<"$root/$page"
[[ -z $fenced ]] || fail 'a block has no end'
((${#programs[@]} == 0)) || build_and_run_programs
printf '%s: %d blocks, %d of them commands, %d programs, %d wrong\n' "$page" "$blocks" "$commands" "${#programs[@]}" "$wrong"
((wrong == 0))
