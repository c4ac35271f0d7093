# Was Riffel sagt. Terms: Schlupf (creepage), Bohrschlupf (spin), Kraftschlussausnutzung (tractive ratio), Zwischenlage (rail
# pad), Riffel (corrugation), Überrollung (passage of a wheel), Wachstumsgrat (growth ridge), Radsatz (wheelset).

verbatim = { $words }

## Windows, values and presets

map-window = Karte
traffic-window = Verkehr
unusual-value = { $key } ist { $value }; üblich sind { $from } bis { $to }{ $question }
number-without-unit = { $key } hat keine Einheit und wird als { $read } gelesen{ $question }
quoted = „{ $words }“
in-brackets = {" "}({ $words })
did-you-mean = gemeint: { $meant }?
did-you-mean-either = gemeint: { $one } oder { $other }?
preset-changes-nothing = { $key } = "{ $name }" ändert nichts: der Fall gibt alle Werte selbst vor

## Measured receptances

value-at-zero-left-out = der gemessene Wert bei 0 Hz bleibt weg
set-conjugate = track.measurement.conjugate setzen
conjugate-it = konjugieren
receptance-gives-energy = die gemessene Rezeptanz gibt Energie ab (Im H > 0), bei { $count } von { $points } Frequenzen zwischen { $first } und { $last } Hz: Phase und Rauschen prüfen, und ob sie exp(+iωt) folgt (sonst { $remedy })
column-without-unit = Spalte `{ $column }` nennt keine Einheit: als Rezeptanz in m/N gelesen (sonst track.measurement.quantity und unit setzen)
receptance-unlike-rail = die gemessene Rezeptanz liegt bei { $least } bis { $most } m/N, Schienen haben 1e-11 bis 1e-7 m/N: track.measurement.quantity und unit prüfen
poor-coherence = die Kohärenz liegt bei { $count } von { $points } Frequenzen zwischen { $first } und { $last } Hz unter { $good }: dort gilt das Mittel der Linien im Umkreis von 1/24 Oktave, gewichtet mit γ²/(1 − γ²)
response-at-other-node = gemessen ist die Antwort am Knoten { $response } auf eine Kraft am Knoten { $reference }: sie gilt als Rezeptanz am Kontakt

## Ranges of validity

rail-without-support = die Schiene liegt nirgends auf: unter etwa { $free_beam_from_hz } Hz ({ $window }: ab { $lowest } Hz) ändern Zwischenlagen, Schwellen und Schotter ihre Rezeptanz
rail-without-shear = die Schiene biegt sich ohne Schub: ihre Rezeptanz weicht bei { $euler_beam_up_to_hz } Hz um etwa 9° ab, bei 1500 Hz um 24° und 14 % ({ $window }: bis { $highest } Hz)
pinned-pinned-without-shear = die Schiene biegt sich ohne Schub: ihre Pinned-pinned-Frequenz ist um 20 bis 35 % oder mehr zu hoch und wird nicht genannt (rail.beam = "timoshenko" wählen)
supports-spread-evenly = die Stützpunkte sind gleichmäßig über die Schiene verteilt: die Pinned-pinned-Resonanz nahe { $pinned } Hz fehlt, und darunter weicht die Rezeptanz um 10 bis 50 % ab, auf sehr steifen Zwischenlagen um mehr ({ $window }: bis { $highest } Hz; ein Modell wählen, das auf -periodic endet)
no-average-over-patch = der Kontakt ist quasistatisch und mittelt nicht über seine Fläche: unter { $shortest } mm ist das Wachstum zu hoch
closed-form-of-ellipse = die Radien von Rad und Schiene sind sehr verschieden: die geschlossene Formel der Kontaktellipse weicht quer zur Schiene um { $percent } % ab (contact.hertz = "exact" wählen)
falling-friction-at-one-speed = die fallende Reibung ist die beim Schlupf bei { $rolling }, contact.polach.speed, bei jeder Geschwindigkeit ({ $window })
wheel-and-rail-part = bei einer Amplitude von { $amplitude } µm erreicht |P₁/P₀| { $worst }: Rad und Schiene trennen sich; Kräfte sind bis { $limit } µm linear (Wachstumsraten gelten für kleine Amplituden und ändern sich nicht)
wave-geometry-left-out = die Geometrie der Welle selbst ist nicht dabei (contact.wave_geometry): sie nähme etwa { $takes } je m von einem Wachstum von { $growth } je m, bei { $wavelength } mm und { $speed } km/h
    .short = ohne die Geometrie der Welle selbst, die etwa { $takes } je m von { $growth } nähme (contact.wave_geometry)
wave-shorter-than-patch = unter { $shortest } mm, drei halben Längen der Kontaktfläche, ist die Geometrie der Welle selbst nur grob geschätzt
troughs-bridged = unter { $bridged } mm überbrückt das Rad die Täler von Wellen von { $amplitude } µm (Wachstumsraten gelten für kleine Amplituden)
    .short = unter { $bridged } mm überbrückt das Rad Täler von { $amplitude } µm

## Branches of the ridge

at-edge-of-window = , am Rand des Fensters
nothing-grows = in diesem Fenster wächst nichts
both = { $one } und { $other }
one-after-other = { $one }; { $other }
before-comma = { $words },{" "}
branch = { $frequency } Hz ({ $mechanism }{ $speeds } km/h, { $wavelengths } mm{ $edge })
no-crest = in diesem Fenster liegt kein Kamm: das Wachstum steigt bis { $ends } mm
one-branch = der Grat ist ein einziger Ast, der bei { $words } wächst
branch-with-share = { $words } mit { $share } seines Wachstums
more-branches = { $count } weitere
weaker-branches = { $count ->
        [one] 1 schwächerer Ast
       *[other] { $count } schwächere Äste
    }
strongest-branch = der stärkste Ast wächst bei { $words }; { $noun }: { $named }

## Mechanisms

mechanism-p2 = P2-Resonanz
mechanism-wheelset-torsion = Torsion des Radsatzes
mechanism-wheelset-bending = Biegung des Radsatzes
mechanism-full-track = Resonanz des ganzen Gleises
mechanism-sleeper-antiresonance = Antiresonanz der Schwelle
mechanism-rail-on-pad = Schiene auf Zwischenlage
mechanism-pinned-pinned = Pinned-Pinned, vertikal
mechanism-measured-peak = Spitze der gemessenen Rezeptanz
mechanism-measured-dip = Senke der gemessenen Rezeptanz
mechanism-given-peak = Spitze der gegebenen Rezeptanz
mechanism-given-dip = Senke der gegebenen Rezeptanz

## Captions: the track

rail-word = Schiene
under-moving-load = {" "}unter wandernder Last
receptance-from-file = Rezeptanz aus { $file }
free-beam = freier { $beam }-Balken{ $moving }
rail-on-pads = { $beam }-Schiene{ $moving } auf Zwischenlagen ({ $pad })
sleepers-and-ballast = , Schwellen ({ $mass } kg) und Schotter ({ $ballast })
spacing = {" "}alle { $spacing } m,{" "}
discrete = diskret
spread-evenly = gleichmäßig verteilt
from-preset = , Vorgabe { $name }

