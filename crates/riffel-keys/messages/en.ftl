# What Riffel says. One message an entry: its English, and in .short the same in one line for a terminal.

verbatim = { $words }

## Windows, values and presets

map-window = map
traffic-window = traffic
unusual-value = { $key } is { $value }; usual values are { $from } to { $to }{ $question }
number-without-unit = { $key } has no unit and is read as { $read }{ $question }
quoted = "{ $words }"
# Beside errors, of four letters.
help-in-four-letters = help
note = note: { $remark }
sentence = { $words }.
in-brackets = {" "}({ $words })
did-you-mean = did you mean { $meant }?
did-you-mean-either = did you mean { $one } or { $other }?
preset-changes-nothing = { $key } = "{ $name }" changes nothing: the case gives all of its values itself

## Measured receptances

value-at-zero-left-out = the measured value at 0 Hz is left out
set-signs = write { KEY("track.measurement.conjugate") } = { $conjugate } and { KEY("track.measurement.negate") } = { $negate }
set-one-of-the-signs = set { KEY("track.measurement.conjugate") } or { KEY("track.measurement.negate") }, whichever it is
conjugate-it = conjugate it
negate-it = change its sign
conjugate-and-negate-it = conjugate it and change its sign
conjugate-or-negate-it = conjugate it or change its sign, whichever it is
receptance-gives-energy = the measured receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies, between { $first } and { $last } Hz: check its phase and its noise
    .short = the measured receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies: check its phase
response-conjugated = the receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies, and the sign of its real part is right: it is conjugated, as with exp(−iωt). To have it with exp(+iωt), { $remedy }
response-negated = the receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies, and its real part has the wrong sign as well: it is turned in sign, for sensor and force point against each other. To turn it, { $remedy }
response-conjugated-and-negated = the real part of the receptance has the wrong sign for its modulus: it is conjugated, as with exp(−iωt), and turned in sign. To turn it, { $remedy }
response-conjugated-or-negated = the receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies: it is conjugated, as with exp(−iωt), or turned in sign. To turn it, { $remedy }
response-of-other-quantity = the receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies, but its phase goes with its modulus, as that of a mobility or an accelerance does: check what was measured, and its unit
response-mirrored = above { $hertz } Hz the response runs backwards through the conjugates of its own values, as the upper half of a two-sided spectrum does: leave out the lines above
response-delayed = the phase of the measured response turns by { $degrees }° up to { $hertz } Hz beside the one that goes with its modulus, as with { $milliseconds } ms between the channels of force and response: take the delay off, else growth is that of another track
    .short = the phase of the measured response turns by { $degrees }° as with a delay of { $milliseconds } ms: take it off
response-ripples = the modulus of the measured response ripples every { $hertz } Hz, as where the hammer hit twice, { $milliseconds } ms apart: leave such blows out
    .short = the measured response ripples every { $hertz } Hz, as where the hammer hit twice
receptance-in-si = a receptance in m/N
mobility-in-si = a mobility in m/s/N
accelerance-in-si = an accelerance in m/s²/N
column-without-unit = column `{ $column }` names no unit: taken as { $what } (else set { KEY("track.measurement.quantity") } and unit)
receptance-unlike-rail = the measured receptance is { $least } to { $most } m/N, but rails have 1e-11 to 1e-7 m/N: check quantity and unit, in a case { KEY("track.measurement.quantity") } and unit
poor-coherence = the coherence is below { $good } at { $count } of { $points } frequencies, between { $first } and { $last } Hz: there the receptance is the mean of the lines within 1/24 octave, weighted by γ²/(1 − γ²)
response-at-other-node = the measured response is at node { $response } and its force at node { $reference }: it is taken as the receptance at the contact

## Ranges of validity

response-known-from = lies below { $wavelength } mm: the table of the exact contact does not converge on shorter waves
take-longer-waves-or-another-grid = take longer waves, or another { KEY("contact.grid") }
map-begins-where-contact-is-known = the map begins at { $wavelength } mm: on shorter waves the table of the exact contact does not converge; another { KEY("contact.grid") } may
rail-without-support = the rail has no support: below about { $free_beam_from_hz } Hz (lowest of the { $window }: { $lowest } Hz) pads, sleepers and ballast change its receptance
    .short = the rail has no support: wrong below about { $free_beam_from_hz } Hz ({ $window } from { $lowest } Hz)
rail-without-shear = the rail bends without shear: its receptance is some 9° off at { $euler_beam_up_to_hz } Hz, 24° and 14 % at 1500 Hz (highest of the { $window }: { $highest } Hz)
    .short = the rail bends without shear: 24° and 14 % off at 1500 Hz ({ $window } to { $highest } Hz)
pinned-pinned-without-shear = the rail bends without shear: its pinned-pinned frequency is overstated by 20 to 35 % or more and not named (choose { KEY("rail.beam") } = "timoshenko")
    .short = the rail bends without shear: its pinned-pinned frequency is too high and not named
supports-spread-evenly = supports are spread evenly along the rail: the pinned-pinned resonance near { $pinned } Hz is missing, and below it the receptance is 10 to 50 % off, more on very stiff pads (highest of the { $window }: { $highest } Hz; choose a model that ends in -periodic)
    .short = supports are spread evenly: no pinned-pinned resonance near { $pinned } Hz ({ $window } to { $highest } Hz)
no-average-over-patch = the contact is quasi-static and does not average over its patch: below { $shortest } mm growth is overstated
    .short = the contact does not average over its patch: growth is overstated below { $shortest } mm
closed-form-of-ellipse = the radii of wheel and rail differ much: the closed form of the contact ellipse is { $percent } % off across the rail (choose { KEY("contact.hertz") } = "exact")
    .short = the closed form of the contact ellipse is { $percent } % off ({ KEY("contact.hertz") } = "exact" is not)
falling-friction-at-one-speed = falling friction is that of the slip at { $rolling }, { KEY("contact.polach.speed") }, at every speed of the { $window }
    .short = falling friction is that at { $rolling } at every speed of the { $window }
wheel-and-rail-part = an amplitude of { $amplitude } µm makes |P₁/P₀| reach { $worst }: wheel and rail part; forces are linear up to { $limit } µm (growth rates hold for small amplitudes and do not change)
    .short = { $amplitude } µm make wheel and rail part (|P₁/P₀| = { $worst }); forces are linear up to { $limit } µm
wave-geometry-left-out = the wave's own geometry has no part ({ KEY("contact.wave_geometry") }): it would take some { $takes } per m off a growth of { $growth } per m, at { $wavelength } mm and { $speed }
    .short = without the wave's own geometry, which would take some { $takes } per m off { $growth } ({ KEY("contact.wave_geometry") })
wave-shorter-than-patch = below { $shortest } mm, three half-lengths of the patch, the wave's own geometry is a rough estimate
troughs-bridged = below { $bridged } mm the wheel bridges the troughs of waves of { $amplitude } µm (growth rates hold for small amplitudes)
    .short = below { $bridged } mm the wheel bridges troughs of { $amplitude } µm

## Branches of the ridge

at-edge-of-window = , at the edge of the window
nothing-grows = nothing grows in this window
both = { $one } and { $other }
one-after-other = { $one }; { $other }
before-comma = { $words },{" "}
branch = { $frequency } Hz ({ $mechanism }{ $speeds }, { $wavelengths } mm{ $edge })
no-crest = no crest lies in this window: growth rises towards { $ends } mm
one-branch = the ridge is one branch, which grows at { $words }
branch-with-share = { $words } with { $share } of its growth
more-branches = { $count } more
weaker-branches = { $count ->
        [one] 1 weaker branch
       *[other] { $count } weaker branches
    }
strongest-branch = the strongest branch grows at { $words }; { $noun }: { $named }

## Mechanisms

mechanism-p2 = P2 resonance
mechanism-wheelset-torsion = wheelset torsion
mechanism-wheelset-bending = wheelset bending
mechanism-full-track = full-track resonance
mechanism-sleeper-antiresonance = sleeper antiresonance
mechanism-rail-on-pad = rail on pad
mechanism-pinned-pinned = pinned-pinned, vertical
mechanism-measured-peak = peak of the measured receptance
mechanism-measured-dip = dip of the measured receptance
mechanism-given-peak = peak of the given receptance
mechanism-given-dip = dip of the given receptance

## Captions: the track

rail-word = rail
under-moving-load = {" "}under a moving load
receptance-from-file = receptance read from { $file }
free-beam = free { $beam } beam{ $moving }
rail-on-pads = { $beam } rail{ $moving } on pads ({ $pad })
sleepers-and-ballast = , sleepers ({ $mass } kg) and ballast ({ $ballast })
spacing = {" "}every { $spacing } m,{" "}
discrete = discrete
spread-evenly = spread evenly
from-preset = , preset { $name }

## Captions: the case

track = Track
constant-tangential-force = constant tangential force (I_w → 0)
constant-creepage = constant creepage (I_w → ∞)
wheelset = wheelset
non-steady-contact = non-steady contact
phase-lag = dissipation phase: lag
phase-lead = dissipation phase: lead
phase-none = dissipation phase: none
creep-law = creep law
spring-and-dashpot = spring and dashpot;{" "}
sign-of-growth = Corrugation grows where Re Ŵ₁ < 0 (coloured): the dissipation is in antiphase with the profile; time factor exp(+iωt), braking positive.

## Figures of the paper

figure-4 = Figure 4. Real part of the dissipation, free Euler beam
figure-5 = Figure 5. Real part of the dissipation, track of Bhaskar et al.
parameters-of = Parameters of ({ $letter }): { $parameters } { $sign }
plus-spring-and-dashpot = , spring and dashpot
plus-non-steady = , non-steady contact
speed-axis = speed V [m/s]
minima-over-wavelengths = Minima over wavelengths of 20–80 mm.
figure-6 = Figure 6. Highest growth over speed
minima-inside-window = Minima over wavelengths of 20–80 mm; (b) leaves out minima at the edge of the window.
panel-of-tractive-ratio = (a) tractive ratio
panel-of-inertia = (b) inertia, τ = 0.1
wavelength-axis = wavelength λ [mm]
figure-7 = Figure 7. Highest growth over speed for different inertia
figure-8 = Figure 8. Highest growth at { $speed } m/s
falls-in-part = (a) falls up to τ ≈ 0.9 only.{" "}
tractive-ratio-axis = tractive ratio τ [-]
inertia-axis = inertia I_w [kg m²]
frequency-axis = frequency f [Hz]
beam-under-moving-load = beam under a moving load
track-of-bhaskar = track of Bhaskar et al. (inferred)
figure-2 = Figure 2. Vertical direct receptance
caption-of-figure-2 = Load at { $speed } m/s, exp(+iωt), displacement and force downward. Solid: { $solid }. Dashed: { $dashed }.
modulus = modulus
phase = phase
figure-3 = Figure 3. Normal force
caption-of-figure-3 = V = { $speed } m/s, equation (24). { $parameters }
amplitude = amplitude
profile-over-rail = Δ/H rail
profile-over-wheel = Δ/H wheel

## A wheel in time

loss-factors-not-causal = loss factors are not causal: in time the track is a causal one near it, with dashpots in its layers where need be, { $per_cent } % rms off in receptance
fitted-receptances-off = in time receptances of track and wheels are { $per_cent } % rms off up to 3 kHz, { $most } % at worst: loss factors are not causal, and waves between wheels far apart take more oscillations than are fitted
unstable-but-still = the linear loop is unstable, but nothing has been seen to grow: what grows does so more slowly than this run shows, or the structures in time are stable where those of the loop are not
stable-but-limit-cycle = the linear loop is stable, but the push is large enough for a limit cycle beside the state of rest
support-passing-close-to-wave = passing the supports shakes the wheel every { $length } mm as well, too close to this wave to tell them apart: harmonics hold both
airborne-run-ends = after { $passages } passages the wheel is in the air for more than half of the time, and the run ends there: steel yields where it comes down
wheels-slide-as-they-roll = the wheels slide as fast as they roll: with so much creepage the creep forces fall short of those of the mean state, and nothing else holds the wheels; give them { KEY("wheelset.suspension") }, or less creepage
wheel-bridges-trough = a wheel of this radius does not reach the troughs of such waves above { $largest } µm: it would touch in two places, and here touches in one
edge-of-patch-not-resolved = the load moves the edge of the patch by { $moves } elements: harmonics of the creep force may be tens of per cent off; take a larger amplitude, or more than { $across } elements across ({ KEY("contact.grid") }), until it is { $resolved }

## Profiles

flat-patch-beyond-range = the rail turns by { $degrees }° across a patch: the flat one holds to some 23°, half a width over the radius of 0.2; beyond, take the conformal one beside it
positions-do-not-rise = { KEY("--from") } is { $from } m and { KEY("--to") } { $to } m, but positions must rise
spectra-have-no-positions = { $key } is { $position }, but the file is a table of spectra, which has no positions
no-column-of-rails = { KEY("--rail") } is { $rail }, but the table has no column `rail`
spacing-is-not-positive = { KEY("--spacing") } is { $spacing }, but must be greater than zero
spacing-is-not-that-of-positions = { KEY("--spacing") } is { $spacing }, but the positions are { $metres } m apart
measures-not-measured = { $name }: { $measures } { $count ->
    [one] is
   *[other] are
 } not told: the points have a gap or end there
rail-worn-on-field-side = { $name }: { $millimetres } mm are left on the field side by which it is laid: it is worn there, or inclined ({ KEY("--inclination") }), or another rail

## Files of profiles

flange-backs-apart = the flange backs of the file are { $distance } mm apart
tread-datum-elsewhere = its tread datum lies { $datum } mm from the flange back, but the wheel is placed by its flange back, and its origin lies { $origin } mm from it
gauge-of-file = the gauge of the file is { $distance } mm, { $depth } mm below the crown
smoothing-of-file-left-out = the smoothing of the file (approx.smooth) is not that of Riffel and is left out: give the scatter of its points
points-missing = the head announces { $announced } points (XYPoints), but { $count } follow: the file may be cut short
masked-points-left-out = { $masked } points that were masked at the device are left out
profile-has-gaps = { $name }: no points across { $gaps }: a smooth curve is drawn there, and wear, flange and conicity that reach there are not measured
between-millimetres = { $from } to { $to } mm
outlying-points-left-out = { $name }: { $count } points far off those beside them are left out, the first in line { $line }
scatter-of-curvature = { $name }: scatter leaves ±{ $error } 1/m of the curvature at x = 0
points-scatter = { $name }: the points scatter by { $micrometres } µm, so that the curvature of a curve through them is off by some { $curvature } 1/m; give that scatter (profiles.scatter, { KEY("--scatter") }) for a smooth one

## Curves

wheelset-beyond-flange = a wheelset is shifted by { $shift } mm: flanges leave 5 to 10 mm of play, and this case has none
linear-creep-beyond-friction = creep_law = "linear" knows no friction: creep forces reach { $most } of μP
yaw-takes-play = with its yaw of { $yaw } mrad wheelset { $number } has { $yawed } mm to its flange, not the { $straight } mm of the tables: contacts are placed as without yaw

## The mean state from a curve

creep-law-without-spin = { KEY("contact.creep_law") } = "{ $name }" knows no spin: the { $spin } 1/m of the curve are left out ({ $key })
case-has-own-values = in place of what that curve says the case has its own { $instead }
no-rigid-contact-at-angle = no rigid contact has the angle of the equilibrium, { $degrees }°
patches-join = the patch joins that of the place where the wheel touches next
two-points-join-under-load = the wheel stands on two points, which a patch under load would join

## Ranges of validity, further

ellipse-too-wide = the ellipse of the contact is { $width } mm wide: over that no profile has one curvature, and Hertz's theory ends
loop-not-judged = whether the loop is stable at { $speed } cannot be told: its phase jumps, as at a resonance without damping or beyond measured frequencies; give wheelset, rail and pads a loss factor
loop-unstable = the loop is unstable at { $speed }: near { $frequency } Hz it oscillates without any profile (squeal, stick and slip){ $growth }, and growth rates mean nothing there
loop-unstable-growth = , growing e-fold in { $time }{ $others }
loop-unstable-other = , one of { $frequency } Hz e-fold in { $time }{ $others }
stability-title = Oscillation without any profile
stability-caption = Solid: the boundary; on the side of the mark an oscillation of the named frequency grows by itself (known to half a step of the grid). Dotted and dashed: how fast, e-fold so many times a second. Mark: where it grows fastest. Where several grow, the highest frequency is shown.
stability-of-one-axis = a wheel that only moves down and turns does not oscillate by itself; give it creepage or motion across the rail, as { KEY("contact.from") } or a [wheelset] does
stability-unknown = { $points } points cannot be told: the phase of the loop jumps there, as at a resonance without damping; give wheelset, rail and pads a loss factor
no-mean-state = at a friction of { $friction } the wheels find no mean state; those points are left out
stable-everywhere = the loop is stable from { $slowest } to { $fastest } up to a friction of { $highest }
unstable-from = an oscillation grows by itself from a friction between { $stable } and { $least } on, somewhere from { $slowest } to { $fastest }
unstable-from-the-least = an oscillation grows by itself even at the least friction looked at, { $least }, somewhere from { $slowest } to { $fastest }
branch-from = from Hz
branch-to = to Hz
least-friction = least friction
fastest-growth-in-time = fastest growth 1/s
at-speed-column = at km/h
at-friction-column = at friction
wheel-flatter-than-radius = at { $angle }° the wheel is { $flatter } times as flat along the rail as its rolling radius, which the ellipse takes: give { KEY("contact.longitudinal_radius") }
track-moves-downward-only = this track moves downward alone; along and across the rail it is taken as rigid

## Measured wheelsets

column-of-wheelset-without-unit = column `{ $column }` names no unit: taken as a receptance in m/N (else write it, as in `{ $column } [m/s2/N]`)
wheelset-not-reciprocal = the measured wheelset is not reciprocal: { $at } by a force at { $from } and the reverse differ by up to { $percent } %, at { $hertz } Hz; their mean is taken: check accelerometer, hammer and the sign of the axes
wheelset-gives-energy = the measured wheelset gives energy away, by up to { $percent } % of its largest receptance, at { $hertz } Hz, most at { $port }: check phases, noise, missing entries, and whether it follows exp(+iωt)
wheelset-not-measured-along = the wheelset was not measured along { $axes }: there it is taken as rigid

## Cases

creep-law-unlike-equilibrium = { KEY("contact.creep_law") } = "{ $law }" makes |Q| = { $here } μP of creepages at which the equilibrium of the curve has { $in_curve }
creep-law-of-growth-only = { KEY("contact.creep_law") } = "{ $law }" is that of growth: in the curve creep is of Shen, Hedrick and Elkins
modes-of-wheelset-end = the modes of the wheelset describe it up to some { $up_to } Hz, and the window reaches { $highest } Hz: add modes or rows `residual`

## Curves, patches and files, with their parts

second-point-left-out = { $rail } the wheel stands on two points; the other one, with { $percent } % of its normal forces, is left out of the loop
on-left = on the left rail
on-right = on the right rail
of-left = of the left rail
of-right = of the right rail
on-low-left = on the low, left rail
on-low-right = on the low, right rail
on-high-left = on the high, left rail
on-high-right = on the high, right rail
mean-state-from-curve = mean state from the curve of { $radius } m at { $speed }: wheelset { $wheelset } { $rail } creeps { $along } % along, { $across } % across, spin { $spin } 1/m, under { $load } kN at { $angle }°
ellipse-in-place-of-patch = { $rail } the loop takes the ellipse of Hertz and no patch of the profiles under load: { $reason }
patch-under-load-against-hertz = ; the profiles under load, on the curved rail, are stiffer by { $stiffer } %, { $longer } % as long and { $wider } % as wide ({ KEY("contact.from.patch") } = "conformal" takes them)
contact-is-conformal = the semi-axis across is { $semi_axis } mm, { $share } of the radius { $rail } there, and Hertz's theory is for patches up to 0.2 to 0.3: beyond, the contact is conformal{ $under_load }
patch-of-profiles = { $rail } the patch is that of the profiles under load: { $stiffness } MN/m ({ $stiffer } % against Hertz), like an ellipse of semi-axes { $along } mm along ({ $longer } %) and { $across } mm across ({ $wider } %), at { $angle }° ({ $turned }°)
patch-of-profiles-alone = { $rail } the patch is that of the profiles under load: { $stiffness } MN/m, like an ellipse of semi-axes { $along } mm along and { $across } mm across, at { $angle }° ({ $turned }°); Hertz has none there
several-equilibria = the vehicle has { $count } equilibria in this curve; the contact is { $which }
equilibrium-from-straight-track = that which straight track leads to
equilibrium-found-first = of the first found, to which straight track does not lead
about = { $subject }: { $remark }
coordinates-right = stand as they should
coordinates-mirrored = are mirrored
coordinates-upside-down = are upside down
coordinates-turned = are mirrored and upside down
read-as-wheel = read as a wheel: its coordinates { $changes }
read-as-rail = read as a rail: its coordinates { $changes }; x below zero is taken as the gauge side, or give the orientation "mirrored"
read-as-leaning-rail = read as a rail: its coordinates { $changes }; its head leans by { $off } mm to x below zero, which is the gauge side of an inclined rail
read-as-undecided-rail = read as a rail: its coordinates { $changes }; its head leans by { $off } mm, farther than that of an inclined rail (20 mm), so that its gauge side is undecided: x below zero is taken, or give the orientation "mirrored"
rail-leans-outward = its head leans by { $off } mm to x above zero, as that of an inclined rail does to its gauge side; if that is the gauge side, give the orientation "mirrored"
offset-added = XOffset and YOffset of the file are added, { $x } mm and { $y } mm
offset-is-in = XOffset of the file, { $x } mm, is left out: the flange back shows that the coordinates have it already
flange-back-elsewhere = the flange back lies at x = { $back } mm, but is taken to lie at { $usual } mm: the wheel stands { $off } mm off on its axle; move the origin to the datum circle, or give profiles.flange_back_position
origin-moved = its origin is moved to the { $place }, by x = { $x } mm and y = { $y } mm
to-crown = crown
to-datum-circle = datum circle
rail-taken-as-rigid = the rail is taken as rigid { $direction }: give { $keys } to let it move
across-track = across the track
along-itself = along itself
t-gamma-below-zero = Tγ of wheel { $wheelset } { $rail } is { $wear } N: it is Qx ξx + Qy ξy without the moment of spin, and spin, not creepage, makes the lateral force there
ellipse-of-wheel-too-wide = the ellipse of wheel { $wheelset } { $rail } is { $width } mm wide: over that no profile has one curvature, Hertz's theory ends, and creep laws differ most
left = left
right = right

## Values of presets: how well they are known

badge-measured = measured
badge-typical = typical
badge-assumed = assumed

## Traffic

growth-faster-than-any-seen = growth at { $wavelength } mm is faster than any railway known: wavelengths and order hold, the rate does not; the fastest amplitude known here doubled in { $known } days, in a metro curve of 120 m radius (Torstensson & Nielsen 2009); check { $keys }
keys-of-traction = tractive_ratio, traction_share (the share of axles under it) and { KEY("wear.coefficient") }
keys-of-sliding = creepage, traction_share (the share of axles under it) and { KEY("wear.coefficient") }

## What the fastest wavelength follows

cause-near = { $wavelength } mm grows most at { $speed }, where { $frequency } Hz lies { $distance } % from { $resonance } Hz ({ $mechanism })
cause-at = { $wavelength } mm grows most at { $speed }, at { $frequency } Hz, a resonance ({ $mechanism })
cause-alone = { $wavelength } mm grows most at { $speed }, at { $frequency } Hz; no resonance of track or wheelset lies within { $within } % of that
cause-loop = no resonance: the loop of force, creepage and wear
frequency-is-kept = from { $slow } to { $fast } the fastest wavelength goes from { $first } to { $last } mm and its frequency from { $low } to { $high } Hz: a frequency is fixed, not a length
frequency-is-not-kept = from { $slow } to { $fast } the frequency of the fastest wavelength goes from { $low } to { $high } Hz: no one frequency is fixed
others-in-reach = trains of this traffic pass over { $wavelength } mm at { $low } to { $high } Hz, and there are also { $others }
others-out-of-reach = no other resonance lies at { $low } to { $high } Hz, at which trains of this traffic pass over { $wavelength } mm
mechanism-at = { $mechanism } ({ $frequency } Hz)
nothing-against = nothing that the case knows speaks against it

