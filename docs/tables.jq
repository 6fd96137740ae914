# The tables of docs/verification.md from what `fretval check --suite NAME --json FILE` writes: jq -r -f docs/tables.jq FILE
# and those of motions, forces and wear from results: jq -s -r -f docs/tables.jq report/*/*/result.json

def power_of_ten: log10 | floor;
def number:
  if . == null then "–" elif . == 0 then "0"
  else fabs as $size | ($size | power_of_ten) as $e | ($size / pow(10; $e) * 10 | round / 10) as $digits
    | (if $digits >= 10 then [1, $e + 1] else [$digits, $e] end) as [$d, $e]
    | (if . < 0 then "-" else "" end) + (if $e >= -1 and $e <= 1 then $d * pow(10; $e) * 100 | round / 100 | tostring else "\($d)e\($e)" end)
  end;
def line: "| " + join(" | ") + " |";
def table($heads): ($heads | line), ($heads | map("---") | line), (.[] | line);
def spread: if .median == .high then .median | number else "\(.median | number), \(.high | number)" end;

def exact_row:
  ["\(.solution): \(.quantity)", "\(.resolutions[0]) to \(.resolutions[-1]) \(.refined)", (.errors | map(number) | join(", ")),
   "\(if .observed_order == null then "floor" else .observed_order * 10 | round / 10 | tostring end) (\(if .expected_order == 0 then "exact" else .expected_order | tostring end))",
   (.tolerance | number), .verdict];

def quantity_row:
  [(.quantity | gsub("_"; " ")), (.tolerance | number), .errors, .above_bar, .wide, (.error | spread), (.bar | spread), (.effectivity.median | number)] | map(tostring);

# Families in the order in which they come.
def families: reduce .[] as $row ({}; .[$row.family] += [$row]) | to_entries[]
  | [.key, "\(.value[0].name) … \(.value[-1].name)", (.value | length),
     (.value | map(select(.verdict == "agrees")) | length), (.value | map(select(.verdict == "refused")) | length),
     (.value | map(select(.verdict == "inconclusive")) | length), (.value | map(select(.verdict == "FAIL")) | length)] | map(tostring);

# A case: radii over the contact radius.
def share($case): (. / $case.scene.contact_radius_unworn * 1e4 | round / 1e4 | tostring);
def beside($case; $q): if $case.mdr[$q] == null then ["none", "none", ""] else
  [($case.mdr[$q] | share($case)), ($case.comparison[$q].difference | number), ($case.comparison[$q].error_bar | number)] end;
# Energy of the tangential loop in µJ, of an elastic body all lost to friction, and the difference over sliding or the loop.
def loop($case): ($case.comparison | if has("tangential_work") then "tangential_work" elif has("friction_work") then "friction_work" else null end) as $q
  | if $q == null then ["–", "–", ""] else
    [($case.mdr[$q] * 1e6 | number), ($case.comparison[$q].difference | number), ($case.comparison[$q].error_bar | number)] end;
def motion_row: . as $case
  | [.name] + beside($case; "stick_radius_first_slip") + beside($case; "stick_radius_shakedown")
    + (($case.comparison.normal_force_max // $case.comparison.indentation_max) | [(.difference | number), (.error_bar | number)])
    + loop($case);

def compared($q): if .comparison[$q] == null then ["–", ""] else
    [(.comparison[$q].difference | number), (.comparison[$q].error_bar | number)] end;

def settling_row:
  def cycles: . * 1e2 | round / 1e2 | tostring;
  [.name, (.mdr.cycles_to_shakedown | cycles), (.mdr.cycles_to_shakedown_error | cycles), (.fe.cycles_to_shakedown | cycles)]
  + compared("cycles_to_shakedown") + [(.mdr.slip_decay | if . == null then "–" else . * 1e4 | round / 1e4 | tostring end)] + compared("slip_decay");

def cycle_row:
  [.name, (.mdr.tangential_force_max | if . == null then "–" else . * 1e3 | number end)] + (["tangential_force_max", "tangential_force_mean", "friction_work", "bulk_work", "cycle_work"] as $all
    | . as $case | [$all[] as $q | $case | compared($q)] | add);

def wear_row: . as $case | .fe.wear as $wear |
  [.name, (if .scene.wear_law.law == "power" then "p^\(.scene.wear_law.exponent)" else .scene.wear_law.law end),
   (.fe.stick_radius_shakedown // 0 | share($case)), ($wear.distance_to_limit.shakedown | number), compared("distance_to_limit")[1], ($wear.distance_to_limit.first_slip | number),
   ($wear.volume[-1] / $wear.volume_of_limit * 1e5 | round / 1e5 | tostring)] + compared("worn_volume") + compared("worn_radius")
   + [($wear.springs_difference | number), ($wear.cycles[-1] | number), (.cost.all.seconds * 10 | round / 10 | tostring)];

if type == "array" and (.[0] | .fe | has("wear")) then
  map(wear_row) | table(["case", "law", "c/a", "distance from the limit", "bar", "from that of first slip", "volume over that of the limit", "FE - MDR", "bar", "a_∞/a: FE - MDR", "bar", "springs, along the course", "cycles", "processor seconds"])
elif type == "array" and (.[0] | has("scene")) then
  (map(.comparison | to_entries[]) | "\(length) values, \(map(select(.value.pass)) | length) agree, \(map(select((.value.difference | fabs) <= .value.error_bar)) | length) lie within their bars."),
  "",
  (map(motion_row) | table(["motion", "c/a, first slip: MDR", "FE - MDR", "bar", "c/a, shakedown: MDR", "FE - MDR", "bar", "force, or depth under a force: FE - MDR", "bar", "loop, µJ: MDR", "FE - MDR", "bar"]))
  , (map(select(.comparison.tangential_force_mean) | cycle_row) | if length == 0 then empty else
      "", table(["motion", "largest F_x, mN: springs", "FE - springs", "bar", "mean F_x", "bar", "lost to friction", "bar", "in the body", "bar", "altogether", "bar"]) end)
  , (map(select(.comparison.cycles_to_shakedown) | settling_row) | if length == 0 then empty else
      "", table(["motion", "cycles to shakedown: springs", "their error", "finite elements", "FE over springs - 1", "bar", "decay of slip in a cycle: MDR", "FE over MDR - 1", "bar"]) end)
elif type == "array" then
  map(exact_row) | table(["solution: quantity", "refined", "errors", "order (expected)", "tolerance", "verdict"])
else
  (.summary | "\(.cases) cases: \(.agree) agree, \(.refused) refused by name as expected, \(.inconclusive) inconclusive, \(.fail) fail. \(.errors - .above_bar) of \(.errors) errors are within their bars. \(.computations) computations, \(.seconds | round) s."),
  "",
  ([.quantities[] | quantity_row]
    | table(["quantity", "tolerance", "errors", "above bar", "bars above tolerance", "error: median, 90 %", "bar: median, 90 %", "bar over error, median"])),
  (if [.rows[].family] | unique | length > 3 then
     "", ([.rows | families] | table(["family", "from … to", "cases", "agree", "refused", "inconclusive", "fail"]))
   else empty end)
end
