# Français : la une de la page, les messages de `map` et la première page du rapport. Le reste se dit en anglais.

## Temps, nombres et mots qui reviennent

sentence = { $words }.
in-brackets = {" "}({ $words })
help-in-four-letters = aide
note = remarque : { $remark }
both = { $one } et { $other }
days-between = { $early } à { $late } jours
days-of = { $days } jours
months-between = { $early } à { $late } mois
months-of = { $months } mois
years-between = { $early } à { $late } ans
years-of = { $years } ans
million-axles = { $axles } millions d’essieux
million-axles-between = { $early } à { $late } millions d’essieux
one-wavelength = { $wavelength } mm
longer-waves = plus longues
shorter-waves = plus courtes
ordinal = { $order ->
        [1] premier
       *[other] { $order }e
    }

## Carte de croissance

map-window = carte
traffic-window = trafic
growth-map = Carte de croissance
growth-rate-per-passage-column = taux par passage
passages-to-double-column = passages pour doubler
speed-column = vitesse km/h
wavelength-of-band = longueur d’onde mm
frequency-in-hertz = fréquence Hz
decays-in-table = décroît
edge-in-table = bord
at-edge-in-table = { $value } (bord)
at-edge-of-window = , au bord de la fenêtre
sign-of-growth = L’usure croît où Re Ŵ₁ < 0 (en couleur) : la dissipation est en opposition de phase avec le profil ; facteur temporel exp(+iωt), freinage positif.
grows-fastest-under = { $range } croissent le plus vite sous { $traffic } ; { $wavelength } mm dominent et doublent en { $time }
grows-fastest-under-within = { $range } croissent le plus vite sous { $traffic } ; { $wavelength } mm dominent et doublent en { $time } (80 % : le coefficient d’usure est incertain)
grows-fastest-without-rate = { $range } croissent le plus vite sous { $traffic } ; { $wavelength } mm dominent, plus vite que sur toute voie connue : longueurs d’onde et ordre tiennent, le taux non
grows-fastest-by-damage = { $range } croissent le plus vite sous { $traffic } ; { $wavelength } mm dominent et doublent en { $time } si les profondeurs de { KEY("damage") } sont telles qu’écrites, ce qu’aucune mesure n’a montré
helps-most = ce qui aide le plus : { $title } ; la croissance baisse de { $percent } % et double en { $time }
helps-most-of-all = ce qui aide le plus : { $title } ; alors rien ne croît
helps-most-in-order = ce qui aide le plus : { $title } ; la croissance baisse de { $percent } %
on-straight-track = en alignement
in-this-curve = dans cette courbe
in-this-curve-of = dans cette courbe de { $radius } m
wear-unlike-rails = { $place }, le rail perdrait { $depth } mm par 100 MGT, où les rails perdent { $low } à { $high } : longueurs d’onde et ordre tiennent, mais taux et durées sont faux d’autant ; ce que le rail a perdu, { KEY("wear.measured") } = "1 mm / 100 MGT", les corrige
faster-than-known = plus vite que sur toute voie connue
nothing-grows = rien ne croît dans cette fenêtre
traffic-given = le trafic donné
traffic-of-main-line = le trafic usuel d’une grande ligne
traffic-of-freight-line = le trafic usuel d’une ligne de fret
traffic-of-heavy-haul = le trafic usuel d’une ligne de trains lourds
traffic-of-metro = le trafic usuel d’un métro
traffic-of-tram = le trafic usuel d’un tramway
traffic-of-curve = le trafic usuel de cette courbe
traffic-at-speeds = { $traffic } ({ $speeds })
traffic-at-speeds-a-day = { $traffic } ({ $speeds }, { $axles } essieux par jour)
rate-of-wheels-on-one-line = le taux est celui de roues de cette seule sorte, toutes sur une ligne large de { $width } mm ; `riffel forecast` dit celui d’un trafic
rate-of-wheels-over-a-band = le taux est celui de roues de cette seule sorte, réparties sur une bande de { $width } mm ; `riffel forecast` dit celui d’un trafic
highest-at-each-speed = plus forte croissance à chaque vitesse, { $shortest }–{ $longest } mm
oscillates-by-itself = la boucle oscille d’elle-même
oscillates-under = la boucle oscille d’elle-même près de { $frequency } Hz sous { $traffic }, comme un crissement : ses taux de croissance ne veulent rien dire, et aucune onde ne domine
no-growth-in-draws = dans { $share } % des tirages rien ne croît
no-crest = aucune crête dans cette fenêtre : la croissance monte vers { $ends } mm
one-branch = la crête est une seule branche, qui croît à { $words }
strongest-branch = la branche la plus forte croît à { $words } ; { $noun } : { $named }
candidate-leads = { $first } vient en tête avec une part de { $share }, puis { $second } avec { $other }.
branch-with-share = { $words } avec { $share } de sa croissance
branches-over-the-bay = en moyenne sur la travée, { $branches }
more-branches = { $count } de plus
weaker-branches = { $count ->
        [one] 1 branche plus faible
       *[other] { $count } branches plus faibles
    }