## Remedies

softer-ballast = half the stiffness under the sleepers
more-rail-loss = rail dampers that raise the loss factor of the rail by { $loss }
friction-treatment = friction treatment down to { $friction }
lighter-wheel = a fifth less unsprung mass
wider-speeds = speeds spread more widely
slower-trains = trains a fifth slower
more-grinding = a shorter grinding interval
remedy-column = remedy
remedy-changes-column = changes
growth-change-column = growth %
doubles-in-column = doubles in
ground-after-column = ground after
nothing-grows-then = nothing grows
helps-most = what helps most is { $title }: growth falls by { $percent } % and doubles in { $time }
helps-most-of-all = what helps most is { $title }: nothing grows then
helps-most-in-order = what helps most is { $title }: growth falls by { $percent } %
helps-nothing = none of these remedies slows growth
left-out-for = left out: { $title }; { $reason }
vehicles-differ = { $key } differs between the vehicles, or is spread over their wheels: change it in the traffic file
remedy-lacks-key = the case has no value of { $key }
remedy-has-no-effect = { $key } changes nothing in this case
remedy-is-refused = this case cannot be computed with it
friction-is-low = friction is { $friction } already
grinding-leaves-fast-growth = grinding lowers the level and leaves growth as it is
grinding-leaves-growth = grinding lowers the level and leaves growth as it is, 6 dB in { $time }
ground-as-it-is = as it is, the first band rises by 6 dB from what grinding leaves in { $time }: this is the grinding interval of a limit so far above
steps-are-chosen = how far each remedy goes is chosen; what a product does stands in its data sheet
speeds-are-wide = speeds are spread about as widely as a normal distribution can be
treatment-keeps-force = with the friction treatment trains pull and brake with the same force, at more creepage; where a curve sets the creepage, give { KEY("contact.creepage") } in place of { KEY("contact.tractive_ratio") }

## The field

field-wavelength = wavelength
field-frequency = frequency
field-growth = growth
field-shorter-wave = shorter of the two strongest waves
field-longer-wave = longer of the two strongest waves
field-high-over-low = high rail over low rail
field-outer-over-inner = outer rail over inner rail
field-with-modifier = growth with a friction modifier, over that without
decibels-per-million-axles = dB per million axles
field-is-kept = predicted by riffel { $version } at the wear of rails in service with { $samples } samples of each site, once, and kept by the project: { $inside } of { $outcomes } measured values lie inside, the logarithmic score is { $score }

## Growth under the traffic of a line

traffic-of-main-line = the usual traffic of a main line
traffic-of-freight-line = the usual traffic of a freight line
traffic-of-heavy-haul = the usual traffic of a heavy-haul line
traffic-of-metro = the usual traffic of a metro
traffic-of-tram = the usual traffic of a tramway
traffic-of-curve = the usual traffic of this curve
traffic-given = the traffic given
traffic-at-speeds = { $traffic } ({ $speeds })
traffic-at-speeds-a-day = { $traffic } ({ $speeds }, { $axles } axles a day)
compared-under = under { $traffic }
shorter-waves = shorter
longer-waves = longer
one-wavelength = { $wavelength } mm
grows-fastest-under = { $range } grows fastest under { $traffic }; { $wavelength } mm leads and doubles in { $time }
rates-faster-than-known = growth by the model is faster than any railway known; wavelengths and order hold, rates do not
rates-of-unstable-loop = the loop oscillates by itself near { $frequency } Hz, and its growth rates mean nothing
oscillates-by-itself = the loop oscillates by itself
oscillates-under = the loop oscillates by itself near { $frequency } Hz under { $traffic }, as in squeal: its growth rates mean nothing, and no wave leads
faster-than-known = faster than any railway known
grows-fastest-without-rate = { $range } grows fastest under { $traffic }; { $wavelength } mm leads, faster than any railway known: wavelengths and order hold, the rate does not
grows-fastest-by-damage = { $range } grows fastest under { $traffic }; { $wavelength } mm leads, and doubles in { $time } if the depths of { KEY("damage") } are as written, which no measurement has told
grows-fastest-under-within = { $range } grows fastest under { $traffic }; { $wavelength } mm leads and doubles in { $time } (80 %: the wear coefficient is uncertain)
growth-is-cut-off = "{ $title }" grows fastest at { $wavelength } mm, the edge of { KEY("map.wavelength") }, and no maximum: { $beyond } waves, which have no part in what is told of the limit, may reach it before; widen { KEY("map.wavelength") }
fastest-at-edge = { $wavelength } mm is at the edge and no maximum: { $beyond } waves may grow faster
nothing-grows-under = nothing from { $shortest } to { $longest } mm grows under { $traffic }
days-of = { $days } days
days-between = { $early } to { $late } days
months-of = { $months } months
months-between = { $early } to { $late } months
years-of = { $years } years
years-between = { $early } to { $late } years
time-or-longer = { $early } to more than { $years } years
longer-than-years = more than { $years } years
million-axles = { $axles } million axles
million-axles-between = { $early } to { $late } million axles

## Noise

rigid-wheel = the wheel is a rigid body here: above some 1.6 kHz the modes of its web and tyre, which are left out, radiate as much as the rail and more
ringing-wheel = the wheel rings as its modes and the rail let it: above 2 kHz such levels were 5 to 13 dB too loud where they were measured, and those of a rigid wheel 3 to 6 dB too quiet
modes-of-other-wheel = the modes are those of a wheel of { $of_modes } mm, the wheel of the case has { $of_case } mm: a smaller wheel rings higher
far-away = { $distance } m away ground and air take some of it, which are left out: levels beyond { $far } m are too high
smooth-wheels = the wheels are taken to be smooth: rougher ones than the rail raise every level and lower what grinding saves
over-common-bands = { $count ->
        [one] over the one band that both have, { $said }
       *[other] over the { $count } bands that both have, { $said }
    }
noise-before-and-after = { $before } before, { $after } now: { $change } dB
noise-before = before
level-at-least = ≥ { $level } (up to { $hertz } Hz)
noise-is-lower-bound = a train is heard at { $level }: this is a lower bound, for no level above is known
noise-on-mean-of-rails = on the energy mean of the rails { $rails }, as wheels run on both; choose one by { KEY("--rail") } for the noise of a train on rails like it
noise-beyond-linear-range = beyond the linear range: |P₁| is { $ratio } P₀, so that wheel and rail part, which bounds the force; the levels are those of a contact that holds
rail-cut-short = the rail carries more than a tenth of its vibration beyond 66 bays, where its length is cut: its level is too low at { $frequencies } Hz
bands-left-out = left out of every level, for want of roughness, decay or receptance there: { $frequencies } Hz

# Rolling noise: tables and sentences
rolling-noise = Rolling noise
noise-at-speed = { $title }, { $speed }
noise-heard-at = levels over the passage, { $distance } m from the middle of the track, { $height } m above the rail
noise-of-rail = rail
noise-of-sleepers = sleepers
noise-of-wheel = wheel
noise-of-all = total
by-transfer-functions = by transfer functions
frequency-in-hertz = frequency Hz
in-decibels = { $what } dB
decibels-a-weighted = dB(A)
sound-exposure = sound exposure, { $wheels } wheels on each rail
what-radiates = what radiates
sound-power-of-a-wheel = sound power of a wheel dB(A)
each-alone = each alone
saves-decibels = saves dB
saves-decibels-up-to = saves dB (up to { $hertz } Hz)
rail-ground-to = rail ground to { $edition }
at-speed = { $speed }
rail-dampers = rail dampers that double the decay rate
wheel-dampers = wheel dampers, modes of { $percent } % damping
softer-pads = pads of half the stiffness
stiffer-pads = pads of twice the stiffness
noise-becomes = under the traffic { $from } become { $to } in { $months } months
noise-becomes-to-linear-end = under the traffic { $from } become { $to } in { $months } months, where roughness leaves the linear range
noise-without-course = the level in months to come is not told: { $reason }
noise-falls-below = { $sentence }; it is above { $limit } dB(A) now and falls below
noise-limit-now = { $sentence }; { $limit } dB(A) are reached now
noise-limit-in-months = { $sentence }; { $limit } dB(A) are reached in { $months } months
noise-limit-not-known = { $sentence }; whether { $limit } dB(A) are reached cannot be told
noise-limit-not-reached = { $sentence }; { $limit } dB(A) are not reached

## Measured growth

decaying-bands-stay = bands that decay keep today's level: nothing in the model makes the roughness that traffic makes on a rail
fit-of-one-rail = the fit and the changes beside it are of { $rail } alone; what each rail does by itself stands in the table by band
growth-unexplained = no wear coefficient: the model does not explain the growth at { $wavelengths } mm, { $measured } dB measured and { $fitted } dB with the best coefficient
grew-in-a-year = { $wavelength } mm has grown by { $rate } dB a year
grew-in-a-year-within = { $wavelength } mm has grown by { $rate } dB a year, 95 % interval { $low } to { $high }
grew-in-a-million = { $wavelength } mm has grown by { $rate } dB per 10⁶ passages
grew-in-a-million-within = { $wavelength } mm has grown by { $rate } dB per 10⁶ passages, 95 % interval { $low } to { $high }

## Sections of a rail against limits

section-within = within the limits; nothing to grind, for the moving RMS is nowhere over its limit
section-within-levels = within the limit of levels; no limit says what to grind
section-over-levels = over the limit of levels by { $excess } dB at { $wavelength } mm
section-over-rms = over the limit of RMS on { $share } % of it at { $band } mm, up to { $ratio } times, where { $allowed } % are allowed
section-nothing-to-grind = nothing to grind: what to grind follows from the moving RMS, which is nowhere over its limit here
section-to-grind = { $length } m to grind
section-short-places = within the limits, but { $length } m to grind: grinding takes every place where the moving RMS is over its limit, here { $share } % of the section at { $band } mm and up to { $ratio } times; the limit allows { $allowed } %, and levels are a mean over the section
section-ground-along = { $length } m ground along with what lies beside: nothing here is over a limit of RMS, but what lies close is ground as one, and no less than the shortest length

## Welds, joints and squats

defect-at = { $place } m ({ $height } µm)
one-defect = rail { $rail } has a weld, joint or squat: { $places }
some-defects = rail { $rail } has { $count } welds, joints or squats: { $places }
many-defects = rail { $rail } has { $count } welds, joints or squats: { $places } and { $more } more
defects-left-out = { $sentence }; left out of the spectra ({ KEY("--keep-defects") } keeps them)
defects-out-of-levels = { $sentence }; left out of the levels ({ KEY("--keep-defects") } keeps them), but not of the moving RMS and what to grind
defects-judged = { $sentence }; they count in levels and limits, but are no corrugation
wheel-has-a-flat = { $channel }: the wheel has a flat of some { $depth } µm, felt every { $circumference } m; it is no weld, and left out of levels and what to grind
wheel-is-not-round = { $channel }: the wheel has { $order } waves around it, { $wavelength } mm long with an amplitude of { $amplitude } µm; they are left out of levels and what to grind
wheel-or-rail = { $channel }: waves of { $wavelength } mm with an amplitude of { $amplitude } µm repeat with the wheel's turn, { $order } in one, and stay in the levels: a rail whose waves keep their phase looks the same; a second axle box on this rail would tell
level-of-wheel-or-rail = { $channel }: at { $wavelength } mm the level of the rail lies between some { $lowest } and { $level } dB, as these waves may be the wheel's; limits and what to grind are judged by the upper

grows-within = { $wavelength } mm grows fastest, by { $low } to { $high } dB per million axles (80 %): { $by }
grows-within-a-month = { $wavelength } mm grows fastest, by { $low } to { $high } dB per million axles, { $low_a_month } to { $high_a_month } dB a month (80 %): { $by }
no-band-has-grown = no band of this rail has grown from date to date, and the forecast goes by that: all levels stay
grew-where-model-decays = the model of the case does not explain this rail: { $wavelength } mm has grown by { $decibels } dB in { $amount }, and in the model it decays; the forecast goes by what was measured
grew-unlike-model = the model of the case does not explain this rail: { $wavelength } mm has grown by { $decibels } dB in { $amount }, and the model has { $ratio } times that at most within 10 % of that wavelength; the forecast goes by what was measured
grew-as-model-explains = the forecast goes by what was measured on this rail: { $wavelength } mm has grown by { $decibels } dB in { $amount }; the model of the case has { $ratio } times that at its fastest within 10 % of that wavelength
grew-by-its-own = the forecast goes by what was measured on this rail: { $wavelength } mm has grown by { $decibels } dB in { $amount }
dates-since-grinding = the dates of the rail do not tell how it grows: since its level last fell by more than 3 dB, as by grinding, there is one date; growth is that of the model
dates-of-other-instruments = the dates of the rail do not tell how it grows, for its instruments never measured it on one day; growth is that of the model
growth-without-traffic = the dates of the rail do not tell how it grows, for the traffic file says under [line] neither { KEY("passages_per_day") } nor { KEY("mgt_per_year") }; growth is that of the model
levels-beside-ground = the levels of the rail do not count beside what grinding leaves, for they are of one date; growth is that of the model
rate-now-and-then = { $now } now, { $then } then
so-many-million = { $count } million
so-many-passages = { $passages } axle passages
as-this-rail-grew = as this rail grew from date to date
as-the-coefficient-may-be = the wear coefficient is uncertain; friction, pads and traction are taken as given
measured-months-within = by what was measured that is { $early } to { $late } months from now (80 %)
measured-months-from = by what was measured that is { $early } months from now or more (80 %): the rail grew by little more than it scatters
months-within = with the uncertainty of the wear coefficient that is { $early } to { $late } months from now (80 %)
wear-unlike-rails = { $place } the rail would lose { $depth } mm per 100 MGT, where rails lose { $low } to { $high }: wavelengths and order hold, but rates and times are as far off; what the rail has lost, { KEY("wear.measured") } = "1 mm / 100 MGT", puts them right
on-straight-track = on straight track
in-this-curve = in this curve
in-this-curve-of = in this curve of { $radius } m
rate-of-wheels-on-one-line = the rate is that of wheels of this kind alone, all on one line { $width } mm wide; `riffel forecast` tells that of a traffic
rate-of-wheels-over-a-band = the rate is that of wheels of this kind alone, spread over a band of { $width } mm; `riffel forecast` tells that of a traffic
rates-hold-to = the uncertainty of the wear coefficient puts rates and times within a factor of { $factor } either way (80 %); it has no part in what variants change
band-narrower-than-contact = { KEY("wear.band_width") } is { $band } mm, but the contact is { $contact } mm wide: wear comes off the contact's own width
wheels-across-rail = the wheels of "{ $vehicle }" run { $innermost } to { $outermost } mm from the axis of the rail, the field side positive; { $percent } % of their passages cover the line at { $line } mm
no-equilibrium-at-speeds = "{ $vehicle }" finds no equilibrium in its curve at { $speeds }: there its wheels stand as at the nearest speeds that have one
band-bends-over = the rate at { $wavelength } mm lasts for { $passages } axle passages: then it would need more than the mean wear of the rail, { $wear } mm per 100 MGT, and from then on the level grows more slowly
spread-takes-down = "{ $vehicle }": { $what } takes the fastest growth down { $factor } times
spread-of-speed = the spread of speed
spread-of-wheel-radius = the spread of wheel radii
spread-of-load = the spread of loads
spread-of-friction = the spread of friction
spread-of-position = the spread of contacts across the rail
spread-of-key = the spread of { $key }
creepages-left-out = the exact theory does not converge at a creepage of { $creepages } on a grid of { $grid } and is left out there; another { KEY("contact.grid") } may do

## Damage beside wear

damage-beyond-friction = the utilised friction of the mean state is { $friction }: above 0.6 stress and shakedown limits of the laws of damage have not been compared with anything
damage-beyond-elastic = the contact pressure of { $pressure } MPa is { $ratio } times the shear yield: above 7.3 the whole patch is plastic, and neither the ellipse of Hertz nor limits of shakedown hold; check { KEY("damage.shear_yield") }
moment-beside-its-limit = the mean load bends the rail by { $moment } kN m, { $share } of { KEY("damage.bending.limit") }
flow-hardens = flow hardens: growth by it is that of the first passages; below a runaway number of one it comes to rest, and what goes on is ratchetting at the hardened yield
hardening-runs-away = flow that hardens does not stop the waves of the band at { $wavelength } mm: the runaway number of one of them is { $runaway }, above one, so that it runs away
rests-after-passages = {" "}after { $passages } axle passages
rests-after-months = {" "}after { $months } months
hardening-ends-wave = flow that hardens multiplies the waves of the band at { $wavelength } mm by { $ratio } and comes to rest{ $when }: their runaway number is { $runaway } at most, below one. A law that hardens to rest makes no corrugation by itself; what goes on is ratchetting at the hardened yield
cracks-are-worn-off = no crack grows at any phase of the waves forecast: wear takes cracks off faster than they grow, or { KEY("damage.fatigue.crack_growth") } is zero, as it is where it is left out
cracks-grow = cracks are longest { $at } at { $wavelength } mm: { $length } mm after { $passages } axle passages, beside { $other } mm { $opposite }
cracks-grow-in-months = cracks are longest { $at } at { $wavelength } mm: { $length } mm after { $months } months, beside { $other } mm { $opposite }
on-crests = on the crests
in-troughs = in the troughs
on-rising-flanks = on the flanks that the wheel runs up
on-falling-flanks = on the flanks that the wheel runs down
below-the-limit-of-flow = the mean demand is { $demand }, below one: by the law of { $law } a wave does not grow until its own forces exceed the limit
fatigue-below-threshold = Tγ of the mean state is { $energy } N, below the first threshold of { $threshold } N: fatigue takes nothing there, and where it is the only law a small wave neither grows nor decays
fatigue-loses-nothing = { KEY("damage.fatigue.loss") } is zero: fatigue is told, but takes no part in growth
shear-yield-assumed = the shear yield of the rail is taken as { $shear } MPa; { KEY("damage.shear_yield") } or { KEY("damage.grade") } say it
parts-along-the-wave = wheel and rail part along the wave: forces in proportion to the profile hold only below its amplitude there
more-friction-than-there-is = the linear loop asks for a friction of { $used } along the wave where there is { $friction }: a real wheel slides there, and its largest demand is smaller and at another place; a march in time holds to the friction
shakedown-beyond-friction = above a utilised friction of 0.6 these limits have not been compared with anything
shakedown-of-mean = mean state: p₀/k = { $pressure } at k = { $shear } MPa, utilised friction { $friction }, demand { $demand }, surface fatigue index { $index }
utilised-friction = utilised friction
limit-elastic = elastic limit
limit-line = shakedown, line contact
limit-surface = at the surface
limit-subsurface = below it
limit-subsurface-at-floor = below it, towards the surface
phase-of-wave = phase °
pressure-over-yield = p₀/k
surface-fatigue-index = surface fatigue index
demand-of-flow = demand
demand-is-largest-at = the demand is largest, { $demand }, at { $phase }° after the crest, and above one along { $share } % of the wave
stress-has-no-maximum-below = rows "below it, towards the surface" are largest at { $depth } of the smaller semi-axis, where the search begins: the stress still rises to the surface from there, and has no larger maximum of its own below it
stress-beyond-ratio = a/b is beyond 0.3 to 3, within which the stress under the contact has been compared with other numbers
stress-beyond-friction = above a friction of 0.6 the stress under the contact has not been compared with anything
stress-under-contact = stress under the contact: p₀ = { $pressure } MPa, a/b = { $ratio }, friction { $friction }, tractive ratio { $tractive }; stresses over p₀, Tresca is the largest shear stress
in-full-slip = full slip
in-partial-slip = partial slip
by-half-space = half-space
traction-of-contact = traction
measure-of-stress = measure
depth-of-stress = where
stress-over-pressure = stress/p₀
contact-title = Contact
ellipse-of-contact = ellipse { $along } mm along and { $across } mm across the rail, approach { $approach } µm
pressure-and-stiffness = peak pressure { $pressure } MPa, stiffness { $stiffness } MN/m
kalker-coefficients = Kalker's coefficients C₁₁ = { $c11 }, C₂₂ = { $c22 }, C₂₃ = { $c23 }, C₃₃ = { $c33 }
mean-state-along-rail = mean state by half-space: tractive ratio { $ratio } at creepage { $creepage } %
mean-state-by-law = mean state by { $law }: { $along } kN along and { $across } kN across the rail, tractive ratio { $ratio }{ $moment }{ $energy }
with-spin-moment = , spin moment { $moment } Nm
with-energy-per-metre = , { $energy } J/m dissipated
no-slope-near-full-slip = near full slip there is no slope, and no frequency response
tractive-ratio-over-creepage = tractive ratio Q/μP
creepage-column = creepage
receptance-title = Receptance
no-resonance-to-name = no resonance to name: the rail has no support that is known
no-peak-or-dip = no peak or dip of the measured receptance stands out of its neighbours and its noise
resonance-column = resonance
resonance-of = of
damping-column = damping %
lines-column = lines Hz
least-of-rail-wheel-and-contact = rail, wheel and contact: least
rail-in-mid-span = rail in mid-span
rail-over-support = rail over support
p2-in-closed-form = P2 in closed form: { $frequency } Hz, { $wheel } kg of the wheel and { $track } kg of the track on { $stiffness } MN/m of track and contact
kind-and-frequency = { $kind } { $frequency } Hz
across-the-track = across the track, undamped: { $named }
decay-at = { $frequency } Hz { $rate }
decay-rates = decay rate dB/m: { $rates }
wheelset-title = Wheelset
wheelset-was-measured = measured: its natural frequencies are the peaks of its receptances
wheelset-is-rigid = a free rigid body: it has no natural frequency
natural-frequency-column = natural frequency Hz
mode-column = mode
wheelset-in-a-curve = Wheelset in a curve
bogie-in-a-curve = Bogie in a curve
vehicle-in-a-curve = Vehicle in a curve
acceleration-and-power = uncompensated acceleration { $acceleration } m/s2, frictional power { $power } W
shift-column = shift mm
yaw-column = yaw mrad
angle-of-attack-column = angle of attack mrad
wheel-on-rail = { $wheelset } { $rail }
second-contact-of = { $wheel }, second
creepage-along-column = creepage along %
residual-without-straight-track = largest residual { $residual } of the load of a wheel; straight track does not lead here, other starts do
residual-from-straight-track = largest residual { $residual } of the load of a wheel, in { $steps } steps from straight track
wheelset-on-two-points = wheelset { $wheelset } stands on two points of the { $rail } wheel, { $share } % of their normal forces on the second
shifts-in-millimetres = { $shifts } mm
no-other-equilibrium = no other equilibrium found
other-equilibria = other equilibria, wheelsets shifted by { $shifts }
point-of-loop = { $wavelength } mm at { $speed } km/h: { $frequency } Hz
contact-at-point = tractive ratio { $ratio }, creepage { $creepage }{ $full_slip }, contact { $length } × { $width } mm
creepage-along-rail = { $creepage } %
creepage-on-axes = { $along } % along and { $across } % across, spin { $spin } 1/m
full-slip-from = {" "}(full slip from { $creepage } %)
oscillation-column = oscillation for exp(+iωt)
amplitude-column = amplitude
unit-column = unit
phase-column = phase
receptance-of-rail = receptance of the rail
receptance-of-wheel = receptance of the wheel
oscillating-normal-force = normal force P₁
oscillating-tangential-force = tangential force Q₁
oscillating-angular-velocity = angular velocity Ω₁
oscillating-lateral-force = lateral force
dissipation-at-wheel = dissipation at the wheel W₁
dissipation-at-rail = dissipation at the rail
dissipation-normalised = normalised, Ŵ₁
loop-oscillates-by-itself = the loop oscillates by itself, and the rate means nothing
doubles-in-passages = grows: doubles in { $passages } passages
neither-grows-nor-decays = neither grows nor decays
halves-in-passages = decays: halves in { $passages } passages
growth-at-point = Re Ŵ₁ = { $dissipation }, growth rate { $rate } per passage: { $verdict }
law-column = law
growth-per-passage-column = growth per passage
depth-per-passage-column = depth per passage nm
demand-at-point = demand { $demand }, largest at { $phase }° after the crest, and at its limit at an amplitude of { $amplitude } µm
wheel-column = wheel
normal-force-in-kilonewton = normal force kN
smooth-rail = smooth
growth-with-neighbours = with the supports passing, growth rate per passage: { $alone } of the wave alone, { $pattern } of the pattern that grows fastest
share-of-pattern = share of the pattern
pattern-is-highest = the pattern is highest { $place } mm from a support, { $modulation } times its least
supports-that-scatter = { $supports } supports at distances that scatter by { $deviation } mm, seed { $seed }
growth-rate-per-passage-column = growth rate per passage
highest-at-each-speed = highest growth at each speed, { $shortest }–{ $longest } mm
speed-column = speed km/h
decays-in-table = decays
edge-in-table = edge
profile-column = profile
from-millimetres-column = from mm
to-millimetres-column = to mm
radius-at-origin-column = radius at x = 0 mm
straight-profile = straight
wheelset-on-its-track = Wheelset on its track
amplitude-in-millimetres-column = amplitude mm
equivalent-conicity-column = equivalent conicity
conicity-with-roll-column = with roll
conicity-harmonic-column = harmonic
conicity-regression-column = regression
wavelength-in-metres-column = wavelength m
no-motion = no motion
endless-wavelength = endless
conicity-by-standard = equivalent conicity by EN 15302, for an axle that stays level; with roll: as it rolls where both wheels touch, which counts on flanks
wheels-under-load = Wheels under { $load } kN each
length-in-millimetres-column = length mm
width-in-millimetres-column = width mm
peak-pressure-column = peak MPa
conformal-pressure-column = conformal MPa
hertz-pressure-column = Hertz MPa
approach-column = approach µm
stiffness-column = stiffness MN/m
wear-as-written = Wear against { $nominal }, as the coordinates are
wear-laid-by-flange = Wear against { $nominal }, laid by the flange back across the track and by the tip of the flange upward
wear-laid-by-field-side = Wear against { $nominal }, laid by the field side, where it is steeper than 20°
tread-wear-column = tread wear mm
flange-height-column = flange height Sh mm
flange-thickness-column = thickness Sd mm
w1-column = W1 vertical mm
w2-column = W2 lateral mm
w3-column = W3 at 45° mm
deepest-column = deepest mm
area-column = area mm2
normal-force-between = normal force { $least } to { $largest } kN; { $contact }
always-in-contact = always in contact
no-contact-for = no contact for { $share } % of the time
wheel-over-a-sinusoid = Wheel over a sinusoid
wave-and-speed = { $wavelength } mm and { $amplitude } µm at { $speed } km/h, { $frequency } Hz
harmonic-column = harmonic
creep-force-column = creep force kN
creepage-in-percent-column = creepage %
dissipation-column = dissipation J/m
lateral-force-column = lateral force kN
lateral-creepage-column = lateral creepage %
dissipation-at-the-rail-column = at the rail J/m
wheel-along-a-profile = Wheel along a profile
length-of-passage = { $length } m from { $start } m on at { $speed } km/h, a run-in of { $run_in } m before, steps of { $step } mm
means-of-passage = mean creepage { $creepage } %, mean dissipation { $dissipation } J/m
wheels-on-a-smooth-rail = Wheels on a smooth rail
smooth-rail-at = smooth rail at { $speed } km/h, { $seconds } s: { $outcome }; { $linear }
limit-cycle-of = a limit cycle of { $frequency } Hz
no-settled-period = no settled period, like itself at { $frequency } Hz
wheels-slide-off = the wheels slide off
push-dies-out = the push dies out
linear-loop-stable = the linear loop is stable
linear-loop-grows = the linear loop is unstable near { $frequency } Hz, where it grows e-fold in { $seconds } s
linear-loop-unstable-near = the linear loop is unstable near { $frequency } Hz
linear-loop-unstable = the linear loop is unstable
linear-loop-not-judged = the linear loop cannot be judged
from-one-to-another = { $least } to { $most }
lateral-in-kilonewton-column = lateral kN
lateral-in-percent-column = lateral %
stick-column = stick %
rail-under-many-wheels = A rail under many wheels
passages-over-rail = { $passages } passages over { $length } m at { $speed } km/h in steps of { $step } mm
passing-vehicle = {"  "}{ $share } %  { $name }, { $speed } ± { $deviation } km/h
level-column = level dB
level-at-end-column = at the end
linear-column = linear
growth-of-level-column = growth dB/10⁶
last-quarter-column = last quarter
drift-column = drift mm/10⁶
so-many-decibels = { $level } dB
no-level-yet = nothing
waves-between-supports = waves that fit between two supports: from { $first } to { $last }
wheel-leaves-rail-from = the wheel leaves the rail from { $passages } passages on
worn-off-everywhere = worn off everywhere { $depth } µm
last-normal-force = last normal force { $least } to { $largest } kN; { $contact }
wavelength-at-level = { $wavelength } mm at { $level } dB
no-band-has-stopped = no band has stopped growing
bands-have-stopped = stopped growing: { $bands }
passages-kept = stopped after { $passed } of { $passages } passages, which are kept in { $file }; the same command goes on from there
passages-stopped = stopped after { $passed } of { $passages } passages
going-on-after = going on after { $passages } passages, from { $file }
rail-of-whole-bays = note: the rail is { $length } m long, whole bays of { $bay } m, so that its end meets its beginning
bands-below-patch-left-out = note: { $bands } bands below { $length } mm are left out: the contact is as long and averages them
levels-after-passages-taken = note: of the levels those after { $passages } passages are taken
longest-stretch-taken = of { $stretches } stretches without a gap the longest is taken, from { $start } m on
growth-over-the-bay = over the bay at { $wavelength } mm and { $speed } km/h: growth rate { $support } over a support, { $span } in mid-span, { $mean } in the mean (quasi-static in position: lines sharper than { $passing } Hz, the passing of supports, are overstated)
branches-over-the-bay = in the mean over the bay, { $branches }
so-many-observations = { $count ->
        [one] 1 observation
       *[other] { $count } observations
    }
