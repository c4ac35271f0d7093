# What Riffel says. One message an entry: its English, and in .short the same in one line for a terminal.

verbatim = { $words }

## Windows, values and presets

map-window = map
traffic-window = traffic
unusual-value = { $key } is { $value }; usual values are { $from } to { $to }{ $question }
number-without-unit = { $key } has no unit and is read as { $read }{ $question }
quoted = "{ $words }"
in-brackets = {" "}({ $words })
did-you-mean = did you mean { $meant }?
did-you-mean-either = did you mean { $one } or { $other }?
preset-changes-nothing = { $key } = "{ $name }" changes nothing: the case gives all of its values itself

## Measured receptances

value-at-zero-left-out = the measured value at 0 Hz is left out
set-conjugate = set track.measurement.conjugate
conjugate-it = conjugate it
receptance-gives-energy = the measured receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies, between { $first } and { $last } Hz: check its phase, its noise, and whether it follows exp(+iωt) (else { $remedy })
    .short = the measured receptance gives energy away (Im H > 0) at { $count } of { $points } frequencies: check its phase
column-without-unit = column `{ $column }` names no unit: taken as a receptance in m/N (else set track.measurement.quantity and unit)
receptance-unlike-rail = the measured receptance is { $least } to { $most } m/N, but rails have 1e-11 to 1e-7 m/N: check track.measurement.quantity and unit
poor-coherence = the coherence is below { $good } at { $count } of { $points } frequencies, between { $first } and { $last } Hz: there the receptance is the mean of the lines within 1/24 octave, weighted by γ²/(1 − γ²)
response-at-other-node = the measured response is at node { $response } and its force at node { $reference }: it is taken as the receptance at the contact

## Ranges of validity

rail-without-support = the rail has no support: below about { $free_beam_from_hz } Hz (lowest of the { $window }: { $lowest } Hz) pads, sleepers and ballast change its receptance
    .short = the rail has no support: wrong below about { $free_beam_from_hz } Hz ({ $window } from { $lowest } Hz)
rail-without-shear = the rail bends without shear: its receptance is some 9° off at { $euler_beam_up_to_hz } Hz, 24° and 14 % at 1500 Hz (highest of the { $window }: { $highest } Hz)
    .short = the rail bends without shear: 24° and 14 % off at 1500 Hz ({ $window } to { $highest } Hz)
pinned-pinned-without-shear = the rail bends without shear: its pinned-pinned frequency is overstated by 20 to 35 % or more and not named (choose rail.beam = "timoshenko")
    .short = the rail bends without shear: its pinned-pinned frequency is too high and not named
supports-spread-evenly = supports are spread evenly along the rail: the pinned-pinned resonance near { $pinned } Hz is missing, and below it the receptance is 10 to 50 % off, more on very stiff pads (highest of the { $window }: { $highest } Hz; choose a model that ends in -periodic)
    .short = supports are spread evenly: no pinned-pinned resonance near { $pinned } Hz ({ $window } to { $highest } Hz)
no-average-over-patch = the contact is quasi-static and does not average over its patch: below { $shortest } mm growth is overstated
    .short = the contact does not average over its patch: growth is overstated below { $shortest } mm
closed-form-of-ellipse = the radii of wheel and rail differ much: the closed form of the contact ellipse is { $percent } % off across the rail (choose contact.hertz = "exact")
    .short = the closed form of the contact ellipse is { $percent } % off (contact.hertz = "exact" is not)
falling-friction-at-one-speed = falling friction is that of the slip at { $rolling }, contact.polach.speed, at every speed of the { $window }
    .short = falling friction is that at { $rolling } at every speed of the { $window }
wheel-and-rail-part = an amplitude of { $amplitude } µm makes |P₁/P₀| reach { $worst }: wheel and rail part; forces are linear up to { $limit } µm (growth rates hold for small amplitudes and do not change)
    .short = { $amplitude } µm make wheel and rail part (|P₁/P₀| = { $worst }); forces are linear up to { $limit } µm
wave-geometry-left-out = the wave's own geometry has no part (contact.wave_geometry): it would take some { $takes } per m off a growth of { $growth } per m, at { $wavelength } mm and { $speed } km/h
    .short = without the wave's own geometry, which would take some { $takes } per m off { $growth } (contact.wave_geometry)