frequency-is-not-kept = de { $slow } à { $fast }, la fréquence de l’onde la plus rapide va de { $low } à { $high } Hz : aucune fréquence n’est fixe
so-many-observations = { $count ->
        [one] 1 observation
       *[other] { $count } observations
    }
observations-outside = { $all }, dont { $outside } hors de la carte

wheel-and-rail-part = une amplitude de { $amplitude } µm porte |P₁/P₀| à { $worst } : la roue quitte le rail ; les forces sont linéaires jusqu’à { $limit } µm (les taux valent pour de petites amplitudes et ne changent pas)
    .short = { $amplitude } µm : la roue quitte le rail (|P₁/P₀| = { $worst }) ; forces linéaires jusqu’à { $limit } µm
rail-without-support = le rail n’a pas d’appui : sous quelque { $free_beam_from_hz } Hz ({ $window } : dès { $lowest } Hz) semelles, traverses et ballast changent sa réceptance
    .short = le rail n’a pas d’appui : faux sous quelque { $free_beam_from_hz } Hz ({ $window } : dès { $lowest } Hz)
rail-without-shear = le rail fléchit sans cisaillement : sa réceptance est à quelque 9° près à { $euler_beam_up_to_hz } Hz, à 24° et 14 % à 1500 Hz ({ $window } : jusqu’à { $highest } Hz)
    .short = le rail fléchit sans cisaillement : 24° et 14 % d’écart à 1500 Hz ({ $window } : jusqu’à { $highest } Hz)

## Causes

cause-at = { $wavelength } mm croissent le plus à { $speed }, à { $frequency } Hz, une résonance ({ $mechanism })
cause-near = { $wavelength } mm croissent le plus à { $speed }, où { $frequency } Hz est à { $distance } % de { $resonance } Hz ({ $mechanism })
cause-alone = { $wavelength } mm croissent le plus à { $speed }, à { $frequency } Hz ; aucune résonance de la voie ou de l’essieu à moins de { $within } % de là
cause-loop = pas de résonance : la boucle de la force, du glissement et de l’usure
others-out-of-reach = aucune autre résonance ne se trouve à { $low } à { $high } Hz, où les trains de ce trafic passent sur { $wavelength } mm
nothing-against = rien de ce que le cas sait ne parle contre
mechanism-at = { $mechanism } ({ $frequency } Hz)
mechanism-full-track = résonance de toute la voie
mechanism-given-dip = creux de la réceptance donnée
mechanism-given-peak = pic de la réceptance donnée
mechanism-grinding-mark = marque de meulage
mechanism-growth-ridge = crête de croissance
mechanism-lateral-pinned-pinned = pinned-pinned, latéral
mechanism-measured-dip = creux de la réceptance mesurée
mechanism-measured-peak = pic de la réceptance mesurée
mechanism-p2 = résonance P2
mechanism-pinned-pinned = pinned-pinned, vertical
mechanism-rail-on-pad = rail sur semelle
mechanism-sleeper-antiresonance = antirésonance des traverses
mechanism-support-spacing = passage des traverses
mechanism-unlisted = une cause qui n’est pas dans la liste
mechanism-wheel-circumference = circonférence de la roue
mechanism-wheelset-bending = flexion de l’essieu
mechanism-wheelset-torsion = torsion de l’essieu
torsional-mode = { $ordinal } mode de torsion
stretching-mode = { $ordinal } mode longitudinal
symmetric-bending = { $ordinal } mode de flexion symétrique
antisymmetric-bending = { $ordinal } mode de flexion antisymétrique
elastic-mode = { $ordinal } mode élastique
mode-horizontal = { $mode }, horizontal
mode-vertical = { $mode }, vertical
discs-against-each-other = { $mode } (disques l’un contre l’autre)
discs-against-wheels = { $mode } (disques contre roues)
rigid-body-bounce = corps rigide : galop
rigid-body-lateral = corps rigide : latéral
rigid-body-longitudinal = corps rigide : longitudinal
rigid-body-roll = corps rigide : roulis
rigid-body-yaw = corps rigide : lacet