observations-outside = { $all }, { $outside } outside the map
mean-column = mean
least-column = least
tenth-column = tenth
nine-tenths-column = nine tenths
largest-column = largest
equal-distances = equal distances
drawn-distances = drawn
parameter-column = parameter
value-column = value
growth-for-one-percent = growth for +1 %
rates-follow-amplitude = rates of growth depend on the amplitude by laws of damage: those told are at { KEY("corrugation.amplitude") }, { $amplitude } µm, levels are marched
fit-scales-all-damage = growth is by laws of damage beside wear, whose depths no measurement has told: times hold for { KEY("damage") } as it is written, and have no band; a wear coefficient fitted to measurements scales all of them
models-leave-damage-out = models of the field are told without the laws of [damage], which none of their authors has
action-none = left as it is
action-column = action
decision-on-doubtful-chains = the chains leave { $doubts } doubts, which riffel calibrate tells: the ranking may change with more draws
over-limit-costs-nothing = a month over the limit costs nothing here, so that a fixed interval is the cheaper the longer it is: give { KEY("cost.over_limit") }
rise-after-grinding-assumed = cost.from_limit is left out: grinding is taken to leave every band 6 dB below the limit
decision-is-over = { $draws } draws of the posterior; the limit is reached when the first band has risen by { $rise } dB after grinding; intervals up to { $horizon } months; costs in the mean over the draws, savings against leaving all as it is
months-to-limit-median = months to the limit
five-per-cent = 5 %
ninety-five-per-cent = 95 %
never-percent = never %
mean-cost-per-year = cost a year, { $currency }
saving-from = saving, 5 %
saving-to = saving, 95 %
longer-percent = lasts longer, %
cheapest-percent = cheapest, %
regret-per-year = expected regret, { $currency }
value-known = if it were known
measurement-first = if it were measured first
worth-per-year = worth a year, { $currency }
price-in = price, { $currency }
net-worth-in = worth less price, { $currency }
cheapest-in-the-mean = cheapest in the mean: { $action } at { $cost } { $currency } a year; it is the cheapest in { $share } % of the draws
worth-of-knowing-all = to know every value would be worth { $worth } { $currency } a year
measure-first = measure first: { $measurement }
no-measurement-pays = no measurement is worth its price: none changes the action often enough
over-budget-percent = over budget, %
too-loud-percent = too loud, %
without-possession-percent = over hours of possession, %
rank-of-action = rank
actions-break = { $count } of the actions break the budget, the noise limit or the hours of possession in more than 5 % of the draws; they rank behind those that hold
all-actions-break = every action breaks the budget, the noise limit or the hours of possession in more than 5 % of the draws; they are ranked by cost alone
posterior-forecast-is-linear = levels are what linear growth says, and what decays in the model falls, while riffel forecast without { KEY("--posterior") } keeps it; where the wheel leaves the rail is not told over a posterior
forecast-on-doubtful-chains = the chains leave { $doubts } doubts, which riffel calibrate tells: bands may change with more draws
posterior-forecast-is-over = { $draws } draws of the posterior, from the last date { $months } months on; medians with bands of 90 %
wavelength-of-band = wavelength mm
level-now-banded = now dB
level-then-banded = then dB
limit-of-band = limit dB
months-banded = months to the limit
months-to-the-limit = months to the limit ({ $limit }): { $months }; half of the draws between { $low } and { $high }
never-within = { $share } % of the draws do not reach it within { $months } months
told-by-data = data
told-by-prior = prior
told-by = told by
values-together = values together
spread-percent = ± %
told-as-a-product = the data tell { $one } and { $other } only together, as a product of powers (r = { $correlation }): neither may be written back into a case alone
told-as-a-ratio = the data tell { $one } and { $other } only together, as a ratio of powers (r = { $correlation }): neither may be written back into a case alone
calibration-allows-no-conclusion = the chains allow no conclusion, by { $doubts } doubts that are told with them: more draws may settle these
chains-take = the model takes { $seconds } s for one set of values: the chains take some { $minutes } min, and longer where they go on
chains-go-on = the chains allow no conclusion yet, and go on to { $draws } draws each
chains-disagree = the chains disagree on { $value }: R̂ is { $rhat }, but must be { $most } at most; take more draws, or { $other }
look-for-a-second-way = look for a second way to fit the data
populations-find-both-ways = where the data can be fitted in two ways sampler.kind = "smc" finds both
too-few-effective-draws = { $value } has { $draws } effective draws, but must have { $least }; take more draws
trajectories-ran-away = { $trajectories } trajectories ran away: the draws leave out a narrow part of the posterior; take a longer warm-up, or priors that keep away from it
tails-are-not-reached = the energy of the chains moves by { $moves } of its spread, but must by { $least }: the tails are not reached
calibration-tells-nothing = the data tell none of the { $count } values: each is as uncertain as before
calibration-tells-all = the data narrow all { $count } values by { $least } to { $most } %, most of all { $best }
calibration-tells-some = the data tell { $told } of { $count } values, most of all { $best }; they do not tell { $untold }
outlying-above = { $datum } ({ $data }) lies { $deviations } standard deviations above what all other data say of it; it stays among them: look how it was measured, or what the model lacks there
outlying-below = { $datum } ({ $data }) lies { $deviations } standard deviations below what all other data say of it; it stays among them: look how it was measured, or what the model lacks there
datum-receptance = |H| at { $at } Hz
datum-phase = the phase of H at { $at } Hz
datum-wear = the wear under { $mgt } million gross tonnes
datum-decay-rate = the decay rate at { $at } Hz
datum-level = the level of { $at } mm after { $passages } million passages
datum-axle-box = the level of the axle box at { $at } mm
datum-pass-by = the level beside the track after { $passages } million passages
datum-growth = the growth of waves of { $at } mm after { $passages } million passages
datum-drift = the drift of waves of { $at } mm after { $passages } million passages
at-position = { $datum }, { $position } m
value-is-not-told = { $value } is not told by these data: 90 % of its prior lie between { $low } and { $high } { $unit }
drawn-as-levels-see-it = over the calibration the case is as its dated levels see it, with { $set }
median-with-band = { $median } ({ $low } … { $high })
growth-over-posterior = over { $draws } draws of the calibration { $wavelength } mm grows fastest in the median ({ $shortest } to { $longest } mm, 90 %) and doubles in { $time } (90 %)
no-growth-in-draws = in { $share } % of the draws nothing grows
variant-over-posterior = "{ $title }": over { $draws } draws of the calibration growth changes by { $change } % (90 %), and is less in { $share } % of them
variant-months-over-posterior = "{ $title }": { $months } months to the limit (90 %)
level-over-posterior = over { $draws } draws of the calibration { $level } dB(A) (90 %)
measure-over-posterior = { $measure }: saves { $saved } dB(A) (90 %)
model-of-the-plan = model of the plan
model-column = model
left-out-date = { $data }, date of { $passages } passages
left-out-place = { $data }, blows at { $place } m
models-by-what-they-predict = models by what they predict: data are left out, and ln density is how likely the model and all other data make what was measured there
log-density = ln density
behind-the-best = behind the best
error-of-behind = ±
verdict-on-model = verdict
verdict-best = best
verdict-worse = worse
verdict-not-told-apart = not told apart
inside-50-percent = in its 50 % band, %
inside-80-percent = in its 80 % band, %
inside-90-percent = in its 90 % band, %
left-out-column = left out
shape-of-weights = k̂
data-left-out = data
inside-50 = in the 50 % band
inside-90 = in the 90 % band
model-predicts-worse = { $model } predicts worse than { $best }: ln density is lower by { $behind } ± { $error }
model-not-told-apart = { $model } and { $best } are not told apart: ln density differs by { $behind } ± { $error }, but must by two standard errors and by 4
all-models-see = models: { $models }
left-out-to-compare = left out, each by itself, to compare them: { $held }
one-group-left-out = only { $held } was left out: another date, place or kind may judge otherwise, and ± is the error of the draws alone
log-evidence = ln evidence { $value }, { $low } to { $high } by { $runs } runs; it moves with the width of the priors, so that it compares only models with the same
models-on-doubtful-chains = { $model }: its chains leave { $doubts } doubts, and its score may change with more draws

## The report

keys-have-no-effect = { $count ->
        [one] { $keys } has no effect, for { $reason }
       *[other] { $keys } have no effect, for { $reason }
    }
variant-cannot-act = "{ $title }" cannot act on this case: { $reasons }
variant-changes-nothing = "{ $title }" changes nothing: growth is that of the case to the last digit
variant-acts-in-part = of "{ $title }" only a part acts: { $reasons }
growth-of-the-level = growth of the level by wavelength, positive where corrugation grows
after-grinding = after grinding
now = now
rail-when = { $rail } { $time }
in-quotes = “{ $words }”
levels-after = levels after { $passages } axle passages, { $tonnes } MGT as it is
levels-of-rail-as-it-is = the levels are those of { $rail }, which leads as it is
forecast-ends-before = before, where the wheel leaves the rail and the forecast ends: { $titles }
comparison = Comparison
keeps-tractive-ratio = "{ $title }" keeps the tractive ratio: the traction force changes with friction and load; { KEY("--hold") } force keeps the force
fastest-in-millimetres = fastest mm
decibels-per-million-passages = dB per 10⁶ passages
change-head = change
held-head = held
ridge-in-hertz = ridge Hz
passages-to-limit-head = passages to limit
tonnes-to-limit-head = MGT to limit
months-to-limit-head = months to limit
at-edge-of-lines = { $wavelength } (edge)
cannot-act = cannot act
cannot-be-told = cannot be told
changes-nothing = changes nothing
held-mixed = mixed
held-force = force
held-ratio = ratio
held-creepage = creepage
as-it-is = as it is
growth-ridge-is-no-candidate = the growth ridge is not among the candidates: { $reason }
track-known-up-to = at { $speeds } the track is known up to { $longest } mm, and waves shorter than 1.5 contact lengths, { $shortest } mm, pass unseen
share-of-belief = share of the belief when every mechanism of the list, and one not in it, is equally likely beforehand; it compares candidates on the evidence named and is no probability that a finding is right
measured-word = measured
given-word = given
trend-of-neighbours = trend of the neighbours
fine-level-axis = level in 1/24 octave [dB re 1 µm]
how-fine-bands-are = Bands of 1/24 octave, at least one line of the transform wide; trend of the first curve.
level-axis = level [dB re 1 µm]
means-of-levels = Means of one-third-octave levels.
perhaps-made-by = { $wavelength } mm: { $mechanism }?
dominant-wavelengths = Dominant wavelengths
caption-of-diagnosis = { $file }: { $record }. { $bands } Named at each wavelength is the candidate that leads; the list has the others and the reasons.
dominant-wavelength-at = dominant wavelength { $wavelength } mm ({ $band } mm), { $place }, { $frequency } Hz at { $speeds }
dominant-wavelength = dominant wavelength { $wavelength } mm ({ $band } mm), { $frequency } Hz at { $speeds }
rail-all-along = { $rail }, all along
rail-from-to = { $rail }, { $from }–{ $to } m
more-places = { $count ->
        [one] { $place } and one more place
       *[other] { $place } and { $count } more places
    }
scatter-of = scatter { $scatter } dB
scatter-unknown = scatter unknown, one spectrum only
level-of-record = level { $level } dB re 1 µm, record { $record }
level-of-peak = level { $level } dB re 1 µm
level-of-rail = { $name } { $level }
with-levels-of-rails = { $level } ({ $rails })
stands-over-its-trend = { $level }, { $prominence } dB over the trend of its neighbours ({ $scatter })
by-chance-in-a-million = by chance in less than one spectrum of a million
by-chance = by chance in one spectrum of { $spectra }
harmonic-of = harmonic { $order } of { $wavelength } mm
means-of-energies = means of energies { $levels }
beside-wave = comes with { $wavelength } mm
comes-with-wave = It comes with { $wavelength } mm, which swells and fades from support to support (sideband { $order } of supports { $spacing } m apart). Look for the cause of that wave.
gone-by-grinding = Gone by grinding: its level fell by { $fall } dB before { $record }, and it stands out of no record since. What had made it:
beside-stand = { $count ->
        [one] Beside it stands { $wavelengths }: it swells and fades from support to support.
       *[other] Beside it stand { $wavelengths }: it swells and fades from support to support.
    }
candidate-leads = { $first } leads with a share of { $share }, next is { $second } with { $other }.
level-falls-as-grinding-mark = The level falls with a probability of { $percent }, as a fading grinding mark does and growing corrugation does not. Best read as a fading grinding mark and not growing corrugation.
level-falls = The level falls with a probability of { $percent }, as a fading mark does and growing corrugation does not.
level-rises = The level rises with a probability of { $percent }, as corrugation under traffic does and a grinding mark does not.
rise-is-open = Whether the level rises is open (probability { $percent } %).
one-record-since-ground = The level fell as by grinding, and one record since then does not tell whether it grows.
one-record-only = There is one record only: whether it grows is not known.
two-sentences = { $one } { $other }
mechanism-of = { $mechanism }, { $wheel }
more-than-999-per-mille = more than 99.9 %
percent-of = { $percent } %
speeds-of-the-usual-traffic = the speeds are those of { $traffic }
explains-any-wavelength = It explains any wavelength and any course, none of them well.
patch-averages = The contact patch averages over waves this short: of { $wavelength } it passes { $percent } %.
higher-than-ground = Grinding is accepted up to { $accepted } µm RMS at such wavelengths (Grassie, Saxon & Smith 1999); this wave has { $rms } µm.
trolley-measures-rail-alone = A trolley measures the rail alone, and wheels of many diameters do not print one pattern on it.
known-with-damping = damping { $ratio } %, ±{ $spread } %
known-to = ±{ $spread } %
frequency-makes = { $frequency } Hz ({ $known }) makes { $range } at { $speeds }; measured { $measured }, which is { $frequencies }.
case-grows-at-measured = At { $speeds } the case grows fastest at { $wavelength } ({ $rate } per passage); at { $measured } it grows by { $own }, { $percent } % of that.
case-decays-at-measured = At { $speeds } the case grows fastest at { $wavelength } ({ $rate } per passage); at { $measured } it decays by { $own }.
case-lets-nothing-grow = At { $speeds } the case lets no wavelength grow, { $measured } included.
measured-outside-growth = { $measured } lies outside the wavelengths at which the case can grow: those of its map, and not below 1.5 contact lengths.
wavelengths-at-any-speed = Its wavelengths are { $range }, whatever the speed of the traffic; measured { $measured }.
order-of-length = { $length } over { $order } is { $nearest }, { $ratio } times the measured { $measured }, whatever the speed of the traffic.
marks-fade-under-traffic = A mark of machining fades under traffic; this level is { $course }.
corrugation-grows-under-traffic = Corrugation grows under traffic; this level is { $course }.
measure-at-other-speed = Speed: measure where the same trains run a fifth slower. A constant frequency ({ $frequencies }) would stand at { $moved } mm there, a mark or an order of length at { $wavelength } mm as here
in-weeks-moves = in { $weeks } weeks the present course moves the level by three times its scatter
intervals-move = { $records } of the intervals between these records move the level by three times its scatter
after-three-months = after three months, and again after six, at the same chainage
measure-again = Time: repeat this record ({ $when }). Corrugation rises, a grinding mark falls
year = year
record = record
course-since-ground = { $levels } dB re 1 µm: fell by { $fall } dB before { $record }, as by grinding; since then { $since }
course-ends-ground = { $levels } dB re 1 µm: fell by { $fall } dB before { $record }, by grinding or as a mark of grinding fades
course-of-two-is-open = { $levels } dB re 1 µm: two records do not tell whether it rises, { $slope } ± { $scatter } dB a { $unit }
course-of-two-rises = { $levels } dB re 1 µm: rises, { $slope } ± { $scatter } dB a { $unit }
course-of-two-falls = { $levels } dB re 1 µm: falls, { $slope } ± { $scatter } dB a { $unit }
course-falls = { $levels } dB re 1 µm: falls every time, { $slope } ± { $scatter } dB a { $unit }
course-rises = { $levels } dB re 1 µm: rises every time, { $slope } ± { $scatter } dB a { $unit }
course-is-open = { $levels } dB re 1 µm: neither rises nor falls every time, { $slope } ± { $scatter } dB a { $unit }
after-tonnes = after { $tonnes } MGT
after-tonnes-at-end = after { $tonnes } MGT, where the forecast ends
by-vehicle = by { $vehicle }, { $percent } %
mix-of-vehicles = mix
caption-of-forecast = After { $amount }. One-third-octave levels; growth of the level by wavelength, positive where corrugation grows: what each kind of vehicle adds, and their sum. The forecast ends where the wheel leaves the rail.
levels-of-leading-rail = Levels are those of { $rail }, which leads.
growth-forecast = Growth forecast
months-axis = months
million-passages-axis = 10⁶ axle passages
crest = crest
falling-flank = falling flank
trough = trough
rising-flank = rising flank
cracks-at = cracks at { $wavelength } mm
crack-axis = length of a crack [mm]
growth-axis = growth [dB per 10⁶ passages]
rail-leads = { $rail } leads: { $sentence }
bands-not-forecast = not forecast: { $count } bands from { $first } to { $last } mm that lie outside { KEY("map.wavelength") } of the case
grinding-interval-from = grinding interval from { $ground }
grinding-interval = grinding interval
over-the-limit-now = over the limit now: { $edition } at { $wavelength } mm by { $decibels } dB
mean-over-the-record = { $sentence }, in the mean over the record; places above the mean reach it sooner
limit-reached-after = { $edition } is reached at { $wavelength } mm after { $amount }
no-band-reaches = no band forecast ever reaches { $edition }
limit-reached-without-time = { $edition } is reached first at { $wavelength } mm; in what time is not told: { $reason }
limit-not-reached-before = { $edition } is not reached before the wheel leaves the rail, where the forecast ends
beyond-linear-range-now = beyond the linear range now: |P₁| is { $ratio } P₀ under "{ $vehicle }", so that wheel and rail part; corrugation then grows otherwise than the linear loop says, and nothing is forecast
linear-range-ends = linear range: |P₁| is { $ratio } P₀ now and reaches P₀ under "{ $vehicle }" after { $amount }; there the wheel leaves the rail, and the forecast ends
linear-range-never-ends = linear range: |P₁| is { $ratio } P₀ now under "{ $vehicle }" and never reaches P₀
amount-with-date = { $passages } axle passages = { $tonnes } MGT = { $months } months ({ $date })
amount-with-months = { $passages } axle passages = { $tonnes } MGT = { $months } months
amount-of-traffic = { $passages } axle passages = { $tonnes } MGT
rail-not-forecast = { $rail } has no band between { $from } and { $to } mm, { KEY("map.wavelength") } of the case, and is left out
wavelength-in-millimetres = wavelength [mm]
median = median
forecast = Forecast
caption-of-posterior-forecast = { $draws } draws of the posterior; months to the limit: { $months }.
at-the-last-date = at the last date
months-later = { $months } months later
growth-goes-by-this-rail = growth goes by the wear coefficient of this rail, { $coefficient } kg/J, { $interval }: it is fitted to what has changed over { $passages } axle passages, and the case says { $given } kg/J
interval-of-coefficient = 95 % interval { $low } to { $high } kg/J
coefficient-is-fitted = wear coefficient { $coefficient } kg/J, { $interval }
forecast-with-coefficient = forecast with this coefficient by { KEY("--set") } { KEY("wear.coefficient") }={ $value }
no-coefficient-nothing-grows = no wear coefficient: the model says of no band measured that it grows
no-coefficient-nothing-moved = no wear coefficient: the bands that should grow by the model have not moved
no-coefficient-bands-fell = no wear coefficient: the bands that should grow by the model have fallen: the rail was ground between the two dates, or what is on it is not the corrugation of this model
no-coefficient-not-grown = no wear coefficient: the bands that should grow by the model have not grown by more than levels scatter
no-coefficient-indistinct = no wear coefficient: growth cannot be told from none, { $interval }
no-coefficient-claimed = no wear coefficient is claimed: an interval takes three records of each date, or 30 m of profile; the best fit is { $coefficient } kg/J
band-fades-against-model = { $wavelength } mm does not grow as the model says: { $measured } dB measured, { $predicted } dB predicted; it fades
band-grows-against-model = { $wavelength } mm grows where the model says that it decays: { $measured } dB measured, { $predicted } dB predicted
band-fades-as-in-model = { $wavelength } mm fades, { $measured } dB measured, and decays in the model, too, { $predicted } dB: what fades is not growing corrugation
band-grows-unlike-fit = { $wavelength } mm does not grow as the fit says: { $measured } dB measured, { $fitted } dB fitted
beyond-linear-range = beyond the linear range
never = never
number-alone = { $number }
noise-beside-the-track = Rolling noise beside the track
caption-of-noise = Equivalent level over the passage at { $speed }, { $distance } m from the middle of the track and { $height } m above the rail, re 20 µPa, one-third octaves without weighting. { $parameters }
level-a-weighted = { $level } dB(A)
part-and-level = { $part } { $level }
what-would-help = what would help, each alone
limit-word = limit
under-traffic = under traffic
time-axis-in-months = time [months]
level-axis-a-weighted = level [dB(A)]
level-axis-in-decibels = level [dB]
grinding-shifts = { $count ->
        [one] 1 grinding shift
       *[other] { $count } grinding shifts
    }
