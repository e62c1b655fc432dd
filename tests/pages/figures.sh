#!/usr/bin/env bash
# The tables of docs/accuracy-and-speed.md are those of the CSV files beside it.
#   figures.sh ROOT           prints every difference; exit status 0 when there is none
#   figures.sh ROOT --update  writes the tables into the page, between <!-- table NAME --> and <!-- end -->
# The files come from one run of each of these commands on a quiet machine:
#   touchstone report --out report
#   touchstone bench --filter '(simulation|bundled)/' --csv bench.csv
#   touchstone stress --out stress
#   touchstone bench --filter '^(link-chain|nut-and-bolt|bundled-curved)/' --csv curved-bench.csv
# SPDX-License-Identifier: MIT
set -euo pipefail
root=$1
page=$root/docs/accuracy-and-speed.md
folder=$root/docs/accuracy-and-speed

# rows FILE: an awk program, read from standard input, over the rows of FILE; get("column") is a field by its name.
rows() {
  local file=$1
  awk '
    function split_csv(line, fields,   i, c, quoted, count) {
      delete fields
      count = 1
      fields[1] = ""
      for (i = 1; i <= length(line); ++i) {
        c = substr(line, i, 1)
        if (c == "\"") quoted = !quoted
        else if (c == "," && !quoted) fields[++count] = ""
        else fields[count] = fields[count] c
      }
      return count
    }
    function get(name) { return field[column[name]] }
    function percent(part, whole) {
      if (part == 0) return "0"
      part = 100 * part / whole
      return part < 1 ? sprintf("%.2g %%", part) : sprintf("%.0f %%", part)
    }
    function of(part, whole) { return part == 0 ? "0" : part " of " whole }
    function power(x) { x += 0; return x == 0 ? "0" : x < 1000 ? sprintf("%d", x) : sprintf("1e%d", int(log(x) / log(10) + 1e-9)) }
    function grouped(n,   text) {
      text = sprintf("%d", n)
      while (match(text, /[0-9][0-9][0-9][0-9]($|,)/)) text = substr(text, 1, RSTART) "," substr(text, RSTART + 1)
      return text
    }
    NR == 1 { count = split_csv($0, head); for (i = 1; i <= count; ++i) column[head[i]] = i; next }
    { split_csv($0, field) }
    '"$(cat)" "$folder/$file"
}

table_machine() {
  rows report.csv <<'END'
    NR == 2 { printf "%s, %s, touchstone %s.\n", get("machine"), get("compiler"), get("version") }
END
}

table_errors() {
  printf '| queries | method | us a query | missed | phantom | late | greatest time error [ulps] |\n'
  printf '|---|---|---:|---:|---:|---:|---:|\n'
  rows report.csv <<'END'
    get("set") !~ /^(simulation|random|near|bundled|aligned)\// || get("queries") == 0 { next }
    get("method") !~ /^(closed_form|exact_only|touchstone|touchstone_cgal)$/ && get("method") get("tolerance") !~ /^newton(1e-06|1e-6)$/ { next }
    {
      shown = get("set") == last ? "" : get("set")
      last = get("set")
      printf "| %s | `%s` | %.3g | %s | %s | %s | %s |\n", shown, get("method"), get("mean_us"),
        percent(get("missed"), get("contacts")), percent(get("phantom"), get("queries") - get("contacts")),
        percent(get("late"), get("contacts")),
        get("ulps_greatest_magnitude") == "" ? "" : power(get("ulps_greatest_magnitude"))
    }
END
}

table_wrong() {
  rows report.csv <<'END'
    get("method") == "touchstone" && get("set") !~ /^scale\// {
      asked += get("queries")
      wrong += get("missed") + get("phantom") + get("late")
    }
    END { printf "`touchstone` is wrong on %d of %s queries.\n", wrong, grouped(asked) }
END
}

