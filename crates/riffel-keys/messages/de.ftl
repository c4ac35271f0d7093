# Was Riffel sagt. Terms: Schlupf (creepage), Bohrschlupf (spin), Kraftschlussausnutzung (tractive ratio), Zwischenlage (rail
# pad), Riffel (corrugation), Überrollung (passage of a wheel), Wachstumsgrat (growth ridge), Radsatz (wheelset).

verbatim = { $words }
in-both-languages = { $english ->
       *[other] { $german }
    }

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
set-signs = { KEY("track.measurement.conjugate") } = { $conjugate } und { KEY("track.measurement.negate") } = { $negate } schreiben
set-one-of-the-signs = { KEY("track.measurement.conjugate") } oder { KEY("track.measurement.negate") } setzen, je nachdem
conjugate-it = konjugieren
negate-it = das Vorzeichen wechseln
conjugate-and-negate-it = konjugieren und das Vorzeichen wechseln
conjugate-or-negate-it = konjugieren oder das Vorzeichen wechseln, je nachdem
receptance-gives-energy = die gemessene Rezeptanz gibt Energie ab (Im H > 0), bei { $count } von { $points } Frequenzen zwischen { $first } und { $last } Hz: Phase und Rauschen prüfen
    .short = die gemessene Rezeptanz gibt Energie ab (Im H > 0), bei { $count } von { $points } Frequenzen: Phase prüfen
response-conjugated = die Rezeptanz gibt Energie ab (Im H > 0), bei { $count } von { $points } Frequenzen, und das Vorzeichen ihres Realteils stimmt: sie ist konjugiert, wie mit exp(−iωt). Um sie mit exp(+iωt) zu haben, { $remedy }
response-negated = die Rezeptanz gibt Energie ab (Im H > 0), bei { $count } von { $points } Frequenzen, und auch das Vorzeichen ihres Realteils ist falsch: sie ist negativ, weil Aufnehmer und Kraft gegeneinander zeigen. Um sie umzukehren, { $remedy }
response-conjugated-and-negated = der Realteil der Rezeptanz hat das falsche Vorzeichen für ihren Betrag: sie ist konjugiert, wie mit exp(−iωt), und negativ. Um sie umzukehren, { $remedy }
response-conjugated-or-negated = die Rezeptanz gibt Energie ab (Im H > 0), bei { $count } von { $points } Frequenzen: sie ist konjugiert, wie mit exp(−iωt), oder negativ. Um sie umzukehren, { $remedy }
response-of-other-quantity = die Rezeptanz gibt Energie ab (Im H > 0), bei { $count } von { $points } Frequenzen, doch ihre Phase passt zu ihrem Betrag, wie die einer Mobilität oder Akzeleranz: prüfen, was gemessen wurde, und die Einheit
response-mirrored = oberhalb von { $hertz } Hz läuft der Frequenzgang rückwärts durch seine eigenen konjugierten Werte, wie die obere Hälfte eines zweiseitigen Spektrums: die Linien darüber weglassen
response-delayed = die Phase des gemessenen Frequenzgangs dreht bis { $hertz } Hz um { $degrees }° gegen die, die zu seinem Betrag gehört, wie bei { $milliseconds } ms zwischen den Kanälen von Kraft und Antwort: die Verzögerung herausrechnen, sonst gilt das Wachstum für ein anderes Gleis
    .short = die Phase des gemessenen Frequenzgangs dreht um { $degrees }°, wie bei einer Verzögerung von { $milliseconds } ms: herausrechnen
response-ripples = der Betrag des gemessenen Frequenzgangs ist alle { $hertz } Hz wellig, wie wenn der Hammer zweimal trifft, im Abstand von { $milliseconds } ms: solche Schläge weglassen
    .short = der gemessene Frequenzgang ist alle { $hertz } Hz wellig, wie wenn der Hammer zweimal trifft
receptance-in-si = Rezeptanz in m/N
mobility-in-si = Mobilität in m/s/N
accelerance-in-si = Akzeleranz in m/s²/N
column-without-unit = Spalte `{ $column }` nennt keine Einheit: als { $what } gelesen (sonst { KEY("track.measurement.quantity") } und unit setzen)
receptance-unlike-rail = die gemessene Rezeptanz liegt bei { $least } bis { $most } m/N, Schienen haben 1e-11 bis 1e-7 m/N: Größe und Einheit prüfen, im Fall { KEY("track.measurement.quantity") } und unit
poor-coherence = die Kohärenz liegt bei { $count } von { $points } Frequenzen zwischen { $first } und { $last } Hz unter { $good }: dort gilt das Mittel der Linien im Umkreis von 1/24 Oktave, gewichtet mit γ²/(1 − γ²)
response-at-other-node = gemessen ist die Antwort am Knoten { $response } auf eine Kraft am Knoten { $reference }: sie gilt als Rezeptanz am Kontakt

## Ranges of validity

response-known-from = liegt unter { $wavelength } mm: Die Tabelle des exakten Kontakts konvergiert auf kürzeren Wellen nicht
take-longer-waves-or-another-grid = längere Wellen nehmen, oder ein anderes { KEY("contact.grid") }
map-begins-where-contact-is-known = die Karte beginnt bei { $wavelength } mm: Auf kürzeren Wellen konvergiert die Tabelle des exakten Kontakts nicht; ein anderes { KEY("contact.grid") } hilft vielleicht
rail-without-support = die Schiene liegt nirgends auf: unter etwa { $free_beam_from_hz } Hz ({ $window }: ab { $lowest } Hz) ändern Zwischenlagen, Schwellen und Schotter ihre Rezeptanz
rail-without-shear = die Schiene biegt sich ohne Schub: ihre Rezeptanz weicht bei { $euler_beam_up_to_hz } Hz um etwa 9° ab, bei 1500 Hz um 24° und 14 % ({ $window }: bis { $highest } Hz)
pinned-pinned-without-shear = die Schiene biegt sich ohne Schub: ihre Pinned-pinned-Frequenz ist um 20 bis 35 % oder mehr zu hoch und wird nicht genannt ({ KEY("rail.beam") } = "timoshenko" wählen)
supports-spread-evenly = die Stützpunkte sind gleichmäßig über die Schiene verteilt: die Pinned-pinned-Resonanz nahe { $pinned } Hz fehlt, und darunter weicht die Rezeptanz um 10 bis 50 % ab, auf sehr steifen Zwischenlagen um mehr ({ $window }: bis { $highest } Hz; ein Modell wählen, das auf -periodic endet)
no-average-over-patch = der Kontakt ist quasistatisch und mittelt nicht über seine Fläche: unter { $shortest } mm ist das Wachstum zu hoch
closed-form-of-ellipse = die Radien von Rad und Schiene sind sehr verschieden: die geschlossene Formel der Kontaktellipse weicht quer zur Schiene um { $percent } % ab ({ KEY("contact.hertz") } = "exact" wählen)
falling-friction-at-one-speed = die fallende Reibung ist die beim Schlupf bei { $rolling }, { KEY("contact.polach.speed") }, bei jeder Geschwindigkeit ({ $window })
wheel-and-rail-part = bei einer Amplitude von { $amplitude } µm erreicht |P₁/P₀| { $worst }: Rad und Schiene trennen sich; Kräfte sind bis { $limit } µm linear (Wachstumsraten gelten für kleine Amplituden und ändern sich nicht)
wave-geometry-left-out = die Geometrie der Welle selbst ist nicht dabei ({ KEY("contact.wave_geometry") }): sie nähme etwa { $takes } je m von einem Wachstum von { $growth } je m, bei { $wavelength } mm und { $speed }
    .short = ohne die Geometrie der Welle selbst, die etwa { $takes } je m von { $growth } nähme ({ KEY("contact.wave_geometry") })
wave-shorter-than-patch = unter { $shortest } mm, drei halben Längen der Kontaktfläche, ist die Geometrie der Welle selbst nur grob geschätzt
troughs-bridged = unter { $bridged } mm überbrückt das Rad die Täler von Wellen von { $amplitude } µm (Wachstumsraten gelten für kleine Amplituden)
    .short = unter { $bridged } mm überbrückt das Rad Täler von { $amplitude } µm

## Branches of the ridge

at-edge-of-window = , am Rand des Fensters
nothing-grows = in diesem Fenster wächst nichts
both = { $one } und { $other }
one-after-other = { $one }; { $other }
before-comma = { $words },{" "}
branch = { $frequency } Hz ({ $mechanism }{ $speeds }, { $wavelengths } mm{ $edge })
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
wheels-slide-as-they-roll = die Räder gleiten so schnell, wie sie rollen: bei so viel Schlupf bleiben die Kraftschlusskräfte unter denen des mittleren Zustands, und sonst hält die Räder nichts; { KEY("wheelset.suspension") } oder weniger Schlupf hilft
wheel-bridges-trough = ein Rad von diesem Halbmesser erreicht über { $largest } µm die Täler solcher Wellen nicht: es berührte an zwei Stellen, hier an einer
edge-of-patch-not-resolved = die Last bewegt den Rand der Kontaktfläche um { $moves } Elemente: Harmonische der Schlupfkraft liegen bis zu einigen zehn Prozent daneben; eine größere Amplitude oder mehr als { $across } Elemente ({ KEY("contact.grid") }) nehmen, bis es { $resolved } sind

## Profiles

flat-patch-beyond-range = die Schiene dreht sich über eine Kontaktfläche um { $degrees }°: die ebene trägt bis etwa 23°, halbe Breite durch Radius 0,2; darüber gilt die konforme daneben
positions-do-not-rise = { KEY("--from") } ist { $from } m und { KEY("--to") } { $to } m, doch Positionen müssen steigen
spectra-have-no-positions = { $key } ist { $position }, doch die Datei ist eine Tabelle von Spektren, die keine Positionen hat
no-column-of-rails = { KEY("--rail") } ist { $rail }, doch die Tabelle hat keine Spalte `rail`
spacing-is-not-positive = { KEY("--spacing") } ist { $spacing }, muss aber größer als null sein
spacing-is-not-that-of-positions = { KEY("--spacing") } ist { $spacing }, doch die Positionen liegen { $metres } m auseinander
measures-not-measured = { $name }: { $measures } { $count ->
    [one] wird
   *[other] werden
 } nicht angegeben: dort haben die Punkte eine Lücke oder enden
rail-worn-on-field-side = { $name }: auf der Außenseite, an der es ausgerichtet ist, bleiben { $millimetres } mm: sie ist dort verschlissen, oder geneigt ({ KEY("--inclination") }), oder eine andere Schiene

## Files of profiles

flange-backs-apart = die Spurkranzrücken der Datei stehen { $distance } mm auseinander
tread-datum-elsewhere = ihr Messkreis liegt { $datum } mm vom Spurkranzrücken, doch das Rad steht nach seinem Spurkranzrücken auf der Achse, und der Ursprung liegt { $origin } mm davon
gauge-of-file = die Spurweite der Datei ist { $distance } mm, { $depth } mm unter der Schienenoberkante
smoothing-of-file-left-out = die Glättung der Datei (approx.smooth) ist nicht die von Riffel und bleibt weg: die Streuung ihrer Punkte angeben
points-missing = der Kopf kündigt { $announced } Punkte an (XYPoints), es folgen { $count }: vielleicht fehlt ein Stück der Datei
masked-points-left-out = { $masked } am Gerät ausgeblendete Punkte sind weggelassen
profile-has-gaps = { $name }: keine Punkte quer bei { $gaps }: dort ist eine glatte Kurve gezogen, und Verschleiß, Spurkranz und Konizität, die dorthin reichen, sind nicht gemessen
between-millimetres = { $from } bis { $to } mm
outlying-points-left-out = { $name }: { $count } Punkte weit neben ihren Nachbarn sind weggelassen, der erste in Zeile { $line }
scatter-of-curvature = { $name }: Streuung lässt ±{ $error } 1/m der Krümmung bei x = 0
points-scatter = { $name }: die Punkte streuen um { $micrometres } µm, so dass die Krümmung einer Kurve durch sie um etwa { $curvature } 1/m daneben liegt; diese Streuung angeben (profiles.scatter, { KEY("--scatter") }), um zu glätten

## Curves

wheelset-beyond-flange = ein Radsatz ist um { $shift } mm verschoben: Spurkränze lassen 5 bis 10 mm Spiel, dieser Fall hat keine
linear-creep-beyond-friction = creep_law = "linear" kennt keine Reibung: Schlupfkräfte erreichen { $most } von μP
yaw-takes-play = mit seinem Gierwinkel von { $yaw } mrad hat Radsatz { $number } { $yawed } mm bis zum Spurkranz, nicht die { $straight } mm der Tabellen: Kontakte liegen, wo sie ohne Gieren liegen

## The mean state from a curve

creep-law-without-spin = { KEY("contact.creep_law") } = "{ $name }" kennt keinen Bohrschlupf: die { $spin } 1/m des Bogens bleiben weg ({ $key })
case-has-own-values = statt dessen, was der Bogen sagt, hat der Fall eigene Werte: { $instead }
no-rigid-contact-at-angle = kein starrer Kontakt hat den Winkel des Gleichgewichts, { $degrees }°
patches-join = die Kontaktfläche geht in die des nächsten Berührpunkts über
two-points-join-under-load = das Rad steht auf zwei Punkten, die unter Last zu einer Kontaktfläche würden

## Ranges of validity, further

ellipse-too-wide = die Kontaktellipse ist { $width } mm breit: darüber hat kein Profil eine einzige Krümmung, und die Theorie von Hertz endet
loop-not-judged = ob der Kreis bei { $speed } stabil ist, ist nicht zu erkennen: seine Phase springt, wie an einer Resonanz ohne Dämpfung oder außerhalb gemessener Frequenzen; Radsatz, Schiene und Zwischenlagen einen Verlustfaktor geben
loop-unstable = der Kreis ist bei { $speed } instabil: um { $frequency } Hz schwingt er ohne jedes Profil (Quietschen, Haften und Gleiten){ $growth }, und Wachstumsraten bedeuten dort nichts
loop-unstable-growth = , wächst e-fach in { $time }{ $others }
loop-unstable-other = , eine mit { $frequency } Hz e-fach in { $time }{ $others }
stability-title = Schwingung ohne jedes Profil
stability-caption = Durchgezogen: die Grenze; auf der Seite des Zeichens wächst eine Schwingung der genannten Frequenz von selbst (auf einen halben Schritt des Rasters genau). Gepunktet und gestrichelt: wie schnell, so viele Male in der Sekunde e-fach. Zeichen: wo sie am schnellsten wächst. Wo mehrere wachsen, steht die höchste Frequenz da.
stability-of-one-axis = ein Rad, das sich nur senkt und dreht, schwingt nicht von selbst; ihm Schlupf oder Bewegung quer zur Schiene geben, wie { KEY("contact.from") } oder [wheelset]
stability-unknown = { $points } Punkte sind nicht zu erkennen: die Phase des Kreises springt dort, wie an einer Resonanz ohne Dämpfung; Radsatz, Schiene und Zwischenlagen einen Verlustfaktor geben
no-mean-state = bei einer Reibung von { $friction } finden die Räder keinen mittleren Zustand; diese Punkte bleiben weg
stable-everywhere = der Kreis ist von { $slowest } bis { $fastest } bis zu einer Reibung von { $highest } stabil
unstable-from = ab einer Reibung zwischen { $stable } und { $least } wächst irgendwo von { $slowest } bis { $fastest } eine Schwingung von selbst
unstable-from-the-least = schon bei der kleinsten betrachteten Reibung, { $least }, wächst irgendwo von { $slowest } bis { $fastest } eine Schwingung von selbst
branch-from = von Hz
branch-to = bis Hz
least-friction = kleinste Reibung
fastest-growth-in-time = schnellstes Wachstum 1/s
at-speed-column = bei km/h
at-friction-column = bei Reibung
wheel-flatter-than-radius = bei { $angle }° ist das Rad längs der Schiene { $flatter } mal so flach wie sein Rollradius, den die Ellipse nimmt: { KEY("contact.longitudinal_radius") } angeben
track-moves-downward-only = dieses Gleis bewegt sich nur nach unten; längs und quer zur Schiene gilt es als starr

## Measured wheelsets

column-of-wheelset-without-unit = Spalte `{ $column }` nennt keine Einheit: als Rezeptanz in m/N gelesen (sonst dazuschreiben, wie in `{ $column } [m/s2/N]`)
wheelset-not-reciprocal = der gemessene Radsatz ist nicht reziprok: { $at } bei Kraft an { $from } und umgekehrt unterscheiden sich um bis zu { $percent } %, bei { $hertz } Hz; es gilt ihr Mittel: Aufnehmer, Hammer und Vorzeichen der Achsen prüfen
wheelset-gives-energy = der gemessene Radsatz gibt Energie ab, bis zu { $percent } % seiner größten Rezeptanz, bei { $hertz } Hz, am meisten an { $port }: Phasen, Rauschen und fehlende Einträge prüfen, und ob er exp(+iωt) folgt
wheelset-not-measured-along = der Radsatz ist nicht gemessen in Richtung { $axes }: dort gilt er als starr

## Cases

creep-law-unlike-equilibrium = { KEY("contact.creep_law") } = "{ $law }" macht |Q| = { $here } μP aus Schlüpfen, bei denen das Gleichgewicht im Bogen { $in_curve } hat
creep-law-of-growth-only = { KEY("contact.creep_law") } = "{ $law }" ist das des Wachstums: im Bogen rollt das Rad nach Shen, Hedrick und Elkins
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
mean-state-from-curve = mittlerer Zustand aus dem Bogen von { $radius } m bei { $speed }: Radsatz { $wheelset } { $rail } schlüpft { $along } % längs, { $across } % quer, Bohrschlupf { $spin } 1/m, unter { $load } kN bei { $angle }°
ellipse-in-place-of-patch = { $rail } nimmt der Kreis die Ellipse von Hertz und keine Kontaktfläche der Profile unter Last: { $reason }
patch-under-load-against-hertz = ; die Profile unter Last auf der gekrümmten Schiene sind um { $stiffer } % steifer, { $longer } % so lang und { $wider } % so breit ({ KEY("contact.from.patch") } = "conformal" nimmt sie)
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
read-as-undecided-rail = gelesen als Schiene: die Koordinaten { $changes }; ihr Kopf neigt sich um { $off } mm, weiter als der einer geneigten Schiene (20 mm), sodass die Fahrkantenseite offen bleibt: x unter null gilt, sonst als Lage "mirrored" angeben
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

## Values of presets: how well they are known

badge-measured = gemessen
badge-typical = typisch
badge-assumed = angenommen

## Traffic

growth-faster-than-any-seen = das Wachstum bei { $wavelength } mm ist schneller als bei jeder bekannten Bahn: Wellenlängen und Reihenfolge gelten, die Rate nicht; die schnellste hier bekannte Amplitude verdoppelte sich in { $known } Tagen, in einem Metrobogen von 120 m Radius (Torstensson & Nielsen 2009); tractive_ratio, traction_share (der Anteil der Achsen darunter) und { KEY("wear.coefficient") } prüfen

## Wem die schnellste Wellenlänge folgt

cause-near = { $wavelength } mm wächst am stärksten bei { $speed }, wo { $frequency } Hz { $distance } % neben { $resonance } Hz liegt ({ $mechanism })
cause-at = { $wavelength } mm wächst am stärksten bei { $speed }, bei { $frequency } Hz, einer Resonanz ({ $mechanism })
cause-alone = { $wavelength } mm wächst am stärksten bei { $speed }, bei { $frequency } Hz; keine Resonanz von Gleis oder Radsatz liegt näher als { $within } %
cause-loop = keine Resonanz: der Kreis von Kraft, Schlupf und Verschleiß
frequency-is-kept = von { $slow } bis { $fast } geht die schnellste Wellenlänge von { $first } bis { $last } mm und ihre Frequenz von { $low } bis { $high } Hz: fest ist eine Frequenz, keine Länge
frequency-is-not-kept = von { $slow } bis { $fast } geht die Frequenz der schnellsten Wellenlänge von { $low } bis { $high } Hz: keine eine Frequenz ist fest
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
helps-most-in-order = am meisten hilft: { $title }; das Wachstum fällt um { $percent } %
helps-nothing = keine dieser Maßnahmen bremst das Wachstum
left-out-for = ausgelassen: { $title }; { $reason }
vehicles-differ = { $key } unterscheidet sich zwischen den Fahrzeugen oder streut über ihre Räder: in der Verkehrsdatei ändern
remedy-lacks-key = der Fall hat keinen Wert von { $key }
remedy-has-no-effect = { $key } ändert in diesem Fall nichts
remedy-is-refused = damit lässt sich dieser Fall nicht berechnen
friction-is-low = die Reibung ist schon { $friction }
grinding-leaves-fast-growth = Schleifen senkt den Pegel und lässt das Wachstum, wie es ist
grinding-leaves-growth = Schleifen senkt den Pegel und lässt das Wachstum, wie es ist: 6 dB in { $time }
ground-as-it-is = so wie es ist, steigt das erste Band in { $time } um 6 dB über das, was Schleifen hinterlässt: so lang ist der Abstand des Schleifens bei einem Grenzwert in dieser Höhe
steps-are-chosen = wie weit jede Maßnahme geht, ist gewählt; was ein Produkt bewirkt, steht in seinem Datenblatt
speeds-are-wide = die Geschwindigkeiten streuen schon etwa so weit, wie es eine Normalverteilung kann
treatment-keeps-force = auf behandelter Reibung ziehen und bremsen Züge mit derselben Kraft und mehr Schlupf; wo ein Bogen den Schlupf bestimmt, { KEY("contact.creepage") } anstelle von { KEY("contact.tractive_ratio") } angeben

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
field-is-kept = vorhergesagt von riffel { $version } beim Verschleiß von Schienen im Betrieb mit { $samples } Stichproben je Ort, einmal, und vom Projekt aufbewahrt: { $inside } von { $outcomes } gemessenen Werten liegen darin, die logarithmische Bewertung ist { $score }

## Wachstum unter dem Verkehr einer Strecke