grinding-costs-a-year = to grind { $length } m of line takes { $shifts } and { $cost } { $currency }, { $yearly } { $currency } a year if repeated every { $months } months
grinding-costs = to grind { $length } m of line takes { $shifts } and { $cost } { $currency }
input-head = input
file-head = file
what-it-is-head = what it is
growth-map = Growth map
speed-axis-in-kilometres-per-hour = speed V [km/h]
strongest-growth-at-each-speed = strongest growth at each speed
strongest-at-edge = strongest at the edge of the window
frequency-of-strongest-branch = constant frequency of the strongest branch
branches-of-growth = branches of growth
constant-frequency = constant frequency V = fλ
neither-growth-nor-decay = neither growth nor decay
not-computed = not computed
rail-and-group = { $rail }, { $group }
measured-wavelength = measured { $wavelength } mm
where-measured-wavelengths-stand = measured wavelengths at the slowest, mean and fastest of { $speeds }
outside-the-map = outside the map: { $wavelengths }
nothing-stands-out = no dominant wavelength: nothing stands 3 dB over the trend of its neighbours beyond chance and for twenty waves
diagnosis = Diagnosis
share-capital = Share
mechanism-head = mechanism
source-head = source
valid-for-head = valid for
sources-and-validity = Sources and validity
course-capital = Course
candidate-head = candidate
share-head = share
frequency-in-hertz-head = frequency [Hz]
predicts-in-millimetres = predicts [mm]
the-case = the case
held-against = held against: { $title }; traffic at { $speeds }
indented-line = {"  "}{ $line }
course-line = {"  "}course: { $course }
reason-for = {"  "}for:     { $reason }
reason-against = {"  "}against: { $reason }
telling-them-apart = to tell them apart
predicts-column = predicts mm
to-tell-them-apart = To tell them apart
profile = Profile
moving-rms-along-the-line = Moving RMS along the line
spectrum-and-limits = Spectrum and limits
wavelength-bands = Wavelength bands
what-to-grind = What to grind
what-if = What-if
since-when = Since when
why-and-how-sure = Why, and how sure
no-dates-are-told = dates, times and what measures would save are therefore left out here; below they stand as the model has them
not-plausible = Not plausible
model-is-of-the-other-rail = the case is of the other rail of the curve ({ KEY("contact.from.rail") }), so that it does not tell what would lower this one's growth
model-does-not-explain-growth = the model does not explain the growth that was measured, so that it cannot tell what would lower it
what-comes = What comes
what-helps = What helps
what-is-heard = What is heard
no-roughness-given = no roughness was given
roughness-not-diagnosed = the roughness was not diagnosed
how-bad-and-where = How bad, and where
forecast-over-calibration = Forecast over the calibration
no-case-given = no case was given
what-it-costs = What it costs
rail-roughness-and-corrugation = Rail roughness and corrugation
levels-are-no-profile = the record is a table of levels; it needs a profile
course-of-wavelength = { $wavelength }, { $first } to { $last }: { $course }
no-wavelength-stands-out = no dominant wavelength stands out of the roughness
wavelength-stands-out-at = { $wavelength } stands out on { $place }, { $level } dB
wavelength-stands-out = { $wavelength } stands out, { $level } dB
limit-of-name = limit { $name }
preset-of-name = preset { $name }
built-in-head = built in
made-by = made by riffel { $version }. The same files and the same version give the same report
inputs-and-versions = Inputs and versions
no-warnings = none
warnings-and-limits-of-models = Warnings and limits of the models
no-level = none
train-is-heard = at { $speed } a train of { $wheels } wheels on each rail, { $length } m long, is heard at { $level }, { $distance } m from the middle of the track
level-is-of = of it: { $parts }
measure-saves = { $title } { $saved } dB
each-alone-would-save = each alone would save: { $savings }
noise = noise
now-in-decibels = now dB
then-in-decibels = then dB
limit-in-decibels = limit dB
wheel-leaves-the-rail = wheel leaves rail
from-ground-to-limit = from { $ground } to { $edition }
after-amount = after { $amount }
measured-in-decibels = measured dB
model-in-decibels = model dB
fitted-in-decibels = fitted dB
residual-in-decibels = residual dB
decays-in-the-model = decays in the model
decays-at-first-in-the-model = decays at first in the model
change-between-records = change over { $passages } axle passages between { $earlier } and { $later } records
change-between-paired-records = change over { $passages } axle passages between { $earlier } and { $later } records, paired by place
growth-of-the-bands = growth of the bands, dB per 10⁶ passages
limit-is-of-the-rail-that-leads = passages, MGT and months are those of the rail named, which leads; summary.json has every rail
comparison-of-variants = Comparison
the-traffic = the traffic
levels-after-grinding = one-third-octave levels under { $traffic }; now is after grinding to { $ground }; then is after { $amount }
levels-under-traffic = one-third-octave levels under { $traffic }; then is after { $amount }
growth-is-uncertain = forecast and what-if: growth rates are proportional to a wear coefficient that is uncertain by a factor of three until it is fitted to two dated records ({ KEY("--earlier") }, { KEY("--dates") })
variant-head = variant
case-and-variants = the case and its variants, { $speeds }
limit-is = limit: { $edition }
from-ground = from { $ground }
held-is = held is what a change of friction or load leaves as it is: the traction force, the tractive ratio Q₀/μP₀ or the creepage
no-variant-can-act = none of the variants can act on this case
variant-lowers-most = of the variants “{ $title }” lowers the fastest growth most, by { $percent } %
no-variant-lowers = none of the variants lowers the fastest growth
with-held = { $sentence } (held: { $held })
without-any-effect = without any effect: { $titles }
limit-is-passed-on = the limit ({ $edition }) is passed already on { $rail }; { KEY("--ground") } or { KEY("--from-limit") } says how long each variant lasts after grinding
limit-is-passed = the limit ({ $edition }) is passed already; { KEY("--ground") } or { KEY("--from-limit") } says how long each variant lasts after grinding
with-variant = with “{ $title }”
gross-tonnes = { $tonnes } MGT
reached-after = after { $time } { $variant }
reached-beyond-linear-range = not before the wheel leaves the rail { $variant }
never-reached = never { $variant }
on-rail = { $sentence } on { $rail }
limit-is-reached-from = from { $ground } the limit ({ $edition }) is reached { $times }
limit-is-reached = the limit ({ $edition }) is reached { $times }
in-brief = In brief
not-in-this-report = Not in this report
line-of-site = Line
height-axis = height [µm]
caption-of-heights = Heights as read, positive upward, { $from } m to { $to } m. Lowest and highest of { $columns } lengths each; gaps are gaps.
caption-of-moving-rms = Highest moving RMS of each { $block } m, by band of wavelengths; dashed in the same colour: the limit of the band. The worst rail is first.
caption-of-levels = One-third-octave levels after EN 15610:2009, method A, without { $spikes } and { $pits }; base-ten bands
group-of-spectra = { $name } ({ $count })
caption-of-group-means = Means of energies over the spectra of each group: { $groups }
dashed-limit = Dashed: { $edition } ({ $source })
within-the-limit = within the limit
over-the-limit = over the limit
band-in-millimetres = band [mm]
rms-in-micrometres = RMS [µm]
highest-moving-rms = highest moving RMS [µm]
highest-peak-to-peak = highest peak-to-peak [µm]
window-in-metres = window [m]
limit-of-rms = limit of the RMS [µm]
length-over-the-limit = length over the limit
limit-of-bands = limit: { $edition } ({ $source })
how-bands-are-filtered = profile without spikes, zero-phase band-pass, each rail on its own, the worst first
needs-a-limit-of-rms = it needs a table of RMS limits ({ KEY("--limit") })
no-band-over-its-limit = nothing to grind: no band is over its limit of the moving RMS ({ $edition }) anywhere
section-head = section
from-in-metres = from [m]
to-in-metres = to [m]
length-in-metres = length [m]
worst-band-in-millimetres = worst band [mm]
rms-over-limit = RMS over limit [-]
further-sections = { $count } further sections are in grind.csv of riffel roughness
how-sections-are-ground = sections no further apart than { $merge } m are ground as one, and none shorter than { $shortest } m
no-length-over-rms-limits = no length is over the RMS limits: nothing to grind
sections-to-grind = { $count ->
        [one] 1 section to grind, { $sums }
       *[other] { $count } sections to grind, { $sums }
    }
sections-at-defects = sections with a weld, joint or squat among them: { $count }
railway = Railway
place-of-site = Place
measured-on = Measured on
instrument = Instrument
author = Author
date-of-report = Date
caption-of-strip-map = The line: red is over the limit of the RMS, and to be ground; blue is a dominant wavelength; black is a weld, joint or squat.
mechanism-growth-ridge = growth ridge
mechanism-lateral-pinned-pinned = pinned-pinned, lateral
mechanism-grinding-mark = grinding mark
mechanism-support-spacing = sleeper passing
mechanism-wheel-circumference = wheel circumference
mechanism-unlisted = a cause not listed
energy-mean = energy mean
rail-roughness = Rail roughness
caption-of-profile = { $file }: one-third-octave levels after EN 15610:2009 (method A); highest moving RMS in blocks of { $block } m, its limit dashed.
position-axis-in-metres = position along the rail [m]
position-axis-in-kilometres = position along the rail [km]
moving-rms-axis = moving RMS [µm]
caption-of-means = { $file }: means over the spectra of each group.
mean-of-energies = mean of energies
mean-of-levels = mean of levels
worst-within = every rail is within the limits; nearest to them is { $rail }
worst-over = worst is { $rail }, over { $count } of { $all } limits
window-shorter-than-wave = a window of { $window } m is shorter than waves of { $band }: a moving RMS over less than a wave goes up and down with it and tells nothing
stretches-too-short-for-band = no statistics of { $band } mm: no stretch is four of its longest waves long, { $length } m
samples-too-far-for-band = no statistics of { $band } mm: samples are { $step } mm apart
rms-unlike-any-rail = an rms of { $rms } µm between 30 and 100 mm is unlike any rail: check the unit of the heights
group-and-rail = { $group }, { $rail }
peak-falls = the peak at { $wavelength } mm, { $levels } dB re 1 µm, falls every time: a fixed wavelength that fades, as a grinding mark does, and not growing corrugation
peak-rises = the peak at { $wavelength } mm, { $levels } dB re 1 µm, rises every time: it grows under traffic
peak-stays = the peak at { $wavelength } mm, { $levels } dB re 1 µm, neither rises nor falls every time
sections-over-levels = by themselves { $over } of { $all } sections of { $length } m are over it, at worst { $place } by { $decibels } dB at { $wavelength } mm
rail-is-not-measured = there is no record of { $rail }
rail-named = rail { $name }
verdict-within = { $edition }: within the limit, { $rest }
verdict-over = { $edition }: over the limit, { $rest }
all-bands-within = { $all } bands; { $room } dB are left at { $wavelength } mm
measured-bands-within = { $measured } bands that were measured, of { $all }; { $room } dB are left at { $wavelength } mm
bands-over = { $count } of { $all } bands, at worst by { $decibels } dB at { $wavelength } mm
measured-bands-over = { $count } of { $measured } bands that were measured, of { $all }, at worst by { $decibels } dB at { $wavelength } mm
share-of-band = { $band } mm { $share } %
length-may-be-over = { $allowed } % of the length may be over
rail-on-stretch = { $rail }, stretch { $stretch }
stretch-named = stretch { $stretch }
place-on-stretch = { $from }–{ $to } m on stretch { $stretch }
place-from-to = { $from }–{ $to } m
no-section-over = { $allowed } % of any { $length } m may be over, and none of { $all } sections is more
sections-over = { $allowed } % of any { $length } m may be over, and { $over } of { $all } sections are more, at worst { $place } with { $share } % at { $band } mm, up to { $ratio } times the limit
no-header = no header
header-of-one-line = a header of one line
header-of-lines = a header of { $count } lines
no-position = no position
falling-position-in-column = position in column { $column } [{ $unit }], falling
position-in-column = position in column { $column } [{ $unit }]
rail-in-column = { $name } in column { $column } [{ $unit }]
read-as = read as: { $delimiter }, { $decimal }, { $header }; { $position }; { $rails }
metres-of-rail = { $name } { $length } m
line-of-rails-to-grind = in all { $length } m of line to grind ({ $rails }), { $share } % of the line measured
rail-is-sampled = { $from } m to { $to } m, { $length } m of rail sampled every { $spacing } mm; { $spikes } and { $pits } removed
rail-is-heard = { $rail }: { $length } m of rail at { $slowest } to { $fastest } km/h, wavelengths of { $shortest } to { $longest } mm
read-as-spectra = read as: { $spectra }
read-as-spectra-of-dates = read as: { $spectra } of { $dates } dates, told apart by column { $column }
means-of-spectra = levels in dB re 1 µm: mean of energies | mean of levels, over so many spectra
more-in-grind-file = { $count } more in grind.csv
study-word = Study
first-order-column = first order
interval-column = { $percent } % interval
total-column = total
parameter-alone = { $output } alone
at-percent = at { $percent } %
at-all-medians = at all medians: { $value }
output-fails = fails
over-the-samples-column = over the samples
samples-column = samples
samples-without-results = { $failed } of { $finished } samples have no results:
samples-fail-as = {"  "}{ $count } times, as in: { $example }
chunks-left-to-shards = { $left } of { $chunks } chunks are left to other shards
study-begins = { $samples } samples of { $parameters } parameters ({ $method }), { $size } in { $chunks } chunks
study-stopped = stopped: { $finished } of { $chunks } chunks are finished and kept in { $folder }; the same command goes on from there
samples-computed = { $samples } samples in { $time }, { $rate } a second
chunk-is-damaged = note: { $file } is damaged; chunk { $chunk } is computed anew
chunks-are-kept = { $kept } of { $chunks } chunks are finished and kept
study-not-finished = note: nothing is analysed, for { $folder } is not finished: { $missing } of { $chunks } chunks are missing; riffel study PLAN -o { $folder } computes them, riffel study merge brings shards together
chunks-merged = { $finished } of { $chunks } chunks, { $copied } copied
chunks-merged-beside-others = { $finished } of { $chunks } chunks, { $copied } copied, { $already } were there already with the same numbers
chunks-are-missing = note: { $count } chunks are missing: { $chunks }; riffel study PLAN -o { $folder } computes them
sobol-indices-need-saltelli = Sobol indices need design.method = "saltelli"; this study has "{ $method }"
base-samples-left-out = { $count } base samples are left out: one of their rows has no results
bands-need-growth-by-wavelength = bands of growth against wavelength need outputs.growth_by_wavelength
calibration-word = Calibration
told-by-data-column = told by data
calibration-stopped = stopped: finished parts of the chains are kept in { $folder }; the same command with --restart goes on from there
check-stopped = stopped: the check begins anew
chains-of-model = chains of "{ $title }"
chains-begin = { $chains } chains of { $warmup } + { $draws } draws of { $parameters } parameters
sampled-in = sampled in { $time }
no-data = no data
plan-asks-for = { $data } data, { $chains } chains of { $warmup } + { $draws } draws
kind-corrugation = corrugation
kind-joints = joints
kind-welds = welds or squats
kind-ground = ground
kind-unknown = joints or corrugation
places-go-back = line { $row }: { $rail }: places go back from { $end } m to { $from } m, as at a long kilometre; cells of both stretches hold the mean of their energies
rail-is-renamed = rail { $old } of the file is rail { $new } of the line
line-has-not-had-rail = the line has not had rail { $rails } before; if it has another name there, ingest the file again with --rename OLD=NEW --replace
line-is-called-alike = the store has a line "{ $alike }", and "{ $line }" is another one; if the same was meant, delete the folder of this one in the store and ingest the file under that name
survey-is-there-already = { $line }, { $date }: is there already
cells-of-rail = { $rail } { $cells } cells
survey-is-taken-in = { $line }, { $date }: { $rails }, each { $length } m long
survey-is-left-out = { $reason }; the survey is left out
surveys-are-whole = { $count } surveys are whole
no-survey-in-store = no survey is in the store
surveys-in-cells = surveys: { $surveys }, in cells of { $length } m
no-section-in-limited-band = no section is known in a band that has a limit
growth-not-known = not known
over-its-limit = over it
months-or-more = { $months } (more than { $early })
middle-from-to = { $middle } ({ $from } to { $to })
and-more-sites = and { $count } more sites: --json has them all
for-money = {" "}for { $cost }
no-plan-leaves-less = , and no plan for this leaves less than { $length } km
grinding-is-planned = in { $months } months { $over } km of track are over the limit; { $ground } km are ground{ $cost }, { $left } km are left{ $least }
lines-are-not-drawn = the picture holds the longest lines; { $count } more are in chart.csv (--line draws one)
line-column = line
date-column = date
surveys-column = surveys
latest-column = latest
from-kilometre-column = from km
to-kilometre-column = to km
rails-column = rails km
rms-of-band-column = rms { $band } mm µm
kind-column = kind
decibels-a-year-column = dB a year
between-column = between
months-to-limit-column = months to limit (80 %)
expected-growth-column = expected dB a year (80 %)
cost-column = cost
kilometres-column = km
kilometres-over-limit-column = km over limit
worst-column = worst
at-kilometre-column = at km
statement-column = statement
source-column = source
expected-column = expected
tolerance-column = tolerance
check-holds = holds
check-fails = FAILS
checks-hold = { $hold } of { $all } checks hold
predicted-wavelength = wavelength
predicted-frequency = frequency
predicted-growth = growth
predicted-wear = mean wear
decibels-a-month = dB a month
millimetres-per-100-mgt = mm per 100 MGT
no-wave-geometry = { $what }, no wave geometry
from-on = from { $from }
up-to = up to { $to }
inside-band = inside
outside-band = OUTSIDE
site-column = site
what-column = what
outcomes-inside = { $share } % of the published outcomes lie inside their bands of 80 %; logarithmic score { $score }
report-is-written = wrote { $file }; open it in a browser, print it to A4 from there
profile-is-written = wrote { $file }; next: riffel roughness { $file }
from-to = { $from } to { $to }
felt-level-column = level dB re 1 µm
with-pads-column = with pads of half to twice the stiffness
band-column = band mm
rms-column = rms µm
highest-moving-rms-column = highest moving rms µm
highest-peak-to-peak-column = highest peak-to-peak µm
window-column = window m
limit-of-rms-column = limit µm
over-limit-column = over limit
grind-column = grind
from-column = from m
to-column = to m
length-column = length m
worst-band-column = worst band mm
ratio-to-limit-column = rms/limit
line-to-grind = in all { $length } m of line to grind, { $share } % of the line measured
low = low
high = high
idle-belongs-to-curve = it belongs to `riffel curve` and `riffel profile`
idle-amplitude = growth rates do not depend on the amplitude
idle-one-wheel = there is one wheel, which interferes with no other
idle-map = the bands are those of the case, and the speeds those of the traffic
idle-inertia = { KEY("wheel.rotation") } is the limit of no inertia or of infinite inertia
idle-rotation = { KEY("wheel.rotation") } holds the creepage or the force along the rail
idle-contact-angle = under a contact angle of zero the wheel has the same radius everywhere
idle-free-wheel = a wheel that turns freely takes any radius
idle-belongs-to = it belongs to { $keys }
idle-patch = a non-steady contact resolves its patch
idle-place-of-wear = a non-steady contact finds the place of wear itself
one-or-other = { $one } or { $other }
idle-belongs-to-wheelset = it belongs to { KEY("wheelset.model") } = { $models }
idle-receptance-given = the track is a receptance given in place of the model
idle-receptance-measured = the track is a measured receptance, with the rail and the supports that were measured
idle-twist = without { KEY("rail.torsion_constant") } the rail does not twist
idle-without-supports = { KEY("track.model") } = "{ $model }" is a rail without supports
idle-sleepers = { KEY("track.model") } = "{ $model }" has no sleepers without ballast
idle-one-layer = { KEY("track.model") } = "{ $model }" has one layer, the pads
idle-mean-over-bay = growth is the mean over the bay
idle-same-everywhere = { KEY("track.model") } = "{ $model }" is the same everywhere along the rail
lateral-pinned-pinned-is-no-candidate = the lateral pinned-pinned mode is not among the candidates: it needs supports at a spacing and a { KEY("rail.section") } whose lateral bending and shear are known
vertical-pinned-pinned-is-no-candidate = the vertical pinned-pinned mode is not among the candidates: it needs supports at a spacing and a { KEY("rail.section") } whose vertical bending and shear are known
no-least-sum-of-receptances = below the first peak of the { $origin } receptance the sum of rail, wheel and contact has no least value within its frequencies
p2-is-no-candidate = P2 is not among the candidates: { $reason }
no-modes-of-receptance = modes of the track are not among the candidates: no peak or dip of the { $origin } receptance stands out of its neighbours and its noise
rail-has-no-support = the rail of this case has no support
no-resonance-of-unsprung-mass = damping, or the suspension and the bending of the axle, leave no resonance of the unsprung mass on the track
track-has-no-layers = modes of pads and sleepers are not among the candidates: the track of this case has none
wheel-of-the-case = the wheel of the case
models-of-the-field = Models of the field
under-title = { $title }, { $passing }
passages-to-double-column = passages to double
what-moves-models-most = what moves it most: the one joint that, taken from the case with the exact contact, changes growth most
model-not-on-this-case = not on this case: { $model }: { $reason }
wheels-of-a-curve = Wheels of a curve
all-wheels-in-the-curve = all wheels in the curve of { $radius } m at { $speed } km/h
under-no-wheel = { $under } corrugation grows under no wheel
fastest-at-wheel = { $under } it grows fastest at { $wheel }: { $rate } per passage at { $wavelength } mm, { $frequency } Hz
wheel-not-in-loop = not in the loop: { $wheel }: { $reason }
wheelset-column = wheelset
rail-column = rail
flange-of-rail = { $rail }, flange
creeps-along-column = along %
creeps-across-column = across %
spin-column = spin 1/m
normal-force-column = normal kN
contact-angle-column = angle deg
highest-growth-column = highest 10⁻⁶ per passage
no-growth-in-table = no growth
not-in-loop-in-table = not in the loop
at-edge-in-table = { $value } (edge)
wheel-on-low-rail = wheelset { $number }, low rail
wheel-on-high-rail = wheelset { $number }, high rail
wheel-on-left-rail = wheelset { $number }, left rail
wheel-on-right-rail = wheelset { $number }, right rail
all-rails-grow-alike = all rails are given the growth { $of_rail } ({ KEY("contact.from") }); in a curve the other one grows at its own rate, which { KEY("contact.from.rail") } asks for
of-low = of the low rail
of-high = of the high rail
flange-of-wheel = { $wheel }, flange
traffic-word = traffic
at-spread-speed = { $speed } with a standard deviation of { $deviation }
neither-speed-nor-traffic = neither { KEY("--speed") } nor { KEY("--traffic") } given
not-fitted-without-passages = the wear coefficient is not fitted to the earlier record, for the axle passages since then are not known: they follow from the dates of both records and from a traffic file that says how much traffic there is, or are given ({ KEY("--passages-between") })
coefficient-not-fitted = the wear coefficient is not fitted: { $reason }
input-roughness = roughness
input-of-the-same-rail = of the same rail
input-earlier-record = earlier record
a-case = a case
input-with = { $title }, with { $values }
input-case = case
input-track-receptance = track receptance
input-traffic = traffic
input-vehicles = vehicles, speeds, loads
input-changes = changes to the case
input-reader-profile = reader profile
input-layout = how profiles are laid out
input-limit-table = limit table
input-of-your-own = of your own
input-site = site
input-words-at-the-top = the words at the top
standard-input = standard input
one-third-octave-spectra = { $count ->
        [one] 1 one-third-octave spectrum
       *[other] { $count } one-third-octave spectra
    }