## Captions: the case

track = Gleis
constant-tangential-force = konstante Tangentialkraft (I_w → 0)
constant-creepage = konstanter Schlupf (I_w → ∞)
wheelset = Radsatz
non-steady-contact = instationärer Kontakt
phase-lag = Phase der Dissipation: lag
phase-lead = Phase der Dissipation: lead
phase-none = Phase der Dissipation: none
creep-law = Kraftschlussgesetz
spring-and-dashpot = Feder und Dämpfer;{" "}
sign-of-growth = Riffeln wachsen, wo Re Ŵ₁ < 0 (farbig): die Dissipation ist in Gegenphase zum Profil; Zeitfaktor exp(+iωt), Bremsen positiv.

## Figures of the paper

figure-4 = Bild 4. Realteil der Dissipation, freier Euler-Balken
figure-5 = Bild 5. Realteil der Dissipation, Gleis von Bhaskar et al.
parameters-of = Werte von ({ $letter }): { $parameters } { $sign }
plus-spring-and-dashpot = , Feder und Dämpfer
plus-non-steady = , instationärer Kontakt
speed-axis = Geschwindigkeit V [m/s]
minima-over-wavelengths = Minima über Wellenlängen von 20–80 mm.
figure-6 = Bild 6. Höchstes Wachstum über der Geschwindigkeit
minima-inside-window = Minima über Wellenlängen von 20–80 mm; (b) lässt Minima am Rand des Fensters weg.
panel-of-tractive-ratio = (a) Kraftschlussausnutzung
panel-of-inertia = (b) Trägheit, τ = 0,1
wavelength-axis = Wellenlänge λ [mm]
figure-7 = Bild 7. Höchstes Wachstum über der Geschwindigkeit bei verschiedener Trägheit
figure-8 = Bild 8. Höchstes Wachstum bei { $speed } m/s
falls-in-part = (a) fällt nur bis τ ≈ 0,9.{" "}
tractive-ratio-axis = Kraftschlussausnutzung τ [-]
inertia-axis = Trägheit I_w [kg m²]
frequency-axis = Frequenz f [Hz]
beam-under-moving-load = Balken unter wandernder Last
track-of-bhaskar = Gleis von Bhaskar et al. (erschlossen)
figure-2 = Bild 2. Vertikale Eingangsrezeptanz
caption-of-figure-2 = Last mit { $speed } m/s, exp(+iωt), Weg und Kraft nach unten. Durchgezogen: { $solid }. Gestrichelt: { $dashed }.
modulus = Betrag
phase = Phase
figure-3 = Bild 3. Normalkraft
caption-of-figure-3 = V = { $speed } m/s, Gleichung (24). { $parameters }
amplitude = Amplitude
profile-over-rail = Δ/H Schiene
profile-over-wheel = Δ/H Rad

## A wheel in time

loss-factors-not-causal = Verlustfaktoren sind nicht kausal: in der Zeit ist das Gleis ein kausales nahebei, wo nötig mit Dämpfern in den Schichten, Rezeptanz im Mittel { $per_cent } % daneben
fitted-receptances-off = in der Zeit liegen die Rezeptanzen von Gleis und Rädern bis 3 kHz im Mittel { $per_cent } % daneben, höchstens { $most } %: Verlustfaktoren sind nicht kausal, und Wellen zwischen weit entfernten Rädern brauchen mehr Schwingungen, als angepasst werden
unstable-but-still = linear ist der Kreis instabil, doch nichts ist sichtbar gewachsen: was wächst, wächst langsamer, als diese Rechnung zeigt, oder die Strukturen in der Zeit sind stabil, wo die des Kreises es nicht sind
stable-but-limit-cycle = linear ist der Kreis stabil, doch der Anstoß reicht für einen Grenzzyklus neben der Ruhelage
support-passing-close-to-wave = auch die Überfahrt der Stützpunkte regt das Rad alle { $length } mm an, zu nahe an dieser Welle, um beide zu trennen: die Harmonischen enthalten beides
airborne-run-ends = nach { $passages } Überrollungen ist das Rad mehr als die halbe Zeit in der Luft, und dort endet die Rechnung: wo es aufschlägt, fließt der Stahl
wheels-slide-as-they-roll = die Räder gleiten so schnell, wie sie rollen: bei so viel Schlupf bleiben die Kraftschlusskräfte unter denen des mittleren Zustands, und sonst hält die Räder nichts; wheelset.suspension oder weniger Schlupf hilft
wheel-bridges-trough = ein Rad von diesem Halbmesser erreicht über { $largest } µm die Täler solcher Wellen nicht: es berührte an zwei Stellen, hier an einer
edge-of-patch-not-resolved = die Last bewegt den Rand der Kontaktfläche um { $moves } Elemente: Harmonische der Schlupfkraft liegen bis zu einigen zehn Prozent daneben; eine größere Amplitude oder mehr als { $across } Elemente (contact.grid) nehmen, bis es { $resolved } sind

## Profiles

flat-patch-beyond-range = die Schiene dreht sich über eine Kontaktfläche um { $degrees }°: die ebene trägt bis etwa 23°, halbe Breite durch Radius 0,2; darüber gilt die konforme daneben
rail-worn-on-field-side = { $name }: auf der Außenseite, an der es ausgerichtet ist, bleiben { $millimetres } mm: sie ist dort verschlissen, oder geneigt (--inclination), oder eine andere Schiene

## Files of profiles

flange-backs-apart = die Spurkranzrücken der Datei stehen { $distance } mm auseinander
tread-datum-elsewhere = ihr Messkreis liegt { $datum } mm vom Spurkranzrücken, doch das Rad steht nach seinem Spurkranzrücken auf der Achse, und der Ursprung liegt { $origin } mm davon
gauge-of-file = die Spurweite der Datei ist { $distance } mm, { $depth } mm unter der Schienenoberkante
smoothing-of-file-left-out = die Glättung der Datei (approx.smooth) ist nicht die von Riffel und bleibt weg: die Streuung ihrer Punkte angeben
points-missing = der Kopf kündigt { $announced } Punkte an (XYPoints), es folgen { $count }: vielleicht fehlt ein Stück der Datei
masked-points-left-out = { $masked } am Gerät ausgeblendete Punkte sind weggelassen
outlying-points-left-out = { $name }: { $count } Punkte weit neben ihren Nachbarn sind weggelassen, der erste in Zeile { $line }
scatter-of-curvature = { $name }: Streuung lässt ±{ $error } 1/m der Krümmung bei x = 0
points-scatter = { $name }: die Punkte streuen um { $micrometres } µm, so dass die Krümmung einer Kurve durch sie um etwa { $curvature } 1/m daneben liegt; diese Streuung angeben (profiles.scatter, --scatter), um zu glätten

## Curves