traffic-of-main-line = dem üblichen Verkehr einer Hauptstrecke
traffic-of-freight-line = dem üblichen Verkehr einer Güterstrecke
traffic-of-heavy-haul = dem üblichen Verkehr einer Schwerlaststrecke
traffic-of-metro = dem üblichen Verkehr einer U-Bahn
traffic-of-tram = dem üblichen Verkehr einer Straßenbahn
traffic-of-curve = dem üblichen Verkehr dieses Bogens
traffic-given = dem angegebenen Verkehr
traffic-at-speeds = { $traffic } ({ $speeds })
traffic-at-speeds-a-day = { $traffic } ({ $speeds }, { $axles } Achsen am Tag)
compared-under = unter { $traffic }
shorter-waves = kürzere
longer-waves = längere
one-wavelength = { $wavelength } mm
grows-fastest-under = am schnellsten wächst { $range } unter { $traffic }; { $wavelength } mm führt und verdoppelt sich in { $time }
rates-faster-than-known = nach dem Modell wächst sie schneller als bei jeder bekannten Bahn; Wellenlängen und Reihenfolge gelten, Raten nicht
rates-of-unstable-loop = der Kreis schwingt bei { $frequency } Hz von selbst, und seine Wachstumsraten bedeuten nichts
oscillates-by-itself = der Kreis schwingt von selbst
oscillates-under = der Kreis schwingt bei { $frequency } Hz von selbst unter { $traffic }, wie beim Quietschen: seine Wachstumsraten bedeuten nichts, und keine Welle führt
faster-than-known = schneller als jede bekannte Bahn
grows-fastest-without-rate = am schnellsten wächst { $range } unter { $traffic }; { $wavelength } mm führt, schneller als bei jeder bekannten Bahn: Wellenlängen und Reihenfolge gelten, die Rate nicht
grows-fastest-by-damage = am schnellsten wächst { $range } unter { $traffic }; { $wavelength } mm führt und verdoppelt sich in { $time }, wenn die Tiefen von { KEY("damage") } so sind, wie sie geschrieben stehen, was keine Messung gesagt hat
grows-fastest-under-within = am schnellsten wächst { $range } unter { $traffic }; { $wavelength } mm führt und verdoppelt sich in { $time } (80 %: der Verschleißbeiwert ist unsicher)
growth-is-cut-off = „{ $title }“ wächst am schnellsten bei { $wavelength } mm, am Rand von { KEY("map.wavelength") } und ohne ein Maximum: { $beyond } Wellen, die in den Aussagen über den Grenzwert fehlen, können ihn früher erreichen; { KEY("map.wavelength") } erweitern
fastest-at-edge = { $wavelength } mm liegt am Rand und ist kein Maximum: { $beyond } Wellen können schneller wachsen
nothing-grows-under = nichts von { $shortest } bis { $longest } mm wächst unter { $traffic }
days-of = { $days } Tagen
days-between = { $early } bis { $late } Tagen
months-of = { $months } Monaten
months-between = { $early } bis { $late } Monaten
years-of = { $years } Jahren
years-between = { $early } bis { $late } Jahren
time-or-longer = { $early } bis mehr als { $years } Jahre
longer-than-years = über { $years } Jahren
million-axles = { $axles } Millionen Achsen
million-axles-between = { $early } bis { $late } Millionen Achsen

## Noise

rigid-wheel = das Rad ist hier ein starrer Körper: über etwa 1,6 kHz strahlen die Moden von Steg und Kranz, die fehlen, so viel ab wie die Schiene und mehr
ringing-wheel = das Rad klingt, wie seine Moden und die Schiene es zulassen: über 2 kHz waren solche Pegel dort, wo gemessen wurde, um 5 bis 13 dB zu laut, die eines starren Rades um 3 bis 6 dB zu leise
modes-of-other-wheel = die Moden sind die eines Rades von { $of_modes } mm, das Rad des Falls hat { $of_case } mm: ein kleineres Rad klingt höher
far-away = in { $distance } m nehmen Boden und Luft, die hier fehlen, etwas davon weg: Pegel jenseits von { $far } m sind zu hoch
smooth-wheels = die Räder gelten als glatt: sind sie rauer als die Schiene, steigen alle Pegel, und Schleifen spart weniger
over-common-bands = { $count ->
        [one] über das eine Band, das beide haben: { $said }
       *[other] über die { $count } Bänder, die beide haben: { $said }
    }
noise-before-and-after = vorher { $before }, jetzt { $after }: { $change } dB
noise-before = vorher
level-at-least = ≥ { $level } (bis { $hertz } Hz)
noise-is-lower-bound = ein Zug ist mit { $level } zu hören: das ist eine untere Schranke, denn darüber ist kein Pegel bekannt
noise-on-mean-of-rails = auf dem energetischen Mittel der Schienen { $rails }, da Räder auf beiden laufen; eine davon allein gewählt ({ KEY("--rail") }) gibt den Lärm eines Zugs auf Schienen wie dieser
noise-beyond-linear-range = außerhalb des linearen Bereichs: |P₁| ist { $ratio } P₀, Rad und Schiene trennen sich also, was die Kraft begrenzt; die Pegel sind die eines Kontakts, der hält
rail-cut-short = die Schiene trägt mehr als ein Zehntel ihrer Schwingung weiter als 66 Schwellenfächer, wo ihre Länge endet: ihr Pegel ist zu niedrig bei { $frequencies } Hz
bands-left-out = fehlt in jedem Pegel, mangels Rauheit, Abklingrate oder Rezeptanz dort: { $frequencies } Hz

# Rollgeräusch: Tabellen und Sätze
rolling-noise = Rollgeräusch
noise-at-speed = { $title }, { $speed }
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
saves-decibels-up-to = spart dB (bis { $hertz } Hz)
rail-ground-to = Schiene geschliffen auf { $edition }
at-speed = { $speed }
rail-dampers = Schienendämpfer, die die Abklingrate verdoppeln
wheel-dampers = Raddämpfer, Moden mit { $percent } % Dämpfung
softer-pads = Zwischenlagen halber Steifigkeit
stiffer-pads = Zwischenlagen doppelter Steifigkeit
noise-becomes = unter dem Verkehr werden aus { $from } in { $months } Monaten { $to }
noise-becomes-to-linear-end = unter dem Verkehr werden aus { $from } in { $months } Monaten { $to }, wo die Rauheit den linearen Bereich verlässt
noise-without-course = der Pegel in kommenden Monaten wird nicht genannt: { $reason }
noise-falls-below = { $sentence }; jetzt liegt er über { $limit } dB(A) und fällt darunter
noise-limit-now = { $sentence }; { $limit } dB(A) sind jetzt erreicht
noise-limit-in-months = { $sentence }; { $limit } dB(A) sind in { $months } Monaten erreicht
noise-limit-not-known = { $sentence }; ob { $limit } dB(A) erreicht werden, lässt sich nicht sagen
noise-limit-not-reached = { $sentence }; { $limit } dB(A) werden nicht erreicht

## Gemessenes Wachstum

decaying-bands-stay = Bänder, die abklingen, behalten den Pegel von heute: nichts im Modell macht die Rauheit, die der Verkehr auf einer Schiene macht
fit-of-one-rail = die Anpassung und die Änderungen daneben gelten für { $rail } allein; was jede Schiene für sich tut, steht in der Tabelle je Band
growth-unexplained = kein Verschleißbeiwert: das Modell erklärt das Wachstum bei { $wavelengths } mm nicht, { $measured } dB gemessen und { $fitted } dB mit dem besten Beiwert
grew-in-a-year = { $wavelength } mm ist um { $rate } dB im Jahr gewachsen
grew-in-a-year-within = { $wavelength } mm ist um { $rate } dB im Jahr gewachsen, 95-%-Intervall { $low } bis { $high }
grew-in-a-million = { $wavelength } mm ist um { $rate } dB je 10⁶ Überrollungen gewachsen
grew-in-a-million-within = { $wavelength } mm ist um { $rate } dB je 10⁶ Überrollungen gewachsen, 95-%-Intervall { $low } bis { $high }

## Abschnitte einer Schiene gegen Grenzwerte

section-within = innerhalb der Grenzwerte; nichts zu schleifen, denn der gleitende Effektivwert liegt nirgends über seinem Grenzwert
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
defects-left-out = { $sentence }; aus den Spektren weggelassen ({ KEY("--keep-defects") } behält sie)
defects-out-of-levels = { $sentence }; aus den Pegeln weggelassen ({ KEY("--keep-defects") } behält sie), nicht aber aus gleitendem Effektivwert und Schleifplan
defects-judged = { $sentence }; sie zählen in Pegeln und Grenzwerten, sind aber keine Riffeln
wheel-has-a-flat = { $channel }: das Rad hat eine Flachstelle von etwa { $depth } µm, die alle { $circumference } m zu spüren ist; sie ist keine Schweißung und aus Pegeln und Schleifplan weggelassen
wheel-is-not-round = { $channel }: das Rad hat { $order } Wellen auf dem Umfang, { $wavelength } mm lang mit einer Amplitude von { $amplitude } µm; sie sind aus Pegeln und Schleifplan weggelassen
wheel-or-rail = { $channel }: Wellen von { $wavelength } mm mit einer Amplitude von { $amplitude } µm kehren mit jeder Radumdrehung wieder, { $order } in einer, und bleiben in den Pegeln: eine Schiene, deren Wellen ihre Phase halten, sieht ebenso aus; ein zweites Achslager über dieser Schiene würde es zeigen
level-of-wheel-or-rail = { $channel }: bei { $wavelength } mm liegt der Pegel der Schiene zwischen etwa { $lowest } und { $level } dB, da diese Wellen die des Rades sein können; Grenzwerte und was zu schleifen ist, sind nach dem oberen beurteilt

grows-within = { $wavelength } mm wächst am schnellsten, um { $low } bis { $high } dB je Million Achsen (80 %): { $by }
grows-within-a-month = { $wavelength } mm wächst am schnellsten, um { $low } bis { $high } dB je Million Achsen, { $low_a_month } bis { $high_a_month } dB im Monat (80 %): { $by }
no-band-has-grown = kein Band dieser Schiene ist von Termin zu Termin gewachsen, und danach geht die Prognose: alle Pegel bleiben
grew-where-model-decays = das Modell des Falls erklärt diese Schiene nicht: { $wavelength } mm ist in { $amount } um { $decibels } dB gewachsen, und im Modell klingt es ab; die Prognose richtet sich nach der Messung
grew-unlike-model = das Modell des Falls erklärt diese Schiene nicht: { $wavelength } mm ist in { $amount } um { $decibels } dB gewachsen, und das Modell hat höchstens das { $ratio }-Fache davon (bis 10 % neben dieser Wellenlänge); die Prognose richtet sich nach der Messung
grew-as-model-explains = die Prognose richtet sich nach der Messung an dieser Schiene: { $wavelength } mm ist in { $amount } um { $decibels } dB gewachsen; das Modell des Falls hat, wo es bis 10 % daneben am schnellsten wächst, das { $ratio }-Fache davon
grew-by-its-own = die Prognose richtet sich nach der Messung an dieser Schiene: { $wavelength } mm ist in { $amount } um { $decibels } dB gewachsen
dates-since-grinding = die Messtage der Schiene sagen nicht, wie sie wächst: Seit ihr Pegel zuletzt um mehr als 3 dB gefallen ist, wie durch Schleifen, gibt es einen; das Wachstum ist das des Modells
dates-of-other-instruments = die Messtage der Schiene sagen nicht, wie sie wächst, denn ihre Geräte haben sie nie am selben Tag gemessen; das Wachstum ist das des Modells
growth-without-traffic = die Messtage der Schiene sagen nicht, wie sie wächst, denn die Verkehrsdatei nennt unter [line] weder { KEY("passages_per_day") } noch { KEY("mgt_per_year") }; das Wachstum ist das des Modells
levels-beside-ground = die Pegel der Schiene zählen neben dem, was Schleifen hinterlässt, nicht, denn sie sind von einem Tag; das Wachstum ist das des Modells
rate-now-and-then = { $now } jetzt, { $then } dann
so-many-million = { $count } Millionen
so-many-passages = { $passages } Überrollungen
as-this-rail-grew = wie diese Schiene von Messung zu Messung gewachsen ist
as-the-coefficient-may-be = der Verschleißbeiwert ist unsicher; Reibung, Zwischenlagen und Zugkraft gelten wie angegeben
measured-months-within = nach dem, was gemessen wurde, sind das { $early } bis { $late } Monate von jetzt (80 %)
measured-months-from = nach dem, was gemessen wurde, sind das { $early } Monate von jetzt oder mehr (80 %): Die Schiene ist kaum mehr gewachsen, als sie streut
months-within = mit der Unsicherheit des Verschleißbeiwerts sind das { $early } bis { $late } Monate von jetzt (80 %)
wear-unlike-rails = { $place } würde die Schiene { $depth } mm je 100 MGT verlieren, wo Schienen { $low } bis { $high } verlieren: Wellenlängen und Reihenfolge gelten, aber Raten und Zeiten liegen ebenso weit daneben; was die Schiene verloren hat, { KEY("wear.measured") } = "1 mm / 100 MGT", rückt sie zurecht
on-straight-track = auf gerader Strecke
in-this-curve = in diesem Bogen
in-this-curve-of = in diesem Bogen von { $radius } m
rate-of-wheels-on-one-line = die Rate ist die von Rädern dieser Art allein, alle auf einer { $width } mm breiten Spur; die eines Verkehrs sagt `riffel forecast`
rate-of-wheels-over-a-band = die Rate ist die von Rädern dieser Art allein, verteilt über ein Band von { $width } mm; die eines Verkehrs sagt `riffel forecast`
rates-hold-to = die Unsicherheit des Verschleißbeiwerts legt Raten und Zeiten auf einen Faktor { $factor } nach oben und unten fest (80 %); sie hat keinen Teil an dem, was Varianten ändern
band-narrower-than-contact = { KEY("wear.band_width") } ist { $band } mm, aber der Kontakt ist { $contact } mm breit: der Verschleiß kommt von der Breite des Kontakts
wheels-across-rail = die Räder von „{ $vehicle }“ laufen { $innermost } bis { $outermost } mm von der Achse der Schiene, nach außen positiv; { $percent } % ihrer Überrollungen treffen die Linie bei { $line } mm
no-equilibrium-at-speeds = „{ $vehicle }“ findet in seinem Bogen bei { $speeds } kein Gleichgewicht: dort stehen seine Räder wie bei den nächsten Geschwindigkeiten, die eines haben
band-bends-over = die Rate bei { $wavelength } mm hält { $passages } Achsüberfahrten lang: dann bräuchte sie mehr als den mittleren Verschleiß der Schiene, { $wear } mm je 100 Mio. t, und von da an steigt der Pegel langsamer
spread-takes-down = „{ $vehicle }“: { $what } senkt das schnellste Wachstum auf 1/{ $factor }
spread-of-speed = die Streuung der Geschwindigkeit
spread-of-wheel-radius = die Streuung der Radhalbmesser
spread-of-load = die Streuung der Lasten
spread-of-friction = die Streuung der Reibung
spread-of-position = die Streuung der Kontakte quer zur Schiene
spread-of-key = die Streuung von { $key }
creepages-left-out = die exakte Theorie konvergiert beim Schlupf { $creepages } auf einem Gitter von { $grid } nicht und bleibt dort aus; ein anderes { KEY("contact.grid") } kann helfen

## Schäden neben dem Verschleiß

