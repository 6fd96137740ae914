# docs/benchmarks.json and docs/benchmarks.md, from the cases and from what `fretval run cases/benchmarks -o DIR` writes:
#   jq -n --arg form json -f docs/benchmarks.jq cases/benchmarks/*.json DIR/*/result.json > docs/benchmarks.json
#   jq -r -n --arg form page -f docs/benchmarks.jq cases/benchmarks/*.json DIR/*/result.json > docs/benchmarks.md

def digits($n): if . == null or . == 0 then . else
  (fabs | log10 | floor) as $e | if $n - 1 - $e >= 0 then . * pow(10; $n - 1 - $e) | round / pow(10; $n - 1 - $e)
    else . / pow(10; $e - $n + 1) | round * pow(10; $e - $n + 1) end end;
def quantities: ["contact_radius_max", "stick_radius_first_slip", "stick_radius_shakedown", "normal_force_max", "axis_pressure_max", "indentation_max",
  "tangential_amplitude", "tangential_force_max", "cycle_work", "worn_radius"];
# In SI: radii are compared over the contact radius, all else relatively.
def bar($case; $q): $case.comparison[$q].error_bar as $bar | if $bar == null then null else
  ($bar * (if $q | startswith("stick_radius") or . == "worn_radius" then $case.scene.contact_radius_unworn else $case.fe[$q] // 0 end) | digits(2)) end;
# Springs stepped through a cycle have an error of their own; what has a closed form has none.
def mdr_error($case; $q): if $case.mdr[$q] == null then null else
  {tangential_force_max: $case.mdr.cycle_error.force, cycle_work: $case.mdr.cycle_error.work}[$q] | digits(2) end;
def answer($case): reduce quantities[] as $q ({}; if $case.mdr[$q] == null and $case.fe[$q] == null then . else
  .[$q] = {mdr: ($case.mdr[$q] | digits(6)), fe: ($case.fe[$q] | digits(6)), error_bar: bar($case; $q)}
  + (mdr_error($case; $q) | if . == null then {} else {mdr_error: .} end) end);

[inputs | {file: input_filename, value: .}] as $all
| [$all[] | select(.value.Indenter) | (.file | split("/")[-1] | rtrimstr(".json")) as $name
   | {name: $name, input: .value, answer: answer($all[] | select(.value.name? == $name) | .value)}] as $cases
| def cell($a; $scale): if $a == null then "none" else
    "\($a.mdr * $scale | digits(6)) | \(if $a.fe == null then "–" else $a.fe * $scale | digits(6) end) | \(if $a.error_bar == null then "" else $a.error_bar * $scale | digits(1) end)" end;
  def cells($case; $q; $scale): $case.answer[$q] as $a | if $a == null or $a.mdr == null then "none | none | " else cell($a; $scale) end;
  def row: "| \(.name) | \(cells(.; "contact_radius_max"; 1e3)) | \(cells(.; "stick_radius_first_slip"; 1e3)) | \(cells(.; "stick_radius_shakedown"; 1e3)) | \(cells(.; "normal_force_max"; 1e3)) |";
  if $form == "json" then {units: "SI, degrees, Hz", cases: $cases} else
  "# Benchmarks for other codes",
  "",
  "\($cases | length) cases of contact and fretting on an incompressible half-space, to hold any other code to. Each is specified in full, in plain numbers, in [`benchmarks.json`](benchmarks.json) (and as a case file in [`cases/benchmarks`](../cases/benchmarks)), with what both methods say:",
  "MDR is exact for what it assumes; finite elements share no code with it and come with their own error bars. Entries are explained in [case_file.md](case_file.md). A rigid indenter of profile f(r) is pressed by d(t) = d0 + Δd cos(2π f_z t) into the half-space and moved by u_x(t) =",
  "u_x0 cos(2π f_x t + φ0); Coulomb's friction, the traction keeps the direction of the motion. Forces are those of the periodic state.",
  "",
  "Two stick radii: what has *never* slipped since rest, and what does not slip any more in the periodic state ([theory.md](theory.md#two-stick-radii)). A code that steps through time from rest and looks at a late cycle finds the second; where the two differ, the first is not what it",
  "should be held to. The paper has the first alone, and its equation (23) has μ in the wrong place, (29) a modulus that tends to 0 instead of G1 + G2 ([theory.md](theory.md#misprints-of-the-paper)); the numbers here are of the right ones.",
  "",
  "Lengths in mm, forces in mN; ±: error bar of the finite elements. In the JSON file besides: the largest pressure on the axis (Pa; not under a cone); the outer radius of wear; of locked motions without a dashpot the largest tangential force and, in a body with memory, the energy lost in a cycle (MDR's by springs, with their error `mdr_error`); under prescribed forces (20) indentation and tangential amplitude.",
  "",
  "| case | largest contact radius: MDR | FE | ± | first slip: MDR | FE | ± | shakedown: MDR | FE | ± | largest force: MDR | FE | ± |",
  "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |",
  ($cases[] | row),
  "",
  "Numbers of your own are held to one of them by `fretval score my.csv --benchmark 10-elastic-60-degrees`: a table of one row, with names of quantities as in the JSON file, a line of their units and one of numbers; it says by how much each differs, and where a stick radius is the other one. Exit code 1 where one is farther off than `--tolerance` (1e-2).",
  "",
  "Both files are made by [`benchmarks.jq`](benchmarks.jq) from `fretval run cases/benchmarks`; a test holds the first to what MDR says today."
  end