wheelset-beyond-flange = ein Radsatz ist um { $shift } mm verschoben: Spurkränze lassen 5 bis 10 mm Spiel, dieser Fall hat keine
linear-creep-beyond-friction = creep_law = "linear" kennt keine Reibung: Schlupfkräfte erreichen { $most } von μP
yaw-takes-play = mit seinem Gierwinkel von { $yaw } mrad hat Radsatz { $number } { $yawed } mm bis zum Spurkranz, nicht die { $straight } mm der Tabellen: Kontakte liegen, wo sie ohne Gieren liegen

## The mean state from a curve

creep-law-without-spin = contact.creep_law = "{ $name }" kennt keinen Bohrschlupf: die { $spin } 1/m des Bogens bleiben weg ({ $key })
case-has-own-values = statt dessen, was der Bogen sagt, hat der Fall eigene Werte: { $instead }
no-rigid-contact-at-angle = kein starrer Kontakt hat den Winkel des Gleichgewichts, { $degrees }°
patches-join = die Kontaktfläche geht in die des nächsten Berührpunkts über
two-points-join-under-load = das Rad steht auf zwei Punkten, die unter Last zu einer Kontaktfläche würden

## Ranges of validity, further

ellipse-too-wide = die Kontaktellipse ist { $width } mm breit: darüber hat kein Profil eine einzige Krümmung, und die Theorie von Hertz endet
loop-not-judged = ob der Kreis bei { $speed } km/h stabil ist, ist nicht zu erkennen: seine Phase springt, wie an einer Resonanz ohne Dämpfung oder außerhalb gemessener Frequenzen; Radsatz, Schiene und Zwischenlagen einen Verlustfaktor geben
loop-unstable = der Kreis ist bei { $speed } km/h instabil: um { $frequency } Hz schwingt er ohne jedes Profil (Quietschen, Haften und Gleiten){ $growth }, und Wachstumsraten bedeuten dort nichts
loop-unstable-growth = , wächst e-fach in { $time }
stability-title = Schwingung ohne jedes Profil
stability-caption = Durchgezogen: die Grenze; auf der Seite des Zeichens wächst eine Schwingung der genannten Frequenz von selbst (auf einen halben Schritt des Rasters genau). Gepunktet und gestrichelt: wie schnell, so viele Male in der Sekunde e-fach. Zeichen: wo sie am schnellsten wächst. Wo mehrere wachsen, steht die höchste Frequenz da.
stability-of-one-axis = ein Rad, das sich nur senkt und dreht, schwingt nicht von selbst; ihm Schlupf oder Bewegung quer zur Schiene geben, wie contact.from oder [wheelset]
stability-unknown = { $points } Punkte sind nicht zu erkennen: die Phase des Kreises springt dort, wie an einer Resonanz ohne Dämpfung; Radsatz, Schiene und Zwischenlagen einen Verlustfaktor geben
no-mean-state = bei einer Reibung von { $friction } finden die Räder keinen mittleren Zustand; diese Punkte bleiben weg
stable-everywhere = der Kreis ist von { $slowest } bis { $fastest } km/h bis zu einer Reibung von { $highest } stabil
unstable-from = ab einer Reibung von { $least } wächst irgendwo von { $slowest } bis { $fastest } km/h eine Schwingung von selbst
unstable-from-the-least = schon bei der kleinsten betrachteten Reibung, { $least }, wächst irgendwo von { $slowest } bis { $fastest } km/h eine Schwingung von selbst
branch-from = von Hz
branch-to = bis Hz
least-friction = kleinste Reibung
fastest-growth-in-time = schnellstes Wachstum 1/s
at-speed-column = bei km/h
at-friction-column = bei Reibung
wheel-flatter-than-radius = bei { $angle }° ist das Rad längs der Schiene { $flatter } mal so flach wie sein Rollradius, den die Ellipse nimmt: contact.longitudinal_radius angeben
track-moves-downward-only = dieses Gleis bewegt sich nur nach unten; längs und quer zur Schiene gilt es als starr

## Measured wheelsets

column-of-wheelset-without-unit = Spalte `{ $column }` nennt keine Einheit: als Rezeptanz in m/N gelesen (sonst dazuschreiben, wie in `{ $column } [m/s2/N]`)
wheelset-not-reciprocal = der gemessene Radsatz ist nicht reziprok: { $at } bei Kraft an { $from } und umgekehrt unterscheiden sich um bis zu { $percent } %, bei { $hertz } Hz; es gilt ihr Mittel: Aufnehmer, Hammer und Vorzeichen der Achsen prüfen
wheelset-gives-energy = der gemessene Radsatz gibt Energie ab, bis zu { $percent } % seiner größten Rezeptanz, bei { $hertz } Hz, am meisten an { $port }: Phasen, Rauschen und fehlende Einträge prüfen, und ob er exp(+iωt) folgt
wheelset-not-measured-along = der Radsatz ist nicht gemessen in Richtung { $axes }: dort gilt er als starr

## Cases

creep-law-unlike-equilibrium = contact.creep_law = "{ $law }" macht |Q| = { $here } μP aus Schlüpfen, bei denen das Gleichgewicht im Bogen { $in_curve } hat
creep-law-of-growth-only = contact.creep_law = "{ $law }" ist das des Wachstums: im Bogen rollt das Rad nach Shen, Hedrick und Elkins
modes-of-wheelset-end = die Eigenformen beschreiben den Radsatz bis etwa { $up_to } Hz, und das Fenster reicht bis { $highest } Hz: Eigenformen oder Zeilen `residual` ergänzen

## Curves, patches and files, with their parts