damage-beyond-friction = der ausgenutzte Kraftschluss des mittleren Zustands ist { $friction }: über 0,6 sind Spannungen und Shakedown-Grenzen der Schadensgesetze mit nichts verglichen
damage-beyond-elastic = der Kontaktdruck von { $pressure } MPa ist das { $ratio }-Fache der Schubfließgrenze: über 7,3 ist der ganze Kontakt plastisch, und weder die Ellipse von Hertz noch Grenzen des Shakedowns gelten; { KEY("damage.shear_yield") } prüfen
moment-beside-its-limit = die mittlere Last biegt die Schiene mit { $moment } kN m, dem { $share }-fachen von { KEY("damage.bending.limit") }
flow-hardens = das Fließen verfestigt: sein Wachstum ist das der ersten Überfahrten; unter einer Durchgehzahl von eins kommt es zur Ruhe, und was weitergeht, ist Ratchetting bei der verfestigten Fließgrenze
hardening-runs-away = Fließen mit Verfestigung hält die Wellen des Bandes bei { $wavelength } mm nicht auf: die Durchgehzahl von einer ist { $runaway }, über eins, sodass sie durchgeht
rests-after-passages = {" "}nach { $passages } Achsüberrollungen
rests-after-months = {" "}nach { $months } Monaten
hardening-ends-wave = Fließen mit Verfestigung bringt die Wellen des Bandes bei { $wavelength } mm auf das { $ratio }-Fache und kommt{ $when } zur Ruhe: ihre Durchgehzahl ist höchstens { $runaway }, unter eins. Ein Gesetz, das sich bis zur Ruhe verfestigt, macht allein keine Riffeln; was weitergeht, ist Ratchetting bei der verfestigten Fließgrenze
cracks-are-worn-off = kein Riss wächst, in keiner Phase der vorhergesagten Wellen: der Verschleiß nimmt Risse schneller ab, als sie wachsen, oder { KEY("damage.fatigue.crack_growth") } ist null wie dort, wo es weggelassen ist
cracks-grow = Risse werden { $at } bei { $wavelength } mm am längsten: { $length } mm nach { $passages } Achsüberrollungen, daneben { $other } mm { $opposite }
cracks-grow-in-months = Risse werden { $at } bei { $wavelength } mm am längsten: { $length } mm nach { $months } Monaten, daneben { $other } mm { $opposite }
on-crests = auf den Bergen
in-troughs = in den Tälern
on-rising-flanks = auf den Flanken, die das Rad hinaufläuft
on-falling-flanks = auf den Flanken, die das Rad hinabläuft
below-the-limit-of-flow = die mittlere Beanspruchung ist { $demand }, unter eins: nach dem Gesetz { $law } wächst eine Welle erst, wenn ihre eigenen Kräfte die Grenze überschreiten
fatigue-below-threshold = Tγ des mittleren Zustands ist { $energy } N, unter der ersten Schwelle von { $threshold } N: Ermüdung nimmt dort nichts, und wo sie das einzige Gesetz ist, wächst eine kleine Welle nicht und klingt nicht ab
fatigue-loses-nothing = { KEY("damage.fatigue.loss") } ist null: Ermüdung wird genannt, hat aber keinen Anteil am Wachstum
shear-yield-assumed = die Schubfließgrenze der Schiene ist mit { $shear } MPa angenommen; { KEY("damage.shear_yield") } oder { KEY("damage.grade") } sagen sie
parts-along-the-wave = Rad und Schiene trennen sich entlang der Welle: Kräfte im Verhältnis zum Profil gelten nur unterhalb der Amplitude dafür
more-friction-than-there-is = der lineare Kreis verlangt entlang der Welle eine Reibung von { $used }, wo es { $friction } gibt: ein wirkliches Rad gleitet dort, und seine größte Beanspruchung ist kleiner und an anderer Stelle; ein Lauf in der Zeit hält sich an die Reibung
shakedown-beyond-friction = über einem ausgenutzten Kraftschluss von 0,6 sind diese Grenzen mit nichts verglichen
shakedown-of-mean = mittlerer Zustand: p₀/k = { $pressure } bei k = { $shear } MPa, ausgenutzter Kraftschluss { $friction }, Beanspruchung { $demand }, Oberflächenermüdungsindex { $index }
utilised-friction = ausgenutzter Kraftschluss
limit-elastic = elastische Grenze
limit-line = Shakedown, Linienkontakt
limit-surface = an der Oberfläche
limit-subsurface = darunter
limit-subsurface-at-floor = darunter, zur Oberfläche hin
phase-of-wave = Phase °
pressure-over-yield = p₀/k
surface-fatigue-index = Oberflächenermüdungsindex
demand-of-flow = Beanspruchung
demand-is-largest-at = die Beanspruchung ist am größten, { $demand }, { $phase }° nach dem Wellenberg, und auf { $share } % der Welle über eins
stress-has-no-maximum-below = Zeilen „darunter, zur Oberfläche hin“ sind bei { $depth } der kleineren Halbachse am größten, wo die Suche beginnt: von dort steigt die Spannung weiter zur Oberfläche, und darunter hat sie kein größeres Maximum
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
contact-title = Kontakt
ellipse-of-contact = Ellipse { $along } mm längs und { $across } mm quer zur Schiene, Annäherung { $approach } µm
pressure-and-stiffness = größter Druck { $pressure } MPa, Steifigkeit { $stiffness } MN/m
kalker-coefficients = Beiwerte nach Kalker C₁₁ = { $c11 }, C₂₂ = { $c22 }, C₂₃ = { $c23 }, C₃₃ = { $c33 }
mean-state-along-rail = mittlerer Zustand nach half-space: Kraftschlussausnutzung { $ratio } beim Schlupf von { $creepage } %
mean-state-by-law = mittlerer Zustand nach { $law }: { $along } kN längs und { $across } kN quer zur Schiene, Kraftschlussausnutzung { $ratio }{ $moment }{ $energy }
with-spin-moment = , Bohrmoment { $moment } Nm
with-energy-per-metre = , { $energy } J/m dissipiert
no-slope-near-full-slip = nahe dem vollen Gleiten gibt es keine Steigung und keinen Frequenzgang
tractive-ratio-over-creepage = Kraftschlussausnutzung Q/μP
creepage-column = Schlupf
receptance-title = Rezeptanz
no-resonance-to-name = keine Resonanz zu nennen: die Schiene hat keine bekannte Stützung
no-peak-or-dip = keine Spitze und kein Tal der gemessenen Rezeptanz ragt aus ihrer Umgebung und ihrem Rauschen
resonance-column = Resonanz
resonance-of = von
damping-column = Dämpfung %
lines-column = Linien Hz
least-of-rail-wheel-and-contact = Schiene, Rad und Kontakt: am kleinsten
rail-in-mid-span = Schiene in Feldmitte
rail-over-support = Schiene über dem Stützpunkt
p2-in-closed-form = P2 in geschlossener Form: { $frequency } Hz, { $wheel } kg des Rades und { $track } kg des Gleises auf { $stiffness } MN/m von Gleis und Kontakt
kind-and-frequency = { $kind } { $frequency } Hz
across-the-track = quer zum Gleis, ungedämpft: { $named }
decay-at = { $frequency } Hz { $rate }
decay-rates = Abklingrate dB/m: { $rates }
wheelset-title = Radsatz
wheelset-was-measured = gemessen: seine Eigenfrequenzen sind die Spitzen seiner Rezeptanzen
wheelset-is-rigid = ein freier starrer Körper: er hat keine Eigenfrequenz
natural-frequency-column = Eigenfrequenz Hz
mode-column = Eigenform
wheelset-in-a-curve = Radsatz im Bogen
bogie-in-a-curve = Drehgestell im Bogen
vehicle-in-a-curve = Fahrzeug im Bogen
acceleration-and-power = unausgeglichene Beschleunigung { $acceleration } m/s2, Reibleistung { $power } W
shift-column = Verschiebung mm
yaw-column = Wendewinkel mrad
angle-of-attack-column = Anlaufwinkel mrad
wheel-on-rail = { $wheelset } { $rail }
second-contact-of = { $wheel }, zweiter
creepage-along-column = Schlupf längs %
residual-without-straight-track = größter Rest { $residual } der Last eines Rades; gerades Gleis führt nicht hierher, andere Anfänge tun es
residual-from-straight-track = größter Rest { $residual } der Last eines Rades, in { $steps } Schritten von geradem Gleis aus
wheelset-on-two-points = Radsatz { $wheelset } steht auf zwei Punkten des Rades { $rail }, { $share } % ihrer Normalkräfte auf dem zweiten
shifts-in-millimetres = { $shifts } mm
no-other-equilibrium = kein anderes Gleichgewicht gefunden
other-equilibria = andere Gleichgewichte, Radsätze verschoben um { $shifts }
point-of-loop = { $wavelength } mm bei { $speed } km/h: { $frequency } Hz
contact-at-point = Kraftschlussausnutzung { $ratio }, Schlupf { $creepage }{ $full_slip }, Kontakt { $length } × { $width } mm
creepage-along-rail = { $creepage } %
creepage-on-axes = { $along } % längs und { $across } % quer, Bohrschlupf { $spin } 1/m
full-slip-from = {" "}(volles Gleiten ab { $creepage } %)
oscillation-column = Schwingung mit exp(+iωt)
amplitude-column = Amplitude
unit-column = Einheit
phase-column = Phase
receptance-of-rail = Rezeptanz der Schiene
receptance-of-wheel = Rezeptanz des Rades
oscillating-normal-force = Normalkraft P₁
oscillating-tangential-force = Tangentialkraft Q₁
oscillating-angular-velocity = Winkelgeschwindigkeit Ω₁
oscillating-lateral-force = Querkraft
dissipation-at-wheel = Dissipation am Rad W₁
dissipation-at-rail = Dissipation an der Schiene
dissipation-normalised = normiert, Ŵ₁
loop-oscillates-by-itself = der Regelkreis schwingt von selbst, und die Rate besagt nichts
doubles-in-passages = wächst: verdoppelt sich in { $passages } Überfahrten
neither-grows-nor-decays = wächst weder noch klingt es ab
halves-in-passages = klingt ab: halbiert sich in { $passages } Überfahrten
growth-at-point = Re Ŵ₁ = { $dissipation }, Wachstumsrate { $rate } je Überfahrt: { $verdict }
law-column = Gesetz
growth-per-passage-column = Wachstum je Überfahrt
depth-per-passage-column = Tiefe je Überfahrt nm
demand-at-point = Beanspruchung { $demand }, am größten { $phase }° nach dem Wellenberg, und an ihrer Grenze bei einer Amplitude von { $amplitude } µm
wheel-column = Rad
normal-force-in-kilonewton = Normalkraft kN
smooth-rail = glatt
growth-with-neighbours = mit den überfahrenen Stützpunkten, Wachstumsrate je Überfahrt: { $alone } der Welle allein, { $pattern } des am schnellsten wachsenden Musters
share-of-pattern = Anteil am Muster
pattern-is-highest = das Muster ist { $place } mm von einem Stützpunkt am höchsten, { $modulation }-mal so hoch wie an seiner niedrigsten Stelle
supports-that-scatter = { $supports } Stützpunkte in Abständen, die um { $deviation } mm streuen, Startwert { $seed }
growth-rate-per-passage-column = Wachstumsrate je Überfahrt
highest-at-each-speed = höchstes Wachstum bei jeder Geschwindigkeit, { $shortest }–{ $longest } mm
speed-column = Geschwindigkeit km/h
decays-in-table = klingt ab
edge-in-table = Rand
profile-column = Profil
from-millimetres-column = von mm
to-millimetres-column = bis mm
radius-at-origin-column = Radius bei x = 0 mm
straight-profile = gerade
wheelset-on-its-track = Radsatz auf seinem Gleis
amplitude-in-millimetres-column = Amplitude mm
equivalent-conicity-column = äquivalente Konizität
conicity-with-roll-column = mit Rollen
conicity-harmonic-column = harmonisch
conicity-regression-column = Regression
wavelength-in-metres-column = Wellenlänge m
no-motion = keine Bewegung
endless-wavelength = endlos
conicity-by-standard = äquivalente Konizität nach EN 15302, für eine Achse, die waagerecht bleibt; mit Rollen: wie sie rollt, wo beide Räder berühren, was an Flanken zählt
wheels-under-load = Räder unter je { $load } kN
length-in-millimetres-column = Länge mm
width-in-millimetres-column = Breite mm
peak-pressure-column = Spitze MPa
conformal-pressure-column = konform MPa
hertz-pressure-column = Hertz MPa
approach-column = Annäherung µm
stiffness-column = Steifigkeit MN/m
wear-as-written = Verschleiß gegenüber { $nominal }, wie die Koordinaten sind
wear-laid-by-flange = Verschleiß gegenüber { $nominal }, quer zum Gleis an den Spurkranzrücken und nach oben an die Spurkranzkuppe gelegt
wear-laid-by-field-side = Verschleiß gegenüber { $nominal }, an die Feldseite gelegt, wo sie steiler als 20° ist
tread-wear-column = Laufflächenverschleiß mm
flange-height-column = Spurkranzhöhe Sh mm
flange-thickness-column = Dicke Sd mm
w1-column = W1 senkrecht mm
w2-column = W2 seitlich mm
w3-column = W3 unter 45° mm
deepest-column = am tiefsten mm
area-column = Fläche mm2
normal-force-between = Normalkraft { $least } bis { $largest } kN; { $contact }
always-in-contact = immer in Berührung
no-contact-for = { $share } % der Zeit ohne Berührung
wheel-over-a-sinusoid = Rad über einem Sinus
wave-and-speed = { $wavelength } mm und { $amplitude } µm bei { $speed } km/h, { $frequency } Hz
harmonic-column = Harmonische
creep-force-column = Schlupfkraft kN
creepage-in-percent-column = Schlupf %
dissipation-column = Dissipation J/m
lateral-force-column = Querkraft kN
lateral-creepage-column = Querschlupf %
dissipation-at-the-rail-column = an der Schiene J/m
wheel-along-a-profile = Rad entlang eines Profils
length-of-passage = { $length } m ab { $start } m bei { $speed } km/h, ein Vorlauf von { $run_in } m davor, Schritte von { $step } mm
means-of-passage = mittlerer Schlupf { $creepage } %, mittlere Dissipation { $dissipation } J/m
wheels-on-a-smooth-rail = Räder auf glatter Schiene
smooth-rail-at = glatte Schiene bei { $speed } km/h, { $seconds } s: { $outcome }; { $linear }
limit-cycle-of = ein Grenzzyklus von { $frequency } Hz
no-settled-period = keine feste Periode, sich selbst ähnlich bei { $frequency } Hz
wheels-slide-off = die Räder gleiten davon
push-dies-out = der Anstoß klingt ab
linear-loop-stable = der lineare Regelkreis ist stabil
linear-loop-grows = der lineare Regelkreis ist nahe { $frequency } Hz instabil, wo er in { $seconds } s auf das e-Fache wächst
linear-loop-unstable-near = der lineare Regelkreis ist nahe { $frequency } Hz instabil
linear-loop-unstable = der lineare Regelkreis ist instabil
linear-loop-not-judged = der lineare Regelkreis lässt sich nicht beurteilen
from-one-to-another = { $least } bis { $most }
lateral-in-kilonewton-column = quer kN
lateral-in-percent-column = quer %
stick-column = Haften %
rail-under-many-wheels = Eine Schiene unter vielen Rädern
passages-over-rail = { $passages } Überfahrten über { $length } m bei { $speed } km/h in Schritten von { $step } mm
passing-vehicle = {"  "}{ $share } %  { $name }, { $speed } ± { $deviation } km/h
level-column = Pegel dB
level-at-end-column = am Ende
linear-column = linear
growth-of-level-column = Wachstum dB/10⁶
last-quarter-column = letztes Viertel
drift-column = Drift mm/10⁶
so-many-decibels = { $level } dB
no-level-yet = nichts
waves-between-supports = Wellen, die zwischen zwei Stützpunkte passen: von { $first } bis { $last }
wheel-leaves-rail-from = das Rad verlässt die Schiene ab { $passages } Überfahrten
worn-off-everywhere = überall abgetragen { $depth } µm
last-normal-force = letzte Normalkraft { $least } bis { $largest } kN; { $contact }
wavelength-at-level = { $wavelength } mm bei { $level } dB
no-band-has-stopped = kein Band hat aufgehört zu wachsen
bands-have-stopped = nicht mehr gewachsen: { $bands }
passages-kept = nach { $passed } von { $passages } Überfahrten angehalten, die in { $file } liegen; derselbe Befehl rechnet von dort weiter
passages-stopped = nach { $passed } von { $passages } Überfahrten angehalten
going-on-after = weiter nach { $passages } Überfahrten, aus { $file }
rail-of-whole-bays = Hinweis: die Schiene ist { $length } m lang, ganze Felder von { $bay } m, damit ihr Ende an ihren Anfang passt
bands-below-patch-left-out = Hinweis: { $bands } Bänder unter { $length } mm bleiben weg: der Kontakt ist so lang und mittelt sie
levels-after-passages-taken = Hinweis: von den Pegeln werden die nach { $passages } Überfahrten genommen
longest-stretch-taken = von { $stretches } lückenlosen Abschnitten wird der längste genommen, ab { $start } m
growth-over-the-bay = über das Feld bei { $wavelength } mm und { $speed } km/h: Wachstumsrate { $support } über einem Stützpunkt, { $span } in Feldmitte, { $mean } im Mittel (quasistatisch im Ort: Linien, die schärfer als { $passing } Hz sind, die Folge der Stützpunkte, sind überschätzt)
branches-over-the-bay = im Mittel über das Feld: { $branches }
so-many-observations = { $count ->
        [one] 1 Beobachtung
       *[other] { $count } Beobachtungen
    }
observations-outside = { $all }, { $outside } außerhalb der Karte
mean-column = Mittel
least-column = kleinste
tenth-column = ein Zehntel
nine-tenths-column = neun Zehntel
largest-column = größte
equal-distances = gleiche Abstände
drawn-distances = gezogen
parameter-column = Parameter
value-column = Wert
growth-for-one-percent = Wachstum bei +1 %
rates-follow-amplitude = Wachstumsraten hängen nach Schadensgesetzen von der Amplitude ab: die genannten gelten bei { KEY("corrugation.amplitude") }, { $amplitude } µm, Pegel werden schrittweise gerechnet
fit-scales-all-damage = Wachstum geschieht nach Schadensgesetzen neben dem Verschleiß, deren Tiefen keine Messung gesagt hat: Zeiten gelten für { KEY("damage") }, wie es geschrieben steht, und haben keine Spanne; ein an Messungen angepasster Verschleißbeiwert verändert sie alle
models-leave-damage-out = Modelle der Literatur stehen ohne die Gesetze von [damage], die keiner ihrer Autoren hat
action-none = bleibt, wie es ist
action-column = Maßnahme
decision-on-doubtful-chains = die Ketten lassen { $doubts } Zweifel, die riffel calibrate nennt: mit mehr Ziehungen kann sich die Reihenfolge ändern
over-limit-costs-nothing = ein Monat über dem Grenzwert kostet hier nichts; ein festes Intervall ist so umso billiger, je länger es ist: { KEY("cost.over_limit") } angeben
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
posterior-forecast-is-linear = die Pegel sind die des linearen Wachstums, und was im Modell abklingt, sinkt, während riffel forecast ohne { KEY("--posterior") } es hält; wo das Rad die Schiene verlässt, wird über eine Posteriorverteilung nicht gesagt
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
told-as-a-product = die Daten sagen über { $one } und { $other } nur zusammen etwas, als Produkt von Potenzen (r = { $correlation }): keiner von beiden darf allein in einen Fall geschrieben werden
told-as-a-ratio = die Daten sagen über { $one } und { $other } nur zusammen etwas, als Quotient von Potenzen (r = { $correlation }): keiner von beiden darf allein in einen Fall geschrieben werden
calibration-allows-no-conclusion = die Ketten erlauben keinen Schluss, wegen { $doubts } Zweifeln, die bei ihnen stehen: mehr Ziehungen können sie ausräumen
chains-take = das Modell braucht { $seconds } s für einen Satz von Werten: die Ketten brauchen rund { $minutes } min, und länger, wenn sie weitergehen
chains-go-on = die Ketten lassen noch keinen Schluss zu und gehen weiter, bis jede { $draws } Ziehungen hat
chains-disagree = die Ketten sind über { $value } uneins: R̂ ist { $rhat }, darf aber höchstens { $most } sein; mehr Ziehungen nehmen, oder { $other }
look-for-a-second-way = einen zweiten Weg suchen, auf dem das Modell zu den Daten passt
populations-find-both-ways = wo sich die Daten auf zwei Wegen treffen lassen, sampler.kind = "smc" nehmen, das beide findet
too-few-effective-draws = { $value } hat { $draws } wirksame Ziehungen, braucht aber { $least }; mehr Ziehungen nehmen
trajectories-ran-away = { $trajectories } Bahnen sind entwichen: die Ziehungen lassen einen engen Teil der Nachverteilung aus; länger einlaufen lassen oder Vorverteilungen wählen, die ihn meiden
tails-are-not-reached = die Energie der Ketten bewegt sich um { $moves } ihrer Streuung, muss sich aber um { $least } bewegen: die Ausläufer sind nicht erreicht
calibration-tells-nothing = aus den Daten geht keiner der { $count } Werte hervor: jeder ist so unsicher wie zuvor
calibration-tells-all = durch die Daten werden alle { $count } Werte um { $least } bis { $most } % enger, am meisten { $best }
calibration-tells-some = aus den Daten gehen { $told } von { $count } Werten hervor, am besten { $best }; nicht hervor geht { $untold }
outlying-above = { $datum } ({ $data }) liegt { $deviations } Standardabweichungen über dem, was alle anderen Daten davon sagen; der Wert bleibt unter ihnen: zu prüfen ist, wie gemessen wurde oder was dem Modell dort fehlt
outlying-below = { $datum } ({ $data }) liegt { $deviations } Standardabweichungen unter dem, was alle anderen Daten davon sagen; der Wert bleibt unter ihnen: zu prüfen ist, wie gemessen wurde oder was dem Modell dort fehlt
datum-receptance = |H| bei { $at } Hz
datum-phase = die Phase von H bei { $at } Hz
datum-wear = der Verschleiß unter { $mgt } Mio. Bruttotonnen
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

## The report

keys-have-no-effect = { $count ->
        [one] { $keys } hat keine Wirkung, denn { $reason }
       *[other] { $keys } haben keine Wirkung, denn { $reason }
    }
variant-cannot-act = "{ $title }" kann auf diesen Fall nicht wirken: { $reasons }
variant-changes-nothing = "{ $title }" ändert nichts: das Wachstum ist bis zur letzten Stelle das des Falls
variant-acts-in-part = von "{ $title }" wirkt nur ein Teil: { $reasons }
growth-of-the-level = Wachstum des Pegels nach Wellenlänge, positiv, wo Riffeln wachsen
after-grinding = nach dem Schleifen
now = jetzt
rail-when = { $rail } { $time }
in-quotes = „{ $words }“
levels-after = Pegel nach { $passages } Achsüberrollungen, { $tonnes } Mio. t, wie er ist
levels-of-rail-as-it-is = die Pegel sind die von { $rail }, die führt, wie er ist
forecast-ends-before = davor, wo das Rad von der Schiene abhebt und die Prognose endet: { $titles }
comparison = Vergleich
keeps-tractive-ratio = "{ $title }" behält die Kraftschlussausnutzung: die Zugkraft ändert sich mit Reibung und Last; { KEY("--hold") } force behält die Kraft
fastest-in-millimetres = am schnellsten mm
decibels-per-million-passages = dB je 10⁶ Überrollungen
change-head = Änderung
held-head = gehalten
ridge-in-hertz = Grat Hz
passages-to-limit-head = Überrollungen bis Grenze
tonnes-to-limit-head = Mio. t bis Grenze
months-to-limit-head = Monate bis Grenze
at-edge-of-lines = { $wavelength } (Rand)
cannot-act = kann nicht wirken
cannot-be-told = ist nicht zu sagen
changes-nothing = ändert nichts
held-mixed = verschieden
held-force = Kraft
held-ratio = Ausnutzung
held-creepage = Schlupf
as-it-is = wie er ist
growth-ridge-is-no-candidate = der Wachstumsgrat ist nicht unter den Kandidaten: { $reason }
track-known-up-to = bei { $speeds } ist das Gleis bis { $longest } mm bekannt, und Wellen unter 1,5 Kontaktlängen, { $shortest } mm, bleiben ungesehen
share-of-belief = Anteil am Glauben, wenn jeder Mechanismus der Liste, und einer außerhalb, vorher gleich wahrscheinlich ist; er vergleicht die Kandidaten nach den genannten Gründen und ist keine Wahrscheinlichkeit, dass ein Befund stimmt
measured-word = gemessen
given-word = gegeben
trend-of-neighbours = Trend der Nachbarn
fine-level-axis = Pegel je 1/24 Oktave [dB re 1 µm]
how-fine-bands-are = Bänder von 1/24 Oktave, wenigstens eine Linie der Transformation breit; Trend der ersten Kurve.
level-axis = Pegel [dB re 1 µm]
means-of-levels = Mittel der Terzpegel.
perhaps-made-by = { $wavelength } mm: { $mechanism }?
dominant-wavelengths = Vorherrschende Wellenlängen
caption-of-diagnosis = { $file }: { $record }. { $bands } An jeder Wellenlänge steht der führende Kandidat; die Liste nennt die anderen und die Gründe.
dominant-wavelength-at = vorherrschende Wellenlänge { $wavelength } mm ({ $band } mm), { $place }, { $frequency } Hz bei { $speeds }
dominant-wavelength = vorherrschende Wellenlänge { $wavelength } mm ({ $band } mm), { $frequency } Hz bei { $speeds }
rail-all-along = { $rail }, durchgehend
rail-from-to = { $rail }, { $from }–{ $to } m
more-places = { $count ->
        [one] { $place } und an einem weiteren Ort
       *[other] { $place } und an { $count } weiteren Orten
    }
scatter-of = Streuung { $scatter } dB
scatter-unknown = Streuung unbekannt, nur ein Spektrum
level-of-record = Pegel { $level } dB re 1 µm, Messung { $record }
level-of-peak = Pegel { $level } dB re 1 µm
level-of-rail = { $name } { $level }
with-levels-of-rails = { $level } ({ $rails })
stands-over-its-trend = { $level }, { $prominence } dB über dem Trend seiner Nachbarn ({ $scatter })
by-chance-in-a-million = zufällig in weniger als einem von einer Million Spektren
by-chance = zufällig in einem von { $spectra } Spektren
harmonic-of = Harmonische { $order } von { $wavelength } mm
means-of-energies = Mittel der Energien { $levels }
beside-wave = kommt mit { $wavelength } mm
comes-with-wave = Sie kommt mit { $wavelength } mm, die von Stützpunkt zu Stützpunkt an- und abschwillt (Seitenband { $order } von Stützpunkten im Abstand von { $spacing } m). Zu suchen ist die Ursache jener Welle.
gone-by-grinding = Durch Schleifen beseitigt: Der Pegel fiel um { $fall } dB vor { $record }, und seitdem ragt die Welle aus keiner Messung heraus. Was sie gemacht hatte:
beside-stand = { $count ->
        [one] Daneben steht { $wavelengths }: Die Welle schwillt von Stützpunkt zu Stützpunkt an und ab.
       *[other] Daneben stehen { $wavelengths }: Die Welle schwillt von Stützpunkt zu Stützpunkt an und ab.
    }