table_floor() {
  printf '| queries | floor [ns] | `solve`, x floor | in columns, x floor | exact arithmetic alone, x floor | slowest [us] |\n'
  printf '|---|---:|---:|---:|---:|---:|\n'
  rows bench.csv <<'END'
    get("set") !~ /^(simulation|bundled)\/[a-z-]*\/(all|hits)$/ || (get("set") ~ /^bundled/ && get("set") ~ /hits$/) { next }
    !(get("set") in seen) { seen[get("set")] = 1; order[++sets] = get("set") }
    {
      ratio[get("set"), get("method")] = get("ratio_to_floor")
      ns[get("set"), get("method")] = get("median_ns")
      slowest[get("set"), get("method")] = get("slowest_us")
    }
    END {
      for (i = 1; i <= sets; ++i) {
        s = order[i]
        printf "| %s | %.1f | %.3g | %.3g | %.3g | %.3g |\n", s, ns[s, "floor"], ratio[s, "touchstone"],
          ratio[s, "touchstone_columns"], ratio[s, "exact"], slowest[s, "touchstone"]
      }
    }
END
}

table_cgal() {
  rows bench.csv <<'END'
    get("set") !~ /^(simulation|bundled)\/[a-z-]*\/all$/ { next }
    !(get("set") in seen) { seen[get("set")] = 1; order[++sets] = get("set") }
    { ns[get("set"), get("method")] = get("median_ns"); if (get("method") == "touchstone_cgal") paired = 1 }
    END {
      printf "| queries | `fast` [us] |%s `exact` [us] | `oracle` [us] | oracle / exact |%s\n",
        paired ? " `fast_cgal` [us] |" : "", paired ? " fast_cgal / fast |" : ""
      printf "|---|---:|%s---:|---:|---:|%s\n", paired ? "---:|" : "", paired ? "---:|" : ""
      for (i = 1; i <= sets; ++i) {
        s = order[i]
        printf "| %s | %.3g |", s, ns[s, "touchstone"] / 1000
        if (paired) printf " %.3g |", ns[s, "touchstone_cgal"] / 1000
        printf " %.3g | %.3g | %.2g |", ns[s, "exact"] / 1000, ns[s, "oracle"] / 1000, ns[s, "oracle"] / ns[s, "exact"]
        if (paired) {
          slower = ns[s, "touchstone_cgal"] / ns[s, "touchstone"]
          printf(slower < 99.5 ? " %.2g |" : " %.0f |", slower)
        }
        printf "\n"
      }
    }
END
}

table_curvederrors() {
  printf '| queries | method | us a query | missed | phantom | late | greatest time error [ulps] |\n'
  printf '|---|---|---:|---:|---:|---:|---:|\n'
  rows report.csv <<'END'
    get("set") !~ /curved|^(link-chain|nut-and-bolt)\// || get("queries") == 0 || get("method") == "touchstone_cgal" { next }
    get("tolerance") != "" && get("tolerance") !~ /^(1e-06|1e-6)$/ { next }
    {
      shown = get("set") == last ? "" : get("set")
      last = get("set")
      some = get("queries") == get("set_queries") ? "" : sprintf(", asked %s of %s", get("queries"), get("set_queries"))
      printf "| %s | `%s`%s | %.3g | %s | %s | %s | %s |\n", shown, get("method"), some, get("mean_us"),
        percent(get("missed"), get("contacts")), percent(get("phantom"), get("queries") - get("contacts")),
        percent(get("late"), get("contacts")),
        get("ulps_greatest_magnitude") == "" ? "" : power(get("ulps_greatest_magnitude"))
    }
END
}

table_bodies() {
  printf '| steps | method | asked | us a step | missed | phantom | late |\n'
  printf '|---|---|---:|---:|---:|---:|---:|\n'
  rows report.csv <<'END'
    get("set") !~ /^bodies\// || get("queries") == 0 { next }
    {
      shown = get("set") == last ? "" : get("set")
      last = get("set")
      to = get("tolerance") == "" ? "" : get("method") == "waypoints" ? sprintf(", %d of them", 1 / get("tolerance") + 0.5) : sprintf(", to %g", get("tolerance"))
      printf "| %s | `%s`%s | %s of %s | %s | %s | %s | %s |\n", shown, get("method"), to, get("queries"), get("set_queries"),
        grouped(get("mean_us")), of(get("missed"), get("contacts")), of(get("phantom"), get("queries") - get("contacts")),
        of(get("late"), get("contacts"))
    }
END
}