second-point-left-out = { $rail } steht das Rad auf zwei Punkten; der andere, mit { $percent } % seiner Normalkräfte, fehlt im Kreis
on-left = auf der linken Schiene
on-right = auf der rechten Schiene
of-left = der linken Schiene
of-right = der rechten Schiene
on-low-left = auf der inneren, linken Schiene
on-low-right = auf der inneren, rechten Schiene
on-high-left = auf der äußeren, linken Schiene
on-high-right = auf der äußeren, rechten Schiene
mean-state-from-curve = mittlerer Zustand aus dem Bogen von { $radius } m bei { $speed } km/h: Radsatz { $wheelset } { $rail } schlüpft { $along } % längs, { $across } % quer, Bohrschlupf { $spin } 1/m, unter { $load } kN bei { $angle }°
ellipse-in-place-of-patch = { $rail } nimmt der Kreis die Ellipse von Hertz und keine Kontaktfläche der Profile unter Last: { $reason }
patch-under-load-against-hertz = ; die Profile unter Last auf der gekrümmten Schiene sind um { $stiffer } % steifer, { $longer } % so lang und { $wider } % so breit (contact.from.patch = "conformal" nimmt sie)
contact-is-conformal = die Halbachse quer ist { $semi_axis } mm, { $share } des Radius { $rail } dort, und die Theorie von Hertz gilt bis 0,2 bis 0,3: darüber ist der Kontakt konform{ $under_load }
patch-of-profiles = { $rail } gilt die Kontaktfläche der Profile unter Last: { $stiffness } MN/m ({ $stiffer } % gegen Hertz), wie eine Ellipse mit den Halbachsen { $along } mm längs ({ $longer } %) und { $across } mm quer ({ $wider } %), bei { $angle }° ({ $turned }°)
patch-of-profiles-alone = { $rail } gilt die Kontaktfläche der Profile unter Last: { $stiffness } MN/m, wie eine Ellipse mit den Halbachsen { $along } mm längs und { $across } mm quer, bei { $angle }° ({ $turned }°); Hertz hat dort keine
several-equilibria = das Fahrzeug hat { $count } Gleichgewichte in diesem Bogen; der Kontakt ist { $which }
equilibrium-from-straight-track = der, zu dem gerades Gleis führt
equilibrium-found-first = aus dem zuerst gefundenen, zu dem gerades Gleis nicht führt
about = { $subject }: { $remark }
coordinates-right = stehen richtig
coordinates-mirrored = sind gespiegelt
coordinates-upside-down = stehen auf dem Kopf
coordinates-turned = sind gespiegelt und stehen auf dem Kopf
read-as-wheel = gelesen als Rad: die Koordinaten { $changes }
read-as-rail = gelesen als Schiene: die Koordinaten { $changes }; x unter null gilt als Fahrkantenseite, sonst als Lage "mirrored" angeben
read-as-leaning-rail = gelesen als Schiene: die Koordinaten { $changes }; ihr Kopf neigt sich um { $off } mm zu x unter null, was bei einer geneigten Schiene die Fahrkantenseite ist
rail-leans-outward = ihr Kopf neigt sich um { $off } mm zu x über null, wie der einer geneigten Schiene zur Fahrkantenseite; ist das die Fahrkantenseite, die Lage "mirrored" angeben
offset-added = XOffset und YOffset der Datei sind addiert, { $x } mm und { $y } mm
offset-is-in = XOffset der Datei, { $x } mm, bleibt weg: der Spurkranzrücken zeigt, dass die Koordinaten ihn schon haben
flange-back-elsewhere = der Spurkranzrücken liegt bei x = { $back } mm, wird aber bei { $usual } mm angenommen: das Rad steht { $off } mm versetzt auf der Achse; den Ursprung auf den Messkreis legen oder profiles.flange_back_position angeben
origin-moved = der Ursprung ist auf { $place } verschoben, um x = { $x } mm und y = { $y } mm
to-crown = Schienenoberkante
to-datum-circle = Messkreis
rail-taken-as-rigid = die Schiene gilt { $direction } als starr: { $keys } lässt sie sich bewegen
across-track = quer zum Gleis
along-itself = in ihrer Richtung
t-gamma-below-zero = Tγ von Rad { $wheelset } { $rail } ist { $wear } N: es ist Qx ξx + Qy ξy ohne das Bohrmoment, und die Querkraft kommt dort vom Bohren, nicht vom Schlupf
ellipse-of-wheel-too-wide = die Ellipse von Rad { $wheelset } { $rail } ist { $width } mm breit: darüber hat kein Profil eine einzige Krümmung, die Theorie von Hertz endet, und Schlupfgesetze weichen am meisten voneinander ab
left = links
right = rechts

## Traffic

growth-faster-than-any-seen = die Amplitude bei { $wavelength } mm verdoppelt sich in { $days } Tagen, schneller als jedes Wachstum, das hier von einer Bahn bekannt ist: { $known } Tage in einem Metrobogen von 120 m Radius (Torstensson & Nielsen 2009); tractive_ratio, traction_share (der Anteil der Achsen darunter) und wear.coefficient prüfen

## Wem die schnellste Wellenlänge folgt

cause-near = { $wavelength } mm wächst am stärksten bei { $speed } km/h, wo { $frequency } Hz { $distance } % neben { $resonance } Hz liegt ({ $mechanism })
cause-alone = { $wavelength } mm wächst am stärksten bei { $speed } km/h, bei { $frequency } Hz; keine Resonanz von Gleis oder Radsatz liegt näher als { $within } %
cause-loop = keine Resonanz: der Kreis von Kraft, Schlupf und Verschleiß
frequency-is-kept = von { $slow } bis { $fast } km/h geht die schnellste Wellenlänge von { $first } bis { $last } mm und ihre Frequenz von { $low } bis { $high } Hz: fest ist eine Frequenz, keine Länge
frequency-is-not-kept = von { $slow } bis { $fast } km/h geht die Frequenz der schnellsten Wellenlänge von { $low } bis { $high } Hz: keine eine Frequenz ist fest
others-in-reach = Züge dieses Verkehrs rollen mit { $low } bis { $high } Hz über { $wavelength } mm, und dort liegt auch { $others }
others-out-of-reach = keine andere Resonanz liegt bei { $low } bis { $high } Hz, mit denen Züge dieses Verkehrs über { $wavelength } mm rollen
mechanism-at = { $mechanism } ({ $frequency } Hz)
nothing-against = nichts, was der Fall weiß, spricht dagegen

## Maßnahmen

softer-ballast = halbe Steifigkeit unter den Schwellen
more-rail-loss = Schienendämpfer, die den Verlustfaktor der Schiene um { $loss } erhöhen
friction-treatment = Reibung behandelt bis auf { $friction }
lighter-wheel = ein Fünftel weniger unabgefederte Masse
wider-speeds = weiter gestreute Geschwindigkeiten
slower-trains = um ein Fünftel langsamere Züge
more-grinding = kürzerer Abstand des Schleifens
remedy-column = Maßnahme
remedy-changes-column = ändert
growth-change-column = Wachstum %
doubles-in-column = verdoppelt sich in
ground-after-column = geschliffen nach
nothing-grows-then = nichts wächst
helps-most = am meisten hilft: { $title }; das Wachstum fällt um { $percent } % und verdoppelt in { $time }
helps-most-of-all = am meisten hilft: { $title }; dann wächst nichts
helps-nothing = keine dieser Maßnahmen bremst das Wachstum
left-out-for = ausgelassen: { $title }; { $reason }
remedy-lacks-key = der Fall hat keinen Wert von { $key }
remedy-has-no-effect = { $key } ändert in diesem Fall nichts
remedy-is-refused = damit lässt sich dieser Fall nicht berechnen
friction-is-low = die Reibung ist schon { $friction }
grinding-leaves-growth = Schleifen senkt den Pegel und lässt das Wachstum, wie es ist: 6 dB in { $time }
ground-as-it-is = so wie es ist, steigt das erste Band in { $time } um 6 dB über das, was Schleifen hinterlässt: so lang ist der Abstand des Schleifens bei einem Grenzwert in dieser Höhe
steps-are-chosen = wie weit jede Maßnahme geht, ist gewählt; was ein Produkt bewirkt, steht in seinem Datenblatt
speeds-are-wide = die Geschwindigkeiten streuen schon etwa so weit, wie es eine Normalverteilung kann
treatment-keeps-force = auf behandelter Reibung ziehen und bremsen Züge mit derselben Kraft und mehr Schlupf; wo ein Bogen den Schlupf bestimmt, contact.creepage anstelle von contact.tractive_ratio angeben

## Das Feld