chosen-spectra = { $count } one-third-octave spectra, those with { $choices }
needs-a-limit-of-levels = it needs a limit of levels ({ KEY("--limit") })
no-traffic-given = no traffic was given ({ KEY("--traffic") })
no-variant-given = no variant was given ({ KEY("--with") })
spikes = { $count ->
        [one] 1 spike
       *[other] { $count } spikes
    }
pits = { $count ->
        [one] 1 pit
       *[other] { $count } pits
    }
uneven-positions = positions are { $off } mm rms off even steps of { $step } mm: heights are brought to even steps by cubic interpolation
rows-without-position = { $count ->
        [one] 1 row without a position left out
       *[other] { $count } rows without a position left out
    }
rows-repeat-position = { $count ->
        [one] 1 row with the position of the row before left out
       *[other] { $count } rows with the position of the row before left out
    }
rows-after-gap = { $count ->
        [one] 1 row after a gap of up to { $gap } mm, filled by straight lines
       *[other] { $count } rows after a gap of up to { $gap } mm, filled by straight lines
    }
rows-after-jump = { $count ->
        [one] 1 row after a longer gap or jump, { $length } m in all, where the record is divided
       *[other] { $count } rows after a longer gap or jump, { $length } m in all, where the record is divided
    }
rows-go-back = { $count ->
        [one] 1 row where the position goes back, at which the record is divided into two stretches
       *[other] { $count } rows where the position goes back, at each of which the next stretch of the record begins
    }
rows-behind = { $count ->
        [one] 1 row behind the row before left out
       *[other] { $count } rows behind the row before left out
    }
below-limit = { $decibels } dB below { $edition }
in-windows = , whole and in windows of { $window } m
profile-of-rails = { $count ->
        [one] profile, 1 rail of { $length } m{ $windows }, { $segments } segments of { $segment } m averaged
       *[other] profile, { $count } rails of { $length } m{ $windows }, { $segments } segments of { $segment } m averaged
    }
record-lacks-rail = has no rail { $rail }, whose course is not known
record-lacks-rail-there = has no rail { $rail }, whose course is not known there
rail-not-measured-there = rail { $rail } was not measured from { $from } m to { $to } m, so that its course there is not known
spectra-of-records = { $count ->
        [one] { $spectra }, 1 record
       *[other] { $spectra }, { $count } records
    }
spectra-of-records-by-rail = { $count ->
        [one] { $spectra }, 1 record, { $rails } rails judged one by one
       *[other] { $spectra }, { $count } records, { $rails } rails judged one by one
    }
earlier-records = { $count ->
        [one] 1 earlier record
       *[other] { $count } earlier records
    }
its-unit-is-no-length = its unit is no length
it-is-computed = it is computed from other columns
position-and-heights-in = position in { $unit } and heights in { $other }
position-in = position in { $unit }
heights-in = heights in { $unit }
by-line = { $what } by line { $line }
taken-for-granted = { $what } taken for granted
it-numbers-the-rows = it numbers the rows
it-is-neither = it is neither a position nor a height
text-behind-left-out = the text behind column { $column } is left out
text-columns-left-out = text in column { $columns } is left out
column-left-out = column { $column } is left out: { $reason }
column-of-head = column { $column }, "{ $head }",
column-is-filtered = { $column } is what a filter left: waves that it takes away look smooth, and within a limit they say nothing of the rail
headed-column-left-out = column { $column }, "{ $head }", is left out: { $reason }
it-is-a-chord-offset = it is an offset from a chord, which has no waves of a half, a quarter or a sixth of the chord and doubles those of its length
it-is-across = it is along or across the rail
it-is-above-springs = it is of what a train has above its axle boxes
it-is-a-size = it is a size without a sign, no signal
it-is-empty = it is empty
it-is-no-signal = it is no acceleration, speed, odometer or time
it-is-text = it is text
it-is-second = one before it is of the same kind
speed-tells-the-place = places follow from { KEY("--speed") }
channel-left-out = { $channel } is left out: { $reason }
it-is-geometry = it is geometry of the track
it-is-a-statistic = it is a limit or a statistic, no measured rail
marks-of-missing-values = { $count ->
        [one] column { $column } has { $mark } in 1 row, taken for a missing value
       *[other] column { $column } has { $mark } in { $count } rows, taken for a missing value
    }
first-at-line = { $sentence }; the first is line { $line }
coarse-sampling = sampled every { $step } mm; EN 15610 asks for 1 mm or less
short-stretches-left-out = { $length } m left out in stretches shorter than { $shortest } m
heights-missing = { $count ->
        [one] 1 height missing, filled by straight lines where no more than { $longest } follow each other, else left out
       *[other] { $count } heights missing, filled by straight lines where no more than { $longest } follow each other, else left out
    }
heights-clipped = { $samples } heights stand at the end of the range, { $low } or { $high } in the unit of the file, for { $run } samples and more: the sensor is clipped
dates-are-day-numbers = column `{ $column }` holds the day numbers of a spreadsheet: { $cell } is read as { $date }
rails-of-last-date = the file has rails of several dates: the rail now is that of { $last }, and before it stands that of { $before }
device-is-laid-on-another = column `{ $column }`: levels of { $device } count { $offset } dB, in the mean over the bands: { $reference } differs by this on days when both measured; growth is that of one instrument
device-is-left-out = column `{ $column }`: { $device } is left out of growth, for on no day both it and { $reference } measured the rail: what they differ by is not known
device-changes = column `{ $column }` changes along the dates, from { $first } to { $last }, and these are not told apart: what the instruments differ by is part of the change between the dates
device-of-other-dates = column `{ $column }` is { $device } at some dates and { $other } at others: what two instruments differ by would be taken for growth; give the rows of each a file of its own
now-is-latest-of-each-rail = column `{ $column }` has { $count } dates: now is the latest of each rail, { $last }
commas = commas
semicolons = semicolons
tabs = tabs
blanks = blanks
decimal-point = decimal point
decimal-comma = decimal comma
source-of-growth-ridge = Afferrante & Ciavarella (2009), with the receptances, contact and wear of this case
source-of-p2 = 50–100 Hz in Afferrante & Ciavarella (2009); here the least sum of the receptances of rail, wheel and contact of this case
source-of-full-track = Near 100 Hz (Bhaskar et al., in Afferrante & Ciavarella 2009); here the peak of the case's rail receptance
source-of-sleeper-antiresonance = Low vertical receptance near 300 Hz (Müller, in Afferrante & Ciavarella 2009); here √((k_p + k_b)/m_s) of this case
source-of-rail-on-pad = the peak of the case's rail receptance, else √(k_p/m)
source-of-pinned-pinned = Near 800 Hz at 0.75 m and 1200 Hz at 0.6 m (Grassie & Kalousek, in Afferrante & Ciavarella 2009); Nielsen (2003) for low receptance above sleepers; here Timoshenko's beam of this case
source-of-lateral-pinned-pinned = 513.7 Hz lateral beside 1050 Hz vertical (Wang & Lei 2020); here Timoshenko's beam of this case, lateral
source-of-measured-peak = the measured receptance of the rail: which mode of the track this is, it does not say
source-of-given-peak = the receptance of the rail given with the case: which mode of the track this is, it does not say
source-of-wheelset-torsion = second torsional mode near 300 Hz (Elkins 1998, in Afferrante & Ciavarella 2009); the frequency as given
source-of-wheelset-bending = bending of the leading axle (Torstensson & Nielsen 2013); the frequency as given
source-of-grinding-mark = stones that turn 50 to 60 times a second on a train at 3 to 15 km/h: 14 to 83 mm; marks of 60 mm with 60 Hz are reported from a Chinese high-speed line (Shock and Vibration 2021, 5546809). The speeds are Riffel's assumption
source-of-support-spacing = d and d/2 of this case's support spacing d: kinematics
source-of-wheel-circumference = 2πR/n, n = 1 to 30, of this case's rolling radius: kinematics
source-of-unlisted = every wavelength from 5 mm to 2 m equally likely on a logarithmic scale
validity-of-growth-ridge = one wheel, linear, within the remarks on this case; shares follow growth inside the wavelengths asked for
validity-of-p2 = rigid unsprung mass, evenly spread supports; ±15 % for the stiffness of real track
validity-of-full-track = undamped layers; ballast stiffness is uncertain by a factor of two, the frequency by ±15 %
validity-of-rail-on-pad = pads stiffen with load and frequency and in the cold: ±15 %
validity-of-pinned-pinned = Timoshenko's beam on supports at equal distances; ±5 % for spacing and foot of the rail
validity-of-measured-peak = the place and the load of the receptance; ±5 % for another place, temperature and wheel load, and its width at half power
validity-of-wheelset-torsion = as good as the frequency given; ±5 %
validity-of-grinding-mark = the wavelength of one pass of one train; several passes leave several
validity-of-support-spacing = supports at equal distances; ±2 %
validity-of-wheel-circumference = in a record taken from a vehicle: wheels of other diameters and phases do not print one pattern on the rail; ±3 % for worn diameters
validity-of-unlisted = always
measurement-of-growth-ridge = speed: where trains run at another speed the wavelength moves and the frequency stays; speeds spread more widely lower its growth
measurement-of-p2 = vertical axle-box acceleration of vehicles with another unsprung mass: P2 moves with the mass, modes of the track do not
measurement-of-full-track = receptance of the loaded track from 20 to 200 Hz, with and without voids under the sleepers
measurement-of-sleeper-antiresonance = impact hammer on sleeper and rail head: at this frequency the sleeper moves and the rail does not
measurement-of-rail-on-pad = track decay rate (EN 15461) and hammer receptance: a peak here that moves with the pads (temperature, new pads over a trial length)
measurement-of-pinned-pinned = hammer receptance above a sleeper and in mid-span, and the profile averaged over sleeper bays: the amplitude follows the sleepers; an irregular spacing or rail dampers remove it
measurement-of-lateral-pinned-pinned = lateral hammer receptance of the rail head in mid-span and lateral track decay rate
measurement-of-measured-peak = hammer receptance above a sleeper, in mid-span and on the sleeper, with a wheel beside it: a mode of the pads moves the sleeper little and shifts with new or colder pads, a pinned-pinned mode is seen in mid-span alone
measurement-of-measured-dip = impact hammer on sleeper and rail head: at this frequency something else moves and holds the rail
measurement-of-wheelset-torsion = strain gauges for torque on a driven axle, or longitudinal axle-box acceleration, through the section
measurement-of-wheelset-bending = lateral and vertical axle-box acceleration of the leading axle through the curve; the low rail should be worst
measurement-of-grinding-mark = the log of the grinding train (date, passes, speed, turns of the stones), a photograph of the facets, and a section that was not ground
measurement-of-support-spacing = sleeper positions on the chainage of the record: the phase stays with them
measurement-of-wheel-circumference = a trolley record of the same rail, and wheel roughness or out-of-roundness: if the trolley does not see the wavelength it is on the wheel
measurement-of-unlisted = a receptance measurement of this track in place of the model ({ KEY("track.model") } = "measured")

## Chains on simulated data

truth-among-draws = { $runs } simulations with the priors and the likelihood of the plan: how often intervals hold the truth, and whether it lies anywhere among the draws
checked-value = value
probability-of-ranks = probability of its ranks
verdict-on-ranks = ranks
ranks-even = even
ranks-uneven = uneven
log-likelihood-of-all-data = ln likelihood
passages-to-the-limit = passages to the limit
simulations = simulations
all-ranks-even = in { $runs } simulations the truth lies anywhere among the draws
ranks-are-uneven = { $value }: in { $runs } simulations the truth does not lie anywhere among the draws (probability { $probability }): its intervals are wrong, by more warm-up and draws or by another sampler they may be right

## Cases that are refused

file-cannot-be-read = cannot read the { $what } { $path }: { $reason }
not-valid-toml = not valid TOML: { $message }
place-and-fault = { $place }: { $fault }
track-is-the-same-everywhere = the track is the same everywhere along the rail with { KEY("track.model") } = "{ $model }"; choose one-layer-periodic or two-layer-periodic
line-and-fault = { $path }, line { $line }: { $fault }
no-such-preset = no preset is called "{ $name }"; the nearest is "{ $nearest }"
presets-are-listed = riffel presets lists them all
key-and-rule = `{ $key }`: { $rule }
key-as-subject = `{ $key }` { $rule }
is-key-with-command = is a key with the control character { $command }
is-text-with-command = is a text with the control character { $command }
leave-it-out = leave it out
key-of-many-parts = a key has at most { $most } parts, and this one { $count }
value-not-table = `{ $parent }` is a value, not a table of keys, in `{ $path }`
is-outside = is { $value }, but must be between { $low } and { $high }
is-unknown-key = is not a key Riffel knows
no-choice = "{ $variant }" is not one of its choices
is-no-table = is not a table of keys, as it must be
is-no-list = is not a list, as it must be
is-but-must-be = is { $value }, but must be { $rule }
is-missing = is missing
whole-number = a whole number, zero or more
some-number = a number
quoted-text = a text in quotes
true-or-false = true or false
some-list = a list
some-table = a table of keys
near-name = did you mean { $nearest }? (allowed: { $allowed })
is-no-preset = is "{ $name }", but no { $kind } preset has that name
track-kind = track
pad-kind = pad
sleeper-kind = sleeper
ballast-kind = ballast
vehicle-kind = vehicle
allowed-names = allowed: { $allowed }
not-a-number = "{ $text }" does not begin with a number; write { $kind } as in "{ $example }"
not-finite = { $text } is not finite, as { $kind } must be
number-with-separator = "{ $text }" has a comma or a gap in its number; write a decimal point and no separators of thousands, as in "{ $example }" for { $kind }
range-for-one-value = "{ $text }" is a range, but one value is needed; write { $kind } as in "{ $example }"
unknown-unit = unknown unit "{ $unit }" in "{ $text }"; write { $kind } as in "{ $example }"
wrong-unit = "{ $text }" is { $got }, not { $kind }; write it as in "{ $example }"
plain-number = a plain number
in-unit = in { $unit }
kind-in-unit = { $kind } in { $unit }
kind-as-in = { $kind } in { $unit } or as in "{ $example }"
ratio-such-as = { $kind } such as 0.4 or "{ $example }"
name-as-subject = { $name } { $rule }
is-flange-but-the-wheel-stands = is "flange", but the wheel stands on one point, at a contact angle of { $angle }°
the-profiles-do-not-part-across = the profiles do not part across the track where they touch (curvature { $curvature } 1/m), so that there is no ellipse; give { $key }
the-rail-is-not-convex-where = the rail is not convex where the wheel stands (curvature { $curvature } 1/m), so that no contact of a head moves there; leave { KEY("contact.conformity") } out, or give { $key }
is-but-the-ellipse-like-it = is "{ $name }", but the ellipse like it is one of { KEY("contact.hertz") } = "exact"
needs = needs { $what }
supports-of-the-rail-or-a = supports of the rail: { $keys } or a { KEY("track.preset") }
a-rail-that-moves-across-the = a rail that moves across the track: { $keys }
narrow-the-window-or-measure-further = narrow the window, or measure further
the-traction-force-of-kn-on = the traction force of { $force } kN on a wheel is { $ratio } times what friction can carry, μP₀ = { $most } kN
slides-without-creepage = where all of the contact slides, a tractive ratio tells no creepage
at-the-tractive-ratio-of = at the tractive ratio of { $ratio }, { $reason }
at-the-creepage-of = at the creepage of { $creepage } %, { $reason }
hold-is-but-must-be-force = hold is "{ $name }", but must be force, ratio or creepage
give-with = give [{ $key }] with { $needs }
is-but-the-profiles-lie-m = is { $given }, but the profiles lie { $placed } m apart: profiles.flange_back_distance less twice profiles.flange_back_position
profiles-wheel-cone-needs-it = profiles.wheel = "cone" needs it
is-set-but-curve-theory-linear = is set, but curve.theory = "linear" knows no flange
leave-it-out-or-choose-curve = leave it out, or choose curve.theory = "nonlinear"
is-set-but-profiles-contact-plane = is set, but profiles.contact_plane = "{ $name }" takes a flange of { $keys }
is-set-but-belongs-to = is set, but belongs to { $belongs }
larger-than-the-to-either-side = larger than the { $what }, to either side, and at most 10000 km
is-but-the-wheelset-is-mm = is { $gauge }, but the wheelset is { $width } mm wide over its flanges, 10 mm below the tread, and does not go between such rails
is-but-the-wheels-mm-wide = is { $gauge }, but the wheels, { $width } mm wide over their field sides, do not stand on both rails
is-but-cannot-be-read = is "{ $name }", but { $path } cannot be read: { $reason }
nominal-profiles = nominal profiles: { $known }
track-model-says-what-the-rail = { KEY("track.model") } = "{ $model }" says what the rail does under the wheel alone, not how far its vibration runs
the-rail-of-track-model-carries = the rail of { KEY("track.model") } = "{ $model }" carries its vibration on without end at every frequency
takes-one-wheel-of-wheel-with = { $what } takes one wheel of [wheel] with longitudinal creepage, and this is a loop on all axes or of several wheels
track-model-is-but-is-of = `{ KEY("track.model") }` is "{ $model }", but { $what } is of discrete supports; choose a periodic model
traffic-file-for-case = this is a traffic file, with its [[vehicle]], and no case file; give it by { KEY("--traffic") }, and a case file, as `riffel init` writes one, in its place
below-r-at-the-wavelength-of = below λ²/4π²R at the wavelength of { $wavelength } m: beyond it the profile is as curved as the wheel, which bridges the troughs
at-m-and-m-s-is = { $quantity } at { $wavelength } m and { $speed } m/s is not a finite number: values of the case are too large or too small to compute with
wheelset-model-needs-it = { KEY("wheelset.model") } = "{ $model }" needs it
give-length-and-diameter-of-an = give length and diameter of an axle of one diameter, or segments
is-an-empty-list-an-axle = is an empty list, an axle of 0 m, but the sum of the lengths must be above 0
at-most-the-length-of-the = at most the length of the axle, { $length } m
between-m-and-m-the-ends = between -{ $end } m and { $end } m, the ends of the axle
traffic-file-for-changes = this is a traffic file, with its [[vehicle]], and no file of changes; give it by { KEY("--traffic") }
give-one-of-the-two = give one of the two
the-file-of-changes-changes-nothing = the file of changes changes nothing
write-keys-of-the-case-as = write keys of the case, as in [contact] friction = 0.3, or [speed] mean, factor or standard_deviation
give-damping-loss-factor-or-both = give { $key }.damping, { $key }.loss_factor, or both
at-most-the-support-spacing = at most the support spacing, { $spacing }
choose-contact-creep-law-half-space = choose { KEY("contact.creep_law") } = "half-space", or leave it out
give-contact-tractive-ratio-or-contact = give { KEY("contact.tractive_ratio") } or { KEY("contact.creepage") }
at-most-contact-polach-adhesion-reduction = at most { KEY("contact.polach.adhesion_reduction") }, { $value }
falling-friction-needs-limit-friction-ratio = falling friction needs limit_friction_ratio, friction_decay and speed of [contact.polach]: give all three or none
is-one-of-t-a-of = is one of Tγ/A, of which the law of wear does not ask
is-no-measured-wear = is "{ $text }", but must be a depth and the traffic that wore it off, as in "1.2 mm / 100 MGT"
is-of-wear-by-energy = is of a rail that wears in proportion to energy: leave out other laws in { KEY("wear.law") } and { KEY("damage.laws") }
is-measured-but-nothing-slides = is { $depth } mm per 100 MGT, but under these wheels nothing slides, so that no wear coefficient gives it: give them traction or creepage, or leave it out
measured-wear-makes = { $depth } mm worn off per 100 MGT make the wear coefficient { $coefficient } kg/J (80 %: { $low } to { $high })
measured-wear-of-the-case = { $coefficient }, if all wheels are like this one
measured-wear-of-traffic = under this traffic { $coefficient }
it-belongs-to-wear-law-usfd = it belongs to { KEY("wear.law") } = "usfd" and "usfd-smooth"
rates-of-the-laws-add-name = rates of the laws add: name each once
damage-laws-names-give-its-table = { KEY("damage.laws") } names "{ $law }": give its table
names-bending-but-track-model-does = names bending, but { KEY("track.model") } = "{ $name }" does not tell what carries the rail
choose-a-model-or-no-bending = choose a model of rail and supports, or leave bending out
names-fatigue-by-t-but-the = names fatigue by Tγ, but the contact does not creep
give-contact-creepage-or-contact-tractive = give { KEY("contact.creepage") } or { KEY("contact.tractive_ratio") } above zero
is-true-but-wheelset-model-tells = is true, but { KEY("wheelset.model") } = "{ $model }" tells how the contacts move and not how the hubs do
choose-wheelset-model-rigid-or-flexible = choose { KEY("wheelset.model") } = "rigid" or "flexible", or leave it out
give-longitudinal-or-lateral-creepage-with = give longitudinal or lateral creepage with it
transverse-radius-is-the-relative-one = transverse_radius is the relative one of both profiles, equal to that of the rail under a cone
are-several-but-track-model-does = are several, but { KEY("track.model") } = "{ $model }" does not tell how the track answers from one to the next
choose-a-model-or-one-wheel = choose a model of rail and supports, or one wheel
give-rail-lateral-second-moment-and = give { KEY("rail.lateral_second_moment") } and { KEY("track.pad.lateral_stiffness") }, or leave it out
the-waves-that-run-along-this = the waves that run along this rail over the { $furthest } m from the first wheel to the last are not told by so few oscillations as are fitted in time, { $per_cent } % rms off; give fewer or nearer wheels, or a track that damps more
the-case-has-contacts-but-a = the case has { $count } contacts, but a passage in time takes at most { $most_contacts }: the work of a step and of the fit goes with their square; choose fewer wheels, or { KEY("wheelset.opposite_rail") } = "absent"
is-a-file-and-this-case = is a file, and this case may not name any
use-it-in-a-case-file = use it in a case file with the program, `riffel map CASE`
lower-points = lower { KEY("map.wavelength.points") } or { KEY("map.speed.points") }
and-exclude-each-other = and `{ $other }` exclude each other
the-nearest-key-is = the nearest key is `{ $key }`
is-no-key-of-a-case = is no key of a case
vehicle-at-km-h = vehicle "{ $vehicle }" at { $speed }: { $error }
damage-by-one-law-or-more = name one law or more, as in ["wear"], or leave it out
is-an-empty-list = is an empty list
give-both-keys-of-one-of = give both keys of one of the two
goes-down-to-but-every-value = goes down to { $value }, but every value must be greater than zero
is-no-spread-give-mean-and = is no spread: give mean and standard_deviation, min and max, or a list of value and share, with { $name } as in "{ $example }"
key-of-vehicle-without-effect = `{ $key }` is without effect: a traffic is computed at the speeds of its vehicles and in the bands of the case; leave it out
wheelset-of-vehicle-in-curve = `{ $key }` is without effect on a vehicle with a `curve`, which brings all its wheelsets; leave it out
speed-of-vehicle-in-curve = `{ $key }` is without effect on a vehicle with a `curve`, which is balanced at each of its own speeds: give these by `speed` or `speeds`
creepage-of-vehicle-in-curve = `{ $key }` is given, but each wheel of a vehicle with a `curve` takes its creepage from the equilibrium; leave it out, or drive the wheelsets by set = {"{"} bogie.drive_torque = [ … ] {"}"}
is-no-curve-of-a-vehicle = is neither true, for the curve of the case, nor the name of a case file of `riffel curve`
curve-of-vehicle-without-curve-of-case = `{ $key }` is true, but the case has no [curve]; give it one, or name a case file of `riffel curve` in place of true
key-of-vehicle-beside-curve-of-case = `{ $key }` is given, but contact.from of the case takes creepage and load from a bogie in its curve; leave it out, or change the bogie by set = {"{"} bogie.mass_per_axle = … {"}"}, or give the vehicle curve = true, which brings all wheels
friction-of-both-rails = `{ $key }` is one friction for both rails, but `contact.friction` is { $left } on the left rail and { $right } on the right one; leave it out, or give the vehicle set.contact.friction = {"{"} left = …, right = … {"}"}
axles-that-roll-free = `{ $key }` is below one, but axles that roll free damage the rail by the laws of { KEY("damage.laws") }, too: name the axles with traction and those without as two vehicles
the-shares-of-sum-to-but = the shares of `{ $key }` sum to { $sum }, but must sum to 1
vehicle = vehicle "{ $vehicle }": { $error }
variant-changes-friction-or-load-under = variant "{ $title }" changes friction or load under "{ $vehicle }"; { $why }
speeds-and-bands-of-vehicle = speeds and bands of vehicle "{ $name }": { $message }
line-measured-line-needs-profiles-of = `line.measured_line` needs profiles of wheel and rail that touch at the contact angle of the equilibrium, and vehicle "{ $name }" has none
width-excludes-that-of-the-case = `{ $key }` and { KEY("wear.band_width") } of the case exclude each other; give one of the two
write-one-vehicle-or-more = write one [[vehicle]] or more
is-empty-but-tables-need-a = is empty, but tables need a name
is-a-second-time = is "{ $text }" a second time
line-measured-line-needs-for-without = `line.measured_line` needs `{ $key }`, for without it vehicle "{ $name }" does not say where its wheels run on the rail
this-is-a-case-file-with = this is a case file, with its table [{ $table }], and no traffic file; a traffic file lists the vehicles of a line in [[vehicle]], `riffel init --traffic` writes one
is-a-force-but-must-be = is "{ $force }", a force, but must be a mass, as in "13 t"; half of the force may be written as wheel_load
there-are-vehicles-but-the-page = there are { $count } vehicles, but the page takes { $most_vehicles } at most
the-case-is-larger-than-kib = the case is larger than { $size } KiB
map-points-are-more-than-the = `{ KEY("map") }`: { $points } points are more than the { $most_map_points } that the page computes
lower-points-on-the-page = lower { KEY("map.wavelength.points") } or { KEY("map.speed.points") }; the program itself computes larger maps
contact-grid-is-but-the-page = `{ KEY("contact.grid") }` is { $grid }, but the page goes up to { $finest_grid } with a non-steady response
the-program-itself-goes-further = the program itself goes further
the-of-the-point-is-but = the { $what } of the point is { $value }, but the map reaches from { $low } to { $high }
choose-a-point-on-the-map = choose a point on the map
the-speed-is-m-s-but = { $name }: the speed is { $speed } m/s, but must be above zero and at most 200 m/s
wave-is-but-must-be = the wave is { $value }, but must be { $rule }
the-amplitude-is-m-but-must = the amplitude is { $number } µm, but must be between { $low } and { $high } µm
the-plan-cannot-be-read = the plan cannot be read
the-plan-cannot-be-written = the plan cannot be written
of-a-prior-must-be-a = `{ $key }` of a prior must be a number or a text
the-answer-took-longer-than-s = the answer took longer than { $seconds } s and was given up
too-much-is-being-computed-at = too much is being computed at present
the-program-is-ending = the program is ending
the-computation-broke-off = the computation broke off
the-file-is-larger-than-mib = the file is larger than { $size } MiB
riffel-roughness-reads-larger-ones = `riffel roughness` reads larger ones
other-files-are-just-coming-in = other files are just coming in
nothing-of-the-file-came-for = nothing of the file came for { $seconds } s
the-file-broke-off-on-its = the file broke off on its way
the-file-came-more-slowly-than = the file came more slowly than { $rate } kB a second
the-files-of-all-pages-have = the files of all pages have more than { $size } MiB
close-pages-that-are-not-needed = close pages that are not needed
the-file-is-no-longer-here = the file is no longer here
choose-it-once-more = choose it once more
there-are-such-files-already-which = there are { $most } such files already, which is as many as the page takes
the-file-cannot-be-stored = the file cannot be stored: { $error }
free-room-on-the-disk = free room on the disk of { $folder }, or start riffel serve with TMPDIR on another one
the-calibration-is-no-longer-here = the calibration is no longer here
choose-its-data-once-more = choose its data once more
the-file-takes-more-memory-than = the file takes more memory than the { $memory } MiB that the page gives it
riffel-roughness-reads-it-without-a = `riffel roughness` reads it without a limit
the-program-broke-off = the program broke off
the-request-did-not-come-within = the request did not come within { $seconds } s
the-request-is-larger-than-kib = the request is larger than { $size } KiB
a-case-is-a-few-hundred = a case is a few hundred bytes long
there-are-more-than-actions-or = there are more than { $most } actions or measurements, which is as many as the page takes
the-actions-cannot-be-written = the actions cannot be written
is-larger-than-mib-the-most = is larger than { $size } MiB, the most that Riffel reads of a { $what }
is-text-in-but-a-must = is text in { $encoding }, but a { $what } must be UTF-8
byte-of-the-file-is-which = byte { $place } of the file is { $value }, which is not UTF-8; it looks like Windows-1252, where it is "{ $letter }"
write-set-key-value-as-in = write { KEY("--set") } key=value, as in { KEY("--set") } { KEY("contact.friction") }=0.3
is-empty-window = is { $max }, but the window is empty unless it is above the min of { $min }
track-model-needs-it = { KEY("track.model") } = "{ $model }" needs it: give it{ $preset }
or-name-a-preset = , or name a preset by { KEY("track.preset") }
track-of-all-frequencies-in-time = a passage in time needs all frequencies: a model of track and wheel in the place of receptances
rigid-wheel-in-time = a passage in time takes the rigid wheel of [wheel], not a receptance that is given for it
wheelset-of-all-frequencies-in-time = a passage in time needs all frequencies: a model of the wheelset, or its modes, in the place of measured receptances
contacts-at-rest-in-time = a passage in time takes contacts that stay where they are on the profiles; leave it out
no-spring-dashpot-in-time = `{ KEY("contact.response") }` is "spring-dashpot", which is known for small oscillations only; for a passage in time choose "quasi-static" or "non-steady"
quasi-static-in-time = on all axes a passage in time takes a contact that answers at once, `{ KEY("contact.response") }` = "quasi-static"
no-constant-force-in-time = `{ KEY("wheel.rotation") }` is "constant-tangential-force", but where the wheel leaves the rail no creepage keeps the force; choose "inertia" or "constant-creepage"