wave-shorter-than-patch = below { $shortest } mm, three half-lengths of the patch, the wave's own geometry is a rough estimate
troughs-bridged = below { $bridged } mm the wheel bridges the troughs of waves of { $amplitude } µm (growth rates hold for small amplitudes)
    .short = below { $bridged } mm the wheel bridges troughs of { $amplitude } µm

## Branches of the ridge

at-edge-of-window = , at the edge of the window
nothing-grows = nothing grows in this window
both = { $one } and { $other }
one-after-other = { $one }; { $other }
before-comma = { $words },{" "}
branch = { $frequency } Hz ({ $mechanism }{ $speeds } km/h, { $wavelengths } mm{ $edge })
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
wheels-slide-as-they-roll = the wheels slide as fast as they roll: with so much creepage the creep forces fall short of those of the mean state, and nothing else holds the wheels; give them wheelset.suspension, or less creepage
wheel-bridges-trough = a wheel of this radius does not reach the troughs of such waves above { $largest } µm: it would touch in two places, and here touches in one
edge-of-patch-not-resolved = the load moves the edge of the patch by { $moves } elements: harmonics of the creep force may be tens of per cent off; take a larger amplitude, or more than { $across } elements across (contact.grid), until it is { $resolved }

## Profiles

flat-patch-beyond-range = the rail turns by { $degrees }° across a patch: the flat one holds to some 23°, half a width over the radius of 0.2; beyond, take the conformal one beside it
rail-worn-on-field-side = { $name }: { $millimetres } mm are left on the field side by which it is laid: it is worn there, or inclined (--inclination), or another rail

## Files of profiles

flange-backs-apart = the flange backs of the file are { $distance } mm apart
tread-datum-elsewhere = its tread datum lies { $datum } mm from the flange back, but the wheel is placed by its flange back, and its origin lies { $origin } mm from it
gauge-of-file = the gauge of the file is { $distance } mm, { $depth } mm below the crown
smoothing-of-file-left-out = the smoothing of the file (approx.smooth) is not that of Riffel and is left out: give the scatter of its points
points-missing = the head announces { $announced } points (XYPoints), but { $count } follow: the file may be cut short
masked-points-left-out = { $masked } points that were masked at the device are left out
outlying-points-left-out = { $name }: { $count } points far off those beside them are left out, the first in line { $line }
scatter-of-curvature = { $name }: scatter leaves ±{ $error } 1/m of the curvature at x = 0
points-scatter = { $name }: the points scatter by { $micrometres } µm, so that the curvature of a curve through them is off by some { $curvature } 1/m; give that scatter (profiles.scatter, --scatter) for a smooth one

## Curves

wheelset-beyond-flange = a wheelset is shifted by { $shift } mm: flanges leave 5 to 10 mm of play, and this case has none
linear-creep-beyond-friction = creep_law = "linear" knows no friction: creep forces reach { $most } of μP
yaw-takes-play = with its yaw of { $yaw } mrad wheelset { $number } has { $yawed } mm to its flange, not the { $straight } mm of the tables: contacts are placed as without yaw

## The mean state from a curve

creep-law-without-spin = contact.creep_law = "{ $name }" knows no spin: the { $spin } 1/m of the curve are left out ({ $key })
case-has-own-values = in place of what that curve says the case has its own { $instead }
no-rigid-contact-at-angle = no rigid contact has the angle of the equilibrium, { $degrees }°
patches-join = the patch joins that of the place where the wheel touches next
two-points-join-under-load = the wheel stands on two points, which a patch under load would join

## Ranges of validity, further