## Ce qui porte le rail

rail-word = rail
free-beam = poutre libre de { $beam }{ $moving }
rail-on-pads = rail de { $beam }{ $moving } sur semelles ({ $pad })
sleepers-and-ballast = , traverses ({ $mass } kg) et ballast ({ $ballast })
spacing = {" "}tous les { $spacing } m,{" "}
spread-evenly = réparties uniformément
discrete = discrètes
under-moving-load = {" "}sous une charge mobile
from-preset = , préréglage { $name }
receptance-from-file = réceptance lue dans { $file }

## Première page du rapport

author = Auteur
beside-stand = { $count ->
        [one] À côté se tient { $wavelengths } : elle enfle et s’efface d’un appui à l’autre.
       *[other] À côté se tiennent { $wavelengths } : elles enflent et s’effacent d’un appui à l’autre.
    }
course-of-wavelength = { $wavelength }, { $first } à { $last } : { $course }
date-of-report = Date
how-bad-and-where = Combien, et où
in-brief = En bref
instrument = Appareil
limit-of-name = limite { $name }
line-of-site = Ligne
made-by = fait par riffel { $version }. Les mêmes fichiers et la même version donnent le même rapport
measured-on = Mesuré le
model-does-not-explain-growth = le modèle n’explique pas la croissance mesurée, et ne peut donc pas dire ce qui la réduirait
no-case-given = aucun cas n’a été donné
no-dates-are-told = les dates, les durées et ce que des mesures épargneraient sont donc laissés de côté ici ; plus bas, ils figurent tels que le modèle les donne
no-roughness-given = aucune rugosité n’a été donnée
no-warnings = aucun
no-wavelength-stands-out = aucune longueur d’onde ne domine la rugosité
not-plausible = Peu plausible
place-of-site = Lieu
rail-roughness-and-corrugation = Rugosité et usure ondulatoire du rail
railway = Réseau
roughness-not-diagnosed = la rugosité n’a pas été diagnostiquée
since-when = Depuis quand
track = Voie
two-sentences = { $one } { $other }
wavelength-stands-out = { $wavelength } domine, { $level } dB
wavelength-stands-out-at = { $wavelength } domine sur { $place }, { $level } dB
what-comes = Ce qui vient
what-helps = Ce qui aide
what-is-heard = Ce que l’on entend
what-it-costs = Ce que cela coûte
what-to-grind = Ce qu’il faut meuler
why-and-how-sure = Pourquoi, et avec quelle certitude

## La une de la page

web-tagline = quelle usure ondulatoire croît, à quelle vitesse et pourquoi
web-headline = À quoi s’attendre
web-explore = Explorer
web-compare = Comparer
web-measure = Mesurer
web-motion = Mouvement
web-paper = Article
web-take-away = Emporter
web-language = Langue
web-growth-map = Carte de croissance
web-why-there = Pourquoi là
web-what-helps = Ce qui aide
web-show-why = Pourquoi là
web-show-helps = Ce qui aide
web-not-known = inconnu
web-nothing-grows-here = rien ne croît
web-order-holds = longueurs d’onde et ordre tiennent, le taux non
web-until-doubled = et les ondes seront deux fois plus hautes{ $band ->
    [no] {""}
   *[other] {" "}(intervalle à 80 %)
 }
web-no-cause = Sous la roue du cas, rien ne croît à ces vitesses.
web-speaks-for = Pour
web-speaks-against = Contre
web-would-settle = Trancherait
web-traffic-curve = Croissance sous le trafic
web-wavelength = longueur d’onde
web-speed = vitesse
web-frequency = fréquence
