#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# How much tuned values matter: runs each at half and at twice its value, all others at
# their defaults, and writes a row of a CSV for it: name, value, the two values tried with
# the mean error of each, and the larger change of the error as a ratio to that without
# changes (1 = none). Values tried stay in their range. Rows that are there are not done
# again.
#
# usage: bash cmake/sensitivity.sh TOOLS CSV [NAME ...]
#   TOOLS  the folder of the programs, as build/examples
#   NAME   a tuned value, or the begin of several names as points.match; default: all
#   SCORER a command in the environment that is given "--tuning NAME=VALUE" (nothing for
#          the defaults) and prints its mean error as the last word; default: the mean
#          end-point error over small generated scenes. Recordings and clouds are scored
#          by a command of your own.
#   SCENES options of the default scorer for pcl_msf_evaluate
set -euo pipefail
export LC_ALL=C
tools="${1:?the folder of the programs}"
csv="${2:?the table to write}"
shift 2
scenes="${SCENES:---size 160x120 --frames 2 --seed 1}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

generated () { # mean end-point error in pixels over all generated pairs
  # shellcheck disable=SC2086
  "$tools/pcl_msf_evaluate" generated $scenes --methods msf --quiet "$@" \
    --csv "$work/rows.csv" >/dev/null </dev/null || true # what is there counts
  awk -F, '/^pair,/ { for (i = 1; i <= NF; ++i) if ($i == "epe_all") column = i; next }
    column && $column != "" { sum += $column; ++n }
    END { print n ? sum / n : "nan" }' "$work/rows.csv"
  rm "$work/rows.csv"
}

score () {
  # shellcheck disable=SC2086
  if [ -n "${SCORER:-}" ]; then
    $SCORER "$@" </dev/null | awk 'NF { last = $NF } END { print last }'
  else
    generated "$@"
  fi
}

tried () { # FACTOR VALUE LEAST MOST KIND: kept in its range
  awk -v f="$1" -v v="$2" -v a="$3" -v b="$4" -v kind="$5" 'BEGIN {
    x = f * v; if (x < a) x = a; if (x > b) x = b
    print kind == "whole" ? int(x) : x }'
}

wanted () { # NAME BEGIN...
  local name="$1" begin
  shift
  [ $# -gt 0 ] || return 0
  for begin in "$@"; do
    if [[ "$name" == "$begin"* ]]; then return 0; fi
  done
  return 1
}

"$tools/pcl_msf_evaluate" --list-tuning >"$work/all"
[ -s "$csv" ] || echo "name,value,default,half,half_mean,twice,twice_mean,ratio" >"$csv"
default="$(score)"
while read -r name value least most kind; do
  wanted "$name" "$@" || continue
  ! grep -q "^$name," "$csv" || continue
  half="$(tried 0.5 "$value" "$least" "$most" "$kind")"
  twice="$(tried 2 "$value" "$least" "$most" "$kind")"
  half_mean="$(score --tuning "$name=$half")"
  twice_mean="$(score --tuning "$name=$twice")"
  ratio="$(awk -v d="$default" -v h="$half_mean" -v t="$twice_mean" 'function far(x) {
      return x > d ? x / d : d / x }
    BEGIN { if (h + 0 <= 0 || t + 0 <= 0 || d + 0 <= 0) print "nan"
      else { r = far(h) > far(t) ? h / d : t / d; printf "%.4f\n", r } }')"
  echo "$name,$value,$default,$half,$half_mean,$twice,$twice_mean,$ratio" | tee -a "$csv"
done <"$work/all"