candidate-leads = { $first } führt mit einem Anteil von { $share }, dann folgt { $second } mit { $other }.
level-falls-as-grinding-mark = Der Pegel fällt mit einer Wahrscheinlichkeit von { $percent }, wie es eine abklingende Schleifspur tut und eine wachsende Riffel nicht. Am ehesten eine abklingende Schleifspur und keine wachsende Riffel.
level-falls = Der Pegel fällt mit einer Wahrscheinlichkeit von { $percent }, wie es eine abklingende Spur tut und eine wachsende Riffel nicht.
level-rises = Der Pegel steigt mit einer Wahrscheinlichkeit von { $percent }, wie es eine Riffel unter Verkehr tut und eine Schleifspur nicht.
rise-is-open = Ob der Pegel steigt, ist offen (Wahrscheinlichkeit { $percent } %).
one-record-since-ground = Der Pegel fiel wie durch Schleifen, und eine Messung seitdem sagt nicht, ob er wächst.
one-record-only = Es gibt nur eine Messung: Ob sie wächst, ist nicht bekannt.
two-sentences = { $one } { $other }
mechanism-of = { $mechanism }, { $wheel }
more-than-999-per-mille = mehr als 99,9 %
percent-of = { $percent } %
speeds-of-the-usual-traffic = die Geschwindigkeiten sind die von { $traffic }
explains-any-wavelength = Sie erklärt jede Wellenlänge und jeden Verlauf, keinen davon gut.
patch-averages = Die Kontaktfläche mittelt über so kurze Wellen: von { $wavelength } lässt sie { $percent } % durch.
higher-than-ground = Schleifen wird bei solchen Wellenlängen bis { $accepted } µm Effektivwert abgenommen (Grassie, Saxon & Smith 1999); diese Welle hat { $rms } µm.
trolley-measures-rail-alone = Ein Messwagen von Hand misst die Schiene allein, und Räder vieler Durchmesser prägen ihr kein gemeinsames Muster ein.
known-with-damping = Dämpfung { $ratio } %, ±{ $spread } %
known-to = ±{ $spread } %
frequency-makes = { $frequency } Hz ({ $known }) ergibt { $range } bei { $speeds }; gemessen { $measured }, also { $frequencies }.
case-grows-at-measured = Bei { $speeds } wächst der Fall am schnellsten bei { $wavelength } ({ $rate } je Überrollung); bei { $measured } wächst er um { $own }, das sind { $percent } % davon.
case-decays-at-measured = Bei { $speeds } wächst der Fall am schnellsten bei { $wavelength } ({ $rate } je Überrollung); bei { $measured } klingt er um { $own } ab.
case-lets-nothing-grow = Bei { $speeds } lässt der Fall keine Wellenlänge wachsen, auch { $measured } nicht.
measured-outside-growth = { $measured } liegt außerhalb der Wellenlängen, bei denen der Fall wachsen kann: die seiner Karte, und nicht unter 1,5 Kontaktlängen.
wavelengths-at-any-speed = Ihre Wellenlängen sind { $range }, wie schnell der Verkehr auch fährt; gemessen { $measured }.
order-of-length = { $length } durch { $order } ist { $nearest }, das { $ratio }-fache der gemessenen { $measured }, wie schnell der Verkehr auch fährt.
marks-fade-under-traffic = Bearbeitungsspuren klingen unter Verkehr ab; dieser Pegel: { $course }.
corrugation-grows-under-traffic = Riffeln wachsen unter Verkehr; dieser Pegel: { $course }.
measure-at-other-speed = Geschwindigkeit: dort messen, wo dieselben Züge ein Fünftel langsamer fahren. Eine feste Frequenz ({ $frequencies }) stünde dort bei { $moved } mm, eine Spur oder Ordnung einer Länge wie hier bei { $wavelength } mm
in-weeks-moves = in { $weeks } Wochen bewegt der jetzige Verlauf den Pegel um das Dreifache seiner Streuung
intervals-move = { $records } Abstände zwischen diesen Messungen bewegen den Pegel um das Dreifache seiner Streuung
after-three-months = nach drei Monaten und noch einmal nach sechs, an derselben Stelle
measure-again = Zeit: diese Messung wiederholen ({ $when }). Eine Riffel steigt, eine Schleifspur fällt
year = Jahr
record = Messung
course-since-ground = { $levels } dB re 1 µm: fiel um { $fall } dB vor { $record }, wie durch Schleifen; seitdem { $since }
course-ends-ground = { $levels } dB re 1 µm: fiel um { $fall } dB vor { $record }, durch Schleifen oder wie eine Schleifspur verschwindet
course-of-two-is-open = { $levels } dB re 1 µm: Zwei Messungen sagen nicht, ob er steigt, { $slope } ± { $scatter } dB je { $unit }
course-of-two-rises = { $levels } dB re 1 µm: steigt, { $slope } ± { $scatter } dB je { $unit }
course-of-two-falls = { $levels } dB re 1 µm: fällt, { $slope } ± { $scatter } dB je { $unit }
course-falls = { $levels } dB re 1 µm: fällt jedes Mal, { $slope } ± { $scatter } dB je { $unit }
course-rises = { $levels } dB re 1 µm: steigt jedes Mal, { $slope } ± { $scatter } dB je { $unit }
course-is-open = { $levels } dB re 1 µm: steigt und fällt nicht jedes Mal, { $slope } ± { $scatter } dB je { $unit }
after-tonnes = nach { $tonnes } Mio. t
after-tonnes-at-end = nach { $tonnes } Mio. t, wo die Prognose endet
by-vehicle = durch { $vehicle }, { $percent } %
mix-of-vehicles = Mischung
caption-of-forecast = Nach { $amount }. Terzpegel; Wachstum des Pegels nach Wellenlänge, positiv, wo Riffeln wachsen: was jede Fahrzeugart beiträgt und ihre Summe. Die Prognose endet, wo das Rad von der Schiene abhebt.
levels-of-leading-rail = Die Pegel sind die von { $rail }, die führt.
growth-forecast = Wachstumsprognose
months-axis = Monate
million-passages-axis = 10⁶ Achsüberrollungen
crest = Wellenberg
falling-flank = fallende Flanke
trough = Wellental
rising-flank = steigende Flanke
cracks-at = Risse bei { $wavelength } mm
crack-axis = Länge eines Risses [mm]
growth-axis = Wachstum [dB je 10⁶ Überrollungen]
rail-leads = { $rail } führt: { $sentence }
bands-not-forecast = nicht vorhergesagt: { $count } Bänder von { $first } bis { $last } mm, die außerhalb von { KEY("map.wavelength") } des Falls liegen
grinding-interval-from = Schleifintervall ab { $ground }
grinding-interval = Schleifintervall
over-the-limit-now = jetzt über der Grenze: { $edition } bei { $wavelength } mm um { $decibels } dB
mean-over-the-record = { $sentence }, im Mittel über die Messung; Stellen über dem Mittel erreichen ihn früher
limit-reached-after = { $edition } ist bei { $wavelength } mm erreicht nach { $amount }
no-band-reaches = kein vorhergesagtes Band erreicht je { $edition }
limit-reached-without-time = { $edition } ist zuerst bei { $wavelength } mm erreicht; in welcher Zeit, ist nicht zu sagen: { $reason }
limit-not-reached-before = { $edition } ist nicht erreicht, bevor das Rad von der Schiene abhebt, wo die Prognose endet
beyond-linear-range-now = jetzt außerhalb des linearen Bereichs: |P₁| ist { $ratio } P₀ unter "{ $vehicle }", Rad und Schiene trennen sich also; dann wächst die Riffel anders, als der lineare Kreis sagt, und nichts wird vorhergesagt
linear-range-ends = linearer Bereich: |P₁| ist jetzt { $ratio } P₀ und erreicht P₀ unter "{ $vehicle }" nach { $amount }; dort hebt das Rad von der Schiene ab, und die Prognose endet
linear-range-never-ends = linearer Bereich: |P₁| ist jetzt { $ratio } P₀ unter "{ $vehicle }" und erreicht P₀ nie
amount-with-date = { $passages } Achsüberrollungen = { $tonnes } Mio. t = { $months } Monate ({ $date })
amount-with-months = { $passages } Achsüberrollungen = { $tonnes } Mio. t = { $months } Monate
amount-of-traffic = { $passages } Achsüberrollungen = { $tonnes } Mio. t
rail-not-forecast = { $rail } hat kein Band zwischen { $from } und { $to } mm, { KEY("map.wavelength") } des Falls, und bleibt weg
wavelength-in-millimetres = Wellenlänge [mm]
median = Median
forecast = Prognose
caption-of-posterior-forecast = { $draws } Ziehungen der Nachverteilung; Monate bis zur Grenze: { $months }.
at-the-last-date = am letzten Datum
months-later = { $months } Monate später
growth-goes-by-this-rail = das Wachstum rechnet mit dem Verschleißbeiwert dieser Schiene, { $coefficient } kg/J, { $interval }: Er ist an das angepasst, was sich über { $passages } Überrollungen geändert hat; der Fall hat { $given } kg/J
interval-of-coefficient = 95-%-Intervall { $low } bis { $high } kg/J
coefficient-is-fitted = Verschleißbeiwert { $coefficient } kg/J, { $interval }
forecast-with-coefficient = Prognose mit diesem Beiwert durch { KEY("--set") } { KEY("wear.coefficient") }={ $value }
no-coefficient-nothing-grows = kein Verschleißbeiwert: von keinem gemessenen Band sagt das Modell, dass es wächst
no-coefficient-nothing-moved = kein Verschleißbeiwert: die Bänder, die nach dem Modell wachsen sollten, haben sich nicht bewegt
no-coefficient-bands-fell = kein Verschleißbeiwert: die Bänder, die nach dem Modell wachsen sollten, sind gefallen: die Schiene wurde zwischen den beiden Daten geschliffen, oder auf ihr ist nicht die Riffel dieses Modells
no-coefficient-not-grown = kein Verschleißbeiwert: die Bänder, die nach dem Modell wachsen sollten, sind nicht mehr gewachsen, als Pegel streuen
no-coefficient-indistinct = kein Verschleißbeiwert: das Wachstum ist von keinem nicht zu unterscheiden, { $interval }
no-coefficient-claimed = kein Verschleißbeiwert wird behauptet: Ein Intervall braucht drei Messungen von jedem Datum oder 30 m Profil; am besten passt { $coefficient } kg/J
band-fades-against-model = { $wavelength } mm wächst nicht, wie es das Modell sagt: { $measured } dB gemessen, { $predicted } dB vorhergesagt; es klingt ab
band-grows-against-model = { $wavelength } mm wächst, wo es nach dem Modell abklingt: { $measured } dB gemessen, { $predicted } dB vorhergesagt
band-fades-as-in-model = { $wavelength } mm klingt ab, { $measured } dB gemessen, und auch im Modell, { $predicted } dB: was abklingt, ist keine wachsende Riffel
band-grows-unlike-fit = { $wavelength } mm wächst nicht, wie es die Anpassung sagt: { $measured } dB gemessen, { $fitted } dB angepasst
beyond-linear-range = außerhalb des linearen Bereichs
never = nie
number-alone = { $number }
noise-beside-the-track = Rollgeräusch neben dem Gleis
caption-of-noise = Äquivalenter Pegel über die Vorbeifahrt bei { $speed }, { $distance } m von der Gleismitte und { $height } m über der Schiene, re 20 µPa, Terzen ohne Bewertung. { $parameters }
level-a-weighted = { $level } dB(A)
part-and-level = { $part } { $level }
what-would-help = was hülfe, jedes allein
limit-word = Grenze
under-traffic = unter Verkehr
time-axis-in-months = Zeit [Monate]
level-axis-a-weighted = Pegel [dB(A)]
level-axis-in-decibels = Pegel [dB]
grinding-shifts = { $count ->
        [one] 1 Schleifschicht
       *[other] { $count } Schleifschichten
    }
grinding-costs-a-year = { $length } m Strecke zu schleifen kostet { $shifts } und { $cost } { $currency }, { $yearly } { $currency } im Jahr, wenn alle { $months } Monate geschliffen wird
grinding-costs = { $length } m Strecke zu schleifen kostet { $shifts } und { $cost } { $currency }
input-head = Eingabe
file-head = Datei
what-it-is-head = was es ist
growth-map = Wachstumskarte
speed-axis-in-kilometres-per-hour = Geschwindigkeit V [km/h]
strongest-growth-at-each-speed = stärkstes Wachstum bei jeder Geschwindigkeit
strongest-at-edge = am stärksten am Rand des Fensters
frequency-of-strongest-branch = feste Frequenz des stärksten Astes
branches-of-growth = Äste des Wachstums
constant-frequency = feste Frequenz V = fλ
neither-growth-nor-decay = weder Wachstum noch Abklingen
not-computed = nicht berechnet
rail-and-group = { $rail }, { $group }
measured-wavelength = gemessen { $wavelength } mm
where-measured-wavelengths-stand = gemessene Wellenlängen bei der langsamsten, mittleren und schnellsten von { $speeds }
outside-the-map = außerhalb der Karte: { $wavelengths }
nothing-stands-out = keine vorherrschende Wellenlänge: nichts ragt mehr als zufällig und über zwanzig Wellen 3 dB über den Trend seiner Nachbarn
diagnosis = Diagnose
share-capital = Anteil
mechanism-head = Mechanismus
source-head = Quelle
valid-for-head = gültig für
sources-and-validity = Quellen und Gültigkeit
course-capital = Verlauf
candidate-head = Kandidat
share-head = Anteil
frequency-in-hertz-head = Frequenz [Hz]
predicts-in-millimetres = sagt vorher [mm]
the-case = der Fall
held-against = verglichen mit: { $title }; Verkehr mit { $speeds }
indented-line = {"  "}{ $line }
course-line = {"  "}Verlauf: { $course }
reason-for = {"  "}dafür:   { $reason }
reason-against = {"  "}dagegen: { $reason }
telling-them-apart = um sie zu unterscheiden
predicts-column = sagt voraus mm
to-tell-them-apart = Was sie unterscheidet
profile = Profil
moving-rms-along-the-line = Gleitender Effektivwert entlang der Strecke
spectrum-and-limits = Spektrum und Grenzen
wavelength-bands = Wellenlängenbänder
what-to-grind = Was zu schleifen ist
what-if = Was wäre, wenn
since-when = Seit wann
why-and-how-sure = Warum, und wie sicher
no-dates-are-told = Daten, Zeiten und was Maßnahmen sparen würden, stehen hier deshalb nicht; unten stehen sie so, wie das Modell sie hat
not-plausible = Nicht plausibel
model-is-of-the-other-rail = der Fall gilt für die andere Schiene des Bogens ({ KEY("contact.from.rail") }) und sagt darum nicht, was das Wachstum dieser senken würde
model-does-not-explain-growth = das Modell erklärt das gemessene Wachstum nicht und kann darum nicht sagen, was es senken würde
what-comes = Was kommt
what-helps = Was hilft
what-is-heard = Was zu hören ist
no-roughness-given = es wurde keine Rauheit angegeben
roughness-not-diagnosed = die Rauheit wurde nicht diagnostiziert
how-bad-and-where = Wie schlimm, und wo
forecast-over-calibration = Prognose über die Kalibrierung
no-case-given = es wurde kein Fall angegeben
what-it-costs = Was es kostet
rail-roughness-and-corrugation = Schienenrauheit und Riffeln
levels-are-no-profile = die Messung ist eine Tabelle von Pegeln; nötig ist ein Profil
course-of-wavelength = { $wavelength }, { $first } bis { $last }: { $course }
no-wavelength-stands-out = aus der Rauheit ragt keine vorherrschende Wellenlänge heraus
wavelength-stands-out-at = { $wavelength } ragt heraus, { $place }, { $level } dB
wavelength-stands-out = { $wavelength } ragt heraus, { $level } dB
limit-of-name = Grenze { $name }
preset-of-name = Vorgabe { $name }
built-in-head = eingebaut
made-by = erstellt von riffel { $version }. Dieselben Dateien und dieselbe Version ergeben denselben Bericht
inputs-and-versions = Eingaben und Versionen
no-warnings = keine
warnings-and-limits-of-models = Warnungen und Grenzen der Modelle
no-level = nichts
train-is-heard = bei { $speed } ist ein Zug mit { $wheels } Rädern auf jeder Schiene, { $length } m lang, zu hören mit { $level }, { $distance } m von der Gleismitte
level-is-of = davon: { $parts }
measure-saves = { $title } { $saved } dB
each-alone-would-save = jedes für sich spart: { $savings }
noise = Rollgeräusch
now-in-decibels = jetzt dB
then-in-decibels = dann dB
limit-in-decibels = Grenze dB
wheel-leaves-the-rail = Rad hebt ab nach
from-ground-to-limit = von { $ground } bis { $edition }
after-amount = nach { $amount }
measured-in-decibels = gemessen dB
model-in-decibels = Modell dB
fitted-in-decibels = angepasst dB
residual-in-decibels = Rest dB
decays-in-the-model = klingt im Modell ab
decays-at-first-in-the-model = klingt im Modell zuerst ab
change-between-records = Änderung über { $passages } Überrollungen zwischen { $earlier } und { $later } Messungen
change-between-paired-records = Änderung über { $passages } Überrollungen zwischen { $earlier } und { $later } Messungen, Ort für Ort
growth-of-the-bands = Wachstum der Bänder, dB je 10⁶ Überrollungen
limit-is-of-the-rail-that-leads = Überrollungen, Mio. t und Monate sind die der genannten Schiene, die führt; summary.json hat jede Schiene
comparison-of-variants = Vergleich
the-traffic = dem Verkehr
levels-after-grinding = Terzpegel unter { $traffic }; jetzt ist nach dem Schleifen auf { $ground }; dann ist nach { $amount }
levels-under-traffic = Terzpegel unter { $traffic }; dann ist nach { $amount }
growth-is-uncertain = Prognose und Was-wäre-wenn: Wachstumsraten sind proportional zu einem Verschleißbeiwert, der auf einen Faktor drei unsicher ist, bis er an zwei datierte Messungen angepasst ist ({ KEY("--earlier") }, { KEY("--dates") })
variant-head = Variante
case-and-variants = der Fall und seine Varianten, { $speeds }
limit-is = Grenze: { $edition }
from-ground = ab { $ground }
held-is = gehalten ist, was eine Änderung von Reibung oder Last lässt, wie es ist: die Zugkraft, die Kraftschlussausnutzung Q₀/μP₀ oder der Schlupf
no-variant-can-act = keine der Varianten kann auf diesen Fall wirken
variant-lowers-most = von den Varianten senkt „{ $title }“ das schnellste Wachstum am meisten, um { $percent } %
no-variant-lowers = keine der Varianten senkt das schnellste Wachstum
with-held = { $sentence } (gehalten: { $held })
without-any-effect = ohne jede Wirkung: { $titles }
limit-is-passed-on = die Grenze ({ $edition }) ist auf { $rail } schon überschritten; { KEY("--ground") } oder { KEY("--from-limit") } sagt, wie lange jede Variante nach dem Schleifen hält
limit-is-passed = die Grenze ({ $edition }) ist schon überschritten; { KEY("--ground") } oder { KEY("--from-limit") } sagt, wie lange jede Variante nach dem Schleifen hält
with-variant = mit „{ $title }“
gross-tonnes = { $tonnes } Mio. t
reached-after = nach { $time } { $variant }
reached-beyond-linear-range = { $variant } nicht, bevor das Rad von der Schiene abhebt
never-reached = { $variant } nie
on-rail = { $sentence } auf { $rail }
limit-is-reached-from = von { $ground } an ist die Grenze ({ $edition }) erreicht { $times }
limit-is-reached = die Grenze ({ $edition }) ist erreicht { $times }
in-brief = In Kürze
not-in-this-report = Nicht in diesem Bericht
line-of-site = Strecke
height-axis = Höhe [µm]
caption-of-heights = Höhen wie gelesen, nach oben positiv, { $from } m bis { $to } m. Je von { $columns } Längen die tiefste und die höchste; Lücken sind Lücken.
caption-of-moving-rms = Höchster gleitender Effektivwert je { $block } m, nach Wellenlängenband; gestrichelt in derselben Farbe: die Grenze des Bands. Die schlechteste Schiene zuerst.
caption-of-levels = Terzpegel nach EN 15610:2009, Verfahren A, ohne { $spikes } und { $pits }; Bänder zur Basis zehn
group-of-spectra = { $name } ({ $count })
caption-of-group-means = Energiemittel über die Spektren jeder Gruppe: { $groups }
dashed-limit = Gestrichelt: { $edition } ({ $source })
within-the-limit = innerhalb der Grenze
over-the-limit = über der Grenze
band-in-millimetres = Band [mm]
rms-in-micrometres = Effektivwert [µm]
highest-moving-rms = höchster gleitender Effektivwert [µm]
highest-peak-to-peak = höchster Spitze-Spitze-Wert [µm]
window-in-metres = Fenster [m]
limit-of-rms = Grenze des Effektivwerts [µm]
length-over-the-limit = Länge über der Grenze
limit-of-bands = Grenze: { $edition } ({ $source })
how-bands-are-filtered = Profil ohne Spitzen, Bandpass ohne Phasendrehung, jede Schiene für sich, die schlechteste zuerst
needs-a-limit-of-rms = nötig ist eine Tabelle von Grenzen des Effektivwerts ({ KEY("--limit") })
no-band-over-its-limit = nichts zu schleifen: kein Band liegt irgendwo über seiner Grenze des gleitenden Effektivwerts ({ $edition })
section-head = Abschnitt
from-in-metres = von [m]
to-in-metres = bis [m]
length-in-metres = Länge [m]
worst-band-in-millimetres = schlimmstes Band [mm]
rms-over-limit = Effektivwert über Grenze [-]
further-sections = { $count } weitere Abschnitte stehen in grind.csv von riffel roughness
how-sections-are-ground = Abschnitte, die höchstens { $merge } m auseinanderliegen, werden als einer geschliffen, und keiner unter { $shortest } m
no-length-over-rms-limits = nirgends ist eine Grenze des Effektivwerts überschritten: nichts zu schleifen
sections-to-grind = { $count ->
        [one] 1 Abschnitt zu schleifen, { $sums }
       *[other] { $count } Abschnitte zu schleifen, { $sums }
    }