## Plans that are refused

is-name-but-must-be = is "{ $name }", but must be { $rule }
is-but-for-kind = is "{ $value }", but must be "{ $only }" for { $kind }
this-or-that = "{ $this }" or "{ $that }"
one-of = one of { $names }
a-file-or-one-of = a file or one of { $names }
zero-or-more = zero or more
greater-than-zero = greater than zero
more-than-one = greater than one
finite-and-above-zero = finite and greater than zero
rate-in-per-cent = { $rate } %
rate-of-interest = zero or more and below 100 %
is-with-thousands-apart = is { $value }, with its thousands apart: write digits alone and a decimal point, as in 9000 or 9000.5
is-perhaps-in-thousands = is { $value }, which may be { $thousands } or { $plain }: write it as one of the two
is-with-a-multiple = is { $value }, but must have all its digits: write { $plain }
is-with-its-currency-before = is { $value }, with its currency before it: write { $plain }
is-with-a-comma = is { $value }, with a comma: write a decimal point, as in { $plain }
number-of-a-sum = a number such as 9000
sum-of-zero-or-more = a sum of zero or more in { $currency }, as cost.grinding is
sum-with-currency = a sum with its currency, as in "9000 EUR"
hours-of-zero-or-more = hours, zero or more, as in "6 h"
time-above-zero = a time above zero, as in "18 months" or "25 a"
level-above-limit = a level above the limit of zero or more, as in "3 dB"
level-below-zero = a level below zero, as in "-6 dB"
level-of-zero-or-more = a level of zero or more, as in "0.3 dB"
at-most-the-horizon = at most as long as cost.horizon, { $months } months
say-for-how-long-grinding-closes = say for how long grinding once closes the line, as in grinding_hours = "6 h"
give-cost-of-grinding = give [cost] grinding = "9000 EUR", and one [[action]] or more
write-one-action-or-more = write one [[action]] or more; to leave all as it is is there by itself
write-one-parameter-or-more = write one [[parameter]] or more
give-what-an-action-does = give changes = "soft-pads.toml", multiplies = {"{"} … {"}"} or grind_every = "12 months"
say-how-long-the-investment-lasts = say how long the investment lasts, as in life = "25 a"
name-the-action = name the action
give-each-its-title = give each its title
give-each-its-name = give each its name
is-no-parameter = is no [[parameter]] of the plan; those are { $names }
names-no-parameter = has "{ $name }", which is no [[parameter]] of the plan; those are { $names }
is-name-of-no-parameter = is "{ $name }", but no [[parameter]] has this name
is-name-of-no-data = is "{ $name }", but no [[data]] has this name or kind
is-name-of-none-of-the-data = is "{ $name }", but no [[data]] has this name; there are { $names }
is-name-of-no-vehicle = is "{ $name }", but no vehicle of the traffic has this name
give-what-is-measured = give kind = "dated-levels" to measure once more, or key = "…" with factor = 1.1
is-no-data-to-repeat = is "{ $kind }", but the plan has no such [[data]] whose places and errors it could repeat
weigh-one-value = an axle box cannot be weighed yet; one value can, by key and factor
say-how-good-it-is = say how good it is: factor = 1.1 for 10 %
factor-of-ten-per-cent = 1.1 stands for 10 %
no-discrepancy = "{ $data }" has no `discrepancy`: the model is taken as exact, and intervals will be too narrow
or-leave-it-out = or leave it out
size-of-discrepancy = must be a number of zero or more, or {"{"} half_normal = … {"}"} above zero
is-kind-that-needs-levels = is "{ $kind }", which needs just one [[data]] of kind "dated-levels" of the same rail
pass-by-without-levels = without levels of a trolley nothing says which of its bands are heard
axle-box-without-levels = without levels of a trolley an axle box tells the shape of a spectrum only
is-kind-without-traffic = is "{ $kind }", but the plan names no traffic that made them grow
give-traffic = give traffic = "traffic.toml"
give-traffic-of-the-program = give { KEY("--traffic") } TRAFFIC
errors-are-zero = the errors of the data are zero within rounding
is-set-but-belongs-to-kinds = is set, but belongs to { $kinds }, not to { $kind }
unused-columns = { $file } has columns that are not used: { $columns }
repeats-line = repeats line { $line }: a row that is there twice would count twice
two-errors-of-a-rate = has both `standard_error_ln` and `standard_error_db_per_m`, but an error must have one
too-few-passages = `passages` rises by { $passages } in all, but must rise by { $least } or more: in fewer no rail changes; are they millions?
lines-are-taken-together = the { $lines } lines of { $file } are taken together to { $bands } means of neighbours, narrow where the response bends
ground-between-dates = before the date of { $passages } passages in { $file } the bands fall by more than { $fall } dB: the rail was ground, and growth begins anew there; earlier dates are left out
only-ground = the rail was ground before the date of { $passages } passages, for its bands fall by more than { $fall } dB, and no later date tells of growth; measure once more, or leave this date out
no-coherence = { $file } has no column `coherence`: every line is taken as good to 5 %
is-kind-but-decay-rates-take-bands = is "{ $kind }", but decay rates take "band": their bands are independent
give-the-speed-of-the-run = give the speed of the run, as in speed = "100 km/h"
date-of-a-run = "first", "last" or the passages since the first date of the levels
run-since-first-date = at_date is taken as { $since } passages since the first date of the levels, { $counted } as their table counts
date-that-is-there = "first", "last" or one of the dates, { $dates } passages since the first
is-date-of-too-few = is { $date }, but the plan has no dated levels of three dates or more: without one of two nothing tells of growth
is-place-of-too-few = is { $place }, but the plan has no frequency responses at two places or more
place-of-the-hammer = one of the places of the hammer, { $places } m
is-left-out-by-date = is "{ $name }", but runs of axle boxes and levels of their rail are left out by date
is-the-only-data = is "{ $name }", the only data of the plan: nothing is left to predict them by
hold-out-names-one = `hold_out` must name one of `date`, `position` and `data`
data-cannot-be-parted = the data cannot be parted into some that are left out and some that predict them; give three dates, two places of the hammer or two kinds of data
say-what-differs = say what differs: set = {"{"} key = value {"}"} or without = ["…"]
changes-what-is-uncertain = `{ $place }` changes `{ $key }`, but the plan has it as uncertain: leave it out as well, without = ["{ $name }"]
model-of-the-plan-says = model "{ $title }": { $error }
give-a-prior = give one of lognormal, normal, uniform and triangular
leaves-nothing = leaves nothing of the range that can be computed, { $low } to { $high }
give-key-or-factor = give the key of the case, or multiplies = "…" with a name
name-the-factor = name the factor, as in "preload_stiffening"
is-no-key-of-a-vehicle = is "{ $name }", which a vehicle does not have or which cannot be uncertain
keys-of-a-vehicle = take speed.mean, speed.standard_deviation, traction_share, tractive_ratio, creepage, wheel_load, axle_load, wheel_mass, rolling_radius or set.… after vehicle.
excludes-value-of-the-case = excludes { $value }, the value of the case for `{ $key }`: it lies beyond the ends or four standard deviations of the prior
widen-the-prior = widen the prior, or correct the case
is-key-of-a-vehicle-without-traffic = is a key of a vehicle, but the plan names no traffic
traffic-has-several-vehicles = the traffic has several vehicles: { $names }
is-no-key-of-the-case = is "{ $name }", but the case file has no such key
is-key-of-no-quantity = is "{ $name }", which takes a choice, a name or a whole number
only-quantities-are-uncertain = only quantities can be uncertain
is-pass-by-but = is "pass-by", but { $why }
give-data-another-model = give these data another model: set = {"{"} "track.model" = … {"}"}
silent-bands = { $file }: of { $bands } no level of roughness is known, and they are taken as silent; `roughness` gives the other bands of the rail
wheels-taken-as-smooth = { $file }: without `wheel_roughness` the wheels are taken as smooth
not-for-calibration = vehicle[{ $index }] has `{ $key }`, which calibration does not take; give one wheel at a distribution of speeds
left-out-with-smc = left out with sampler.kind = "smc", which has no warm-up
middle-of-the-priors = in the middle of the priors the case says: { $reason }
columns-of-no-kind = has the columns { $columns }, from which no kind of measurement follows
is-run-without-speed = is a run of an axle box, whose speed no column says
write-run-into-a-plan = write it into a plan: [[data]] with kind = "axle-box" and speed
dates-without-traffic = has levels or profiles of several dates, but there is no traffic that made them grow
averages-are-assumed = averages is taken as { $averages }, for no column says how many blows are in the mean of a line
is-another-plan = is there already and is not the plan with usual priors of these files
run-the-other-plan = riffel calibrate with this plan in place of the case runs it; another folder begins anew
lines-left-out = { $lost } of { $all } lines have too little in common with the first date and are left out
one-or-more = one or more
above-the-min = above the min of { $min }
is-for-quantities = is for quantities, but `{ $key }` takes a choice, a name or a whole number
needs-moments-or-median = needs mean and standard_deviation, or median and factor
is-other-rail-in-this-curve = is "{ $name }", but contact.from.rail = "{ $of }" is the { $rail } rail in a curve of { $radius } m
is-known-between = is known from { $low } to { $high } Hz and is not extrapolated, but { $asked } Hz is asked for
distance-of-the-bogies = distance of the bogies
wheelbase-of-the-bogie = wheelbase
distance-of-the-contacts = distance of the contacts
leaves-nothing-between-its-ends = leaves nothing between its ends: they are more than 30 standard deviations away
larger-than = larger than the { $what } of { $length } m
kind-as-in-example = { $kind }, as in "{ $example }"
is-no-number = is no number, but must be { $rule }

## Faults of the page

newer-request = a newer request has taken the place of this one
page-asks-again = the page asks again by itself
defect-of-riffel = this is a defect of Riffel; the case in the address bar reproduces it
key-is-given-twice = `{ $key }` is given twice, the second time in line { $line }
place-is-not-for-a-page = `{ $key }` is a place on the disk and not for a page: leave it out
page-misunderstood = the page and the program do not understand each other
reload-page = reload the page: it may be older than the program

## Modes of a wheelset

ordinal = { $order ->
        [1] first
        [2] second
        [3] third
        [4] fourth
        [5] fifth
        [6] sixth
        [21] 21st
        [22] 22nd
        [23] 23rd
        [31] 31st
        [32] 32nd
        [33] 33rd
        [41] 41st
        [42] 42nd
        [43] 43rd
       *[other] { $order }th
    }
rigid-body-longitudinal = rigid body: longitudinal
rigid-body-lateral = rigid body: lateral
rigid-body-bounce = rigid body: bounce
rigid-body-roll = rigid body: roll
rigid-body-yaw = rigid body: yaw
symmetric-bending = { $ordinal } symmetric bending
antisymmetric-bending = { $ordinal } antisymmetric bending
torsional-mode = { $ordinal } torsion
stretching-mode = { $ordinal } stretch
elastic-mode = { $ordinal } elastic mode
mode-vertical = { $mode }, vertical
mode-horizontal = { $mode }, horizontal
discs-against-wheels = { $mode } (discs against wheels)
discs-against-each-other = { $mode } (discs against each other)

## What the physics refuses

out-of-range = { $quantity } is { $value }{ $unit }, but { $rule }
off-the-rails = in its equilibrium wheelset { $wheelset } is shifted by { $shift } mm and yawed by { $yaw } mrad, but must be shifted by less than { $farthest_shift } mm and yawed by less than { $largest_yaw } mrad to stay on its rails
no-equilibrium-beyond = no equilibrium was found beyond { $percent } % of this curve: it may be tighter than the wheelsets can take on these profiles; take a wider curve, less uncompensated acceleration, less moment and torque or softer springs
torque-beyond-friction = no equilibrium is found, and a drive torque of { $torque } N m on wheelset { $wheelset } is more than the { $largest } N m that friction carries under the loads of its wheels
beyond-full-slip = creepage is { $creepage } %, but full slip begins at { $limit } % for this contact; the mean state must keep a region of stick

## Records that are refused

heights-without-position = there is one column of heights and no position
heights-without-position-but = there is one column of heights and no position: column { $column } is "{ $cell }", which is no number
no-heights = there is no column of heights
no-heights-but = there is no column of heights: { $reason }
no-table-of-numbers = no table of numbers begins here or below
cell-has-other-mark = column { $column } is "{ $cell }", with a { $other }; the file has a { $own } elsewhere
cell-in-brackets = column { $column } is "{ $cell }": brackets are a minus to some and a doubt to others; write the number without them
cell-with-letters = column { $column } is "{ $cell }", not a number alone: a unit stands in the head, a remark in a column of its own
cell-with-marks = column { $column } is "{ $cell }", not a number alone: write what its other signs mean into a column of its own
cell-is-no-number = column { $column } is "{ $cell }", not a number

## Axle boxes

train-is-too-slow = the train never runs faster than { $slowest } km/h long enough for the longest wavelength, { $longest } m
stretch-is-too-slow = the longest stretch without a gap is { $length } m, at { $speed } km/h in the mean, but must be run at { $slowest } km/h or more; { $said }
stretch-is-too-short = the longest stretch without a gap is { $length } m, but must be { $least } m at { $speed } km/h for waves of up to { $longest } m; { $said }
roughness-of-rail-and-wheel = the roughness is that of rail and wheel together, but for what repeats with the wheel's turn over 16 turns or more
roughness-through-patch = the roughness is what the patch lets through, which is { $patch } mm long: the rail itself is rougher at shorter wavelengths than some five of it; --contact-filter gives it back
axle-box-moves-as-wheelset = the axle box is taken to move as the wheelset does at the contact: bending of the axle between wheel and box is left out
waves-of-other-wheels-left-out = the waves that the other wheels of [train] send along the rail are left out

## Dates that are refused

no-date = "{ $text }" is no date; write it as 2026-01-31 or 31.01.2026, or as the day number of a spreadsheet from 40000 to 60000
year-of-two-digits = "{ $text }" has a year of two digits; write all four
days-in-two-orders = "{ $text }" and "{ $other }" have day and month in different orders; write both as in 2026-01-31
date-may-be-two = "{ $text }" may be two dates; write { $one } or { $other }
year-is-out-of-range = "{ $text }" is not a day between { $first } and { $last }
day-is-not-in-calendar = "{ $text }" is not in the calendar
of-column = column `{ $column }`: { $sentence }

## Runs of axle boxes that are refused