field-wavelength = Wellenlänge
field-frequency = Frequenz
field-growth = Wachstum
field-shorter-wave = kürzere der beiden stärksten Wellen
field-longer-wave = längere der beiden stärksten Wellen
field-high-over-low = Außenschiene zu Innenschiene
field-outer-over-inner = äußere zu innerer Schiene
field-with-modifier = Wachstum mit Reibmittel zu dem ohne
decibels-per-million-axles = dB je Million Achsen
field-is-kept = vorhergesagt von riffel { $version } mit { $samples } Stichproben je Ort, einmal, und vom Projekt aufbewahrt: { $inside } von { $outcomes } gemessenen Werten liegen darin, die logarithmische Bewertung ist { $score }

## Wachstum unter dem Verkehr einer Strecke

traffic-of-main-line = dem üblichen Verkehr einer Hauptstrecke
traffic-of-freight-line = dem üblichen Verkehr einer Güterstrecke
traffic-of-heavy-haul = dem üblichen Verkehr einer Schwerlaststrecke
traffic-of-metro = dem üblichen Verkehr einer U-Bahn
traffic-of-tram = dem üblichen Verkehr einer Straßenbahn
traffic-of-curve = dem üblichen Verkehr dieses Bogens
traffic-given = dem angegebenen Verkehr
traffic-at-speeds = { $traffic } ({ $slowest }–{ $fastest } km/h)
traffic-at-speeds-a-day = { $traffic } ({ $slowest }–{ $fastest } km/h, { $axles } Achsen am Tag)
compared-under = unter { $traffic }
shorter-waves = kürzere
longer-waves = längere
one-wavelength = { $wavelength } mm
wavelengths-between = { $shortest }–{ $longest } mm
grows-fastest-under = am schnellsten wächst { $range } unter { $traffic }; { $wavelength } mm führt und verdoppelt sich in { $time }
grows-fastest-under-within = am schnellsten wächst { $range } unter { $traffic }; { $wavelength } mm führt und verdoppelt sich in { $time } (80 %: der Verschleißbeiwert ist unsicher)
fastest-at-edge = { $wavelength } mm liegt am Rand und ist kein Maximum: { $beyond } Wellen können schneller wachsen
nothing-grows-under = nichts von { $shortest } bis { $longest } mm wächst unter { $traffic }
days-of = { $days } Tagen
days-between = { $early } bis { $late } Tagen
months-of = { $months } Monaten
months-between = { $early } bis { $late } Monaten
years-of = { $years } Jahren
years-between = { $early } bis { $late } Jahren
longer-than-years = über { $years } Jahren
million-axles = { $axles } Millionen Achsen
million-axles-between = { $early } bis { $late } Millionen Achsen

## Noise

rigid-wheel = das Rad ist hier ein starrer Körper: über etwa 1,6 kHz strahlen die Moden von Steg und Kranz, die fehlen, so viel ab wie die Schiene und mehr
ringing-wheel = das Rad klingt, wie seine Moden und die Schiene es zulassen: über 2 kHz waren solche Pegel dort, wo gemessen wurde, um 5 bis 13 dB zu laut, die eines starren Rades um 3 bis 6 dB zu leise
modes-of-other-wheel = die Moden sind die eines Rades von { $of_modes } mm, das Rad des Falls hat { $of_case } mm: ein kleineres Rad klingt höher
far-away = in { $distance } m nehmen Boden und Luft, die hier fehlen, etwas davon weg: Pegel jenseits von { $far } m sind zu hoch
smooth-wheels = die Räder gelten als glatt: sind sie rauer als die Schiene, steigen alle Pegel, und Schleifen spart weniger
noise-before-and-after = vorher { $before } dB(A), jetzt { $after } dB(A): { $change } dB
noise-on-mean-of-rails = auf dem energetischen Mittel der Schienen { $rails }, da Räder auf beiden laufen; eine davon allein gewählt gibt den Lärm eines Zugs auf Schienen wie dieser
noise-beyond-linear-range = außerhalb des linearen Bereichs: |P₁| ist { $ratio } P₀, Rad und Schiene trennen sich also, was die Kraft begrenzt; die Pegel sind die eines Kontakts, der hält
rail-cut-short = die Schiene trägt mehr als ein Zehntel ihrer Schwingung weiter als 66 Schwellenfächer, wo ihre Länge endet: ihr Pegel ist zu niedrig bei { $frequencies } Hz
bands-left-out = fehlt in jedem Pegel, mangels Rauheit, Abklingrate oder Rezeptanz dort: { $frequencies } Hz

# Rollgeräusch: Tabellen und Sätze
rolling-noise = Rollgeräusch
noise-at-speed = { $title }, { $speed } km/h
noise-heard-at = Pegel über die Vorbeifahrt, { $distance } m von der Gleismitte, { $height } m über der Schiene
noise-of-rail = Schiene
noise-of-sleepers = Schwellen
noise-of-wheel = Rad
noise-of-all = Summe
by-transfer-functions = mit Übertragungsfunktionen
frequency-in-hertz = Frequenz Hz
in-decibels = { $what } dB
decibels-a-weighted = dB(A)
sound-exposure = Schallexposition, { $wheels } Räder auf jeder Schiene
what-radiates = was abstrahlt
sound-power-of-a-wheel = Schallleistung eines Rades dB(A)
each-alone = jedes allein
saves-decibels = spart dB
rail-ground-to = Schiene geschliffen auf { $edition }
at-speed = { $speed } km/h
rail-dampers = Schienendämpfer, die die Abklingrate verdoppeln
wheel-dampers = Raddämpfer, Moden mit { $percent } % Dämpfung
softer-pads = Zwischenlagen halber Steifigkeit
stiffer-pads = Zwischenlagen doppelter Steifigkeit
noise-becomes = unter dem Verkehr werden aus { $from } dB(A) in { $months } Monaten { $to } dB(A)
noise-becomes-to-linear-end = unter dem Verkehr werden aus { $from } dB(A) in { $months } Monaten { $to } dB(A), wo die Rauheit den linearen Bereich verlässt
noise-falls-below = { $sentence }; jetzt liegt er über { $limit } dB(A) und fällt darunter
noise-limit-now = { $sentence }; { $limit } dB(A) sind jetzt erreicht
noise-limit-in-months = { $sentence }; { $limit } dB(A) sind in { $months } Monaten erreicht
noise-limit-not-reached = { $sentence }; { $limit } dB(A) werden nicht erreicht

## Gemessenes Wachstum

decaying-bands-stay = Bänder, die abklingen, behalten den Pegel von heute: nichts im Modell macht die Rauheit, die der Verkehr auf einer Schiene macht
growth-unexplained = kein Verschleißbeiwert: das Modell erklärt das Wachstum bei { $shortest }–{ $longest } mm nicht, { $measured } dB gemessen und { $fitted } dB mit dem besten Beiwert; die Prognose geht nach dem, was gemessen wurde
grew-in-a-year = { $wavelength } mm ist um { $rate } dB im Jahr gewachsen
grew-in-a-year-within = { $wavelength } mm ist um { $rate } dB im Jahr gewachsen, 95-%-Intervall { $low } bis { $high }
grew-in-a-million = { $wavelength } mm ist um { $rate } dB je 10⁶ Überrollungen gewachsen
grew-in-a-million-within = { $wavelength } mm ist um { $rate } dB je 10⁶ Überrollungen gewachsen, 95-%-Intervall { $low } bis { $high }