sections-at-defects = Abschnitte mit einer Schweißung, einem Stoß oder Squat darunter: { $count }
railway = Bahn
place-of-site = Ort
measured-on = Gemessen am
instrument = Messgerät
author = Verfasser
date-of-report = Datum
caption-of-strip-map = Die Strecke: Rot liegt über der Grenze des RMS und ist zu schleifen; Blau ist eine vorherrschende Wellenlänge; Schwarz ist eine Schweißung, ein Stoß oder Squat.
mechanism-growth-ridge = Wachstumsgrat
mechanism-lateral-pinned-pinned = Pinned-Pinned, lateral
mechanism-grinding-mark = Schleifspur
mechanism-support-spacing = Schwellenfach-Überrollung
mechanism-wheel-circumference = Radumfang
mechanism-unlisted = nicht aufgeführte Ursache
energy-mean = Energiemittel
rail-roughness = Schienenrauheit
caption-of-profile = { $file }: Terzpegel nach EN 15610:2009 (Verfahren A); höchster gleitender Effektivwert je { $block } m, seine Grenze gestrichelt.
position-axis-in-metres = Ort entlang der Schiene [m]
position-axis-in-kilometres = Ort entlang der Schiene [km]
moving-rms-axis = gleitender Effektivwert [µm]
caption-of-means = { $file }: Mittel über die Spektren jeder Gruppe.
mean-of-energies = Mittel der Energien
mean-of-levels = Pegelmittel
worst-within = jede Schiene hält die Grenzen ein; am nächsten liegt ihnen { $rail }
worst-over = am schlechtesten ist { $rail }, über { $count } von { $all } Grenzen
window-shorter-than-wave = ein Fenster von { $window } m ist kürzer als Wellen von { $band }: ein gleitender Effektivwert über weniger als eine Welle geht mit ihr auf und ab und sagt nichts
stretches-too-short-for-band = keine Statistik für { $band } mm: kein Abschnitt ist vier seiner längsten Wellen lang, { $length } m
samples-too-far-for-band = keine Statistik für { $band } mm: die Messpunkte liegen { $step } mm auseinander
rms-unlike-any-rail = ein Effektivwert von { $rms } µm zwischen 30 und 100 mm passt zu keiner Schiene: die Einheit der Höhen prüfen
group-and-rail = { $group }, { $rail }
peak-falls = die Spitze bei { $wavelength } mm, { $levels } dB re 1 µm, fällt jedes Mal: eine feste Wellenlänge, die abklingt, wie es eine Schleifspur tut, und keine wachsende Riffel
peak-rises = die Spitze bei { $wavelength } mm, { $levels } dB re 1 µm, steigt jedes Mal: sie wächst unter Verkehr
peak-stays = die Spitze bei { $wavelength } mm, { $levels } dB re 1 µm, steigt und fällt nicht jedes Mal
sections-over-levels = für sich liegen { $over } von { $all } Abschnitten von { $length } m darüber, am meisten { $place } um { $decibels } dB bei { $wavelength } mm
rail-is-not-measured = es gibt keine Messung der { $rail }
rail-named = Schiene { $name }
verdict-within = { $edition }: innerhalb der Grenze, { $rest }
verdict-over = { $edition }: über der Grenze, { $rest }
all-bands-within = { $all } Bänder; bei { $wavelength } mm bleiben { $room } dB
measured-bands-within = { $measured } gemessene Bänder von { $all }; bei { $wavelength } mm bleiben { $room } dB
bands-over = { $count } von { $all } Bändern, am meisten um { $decibels } dB bei { $wavelength } mm
measured-bands-over = { $count } von { $measured } gemessenen Bändern von { $all }, am meisten um { $decibels } dB bei { $wavelength } mm
share-of-band = { $band } mm { $share } %
length-may-be-over = auf { $allowed } % der Länge darf sie überschritten sein
rail-on-stretch = { $rail }, Teil { $stretch }
stretch-named = Teil { $stretch }
place-on-stretch = { $from }–{ $to } m auf Teil { $stretch }
place-from-to = { $from }–{ $to } m
no-section-over = auf { $allowed } % von je { $length } m darf sie überschritten sein, und auf mehr ist sie es in keinem von { $all } Abschnitten
sections-over = auf { $allowed } % von je { $length } m darf sie überschritten sein, und auf mehr ist sie es in { $over } von { $all } Abschnitten, am meisten { $place } mit { $share } % bei { $band } mm, bis zum { $ratio }-Fachen der Grenze
no-header = kein Kopf
header-of-one-line = ein Kopf von einer Zeile
header-of-lines = ein Kopf von { $count } Zeilen
no-position = kein Ort
falling-position-in-column = Ort in Spalte { $column } [{ $unit }], fallend
position-in-column = Ort in Spalte { $column } [{ $unit }]
rail-in-column = { $name } in Spalte { $column } [{ $unit }]
read-as = gelesen als: { $delimiter }, { $decimal }, { $header }; { $position }; { $rails }
metres-of-rail = { $name } { $length } m
line-of-rails-to-grind = zusammen { $length } m Strecke zu schleifen ({ $rails }), { $share } % der gemessenen Strecke
rail-is-sampled = { $from } m bis { $to } m, { $length } m Schiene alle { $spacing } mm abgetastet; { $spikes } und { $pits } entfernt
rail-is-heard = { $rail }: { $length } m Schiene bei { $slowest } bis { $fastest } km/h, Wellenlängen von { $shortest } bis { $longest } mm
read-as-spectra = gelesen als: { $spectra }
read-as-spectra-of-dates = gelesen als: { $spectra } von { $dates } Tagen, unterschieden durch die Spalte { $column }
means-of-spectra = Pegel in dB re 1 µm: Mittel der Energien | Mittel der Pegel, über so viele Spektren
more-in-grind-file = { $count } weitere in grind.csv
study-word = Studie
first-order-column = erste Ordnung
interval-column = { $percent }-%-Intervall
total-column = gesamt
parameter-alone = { $output } allein
at-percent = bei { $percent } %
at-all-medians = bei allen Medianen: { $value }
output-fails = scheitert
over-the-samples-column = über die Stichproben
samples-column = Stichproben
samples-without-results = { $failed } von { $finished } Stichproben haben keine Ergebnisse:
samples-fail-as = {"  "}{ $count }-mal, wie in: { $example }
chunks-left-to-shards = { $left } von { $chunks } Blöcken bleiben anderen Teilen
study-begins = { $samples } Stichproben von { $parameters } Parametern ({ $method }), { $size } in { $chunks } Blöcken
study-stopped = angehalten: { $finished } von { $chunks } Blöcken sind fertig und bleiben in { $folder }; derselbe Befehl macht dort weiter
samples-computed = { $samples } Stichproben in { $time }, { $rate } je Sekunde
chunk-is-damaged = Hinweis: { $file } ist beschädigt; Block { $chunk } wird neu gerechnet
chunks-are-kept = { $kept } von { $chunks } Blöcken sind fertig und bleiben
study-not-finished = Hinweis: nichts wird ausgewertet, denn { $folder } ist nicht fertig: { $missing } von { $chunks } Blöcken fehlen; riffel study PLAN -o { $folder } rechnet sie, riffel study merge führt Teile zusammen
chunks-merged = { $finished } von { $chunks } Blöcken, { $copied } kopiert
chunks-merged-beside-others = { $finished } von { $chunks } Blöcken, { $copied } kopiert, { $already } waren mit denselben Zahlen schon da
chunks-are-missing = Hinweis: { $count } Blöcke fehlen: { $chunks }; riffel study PLAN -o { $folder } rechnet sie
sobol-indices-need-saltelli = Sobol-Indizes brauchen design.method = "saltelli"; diese Studie hat "{ $method }"
base-samples-left-out = { $count } Grundstichproben bleiben weg: eine ihrer Zeilen hat keine Ergebnisse
bands-need-growth-by-wavelength = Bänder des Wachstums über der Wellenlänge brauchen outputs.growth_by_wavelength
calibration-word = Kalibrierung
told-by-data-column = von den Daten
calibration-stopped = angehalten: fertige Teile der Ketten bleiben in { $folder }; derselbe Befehl mit --restart macht dort weiter
check-stopped = angehalten: die Prüfung beginnt von vorn
chains-of-model = Ketten von „{ $title }“
chains-begin = { $chains } Ketten von { $warmup } + { $draws } Ziehungen von { $parameters } Parametern
sampled-in = gezogen in { $time }
no-data = keine Daten
plan-asks-for = { $data } Daten, { $chains } Ketten von { $warmup } + { $draws } Ziehungen
kind-corrugation = Riffeln
kind-joints = Stöße
kind-welds = Schweißungen oder Squats
kind-ground = geschliffen
kind-unknown = Stöße oder Riffeln
places-go-back = Zeile { $row }: { $rail }: Orte springen von { $end } m auf { $from } m zurück, wie an einem langen Kilometer; Zellen beider Strecken halten das Mittel ihrer Energien
rail-is-renamed = Schiene { $old } der Datei ist Schiene { $new } der Strecke
line-has-not-had-rail = die Strecke hatte bisher keine Schiene { $rails }; heißt sie dort anders, nehmen Sie die Datei mit --rename ALT=NEU --replace noch einmal auf
line-is-called-alike = der Speicher hat eine Strecke „{ $alike }“, und „{ $line }“ ist eine andere; war dieselbe gemeint, löschen Sie den Ordner dieser im Speicher und nehmen Sie die Datei unter jenem Namen auf
survey-is-there-already = { $line }, { $date }: ist schon da
cells-of-rail = { $rail } { $cells } Zellen
survey-is-taken-in = { $line }, { $date }: { $rails }, je { $length } m lang
survey-is-left-out = { $reason }; die Messung bleibt weg
surveys-are-whole = { $count } Messungen sind unversehrt
no-survey-in-store = keine Messung ist im Speicher
surveys-in-cells = Messungen: { $surveys }, in Zellen von { $length } m
no-section-in-limited-band = kein Abschnitt ist in einem Band bekannt, das eine Grenze hat
growth-not-known = nicht bekannt
over-its-limit = darüber
months-or-more = { $months } (mehr als { $early })
middle-from-to = { $middle } ({ $from } bis { $to })
and-more-sites = und { $count } weitere Stellen: --json hat alle
for-money = {" "}für { $cost }
no-plan-leaves-less = , und kein Plan dafür lässt weniger als { $length } km
grinding-is-planned = in { $months } Monaten sind { $over } km Gleis über der Grenze; { $ground } km werden geschliffen{ $cost }, { $left } km bleiben{ $least }
lines-are-not-drawn = das Bild hält die längsten Strecken; { $count } weitere stehen in chart.csv (--line zeichnet eine)
line-column = Strecke
date-column = Tag
surveys-column = Messungen
latest-column = letzte
from-kilometre-column = von km
to-kilometre-column = bis km
rails-column = Schienen km
rms-of-band-column = Effektivwert { $band } mm µm
kind-column = Art
decibels-a-year-column = dB im Jahr
between-column = zwischen
months-to-limit-column = Monate bis zur Grenze (80 %)
expected-growth-column = erwartet dB im Jahr (80 %)
cost-column = Kosten
kilometres-column = km
kilometres-over-limit-column = km über der Grenze
worst-column = schlimmste
at-kilometre-column = bei km
statement-column = Aussage
source-column = Quelle
expected-column = erwartet
tolerance-column = Toleranz
check-holds = gilt
check-fails = GILT NICHT
checks-hold = { $hold } von { $all } Prüfungen gelten
predicted-wavelength = Wellenlänge
predicted-frequency = Frequenz
predicted-growth = Wachstum
predicted-wear = mittlerer Verschleiß
decibels-a-month = dB im Monat
millimetres-per-100-mgt = mm je 100 MGT
no-wave-geometry = { $what }, ohne Geometrie der Welle
from-on = ab { $from }
up-to = bis { $to }
inside-band = innerhalb
outside-band = AUSSERHALB
site-column = Ort
what-column = was
outcomes-inside = { $share } % der veröffentlichten Ergebnisse liegen in ihren Bändern von 80 %; logarithmische Wertung { $score }
report-is-written = { $file } ist geschrieben; öffnen Sie die Datei in einem Browser, von dort wird sie auf A4 gedruckt
profile-is-written = { $file } ist geschrieben; als Nächstes: riffel roughness { $file }
from-to = { $from } bis { $to }
felt-level-column = Pegel dB re 1 µm
with-pads-column = mit Zwischenlagen halber bis doppelter Steifigkeit
band-column = Band mm
rms-column = Effektivwert µm
highest-moving-rms-column = höchster gleitender Effektivwert µm
highest-peak-to-peak-column = höchster Spitze-Spitze-Wert µm
window-column = Fenster m
limit-of-rms-column = Grenze µm
over-limit-column = über der Grenze
grind-column = schleifen
from-column = von m
to-column = bis m
length-column = Länge m
worst-band-column = schlimmstes Band mm
ratio-to-limit-column = Effektivwert/Grenze
line-to-grind = zusammen { $length } m Strecke zu schleifen, { $share } % der gemessenen Strecke
low = innen
high = außen
idle-belongs-to-curve = er gehört zu `riffel curve` und `riffel profile`
idle-amplitude = Wachstumsraten hängen nicht von der Amplitude ab
idle-one-wheel = es gibt nur ein Rad, das mit keinem anderen interferiert
idle-map = die Bänder sind die des Falls und die Geschwindigkeiten die des Verkehrs
idle-inertia = { KEY("wheel.rotation") } ist der Grenzfall ohne Trägheit oder unendlicher Trägheit
idle-rotation = { KEY("wheel.rotation") } hält den Schlupf oder die Kraft längs der Schiene fest
idle-contact-angle = bei einem Kontaktwinkel von null hat das Rad überall denselben Radius
idle-free-wheel = ein frei drehendes Rad nimmt jeden Radius an
idle-belongs-to = er gehört zu { $keys }
idle-patch = ein instationärer Kontakt löst seine Berührfläche auf
idle-place-of-wear = ein instationärer Kontakt findet den Ort des Verschleißes selbst
one-or-other = { $one } oder { $other }
idle-belongs-to-wheelset = er gehört zu { KEY("wheelset.model") } = { $models }
idle-receptance-given = das Gleis ist eine Rezeptanz an Stelle des Modells
idle-receptance-measured = das Gleis ist eine gemessene Rezeptanz, mit der Schiene und den Stützpunkten, die gemessen wurden
idle-twist = ohne { KEY("rail.torsion_constant") } verdreht sich die Schiene nicht
idle-without-supports = { KEY("track.model") } = "{ $model }" ist eine Schiene ohne Stützpunkte
idle-sleepers = { KEY("track.model") } = "{ $model }" hat ohne Schotter keine Schwellen
idle-one-layer = { KEY("track.model") } = "{ $model }" hat eine Schicht, die Zwischenlagen
idle-mean-over-bay = das Wachstum ist das Mittel über das Schwellenfach
idle-same-everywhere = { KEY("track.model") } = "{ $model }" ist überall entlang der Schiene gleich
lateral-pinned-pinned-is-no-candidate = die laterale Pinned-Pinned-Mode ist nicht unter den Kandidaten: sie braucht Stützpunkte in einem Abstand und ein Schienenprofil ({ KEY("rail.section") }), dessen laterale Biegung und Schub bekannt sind
vertical-pinned-pinned-is-no-candidate = die vertikale Pinned-Pinned-Mode ist nicht unter den Kandidaten: sie braucht Stützpunkte in einem Abstand und ein Schienenprofil ({ KEY("rail.section") }), dessen vertikale Biegung und Schub bekannt sind
no-least-sum-of-receptances = unter der ersten Spitze der Rezeptanz ({ $origin }) hat die Summe aus Schiene, Rad und Kontakt in ihren Frequenzen kein Minimum
p2-is-no-candidate = P2 ist nicht unter den Kandidaten: { $reason }
no-modes-of-receptance = Moden des Gleises sind nicht unter den Kandidaten: in der Rezeptanz ({ $origin }) ragt weder Spitze noch Senke aus Nachbarn und Rauschen
rail-has-no-support = die Schiene dieses Falls liegt nirgends auf
no-resonance-of-unsprung-mass = Dämpfung, oder Federung und Biegung der Achse, lassen keine Resonanz der ungefederten Masse auf dem Gleis
track-has-no-layers = Moden von Zwischenlagen und Schwellen sind nicht unter den Kandidaten: das Gleis dieses Falls hat keine
wheel-of-the-case = das Rad des Falls
models-of-the-field = Modelle des Fachs
under-title = { $title }, { $passing }
passages-to-double-column = Überfahrten bis zur Verdopplung
what-moves-models-most = was es am meisten bewegt: die eine Fuge, die, aus dem Fall mit exaktem Kontakt genommen, das Wachstum am meisten ändert
model-not-on-this-case = nicht für diesen Fall: { $model }: { $reason }
wheels-of-a-curve = Räder eines Bogens
all-wheels-in-the-curve = alle Räder im Bogen von { $radius } m bei { $speed } km/h
under-no-wheel = { $under } wachsen unter keinem Rad Riffeln
fastest-at-wheel = { $under } wachsen sie am schnellsten unter { $wheel }: { $rate } je Überfahrt bei { $wavelength } mm, { $frequency } Hz
wheel-not-in-loop = nicht im Kreis: { $wheel }: { $reason }
wheelset-column = Radsatz
rail-column = Schiene
flange-of-rail = { $rail }, Spurkranz
creeps-along-column = längs %
creeps-across-column = quer %
spin-column = Bohrschlupf 1/m
normal-force-column = Normalkraft kN
contact-angle-column = Winkel °
highest-growth-column = höchstes 10⁻⁶ je Überfahrt
no-growth-in-table = kein Wachstum
not-in-loop-in-table = nicht im Kreis
at-edge-in-table = { $value } (Rand)
wheel-on-low-rail = Radsatz { $number }, innere Schiene
wheel-on-high-rail = Radsatz { $number }, äußere Schiene
wheel-on-left-rail = Radsatz { $number }, linke Schiene
wheel-on-right-rail = Radsatz { $number }, rechte Schiene
all-rails-grow-alike = alle Schienen haben das Wachstum { $of_rail } ({ KEY("contact.from") }); im Bogen wächst die andere mit eigener Rate, die { KEY("contact.from.rail") } erfragt
of-low = der inneren Schiene
of-high = der äußeren Schiene
flange-of-wheel = { $wheel }, Spurkranz
traffic-word = Verkehr
at-spread-speed = { $speed } mit einer Standardabweichung von { $deviation }
neither-speed-nor-traffic = weder { KEY("--speed") } noch { KEY("--traffic") } angegeben
not-fitted-without-passages = der Verschleißbeiwert ist nicht an die frühere Messung angepasst, weil die Überrollungen seither nicht bekannt sind: Sie folgen aus den Daten beider Messungen und aus einer Verkehrsdatei, die sagt, wie viel gefahren wird, oder werden angegeben ({ KEY("--passages-between") })
coefficient-not-fitted = der Verschleißbeiwert ist nicht angepasst: { $reason }
input-roughness = Rauheit
input-of-the-same-rail = von derselben Schiene
input-earlier-record = frühere Messung
a-case = ein Fall
input-with = { $title }, mit { $values }
input-case = Fall
input-track-receptance = Rezeptanz des Gleises
input-traffic = Verkehr
input-vehicles = Fahrzeuge, Geschwindigkeiten, Lasten
input-changes = Änderungen am Fall
input-reader-profile = Leseprofil
input-layout = Aufbau von Profilen
input-limit-table = Grenzwerttabelle
input-of-your-own = eigene
input-site = Ort
input-words-at-the-top = die Wörter oben
standard-input = Standardeingabe
one-third-octave-spectra = { $count ->
        [one] 1 Terzspektrum
       *[other] { $count } Terzspektren
    }
chosen-spectra = { $count } Terzspektren, die mit { $choices }
needs-a-limit-of-levels = nötig ist eine Grenze von Pegeln ({ KEY("--limit") })
no-traffic-given = es wurde kein Verkehr angegeben ({ KEY("--traffic") })
no-variant-given = es wurde keine Variante angegeben ({ KEY("--with") })
spikes = { $count ->
        [one] 1 Spitze
       *[other] { $count } Spitzen
    }
pits = { $count ->
        [one] 1 Grube
       *[other] { $count } Gruben
    }
uneven-positions = die Orte weichen im Effektivwert { $off } mm von gleichen Schritten von { $step } mm ab: die Höhen sind kubisch auf gleiche Schritte interpoliert
rows-without-position = { $count ->
        [one] 1 Zeile ohne Ort weggelassen
       *[other] { $count } Zeilen ohne Ort weggelassen
    }
rows-repeat-position = { $count ->
        [one] 1 Zeile mit dem Ort der Zeile davor weggelassen
       *[other] { $count } Zeilen mit dem Ort der Zeile davor weggelassen
    }
rows-after-gap = { $count ->
        [one] 1 Zeile nach einer Lücke bis { $gap } mm, durch Geraden gefüllt
       *[other] { $count } Zeilen nach einer Lücke bis { $gap } mm, durch Geraden gefüllt
    }
rows-after-jump = { $count ->
        [one] 1 Zeile nach einer längeren Lücke oder einem Sprung, zusammen { $length } m, wo die Messung geteilt ist
       *[other] { $count } Zeilen nach einer längeren Lücke oder einem Sprung, zusammen { $length } m, wo die Messung geteilt ist
    }
rows-go-back = { $count ->
        [one] 1 Zeile, in der der Ort zurückspringt: dort ist die Messung in zwei Teile geteilt
       *[other] { $count } Zeilen, in denen der Ort zurückspringt: dort beginnt jeweils der nächste Teil der Messung
    }
rows-behind = { $count ->
        [one] 1 Zeile hinter der Zeile davor weggelassen
       *[other] { $count } Zeilen hinter der Zeile davor weggelassen
    }
below-limit = { $decibels } dB unter { $edition }
in-windows = , ganz und in Fenstern von { $window } m
profile-of-rails = { $count ->
        [one] Profil, 1 Schiene von { $length } m{ $windows }, { $segments } Abschnitte von { $segment } m gemittelt
       *[other] Profil, { $count } Schienen von { $length } m{ $windows }, { $segments } Abschnitte von { $segment } m gemittelt
    }
record-lacks-rail = hat keine Schiene { $rail }, deren Verlauf also nicht bekannt ist
record-lacks-rail-there = hat keine Schiene { $rail }, deren Verlauf dort also nicht bekannt ist
rail-not-measured-there = Schiene { $rail } wurde von { $from } m bis { $to } m nicht gemessen, ihr Verlauf dort ist also nicht bekannt
spectra-of-records = { $count ->
        [one] { $spectra }, 1 Messung
       *[other] { $spectra }, { $count } Messungen
    }
spectra-of-records-by-rail = { $count ->
        [one] { $spectra }, 1 Messung, { $rails } Schienen einzeln beurteilt
       *[other] { $spectra }, { $count } Messungen, { $rails } Schienen einzeln beurteilt
    }
earlier-records = { $count ->
        [one] 1 frühere Messung
       *[other] { $count } frühere Messungen
    }
its-unit-is-no-length = ihre Einheit ist keine Länge
it-is-computed = sie ist aus anderen Spalten berechnet
position-and-heights-in = Ort in { $unit } und Höhen in { $other }
position-in = Ort in { $unit }
heights-in = Höhen in { $unit }
by-line = { $what } nach Zeile { $line }
taken-for-granted = { $what } angenommen
it-numbers-the-rows = sie zählt die Zeilen
it-is-neither = sie ist weder ein Ort noch eine Höhe
text-behind-left-out = der Text hinter Spalte { $column } bleibt weg
text-columns-left-out = Text in Spalte { $columns } bleibt weg
column-left-out = Spalte { $column } bleibt weg: { $reason }
column-of-head = Spalte { $column }, "{ $head }",
column-is-filtered = { $column } ist, was ein Filter übrig ließ: Wellen, die er wegnimmt, sehen glatt aus, und unter einem Grenzwert sagen sie nichts über die Schiene
headed-column-left-out = Spalte { $column }, "{ $head }", bleibt weg: { $reason }
it-is-a-chord-offset = das ist die Pfeilhöhe über einer Sehne, in der Wellen von einer halben, einer viertel und einer sechstel Sehne fehlen und solche von ihrer Länge doppelt sind
it-is-across = das ist längs oder quer zur Schiene
it-is-above-springs = das gehört zu dem, was ein Zug über den Achslagern hat
it-is-a-size = das ist ein Betrag ohne Vorzeichen, kein Signal
it-is-empty = sie ist leer
it-is-no-signal = sie ist weder Beschleunigung noch Geschwindigkeit, Weg oder Zeit
it-is-text = sie ist Text
it-is-second = eine davor ist von derselben Art
speed-tells-the-place = Orte folgen aus { KEY("--speed") }
channel-left-out = { $channel } bleibt weg: { $reason }
it-is-geometry = das ist Gleisgeometrie
it-is-a-statistic = das ist eine Grenze oder eine Statistik, keine gemessene Schiene
marks-of-missing-values = { $count ->
        [one] Spalte { $column } hat { $mark } in 1 Zeile, das gilt als fehlender Wert
       *[other] Spalte { $column } hat { $mark } in { $count } Zeilen, das gilt als fehlender Wert
    }
first-at-line = { $sentence }; zuerst in Zeile { $line }
coarse-sampling = alle { $step } mm ein Messpunkt; EN 15610 verlangt 1 mm oder weniger
short-stretches-left-out = { $length } m in Abschnitten unter { $shortest } m weggelassen
heights-missing = { $count ->
        [one] 1 Höhe fehlt; bis zu { $longest } in Folge sind durch Geraden ersetzt, mehr bleiben weg
       *[other] { $count } Höhen fehlen; bis zu { $longest } in Folge sind durch Geraden ersetzt, mehr bleiben weg
    }