ellipse-too-wide = the ellipse of the contact is { $width } mm wide: over that no profile has one curvature, and Hertz's theory ends
loop-not-judged = whether the loop is stable at { $speed } km/h cannot be told: its phase jumps, as at a resonance without damping or beyond measured frequencies; give wheelset, rail and pads a loss factor
loop-unstable = the loop is unstable at { $speed } km/h: near { $frequency } Hz it oscillates without any profile (squeal, stick and slip){ $growth }, and growth rates mean nothing there
loop-unstable-growth = , growing e-fold in { $time }
stability-title = Oscillation without any profile
stability-caption = Solid: the boundary; on the side of the mark an oscillation of the named frequency grows by itself (known to half a step of the grid). Dotted and dashed: how fast, e-fold so many times a second. Mark: where it grows fastest. Where several grow, the highest frequency is shown.
stability-of-one-axis = a wheel that only moves down and turns does not oscillate by itself; give it creepage or motion across the rail, as contact.from or a [wheelset] does
stability-unknown = { $points } points cannot be told: the phase of the loop jumps there, as at a resonance without damping; give wheelset, rail and pads a loss factor
no-mean-state = at a friction of { $friction } the wheels find no mean state; those points are left out
stable-everywhere = the loop is stable from { $slowest } to { $fastest } km/h up to a friction of { $highest }
unstable-from = an oscillation grows by itself from a friction of { $least } on, somewhere from { $slowest } to { $fastest } km/h
unstable-from-the-least = an oscillation grows by itself even at the least friction looked at, { $least }, somewhere from { $slowest } to { $fastest } km/h
branch-from = from Hz
branch-to = to Hz
least-friction = least friction
fastest-growth-in-time = fastest growth 1/s
at-speed-column = at km/h
at-friction-column = at friction
wheel-flatter-than-radius = at { $angle }° the wheel is { $flatter } times as flat along the rail as its rolling radius, which the ellipse takes: give contact.longitudinal_radius
track-moves-downward-only = this track moves downward alone; along and across the rail it is taken as rigid

## Measured wheelsets

column-of-wheelset-without-unit = column `{ $column }` names no unit: taken as a receptance in m/N (else write it, as in `{ $column } [m/s2/N]`)
wheelset-not-reciprocal = the measured wheelset is not reciprocal: { $at } by a force at { $from } and the reverse differ by up to { $percent } %, at { $hertz } Hz; their mean is taken: check accelerometer, hammer and the sign of the axes
wheelset-gives-energy = the measured wheelset gives energy away, by up to { $percent } % of its largest receptance, at { $hertz } Hz, most at { $port }: check phases, noise, missing entries, and whether it follows exp(+iωt)
wheelset-not-measured-along = the wheelset was not measured along { $axes }: there it is taken as rigid

## Cases

creep-law-unlike-equilibrium = contact.creep_law = "{ $law }" makes |Q| = { $here } μP of creepages at which the equilibrium of the curve has { $in_curve }
creep-law-of-growth-only = contact.creep_law = "{ $law }" is that of growth: in the curve creep is of Shen, Hedrick and Elkins
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
mean-state-from-curve = mean state from the curve of { $radius } m at { $speed } km/h: wheelset { $wheelset } { $rail } creeps { $along } % along, { $across } % across, spin { $spin } 1/m, under { $load } kN at { $angle }°
ellipse-in-place-of-patch = { $rail } the loop takes the ellipse of Hertz and no patch of the profiles under load: { $reason }
patch-under-load-against-hertz = ; the profiles under load, on the curved rail, are stiffer by { $stiffer } %, { $longer } % as long and { $wider } % as wide (contact.from.patch = "conformal" takes them)
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

## Traffic

growth-faster-than-any-seen = the amplitude at { $wavelength } mm doubles in { $days } days, faster than any growth known here from a railway: { $known } days in a metro curve of 120 m radius (Torstensson & Nielsen 2009); check tractive_ratio, traction_share (the share of axles under it) and wear.coefficient

## What the fastest wavelength follows

cause-near = { $wavelength } mm grows most at { $speed } km/h, where { $frequency } Hz lies { $distance } % from { $resonance } Hz ({ $mechanism })
cause-alone = { $wavelength } mm grows most at { $speed } km/h, at { $frequency } Hz; no resonance of track or wheelset lies within { $within } % of that
cause-loop = no resonance: the loop of force, creepage and wear
frequency-is-kept = from { $slow } to { $fast } km/h the fastest wavelength goes from { $first } to { $last } mm and its frequency from { $low } to { $high } Hz: a frequency is fixed, not a length
frequency-is-not-kept = from { $slow } to { $fast } km/h the frequency of the fastest wavelength goes from { $low } to { $high } Hz: no one frequency is fixed
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
helps-nothing = none of these remedies slows growth
left-out-for = left out: { $title }; { $reason }
remedy-lacks-key = the case has no value of { $key }
remedy-has-no-effect = { $key } changes nothing in this case
remedy-is-refused = this case cannot be computed with it
friction-is-low = friction is { $friction } already
grinding-leaves-growth = grinding lowers the level and leaves growth as it is, 6 dB in { $time }
ground-as-it-is = as it is, the first band rises by 6 dB from what grinding leaves in { $time }: this is the grinding interval of a limit so far above
steps-are-chosen = how far each remedy goes is chosen; what a product does stands in its data sheet
speeds-are-wide = speeds are spread about as widely as a normal distribution can be
treatment-keeps-force = with the friction treatment trains pull and brake with the same force, at more creepage; where a curve sets the creepage, give contact.creepage in place of contact.tractive_ratio

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
field-is-kept = predicted by riffel { $version } with { $samples } samples of each site, once, and kept by the project: { $inside } of { $outcomes } measured values lie inside, the logarithmic score is { $score }