## Abschnitte einer Schiene gegen Grenzwerte

section-within = innerhalb der Grenzwerte, nichts zu schleifen
section-within-levels = innerhalb des Grenzwerts der Pegel; kein Grenzwert sagt, was zu schleifen ist
section-over-levels = { $excess } dB über dem Grenzwert der Pegel bei { $wavelength } mm
section-over-rms = auf { $share } % der Länge über dem Grenzwert des Effektivwerts bei { $band } mm, bis zum { $ratio }-Fachen, wo { $allowed } % erlaubt sind
section-nothing-to-grind = nichts zu schleifen: was zu schleifen ist, folgt aus dem gleitenden Effektivwert, und der liegt hier nirgends über seinem Grenzwert
section-to-grind = { $length } m zu schleifen
section-short-places = innerhalb der Grenzwerte, aber { $length } m zu schleifen: geschliffen wird jede Stelle, an der der gleitende Effektivwert über seinem Grenzwert liegt, hier { $share } % des Abschnitts bei { $band } mm und bis zum { $ratio }-Fachen; der Grenzwert erlaubt { $allowed } %, und Pegel sind ein Mittel über den Abschnitt
section-ground-along = { $length } m mit dem geschliffen, was daneben liegt: hier ist nichts über einem Grenzwert des Effektivwerts, aber was nahe beieinander liegt, wird in einem geschliffen, und nicht weniger als die kürzeste Länge

## Schweißungen, Stöße und Squats

defect-at = { $place } m ({ $height } µm)
one-defect = Schiene { $rail } hat eine Schweißung, einen Stoß oder Squat: { $places }
some-defects = Schiene { $rail } hat { $count } Schweißungen, Stöße oder Squats: { $places }
many-defects = Schiene { $rail } hat { $count } Schweißungen, Stöße oder Squats: { $places } und { $more } weitere
defects-left-out = { $sentence }; aus den Spektren weggelassen (--keep-defects behält sie)
defects-out-of-levels = { $sentence }; aus den Pegeln weggelassen (--keep-defects behält sie), nicht aber aus gleitendem Effektivwert und Schleifplan
defects-judged = { $sentence }; sie zählen in Pegeln und Grenzwerten, sind aber keine Riffeln

grows-within = { $wavelength } mm wächst am schnellsten, um { $low } bis { $high } dB je Million Achsen (80 %): der Verschleißbeiwert ist unsicher; Reibung, Zwischenlagen und Zugkraft gelten wie angegeben
grows-within-a-month = { $wavelength } mm wächst am schnellsten, um { $low } bis { $high } dB je Million Achsen, { $low_a_month } bis { $high_a_month } dB im Monat (80 %): der Verschleißbeiwert ist unsicher; Reibung, Zwischenlagen und Zugkraft gelten wie angegeben
months-within = mit der Unsicherheit des Verschleißbeiwerts sind das { $early } bis { $late } Monate von jetzt (80 %)
rate-of-wheels-on-one-line = die Rate ist die von Rädern dieser Art allein, alle auf einer { $width } mm breiten Spur; die eines Verkehrs sagt `riffel forecast`
rate-of-wheels-over-a-band = die Rate ist die von Rädern dieser Art allein, verteilt über ein Band von { $width } mm; die eines Verkehrs sagt `riffel forecast`
rates-hold-to = die Unsicherheit des Verschleißbeiwerts legt Raten und Zeiten auf einen Faktor { $factor } nach oben und unten fest (80 %); sie hat keinen Teil an dem, was Varianten ändern
band-narrower-than-contact = wear.band_width ist { $band } mm, aber der Kontakt ist { $contact } mm breit: der Verschleiß kommt von der Breite des Kontakts
wheels-across-rail = die Räder von „{ $vehicle }“ laufen { $innermost } bis { $outermost } mm von der Achse der Schiene, nach außen positiv; { $percent } % ihrer Überrollungen treffen die Linie bei { $line } mm
no-equilibrium-at-speeds = „{ $vehicle }“ findet in seinem Bogen bei { $speeds } km/h kein Gleichgewicht: dort stehen seine Räder wie bei den nächsten Geschwindigkeiten, die eines haben
band-bends-over = die Rate bei { $wavelength } mm hält { $passages } Achsüberfahrten lang: dann bräuchte sie mehr als den mittleren Verschleiß der Schiene, { $wear } mm je 100 Mio. t, und der Pegel biegt ab
spread-takes-down = „{ $vehicle }“: { $what } senkt das schnellste Wachstum auf 1/{ $factor }
spread-of-speed = die Streuung der Geschwindigkeit
spread-of-wheel-radius = die Streuung der Radhalbmesser
spread-of-load = die Streuung der Lasten
spread-of-friction = die Streuung der Reibung
spread-of-position = die Streuung der Kontakte quer zur Schiene
spread-of-key = die Streuung von { $key }
creepages-left-out = die exakte Theorie konvergiert beim Schlupf { $creepages } auf einem Gitter von { $grid } nicht und bleibt dort aus; ein anderes contact.grid kann helfen

## Schäden neben dem Verschleiß