heights-clipped = { $samples } Höhen stehen am Ende des Messbereichs, { $low } oder { $high } in der Einheit der Datei, über { $run } Messpunkte und mehr: der Aufnehmer ist übersteuert
dates-are-day-numbers = Spalte `{ $column }` enthält Tagesnummern einer Tabellenkalkulation: { $cell } wird als { $date } gelesen
rails-of-last-date = die Datei hat Schienen mehrerer Daten: die Schiene von jetzt ist die vom { $last }, davor steht die vom { $before }
device-is-laid-on-another = Spalte `{ $column }`: Pegel von { $device } zählen { $offset } dB, im Mittel der Bänder: darum weicht { $reference } an Tagen ab, an denen beide gemessen haben; das Wachstum ist das eines Geräts
device-is-left-out = Spalte `{ $column }`: { $device } bleibt aus dem Wachstum weg, denn an keinem Tag haben { $device } und { $reference } die Schiene gemessen: worin sie abweichen, ist nicht bekannt
device-changes = Spalte `{ $column }` wechselt mit den Daten, von { $first } auf { $last }, und diese werden nicht unterschieden: worin die Geräte voneinander abweichen, ist Teil der Änderung zwischen den Daten
device-of-other-dates = Spalte `{ $column }` ist an manchen Tagen { $device } und an anderen { $other }: Worin sich zwei Geräte unterscheiden, gälte als Wachstum; die Zeilen jedes Geräts gehören in eine eigene Datei
now-is-latest-of-each-rail = Spalte `{ $column }` hat { $count } Daten: jetzt ist das letzte jeder Schiene, { $last }
commas = Kommas
semicolons = Semikolons
tabs = Tabulatoren
blanks = Leerzeichen
decimal-point = Dezimalpunkt
decimal-comma = Dezimalkomma
source-of-growth-ridge = Afferrante & Ciavarella (2009), mit Rezeptanzen, Kontakt und Verschleiß dieses Falls
source-of-p2 = 50–100 Hz bei Afferrante & Ciavarella (2009); hier das Minimum der Summe der Rezeptanzen von Schiene, Rad und Kontakt dieses Falls
source-of-full-track = Nahe 100 Hz (Bhaskar et al., bei Afferrante & Ciavarella 2009); hier die Spitze der Schienenrezeptanz des Falls
source-of-sleeper-antiresonance = Kleine vertikale Rezeptanz nahe 300 Hz (Müller, bei Afferrante & Ciavarella 2009); hier √((k_p + k_b)/m_s) dieses Falls
source-of-rail-on-pad = die Spitze der Schienenrezeptanz des Falls, sonst √(k_p/m)
source-of-pinned-pinned = Nahe 800 Hz bei 0,75 m und 1200 Hz bei 0,6 m (Grassie & Kalousek, bei Afferrante & Ciavarella 2009); Nielsen (2003) zur kleinen Rezeptanz über Schwellen; hier der Timoshenko-Balken dieses Falls
source-of-lateral-pinned-pinned = 513,7 Hz lateral neben 1050 Hz vertikal (Wang & Lei 2020); hier der Timoshenko-Balken dieses Falls, lateral
source-of-measured-peak = die gemessene Rezeptanz der Schiene: welche Mode des Gleises es ist, sagt sie nicht
source-of-given-peak = die mit dem Fall gegebene Rezeptanz der Schiene: welche Mode des Gleises es ist, sagt sie nicht
source-of-wheelset-torsion = zweite Torsionsmode nahe 300 Hz (Elkins 1998, bei Afferrante & Ciavarella 2009); die Frequenz wie angegeben
source-of-wheelset-bending = Biegung der führenden Welle (Torstensson & Nielsen 2013); die Frequenz wie angegeben
source-of-grinding-mark = Schleifsteine, die sich 50- bis 60-mal in der Sekunde drehen, auf einem Zug mit 3 bis 15 km/h: 14 bis 83 mm; Spuren von 60 mm bei 60 Hz sind von einer chinesischen Schnellfahrstrecke bekannt (Shock and Vibration 2021, 5546809). Die Geschwindigkeiten nimmt Riffel an
source-of-support-spacing = d und d/2 des Stützpunktabstands d dieses Falls: Kinematik
source-of-wheel-circumference = 2πR/n, n = 1 bis 30, des Rollradius dieses Falls: Kinematik
source-of-unlisted = jede Wellenlänge von 5 mm bis 2 m gleich wahrscheinlich, auf logarithmischer Skala
validity-of-growth-ridge = ein Rad, linear, im Rahmen der Hinweise zu diesem Fall; Anteile folgen dem Wachstum in den gefragten Wellenlängen
validity-of-p2 = starre unabgefederte Masse, gleichmäßig verteilte Stützpunkte; ±15 % für die Steifigkeit wirklicher Gleise
validity-of-full-track = ungedämpfte Schichten; die Schottersteifigkeit ist auf einen Faktor zwei unsicher, die Frequenz auf ±15 %
validity-of-rail-on-pad = Zwischenlagen werden mit Last, Frequenz und Kälte steifer: ±15 %
validity-of-pinned-pinned = Timoshenko-Balken auf Stützpunkten in gleichen Abständen; ±5 % für Abstand und Schienenfuß
validity-of-measured-peak = Ort und Last der Rezeptanz; ±5 % für anderen Ort, andere Temperatur und Radlast, und ihre Halbwertsbreite
validity-of-wheelset-torsion = so gut wie die angegebene Frequenz; ±5 %
validity-of-grinding-mark = die Wellenlänge einer Überfahrt eines Zugs; mehrere Überfahrten hinterlassen mehrere
validity-of-support-spacing = Stützpunkte in gleichen Abständen; ±2 %
validity-of-wheel-circumference = in einer Messung vom Fahrzeug aus: Räder anderer Durchmesser und Phasen prägen der Schiene kein gemeinsames Muster ein; ±3 % für verschlissene Durchmesser
validity-of-unlisted = immer
measurement-of-growth-ridge = Geschwindigkeit: wo Züge anders schnell fahren, wandert die Wellenlänge und die Frequenz bleibt; weiter gestreute Geschwindigkeiten senken sein Wachstum
measurement-of-p2 = vertikale Achslagerbeschleunigung von Fahrzeugen anderer unabgefederter Masse: P2 wandert mit der Masse, Moden des Gleises nicht
measurement-of-full-track = Rezeptanz des belasteten Gleises von 20 bis 200 Hz, mit und ohne Hohllagen unter den Schwellen
measurement-of-sleeper-antiresonance = Impulshammer auf Schwelle und Schienenkopf: bei dieser Frequenz bewegt sich die Schwelle und die Schiene nicht
measurement-of-rail-on-pad = Abklingrate des Gleises (EN 15461) und Rezeptanz mit dem Impulshammer: eine Spitze hier, die mit den Zwischenlagen wandert (Temperatur, neue Zwischenlagen auf einer Probestrecke)
measurement-of-pinned-pinned = Rezeptanz mit dem Impulshammer über einer Schwelle und in Feldmitte, und das über die Schwellenfächer gemittelte Profil: die Amplitude folgt den Schwellen; ungleiche Abstände oder Schienendämpfer beseitigen sie
measurement-of-lateral-pinned-pinned = laterale Rezeptanz des Schienenkopfs in Feldmitte und laterale Abklingrate des Gleises
measurement-of-measured-peak = Rezeptanz mit dem Impulshammer über einer Schwelle, in Feldmitte und auf der Schwelle, mit einem Rad daneben: eine Mode der Zwischenlagen bewegt die Schwelle wenig und verschiebt sich mit neuen oder kälteren Zwischenlagen, eine Pinned-Pinned-Mode zeigt sich nur in Feldmitte
measurement-of-measured-dip = Impulshammer auf Schwelle und Schienenkopf: bei dieser Frequenz bewegt sich etwas anderes und hält die Schiene
measurement-of-wheelset-torsion = Dehnmessstreifen für das Drehmoment an einer angetriebenen Welle oder longitudinale Achslagerbeschleunigung durch den Abschnitt
measurement-of-wheelset-bending = laterale und vertikale Achslagerbeschleunigung des führenden Radsatzes durch den Bogen; die bogeninnere Schiene sollte am schlechtesten sein
measurement-of-grinding-mark = das Protokoll des Schleifzugs (Datum, Überfahrten, Geschwindigkeit, Drehzahl der Steine), ein Foto der Facetten und ein ungeschliffener Abschnitt
measurement-of-support-spacing = die Orte der Schwellen auf der Stationierung der Messung: die Phase bleibt bei ihnen
measurement-of-wheel-circumference = eine Messung derselben Schiene von Hand, und Rauheit oder Unrundheit der Räder: sieht die Schienenmessung die Wellenlänge nicht, ist sie auf dem Rad
measurement-of-unlisted = eine Messung der Rezeptanz dieses Gleises anstelle des Modells ({ KEY("track.model") } = "measured")

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

## Cases that are refused

file-cannot-be-read = { $what } { $path } ist nicht zu lesen: { $reason }
not-valid-toml = kein gültiges TOML: { $message }
place-and-fault = { $place }: { $fault }
track-is-the-same-everywhere = das Gleis ist mit { KEY("track.model") } = "{ $model }" entlang der Schiene überall gleich; one-layer-periodic oder two-layer-periodic wählen
line-and-fault = { $path }, Zeile { $line }: { $fault }
no-such-preset = keine Vorgabe heißt "{ $name }"; am nächsten kommt "{ $nearest }"
presets-are-listed = riffel presets zählt sie alle auf
key-and-rule = `{ $key }`: { $rule }
key-as-subject = `{ $key }` { $rule }
is-key-with-command = ist ein Schlüssel mit dem Steuerzeichen { $command }
is-text-with-command = ist ein Text mit dem Steuerzeichen { $command }
leave-it-out = weglassen
key-of-many-parts = ein Schlüssel hat höchstens { $most } Teile, dieser { $count }
value-not-table = `{ $parent }` ist ein Wert und keine Tabelle, in `{ $path }`
is-outside = ist { $value }, muss aber zwischen { $low } und { $high } liegen
is-unknown-key = ist kein Schlüssel, den Riffel kennt
no-choice = "{ $variant }" steht nicht zur Wahl
is-no-table = ist keine Tabelle, wie es sein muss
is-no-list = ist keine Liste, wie es sein muss
is-but-must-be = ist { $value }, muss aber { $rule } sein
is-missing = fehlt
whole-number = eine ganze Zahl, null oder mehr
quoted-text = ein Text in Anführungszeichen
true-or-false = true oder false
some-list = eine Liste
some-table = eine Tabelle
near-name = gemeint: { $nearest }? (erlaubt: { $allowed })
is-no-preset = ist „{ $name }“, aber keine Vorgabe für { $kind } heißt so
track-kind = Gleis
pad-kind = Zwischenlage
sleeper-kind = Schwelle
ballast-kind = Schotter
vehicle-kind = Fahrzeug
allowed-names = erlaubt: { $allowed }
not-a-number = "{ $text }" beginnt nicht mit einer Zahl; { $kind } schreibt man wie "{ $example }"
not-finite = { $text } ist nicht endlich, wie es { $kind } sein muss
number-with-separator = "{ $text }" hat ein Komma oder eine Lücke in der Zahl; mit Punkt und ohne Tausendertrennung schreiben, wie "{ $example }" für { $kind }
range-for-one-value = "{ $text }" ist ein Bereich, nötig ist ein Wert; { $kind } schreibt man wie "{ $example }"
unknown-unit = unbekannte Einheit "{ $unit }" in "{ $text }"; { $kind } schreibt man wie "{ $example }"
wrong-unit = "{ $text }" ist { $got }, nicht { $kind }; man schreibt es wie "{ $example }"
plain-number = eine bloße Zahl
in-unit = in { $unit }
kind-in-unit = { $kind } in { $unit }
kind-as-in = { $kind } in { $unit } oder wie "{ $example }"
ratio-such-as = { $kind } wie 0.4 oder "{ $example }"
name-as-subject = { $name } { $rule }
is-flange-but-the-wheel-stands = ist "flange", das Rad steht aber auf einem Punkt, bei einem Kontaktwinkel von { $angle }°
the-profiles-do-not-part-across = die Profile gehen quer zum Gleis nicht auseinander, wo sie sich berühren (Krümmung { $curvature } 1/m), es gibt also keine Ellipse; { $key } angeben
the-rail-is-not-convex-where = die Schiene ist nicht konvex, wo das Rad steht (Krümmung { $curvature } 1/m), dort wandert also kein Kontakt über einen Kopf; { KEY("contact.conformity") } weglassen, oder { $key } angeben
is-but-the-ellipse-like-it = ist "{ $name }", die gleichwertige Ellipse ist aber eine von { KEY("contact.hertz") } = "exact"
needs = braucht { $what }
supports-of-the-rail-or-a = Stützpunkte der Schiene: { $keys } oder ein { KEY("track.preset") }
a-rail-that-moves-across-the = eine Schiene, die sich quer zum Gleis bewegt: { $keys }
narrow-the-window-or-measure-further = das Fenster enger machen oder weiter messen
the-traction-force-of-kn-on = die Zugkraft von { $force } kN an einem Rad ist das { $ratio }-fache dessen, was die Reibung trägt, μP₀ = { $most } kN
at-the-tractive-ratio-of = bei der Kraftschlussausnutzung { $ratio }: { $reason }
at-the-creepage-of = beim Schlupf von { $creepage } %: { $reason }
hold-is-but-must-be-force = hold ist "{ $name }", muss aber force, ratio oder creepage sein
give-with = [{ $key }] mit { $needs } angeben
is-but-the-profiles-lie-m = ist { $given }, die Profile liegen aber { $placed } m auseinander: profiles.flange_back_distance weniger zweimal profiles.flange_back_position
profiles-wheel-cone-needs-it = profiles.wheel = "cone" braucht es
is-set-but-curve-theory-linear = ist gesetzt, curve.theory = "linear" kennt aber keinen Spurkranz
leave-it-out-or-choose-curve = weglassen oder curve.theory = "nonlinear" wählen
is-set-but-profiles-contact-plane = ist gesetzt, profiles.contact_plane = "{ $name }" nimmt aber einen Spurkranz aus { $keys }
is-set-but-belongs-to = ist gesetzt, gehört aber zu { $belongs }
larger-than-the-to-either-side = größer als { $what }, nach beiden Seiten, und höchstens 10000 km
is-but-the-wheelset-is-mm = ist { $gauge }, der Radsatz ist aber über seine Spurkränze, 10 mm unter der Lauffläche, { $width } mm breit und passt nicht zwischen solche Schienen
is-but-the-wheels-mm-wide = ist { $gauge }, die Räder, über ihre Außenseiten { $width } mm breit, stehen aber nicht auf beiden Schienen
is-but-cannot-be-read = ist "{ $name }", { $path } ist aber nicht zu lesen: { $reason }
nominal-profiles = Sollprofile: { $known }
track-model-says-what-the-rail = { KEY("track.model") } = "{ $model }" sagt nur, was die Schiene unter dem Rad tut, nicht, wie weit ihre Schwingung läuft
the-rail-of-track-model-carries = die Schiene von { KEY("track.model") } = "{ $model }" trägt ihre Schwingung bei jeder Frequenz ohne Ende weiter
takes-one-wheel-of-wheel-with = { $what } braucht ein Rad aus [wheel] mit Längsschlupf, und dies ist ein Kreis in allen Richtungen oder mit mehreren Rädern
track-model-is-but-is-of = `{ KEY("track.model") }` ist "{ $model }", { $what } gibt es aber nur auf diskreten Stützpunkten; ein periodisches Modell wählen
traffic-file-for-case = das ist eine Verkehrsdatei mit ihren [[vehicle]] und keine Falldatei; sie mit { KEY("--traffic") } angeben und an ihrer Stelle eine Falldatei, wie `riffel init` sie schreibt
below-r-at-the-wavelength-of = kleiner als λ²/4π²R bei der Wellenlänge { $wavelength } m: darüber ist das Profil so gekrümmt wie das Rad, das die Täler überbrückt
at-m-and-m-s-is = { $quantity } ist bei { $wavelength } m und { $speed } m/s keine endliche Zahl: mit so großen oder kleinen Werten des Falls lässt sich nicht rechnen
wheelset-model-needs-it = { KEY("wheelset.model") } = "{ $model }" braucht es
give-length-and-diameter-of-an = length und diameter einer Welle von einem Durchmesser angeben, oder segments
is-an-empty-list-an-axle = ist eine leere Liste, eine Welle von 0 m, die Summe der Längen muss aber über 0 liegen
at-most-the-length-of-the = höchstens die Länge der Welle, { $length } m
between-m-and-m-the-ends = zwischen -{ $end } m und { $end } m, den Enden der Welle
traffic-file-for-changes = das ist eine Verkehrsdatei mit ihren [[vehicle]] und keine Datei der Änderungen; sie mit { KEY("--traffic") } angeben
give-one-of-the-two = eines von beiden angeben
the-file-of-changes-changes-nothing = die Datei der Änderungen ändert nichts
write-keys-of-the-case-as = Schlüssel des Falls schreiben, wie in [contact] friction = 0.3, oder [speed] mean, factor oder standard_deviation
give-damping-loss-factor-or-both = { $key }.damping, { $key }.loss_factor oder beide angeben
at-most-the-support-spacing = höchstens der Stützpunktabstand, { $spacing }
choose-contact-creep-law-half-space = { KEY("contact.creep_law") } = "half-space" wählen oder weglassen
give-contact-tractive-ratio-or-contact = { KEY("contact.tractive_ratio") } oder { KEY("contact.creepage") } angeben
at-most-contact-polach-adhesion-reduction = höchstens { KEY("contact.polach.adhesion_reduction") }, { $value }
falling-friction-needs-limit-friction-ratio = fallende Reibung braucht limit_friction_ratio, friction_decay und speed aus [contact.polach]: alle drei angeben oder keines
is-one-of-t-a-of = ist eine von Tγ/A, nach dem das Verschleißgesetz nicht fragt
is-no-measured-wear = ist "{ $text }", muss aber eine Tiefe und der Verkehr sein, der sie abgetragen hat, wie in "1.2 mm / 100 MGT"
is-of-wear-by-energy = ist von einer Schiene, die nach Energie verschleißt: andere Gesetze in { KEY("wear.law") } und { KEY("damage.laws") } weglassen
is-measured-but-nothing-slides = ist { $depth } mm je 100 MGT, aber unter diesen Rädern gleitet nichts, sodass kein Verschleißbeiwert das ergibt: ihnen Zugkraft oder Schlupf geben oder es weglassen
measured-wear-makes = { $depth } mm Verschleiß je 100 MGT ergeben den Verschleißbeiwert { $coefficient } kg/J (80 %: { $low } bis { $high })
measured-wear-of-the-case = { $coefficient }, wenn alle Räder wie dieses sind
measured-wear-of-traffic = unter diesem Verkehr: { $coefficient }
it-belongs-to-wear-law-usfd = es gehört zu { KEY("wear.law") } = "usfd" und "usfd-smooth"
rates-of-the-laws-add-name = Raten der Gesetze addieren sich: jedes einmal nennen
damage-laws-names-give-its-table = { KEY("damage.laws") } nennt „{ $law }“: seine Tabelle angeben
names-bending-but-track-model-does = nennt bending, aber { KEY("track.model") } = "{ $name }" sagt nicht, was die Schiene trägt
choose-a-model-or-no-bending = ein Modell von Schiene und Stützpunkten wählen, oder bending weglassen
names-fatigue-by-t-but-the = nennt Ermüdung nach Tγ, aber der Kontakt hat keinen Schlupf
give-contact-creepage-or-contact-tractive = { KEY("contact.creepage") } oder { KEY("contact.tractive_ratio") } über null angeben
is-true-but-wheelset-model-tells = ist true, { KEY("wheelset.model") } = "{ $model }" sagt aber, wie sich die Kontakte bewegen, und nicht, wie die Naben
choose-wheelset-model-rigid-or-flexible = { KEY("wheelset.model") } = "rigid" oder "flexible" wählen, oder es weglassen
give-longitudinal-or-lateral-creepage-with = Längs- oder Querschlupf dazu angeben
transverse-radius-is-the-relative-one = transverse_radius ist der relative beider Profile, unter einem Kegel der der Schiene
are-several-but-track-model-does = nennt mehrere, { KEY("track.model") } = "{ $model }" sagt aber nicht, wie das Gleis von einem zum nächsten antwortet
choose-a-model-or-one-wheel = ein Modell aus Schiene und Stützpunkten wählen, oder ein einziges Rad
give-rail-lateral-second-moment-and = { KEY("rail.lateral_second_moment") } und { KEY("track.pad.lateral_stiffness") } angeben, oder weglassen
the-waves-that-run-along-this = die Wellen, die auf dieser Schiene über die { $furthest } m vom ersten Rad zum letzten laufen, geben die wenigen in der Zeit angepassten Schwingungen nicht wieder, im Effektivwert { $per_cent } % daneben; weniger oder nähere Räder angeben, oder ein Gleis, das mehr dämpft
the-case-has-contacts-but-a = der Fall hat { $count } Kontakte, eine Überrollung in der Zeit nimmt aber höchstens { $most_contacts }: der Aufwand eines Schrittes und der Anpassung geht mit ihrem Quadrat; weniger Räder wählen, oder { KEY("wheelset.opposite_rail") } = "absent"
is-a-file-and-this-case = ist eine Datei, und dieser Fall darf keine nennen
use-it-in-a-case-file = in einer Falldatei mit dem Programm verwenden, `riffel map CASE`
lower-points = { KEY("map.wavelength.points") } oder { KEY("map.speed.points") } senken
and-exclude-each-other = und `{ $other }` schließen einander aus
the-nearest-key-is = der ähnlichste Schlüssel ist `{ $key }`
is-no-key-of-a-case = ist kein Schlüssel eines Falls
vehicle-at-km-h = Fahrzeug "{ $vehicle }" bei { $speed }: { $error }
is-an-empty-list = ist eine leere Liste
give-both-keys-of-one-of = gib beide Schlüssel von einem der beiden an
goes-down-to-but-every-value = geht hinunter bis { $value }, jeder Wert muss aber größer als null sein
is-no-spread-give-mean-and = ist keine Streuung: mean und standard_deviation, min und max oder eine Liste aus value und share angeben, mit { $name } wie in "{ $example }"
axles-that-roll-free = `{ $key }` ist unter eins, aber auch frei rollende Achsen schädigen die Schiene nach den Gesetzen von { KEY("damage.laws") }: Achsen mit Zugkraft und solche ohne als zwei Fahrzeuge nennen
the-shares-of-sum-to-but = die Anteile von `{ $key }` ergeben zusammen { $sum }, müssen aber 1 ergeben
vehicle = Fahrzeug "{ $vehicle }": { $error }
variant-changes-friction-or-load-under = Variante "{ $title }" ändert Reibung oder Last unter "{ $vehicle }"; { $why }
speeds-and-bands-of-vehicle = Geschwindigkeiten und Bänder von Fahrzeug "{ $name }": { $message }
line-measured-line-needs-profiles-of = `line.measured_line` braucht Profile von Rad und Schiene, die sich unter dem Kontaktwinkel des Gleichgewichts berühren, und das Fahrzeug "{ $name }" hat keine
width-excludes-that-of-the-case = `{ $key }` und { KEY("wear.band_width") } des Falls schließen einander aus; gib eines von beiden an
write-one-vehicle-or-more = ein [[vehicle]] oder mehr schreiben
is-empty-but-tables-need-a = ist leer, Tabellen brauchen aber einen Namen
is-a-second-time = ist zum zweiten Mal "{ $text }"
line-measured-line-needs-for-without = `line.measured_line` braucht `{ $key }`, denn ohne das sagt das Fahrzeug "{ $name }" nicht, wo auf der Schiene seine Räder laufen
this-is-a-case-file-with = das ist eine Falldatei, mit ihrer Tabelle [{ $table }], und keine Verkehrsdatei; eine Verkehrsdatei führt die Fahrzeuge einer Strecke in [[vehicle]] auf, `riffel init --traffic` schreibt eine
is-a-force-but-must-be = ist "{ $force }", eine Kraft, muss aber eine Masse sein, wie in "13 t"; die halbe Kraft darf als wheel_load dastehen
the-speeds-of-the-traffic-go = die Geschwindigkeiten des Verkehrs gehen von { $from } bis { $to }, müssen aber über null liegen und steigen
there-are-vehicles-but-the-page = es gibt { $count } Fahrzeuge, die Seite nimmt aber höchstens { $most_vehicles }
the-case-is-larger-than-kib = der Fall ist größer als { $size } KiB
map-points-are-more-than-the = `{ KEY("map") }`: { $points } Punkte sind mehr als die { $most_map_points }, die die Seite rechnet
lower-points-on-the-page = { KEY("map.wavelength.points") } oder { KEY("map.speed.points") } senken; das Programm selbst rechnet größere Karten
contact-grid-is-but-the-page = `{ KEY("contact.grid") }` ist { $grid }, die Seite geht aber bei instationärer Antwort nur bis { $finest_grid }
the-program-itself-goes-further = das Programm selbst geht weiter
the-of-the-point-is-but = { $what } des Punkts ist { $value }, die Karte reicht aber von { $low } bis { $high }
choose-a-point-on-the-map = einen Punkt auf der Karte wählen
the-speed-is-m-s-but = { $name }: die Geschwindigkeit ist { $speed } m/s, muss aber über null und höchstens 200 m/s sein
wave-is-but-must-be = die Welle ist { $value }, muss aber { $rule } sein
the-amplitude-is-m-but-must = die Amplitude ist { $number } µm, muss aber zwischen { $low } und { $high } µm liegen
the-plan-cannot-be-read = der Plan lässt sich nicht lesen
the-plan-cannot-be-written = der Plan lässt sich nicht schreiben
of-a-prior-must-be-a = `{ $key }` einer Vorverteilung muss eine Zahl oder ein Text sein
the-answer-took-longer-than-s = die Antwort brauchte länger als { $seconds } s und wurde aufgegeben
too-much-is-being-computed-at = im Augenblick wird zu viel gerechnet
the-program-is-ending = das Programm endet gerade
the-computation-broke-off = die Rechnung ist abgebrochen
the-file-is-larger-than-mib = die Datei ist größer als { $size } MiB
riffel-roughness-reads-larger-ones = `riffel roughness` liest größere
other-files-are-just-coming-in = gerade kommen andere Dateien an
nothing-of-the-file-came-for = seit { $seconds } s kam nichts von der Datei
the-file-broke-off-on-its = die Datei brach unterwegs ab
the-file-came-more-slowly-than = die Datei kam langsamer als { $rate } kB in der Sekunde
the-files-of-all-pages-have = die Dateien aller Seiten haben mehr als { $size } MiB
close-pages-that-are-not-needed = Seiten schließen, die nicht gebraucht werden
the-file-is-no-longer-here = die Datei ist nicht mehr da
choose-it-once-more = noch einmal wählen
there-are-such-files-already-which = es gibt schon { $most } solche Dateien, mehr nimmt die Seite nicht
the-file-cannot-be-stored = die Datei kann nicht gespeichert werden: { $error }
free-room-on-the-disk = Platz auf dem Datenträger von { $folder } schaffen oder riffel serve mit TMPDIR auf einem anderen starten
the-calibration-is-no-longer-here = die Kalibrierung ist nicht mehr da
choose-its-data-once-more = die Daten noch einmal wählen
the-file-takes-more-memory-than = die Datei braucht mehr Speicher als die { $memory } MiB, die die Seite ihr gibt
riffel-roughness-reads-it-without-a = `riffel roughness` liest sie ohne Grenze
the-program-broke-off = das Programm ist abgebrochen
the-request-did-not-come-within = die Anfrage kam nicht innerhalb von { $seconds } s an
the-request-is-larger-than-kib = die Anfrage ist größer als { $size } KiB
a-case-is-a-few-hundred = ein Fall ist einige hundert Byte lang
there-are-more-than-actions-or = es sind mehr als { $most } Maßnahmen oder Messungen, mehr nimmt die Seite nicht
the-actions-cannot-be-written = die Maßnahmen lassen sich nicht schreiben
blocks-are-m-long-but-must = Abschnitte sind { $block } m lang, erlaubt sind 1 m bis 1000 km
the-date-of-a-record = das Datum einer Messung: { $sentence }
the-dates-of-the-records-do = die Daten der Messungen steigen nicht: { $later } kommt nach { $earlier }; die älteste zuerst
the-limit-of-the-level-must = die Grenze des Pegels muss bei 0 bis { $loudest } dB(A) liegen
is-larger-than-mib-the-most = ist größer als { $size } MiB, das Meiste, was Riffel liest ({ $what })
is-text-in-but-a-must = ist Text in { $encoding }, muss aber UTF-8 sein ({ $what })
byte-of-the-file-is-which = Byte { $place } der Datei ist { $value }, das ist nicht UTF-8; es sieht nach Windows-1252 aus, dort ist es "{ $letter }"
write-set-key-value-as-in = { KEY("--set") } schlüssel=wert schreiben, wie { KEY("--set") } { KEY("contact.friction") }=0.3
is-empty-window = ist { $max }, aber das Fenster ist leer, wenn es nicht über dem Minimum von { $min } liegt
track-model-needs-it = { KEY("track.model") } = "{ $model }" braucht es: angeben{ $preset }
or-name-a-preset = , oder mit { KEY("track.preset") } eine Vorgabe nennen
track-of-all-frequencies-in-time = eine Überrollung in der Zeit braucht alle Frequenzen: ein Modell von Gleis und Rad an Stelle von Rezeptanzen
rigid-wheel-in-time = eine Überrollung in der Zeit nimmt das starre Rad aus [wheel], keine Rezeptanz an seiner Stelle
wheelset-of-all-frequencies-in-time = eine Überrollung in der Zeit braucht alle Frequenzen: ein Modell des Radsatzes oder seine Eigenformen an Stelle gemessener Rezeptanzen
contacts-at-rest-in-time = eine Überrollung in der Zeit nimmt Kontakte, die auf den Profilen bleiben, wo sie sind; weglassen
no-spring-dashpot-in-time = `{ KEY("contact.response") }` ist "spring-dashpot", das nur für kleine Schwingungen bekannt ist; für eine Überrollung in der Zeit "quasi-static" oder "non-steady" wählen
quasi-static-in-time = in allen Richtungen nimmt eine Überrollung in der Zeit einen Kontakt, der sofort antwortet, `{ KEY("contact.response") }` = "quasi-static"
no-constant-force-in-time = `{ KEY("wheel.rotation") }` ist "constant-tangential-force", doch wo das Rad die Schiene verlässt, hält kein Schlupf die Kraft; "inertia" oder "constant-creepage" wählen