## Growth under the traffic of a line

traffic-of-main-line = the usual traffic of a main line
traffic-of-freight-line = the usual traffic of a freight line
traffic-of-heavy-haul = the usual traffic of a heavy-haul line
traffic-of-metro = the usual traffic of a metro
traffic-of-tram = the usual traffic of a tramway
traffic-of-curve = the usual traffic of this curve
traffic-given = the traffic given
traffic-at-speeds = { $traffic } ({ $slowest }–{ $fastest } km/h)
traffic-at-speeds-a-day = { $traffic } ({ $slowest }–{ $fastest } km/h, { $axles } axles a day)
compared-under = under { $traffic }
shorter-waves = shorter
longer-waves = longer
one-wavelength = { $wavelength } mm
wavelengths-between = { $shortest }–{ $longest } mm
grows-fastest-under = { $range } grows fastest under { $traffic }; { $wavelength } mm leads and doubles in { $time }
grows-fastest-under-within = { $range } grows fastest under { $traffic }; { $wavelength } mm leads and doubles in { $time } (80 %: the wear coefficient is uncertain)
fastest-at-edge = { $wavelength } mm is at the edge and no maximum: { $beyond } waves may grow faster
nothing-grows-under = nothing from { $shortest } to { $longest } mm grows under { $traffic }
days-of = { $days } days
days-between = { $early } to { $late } days
months-of = { $months } months
months-between = { $early } to { $late } months
years-of = { $years } years
years-between = { $early } to { $late } years
longer-than-years = more than { $years } years
million-axles = { $axles } million axles
million-axles-between = { $early } to { $late } million axles

## Noise

rigid-wheel = the wheel is a rigid body here: above some 1.6 kHz the modes of its web and tyre, which are left out, radiate as much as the rail and more
ringing-wheel = the wheel rings as its modes and the rail let it: above 2 kHz such levels were 5 to 13 dB too loud where they were measured, and those of a rigid wheel 3 to 6 dB too quiet
modes-of-other-wheel = the modes are those of a wheel of { $of_modes } mm, the wheel of the case has { $of_case } mm: a smaller wheel rings higher
far-away = { $distance } m away ground and air take some of it, which are left out: levels beyond { $far } m are too high
smooth-wheels = the wheels are taken to be smooth: rougher ones than the rail raise every level and lower what grinding saves
noise-before-and-after = { $before } dB(A) before, { $after } dB(A) now: { $change } dB
noise-on-mean-of-rails = on the energy mean of the rails { $rails }, as wheels run on both; choose one by --rail for the noise of a train on rails like it
noise-beyond-linear-range = beyond the linear range: |P₁| is { $ratio } P₀, so that wheel and rail part, which bounds the force; the levels are those of a contact that holds
rail-cut-short = the rail carries more than a tenth of its vibration beyond 66 bays, where its length is cut: its level is too low at { $frequencies } Hz
bands-left-out = left out of every level, for want of roughness, decay or receptance there: { $frequencies } Hz

# Rolling noise: tables and sentences
rolling-noise = Rolling noise
noise-at-speed = { $title }, { $speed } km/h
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
rail-ground-to = rail ground to { $edition }
at-speed = { $speed } km/h
rail-dampers = rail dampers that double the decay rate
wheel-dampers = wheel dampers, modes of { $percent } % damping
softer-pads = pads of half the stiffness
stiffer-pads = pads of twice the stiffness
noise-becomes = under the traffic { $from } dB(A) become { $to } dB(A) in { $months } months
noise-becomes-to-linear-end = under the traffic { $from } dB(A) become { $to } dB(A) in { $months } months, where roughness leaves the linear range
noise-falls-below = { $sentence }; it is above { $limit } dB(A) now and falls below
noise-limit-now = { $sentence }; { $limit } dB(A) are reached now
noise-limit-in-months = { $sentence }; { $limit } dB(A) are reached in { $months } months
noise-limit-not-reached = { $sentence }; { $limit } dB(A) are not reached