at-line = line { $number }
at-sample = sample { $number }
samples-are-lost = samples are lost where the time leaps
time-is-repeated = a row has no time of its own and is left out: the time is repeated
odometer-leaps = the odometer leaps by more than { $length } m
value-is-missing = a value is missing
number-marks-missing-value = { $mark } marks a missing value
found-once = { $what } once, at { $at }
found-often = { $what } { $count } times; the first is { $at }
time-falls = the time falls from { $before } s to { $time } s
speed-is-below-zero = the speed is { $speed } m/s, but must be zero or greater
speed-beyond-any-train = the speed is { $speed } m/s, { $kilometres } km/h, faster than any train; is its unit right?
odometer-falls = the odometer falls from { $before } m to { $odometer } m, but must rise; where chainage falls along the run, give the speed in its stead
odometer-beyond-any-train = by the odometer the train runs at { $speed } m/s, { $kilometres } km/h, faster than any train; are its unit and the sampling rate, { $rate } Hz, right?
times-begin-anew = its times do not go on from those of the file before, and no odometer says where it lies: it is taken for another run from the same place
there-is-no-reading = there is no reading
every-row-lacks-a-value = every row lacks a value that is needed
mean-is-gravity = the mean is { $mean } { $unit }, as gravity is in { $other }: the unit is wrong
give-in-unit = give it in { $unit }
clipped-at-end = clipped at { $end } m/s² in { $count } samples, { $share } %; the first are at { $at }
clipped-at-ends = clipped at { $high } m/s² and { $low } m/s² in { $count } samples, { $share } %; the first are at { $at }
too-many-are-clipped = { $sentence }; at most { $most } % may be
levels-too-low-there = { $sentence }: levels are too low there
drops-out-once = drops out once, keeping one value for more than { $time } ms, at { $at }
drops-out-often = drops out { $count } times, keeping one value for more than { $time } ms; the first is { $at }
vibrates-beyond-any-axle-box = the root mean square is { $rms } m/s², more than any axle box has; is its unit right?
clock-drifts = the times make { $slowest } to { $fastest } samples a second along the run: the clock drifts; { $rate } is taken
clock-without-one-rate = the times make { $slowest } to { $fastest } samples a second along the run, but must make one rate to { $percent } %; give the sampling rate by { KEY("--rate") } if the times are wrong
times-do-not-rise = the times do not rise from line to line; give the sampling rate by { KEY("--rate") }
no-column-of-times = there is no column of times, as time_s; give the sampling rate by { KEY("--rate") }
times-are-text = column { $column }, `{ $name }`, holds no numbers, but "{ $cell }"; times are needed in seconds, or of day as in 02:59:54.25: write them so, or give the sampling rate by { KEY("--rate") }
times-make-another-rate = the times make { $rate } samples a second, but { KEY("--rate") } says { $given }
given-rate-is-taken = { $sentence }, which is taken: one of the two clocks is wrong
file-says-its-rate = the file says { $rate } samples a second; leave out { KEY("--rate") }
column-has-no-unit = column `{ $name }` has no unit known here; call it { $one } or { $other }
channels-are-for-wav = { KEY("--channels") } is for WAV files: what is in other files their heads say
no-acceleration-given = there is no acceleration
lengths-of-arrays-differ = { $name } has { $count } values, but { $first } has { $other }
place-of-other-length = speed or odometer have { $count } values, but { $first } has { $other }
two-channels-of-one-name = two channels are called "{ $name }", and would be taken for one rail; call them apart
file-is-binary = the file is binary: byte { $at } is { $value }, which no text has
file-of-binary-format = the file is { $name }, and no text: { $reader } reads it; write its columns as text
file-of-other-encoding = the file is { $encoding }; write it as UTF-8
no-table-under-a-head = there is no table under a head such as { $example }
no-column-of-accelerations = there is no column of accelerations; call it { $one } or { $other }
place-is-empty = column `{ $name }` is empty in most rows, but the place of every sample is needed: fill it in, or give the speed by { KEY("--speed") } where it was constant
no-column-of-the-place = there is no column of speeds or of an odometer, as speed_km_per_h or odometer_m; give the speed by { KEY("--speed") } where it was constant
line-is-too-long = the line is longer than { $most } bytes
wav-has-no-units = a WAV file has no units: name its channels in their order, each with its value at full scale, as in { $example }
wav-has-other-count = { $count ->
        [one] the file has 1 channel, but { KEY("--channels") } names { $named }
       *[other] the file has { $count } channels, but { KEY("--channels") } names { $named }
    }
channel-without-scale = { KEY("--channels") } has `{ $channel }`, but must give each channel its value at full scale, above zero, as in { $example }
no-channel-of-accelerations = { KEY("--channels") } names no acceleration, as in { $example }
no-channel-of-the-place = no channel is the speed or an odometer; name it, as in speed_km_per_h=300, or give the speed by { KEY("--speed") } where it was constant
wav-ends-early = the WAV file ends before its head says, or cannot be read
wav-of-another-form = no WAV file that is read here: { $reason }
no-riff-of-waves = no RIFF or RF64 file of waves
samples-before-their-form = its samples come before their form
form-is-cut-short = its form is cut short
samples-of-other-kind = integers of 8 to 32 bits or floating point of 32 or 64 alone
no-acceleration-over-time = the file has no acceleration over time (dataset 58 with an abscissa of kind 17 and an ordinate of kind 12)
no-place-over-time = the file has no speed (kind 11) and no odometer (kind 8) over time; give the speed by { KEY("--speed") } where it was constant
signal-of-other-form = "{ $title }" must have { $points } real values with a step of { $step } s, as the first acceleration has
signal-begins-elsewhere = "{ $title }" begins at { $begin } s and "{ $first }" at { $other } s, but all signals of a run must begin together: cut them to the times that all have
times-are-uneven = the times of "{ $title }" are uneven, but must have one step
times-in-other-unit = the times of "{ $title }" are in { $unit }, which is no unit of time
signal-without-unit = "{ $title }" is { $what } without a unit: neither its axis nor a dataset 164 gives one
signal-with-other-unit = "{ $title }" is { $what }, but is labelled with the unit "{ $unit }"
an-acceleration = an acceleration
a-speed = a speed
an-odometer = an odometer
odometer-makes = the odometer makes { $speed } km/h in the mean
speeds-make = the speeds make { $speed } km/h in the mean
given-speed-says = { KEY("--speed") } says { $speed } km/h
but-other-says = { $one }, but { $other }
one-is-wrong = { $sentence }: one of the two is wrong, or in another unit
first-is-taken = { $sentence }; the first is taken
take-the-wrong-one-out = take the wrong one out, or give the speed by { KEY("--speed") } where it was constant

## Profiles that are refused

is-profile-of-wheel = is the profile of a wheel by what it says, but a rail is asked for
is-profile-of-rail = is the profile of a rail by what it says, but a wheel is asked for
is-list-of-slices = is a list of slices along the rail or around the wheel: give one of the files it names
is-wheel-not-laid-so = is a wheel, which is not laid by "{ $alignment }"
is-rail-not-laid-so = is a rail, which is not laid by "{ $alignment }"
is-rail-against-wheel = is a rail, but { $nominal } is a wheel
is-wheel-against-rail = is a wheel, but { $nominal } is a rail
wider-than-any = the profile is { $across } m across, wider than any wheel or rail: check its unit
narrower-than-any = the profile is { $across } mm across, narrower than any wheel or rail: check its unit
datum-circle-not-known = the tip of the flange lies at x = { $tip } mm and its back is not measured, so that the datum circle is not known: give coordinates with their origin on it, { $back } mm from the flange back
file-of-several-profiles = the file holds several profiles: give a file with one of them
column-def-without-x-and-y = ColumnDef is "{ $value }", but must name the columns X and Y
line-without-x-and-y = "{ $text }" has no numbers X and Y
line-without-millimetres = "{ $text }" has no number in millimetres
line-is-no-pair = "{ $text }" is not a pair of numbers x, y
other-count-of-columns = { $count ->
        [one] there is 1 column, but a profile has two: lateral coordinate and height
       *[other] there are { $count } columns, but a profile has two: lateral coordinate and height, under a head such as y_mm,z_mm where there are others; give one rail or wheel at a time
    }
head-says-other-unit = the head says { $unit }: give a profile in mm or m
head-with-two-units = the head gives both columns units of their own: give a profile in mm or m throughout
line-without-both-sides = "{ $text }" is not y and z of both sides
value-not-known = { $name } is "{ $value }", which is not known
value-must-be-number = { $name } is "{ $value }", but must be a number
line-of-no-head = "{ $text }" is no line of a head, nor are these coordinates
units-per-metre-above-zero = units.len.f must be above zero: how many of the file's units make a metre
no-section-of-profile = "{ $text }" is no section of a profile: header, spline and point are
section-closes-none = { $section }.end closes no { $section }.begin
section-without-end = { $section }.begin has no { $section }.end: the file is cut short
line-is-no-point = "{ $text }" is not a point y z
line-is-no-key = "{ $text }" is neither key = value nor a section
too-few-points = a profile needs { $least } points or more, and this one has { $count }
too-many-points = the profile has { $count } points, more than the { $most } that are read
coordinate-not-finite = a coordinate is not finite
point-stands-twice = the point stands there twice
outline-crosses = the outline crosses or retraces itself here, near x = { $place } mm, as two passes of a device or points in a wrong order do
outline-closes = the outline closes here: give the running surface alone, from one flank to the other, or from the flange to the field side
curve-turns-back = the curve turns back across the track here, as a profile with a loop or in a wrong order of points does
outline-comes-back = the outline comes back here above itself, as two passes of a device do
scatter-not-positive = the scatter of the points is { $scatter } m, but must be above zero
crown-at-end = the highest point of the rail lies at its end, as in a profile that is drawn upside down or cut at its crown
no-datum-circle = x = 0, the datum circle of the tread, is not on the profile of the wheel
no-flank-of-flange = the flank of the flange is not on the profile of the wheel
flange-outside = its flange lies at x above zero: it is mirrored, for x must be positive to the field side
wheel-upside-down = it has no flange below the tread: it is upside down, for y must be the height, and a flange hangs down
wheel-without-flange = it has no flange
profile-lies-elsewhere = the measured profile lies nowhere within 20 mm of the nominal one: check its origin, orientation and unit
measured-without-tip = the measured profile does not reach around the tip of a flange, so that it cannot be laid by it
nominal-without-tip = the nominal profile does not reach around the tip of a flange, so that it cannot be laid by it
field-side-not-measured = the field side of the rail, corner and flank, is not measured, so that it cannot be laid by it
touches-beyond-end = under load the { $side } wheel touches beyond the end of a profile
touches-beside-rail = the { $side } wheel touches beside its rail
left-of-wheels = left
right-of-wheels = right
rails-overlap = with a gauge of { $gauge } mm the rails overlap
ends-above-gauge-height = the inner side of the rail ends above the gauge height of { $height } mm below its crown, or the profile is mirrored: x must be positive to the field side
wheel-has-left-its-rail = at a lateral shift of { $shift } mm and a yaw of { $yaw } mrad the { $side } wheel does not touch its rail
is-cone-without-profile = is "cone", which has no profile
name-a-profile = name a profile such as "{ $name }" or a file
check-places-of-flanges = check profiles.gauge, flange_back_distance and flange_back_position
is-nominal-rail = is "{ $name }", which is a rail
is-nominal-wheel = is "{ $name }", which is a wheel
nominal-wheels = nominal wheels: { $known }
nominal-rails = nominal rails: { $known }
is-profile-in-linear-theory = is a profile, but curve.theory = "linear" runs on cones
choose-cone = choose wheel = "cone" with the equivalent conicity of `riffel profile CASE --wheelset`
is-set-but-of-cones = is set, but belongs to profiles.wheel = "cone"

## Progress

nothing-done = 0 of { $total } { $what }
so-many-done = { $done } of { $total } { $what }, { $rate } a second, { $left } left
share-done = { $what }: { $percent } %
share-done-and-left = { $what }: { $percent } %, { $left } left
so-many-seconds = { $time } s
so-many-minutes = { $time } min
so-many-hours = { $time } h
so-many-days = { $time } days
progress-draws-of-calibration = draws of the calibration
progress-reading = reading
progress-roughness = roughness
progress-stability = stability
progress-taking-in-blocks = taking in blocks
progress-passages = passages
progress-fit = fit of the wear coefficient
progress-growth-map = growth map
progress-figures = figures of the paper
progress-remedies = growth with remedies
progress-contact = contact
progress-validation = validation
progress-field = field
progress-wheels = growth under the wheels
progress-models = growth by the models
progress-listening = listening
progress-traffic = growth under traffic
progress-variants = growth of the variants
progress-bay = growth over the bay
progress-writing-map = writing map.csv
progress-draws = draws
progress-simulations = simulations
progress-samples = samples

## Universal files that are refused

no-dataset = the file holds no dataset, which would begin with -1 in columns 5 and 6
outside-of-datasets = this stands outside of the datasets, which begin and end with -1 in columns 5 and 6
dataset-cut-short = the dataset that begins here is cut short by the end of the file
record-missing = the dataset ends where its { $record } must stand
unknown-form-of-dataset = column 7 must be blank, or "b" in a dataset 58, not "{ $text }"
field-is-no-integer = { $what } must be a whole number within 32 bits, not "{ $text }"
field-is-no-number = { $what } must be a finite number, not "{ $text }"
field-has-no-meaning = { $what } must be { $allowed }, not { $value }
field-not-positive = { $what } must be positive, not { $value }
column-must-be-blank = column { $column } must be blank, as it lies between two fields
units-stated-twice = the file states its units a second time, and differently
too-few-numbers = the number of points is { $points }, which takes { $numbers } numbers, but the dataset holds { $held }
too-many-numbers = the number of points is { $points }, which takes { $numbers } numbers, but the dataset goes on after them
line-lacks-numbers = this line must hold { $needed } numbers, not { $held }
text-after-numbers = the numbers of this line end in column { $column }, but text follows
no-mark-behind-bytes = the number of points is { $points }, which takes { $bytes } bytes, but the closing -1 does not follow them
other-count-of-bytes = the number of bytes is { $declared }, but the points take { $bytes }

## What the page says by itself

web-elsewhere = This page is one file. Measured rails, calibration, bogies in a curve, reports, and maps as PNG, SVG and HTML are on the page that riffel serve opens.
web-explore = Explore
web-compare = Compare
web-measure = Measure
web-motion = Motion
web-paper = Paper
web-take-away = Take away
web-tagline = which corrugation grows, how fast, and why
web-case = Case
web-handles = Handles
web-theme = Light or dark
web-language = Language
web-growth-map = Growth map
web-wavelength = wavelength
web-speed = speed
web-frequency = frequency
web-growth-rate = growth rate per passage
web-per-passage = per passage
web-rate = rate per passage
web-nothing-grows = nothing grows in this window
web-no-difference = no difference
web-hold = Hold scale
web-hold-help = Keep the colour scale while values change
web-headline-mark = fastest under the traffic: { $place }
web-to-highest = Highest growth
web-loop = The loop at the cursor
web-growth-curve = Growth over wavelength
web-rail-name = { $name }
web-rail-named = { $name ->
    [no] rail
   *[other] rail { $name }
 }
web-receptance = Receptance
web-force = Normal force P₁/P₀
web-rail = rail
web-wheel = wheel
web-contact = contact
web-grows-here = grows
web-decays-here = decays
web-time = time factor exp(+iωt), Δ upward on the rail; to the left is antiphase
web-profile = profile Δ
web-normal = normal force P₁
web-tangential = tangential force Q₁
web-lateral-force = lateral force Q_y
web-angular = angular velocity Ω₁
web-dissipation = dissipation W₁ at the rail
web-amplitude = amplitude
web-phase = phase
web-quantity = oscillation
web-direction-only = directions are true, lengths are not; amplitudes in the table
web-parts = Wheel and rail part: |P₁| exceeds P₀ at this amplitude. Signs and rates hold for small amplitudes.
web-sentence = { $lambda } mm at { $speed } is { $hertz } Hz. The normal force { $force }. The rail dissipates { $where }, so { $verdict }
web-leads = leads the profile by { $d }°
web-lags = lags the profile by { $d }°
web-inphase = is in phase with the profile
web-troughs = mostly in the troughs ({ $d }° from the crests)
web-crests = mostly on the crests ({ $d }° from them)
web-doubles = the troughs deepen: corrugation grows and doubles in { $n }.
web-halves = the crests wear off: corrugation decays and halves in { $n }.
web-stays = corrugation neither grows nor decays.
web-notes = Notes
web-stale = the map is that of the last case without an error
web-gone = The program does not answer. Is riffel serve still running?
web-no-pads = this track model has no pads
web-no-turning = not used: the wheel turns in a limit
web-from-preset = from preset or default
web-none = —
web-sources = Sources
web-measured = measured
web-typical = typical
web-assumed = assumed
web-search-key = Search a key
web-no-key-found = No key has this name.
web-own-values = Own values
web-not-given = as it was
web-back-to = Back to
web-headline = What to expect
web-show-why = Why there
web-show-helps = What helps
web-why-there = Why there
web-traffic-curve = Growth under the traffic
web-no-cause = Under the wheel of the case nothing grows at these speeds.
web-not-known = not known
web-faster-than-known = faster than any railway known
web-order-holds = wavelengths and order hold, the rate does not
web-until-doubled = the waves will be twice as high{ $band ->
    [no] {""}
   *[other] {" "}(80 % band)
 }
web-speaks-for = For
web-speaks-against = Against
web-would-settle = Would settle it
web-what-helps = What helps
web-each-alone = each alone, under the traffic
web-remedies-come = Remedies come here, ranked by what each does to growth under the traffic.
web-remedy = remedy
web-growth-changes = growth
web-doubles-in = doubles in
web-ground-after = ground after
web-remedy-cost = cost
web-likely-helps = helps, by the calibration
web-likely-best = best, by the calibration
web-months-gained = { $months } months{ $worth ->
    [no] {""}
   *[other] , { $worth } for 1000
 }
web-keep-remedy = Keep as variant
web-set-traffic = To the traffic…
web-remedy-kept = Kept to compare: { $name }.
web-keep = Keep this variant
web-drop = Remove
web-now = Now
web-difference = Difference
web-first = First map
web-second = Second map
web-nothing-kept = Keep a variant, then change the case: maps, their difference, growth curves and a table appear here, of up to six variants.
web-most-kept = { $n } variants are kept: remove one first.
web-name-of-variant = Name of the variant
web-open-variant = Open
web-variant-open = { $name } is open.
web-report-variants = Report of the variants
web-report-of-variants = Riffel: report of variants
web-opens-variants = This link opens the variants in riffel serve.
web-maps-of-variants = Growth maps and their difference
web-sweep = Sweep
web-sweep-comes = Choose one: curves of growth over wavelength come here, with a table of the highest growth of each.
web-sweep-pads = Pad stiffness 50–500 MN/m
web-sweep-friction = Friction 0.1–0.6
web-sweep-tractive = Tractive ratio 0.15–0.9
web-sweep-speeds = Speed
web-sweep-keep = Keep these six as variants
web-sweep-columns = highest growth rate per passage | wavelength there | frequency there | to double
web-map-widened = The map is wider now: what grows fastest lies at { $place }.
web-sweep-of-traffic = under the traffic, as under Explore
web-so-many-of = { $done } of { $of }
web-nothing-grows-here = nothing grows
web-at-edge = at the edge of the window
web-take-figure = Save
web-compare-rows = grows fastest under the traffic | doubles in | axle passages to double | gross tonnes to double | highest growth rate of the map, per passage | wavelength there | speed there | frequency there | frequency of the strongest branch | creepage | contact stiffness
web-less = less growth
web-more = more growth
web-quoted = “{ $name }”
web-untitled = case without a title
web-measured-against = Held against the case { $title }.
web-common-window = All maps have the window of the case at hand, and the highest growth of the map is that in it: { $window }.
web-other-windows = The window of { $names } alone is another, and so may be the maximum there.
web-start = Where do you want to begin?
web-start-line = line
web-start-vehicle = vehicle
web-start-track = rail and what it lies on
web-start-own = wheel of the line
web-start-go = Go on with it
web-start-help = The map below is that of your choice; everything can be changed on the left, and undone.
web-line-main-line = Main line
web-line-freight = Freight line
web-line-metro = Metro
web-line-tram = Tram
web-tour-sliders = Move a slider: the map follows at once. Below are all keys of the case, each with its unit and source.
web-tour-map = A click on the map says why corrugation grows or decays there. The wheel zooms, a drag shows a part, arrow keys move the cursor.
web-tour-measure = Here a measured rail is held against limits and against this case: drop a file, or try the sample.
web-tour-next = Next
web-tour-done = Done
web-help = Help
web-help-map = On the map: arrow keys, Home for the highest growth, plus and minus zoom, 0 shows the whole.
web-help-steps = Ctrl+Z and Ctrl+Shift+Z go back and forth; the address holds the case.
web-help-numbers = Numbers may have a unit of their own: 350 kg, 770 lb, 60 mph.
web-help-program = Nothing leaves this machine. More is in the book, docs/src in the sources, and in riffel --help.
web-help-start = Choose line, vehicle and track…
web-help-tour = Show the three hints
web-all-keys = Show { $n } keys that this case does not use
web-fold-keys = Fold { $n } keys that this case does not use
web-copy-link = Copy link
web-the-link = link to this case
web-copied = copied
web-link-holds = The link holds: { $holds }.
web-link-without = It does not hold { $left }: save the project for that.
web-save-project = Project (.riffel)
web-project-is = case, variants, traffic, measured rail and plan of a calibration in one file
web-project-saved = The project holds: { $holds }.
web-project-opened = { $name } is open: { $holds }.
web-project-without-record = It does not hold { $names }, which neither the page nor the program has any more: choose the file once more.
web-project-broken = { $name } is damaged or cut short: what is open stays.
web-project-large = { $name } unpacks to more than { $most } MiB: what is open stays.
web-project-other = { $name } is no project of Riffel: what is open stays.
web-project-later = { $name } is a project of version { $version }, but this Riffel reads up to { $own }: what is open stays.
web-save-toml = Case as TOML
web-save-csv = Map as CSV
web-save-png = Map as PNG
web-save-svg = Map as SVG
web-save-html = Map as page (HTML)
web-save-report = Report (HTML)
web-report-of = with the measured rail, if there is one
web-open-toml = Open a case or project…
web-start-over = Start over with the nominal case
web-file-fault = { $line ->
    [no] { $name }:{" "}
   *[other] { $name }, line { $line }:{" "}
 }
web-comments-gone = { $name } is open.
web-paper-intro = Figures 2–8 of Afferrante & Ciavarella (2009), computed now.
web-contact-model = Contact
web-quasi = quasi-static, as printed
web-dashpot = spring and dashpot
web-non-steady = non-steady
web-computing = computing…
web-skip = Skip to the map
web-map-label = Growth map over wavelength and speed. Cursor at { $p }. Arrow keys move it, Home goes to the highest growth, plus and minus zoom, 0 shows the whole map.
web-page-reads = The page reads a table whose head names position and height with their units: position [m], height [µm].
web-drop-file = Drop a roughness file here, or choose one
web-choose = Choose a file…
web-uploading = sending
web-cancel = Cancel
web-over = over
web-spectrum = Roughness spectrum
web-dominant = Dominant wavelengths
web-forecast = Forecast
web-speed-from = speeds from
web-speed-to = speeds to
web-passages-daily = axle passages a day
web-months-ahead = forecast, months ahead
web-in-months = in { $n } months
web-excess = above the trend
web-sample = Try a sample
web-sample-source = Sample: 100 m of two rails, not measured but made by Riffel to its built-in recipe (riffel roughness --synthesise): random roughness, corrugation of 40 mm and 15 µm from 30 to 55 m, a spike and a pit.
web-along = Along the line
web-along-hint = a click takes what is below to that place; drag to zoom, double click for the whole line
web-rms-axis = highest moving RMS in each block [µm]; shaded: to grind
web-limit = limit
web-position = position
web-whole-record = whole record
web-shown-below = Spectrum, cause, forecast and noise below are of:
web-part-in-view = The part in view
web-line-table = Add curves, stations, welds, joints…
web-line-table-hint = a table with the columns position, or from and to, and kind and name
web-record-shows = in the record
web-shows-weld-or-joint = weld or joint
web-shows-squat = squat
web-by-section = Verdict by section
web-verdict-columns = rail | from–to [m] | worst level over its limit | moving RMS: over on, highest | to grind [m] | verdict
web-to-grind = To grind
web-section-columns = rail | from–to [m] | length [m] | worst band | RMS / limit
web-grind-total = In all { $metres } m of line, { $share } % of what was measured.
web-nothing-to-grind = Nothing is to be ground: the moving RMS is nowhere over its limit.
web-noise = Rolling noise
web-noise-rail = rail
web-noise-sleepers = sleepers
web-noise-wheel = wheel
web-noise-total = total
web-noise-axis = level [dB re 20 µPa]
web-noise-level-axis = level [dB(A)]
web-noise-months = time [months]
web-months-word = months
web-noise-level = { $hertz ->
    [no] { $level } dB(A)
   *[other] ≥ { $level } dB(A) (up to { $hertz } Hz)
 }