## Plans that are refused

is-name-but-must-be = ist "{ $name }", muss aber { $rule } sein
is-but-for-kind = ist "{ $value }", muss aber bei { $kind } "{ $only }" sein
this-or-that = "{ $this }" oder "{ $that }"
one-of = eines von { $names }
a-file-or-one-of = eine Datei oder eines von { $names }
zero-or-more = null oder mehr
greater-than-zero = größer als null
more-than-one = größer als eins
finite-and-above-zero = endlich und größer als null
rate-in-per-cent = { $rate } %
rate-of-interest = mindestens null und kleiner als 100 %
is-with-thousands-apart = ist { $value }, mit getrennten Tausendern: nur Ziffern und einen Dezimalpunkt schreiben, etwa 9000 oder 9000.5
is-perhaps-in-thousands = ist { $value }, was { $thousands } oder { $plain } sein kann: eines von beiden so schreiben
is-with-a-multiple = ist { $value }, muss aber alle Ziffern haben: { $plain }
is-with-its-currency-before = ist { $value }, mit der Währung davor: zu schreiben ist { $plain }
is-with-a-comma = ist { $value }, mit einem Komma: einen Dezimalpunkt schreiben, etwa { $plain }
number-of-a-sum = eine Zahl wie 9000
sum-of-zero-or-more = eine Summe von null oder mehr in { $currency } wie cost.grinding
sum-with-currency = eine Summe mit ihrer Währung wie "9000 EUR"
hours-of-zero-or-more = eine Zahl von Stunden ab null wie "6 h"
time-above-zero = eine Zeit über null wie "18 months" oder "25 a"
level-above-limit = ein Pegel von null oder mehr über der Grenze wie "3 dB"
level-below-zero = ein Pegel unter null wie "-6 dB"
level-of-zero-or-more = ein Pegel von null oder mehr wie "0.3 dB"
at-most-the-horizon = höchstens so lang wie cost.horizon, { $months } Monate,
say-for-how-long-grinding-closes = angeben, wie lange einmal Schleifen die Strecke sperrt, wie in grinding_hours = "6 h"
give-cost-of-grinding = [cost] grinding = "9000 EUR" und ein [[action]] oder mehr angeben
write-one-action-or-more = ein [[action]] oder mehr schreiben; alles zu lassen, wie es ist, gehört von selbst dazu
write-one-parameter-or-more = ein [[parameter]] oder mehr schreiben
give-what-an-action-does = changes = "soft-pads.toml", multiplies = {"{"} … {"}"} oder grind_every = "12 months" angeben
say-how-long-the-investment-lasts = angeben, wie lange die Anschaffung hält, wie in life = "25 a"
name-the-action = die Maßnahme benennen
give-each-its-title = jedem einen eigenen Titel geben
give-each-its-name = jedem einen eigenen Namen geben
is-no-parameter = ist kein [[parameter]] des Plans; es gibt { $names }
names-no-parameter = nennt "{ $name }", das kein [[parameter]] des Plans ist; es gibt { $names }
is-name-of-no-parameter = ist "{ $name }", aber kein [[parameter]] heißt so
is-name-of-no-data = ist "{ $name }", aber kein [[data]] heißt so oder ist von dieser Art
is-name-of-none-of-the-data = ist "{ $name }", aber kein [[data]] heißt so; es gibt { $names }
is-name-of-no-vehicle = ist "{ $name }", aber kein Fahrzeug des Verkehrs heißt so
give-what-is-measured = kind = "dated-levels" angeben, um noch einmal zu messen, oder key = "…" mit factor = 1.1
is-no-data-to-repeat = ist "{ $kind }", aber der Plan hat kein solches [[data]], dessen Stellen und Fehler sich wiederholen ließen
weigh-one-value = eine Achslagermessung lässt sich noch nicht abwägen; ein einzelner Wert schon, mit key und factor
say-how-good-it-is = angeben, wie gut gemessen wird: factor = 1.1 für 10 %
factor-of-ten-per-cent = 1.1 steht für 10 %
no-discrepancy = "{ $data }" hat kein `discrepancy`: das Modell gilt als genau, und die Intervalle werden zu eng
or-leave-it-out = oder weglassen
size-of-discrepancy = muss eine Zahl von null oder mehr sein oder {"{"} half_normal = … {"}"} über null
is-kind-that-needs-levels = ist "{ $kind }" und braucht genau ein [[data]] der Art "dated-levels" derselben Schiene
pass-by-without-levels = ohne Pegel eines Messwagens sagt nichts, welche ihrer Bänder zu hören sind
axle-box-without-levels = ohne Pegel eines Messwagens zeigt ein Achslager nur die Form eines Spektrums
is-kind-without-traffic = ist "{ $kind }", aber der Plan nennt keinen Verkehr, unter dem sie gewachsen sind
give-traffic = traffic = "traffic.toml" angeben
give-traffic-of-the-program = { KEY("--traffic") } TRAFFIC angeben
errors-are-zero = die Fehler der Daten sind im Rahmen der Rundung null
is-set-but-belongs-to-kinds = ist gesetzt, gehört aber zu { $kinds } und nicht zu { $kind }
unused-columns = { $file } hat Spalten, die nicht gebraucht werden: { $columns }
repeats-line = sagt, was schon in Zeile { $line } steht: eine doppelte Zeile zählte doppelt
two-errors-of-a-rate = hat `standard_error_ln` und `standard_error_db_per_m`, darf aber nur eines davon haben
too-few-passages = `passages` reicht vom ersten bis zum letzten Zeitpunkt über { $passages }, muss aber mindestens { $least } umfassen: mit weniger ändert sich keine Schiene; sind es Millionen?
lines-are-taken-together = die { $lines } Linien von { $file } sind zu { $bands } Mitteln benachbarter zusammengefasst, eng dort, wo sich der Frequenzgang biegt
ground-between-dates = vor dem Zeitpunkt mit { $passages } Überrollungen in { $file } fallen die Bänder um mehr als { $fall } dB: die Schiene wurde geschliffen, und das Wachstum beginnt dort neu; frühere Zeitpunkte bleiben weg
only-ground = vor dem Zeitpunkt mit { $passages } Überrollungen wurde die Schiene geschliffen, denn ihre Bänder fallen um mehr als { $fall } dB, und kein späterer sagt etwas vom Wachstum; noch einmal messen oder diesen Zeitpunkt weglassen
no-coherence = { $file } hat keine Spalte `coherence`: jede Linie gilt als auf 5 % genau
is-kind-but-decay-rates-take-bands = ist "{ $kind }", aber für Abklingraten gilt "band": ihre Bänder sind unabhängig
give-the-speed-of-the-run = die Geschwindigkeit der Fahrt angeben, wie in speed = "100 km/h"
date-of-a-run = "first", "last" oder die Zahl der Überrollungen seit dem ersten Zeitpunkt der Pegel
run-since-first-date = at_date gilt als { $since } Überrollungen seit dem ersten Zeitpunkt der Pegel, { $counted } nach der Zählung ihrer Tabelle
date-that-is-there = "first", "last" oder einer der Zeitpunkte, { $dates } Überrollungen nach dem ersten,
is-date-of-too-few = ist { $date }, aber der Plan hat keine Pegel von drei Zeitpunkten oder mehr: ohne einen von zweien sagt nichts etwas über das Wachstum
is-place-of-too-few = ist { $place }, aber der Plan hat keine Frequenzgänge an zwei Stellen oder mehr
place-of-the-hammer = eine der Stellen des Hammers, { $places } m,
is-left-out-by-date = ist "{ $name }", aber Achslagerfahrten und Pegel ihrer Schiene werden nach Zeitpunkten weggelassen
is-the-only-data = ist "{ $name }", die einzigen Daten des Plans: es bleibt nichts, was sie vorhersagt
hold-out-names-one = `hold_out` muss eines von `date`, `position` und `data` nennen
data-cannot-be-parted = die Daten lassen sich nicht in solche teilen, die weggelassen werden, und solche, die sie vorhersagen; drei Zeitpunkte, zwei Stellen des Hammers oder zwei Arten von Daten angeben
say-what-differs = angeben, was anders ist: set = {"{"} key = value {"}"} oder without = ["…"]
changes-what-is-uncertain = `{ $place }` ändert `{ $key }`, im Plan ist das aber unsicher: auch weglassen, without = ["{ $name }"]
model-of-the-plan-says = Modell "{ $title }": { $error }
give-a-prior = eines von lognormal, normal, uniform und triangular angeben
leaves-nothing = lässt nichts von dem Bereich übrig, der sich rechnen lässt, { $low } bis { $high }
give-key-or-factor = den Schlüssel des Falls angeben oder multiplies = "…" mit einem Namen
name-the-factor = den Faktor benennen, wie "preload_stiffening"
is-no-key-of-a-vehicle = ist "{ $name }", was ein Fahrzeug nicht hat oder was nicht unsicher sein kann
keys-of-a-vehicle = nach vehicle. gehören speed.mean, speed.standard_deviation, traction_share, tractive_ratio, creepage, wheel_load, axle_load, wheel_mass, rolling_radius oder set.…
excludes-value-of-the-case = schließt { $value } aus, den Wert des Falls für `{ $key }`: er liegt jenseits der Enden oder von vier Standardabweichungen der Vorverteilung
widen-the-prior = die Vorverteilung weiter fassen oder den Fall berichtigen
is-key-of-a-vehicle-without-traffic = ist ein Schlüssel eines Fahrzeugs, aber der Plan nennt keinen Verkehr
traffic-has-several-vehicles = der Verkehr hat mehrere Fahrzeuge: { $names }
is-no-key-of-the-case = ist "{ $name }", aber die Falldatei hat keinen solchen Schlüssel
is-key-of-no-quantity = ist "{ $name }", wo eine Wahl, ein Name oder eine ganze Zahl steht
only-quantities-are-uncertain = nur Größen können unsicher sein
is-pass-by-but = ist "pass-by", aber { $why }
give-data-another-model = diesen Daten ein anderes Modell geben: set = {"{"} "track.model" = … {"}"}
silent-bands = { $file }: zu { $bands } ist kein Rauheitspegel bekannt, sie gelten als still; `roughness` gibt die anderen Bänder der Schiene an
wheels-taken-as-smooth = { $file }: ohne `wheel_roughness` gelten die Räder als glatt
not-for-calibration = vehicle[{ $index }] hat `{ $key }`, was eine Kalibrierung nicht nimmt; ein Rad mit einer Verteilung der Geschwindigkeit angeben
left-out-with-smc = bei sampler.kind = "smc", das keine Einlaufphase hat, weggelassen
middle-of-the-priors = in der Mitte der Vorverteilungen sagt der Fall: { $reason }
columns-of-no-kind = hat die Spalten { $columns }, aus denen keine Art von Messung folgt
is-run-without-speed = ist eine Fahrt mit Achslagermessung, deren Geschwindigkeit in keiner Spalte steht
write-run-into-a-plan = sie gehört in einen Plan: [[data]] mit kind = "axle-box" und speed
dates-without-traffic = hat Pegel oder Profile mehrerer Zeitpunkte, aber es gibt keinen Verkehr, unter dem sie gewachsen sind
averages-are-assumed = averages gilt als { $averages }, denn keine Spalte sagt, wie viele Schläge im Mittel einer Linie stecken
is-another-plan = steht schon da und ist nicht der Plan mit üblichen Vorverteilungen für diese Dateien
run-the-other-plan = riffel calibrate mit diesem Plan an Stelle des Falls rechnet ihn; ein anderer Ordner beginnt von neuem
lines-left-out = { $lost } von { $all } Linien haben zu wenig mit dem ersten Zeitpunkt gemein und bleiben weg
one-or-more = eins oder mehr
above-the-min = größer als min, { $min },
is-for-quantities = ist für Größen, bei `{ $key }` steht aber eine Wahl, ein Name oder eine ganze Zahl
needs-moments-or-median = braucht mean und standard_deviation oder median und factor
is-other-rail-in-this-curve = ist "{ $name }", aber contact.from.rail = "{ $of }" ist in einem Bogen von { $radius } m die Schiene "{ $rail }"
is-known-between = ist von { $low } bis { $high } Hz bekannt und wird nicht extrapoliert, gefragt ist aber nach { $asked } Hz
distance-of-the-bogies = der Abstand der Drehgestelle
wheelbase-of-the-bogie = der Achsstand
distance-of-the-contacts = der Abstand der Kontakte
leaves-nothing-between-its-ends = lässt nichts zwischen seinen Enden übrig: sie liegen mehr als 30 Standardabweichungen entfernt
larger-than = größer als { $what }, { $length } m,
kind-as-in-example = { $kind } wie "{ $example }"
is-no-number = ist keine Zahl, muss aber { $rule } sein

## Faults of the page

newer-request = eine neuere Anfrage ist an die Stelle dieser getreten
page-asks-again = die Seite fragt von selbst noch einmal
defect-of-riffel = das ist ein Fehler von Riffel; der Fall in der Adresszeile zeigt ihn wieder
page-misunderstood = Seite und Programm verstehen einander nicht
reload-page = die Seite neu laden: vielleicht ist sie älter als das Programm

## Modes of a wheelset

ordinal = { $order ->
        [1] erste
        [2] zweite
        [3] dritte
        [4] vierte
        [5] fünfte
        [6] sechste
       *[other] { $order }.
    }
rigid-body-longitudinal = starrer Körper: längs
rigid-body-lateral = starrer Körper: quer
rigid-body-bounce = starrer Körper: Tauchen
rigid-body-roll = starrer Körper: Wanken
rigid-body-yaw = starrer Körper: Gieren
symmetric-bending = { $ordinal } symmetrische Biegung
antisymmetric-bending = { $ordinal } antimetrische Biegung
torsional-mode = { $ordinal } Torsion
stretching-mode = { $ordinal } Dehnung
elastic-mode = { $ordinal } elastische Eigenform
mode-vertical = { $mode }, vertikal
mode-horizontal = { $mode }, horizontal
discs-against-wheels = { $mode } (Scheiben gegen Räder)
discs-against-each-other = { $mode } (Scheiben gegeneinander)

## What the physics refuses

out-of-range = { $quantity } ist { $value }{ $unit }, { $rule }
off-the-rails = im Gleichgewicht ist Radsatz { $wheelset } um { $shift } mm verschoben und um { $yaw } mrad verdreht, muss aber, um auf den Schienen zu bleiben, um weniger als { $farthest_shift } mm verschoben und { $largest_yaw } mrad verdreht sein
no-equilibrium-beyond = jenseits von { $percent } % dieses Bogens fand sich kein Gleichgewicht: er ist vielleicht enger, als es die Radsätze auf diesen Profilen vertragen; einen weiteren Bogen, weniger unausgeglichene Beschleunigung, weniger Moment und Antrieb oder weichere Federn nehmen
torque-beyond-friction = es gibt kein Gleichgewicht, und ein Antriebsmoment von { $torque } N m am Radsatz { $wheelset } ist mehr als die { $largest } N m, die die Reibung unter den Lasten seiner Räder trägt
beyond-full-slip = der Schlupf ist { $creepage } %, volles Gleiten beginnt in diesem Kontakt aber bei { $limit } %; im mittleren Zustand muss ein Haftgebiet bleiben