## Measured growth

decaying-bands-stay = bands that decay keep today's level: nothing in the model makes the roughness that traffic makes on a rail
growth-unexplained = no wear coefficient: the model does not explain the growth at { $shortest }–{ $longest } mm, { $measured } dB measured and { $fitted } dB with the best coefficient; the forecast goes by what was measured
grew-in-a-year = { $wavelength } mm has grown by { $rate } dB a year
grew-in-a-year-within = { $wavelength } mm has grown by { $rate } dB a year, 95 % interval { $low } to { $high }
grew-in-a-million = { $wavelength } mm has grown by { $rate } dB per 10⁶ passages
grew-in-a-million-within = { $wavelength } mm has grown by { $rate } dB per 10⁶ passages, 95 % interval { $low } to { $high }

## Sections of a rail against limits

section-within = within the limits, nothing to grind
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
defects-left-out = { $sentence }; left out of the spectra (--keep-defects keeps them)
defects-out-of-levels = { $sentence }; left out of the levels (--keep-defects keeps them), but not of the moving RMS and what to grind
defects-judged = { $sentence }; they count in levels and limits, but are no corrugation

grows-within = { $wavelength } mm grows fastest, by { $low } to { $high } dB per million axles (80 %): the wear coefficient is uncertain; friction, pads and traction are taken as given
grows-within-a-month = { $wavelength } mm grows fastest, by { $low } to { $high } dB per million axles, { $low_a_month } to { $high_a_month } dB a month (80 %): the wear coefficient is uncertain; friction, pads and traction are taken as given
months-within = with the uncertainty of the wear coefficient that is { $early } to { $late } months from now (80 %)
rate-of-wheels-on-one-line = the rate is that of wheels of this kind alone, all on one line { $width } mm wide; `riffel forecast` tells that of a traffic
rate-of-wheels-over-a-band = the rate is that of wheels of this kind alone, spread over a band of { $width } mm; `riffel forecast` tells that of a traffic
rates-hold-to = the uncertainty of the wear coefficient puts rates and times within a factor of { $factor } either way (80 %); it has no part in what variants change
band-narrower-than-contact = wear.band_width is { $band } mm, but the contact is { $contact } mm wide: wear comes off the contact's own width
wheels-across-rail = the wheels of "{ $vehicle }" run { $innermost } to { $outermost } mm from the axis of the rail, the field side positive; { $percent } % of their passages cover the line at { $line } mm
no-equilibrium-at-speeds = "{ $vehicle }" finds no equilibrium in its curve at { $speeds } km/h: there its wheels stand as at the nearest speeds that have one
band-bends-over = the rate at { $wavelength } mm lasts for { $passages } axle passages: then it would need more than the mean wear of the rail, { $wear } mm per 100 MGT, and the level bends over
spread-takes-down = "{ $vehicle }": { $what } takes the fastest growth down { $factor } times
spread-of-speed = the spread of speed
spread-of-wheel-radius = the spread of wheel radii
spread-of-load = the spread of loads
spread-of-friction = the spread of friction
spread-of-position = the spread of contacts across the rail
spread-of-key = the spread of { $key }
creepages-left-out = the exact theory does not converge at a creepage of { $creepages } on a grid of { $grid } and is left out there; another contact.grid may do

## Damage beside wear