web-noise-verdict = A coach of { $wheelsets } wheelsets, { $length } m long, with smooth wheels is heard at { $level } over its passage at { $speed }, the mean speed of the traffic, { $distance } m from the middle of the track and { $height } m above the rail.
web-noise-silent = The track of this case has no level: its rail carries vibration on without end, or the model does not say how far. A track of one or two layers, at even or periodic supports, has one.
web-noise-helps = What would make it quieter
web-noise-columns = each alone | dB(A) | saves [dB]
web-noise-ahead = Level in the months ahead
web-noise-limit = highest level allowed
web-noise-wheel-is = wheel:
web-noise-rigid = rigid
web-noise-straight-web = straight web, 920 mm
web-noise-becomes = Under the traffic it becomes { $level } in { $months } months.
web-noise-cut = There roughness leaves the linear range.
web-noise-never = { $limit } dB(A) are not reached in this time.
web-noise-now = { $limit } dB(A) are reached now.
web-noise-then = { $limit } dB(A) are reached in { $months } months.
web-columns = Columns of the table
web-columns-help = Of a table of many columns say which is the position and which are heights of a rail.
web-columns-use = Read it so
web-columns-spacing = step between samples
web-column-n = column { $n }
web-column-is = what it is
web-column-unit = unit
web-column-none = left out
web-column-position = position
web-column-height = height of a rail
web-columns-one-position = One column is the position, not several.
web-columns-no-height = At least one column must be the height of a rail.
web-nothing-dominant = No wavelength stands out.
web-all-along = all along
web-level-axis = level [dB re 1 µm]
web-two-ways = “{ $text }” can be read two ways. Which is meant?
web-read-as = = { $value }
web-far-off = = { $now }; before it was { $before }. Is that meant?
web-not-accepted = { $count ->
    [one] One field is
   *[other] { $count } fields are
 } not accepted; { $isShown ->
    [no] nothing can be shown before
   *[other] what is shown is the last case without an error
 }. Go to:
web-no-number = “{ $text }” is not a number.
web-must-lie = { $label }: { $value }, but must be { $low } to { $high }.
web-must-rise = The highest speed must not be below the lowest.
web-undo = Undo
web-redo = Redo
web-undo-keys = Undo (Ctrl+Z)
web-redo-keys = Redo (Ctrl+Shift+Z)
web-close = Close
web-again = Try again
web-reload = Reload the page
web-stopped = Stopped. What is shown belongs to an earlier case.
web-stopped-once = Stopped: nothing was saved.
web-not-done = { $what }: not done.
web-damaged = This link is damaged or cut short, and no case can be read from it. What was open is still open: ask for the link again.
web-damaged-first = This link is damaged or cut short, and no case can be read from it. Shown is the case that was open here last, or the nominal case: ask for the link again.
web-went-on = This is the case that was open here last.
web-started-over = The nominal case is open.
web-record-taken = { $name } took the place of the record before.
web-record-gone = { $name } is no longer kept by the program: choose it once more.
web-bogie = Curve
web-wheel-profile = wheel
web-rail-profile = rail
web-curve-radius = radius, to the right positive
web-curve-speed = speed
web-left = left
web-right = right
web-bogie-intro = Dimensions of a typical metro bogie, not of the wheel of the case: write those of yours. Files: two columns in mm or m, MiniProf, Simpack or Vampire.
web-curve-cant = cant
web-curve-gauge = gauge
web-bogie-wheelbase = wheelbase
web-bogie-axle-load = mass per axle
web-bogie-longitudinal = stiffness per axle box, along
web-bogie-lateral = stiffness per axle box, across
web-friction-high = friction, high rail
web-friction-low = friction, low rail
web-bogie-from-above = From above, travelling to the right
web-bogie-drawn = Shifts, angles and the bow of the curve are drawn { $scale } times as large. Arrows: creep force on the rail, the longest { $force } kN. Wheels are the darker the more they wear, up to Tγ = { $wear } N.
web-too-narrow = { $label }: no curve is narrower than { $narrowest } m.
web-passage = A wheel over the wave, in time
web-wave-amplitude = amplitude of the wave
web-wave-place = place of the wheel [mm]
web-wave-height = profile [µm]
web-wave-force = P [kN]
web-wave-creepage = creepage [%]
web-wave-dissipation = dissipation [J/m]
web-wave-time = in time
web-wave-linear = linear
web-wave-apart = The wheel is in the air over { $percent } % of the wave (shaded). The linear answer knows nothing of that.
web-wave-large = The wheel stays on the rail, but its normal force falls to { $share } P₀: the linear answer is off.
web-wave-small = The wheel stays on the rail; its normal force falls to { $share } P₀ at the least. The linear answer holds.
web-damage = Damage: shakedown and cracks
web-limit-elastic = elastic
web-limit-line = shakedown, line contact
web-limit-surface = shakedown, surface
web-limit-subsurface = shakedown, below the surface
web-along-wave = along the wave
web-mean-state = mean state
web-crest = crest
web-trough = trough
web-utilised-friction = utilised friction |Q|/P
web-demand = demand { $value }
web-cracks-wavelength-mm = wavelength [mm]
web-cracks-crest = crack on the crest { $months } months after grinding [mm]
web-cracks-crest-monthly = now, mm a month
web-cracks-trough = crack in the trough after { $months } months [mm]
web-cracks-trough-monthly = now, mm a month
web-field = Held against the field
web-site = site
web-measured-what = what
web-predicted-band = predicted: median (80 %)
web-measured-there = measured
web-inside = inside
web-outside = outside
web-up-to = up to { $value }
web-from-on = from { $value }
web-stability = Oscillation without any profile
web-friction-axis = friction μ; dashed: that of the case
web-wheelset-modes = Wheelset in its modes
web-wheelset-none = This case has a lone wheel and no axle. Choose a wheelset on the left, one of its presets for instance.
web-wheelset-list = Natural frequency
web-wheelset-play = Move
web-wheelset-stop = Hold
web-wheelset-drawn = Drawn slower and larger than it is; wheels and discs are rigid, the axle bends, twists and stretches. Lines on the wheels show the twist.
web-growth-of-wheels = Growth of the case under each wheel
web-growth-of-wheels-help = The track of the case under the wheels of this bogie, within a tenth of the speed of the curve: growth over { $span } mm, in one scale. Creep laws that end in sliding give way to FASTSIM.
web-wheel-of = Wheelset { $wheelset }, { $rail } rail
web-wheel-grows = { $rate } per passage at { $wavelength } mm, { $frequency } Hz{ $isEdge ->
    [no] {""}
   *[other] , at the edge of the window
 }; to double: { $doubling }
web-use-state = Use these creepages in the case
web-state-used = The case has the mean state of: { $name }.
web-wheel-orientation = how the wheel file stands
web-rail-orientation = how the rail file stands
web-stands-found = stands as found
web-stands-as-written = as written
web-stands-mirrored = mirrored
web-stands-upside-down = upside down
web-stands-turned = mirrored and upside down
web-profiles-panel = Profiles
web-curvatures-panel = Curvature
web-wheels-panel = The four wheels in the curve
web-across-profile = lateral x, field side positive [mm]
web-height-profile = height [mm]
web-curvature-profile = curvature [1/m]
web-no-equilibrium = The bogie does not stand in this curve:
web-shift-mm = shift mm
web-attack-mrad = attack mrad
web-along-percent = creepage along %
web-across-percent = across %
web-angle-degrees = angle °
web-load-kn = P kN
web-t-gamma = Tγ N
web-profile-large = { $name } is larger than 80 kB: profiles have some thousand points; riffel profile reads larger files.
web-add-earlier = Add an earlier record…
web-earlier-hint = The oldest first, or with the dates of all: then growth is told by the year, and the wear coefficient is fitted to it. Drop a file here, too.
web-measured-on = measured on
web-earlier-gone = Its earlier records went with it.
web-left-out = left out
web-by-columns = It was read by the columns that were chosen for the record.
web-most-earlier = { $name } was not taken: there are { $most } earlier records at most. Remove one first.
web-no-date = This is no whole date from 1900 on.
web-date-not-before = This must be before { $date }, the date of the record above.
web-date-twice = { $name } is of { $date }, too: each record has a date of its own.
web-course = { $points }: { $change } dB in all, { $slope } ± { $scatter } dB { $isYear ->
    [no] from record to record
   *[other] a year
 }
web-fit-between = Fitted to what has changed between the last two dated records, over { $n } axle passages:
web-use-coefficient = Use it in the case
web-coefficient-used = The wear coefficient of the case is now { $value } kg/J.
web-add-vehicle = Add a vehicle
web-vehicle-n = vehicle { $n }
web-vehicle-name = vehicle
web-vehicle-share = share of axle passages
web-vehicle-load = wheel load P₀
web-vehicle-traction = tractive ratio τ
web-as-the-case = as the case
web-vehicle-needs-name = A vehicle needs a name.
web-vehicle-twice = “{ $name }” is another vehicle already.
web-vehicle-needs = A vehicle needs its own: { $what }.
web-shares-sum = The shares of axle passages sum to { $sum } %, but must sum to 100 %.
web-no-unit = “{ $text }” has no unit of this field, which are { $units }.
web-all-wheels = all wheels of the bogie, each as it stands in the curve
web-traffic = Traffic
web-traffic-default = usual: { $n } axle passages a day
web-traffic-given = { $n } axle passages a day
web-traffic-is-default = This is the usual traffic of such a line: put in that of yours.
web-calibrate = Calibrate
web-choose-data = Choose files…
web-drop-data = Drop measurements here, or choose files
web-taken-as = taken as { $kind }, { $size }
web-frequency-response = receptance of the rail (hammer)
web-wear = wear of the head
web-decay-rate = decay rates
web-dated-levels = roughness levels of several dates
web-axle-box = run of an axle box
web-most-data = { $name } was not taken: there are { $most } files at most. Remove one first.
web-calibrate-comes = Measurements tell what a case can only assume. Drop tables here: receptances of a hammer, decay rates of the rail, roughness levels of several dates. The columns say what each is. Then comes what you knew before, and what is known after: each value with its interval, and which values the data cannot tell.
web-try-example = Try an example
web-example-source = Example: levels of three dates, not measured but made by Riffel with known values. Growth tells the wear coefficient only as a product with friction, traction and the share of driven wheels: these are left out, and the wear coefficient stands for the product.
web-example-open = The case of the example is open, with its traffic.
web-known-before = Known before
web-known-before-help = usual priors: put what you know in their place, or leave a value out
web-uncertain = uncertain value
web-prior = prior
web-told-from = data that depend on it
web-prior-median = median
web-prior-factor = factor
web-prior-mean = mean
web-prior-standard-deviation = ±
web-prior-min = from
web-prior-max = to
web-value-of-case = left out: value of the case
web-calibrate-now = Calibrate
web-draws-word = draws
web-draws-of-chain = draws of each chain
web-draws-done = { $done } of { $of } draws
web-stopped-drawing = Stopped: nothing was concluded.
web-save-plan = Save the plan
web-take-medians = Take the medians into the case
web-medians-taken = medians taken into the case: { $names }
web-data-tell = What the data tell
web-before-after = Before and after
web-before-after-help = Filled: after the data, with the median and 90 %. Pale: before.
web-predicted = Data and model
web-predicted-help = Points: measured. Bands: where 90 % of such data would lie over the calibration, with errors and with what the model misses.
web-drawn = { $chains } chains of { $warmup } + { $draws } draws, seed { $seed }; the program takes 1000 + 1000 if not told otherwise. Largest R̂: { $rhat }.
web-was-before = before: { $span }
web-told-share = told by data { $share } %, R̂ { $rhat }, { $draws } effective draws
web-missed-of = missed by the model ({ $data })
web-preload-stiffening = stiffening of pads under the train
web-speed-mean = mean speed
web-speed-deviation = spread of speeds
web-traction-share = share of driven wheels
web-vehicle-wheel-mass = mass of the wheel (vehicle)
web-receptance-axis = |H| [nm/N]
web-phase-axis = arg H [°]
web-decay-axis = decay rate [dB/m]
web-rise-axis = rise since the first date [dB]
web-axle-box-axis = axle box, over the first date [dB]
web-pass-by-axis = pass-by, over the first levels [dB(A)]
web-wave-growth-axis = growth of waves [dB]
web-wave-drift-axis = drift of waves [°]
web-wear-axis = wear per 100 MGT [mm]
web-what-to-do = What to do
web-what-to-do-help = a remedy takes part once it has a cost; to leave all as it is always does
web-currency = currency
web-cost-grinding = grinding once
web-cost-possession = closing the line for it
web-cost-over-limit = each month over the limit
web-cost-from-limit = grinding leaves, from the limit
web-cost-discount-rate = interest
web-cost-horizon = horizon
web-grind-every = also compare grinding every
web-every-months = grinding every { $n } months
web-action-investment = investment
web-action-life = its life
web-action-upkeep = upkeep a year
web-measure-once-more = measure once more
web-price = price
web-rank-now = Rank
web-ranked = Which pays
web-ranked-help = costs of a year: line 90 %, bar half of the draws, mark the mean
web-as-it-is = leave all as it is
web-ranked-action = action
web-ranked-picture = cost a year
web-ranked-mean = mean [{ $currency }]
web-ranked-band = 90 % [{ $currency }]
web-ranked-cheapest = is cheapest
web-ranked-helps = grinds less often
web-save-decision = Save the plan with its actions
web-passages-unit = dB per 10⁶ passages
web-worth-measured = To measure once more, { $name }, is worth { $worth } { $currency } a year; less its price of { $price } { $currency }, { $net } { $currency } over the horizon.
web-worth-known = To know the value exactly, { $name }, would be worth { $worth } { $currency } a year.
web-passages-word = passages
web-speed-unit = Unit of speeds
web-whole-map = Whole map
web-band = traffic
web-band-default = usual traffic
web-gross-tonnes = { $n } MGT
web-growth-time = { $time } or { $mass }{ $isDefault ->
    [no] {""}
   *[other] {" "}with the usual traffic
 }
web-time-months = { $n } months
web-time-days = { $n } days
web-time-years = { $n } years
web-not-taken-these = Not written back, for these data do not tell them, or only together with another: { $names }.
web-not-taken-any = Nothing is written back, for the chains allow no conclusion.
web-left-record = the record { $name }
web-left-plan = the plan of the calibration
web-left-costs = what remedies cost
web-holds-variants = { $count } variant{ $count ->
    [one] {""}
   *[other] s
 }
web-holds-traffic = the traffic
web-holds-no-traffic = no traffic of its own
web-holds-record = the record { $record }{ $earlier ->
    [no] {""}
   *[other] {" "}with { $earlier } earlier
 }
web-holds-tables = the plan of a calibration with { $count } table{ $count ->
    [one] {""}
   *[other] s
 }
web-billion = { $count } billion
web-million = { $count } million

# Keys of a case as fields, and groups of them
web-name-title = title
web-name-vehicle = vehicle preset
web-name-steel = Steel
web-name-wheel = Wheel
web-name-rail = Rail
web-name-track = Track
web-name-contact = Contact
web-name-corrugation = Corrugation
web-name-wear = Wear
web-name-map = Window of the map
web-name-general = General
web-name-steel-youngs-modulus = Young's modulus E
web-name-steel-poisson-ratio = Poisson's ratio ν
web-name-wheel-rolling-radius = rolling radius R
web-name-wheel-mass = unsprung mass m_w
web-name-wheel-inertia = wheel inertia I_w
web-name-wheel-rotation = rotation
web-name-wheel-normal-direction = direction of the normal force
web-name-rail-section = section
web-name-rail-mass-per-length = mass per length m
web-name-rail-second-moment = second moment I
web-name-rail-lateral-second-moment = lateral second moment
web-name-rail-beam = beam
web-name-rail-area = area A
web-name-rail-shear-coefficient = shear coefficient κ
web-name-rail-lateral-shear-coefficient = lateral shear coefficient
web-name-rail-shear-modulus = shear modulus G
web-name-rail-density = density ρ
web-name-rail-loss-factor = loss factor η
web-name-track-model = model
web-name-track-preset = preset
web-name-track-support-spacing = support spacing
web-name-track-pad = Rail pad
web-name-track-sleeper = Sleeper
web-name-track-ballast = Ballast
web-name-track-rail-damping = rail damping
web-name-track-position = position of the wheel
web-name-contact-transverse-radius = transverse radius R_r
web-name-contact-normal-load = normal load P₀
web-name-contact-friction = friction μ
web-name-contact-tractive-ratio = tractive ratio τ
web-name-contact-creepage = creepage ξ₀
web-name-contact-dissipation-phase = dissipation phase
web-name-contact-wave-geometry = the wave's own geometry
web-name-contact-wave-patch = curvature of waves
web-name-contact-creep-law = creep law
web-name-contact-response = response
web-name-contact-hertz = ellipse
web-name-contact-grid = grid
web-name-contact-polach = Polach's law
web-name-contact-polach-limit-friction-ratio = limit friction ratio A
web-name-contact-polach-friction-decay = friction decay B
web-name-contact-polach-speed = speed V
web-name-contact-polach-adhesion-reduction = adhesion reduction k_A
web-name-contact-polach-slip-reduction = slip reduction k_S
web-name-corrugation-amplitude = amplitude Δ
web-name-wear-coefficient = wear coefficient k_w
web-name-wear-measured = Measured wear
web-name-wear-measured-depth = depth worn off
web-name-wear-measured-per = under trains of
web-name-wear-measured-factor = known within a factor
web-name-wear-density = density ρ
web-name-wear-band-width = band width w
web-name-wear-law = law
web-name-wear-spread = spread σ
web-name-wear-speed = speed V
web-name-wear-natural-lubrication = natural lubrication
web-name-damage = Damage beside wear
web-name-damage-laws = laws
web-name-damage-grade = rail grade
web-name-damage-shear-yield = shear yield k
web-name-damage-limit = limit
web-name-damage-spread = spread of the demand σ
web-name-damage-flow = Flow
web-name-damage-flow-depth = depth H
web-name-damage-flow-exponent = exponent m
web-name-damage-flow-hardening-depth = hardening depth D_h
web-name-damage-flow-along = Flow along the rail
web-name-damage-flow-along-area = area J_r
web-name-damage-flow-along-exponent = exponent m
web-name-damage-load = Load
web-name-damage-load-depth-per-force = depth per force β
web-name-damage-bending = Bending
web-name-damage-bending-limit = limit M_lim
web-name-damage-bending-curvature = curvature B
web-name-damage-bending-exponent = exponent m
web-name-damage-fatigue = Fatigue
web-name-damage-fatigue-thresholds = thresholds of Tγ
web-name-damage-fatigue-peak = peak
web-name-damage-fatigue-crack-growth = crack growth c_D
web-name-damage-fatigue-crack-angle = crack angle α
web-name-damage-fatigue-loss = loss
web-name-map-wavelength = Wavelengths
web-name-map-speed = Speeds
web-name-wheelset = Wheelset
web-name-train = Train
web-name-opposite-contact = Contact on the opposite rail
web-name-wheelset-mass = mass M
web-name-wheelset-roll-inertia = roll inertia J_x
web-name-wheelset-spin-inertia = spin inertia J_y
web-name-wheelset-model = model
web-name-wheelset-contact-spacing = contact spacing 2s
web-name-wheelset-normal-direction = direction of the normal force
web-name-wheelset-opposite-rail = opposite rail
web-name-wheelset-rail = rail under study
web-name-wheelset-suspension = Primary suspension, per side
web-name-wheelset-suspension-spacing = spacing
web-name-wheelset-axle = Axle
web-name-wheelset-discs = discs
web-name-train-wheels = wheels behind the first
web-name-train-comb = comb
web-name-contact-creepage-table = Creepage in any direction
web-name-opposite-contact-creepage-table = Creepage in any direction
web-name-longitudinal = longitudinal ξ_x
web-name-lateral = lateral ξ_y
web-name-spin = spin φ
web-name-contact-angle = contact angle γ
web-name-lateral-offset = lateral offset e
web-name-contact-conformity = Contact that moves across the profiles
web-name-rail-radius = head radius R_c
web-name-cross-slope = cross slope of the ripple κ
web-name-transverse-radius = transverse radius R_r
web-name-normal-load = normal load P₀
web-name-friction = friction μ
web-name-creepage = creepage ξ₀
web-name-rail-torsion-constant = torsion constant J
web-name-rail-polar-second-moment = polar second moment I_p
web-name-rail-warping-constant = warping constant I_ω
web-name-rail-centroid-height = centroid above shear centre
web-name-rail-head-height = head above shear centre h
web-name-rail-foot-depth = foot below shear centre d
web-name-rail-foot-width = foot width B
web-name-vertical-stiffness = vertical stiffness
web-name-longitudinal-damping = longitudinal damping
web-name-lateral-damping = lateral damping
web-name-vertical-damping = vertical damping
web-name-diameter = diameter
web-name-length = length
web-name-segments = segments
web-name-density = density ρ
web-name-youngs-modulus = Young's modulus E
web-name-poisson-ratio = Poisson's ratio ν
web-name-shear-coefficient = shear coefficient κ
web-name-track-pad-stiffness-slider = pad stiffness k
web-name-longitudinal-radius = longitudinal radius
web-name-contact-from = Mean state from a curve
web-name-contact-from-curve = case file of the curve
web-name-contact-from-patch = patch
web-name-contact-conformity-rolling-radius = rolling radius
web-name-rail-roll = rail roll
web-name-curve = Curve
web-name-curve-theory = theory
web-name-curve-radius = radius R
web-name-curve-cant = cant
web-name-curve-speed = speed V
web-name-bogie = Bogie
web-name-bogie-wheelsets = wheelsets
web-name-wheelbase = wheelbase 2a
web-name-primary-spacing = spacing of the axle boxes 2b
web-name-primary-longitudinal-stiffness = primary stiffness, along
web-name-primary-lateral-stiffness = primary stiffness, across
web-name-mass-per-axle = mass per axle
web-name-centre-of-mass-height = height of the centre of mass
web-name-frame-yaw-moment = yaw moment on the frame
web-name-frame-yaw = yaw of the frame
web-name-frame-lateral-shift = lateral shift of the frame
web-name-drive-torque = drive torques
web-name-body = Body on two bogies
web-name-bogie-spacing = spacing of the bogies 2l
web-name-secondary-lateral-stiffness = secondary stiffness, across
web-name-secondary-yaw-stiffness = secondary stiffness, yaw
web-name-profiles = Profiles
web-name-profiles-rail-table = A profile for each rail
web-name-profiles-rail-left = left rail
web-name-profiles-rail-right = right rail
web-name-profiles-scatter = scatter of the points
web-name-wheel-orientation = orientation of the wheel
web-name-rail-orientation = orientation of the rail
web-name-left-wheel = profile of the left wheels
web-name-gauge = gauge
web-name-gauge-height = depth of the gauge
web-name-inclination = inclination of the rails
web-name-flange-back-distance = distance of the flange backs
web-name-flange-back-position = place of the flange back
web-name-conicity = conicity λ
web-name-flange = Flange of cones
web-name-clearance = clearance
web-name-slope = slope
web-name-shift = shift
web-name-width = width
web-name-contact-plane = plane of contact
web-name-contact-shift-moment = moment of shifted contacts
web-name-preset = preset
web-name-stiffness = stiffness k
web-name-damping = damping c
web-name-loss-factor = loss factor η
web-name-lateral-stiffness = lateral stiffness
web-name-longitudinal-stiffness = longitudinal stiffness
web-name-mass = mass
web-name-min = from
web-name-max = to
web-name-points = points