## Records that are refused

heights-without-position = es gibt eine Spalte mit Höhen und keinen Ort
heights-without-position-but = es gibt eine Spalte mit Höhen und keinen Ort: Spalte { $column } ist "{ $cell }", und das ist keine Zahl
no-heights = es gibt keine Spalte mit Höhen
no-heights-but = es gibt keine Spalte mit Höhen: { $reason }
no-table-of-numbers = hier und darunter beginnt keine Tabelle von Zahlen
cell-has-other-mark = Spalte { $column } ist "{ $cell }", mit { $other }; sonst hat die Datei { $own }
cell-in-brackets = Spalte { $column } ist "{ $cell }": Klammern sind für die einen ein Minus, für andere ein Zweifel; die Zahl ohne sie schreiben
cell-with-letters = Spalte { $column } ist "{ $cell }", keine bloße Zahl: eine Einheit steht im Kopf, eine Bemerkung in einer eigenen Spalte
cell-with-marks = Spalte { $column } ist "{ $cell }", keine bloße Zahl: was die übrigen Zeichen bedeuten, gehört in eine eigene Spalte
cell-is-no-number = Spalte { $column } ist "{ $cell }", keine Zahl

## Achslager

train-is-too-slow = der Zug fährt nirgends lange genug für die längste Wellenlänge, { $longest } m, schneller als { $slowest } km/h
stretch-is-too-slow = das längste Stück ohne Lücke ist { $length } m lang und wird im Mittel mit { $speed } km/h befahren, müsste aber mit mindestens { $slowest } km/h befahren werden; { $said }
stretch-is-too-short = das längste Stück ohne Lücke ist { $length } m lang, für Wellen bis { $longest } m müssten es aber bei { $speed } km/h { $least } m sein; { $said }
roughness-of-rail-and-wheel = die Rauheit ist die von Schiene und Rad zusammen, ohne das, was über mindestens 16 Umdrehungen mit dem Rad wiederkehrt
roughness-through-patch = die Rauheit ist das, was die Kontaktfläche durchlässt, die { $patch } mm lang ist: bei Wellenlängen unter etwa dem Fünffachen davon ist die Schiene selbst rauer; --contact-filter gibt das zurück
axle-box-moves-as-wheelset = das Achslager bewegt sich nach Annahme wie der Radsatz am Kontakt: die Biegung der Welle zwischen Rad und Lager bleibt außer Acht
waves-of-other-wheels-left-out = die Wellen, die die anderen Räder von [train] die Schiene entlang senden, bleiben außer Acht

## Daten, die abgelehnt werden

no-date = "{ $text }" ist kein Datum; zu schreiben als 2026-01-31 oder 31.01.2026 oder als Tageszahl einer Tabellenkalkulation von 40000 bis 60000
year-of-two-digits = "{ $text }" hat ein Jahr aus zwei Ziffern; alle vier schreiben
days-in-two-orders = "{ $text }" und "{ $other }" haben Tag und Monat in verschiedener Reihenfolge; beide wie 2026-01-31 schreiben
date-may-be-two = "{ $text }" kann zweierlei Datum sein; { $one } oder { $other } schreiben
year-is-out-of-range = "{ $text }" ist kein Tag zwischen { $first } und { $last }
day-is-not-in-calendar = "{ $text }" steht nicht im Kalender
of-column = Spalte `{ $column }`: { $sentence }

## Achslagerfahrten, die abgelehnt werden

at-line = Zeile { $number }
at-sample = Abtastwert { $number }
samples-are-lost = es fehlen Abtastwerte, wo die Zeit springt
time-is-repeated = eine Zeile ohne eigene Zeit bleibt weg, weil sich die Zeit wiederholt
odometer-leaps = der Weg springt um mehr als { $length } m
value-is-missing = ein Wert fehlt
number-marks-missing-value = { $mark } steht für einen fehlenden Wert
found-once = { $what }: einmal, bei { $at }
found-often = { $what }: { $count }-mal, zuerst bei { $at }
time-falls = die Zeit fällt von { $before } s auf { $time } s
speed-is-below-zero = die Geschwindigkeit ist { $speed } m/s, darf aber nicht kleiner als null sein
speed-beyond-any-train = die Geschwindigkeit ist { $speed } m/s, { $kilometres } km/h, und damit höher als die jedes Zuges; stimmt ihre Einheit?
odometer-falls = der Weg fällt von { $before } m auf { $odometer } m, muss aber steigen; wo die Kilometrierung entlang der Fahrt fällt, stattdessen die Geschwindigkeit angeben
odometer-beyond-any-train = nach dem Weg fährt der Zug { $speed } m/s, { $kilometres } km/h, schneller als jeder Zug; stimmen dessen Einheit und die Abtastrate von { $rate } Hz?
times-begin-anew = die Zeiten schließen nicht an die der Datei davor an, und kein Weg sagt, wo sie liegt: sie gilt als eine weitere Fahrt vom selben Ort aus
there-is-no-reading = es gibt keinen Messwert
every-row-lacks-a-value = jeder Zeile fehlt ein Wert, der nötig ist
mean-is-gravity = der Mittelwert ist { $mean } { $unit }, so groß wie die Erdbeschleunigung in { $other }: die Einheit ist falsch
give-in-unit = in { $unit } angeben
clipped-at-end = bei { $end } m/s² übersteuert, in { $count } Abtastwerten, { $share } %; zuerst bei { $at }
clipped-at-ends = bei { $high } m/s² und { $low } m/s² übersteuert, in { $count } Abtastwerten, { $share } %; zuerst bei { $at }
too-many-are-clipped = { $sentence }; höchstens { $most } % dürfen es sein
levels-too-low-there = { $sentence }: Pegel sind dort zu niedrig
drops-out-once = fällt einmal aus und behält länger als { $time } ms einen Wert, bei { $at }
drops-out-often = fällt { $count }-mal aus und behält länger als { $time } ms einen Wert, zuerst bei { $at }
vibrates-beyond-any-axle-box = der Effektivwert ist { $rms } m/s², mehr als an jedem Achslager; stimmt die Einheit?
clock-drifts = die Zeiten ergeben entlang der Fahrt { $slowest } bis { $fastest } Abtastwerte je Sekunde: die Uhr driftet; { $rate } gilt
clock-without-one-rate = die Zeiten ergeben entlang der Fahrt { $slowest } bis { $fastest } Abtastwerte je Sekunde, müssen aber auf { $percent } % eine Rate ergeben; sind die Zeiten falsch, die Abtastrate mit { KEY("--rate") } angeben
times-do-not-rise = die Zeiten steigen nicht von Zeile zu Zeile; die Abtastrate mit { KEY("--rate") } angeben
no-column-of-times = es gibt keine Spalte mit Zeiten wie time_s; die Abtastrate mit { KEY("--rate") } angeben
times-are-text = Spalte { $column }, `{ $name }`, enthält keine Zahlen, sondern "{ $cell }"; Zeiten sind in Sekunden nötig, oder als Uhrzeit wie 02:59:54.25: so schreiben, oder die Abtastrate mit { KEY("--rate") } angeben
times-make-another-rate = die Zeiten ergeben { $rate } Abtastwerte je Sekunde, { KEY("--rate") } sagt aber { $given }
given-rate-is-taken = { $sentence }, und das gilt: eine der beiden Uhren geht falsch
file-says-its-rate = die Datei nennt { $rate } Abtastwerte je Sekunde; { KEY("--rate") } weglassen
column-has-no-unit = Spalte `{ $name }` hat keine Einheit, die hier bekannt ist; { $one } oder { $other } nennen
channels-are-for-wav = { KEY("--channels") } ist für WAV-Dateien: was in anderen Dateien steht, sagen ihre Köpfe
no-acceleration-given = es gibt keine Beschleunigung
lengths-of-arrays-differ = { $name } hat { $count } Werte, { $first } aber { $other }
place-of-other-length = Geschwindigkeit oder Weg haben { $count } Werte, { $first } aber { $other }
two-channels-of-one-name = zwei Kanäle heißen "{ $name }" und gälten als eine Schiene; verschieden nennen
file-is-binary = die Datei ist binär: Byte { $at } ist { $value }, das hat kein Text
file-of-binary-format = die Datei ist { $name } und kein Text: { $reader } liest sie; ihre Spalten als Text schreiben
file-of-other-encoding = die Datei ist { $encoding }; als UTF-8 schreiben
no-table-under-a-head = es gibt keine Tabelle unter einem Kopf wie { $example }
no-column-of-accelerations = es gibt keine Spalte mit Beschleunigungen; { $one } oder { $other } nennen
place-is-empty = Spalte `{ $name }` ist in den meisten Zeilen leer, der Ort jedes Abtastwerts ist aber nötig: ausfüllen oder, wo die Geschwindigkeit konstant war, sie mit { KEY("--speed") } angeben
no-column-of-the-place = es gibt keine Spalte mit Geschwindigkeiten oder Wegen wie speed_km_per_h oder odometer_m; wo die Geschwindigkeit konstant war, sie mit { KEY("--speed") } angeben
line-is-too-long = die Zeile ist länger als { $most } Bytes
wav-has-no-units = eine WAV-Datei hat keine Einheiten: ihre Kanäle der Reihe nach nennen, jeden mit seinem Wert bei Vollaussteuerung, wie in { $example }
wav-has-other-count = { $count ->
        [one] die Datei hat 1 Kanal, { KEY("--channels") } nennt aber { $named }
       *[other] die Datei hat { $count } Kanäle, { KEY("--channels") } nennt aber { $named }
    }
channel-without-scale = { KEY("--channels") } hat `{ $channel }`, muss aber jedem Kanal seinen Wert bei Vollaussteuerung geben, größer als null, wie in { $example }
no-channel-of-accelerations = { KEY("--channels") } nennt keine Beschleunigung wie in { $example }
no-channel-of-the-place = kein Kanal ist die Geschwindigkeit oder der Weg; einen so nennen wie in speed_km_per_h=300 oder, wo die Geschwindigkeit konstant war, sie mit { KEY("--speed") } angeben
wav-ends-early = die WAV-Datei endet, bevor ihr Kopf es sagt, oder ist nicht zu lesen
wav-of-another-form = keine WAV-Datei, die hier gelesen wird: { $reason }
no-riff-of-waves = keine RIFF- oder RF64-Datei mit Wellen
samples-before-their-form = ihre Abtastwerte stehen vor deren Format
form-is-cut-short = ihr Format ist abgeschnitten
samples-of-other-kind = nur ganze Zahlen von 8 bis 32 Bit oder Gleitkommazahlen von 32 oder 64
no-acceleration-over-time = die Datei hat keine Beschleunigung über der Zeit (Dataset 58 mit einer Abszisse der Art 17 und einer Ordinate der Art 12)
no-place-over-time = die Datei hat weder Geschwindigkeit (Art 11) noch Weg (Art 8) über der Zeit; wo die Geschwindigkeit konstant war, sie mit { KEY("--speed") } angeben
signal-of-other-form = "{ $title }" muss { $points } reelle Werte mit einem Schritt von { $step } s haben wie die erste Beschleunigung
signal-begins-elsewhere = "{ $title }" beginnt bei { $begin } s und "{ $first }" bei { $other } s, alle Signale einer Fahrt müssen aber zusammen beginnen: auf die Zeiten kürzen, die alle haben
times-are-uneven = die Zeiten von "{ $title }" sind ungleichmäßig, müssen aber einen Schritt haben
times-in-other-unit = die Zeiten von "{ $title }" stehen in { $unit }, und das ist keine Zeiteinheit
signal-without-unit = "{ $title }" ist { $what } ohne Einheit: weder die Achse noch ein Dataset 164 nennt eine
signal-with-other-unit = "{ $title }" ist { $what }, trägt aber die Einheit "{ $unit }"
an-acceleration = eine Beschleunigung
a-speed = eine Geschwindigkeit
an-odometer = ein Weg
odometer-makes = der Weg ergibt im Mittel { $speed } km/h
speeds-make = die Geschwindigkeiten ergeben im Mittel { $speed } km/h
given-speed-says = { KEY("--speed") } sagt { $speed } km/h
but-other-says = { $one }, aber { $other }
one-is-wrong = { $sentence }: eines von beiden ist falsch oder hat eine andere Einheit
first-is-taken = { $sentence }; das Erste gilt
take-the-wrong-one-out = das Falsche herausnehmen oder, wo die Geschwindigkeit konstant war, sie mit { KEY("--speed") } angeben

## Profile, die abgelehnt werden

is-profile-of-wheel = ist nach eigener Angabe das Profil eines Rads, verlangt ist aber eine Schiene
is-profile-of-rail = ist nach eigener Angabe das Profil einer Schiene, verlangt ist aber ein Rad
is-list-of-slices = ist eine Liste von Schnitten entlang der Schiene oder um das Rad: eine der Dateien angeben, die sie nennt
is-wheel-not-laid-so = ist ein Rad, und das wird nicht nach "{ $alignment }" angelegt
is-rail-not-laid-so = ist eine Schiene, und die wird nicht nach "{ $alignment }" angelegt
is-rail-against-wheel = ist eine Schiene, { $nominal } aber ein Rad
is-wheel-against-rail = ist ein Rad, { $nominal } aber eine Schiene
wider-than-any = das Profil ist { $across } m breit, breiter als jedes Rad und jede Schiene: die Einheit prüfen
narrower-than-any = das Profil ist { $across } mm breit, schmaler als jedes Rad und jede Schiene: die Einheit prüfen
datum-circle-not-known = die Spurkranzspitze liegt bei x = { $tip } mm, und der Spurkranzrücken ist nicht gemessen, sodass der Messkreis nicht bekannt ist: Koordinaten mit dem Ursprung auf ihm angeben, { $back } mm vom Spurkranzrücken
file-of-several-profiles = die Datei enthält mehrere Profile: eine Datei mit einem davon angeben
column-def-without-x-and-y = ColumnDef ist "{ $value }", muss aber die Spalten X und Y nennen
line-without-x-and-y = "{ $text }" hat keine Zahlen X und Y
line-without-millimetres = "{ $text }" hat keine Zahl in Millimetern
line-is-no-pair = "{ $text }" ist kein Zahlenpaar x, y
other-count-of-columns = { $count ->
        [one] es gibt 1 Spalte, ein Profil hat aber zwei: Querkoordinate und Höhe
       *[other] es gibt { $count } Spalten, ein Profil hat aber zwei: Querkoordinate und Höhe, unter einem Kopf wie y_mm,z_mm, wo es weitere gibt; je eine Schiene oder ein Rad angeben
    }
head-says-other-unit = der Kopf sagt { $unit }: ein Profil in mm oder m angeben
head-with-two-units = der Kopf gibt den beiden Spalten verschiedene Einheiten: ein Profil durchweg in mm oder m angeben
line-without-both-sides = "{ $text }" ist nicht y und z beider Seiten
value-not-known = { $name } ist "{ $value }", und das ist nicht bekannt
value-must-be-number = { $name } ist "{ $value }", muss aber eine Zahl sein
line-of-no-head = "{ $text }" ist weder eine Zeile eines Kopfs noch sind es Koordinaten
units-per-metre-above-zero = units.len.f muss größer als null sein: wie viele Einheiten der Datei einen Meter ergeben
no-section-of-profile = "{ $text }" ist kein Abschnitt eines Profils: das sind header, spline und point
section-closes-none = { $section }.end schließt kein { $section }.begin
section-without-end = { $section }.begin hat kein { $section }.end: die Datei ist abgeschnitten
line-is-no-point = "{ $text }" ist kein Punkt y z
line-is-no-key = "{ $text }" ist weder Schlüssel = Wert noch ein Abschnitt
too-few-points = ein Profil braucht mindestens { $least } Punkte, und dieses hat { $count }
too-many-points = das Profil hat { $count } Punkte, mehr als die { $most }, die gelesen werden
coordinate-not-finite = eine Koordinate ist nicht endlich
point-stands-twice = der Punkt steht zweimal da
outline-crosses = der Umriss kreuzt sich hier oder läuft auf sich selbst zurück, nahe x = { $place } mm, wie bei zwei Messläufen oder Punkten in falscher Reihenfolge
outline-closes = der Umriss schließt sich hier: nur die Lauffläche angeben, von einer Flanke zur anderen oder vom Spurkranz bis zur Außenseite
curve-turns-back = die Kurve kehrt hier quer zum Gleis um, wie bei einem Profil mit einer Schleife oder mit Punkten in falscher Reihenfolge
outline-comes-back = der Umriss kommt hier über sich selbst zurück, wie bei zwei Messläufen
scatter-not-positive = die Streuung der Punkte ist { $scatter } m, muss aber größer als null sein
crown-at-end = der höchste Punkt der Schiene liegt an ihrem Ende, wie bei einem Profil, das auf dem Kopf steht oder am Scheitel abgeschnitten ist
no-datum-circle = x = 0, der Messkreis der Lauffläche, liegt nicht auf dem Profil des Rads
no-flank-of-flange = die Flanke des Spurkranzes liegt nicht auf dem Profil des Rads
flange-outside = der Spurkranz liegt bei x über null: das Profil ist gespiegelt, denn x muss zur Außenseite positiv sein
wheel-upside-down = das Profil hat keinen Spurkranz unter der Lauffläche: es steht auf dem Kopf, denn y muss die Höhe sein, und ein Spurkranz hängt herab
wheel-without-flange = das Profil hat keinen Spurkranz
profile-lies-elsewhere = das gemessene Profil liegt nirgends näher als 20 mm am nominellen: Ursprung, Lage und Einheit prüfen
measured-without-tip = das gemessene Profil reicht nicht um die Spitze eines Spurkranzes, sodass es nicht nach ihr angelegt werden kann
nominal-without-tip = das nominelle Profil reicht nicht um die Spitze eines Spurkranzes, sodass nicht nach ihr angelegt werden kann
field-side-not-measured = die Außenseite der Schiene, Ecke und Flanke, ist nicht gemessen, sodass nicht nach ihr angelegt werden kann
touches-beyond-end = unter Last berührt das { $side } Rad jenseits des Endes eines Profils
touches-beside-rail = das { $side } Rad berührt neben seiner Schiene
left-of-wheels = linke
right-of-wheels = rechte
rails-overlap = bei einer Spurweite von { $gauge } mm überlappen sich die Schienen
ends-above-gauge-height = die Innenseite der Schiene endet über der Messhöhe von { $height } mm unter ihrem Scheitel, oder das Profil ist gespiegelt: x muss zur Außenseite positiv sein
wheel-has-left-its-rail = bei einer Querverschiebung von { $shift } mm und einem Gierwinkel von { $yaw } mrad berührt das { $side } Rad seine Schiene nicht
is-cone-without-profile = ist "cone", und das hat kein Profil
name-a-profile = ein Profil wie "{ $name }" oder eine Datei nennen
check-places-of-flanges = profiles.gauge, flange_back_distance und flange_back_position prüfen
is-nominal-rail = ist "{ $name }", und das ist eine Schiene
is-nominal-wheel = ist "{ $name }", und das ist ein Rad
nominal-wheels = nominelle Räder: { $known }
nominal-rails = nominelle Schienen: { $known }
is-profile-in-linear-theory = ist ein Profil, curve.theory = "linear" rollt aber auf Kegeln
choose-cone = wheel = "cone" wählen, mit der äquivalenten Konizität von `riffel profile CASE --wheelset`
is-set-but-of-cones = ist gesetzt, gehört aber zu profiles.wheel = "cone"

## Fortschritt

nothing-done = 0 von { $total } { $what }
so-many-done = { $done } von { $total } { $what }, { $rate } je Sekunde, noch { $left }
share-done = { $what }: { $percent } %
share-done-and-left = { $what }: { $percent } %, noch { $left }
so-many-seconds = { $time } s
so-many-minutes = { $time } min
so-many-hours = { $time } h
so-many-days = { $time } Tage
progress-draws-of-calibration = Ziehungen der Kalibrierung
progress-reading = Einlesen
progress-roughness = Rauheit
progress-stability = Stabilität
progress-taking-in-blocks = Aufnehmen der Blöcke
progress-passages = Überrollungen
progress-fit = Anpassung des Verschleißbeiwerts
progress-growth-map = Wachstumskarte
progress-figures = Bilder des Aufsatzes
progress-remedies = Wachstum mit Maßnahmen
progress-contact = Kontakt
progress-validation = Validierung
progress-field = Feld
progress-wheels = Wachstum unter den Rädern
progress-models = Wachstum nach den Modellen
progress-listening = Abhören
progress-traffic = Wachstum unter dem Verkehr
progress-variants = Wachstum der Varianten
progress-bay = Wachstum über das Schwellenfach
progress-writing-map = Schreiben von map.csv
progress-draws = Ziehungen
progress-simulations = Simulationen
progress-samples = Stichproben

## Universal files, die abgelehnt werden

no-dataset = die Datei enthält kein Dataset, das mit -1 in den Spalten 5 und 6 begänne
outside-of-datasets = das steht außerhalb der Datasets, die mit -1 in den Spalten 5 und 6 beginnen und enden
dataset-cut-short = das Dataset, das hier beginnt, ist vom Ende der Datei abgeschnitten
record-missing = das Dataset endet, wo { $record } stehen muss
unknown-form-of-dataset = Spalte 7 muss leer sein, oder "b" in einem Dataset 58, nicht "{ $text }"
field-is-no-integer = { $what } muss eine ganze Zahl von höchstens 32 Bit sein, nicht "{ $text }"
field-is-no-number = { $what } muss eine endliche Zahl sein, nicht "{ $text }"
field-has-no-meaning = { $what } muss { $allowed } sein, nicht { $value }
field-not-positive = { $what } muss positiv sein, nicht { $value }
column-must-be-blank = Spalte { $column } muss leer sein, denn sie liegt zwischen zwei Feldern
units-stated-twice = die Datei nennt ihre Einheiten ein zweites Mal, und andere
too-few-numbers = die Anzahl der Punkte ist { $points }, das sind { $numbers } Zahlen, das Dataset enthält aber { $held }
too-many-numbers = die Anzahl der Punkte ist { $points }, das sind { $numbers } Zahlen, das Dataset geht aber dahinter weiter
line-lacks-numbers = diese Zeile muss { $needed } Zahlen enthalten, nicht { $held }
text-after-numbers = die Zahlen dieser Zeile enden in Spalte { $column }, es folgt aber Text
no-mark-behind-bytes = die Anzahl der Punkte ist { $points }, das sind { $bytes } Bytes, aber dahinter folgt nicht das schließende -1
other-count-of-bytes = die Anzahl der Bytes ist { $declared }, die Punkte haben aber { $bytes }