table_curvedbench() {
  printf '| queries | straight [us] | `solve` [us] | x straight | exact arithmetic alone [us] | slowest [us] |\n'
  printf '|---|---:|---:|---:|---:|---:|\n'
  rows curved-bench.csv <<'END'
    get("set") ~ /^bundled/ && get("set") !~ /all$/ { next }
    !(get("set") in seen) { seen[get("set")] = 1; order[++sets] = get("set") }
    {
      us[get("set"), get("method")] = get("median_ns") / 1000
      ratio[get("set"), get("method")] = get("ratio_to_straight")
      slowest[get("set"), get("method")] = get("slowest_us")
    }
    END {
      for (i = 1; i <= sets; ++i) {
        s = order[i]
        printf "| %s | %.2g | %.3g | %.2g | %.3g | %.2g |\n", s, us[s, "straight"], us[s, "touchstone"],
          ratio[s, "touchstone"], us[s, "exact"], slowest[s, "touchstone"]
      }
    }
END
}

table_stress() {
  printf '| dial | `closed_form` wrong | `newton`, tolerance 1e-6, wrong | `touchstone` wrong | slowest / fastest setting |\n'
  printf '|---|---:|---:|---:|---:|\n'
  rows stress.csv <<'END'
    {
      dial = get("set")
      sub(/\/.*/, "", dial)
      if (!(dial in seen)) { seen[dial] = 1; order[++dials] = dial }
      method = get("method")
      if (method == "newton" && get("tolerance") !~ /^(1e-06|1e-6)$/) next
      asked[dial, method] += get("queries")
      wrong[dial, method] += get("missed") + get("phantom") + get("late")
      if (method != "touchstone" || get("queries") == 0) next
      mean = get("mean_us") + 0
      set = get("set")
      kinds[dial] = kinds[dial] " " set
      if (!(set in least) || mean < least[set]) least[set] = mean
      if (mean > most[set]) most[set] = mean
    }
    END {
      for (i = 1; i <= dials; ++i) {
        d = order[i]
        worst = 0
        count = split(kinds[d], names, " ")
        for (k = 1; k <= count; ++k) if (most[names[k]] / least[names[k]] > worst) worst = most[names[k]] / least[names[k]]
        printf "| %s | %s | %s | %s | %.2g |\n", d, percent(wrong[d, "closed_form"], asked[d, "closed_form"]),
          percent(wrong[d, "newton"], asked[d, "newton"]), percent(wrong[d, "touchstone"], asked[d, "touchstone"]), worst
      }
    }
END
}

table_simulation() {
  printf '| scene | edges | steps | contacts | crossings | ms a step | collision detection, response, proof | KB an edge |\n'
  printf '|---|---:|---:|---:|---:|---:|---:|---:|\n'
  rows simulation.csv <<'END'
    {
      ms = 1000 * get("seconds_per_step")
      memory = get("memory_bytes") == "" ? "" : sprintf("%.2g", get("memory_bytes") / get("edges") / 1000)
      printf "| `%s`, size %s | %s | %s | %s | %s | %s | %s | %s |\n", get("scene"), get("size"), grouped(get("edges")),
        get("steps"), grouped(get("contacts")), get("crossings"), ms < 1000 ? sprintf("%.3g", ms) : grouped(ms),
        percent(get("collision_share"), 1), memory
    }
END
}

new=$(mktemp)
trap 'rm -f -- "$new"' EXIT
inside='' tables=0
while IFS= read -r line; do
  if [[ $line =~ ^'<!-- table '([a-z]+)' -->'$ ]]; then
    inside=yes tables=$((tables + 1))
    printf '%s\n\n' "$line"
    "table_${BASH_REMATCH[1]}"
    printf '\n'
  elif [[ $line == '<!-- end -->' ]]; then
    inside=''
  fi
  [[ -n $inside ]] || printf '%s\n' "$line"
done <"$page" >"$new"
if ((tables == 0)) || [[ -n $inside ]]; then
  printf 'the page has no table, or a table without an end\n'
  exit 1
fi
if [[ ${2:-} == --update ]]; then
  cat -- "$new" >"$page"
elif ! diff -u -- "$page" "$new"; then
  printf 'The page differs from its CSV files: tests/pages/figures.sh . --update writes the tables.\n'
  exit 1
else
  printf '%s tables are those of the CSV files\n' "$tables"
fi