damage-beyond-friction = der ausgenutzte Kraftschluss des mittleren Zustands ist { $friction }: über 0,6 sind Spannungen und Shakedown-Grenzen der Schadensgesetze mit nichts verglichen
damage-beyond-elastic = der Kontaktdruck von { $pressure } MPa ist das { $ratio }-Fache der Schubfließgrenze: über 7,3 ist der ganze Kontakt plastisch, und weder die Ellipse von Hertz noch Grenzen des Shakedowns gelten; damage.shear_yield prüfen
moment-beside-its-limit = die mittlere Last biegt die Schiene mit { $moment } kN m, dem { $share }-fachen von damage.bending.limit
flow-hardens = das Fließen verfestigt: sein Wachstum ist das der ersten Überfahrten; unter einer Durchgehzahl von eins kommt es zur Ruhe, und was weitergeht, ist Ratchetting bei der verfestigten Fließgrenze
hardening-runs-away = Fließen mit Verfestigung hält die Welle bei { $wavelength } mm nicht auf: ihre Durchgehzahl ist { $runaway }, über eins, sodass sie durchgeht
hardening-ends-wave = Fließen mit Verfestigung vervielfacht die Welle bei { $wavelength } mm auf das { $ratio }-Fache und kommt zur Ruhe: ihre Durchgehzahl ist { $runaway }, unter eins. Ein Gesetz, das sich bis zur Ruhe verfestigt, macht allein keine Riffeln; was weitergeht, ist Ratchetting bei der verfestigten Fließgrenze
cracks-are-worn-off = der Verschleiß nimmt Risse in jeder Phase der vorhergesagten Wellen schneller weg, als sie wachsen
cracks-grow = Risse werden { $at } bei { $wavelength } mm am längsten: { $length } mm nach { $passages } Achsüberrollungen, daneben { $other } mm { $opposite }
cracks-grow-in-months = Risse werden { $at } bei { $wavelength } mm am längsten: { $length } mm nach { $months } Monaten, daneben { $other } mm { $opposite }
on-crests = auf den Bergen
in-troughs = in den Tälern
on-rising-flanks = auf den Flanken, die das Rad hinaufläuft
on-falling-flanks = auf den Flanken, die das Rad hinabläuft
below-the-limit-of-flow = die mittlere Beanspruchung ist { $demand }, unter eins: nach dem Gesetz { $law } wächst eine Welle erst, wenn ihre eigenen Kräfte die Grenze überschreiten
fatigue-loses-nothing = damage.fatigue.loss ist null: Ermüdung wird genannt, hat aber keinen Anteil am Wachstum
shear-yield-assumed = die Schubfließgrenze der Schiene ist mit { $shear } MPa angenommen; damage.shear_yield oder damage.grade sagen sie
parts-along-the-wave = Rad und Schiene trennen sich entlang der Welle: Kräfte im Verhältnis zum Profil gelten nur unterhalb der Amplitude dafür
shakedown-beyond-friction = über einem ausgenutzten Kraftschluss von 0,6 sind diese Grenzen mit nichts verglichen
shakedown-of-mean = mittlerer Zustand: p₀/k = { $pressure } bei k = { $shear } MPa, ausgenutzter Kraftschluss { $friction }, Beanspruchung { $demand }, Oberflächenermüdungsindex { $index }
utilised-friction = ausgenutzter Kraftschluss
limit-elastic = elastische Grenze
limit-line = Shakedown, Linienkontakt
limit-surface = an der Oberfläche
limit-subsurface = darunter
phase-of-wave = Phase °
pressure-over-yield = p₀/k
surface-fatigue-index = Oberflächenermüdungsindex
demand-of-flow = Beanspruchung
demand-is-largest-at = die Beanspruchung ist am größten, { $demand }, { $phase }° nach dem Wellenberg, und auf { $share } % der Welle über eins
stress-beyond-ratio = a/b liegt außerhalb von 0,3 bis 3, worin die Spannung unter dem Kontakt mit anderen Zahlen verglichen ist
stress-beyond-friction = über einem Reibbeiwert von 0,6 ist die Spannung unter dem Kontakt mit nichts verglichen
stress-under-contact = Spannung unter dem Kontakt: p₀ = { $pressure } MPa, a/b = { $ratio }, Reibung { $friction }, Kraftschlussausnutzung { $tractive }; Spannungen durch p₀, Tresca ist die größte Schubspannung
in-full-slip = volles Gleiten
in-partial-slip = teilweises Gleiten
by-half-space = Halbraum
traction-of-contact = Tangentialspannung
measure-of-stress = Maß
depth-of-stress = Ort
stress-over-pressure = Spannung/p₀
rates-follow-amplitude = Wachstumsraten hängen nach Schadensgesetzen von der Amplitude ab: die genannten gelten bei corrugation.amplitude, { $amplitude } µm, Pegel werden schrittweise gerechnet
fit-scales-all-damage = Wachstum geschieht nach Schadensgesetzen neben dem Verschleiß: ein an Messungen angepasster Verschleißbeiwert verändert sie alle
models-leave-damage-out = Modelle der Literatur stehen ohne die Gesetze von [damage], die keiner ihrer Autoren hat
action-none = bleibt, wie es ist
action-column = Maßnahme
decision-on-doubtful-chains = die Ketten lassen { $doubts } Zweifel, die riffel calibrate nennt: mit mehr Ziehungen kann sich die Reihenfolge ändern
rise-after-grinding-assumed = cost.from_limit fehlt: es wird angenommen, dass Schleifen jedes Band 6 dB unter dem Grenzwert hinterlässt
decision-is-over = { $draws } Ziehungen der Posteriorverteilung; der Grenzwert ist erreicht, wenn das erste Band nach dem Schleifen um { $rise } dB gestiegen ist; Intervalle bis { $horizon } Monate; Kosten im Mittel der Ziehungen, Ersparnis gegenüber dem Zustand, wie er ist
months-to-limit-median = Monate bis zum Grenzwert
five-per-cent = 5 %
ninety-five-per-cent = 95 %
never-percent = nie, %
mean-cost-per-year = Kosten im Jahr, { $currency }
saving-from = Ersparnis, 5 %
saving-to = Ersparnis, 95 %
longer-percent = hält länger, %
cheapest-percent = am billigsten, %
regret-per-year = erwarteter Verlust, { $currency }
value-known = wäre bekannt
measurement-first = würde zuerst gemessen
worth-per-year = Wert im Jahr, { $currency }
price-in = Preis, { $currency }
net-worth-in = Wert nach Abzug des Preises, { $currency }
cheapest-in-the-mean = im Mittel am billigsten: { $action } mit { $cost } { $currency } im Jahr; das ist in { $share } % der Ziehungen die billigste Maßnahme
worth-of-knowing-all = jeden Wert zu kennen wäre { $worth } { $currency } im Jahr wert
measure-first = zuerst messen: { $measurement }
no-measurement-pays = keine Messung ist ihren Preis wert: keine ändert die Maßnahme oft genug
over-budget-percent = über dem Etat, %
too-loud-percent = zu laut, %
without-possession-percent = über den Stunden der Sperrpausen, %
rank-of-action = Rang
actions-break = { $count } der Maßnahmen verletzen den Etat, die Lärmgrenze oder die Stunden der Sperrpausen in mehr als 5 % der Ziehungen; sie stehen hinter denen, die sie einhalten
all-actions-break = jede Maßnahme verletzt den Etat, die Lärmgrenze oder die Stunden der Sperrpausen in mehr als 5 % der Ziehungen; die Reihenfolge folgt allein den Kosten
posterior-forecast-is-linear = die Pegel sind die des linearen Wachstums; wo das Rad die Schiene verlässt, wird über eine Posteriorverteilung nicht gesagt, wohl aber von riffel forecast ohne --posterior
forecast-on-doubtful-chains = die Ketten lassen { $doubts } Zweifel, die riffel calibrate nennt: mit mehr Ziehungen können sich die Bänder ändern
posterior-forecast-is-over = { $draws } Ziehungen der Posteriorverteilung, vom letzten Datum { $months } Monate weit; Mediane mit Bereichen von 90 %
wavelength-of-band = Wellenlänge mm
level-now-banded = jetzt dB
level-then-banded = dann dB
limit-of-band = Grenze dB
months-banded = Monate bis zum Grenzwert
months-to-the-limit = Monate bis zum Grenzwert ({ $limit }): { $months }; die Hälfte der Ziehungen zwischen { $low } und { $high }
never-within = { $share } % der Ziehungen erreichen ihn nicht in { $months } Monaten
told-by-data = Daten
told-by-prior = Vorwissen
told-by = bekannt durch
values-together = Werte zusammen
spread-percent = ± %
first-of-pair = Wert
second-of-pair = anderer Wert
told-as-a-product = die Daten sagen über { $one } und { $other } nur zusammen etwas, als Produkt von Potenzen (r = { $correlation }): keiner von beiden darf allein in einen Fall geschrieben werden
told-as-a-ratio = die Daten sagen über { $one } und { $other } nur zusammen etwas, als Quotient von Potenzen (r = { $correlation }): keiner von beiden darf allein in einen Fall geschrieben werden
calibration-allows-no-conclusion = die Ketten erlauben keinen Schluss, wegen { $doubts } Zweifeln, die bei ihnen stehen: mehr Ziehungen können sie ausräumen
chains-disagree = die Ketten sind über { $value } uneins: R̂ ist { $rhat }, darf aber höchstens { $most } sein; mehr Ziehungen nehmen, oder { $other }
look-for-a-second-way = einen zweiten Weg suchen, auf dem das Modell zu den Daten passt
populations-find-both-ways = wo sich die Daten auf zwei Wegen treffen lassen, sampler.kind = "smc" nehmen, das beide findet
too-few-effective-draws = { $value } hat { $draws } wirksame Ziehungen, braucht aber { $least }; mehr Ziehungen nehmen
trajectories-ran-away = { $trajectories } Bahnen sind entwichen: die Ziehungen lassen einen engen Teil der Nachverteilung aus; länger einlaufen lassen oder Vorverteilungen wählen, die ihn meiden
tails-are-not-reached = die Energie der Ketten bewegt sich um { $moves } ihrer Streuung, muss sich aber um { $least } bewegen: die Ausläufer sind nicht erreicht
calibration-tells-nothing = aus den Daten geht keiner der { $count } Werte hervor: jeder ist so unsicher wie zuvor
calibration-tells-all = aus den Daten gehen alle { $count } Werte hervor, am besten { $best }
calibration-tells-some = aus den Daten gehen { $told } von { $count } Werten hervor, am besten { $best }; nicht hervor geht { $untold }
outlying-above = { $datum } ({ $data }) liegt { $deviations } Standardabweichungen über dem, was alle anderen Daten davon sagen; der Wert bleibt unter ihnen: zu prüfen ist, wie gemessen wurde oder was dem Modell dort fehlt
outlying-below = { $datum } ({ $data }) liegt { $deviations } Standardabweichungen unter dem, was alle anderen Daten davon sagen; der Wert bleibt unter ihnen: zu prüfen ist, wie gemessen wurde oder was dem Modell dort fehlt
datum-receptance = |H| bei { $at } Hz
datum-phase = die Phase von H bei { $at } Hz
datum-decay-rate = die Abklingrate bei { $at } Hz
datum-level = der Pegel von { $at } mm nach { $passages } Millionen Überrollungen
datum-axle-box = der Pegel des Achslagers bei { $at } mm
datum-pass-by = der Vorbeifahrtpegel nach { $passages } Millionen Überrollungen
datum-growth = das Wachstum der Wellen von { $at } mm nach { $passages } Millionen Überrollungen
datum-drift = das Wandern der Wellen von { $at } mm nach { $passages } Millionen Überrollungen
at-position = { $datum }, { $position } m
value-is-not-told = { $value } geht aus diesen Daten nicht hervor: 90 % der Vorverteilung liegen zwischen { $low } und { $high } { $unit }
drawn-as-levels-see-it = über die Kalibrierung ist der Fall so, wie ihn die datierten Pegel sehen, mit { $set }
median-with-band = { $median } ({ $low } … { $high })
growth-over-posterior = über { $draws } Ziehungen der Kalibrierung wächst im Median { $wavelength } mm am schnellsten ({ $shortest } bis { $longest } mm, 90 %) und verdoppelt sich in { $time } (90 %)
no-growth-in-draws = in { $share } % der Ziehungen wächst nichts
variant-over-posterior = „{ $title }“: über { $draws } Ziehungen der Kalibrierung ändert sich das Wachstum um { $change } % (90 %), und in { $share } % von ihnen ist es kleiner
variant-months-over-posterior = „{ $title }“: { $months } Monate bis zur Grenze (90 %)
level-over-posterior = über { $draws } Ziehungen der Kalibrierung { $level } dB(A) (90 %)
measure-over-posterior = { $measure }: spart { $saved } dB(A) (90 %)
model-of-the-plan = Modell des Plans
model-column = Modell
left-out-date = { $data }, Datum nach { $passages } Überrollungen
left-out-place = { $data }, Schläge bei { $place } m
models-by-what-they-predict = Modelle nach ihren Vorhersagen: Daten werden weggelassen, und ln Dichte sagt, wie wahrscheinlich das Modell und alle anderen Daten das dort Gemessene machen
log-density = ln Dichte
behind-the-best = hinter dem besten
error-of-behind = ±
verdict-on-model = Urteil
verdict-best = am besten
verdict-worse = schlechter
verdict-not-told-apart = nicht zu unterscheiden
inside-50-percent = im 50-%-Bereich, %
inside-80-percent = im 80-%-Bereich, %
inside-90-percent = im 90-%-Bereich, %
left-out-column = weggelassen
shape-of-weights = k̂
data-left-out = Daten
inside-50 = im 50-%-Bereich
inside-90 = im 90-%-Bereich
model-predicts-worse = { $model } sagt schlechter voraus als { $best }: die ln Dichte ist um { $behind } ± { $error } kleiner
model-not-told-apart = { $model } und { $best } sind nicht zu unterscheiden: die ln Dichte unterscheidet sich um { $behind } ± { $error }; nötig sind zwei Standardfehler und 4
all-models-see = Modelle: { $models }
left-out-to-compare = weggelassen, jedes für sich, um sie zu vergleichen: { $held }
one-group-left-out = nur { $held } wurde weggelassen: ein anderes Datum, ein anderer Ort oder andere Daten können anders urteilen, und ± ist allein der Fehler der Ziehungen
log-evidence = ln Evidenz { $value }, { $low } bis { $high } in { $runs } Läufen; sie ändert sich mit der Breite des Vorwissens und vergleicht daher nur Modelle mit gleichem
models-on-doubtful-chains = { $model }: seine Ketten lassen { $doubts } Zweifel, mit mehr Ziehungen kann sich das Ergebnis ändern

## Ketten zu simulierten Daten

truth-among-draws = { $runs } Simulationen mit dem Vorwissen und der Likelihood des Plans: wie oft Bereiche die Wahrheit enthalten, und ob sie beliebig unter den Ziehungen liegt
checked-value = Wert
probability-of-ranks = Wahrscheinlichkeit der Ränge
verdict-on-ranks = Ränge
ranks-even = gleichmäßig
ranks-uneven = ungleichmäßig
log-likelihood-of-all-data = ln Likelihood
passages-to-the-limit = Überrollungen bis zur Grenze
simulations = Simulationen
all-ranks-even = in { $runs } Simulationen liegt die Wahrheit beliebig unter den Ziehungen
ranks-are-uneven = { $value }: in { $runs } Simulationen liegt die Wahrheit nicht beliebig unter den Ziehungen (Wahrscheinlichkeit { $probability }): die Bereiche sind falsch; mit mehr Vorlauf und Ziehungen oder einem anderen Verfahren können sie richtig werden