damage-beyond-friction = the utilised friction of the mean state is { $friction }: above 0.6 stress and shakedown limits of the laws of damage have not been compared with anything
damage-beyond-elastic = the contact pressure of { $pressure } MPa is { $ratio } times the shear yield: above 7.3 the whole patch is plastic, and neither the ellipse of Hertz nor limits of shakedown hold; check damage.shear_yield
moment-beside-its-limit = the mean load bends the rail by { $moment } kN m, { $share } of damage.bending.limit
flow-hardens = flow hardens: growth by it is that of the first passages; below a runaway number of one it comes to rest, and what goes on is ratchetting at the hardened yield
hardening-runs-away = flow that hardens does not stop the wave at { $wavelength } mm: its runaway number is { $runaway }, above one, so that it runs away
hardening-ends-wave = flow that hardens multiplies the wave at { $wavelength } mm by { $ratio } and comes to rest: its runaway number is { $runaway }, below one. A law that hardens to rest makes no corrugation by itself; what goes on is ratchetting at the hardened yield
cracks-are-worn-off = wear takes cracks off faster than they grow, at every phase of the waves forecast
cracks-grow = cracks are longest { $at } at { $wavelength } mm: { $length } mm after { $passages } axle passages, beside { $other } mm { $opposite }
cracks-grow-in-months = cracks are longest { $at } at { $wavelength } mm: { $length } mm after { $months } months, beside { $other } mm { $opposite }
on-crests = on the crests
in-troughs = in the troughs
on-rising-flanks = on the flanks that the wheel runs up
on-falling-flanks = on the flanks that the wheel runs down
below-the-limit-of-flow = the mean demand is { $demand }, below one: by the law of { $law } a wave does not grow until its own forces exceed the limit
fatigue-loses-nothing = damage.fatigue.loss is zero: fatigue is told, but takes no part in growth
shear-yield-assumed = the shear yield of the rail is taken as { $shear } MPa; damage.shear_yield or damage.grade say it
parts-along-the-wave = wheel and rail part along the wave: forces in proportion to the profile hold only below its amplitude there
shakedown-beyond-friction = above a utilised friction of 0.6 these limits have not been compared with anything
shakedown-of-mean = mean state: p₀/k = { $pressure } at k = { $shear } MPa, utilised friction { $friction }, demand { $demand }, surface fatigue index { $index }
utilised-friction = utilised friction
limit-elastic = elastic limit
limit-line = shakedown, line contact
limit-surface = at the surface
limit-subsurface = below it
phase-of-wave = phase °
pressure-over-yield = p₀/k
surface-fatigue-index = surface fatigue index
demand-of-flow = demand
demand-is-largest-at = the demand is largest, { $demand }, at { $phase }° after the crest, and above one along { $share } % of the wave
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
rates-follow-amplitude = rates of growth depend on the amplitude by laws of damage: those told are at corrugation.amplitude, { $amplitude } µm, levels are marched
fit-scales-all-damage = growth is by laws of damage beside wear: a wear coefficient fitted to measurements scales all of them
models-leave-damage-out = models of the field are told without the laws of [damage], which none of their authors has
action-none = left as it is
action-column = action
decision-on-doubtful-chains = the chains leave { $doubts } doubts, which riffel calibrate tells: the ranking may change with more draws
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
posterior-forecast-is-linear = levels are what linear growth says; where the wheel leaves the rail is not told over a posterior, riffel forecast without --posterior does
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
first-of-pair = value
second-of-pair = other value
told-as-a-product = the data tell { $one } and { $other } only together, as a product of powers (r = { $correlation }): neither may be written back into a case alone
told-as-a-ratio = the data tell { $one } and { $other } only together, as a ratio of powers (r = { $correlation }): neither may be written back into a case alone
calibration-allows-no-conclusion = the chains allow no conclusion, by { $doubts } doubts that are told with them: more draws may settle these
chains-disagree = the chains disagree on { $value }: R̂ is { $rhat }, but must be { $most } at most; take more draws, or { $other }
look-for-a-second-way = look for a second way to fit the data
populations-find-both-ways = where the data can be fitted in two ways sampler.kind = "smc" finds both
too-few-effective-draws = { $value } has { $draws } effective draws, but must have { $least }; take more draws
trajectories-ran-away = { $trajectories } trajectories ran away: the draws leave out a narrow part of the posterior; take a longer warm-up, or priors that keep away from it
tails-are-not-reached = the energy of the chains moves by { $moves } of its spread, but must by { $least }: the tails are not reached
calibration-tells-nothing = the data tell none of the { $count } values: each is as uncertain as before
calibration-tells-all = the data tell all { $count } values, most of all { $best }
calibration-tells-some = the data tell { $told } of { $count } values, most of all { $best }; they do not tell { $untold }
outlying-above = { $datum } ({ $data }) lies { $deviations } standard deviations above what all other data say of it; it stays among them: look how it was measured, or what the model lacks there
outlying-below = { $datum } ({ $data }) lies { $deviations } standard deviations below what all other data say of it; it stays among them: look how it was measured, or what the model lacks there
datum-receptance = |H| at { $at } Hz
datum-phase = the phase of H at { $at } Hz
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
