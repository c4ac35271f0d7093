// Words of the page in English and German, and numbers as engineers write them.

/** Rails by their names. */
const RAILS = { left: 'links', right: 'rechts', low: 'innen', high: 'außen' };

const WORDS = {
  en: {
    explore: 'Explore', compare: 'Compare', measure: 'Measure', motion: 'Motion', paper: 'Paper', take_away: 'Take away',
    tagline: 'which corrugation grows, how fast, and why',
    case: 'Case', handles: 'Handles', theme: 'Light or dark', language: 'Language',
    growth_map: 'Growth map', wavelength: 'wavelength', speed: 'speed', frequency: 'frequency',
    growth_rate: 'growth rate per passage', per_passage: 'per passage', rate: 'rate per passage', nothing_grows: 'nothing grows in this window', no_difference: 'no difference',
    hold: 'Hold scale', hold_help: 'Keep the colour scale while values change',
    headline_mark: (place) => `fastest under the traffic: ${place}`, to_highest: 'Highest growth', loop: 'The loop at the cursor', growth_curve: 'Growth over wavelength',
    rail_name: (name) => name, rail_named: (name) => (name ? `rail ${name}` : 'rail'), receptance: 'Receptance', force: 'Normal force P₁/P₀', rail: 'rail', wheel: 'wheel', contact: 'contact',
    grows_here: 'grows', decays_here: 'decays', time: 'time factor exp(+iωt), Δ upward on the rail; to the left is antiphase',
    profile: 'profile Δ', normal: 'normal force P₁', tangential: 'tangential force Q₁', lateral_force: 'lateral force Q_y', angular: 'angular velocity Ω₁',
    dissipation: 'dissipation W₁ at the rail', amplitude: 'amplitude', phase: 'phase', quantity: 'oscillation',
    direction_only: 'directions are true, lengths are not; amplitudes in the table',
    parts: 'Wheel and rail part: |P₁| exceeds P₀ at this amplitude. Signs and rates hold for small amplitudes.',
    sentence: (p) => `${p.lambda} mm at ${p.speed} is ${p.hertz} Hz. The normal force ${p.force}. The rail dissipates ${p.where}, so ${p.verdict}`,
    leads: (d) => `leads the profile by ${d}°`, lags: (d) => `lags the profile by ${d}°`, inphase: 'is in phase with the profile',
    troughs: (d) => `mostly in the troughs (${d}° from the crests)`, crests: (d) => `mostly on the crests (${d}° from them)`,
    doubles: (n) => `the troughs deepen: corrugation grows and doubles in ${n}.`,
    halves: (n) => `the crests wear off: corrugation decays and halves in ${n}.`,
    stays: 'corrugation neither grows nor decays.',
    notes: 'Notes', stale: 'the map is that of the last case without an error',
    gone: 'The program does not answer. Is riffel serve still running?',
    no_pads: 'this track model has no pads', no_turning: 'not used: the wheel turns in a limit',
    from_preset: 'from preset or default', none: '—', sources: 'Sources', measured: 'measured', typical: 'typical', assumed: 'assumed',
    search_key: 'Search a key', no_key_found: 'No key has this name.', own_values: 'Own values', not_given: 'as it was', back_to: 'Back to',
    headline: 'What to expect', show_why: 'Why there', show_helps: 'What helps', why_there: 'Why there', traffic_curve: 'Growth under the traffic', no_cause: 'Under the wheel of the case nothing grows at these speeds.', not_known: 'not known',
    faster_than_known: 'faster than any railway known', order_holds: 'wavelengths and order hold, the rate does not',
    until_doubled: (band) => `the waves will be twice as high${band ? ' (80 % band)' : ''}`, speaks_for: 'For', speaks_against: 'Against', would_settle: 'Would settle it',
    what_helps: 'What helps', each_alone: 'each alone, under the traffic', remedies_come: 'Remedies come here, ranked by what each does to growth under the traffic.', remedy: 'remedy', growth_changes: 'growth', doubles_in: 'doubles in', ground_after: 'ground after', remedy_cost: 'cost', likely_helps: 'helps, by the calibration', likely_best: 'best, by the calibration', months_gained: (p) => `${p.months} months${p.worth ? `, ${p.worth} for 1000` : ''}`, keep_remedy: 'Keep as variant', set_traffic: 'To the traffic…', remedy_kept: (name) => `Kept to compare: ${name}.`,
    keep: 'Keep this variant', drop: 'Remove', now: 'Now', difference: 'Difference', first: 'First map', second: 'Second map',
    nothing_kept: 'Keep a variant, then change the case: maps, their difference, growth curves and a table appear here, of up to six variants.',
    most_kept: (n) => `${n} variants are kept: remove one first.`, name_of_variant: 'Name of the variant', open_variant: 'Open', variant_open: (name) => `${name} is open.`,
    report_variants: 'Report of the variants', report_of_variants: 'Riffel: report of variants', opens_variants: 'This link opens the variants in riffel serve.', maps_of_variants: 'Growth maps and their difference',
    sweep: 'Sweep', sweep_comes: 'Choose one: curves of growth over wavelength come here, with a table of the highest growth of each.', sweep_pads: 'Pad stiffness 50–500 MN/m', sweep_friction: 'Friction 0.1–0.6', sweep_tractive: 'Tractive ratio 0.15–0.9', sweep_speeds: 'Speed', sweep_keep: 'Keep these six as variants',
    sweep_columns: ['highest growth rate per passage', 'wavelength there', 'frequency there', 'to double'], map_widened: (place) => `The map is wider now: what grows fastest lies at ${place}.`, sweep_of_traffic: 'under the traffic, as under Explore', so_many_of: (p) => `${p.done} of ${p.of}`, nothing_grows_here: 'nothing grows', at_edge: 'at the edge of the window', take_figure: 'Save',
    compare_rows: ['grows fastest under the traffic', 'doubles in', 'axle passages to double', 'gross tonnes to double', 'highest growth rate of the map, per passage', 'wavelength there', 'speed there', 'frequency there', 'frequency of the strongest branch', 'creepage', 'contact stiffness'],
    less: 'less growth', more: 'more growth', quoted: (name) => `“${name}”`, untitled: 'case without a title', measured_against: (title) => `Held against the case ${title}.`,
    common_window: (window) => `All maps have the window of the case at hand, and the highest growth of the map is that in it: ${window}.`, other_windows: (names) => `The window of ${names} alone is another, and so may be the maximum there.`,
    start: 'Where do you want to begin?', start_line: 'line', start_vehicle: 'vehicle', start_track: 'rail and what it lies on', start_own: 'wheel of the line', start_go: 'Go on with it',
    start_help: 'The map below is that of your choice; everything can be changed on the left, and undone.', 'line_main-line': 'Main line', line_freight: 'Freight line', line_metro: 'Metro', line_tram: 'Tram',
    tour_sliders: 'Move a slider: the map follows at once. Below are all keys of the case, each with its unit and source.', tour_map: 'A click on the map says why corrugation grows or decays there. The wheel zooms, a drag shows a part, arrow keys move the cursor.',
    tour_measure: 'Here a measured rail is held against limits and against this case: drop a file, or try the sample.', tour_next: 'Next', tour_done: 'Done',
    help: 'Help', help_map: 'On the map: arrow keys, Home for the highest growth, plus and minus zoom, 0 shows the whole.', help_steps: 'Ctrl+Z and Ctrl+Shift+Z go back and forth; the address holds the case.',
    help_numbers: 'Numbers may have a unit of their own: 350 kg, 770 lb, 60 mph.', help_program: 'Nothing leaves this machine. More is in the book, docs/src in the sources, and in riffel --help.', help_start: 'Choose line, vehicle and track…', help_tour: 'Show the three hints',
    all_keys: (n) => `Show ${n} keys that this case does not use`, fold_keys: (n) => `Fold ${n} keys that this case does not use`,
    copy_link: 'Copy link', the_link: 'link to this case', copied: 'copied', link_holds: (holds) => `The link holds: ${holds}.`, link_leaves: (p) => [p.record && `the record ${p.record}`, p.plan && 'the plan of the calibration', p.costs && 'what remedies cost'].filter(Boolean).join(', '), link_without: (left) => `It does not hold ${left}: save the project for that.`,
    save_project: 'Project (.riffel)', project_is: 'case, variants, traffic, measured rail and plan of a calibration in one file',
    project_holds: (p) => [p.title, p.variants && `${p.variants} variant${p.variants > 1 ? 's' : ''}`, p.traffic ? 'the traffic' : 'no traffic of its own', p.costs && 'what remedies cost', p.record && `the record ${p.record}${p.earlier ? ` with ${p.earlier} earlier` : ''}`, p.tables && `the plan of a calibration with ${p.tables} table${p.tables > 1 ? 's' : ''}`].filter(Boolean).join(', '),
    project_saved: (holds) => `The project holds: ${holds}.`, project_opened: (p) => `${p.name} is open: ${p.holds}.`, project_without_record: (names) => `It does not hold ${names}, which neither the page nor the program has any more: choose the file once more.`,
    project_broken: (name) => `${name} is damaged or cut short: what is open stays.`, project_large: (p) => `${p.name} unpacks to more than ${p.most} MiB: what is open stays.`, project_other: (name) => `${name} is no project of Riffel: what is open stays.`, project_later: (p) => `${p.name} is a project of version ${p.version}, but this Riffel reads up to ${p.own}: what is open stays.`, save_toml: 'Case as TOML', save_csv: 'Map as CSV', save_png: 'Map as PNG', save_svg: 'Map as SVG', save_html: 'Map as page (HTML)',
    save_report: 'Report (HTML)', report_of: 'with the measured rail, if there is one', open_toml: 'Open a case or project…', start_over: 'Start over with the nominal case',
    file_fault: (name, line) => (line ? `${name}, line ${line}: ` : `${name}: `), comments_gone: (name) => `${name} is open.`,
    paper_intro: 'Figures 2–8 of Afferrante & Ciavarella (2009), computed now.', contact_model: 'Contact', quasi: 'quasi-static, as printed', dashpot: 'spring and dashpot', non_steady: 'non-steady',
    computing: 'computing…', skip: 'Skip to the map',
    map_label: (p) => `Growth map over wavelength and speed. Cursor at ${p}. Arrow keys move it, Home goes to the highest growth, plus and minus zoom, 0 shows the whole map.`,

    page_reads: 'The page reads a table whose head names position and height with their units: position [m], height [µm].', drop_file: 'Drop a roughness file here, or choose one', choose: 'Choose a file…', uploading: 'sending', cancel: 'Cancel',
    over: 'over', spectrum: 'Roughness spectrum', dominant: 'Dominant wavelengths', forecast: 'Forecast',

    speed_from: 'speeds from', speed_to: 'speeds to', passages_daily: 'axle passages a day', months_ahead: 'forecast, months ahead', in_months: (n) => `in ${n} months`, excess: 'above the trend',
    sample: 'Try a sample', sample_source: 'Sample: 100 m of two rails, not measured but made by Riffel to its built-in recipe (riffel roughness --synthesise): random roughness, corrugation of 40 mm and 15 µm from 30 to 55 m, a spike and a pit.',
    along: 'Along the line', along_hint: 'a click takes what is below to that place; drag to zoom, double click for the whole line', rms_axis: 'highest moving RMS in each block [µm]; shaded: to grind', limit: 'limit', position: 'position', whole_record: 'whole record',
    shown_below: 'Spectrum, cause, forecast and noise below are of:', part_in_view: 'The part in view', line_table: 'Add curves, stations, welds, joints…', line_table_hint: 'a table with the columns position, or from and to, and kind and name', record_shows: 'in the record', 'shows_weld-or-joint': 'weld or joint', shows_squat: 'squat',
    by_section: 'Verdict by section', verdict_columns: ['rail', 'from–to [m]', 'worst level over its limit', 'moving RMS: over on, highest', 'to grind [m]', 'verdict'],
    to_grind: 'To grind', section_columns: ['rail', 'from–to [m]', 'length [m]', 'worst band', 'RMS / limit'], grind_total: (p) => `In all ${p.metres} m of line, ${p.share} % of what was measured.`, nothing_to_grind: 'Nothing is to be ground: the moving RMS is nowhere over its limit.',
    noise: 'Rolling noise', noise_rail: 'rail', noise_sleepers: 'sleepers', noise_wheel: 'wheel', noise_total: 'total', noise_axis: 'level [dB re 20 µPa]', noise_level_axis: 'level [dB(A)]', noise_months: 'time [months]', months_word: 'months',
    noise_level: ({ level, hertz }) => hertz ? `≥ ${level} dB(A) (up to ${hertz} Hz)` : `${level} dB(A)`,
    noise_verdict: (p) => `A coach of ${p.wheelsets} wheelsets, ${p.length} m long, with smooth wheels is heard at ${p.level} over its passage at ${p.speed}, the mean speed of the traffic, ${p.distance} m from the middle of the track and ${p.height} m above the rail.`,
    noise_silent: 'The track of this case has no level: its rail carries vibration on without end, or the model does not say how far. A track of one or two layers, at even or periodic supports, has one.',
    noise_helps: 'What would make it quieter', noise_columns: ['each alone', 'dB(A)', 'saves [dB]'],
    noise_ahead: 'Level in the months ahead', noise_limit: 'highest level allowed', noise_wheel_is: 'wheel:', noise_rigid: 'rigid', noise_straight_web: 'straight web, 920 mm', noise_becomes: (p) => `Under the traffic it becomes ${p.level} in ${p.months} months.`, noise_cut: 'There roughness leaves the linear range.',
    noise_never: (p) => `${p.limit} dB(A) are not reached in this time.`, noise_now: (p) => `${p.limit} dB(A) are reached now.`, noise_then: (p) => `${p.limit} dB(A) are reached in ${p.months} months.`,
    columns: 'Columns of the table', columns_help: 'Of a table of many columns say which is the position and which are heights of a rail.', columns_use: 'Read it so', columns_spacing: 'step between samples', column_n: (n) => `column ${n}`, column_is: 'what it is', column_unit: 'unit',
    column_none: 'left out', column_position: 'position', column_height: 'height of a rail', columns_one_position: 'One column is the position, not several.', columns_no_height: 'At least one column must be the height of a rail.',
    nothing_dominant: 'No wavelength stands out.', all_along: 'all along', level_axis: 'level [dB re 1 µm]',

    two_ways: (text) => `“${text}” can be read two ways. Which is meant?`, read_as: (value) => `= ${value}`, far_off: (p) => `= ${p.now}; before it was ${p.before}. Is that meant?`,
    not_accepted: ({ count, isShown }) => `${count === 1 ? 'One field is' : `${count} fields are`} not accepted; ${isShown ? 'what is shown is the last case without an error' : 'nothing can be shown before'}. Go to:`,
    no_number: (text) => `“${text}” is not a number.`, must_lie: (p) => `${p.label}: ${p.value}, but must be ${p.low} to ${p.high}.`, must_rise: 'The highest speed must not be below the lowest.',
    undo: 'Undo', redo: 'Redo', undo_keys: 'Undo (Ctrl+Z)', redo_keys: 'Redo (Ctrl+Shift+Z)', close: 'Close', again: 'Try again', reload: 'Reload the page',
    stopped: 'Stopped. What is shown belongs to an earlier case.', stopped_once: 'Stopped: nothing was saved.', not_done: (what) => `${what}: not done.`,
    damaged: 'This link is damaged or cut short, and no case can be read from it. What was open is still open: ask for the link again.',
    damaged_first: 'This link is damaged or cut short, and no case can be read from it. Shown is the case that was open here last, or the nominal case: ask for the link again.',
    went_on: 'This is the case that was open here last.', started_over: 'The nominal case is open.', record_taken: (name) => `${name} took the place of the record before.`,
    record_gone: (name) => `${name} is no longer kept by the program: choose it once more.`,
    bogie: 'Curve', wheel_profile: 'wheel', rail_profile: 'rail', curve_radius: 'radius, to the right positive', curve_speed: 'speed', left: 'left', right: 'right',
    bogie_intro: 'Dimensions of a typical metro bogie, not of the wheel of the case: write those of yours. Files: two columns in mm or m, MiniProf, Simpack or Vampire.',
    curve_cant: 'cant', curve_gauge: 'gauge', bogie_wheelbase: 'wheelbase', bogie_axle_load: 'mass per axle', bogie_longitudinal: 'stiffness per axle box, along', bogie_lateral: 'stiffness per axle box, across',
    friction_high: 'friction, high rail', friction_low: 'friction, low rail', bogie_from_above: 'From above, travelling to the right',
    bogie_drawn: (p) => `Shifts, angles and the bow of the curve are drawn ${p.scale} times as large. Arrows: creep force on the rail, the longest ${p.force} kN. Wheels are the darker the more they wear, up to Tγ = ${p.wear} N.`,
    too_narrow: (p) => `${p.label}: no curve is narrower than ${p.narrowest} m.`,
    passage: 'A wheel over the wave, in time', wave_amplitude: 'amplitude of the wave', wave_place: 'place of the wheel [mm]', wave_height: 'profile [µm]', wave_force: 'P [kN]', wave_creepage: 'creepage [%]', wave_dissipation: 'dissipation [J/m]', wave_time: 'in time', wave_linear: 'linear',
    wave_apart: (p) => `The wheel is in the air over ${p.percent} % of the wave (shaded). The linear answer knows nothing of that.`,
    wave_large: (p) => `The wheel stays on the rail, but its normal force falls to ${p.share} P₀: the linear answer is off.`, wave_small: (p) => `The wheel stays on the rail; its normal force falls to ${p.share} P₀ at the least. The linear answer holds.`,
    damage: 'Damage: shakedown and cracks', limit_elastic: 'elastic', limit_line: 'shakedown, line contact', limit_surface: 'shakedown, surface', limit_subsurface: 'shakedown, below the surface', along_wave: 'along the wave', mean_state: 'mean state', crest: 'crest', trough: 'trough', utilised_friction: 'utilised friction |Q|/P', demand: (value) => `demand ${value}`,
    cracks_wavelength_mm: 'wavelength [mm]', cracks_crest: (months) => `crack on the crest ${months} months after grinding [mm]`, cracks_crest_monthly: 'now, mm a month', cracks_trough: (months) => `crack in the trough after ${months} months [mm]`, cracks_trough_monthly: 'now, mm a month',
    field: 'Held against the field', site: 'site', measured_what: 'what', predicted_band: 'predicted: median (80 %)', measured_there: 'measured', inside: 'inside', outside: 'outside', up_to: (value) => `up to ${value}`, from_on: (value) => `from ${value}`,
    stability: 'Oscillation without any profile', friction_axis: 'friction μ; dashed: that of the case',
    wheelset_modes: 'Wheelset in its modes', wheelset_none: 'This case has a lone wheel and no axle. Choose a wheelset on the left, one of its presets for instance.', wheelset_list: 'Natural frequency', wheelset_play: 'Move', wheelset_stop: 'Hold', wheelset_drawn: 'Drawn slower and larger than it is; wheels and discs are rigid, the axle bends, twists and stretches. Lines on the wheels show the twist.',
    growth_of_wheels: 'Growth of the case under each wheel', growth_of_wheels_help: (span) => `The track of the case under the wheels of this bogie, within a tenth of the speed of the curve: growth over ${span} mm, in one scale. Creep laws that end in sliding give way to FASTSIM.`, wheel_of: (p) => `Wheelset ${p.wheelset}, ${p.rail} rail`,
    wheel_grows: (p) => `${p.rate} per passage at ${p.wavelength} mm, ${p.frequency} Hz${p.isEdge ? ', at the edge of the window' : ''}; to double: ${p.doubling}`, use_state: 'Use these creepages in the case', state_used: (name) => `The case has the mean state of: ${name}.`,
    wheel_orientation: 'how the wheel file stands', rail_orientation: 'how the rail file stands', 'stands_found': 'stands as found', 'stands_as-written': 'as written', stands_mirrored: 'mirrored', 'stands_upside-down': 'upside down', stands_turned: 'mirrored and upside down',
    profiles_panel: 'Profiles', curvatures_panel: 'Curvature', wheels_panel: 'The four wheels in the curve', across_profile: 'lateral x, field side positive [mm]', height_profile: 'height [mm]', curvature_profile: 'curvature [1/m]',
    no_equilibrium: 'The bogie does not stand in this curve:', shift_mm: 'shift mm', attack_mrad: 'attack mrad', along_percent: 'creepage along %', across_percent: 'across %', angle_degrees: 'angle °', load_kn: 'P kN', t_gamma: 'Tγ N',
    profile_large: (name) => `${name} is larger than 80 kB: profiles have some thousand points; riffel profile reads larger files.`,
    add_earlier: 'Add an earlier record…', earlier_hint: 'The oldest first, or with the dates of all: then growth is told by the year, and the wear coefficient is fitted to it. Drop a file here, too.', measured_on: 'measured on', earlier_gone: 'Its earlier records went with it.', left_out: 'left out', by_columns: 'It was read by the columns that were chosen for the record.',
    most_earlier: (p) => `${p.name} was not taken: there are ${p.most} earlier records at most. Remove one first.`, no_date: 'This is no whole date from 1900 on.', date_not_before: (date) => `This must be before ${date}, the date of the record above.`, date_twice: (p) => `${p.name} is of ${p.date}, too: each record has a date of its own.`,
    course: (p) => `${p.points}: ${p.change} dB in all, ${p.slope} ± ${p.scatter} dB ${p.isYear ? 'a year' : 'from record to record'}`, fit_between: (n) => `Fitted to what has changed between the last two dated records, over ${n} axle passages:`, use_coefficient: 'Use it in the case', coefficient_used: (value) => `The wear coefficient of the case is now ${value} kg/J.`,
    add_vehicle: 'Add a vehicle', vehicle_n: (n) => `vehicle ${n}`, vehicle_name: 'vehicle', vehicle_share: 'share of axle passages', vehicle_load: 'wheel load P₀', vehicle_traction: 'tractive ratio τ', as_the_case: 'as the case', vehicle_needs_name: 'A vehicle needs a name.', vehicle_twice: (name) => `“${name}” is another vehicle already.`, vehicle_needs: (what) => `A vehicle needs its own: ${what}.`,
    shares_sum: (sum) => `The shares of axle passages sum to ${sum} %, but must sum to 100 %.`, no_unit: (p) => `“${p.text}” has no unit of this field, which are ${p.units}.`,
    all_wheels: 'all wheels of the bogie, each as it stands in the curve', traffic: 'Traffic', traffic_default: (n) => `usual: ${n} axle passages a day`, traffic_given: (n) => `${n} axle passages a day`, traffic_is_default: 'This is the usual traffic of such a line: put in that of yours.',
    calibrate: 'Calibrate', choose_data: 'Choose files…', drop_data: 'Drop measurements here, or choose files', taken_as: (p) => `taken as ${p.kind}, ${p.size}`, 'frequency-response': 'receptance of the rail (hammer)', wear: 'wear of the head', 'decay-rate': 'decay rates', 'dated-levels': 'roughness levels of several dates', 'axle-box': 'run of an axle box',
    most_data: (p) => `${p.name} was not taken: there are ${p.most} files at most. Remove one first.`, calibrate_comes: 'Measurements tell what a case can only assume. Drop tables here: receptances of a hammer, decay rates of the rail, roughness levels of several dates. The columns say what each is. Then comes what you knew before, and what is known after: each value with its interval, and which values the data cannot tell.',
    try_example: 'Try an example', example_source: 'Example: levels of three dates, not measured but made by Riffel with known values. Growth tells the wear coefficient only as a product with friction, traction and the share of driven wheels: these are left out, and the wear coefficient stands for the product.', example_open: 'The case of the example is open, with its traffic.',
    known_before: 'Known before', known_before_help: 'usual priors: put what you know in their place, or leave a value out', uncertain: 'uncertain value', prior: 'prior', told_from: 'data that depend on it', prior_median: 'median', prior_factor: 'factor', prior_mean: 'mean', prior_standard_deviation: '±', prior_min: 'from', prior_max: 'to', value_of_case: 'left out: value of the case',
    calibrate_now: 'Calibrate', draws_word: 'draws', draws_of_chain: 'draws of each chain', draws_done: (p) => `${p.done} of ${p.of} draws`, stopped_drawing: 'Stopped: nothing was concluded.', save_plan: 'Save the plan', take_medians: 'Take the medians into the case', medians_taken: (names) => `medians taken into the case: ${names}`,
    not_taken: (p) => (p.isConclusive ? (p.names ? `Not written back, for these data do not tell them, or only together with another: ${p.names}.` : '') : 'Nothing is written back, for the chains allow no conclusion.'),
    data_tell: 'What the data tell', before_after: 'Before and after', before_after_help: 'Filled: after the data, with the median and 90 %. Pale: before.', predicted: 'Data and model', predicted_help: 'Points: measured. Bands: where 90 % of such data would lie over the calibration, with errors and with what the model misses.',
    drawn: (p) => `${p.chains} chains of ${p.warmup} + ${p.draws} draws, seed ${p.seed}; the program takes 1000 + 1000 if not told otherwise. Largest R̂: ${p.rhat}.`, was_before: (span) => `before: ${span}`, told_share: (p) => `told by data ${p.share} %, R̂ ${p.rhat}, ${p.draws} effective draws`,
    missed_of: (data) => `missed by the model (${data})`, preload_stiffening: 'stiffening of pads under the train', speed_mean: 'mean speed', speed_deviation: 'spread of speeds', traction_share: 'share of driven wheels', vehicle_wheel_mass: 'mass of the wheel (vehicle)',
    receptance_axis: '|H| [nm/N]', phase_axis: 'arg H [°]', decay_axis: 'decay rate [dB/m]', rise_axis: 'rise since the first date [dB]', axle_box_axis: 'axle box, over the first date [dB]', pass_by_axis: 'pass-by, over the first levels [dB(A)]', wave_growth_axis: 'growth of waves [dB]', wave_drift_axis: 'drift of waves [°]', wear_axis: 'wear per 100 MGT [mm]',
    what_to_do: 'What to do', what_to_do_help: 'a remedy takes part once it has a cost; to leave all as it is always does', currency: 'currency', cost_grinding: 'grinding once', cost_possession: 'closing the line for it', cost_over_limit: 'each month over the limit', cost_from_limit: 'grinding leaves, from the limit', cost_discount_rate: 'interest', cost_horizon: 'horizon',
    grind_every: 'also compare grinding every', every_months: (n) => `grinding every ${n} months`, action_investment: 'investment', action_life: 'its life', action_upkeep: 'upkeep a year', measure_once_more: 'measure once more', price: 'price', rank_now: 'Rank',
    ranked: 'Which pays', ranked_help: 'costs of a year: line 90 %, bar half of the draws, mark the mean', as_it_is: 'leave all as it is', ranked_action: 'action', ranked_picture: 'cost a year', ranked_mean: (currency) => `mean [${currency}]`, ranked_band: (currency) => `90 % [${currency}]`, ranked_cheapest: 'is cheapest', ranked_helps: 'grinds less often', save_decision: 'Save the plan with its actions', passages_unit: 'dB per 10⁶ passages',
    worth_measured: (p) => `To measure once more, ${p.name}, is worth ${p.worth} ${p.currency} a year; less its price of ${p.price} ${p.currency}, ${p.net} ${p.currency} over the horizon.`, worth_known: (p) => `To know the value exactly, ${p.name}, would be worth ${p.worth} ${p.currency} a year.`,
    passages_word: 'passages', speed_unit: 'Unit of speeds', whole_map: 'Whole map', band: 'traffic', band_default: 'usual traffic', gross_tonnes: (n) => `${n} MGT`, growth_time: (p) => `${p.time} or ${p.mass}${p.isDefault ? ' with the usual traffic' : ''}`, time_months: (n) => `${n} months`, time_days: (n) => `${n} days`, time_years: (n) => `${n} years`,
  },
  de: {
    explore: 'Erkunden', compare: 'Vergleichen', measure: 'Messen', motion: 'Bewegung', paper: 'Aufsatz', take_away: 'Mitnehmen',
    tagline: 'welche Riffeln wachsen, wie schnell und warum',
    case: 'Fall', handles: 'Regler', theme: 'Hell oder dunkel', language: 'Sprache',
    growth_map: 'Wachstumskarte', wavelength: 'Wellenlänge', speed: 'Geschwindigkeit', frequency: 'Frequenz',
    growth_rate: 'Wachstumsrate je Überrollung', per_passage: 'je Überrollung', rate: 'Rate je Überrollung', nothing_grows: 'in diesem Fenster wächst nichts', no_difference: 'kein Unterschied',
    hold: 'Skala halten', hold_help: 'Die Farbskala behalten, während sich Werte ändern',
    headline_mark: (place) => `am schnellsten im Verkehr: ${place}`, to_highest: 'Stärkstes Wachstum', loop: 'Die Schleife am Zeiger', growth_curve: 'Wachstum über der Wellenlänge',
    rail_name: (name) => RAILS[name] ?? name, rail_named: (name) => (name ? `Schiene ${RAILS[name] ?? name}` : 'Schiene'), receptance: 'Rezeptanz', force: 'Normalkraft P₁/P₀', rail: 'Schiene', wheel: 'Rad', contact: 'Kontakt',
    grows_here: 'wächst', decays_here: 'klingt ab', time: 'Zeitfaktor exp(+iωt), Δ auf der Schiene nach oben; links ist Gegenphase',
    profile: 'Profil Δ', normal: 'Normalkraft P₁', tangential: 'Tangentialkraft Q₁', lateral_force: 'Querkraft Q_y', angular: 'Winkelgeschwindigkeit Ω₁',
    dissipation: 'Dissipation W₁ an der Schiene', amplitude: 'Amplitude', phase: 'Phase', quantity: 'Schwingung',
    direction_only: 'Richtungen sind wahr, Längen nicht; Amplituden in der Tabelle',
    parts: 'Rad und Schiene trennen sich: |P₁| übersteigt P₀ bei dieser Amplitude. Vorzeichen und Raten gelten für kleine Amplituden.',
    sentence: (p) => `${p.lambda} mm bei ${p.speed} sind ${p.hertz} Hz. Die Normalkraft ${p.force}. Die Schiene dissipiert ${p.where}: ${p.verdict}`,
    leads: (d) => `eilt dem Profil um ${d}° vor`, lags: (d) => `eilt dem Profil um ${d}° nach`, inphase: 'ist in Phase mit dem Profil',
    troughs: (d) => `vor allem in den Tälern (${d}° von den Bergen)`, crests: (d) => `vor allem auf den Bergen (${d}° von ihnen)`,
    doubles: (n) => `Die Täler werden tiefer, die Riffel wächst und verdoppelt sich in ${n}.`,
    halves: (n) => `Die Berge verschleißen, die Riffel klingt ab und halbiert sich in ${n}.`,
    stays: 'Die Riffel wächst nicht und klingt nicht ab.',
    notes: 'Hinweise', stale: 'die Karte ist die des letzten Falls ohne Fehler',
    gone: 'Das Programm antwortet nicht. Läuft riffel serve noch?',
    no_pads: 'dieses Gleismodell hat keine Zwischenlagen', no_turning: 'ohne Wirkung: das Rad dreht in einem Grenzfall',
    from_preset: 'aus Vorgabe', none: '—', sources: 'Quellen', measured: 'gemessen', typical: 'typisch', assumed: 'angenommen',
    search_key: 'Wert suchen', no_key_found: 'Kein Wert heißt so.', own_values: 'Eigene Werte', not_given: 'wie zuvor', back_to: 'Zurück zu',
    headline: 'Was zu erwarten ist', show_why: 'Warum dort', show_helps: 'Was hilft', why_there: 'Warum dort', traffic_curve: 'Wachstum im Verkehr', no_cause: 'Unter dem Rad des Falls wächst bei diesen Geschwindigkeiten nichts.', not_known: 'nicht bekannt',
    faster_than_known: 'schneller als jede bekannte Bahn', order_holds: 'Wellenlängen und Reihenfolge gelten, die Rate nicht',
    until_doubled: (band) => `sind die Wellen doppelt so hoch${band ? ' (80-%-Band)' : ''}`, speaks_for: 'Dafür', speaks_against: 'Dagegen', would_settle: 'Das entscheidet',
    what_helps: 'Was hilft', each_alone: 'jedes allein, im Verkehr', remedies_come: 'Hier erscheinen Maßnahmen, geordnet nach ihrer Wirkung auf das Wachstum im Verkehr.', remedy: 'Maßnahme', growth_changes: 'Wachstum', doubles_in: 'verdoppelt sich in', ground_after: 'geschliffen nach', remedy_cost: 'Kosten', likely_helps: 'hilft, laut Kalibrierung', likely_best: 'am besten, laut Kalibrierung', months_gained: (p) => `${p.months} Monate${p.worth ? `, ${p.worth} für 1000` : ''}`, keep_remedy: 'Als Variante merken', set_traffic: 'Zum Verkehr…', remedy_kept: (name) => `Zum Vergleich gemerkt: ${name}.`,
    keep: 'Diese Variante merken', drop: 'Entfernen', now: 'Jetzt', difference: 'Unterschied', first: 'Erste Karte', second: 'Zweite Karte',
    nothing_kept: 'Eine Variante merken und den Fall ändern: hier erscheinen Karten, ihr Unterschied, Wachstumskurven und eine Tabelle von bis zu sechs Varianten.',
    most_kept: (n) => `${n} Varianten sind gemerkt: erst eine entfernen.`, name_of_variant: 'Name der Variante', open_variant: 'Öffnen', variant_open: (name) => `${name} ist geöffnet.`,
    report_variants: 'Bericht der Varianten', report_of_variants: 'Riffel: Bericht von Varianten', opens_variants: 'Dieser Link öffnet die Varianten in riffel serve.', maps_of_variants: 'Wachstumskarten und ihr Unterschied',
    sweep: 'Durchlauf', sweep_comes: 'Eines wählen: Hier erscheinen Wachstumskurven über der Wellenlänge und eine Tabelle des höchsten Wachstums.', sweep_pads: 'Steifigkeit der Zwischenlagen 50–500 MN/m', sweep_friction: 'Reibung 0,1–0,6', sweep_tractive: 'Kraftschlussausnutzung 0,15–0,9', sweep_speeds: 'Geschwindigkeit', sweep_keep: 'Diese sechs als Varianten merken',
    sweep_columns: ['höchste Wachstumsrate je Überrollung', 'Wellenlänge dort', 'Frequenz dort', 'bis zur Verdopplung'], map_widened: (place) => `Die Karte ist jetzt weiter: was am stärksten wächst, liegt bei ${place}.`, sweep_of_traffic: 'unter dem Verkehr, wie unter „Erkunden“', so_many_of: (p) => `${p.done} von ${p.of}`, nothing_grows_here: 'nichts wächst', at_edge: 'am Rand des Fensters', take_figure: 'Sichern',
    compare_rows: ['wächst am schnellsten im Verkehr', 'verdoppelt sich in', 'Überrollungen bis zur Verdopplung', 'Tonnen bis zur Verdopplung', 'höchste Wachstumsrate der Karte, je Überrollung', 'Wellenlänge dort', 'Geschwindigkeit dort', 'Frequenz dort', 'Frequenz des stärksten Astes', 'Schlupf', 'Kontaktsteifigkeit'],
    less: 'weniger Wachstum', more: 'mehr Wachstum', quoted: (name) => `„${name}“`, untitled: 'Fall ohne Titel', measured_against: (title) => `Verglichen mit dem Fall ${title}.`,
    common_window: (window) => `Alle Karten haben das Fenster des jetzigen Falls, und das höchste Wachstum ist das darin: ${window}.`, other_windows: (names) => `Das eigene Fenster von ${names} ist ein anderes, das Maximum dort vielleicht auch.`,
    start: 'Womit möchten Sie beginnen?', start_line: 'Strecke', start_vehicle: 'Fahrzeug', start_track: 'Schiene und worauf sie liegt', start_own: 'Rad der Strecke', start_go: 'Damit weiter',
    start_help: 'Die Karte unten ist die Ihrer Wahl; alles lässt sich links ändern und rückgängig machen.', 'line_main-line': 'Hauptstrecke', line_freight: 'Güterstrecke', line_metro: 'U-Bahn', line_tram: 'Straßenbahn',
    tour_sliders: 'Einen Regler bewegen: Die Karte folgt sofort. Darunter stehen alle Werte des Falls, jeder mit Einheit und Quelle.', tour_map: 'Ein Klick auf die Karte sagt, warum Riffeln dort wachsen oder abklingen. Das Mausrad zoomt, Ziehen zeigt einen Teil, Pfeiltasten bewegen den Zeiger.',
    tour_measure: 'Hier wird eine gemessene Schiene mit Grenzen und mit diesem Fall verglichen: eine Datei ablegen oder das Beispiel nehmen.', tour_next: 'Weiter', tour_done: 'Fertig',
    help: 'Hilfe', help_map: 'Auf der Karte: Pfeiltasten, Pos1 für das höchste Wachstum, Plus und Minus zoomen, 0 zeigt alles.', help_steps: 'Strg+Z und Strg+Umschalt+Z gehen zurück und vor; die Adresse enthält den Fall.',
    help_numbers: 'Zahlen dürfen eine eigene Einheit haben: 350 kg, 770 lb, 60 mph.', help_program: 'Nichts verlässt diesen Rechner. Mehr steht im Buch, docs/src in den Quellen, und in riffel --help.', help_start: 'Strecke, Fahrzeug und Gleis wählen…', help_tour: 'Die drei Hinweise zeigen',
    all_keys: (n) => `${n} Werte zeigen, die dieser Fall nicht nutzt`, fold_keys: (n) => `${n} Werte einklappen, die dieser Fall nicht nutzt`,
    copy_link: 'Link kopieren', the_link: 'Link zu diesem Fall', copied: 'kopiert', link_holds: (holds) => `Der Link enthält: ${holds}.`, link_leaves: (p) => [p.record && `die Messung ${p.record}`, p.plan && 'den Plan der Kalibrierung', p.costs && 'die Kosten der Maßnahmen'].filter(Boolean).join(', '), link_without: (left) => `${left[0].toUpperCase()}${left.slice(1)} enthält er nicht: dafür das Projekt sichern.`,
    save_project: 'Projekt (.riffel)', project_is: 'Fall, Varianten, Verkehr, gemessene Schiene und Plan einer Kalibrierung in einer Datei',
    project_holds: (p) => [p.title, p.variants && `${p.variants} Variante${p.variants > 1 ? 'n' : ''}`, p.traffic ? 'den Verkehr' : 'keinen eigenen Verkehr', p.costs && 'die Kosten der Maßnahmen', p.record && `die Messung ${p.record}${p.earlier ? ` mit ${p.earlier} früheren` : ''}`, p.tables && `den Plan einer Kalibrierung mit ${p.tables} Tabelle${p.tables > 1 ? 'n' : ''}`].filter(Boolean).join(', '),
    project_saved: (holds) => `Das Projekt enthält: ${holds}.`, project_opened: (p) => `${p.name} ist geöffnet: ${p.holds}.`, project_without_record: (names) => `Es enthält ${names} nicht, denn weder die Seite noch das Programm hat die Datei noch: die Datei noch einmal wählen.`,
    project_broken: (name) => `${name} ist beschädigt oder abgeschnitten: was offen ist, bleibt.`, project_large: (p) => `${p.name} ergibt ausgepackt mehr als ${p.most} MiB: was offen ist, bleibt.`, project_other: (name) => `${name} ist kein Projekt von Riffel: was offen ist, bleibt.`, project_later: (p) => `${p.name} ist ein Projekt der Version ${p.version}, dieses Riffel liest aber bis ${p.own}: was offen ist, bleibt.`, save_toml: 'Fall als TOML', save_csv: 'Karte als CSV', save_png: 'Karte als PNG', save_svg: 'Karte als SVG', save_html: 'Karte als Seite (HTML)',
    save_report: 'Bericht (HTML)', report_of: 'mit der gemessenen Schiene, wenn es eine gibt', open_toml: 'Fall oder Projekt öffnen…', start_over: 'Neu beginnen mit dem Nennfall',
    file_fault: (name, line) => (line ? `${name}, Zeile ${line}: ` : `${name}: `), comments_gone: (name) => `${name} ist geöffnet.`,
    paper_intro: 'Bilder 2–8 aus Afferrante & Ciavarella (2009), jetzt berechnet.', contact_model: 'Kontakt', quasi: 'quasistatisch, wie gedruckt', dashpot: 'Feder und Dämpfer', non_steady: 'instationär',
    computing: 'rechnet…', skip: 'Zur Karte springen',
    map_label: (p) => `Wachstumskarte über Wellenlänge und Geschwindigkeit. Zeiger bei ${p}. Pfeiltasten bewegen ihn, Pos1 geht zum stärksten Wachstum, Plus und Minus vergrößern und verkleinern, 0 zeigt die ganze Karte.`,

    page_reads: 'Die Seite liest eine Tabelle, deren Kopf Ort und Höhe mit ihren Einheiten nennt: Ort [m], Höhe [µm].', drop_file: 'Eine Rauheitsdatei hier ablegen oder wählen', choose: 'Datei wählen…', uploading: 'sende', cancel: 'Abbrechen',
    over: 'darüber', spectrum: 'Rauheitsspektrum', dominant: 'Vorherrschende Wellenlängen', forecast: 'Prognose',

    speed_from: 'Geschwindigkeiten von', speed_to: 'Geschwindigkeiten bis', passages_daily: 'Achsüberrollungen am Tag', months_ahead: 'Prognose, Monate voraus', in_months: (n) => `in ${n} Monaten`, excess: 'über dem Trend',
    sample: 'Beispiel ansehen', sample_source: 'Beispiel: 100 m von zwei Schienen, nicht gemessen, sondern von Riffel nach eingebautem Rezept gemacht (riffel roughness --synthesise): zufällige Rauheit, Riffeln von 40 mm und 15 µm zwischen 30 und 55 m, eine Spitze und eine Grube.',
    along: 'Entlang der Strecke', along_hint: 'ein Klick führt alles darunter an diesen Ort; Ziehen vergrößert, Doppelklick zeigt die ganze Strecke', rms_axis: 'höchster gleitender Effektivwert je Abschnitt [µm]; getönt: zu schleifen', limit: 'Grenze', position: 'Ort', whole_record: 'ganze Messung',
    shown_below: 'Spektrum, Ursache, Prognose und Geräusch darunter gelten für:', part_in_view: 'Der gezeigte Teil', line_table: 'Bögen, Bahnhöfe, Schweißungen, Stöße hinzufügen…', line_table_hint: 'eine Tabelle mit den Spalten Ort, oder von und bis, und Art und Name', record_shows: 'in der Messung', 'shows_weld-or-joint': 'Schweißung oder Stoß', shows_squat: 'Squat',
    by_section: 'Urteil je Abschnitt', verdict_columns: ['Schiene', 'von–bis [m]', 'schlimmster Pegel über der Grenze', 'gleitender Effektivwert: darüber auf, höchstens', 'zu schleifen [m]', 'Urteil'],
    to_grind: 'Zu schleifen', section_columns: ['Schiene', 'von–bis [m]', 'Länge [m]', 'schlimmstes Band', 'Effektivwert / Grenze'], grind_total: (p) => `Zusammen ${p.metres} m Strecke, ${p.share} % des Gemessenen.`, nothing_to_grind: 'Nichts ist zu schleifen: der gleitende Effektivwert liegt nirgends über seiner Grenze.',
    noise: 'Rollgeräusch', noise_rail: 'Schiene', noise_sleepers: 'Schwellen', noise_wheel: 'Rad', noise_total: 'Summe', noise_axis: 'Pegel [dB re 20 µPa]', noise_level_axis: 'Pegel [dB(A)]', noise_months: 'Zeit [Monate]', months_word: 'Monate',
    noise_level: ({ level, hertz }) => hertz ? `≥ ${level} dB(A) (bis ${hertz} Hz)` : `${level} dB(A)`,
    noise_verdict: (p) => `Ein Wagen mit ${p.wheelsets} Radsätzen, ${p.length} m lang und mit glatten Rädern, ist während der Vorbeifahrt bei ${p.speed}, der mittleren Geschwindigkeit des Verkehrs, mit ${p.level} zu hören, ${p.distance} m von der Gleismitte und ${p.height} m über der Schiene.`,
    noise_silent: 'Das Gleis dieses Falls hat keinen Pegel: Seine Schiene trägt Schwingungen ohne Ende weiter, oder das Modell sagt nicht, wie weit. Ein Gleis aus einer oder zwei Schichten, auf verteilten oder periodischen Stützpunkten, hat einen.',
    noise_helps: 'Was es leiser machte', noise_columns: ['jedes allein', 'dB(A)', 'spart [dB]'],
    noise_ahead: 'Pegel in den kommenden Monaten', noise_limit: 'höchster erlaubter Pegel', noise_wheel_is: 'Rad:', noise_rigid: 'starr', noise_straight_web: 'gerader Steg, 920 mm', noise_becomes: (p) => `Unter dem Verkehr werden es ${p.level} in ${p.months} Monaten.`, noise_cut: 'Dort verlässt die Rauheit den linearen Bereich.',
    noise_never: (p) => `${p.limit} dB(A) werden in dieser Zeit nicht erreicht.`, noise_now: (p) => `${p.limit} dB(A) sind jetzt erreicht.`, noise_then: (p) => `${p.limit} dB(A) sind in ${p.months} Monaten erreicht.`,
    columns: 'Spalten der Tabelle', columns_help: 'Bei einer Tabelle mit vielen Spalten: welche ist der Ort, welche sind Höhen einer Schiene?', columns_use: 'So lesen', columns_spacing: 'Schritt der Messpunkte', column_n: (n) => `Spalte ${n}`, column_is: 'was sie ist', column_unit: 'Einheit',
    column_none: 'ausgelassen', column_position: 'Ort', column_height: 'Höhe einer Schiene', columns_one_position: 'Der Ort steht in einer Spalte, nicht in mehreren.', columns_no_height: 'Mindestens eine Spalte muss die Höhe einer Schiene sein.',
    nothing_dominant: 'Keine Wellenlänge ragt heraus.', all_along: 'durchgehend', level_axis: 'Pegel [dB re 1 µm]',

    two_ways: (text) => `„${text}“ lässt sich auf zwei Arten lesen. Was ist gemeint?`, read_as: (value) => `= ${value}`, far_off: (p) => `= ${p.now}; vorher waren es ${p.before}. Ist das gemeint?`,
    not_accepted: ({ count, isShown }) => `${count === 1 ? 'Ein Feld gilt' : `${count} Felder gelten`} nicht; ${isShown ? 'gezeigt ist der letzte Fall ohne Fehler' : 'vorher lässt sich nichts zeigen'}. Hin zu:`,
    no_number: (text) => `„${text}“ ist keine Zahl.`, must_lie: (p) => `${p.label}: ${p.value}, aber erlaubt ist ${p.low} bis ${p.high}.`, must_rise: 'Die höchste Geschwindigkeit darf nicht unter der niedrigsten liegen.',
    undo: 'Rückgängig', redo: 'Wiederholen', undo_keys: 'Rückgängig (Strg+Z)', redo_keys: 'Wiederholen (Strg+Umschalt+Z)', close: 'Schließen', again: 'Noch einmal', reload: 'Seite neu laden',
    stopped: 'Abgebrochen. Was zu sehen ist, gehört zu einem früheren Fall.', stopped_once: 'Abgebrochen: nichts wurde gesichert.', not_done: (what) => `${what}: nicht geschehen.`,
    damaged: 'Dieser Link ist beschädigt oder abgeschnitten, und kein Fall lässt sich daraus lesen. Was offen war, ist noch offen: den Link noch einmal anfordern.',
    damaged_first: 'Dieser Link ist beschädigt oder abgeschnitten, und kein Fall lässt sich daraus lesen. Gezeigt ist der Fall, der hier zuletzt offen war, oder der Nennfall: den Link noch einmal anfordern.',
    went_on: 'Dies ist der Fall, der hier zuletzt offen war.', started_over: 'Der Nennfall ist geöffnet.', record_taken: (name) => `${name} steht an der Stelle der früheren Messung.`,
    record_gone: (name) => `${name} ist dem Programm nicht mehr bekannt: noch einmal wählen.`,
    bogie: 'Bogen', wheel_profile: 'Rad', rail_profile: 'Schiene', curve_radius: 'Radius, nach rechts positiv', curve_speed: 'Geschwindigkeit', left: 'links', right: 'rechts',
    bogie_intro: 'Maße eines typischen U-Bahn-Drehgestells, nicht des Rads im Fall: Tragen Sie Ihre ein. Dateien: zwei Spalten in mm oder m, MiniProf, Simpack oder Vampire.',
    curve_cant: 'Überhöhung', curve_gauge: 'Spurweite', bogie_wheelbase: 'Achsabstand', bogie_axle_load: 'Masse je Achse', bogie_longitudinal: 'Steifigkeit je Achslager, längs', bogie_lateral: 'Steifigkeit je Achslager, quer',
    friction_high: 'Reibung, bogenäußere Schiene', friction_low: 'Reibung, bogeninnere Schiene', bogie_from_above: 'Von oben, Fahrt nach rechts',
    bogie_drawn: (p) => `Verschiebungen, Winkel und die Krümmung des Gleises sind ${p.scale}-fach vergrößert. Pfeile: Schlupfkraft auf die Schiene, der längste ${p.force} kN. Räder sind umso dunkler, je mehr sie verschleißen, bis Tγ = ${p.wear} N.`,
    too_narrow: (p) => `${p.label}: Kein Bogen ist enger als ${p.narrowest} m.`,
    passage: 'Ein Rad über der Welle, in der Zeit', wave_amplitude: 'Amplitude der Welle', wave_place: 'Ort des Rades [mm]', wave_height: 'Profil [µm]', wave_force: 'P [kN]', wave_creepage: 'Schlupf [%]', wave_dissipation: 'Dissipation [J/m]', wave_time: 'in der Zeit', wave_linear: 'linear',
    wave_apart: (p) => `Das Rad ist auf ${p.percent} % der Welle in der Luft (getönt). Davon weiß die lineare Antwort nichts.`,
    wave_large: (p) => `Das Rad bleibt auf der Schiene, aber seine Normalkraft fällt auf ${p.share} P₀: die lineare Antwort weicht ab.`, wave_small: (p) => `Das Rad bleibt auf der Schiene; seine Normalkraft fällt höchstens auf ${p.share} P₀. Die lineare Antwort gilt.`,
    damage: 'Schäden: Shakedown und Risse', limit_elastic: 'elastisch', limit_line: 'Shakedown, Linienkontakt', limit_surface: 'Shakedown, Oberfläche', limit_subsurface: 'Shakedown, unter der Oberfläche', along_wave: 'entlang der Welle', mean_state: 'mittlerer Zustand', crest: 'Berg', trough: 'Tal', utilised_friction: 'ausgenutzter Kraftschluss |Q|/P', demand: (value) => `Beanspruchung ${value}`,
    cracks_wavelength_mm: 'Wellenlänge [mm]', cracks_crest: (months) => `Riss auf dem Berg ${months} Monate nach dem Schleifen [mm]`, cracks_crest_monthly: 'jetzt, mm im Monat', cracks_trough: (months) => `Riss im Tal nach ${months} Monaten [mm]`, cracks_trough_monthly: 'jetzt, mm im Monat',
    field: 'Am Feld gemessen', site: 'Ort', measured_what: 'was', predicted_band: 'vorhergesagt: Median (80 %)', measured_there: 'gemessen', inside: 'innerhalb', outside: 'außerhalb', up_to: (value) => `bis ${value}`, from_on: (value) => `ab ${value}`,
    stability: 'Schwingung ohne jedes Profil', friction_axis: 'Reibung μ; gestrichelt: die des Falls',
    wheelset_modes: 'Radsatz in seinen Eigenformen', wheelset_none: 'Dieser Fall hat ein einzelnes Rad und keine Welle. Links einen Radsatz wählen, zum Beispiel eine seiner Vorgaben.', wheelset_list: 'Eigenfrequenz', wheelset_play: 'Bewegen', wheelset_stop: 'Anhalten', wheelset_drawn: 'Langsamer und größer gezeichnet, als es ist; Räder und Scheiben sind starr, die Welle biegt, verdreht und dehnt sich. Striche auf den Rädern zeigen die Verdrehung.',
    growth_of_wheels: 'Wachstum im Fall unter jedem Rad', growth_of_wheels_help: (span) => `Das Gleis des Falls unter den Rädern dieses Drehgestells, bis ein Zehntel um die Geschwindigkeit im Bogen: Wachstum über ${span} mm, in einem Maßstab. Kraftschlussgesetze, die im Gleiten enden, weichen FASTSIM.`, wheel_of: (p) => `Radsatz ${p.wheelset}, Schiene ${RAILS[p.rail]}`,
    wheel_grows: (p) => `${p.rate} je Überrollung bei ${p.wavelength} mm, ${p.frequency} Hz${p.isEdge ? ', am Rand des Fensters' : ''}; bis zur Verdopplung: ${p.doubling}`, use_state: 'Diese Schlüpfe im Fall verwenden', state_used: (name) => `Der Fall hat jetzt den mittleren Zustand von: ${name}.`,
    wheel_orientation: 'wie die Datei des Rads liegt', rail_orientation: 'wie die Datei der Schiene liegt', 'stands_found': 'liegt wie erkannt', 'stands_as-written': 'wie geschrieben', stands_mirrored: 'gespiegelt', 'stands_upside-down': 'auf dem Kopf', stands_turned: 'gespiegelt und auf dem Kopf',
    profiles_panel: 'Profile', curvatures_panel: 'Krümmung', wheels_panel: 'Die vier Räder im Bogen', across_profile: 'quer x, Außenseite positiv [mm]', height_profile: 'Höhe [mm]', curvature_profile: 'Krümmung [1/m]',
    no_equilibrium: 'Das Drehgestell steht nicht in diesem Bogen:', shift_mm: 'Versatz mm', attack_mrad: 'Anlauf mrad', along_percent: 'Schlupf längs %', across_percent: 'quer %', angle_degrees: 'Winkel °', load_kn: 'P kN', t_gamma: 'Tγ N',
    profile_large: (name) => `${name} ist größer als 80 kB: Profile haben einige tausend Punkte; riffel profile liest größere Dateien.`,
    add_earlier: 'Frühere Messung hinzufügen…', earlier_hint: 'Die älteste zuerst, oder mit dem Datum jeder Messung: dann steht das Wachstum je Jahr da, und der Verschleißbeiwert wird daran angepasst. Dateien lassen sich auch hier ablegen.', measured_on: 'gemessen am', earlier_gone: 'Ihre früheren Messungen sind mit ihr gegangen.', left_out: 'ausgelassen', by_columns: 'Sie wurde nach den Spalten gelesen, die für die Messung gewählt sind.',
    most_earlier: (p) => `${p.name} wurde nicht genommen: Es gibt höchstens ${p.most} frühere Messungen. Erst eine entfernen.`, no_date: 'Das ist kein ganzes Datum ab 1900.', date_not_before: (date) => `Das muss vor dem ${date} liegen, dem Datum der Messung darüber.`, date_twice: (p) => `Auch ${p.name} ist vom ${p.date}: Jede Messung hat ihr eigenes Datum.`,
    course: (p) => `${p.points}: zusammen ${p.change} dB, ${p.slope} ± ${p.scatter} dB ${p.isYear ? 'im Jahr' : 'von Messung zu Messung'}`, fit_between: (n) => `Angepasst an das, was sich zwischen den letzten beiden datierten Messungen über ${n} Achsüberrollungen geändert hat:`, use_coefficient: 'Im Fall verwenden', coefficient_used: (value) => `Der Verschleißbeiwert des Falls ist jetzt ${value} kg/J.`,
    add_vehicle: 'Fahrzeug hinzufügen', vehicle_n: (n) => `Fahrzeug ${n}`, vehicle_name: 'Fahrzeug', vehicle_share: 'Anteil der Achsüberrollungen', vehicle_load: 'Radlast P₀', vehicle_traction: 'Kraftschluss\u00adausnutzung τ', as_the_case: 'wie im Fall', vehicle_needs_name: 'Ein Fahrzeug braucht einen Namen.', vehicle_twice: (name) => `„${name}“ ist schon ein anderes Fahrzeug.`, vehicle_needs: (what) => `Ein Fahrzeug braucht eigene Werte: ${what}.`,
    shares_sum: (sum) => `Die Anteile der Achsüberrollungen ergeben ${sum} %, müssen aber 100 % ergeben.`, no_unit: (p) => `„${p.text}“ hat keine Einheit dieses Feldes; diese sind ${p.units}.`,
    all_wheels: 'alle Räder des Drehgestells, jedes wie es im Bogen steht', traffic: 'Verkehr', traffic_default: (n) => `üblich: ${n} Achsüberrollungen am Tag`, traffic_given: (n) => `${n} Achsüberrollungen am Tag`, traffic_is_default: 'Dies ist der übliche Verkehr einer solchen Strecke: hier steht besser der eigene.',
    calibrate: 'Kalibrieren', choose_data: 'Dateien wählen…', drop_data: 'Messungen hier ablegen oder Dateien wählen', taken_as: (p) => `gelesen als ${p.kind}, ${p.size}`, 'frequency-response': 'Rezeptanz der Schiene (Hammer)', wear: 'Verschleiß des Kopfes', 'decay-rate': 'Abklingraten', 'dated-levels': 'Rauheitspegel von mehreren Tagen', 'axle-box': 'Fahrt mit Achslager',
    most_data: (p) => `${p.name} wurde nicht genommen: Es sind höchstens ${p.most} Dateien. Erst eine entfernen.`, calibrate_comes: 'Messungen sagen, was ein Fall nur annehmen kann. Hier Tabellen ablegen: Rezeptanzen vom Hammer, Abklingraten der Schiene, Rauheitspegel von mehreren Tagen. Die Spalten sagen, was jede ist. Dann erscheint, was zuvor bekannt war, und was danach bekannt ist: jeder Wert mit seinem Intervall, und welche Werte aus den Daten nicht hervorgehen.',
    try_example: 'Beispiel nehmen', example_source: 'Beispiel: Pegel von drei Tagen, nicht gemessen, sondern von Riffel mit bekannten Werten gemacht. Das Wachstum verrät den Verschleißbeiwert nur als Produkt mit Reibung, Kraftschluss und dem Anteil angetriebener Räder: Diese sind weggelassen, und der Verschleißbeiwert steht für das Produkt.', example_open: 'Der Fall des Beispiels ist geöffnet, mit seinem Verkehr.',
    known_before: 'Zuvor bekannt', known_before_help: 'übliche Vorverteilungen: eigenes Wissen an ihre Stelle setzen oder einen Wert weglassen', uncertain: 'unsicherer Wert', prior: 'Vorverteilung', told_from: 'Daten, die davon abhängen', prior_median: 'Median', prior_factor: 'Faktor', prior_mean: 'Mittel', prior_standard_deviation: '±', prior_min: 'von', prior_max: 'bis', value_of_case: 'weggelassen: Wert des Falls',
    calibrate_now: 'Kalibrieren', draws_word: 'Ziehungen', draws_of_chain: 'Ziehungen je Kette', draws_done: (p) => `${p.done} von ${p.of} Ziehungen`, stopped_drawing: 'Angehalten: Es wurde nichts geschlossen.', save_plan: 'Plan speichern', take_medians: 'Mediane in den Fall übernehmen', medians_taken: (names) => `Mediane in den Fall übernommen: ${names}`,
    not_taken: (p) => (p.isConclusive ? (p.names ? `Nicht zurückgeschrieben, denn sie gehen aus diesen Daten nicht oder nur zusammen mit einem anderen hervor: ${p.names}.` : '') : 'Nichts wird zurückgeschrieben, denn die Ketten erlauben keinen Schluss.'),
    data_tell: 'Was die Daten sagen', before_after: 'Vorher und nachher', before_after_help: 'Gefüllt: nach den Daten, mit Median und 90 %. Blass: zuvor.', predicted: 'Daten und Modell', predicted_help: 'Punkte: gemessen. Bänder: worin über die Kalibrierung 90 % solcher Daten lägen, mit Messfehlern und mit dem, was dem Modell fehlt.',
    drawn: (p) => `${p.chains} Ketten mit ${p.warmup} + ${p.draws} Ziehungen, Startzahl ${p.seed}; das Programm nimmt ohne Angabe 1000 + 1000. Größtes R̂: ${p.rhat}.`, was_before: (span) => `zuvor: ${span}`, told_share: (p) => `aus Daten ${p.share} %, R̂ ${p.rhat}, ${p.draws} wirksame Ziehungen`,
    missed_of: (data) => `was dem Modell fehlt (${data})`, preload_stiffening: 'Versteifung der Zwischenlagen unter dem Zug', speed_mean: 'mittlere Geschwindigkeit', speed_deviation: 'Streuung der Geschwindigkeiten', traction_share: 'Anteil angetriebener Räder', vehicle_wheel_mass: 'Masse des Rades (Fahrzeug)',
    receptance_axis: '|H| [nm/N]', phase_axis: 'arg H [°]', decay_axis: 'Abklingrate [dB/m]', rise_axis: 'Anstieg seit dem ersten Tag [dB]', axle_box_axis: 'Achslager, über dem ersten Tag [dB]', pass_by_axis: 'Vorbeifahrt, über den ersten Pegeln [dB(A)]', wave_growth_axis: 'Wachstum der Wellen [dB]', wave_drift_axis: 'Wandern der Wellen [°]', wear_axis: 'Verschleiß je 100 MGT [mm]',
    what_to_do: 'Was tun', what_to_do_help: 'eine Maßnahme nimmt teil, sobald sie etwas kostet; alles zu lassen nimmt immer teil', currency: 'Währung', cost_grinding: 'einmal schleifen', cost_possession: 'Sperrung dafür', cost_over_limit: 'je Monat über der Grenze', cost_from_limit: 'Schleifen lässt, von der Grenze', cost_discount_rate: 'Zins', cost_horizon: 'Horizont',
    grind_every: 'auch vergleichen: schleifen alle', every_months: (n) => `Schleifen alle ${n} Monate`, action_investment: 'Anschaffung', action_life: 'ihre Dauer', action_upkeep: 'Unterhalt im Jahr', measure_once_more: 'noch einmal messen', price: 'Preis', rank_now: 'Ordnen',
    ranked: 'Was sich lohnt', ranked_help: 'Kosten im Jahr: Linie 90 %, Balken die Hälfte der Ziehungen, Marke das Mittel', as_it_is: 'alles lassen, wie es ist', ranked_action: 'Maßnahme', ranked_picture: 'Kosten im Jahr', ranked_mean: (currency) => `Mittel [${currency}]`, ranked_band: (currency) => `90 % [${currency}]`, ranked_cheapest: 'ist am billigsten', ranked_helps: 'schleift seltener', save_decision: 'Plan mit den Maßnahmen speichern', passages_unit: 'dB je 10⁶ Überrollungen',
    worth_measured: (p) => `Noch einmal zu messen, ${p.name}, ist ${p.worth} ${p.currency} im Jahr wert; abzüglich des Preises von ${p.price} ${p.currency} sind es ${p.net} ${p.currency} über den Horizont.`, worth_known: (p) => `Den Wert genau zu kennen, ${p.name}, wäre ${p.worth} ${p.currency} im Jahr wert.`,
    passages_word: 'Überrollungen', speed_unit: 'Einheit der Geschwindigkeiten', whole_map: 'Ganze Karte', band: 'Verkehr', band_default: 'üblicher Verkehr', gross_tonnes: (n) => `${n} Mio. t`, growth_time: (p) => `${p.time} oder ${p.mass}${p.isDefault ? ' beim üblichen Verkehr' : ''}`, time_months: (n) => `${n} Monate`, time_days: (n) => `${n} Tage`, time_years: (n) => `${n} Jahre`,
  },
};

/** Names of tables and keys; what is not here is named by its key. German in the second place. */
const NAMES = {
  title: ['title', 'Titel'], vehicle: ['vehicle preset', 'Fahrzeug'], steel: ['Steel', 'Stahl'], wheel: ['Wheel', 'Rad'],
  rail: ['Rail', 'Schiene'], track: ['Track', 'Gleis'], contact: ['Contact', 'Kontakt'], corrugation: ['Corrugation', 'Riffel'],
  wear: ['Wear', 'Verschleiß'], map: ['Window of the map', 'Fenster der Karte'], general: ['General', 'Allgemein'],
  'steel.youngs_modulus': ["Young's modulus E", 'Elastizitätsmodul E'], 'steel.poisson_ratio': ["Poisson's ratio ν", 'Querkontraktion ν'],
  'wheel.rolling_radius': ['rolling radius R', 'Laufkreisradius R'], 'wheel.mass': ['unsprung mass m_w', 'unabgefederte Masse m_w'],
  'wheel.inertia': ['wheel inertia I_w', 'Trägheit des Rades I_w'], 'wheel.rotation': ['rotation', 'Drehung'], 'wheel.normal_direction': ['direction of the normal force', 'Richtung der Normalkraft'],
  'rail.section': ['section', 'Profil'], 'rail.mass_per_length': ['mass per length m', 'Masse je Länge m'],
  'rail.second_moment': ['second moment I', 'Flächenmoment I'], 'rail.lateral_second_moment': ['lateral second moment', 'Flächenmoment quer'],
  'rail.beam': ['beam', 'Balken'], 'rail.area': ['area A', 'Fläche A'], 'rail.shear_coefficient': ['shear coefficient κ', 'Schubbeiwert κ'],
  'rail.lateral_shear_coefficient': ['lateral shear coefficient', 'Schubbeiwert quer'], 'rail.shear_modulus': ['shear modulus G', 'Schubmodul G'],
  'rail.density': ['density ρ', 'Dichte ρ'], 'rail.loss_factor': ['loss factor η', 'Verlustfaktor η'],
  'track.model': ['model', 'Modell'], 'track.preset': ['preset', 'Vorgabe'], 'track.support_spacing': ['support spacing', 'Stützpunktabstand'],
  'track.pad': ['Rail pad', 'Zwischenlage'], 'track.sleeper': ['Sleeper', 'Schwelle'], 'track.ballast': ['Ballast', 'Schotter'],
  'track.rail_damping': ['rail damping', 'Dämpfung der Schiene'], 'track.position': ['position of the wheel', 'Ort des Rades'],
  'contact.transverse_radius': ['transverse radius R_r', 'Querradius R_r'], 'contact.normal_load': ['normal load P₀', 'Radlast P₀'],
  'contact.friction': ['friction μ', 'Reibung μ'], 'contact.tractive_ratio': ['tractive ratio τ', 'Kraftschluss\u00adausnutzung τ'],
  'contact.creepage': ['creepage ξ₀', 'Schlupf ξ₀'], 'contact.dissipation_phase': ['dissipation phase', 'Phase der Dissipation'], 'contact.wave_geometry': ["the wave's own geometry", 'Geometrie der Welle selbst'], 'contact.wave_patch': ['curvature of waves', 'Krümmung von Wellen'],
  'contact.creep_law': ['creep law', 'Kraftschluss\u00adgesetz'], 'contact.response': ['response', 'Antwort'], 'contact.hertz': ['ellipse', 'Ellipse'],
  'contact.grid': ['grid', 'Gitter'], 'contact.polach': ["Polach's law", 'Gesetz von Polach'],
  'contact.polach.limit_friction_ratio': ['limit friction ratio A', 'Reibungsverhältnis A'], 'contact.polach.friction_decay': ['friction decay B', 'Reibungsabfall B'],
  'contact.polach.speed': ['speed V', 'Geschwindigkeit V'], 'contact.polach.adhesion_reduction': ['adhesion reduction k_A', 'Minderung Haften k_A'], 'contact.polach.slip_reduction': ['slip reduction k_S', 'Minderung Gleiten k_S'],
  'corrugation.amplitude': ['amplitude Δ', 'Amplitude Δ'], 'wear.coefficient': ['wear coefficient k_w', 'Verschleißbeiwert k_w'], 'wear.measured': ['Measured wear', 'Gemessener Verschleiß'], 'wear.measured.depth': ['depth worn off', 'abgetragene Tiefe'], 'wear.measured.per': ['under trains of', 'unter Zügen von'], 'wear.measured.factor': ['known within a factor', 'bekannt auf einen Faktor'], 'wear.density': ['density ρ', 'Dichte ρ'], 'wear.band_width': ['band width w', 'Bandbreite w'], 'wear.law': ['law', 'Gesetz'], 'wear.spread': ['spread σ', 'Streuung σ'], 'wear.speed': ['speed V', 'Geschwindigkeit V'], 'wear.natural_lubrication': ['natural lubrication', 'natürliche Schmierung'],
  damage: ['Damage beside wear', 'Schäden neben dem Verschleiß'], 'damage.laws': ['laws', 'Gesetze'], 'damage.grade': ['rail grade', 'Schienengüte'], 'damage.shear_yield': ['shear yield k', 'Schubfließgrenze k'], 'damage.limit': ['limit', 'Grenze'], 'damage.spread': ['spread of the demand σ', 'Streuung der Beanspruchung σ'],
  'damage.flow': ['Flow', 'Fließen'], 'damage.flow.depth': ['depth H', 'Tiefe H'], 'damage.flow.exponent': ['exponent m', 'Exponent m'], 'damage.flow.hardening_depth': ['hardening depth D_h', 'Verfestigungstiefe D_h'],
  'damage.flow_along': ['Flow along the rail', 'Fließen längs'], 'damage.flow_along.area': ['area J_r', 'Fläche J_r'], 'damage.flow_along.exponent': ['exponent m', 'Exponent m'],
  'damage.load': ['Load', 'Last'], 'damage.load.depth_per_force': ['depth per force β', 'Tiefe je Kraft β'],
  'damage.bending': ['Bending', 'Biegung'], 'damage.bending.limit': ['limit M_lim', 'Grenze M_lim'], 'damage.bending.curvature': ['curvature B', 'Krümmung B'], 'damage.bending.exponent': ['exponent m', 'Exponent m'],
  'damage.fatigue': ['Fatigue', 'Ermüdung'], 'damage.fatigue.thresholds': ['thresholds of Tγ', 'Schwellen von Tγ'], 'damage.fatigue.peak': ['peak', 'Höchstwert'], 'damage.fatigue.crack_growth': ['crack growth c_D', 'Risswachstum c_D'], 'damage.fatigue.crack_angle': ['crack angle α', 'Risswinkel α'], 'damage.fatigue.loss': ['loss', 'Verlust'],
  'map.wavelength': ['Wavelengths', 'Wellenlängen'], 'map.speed': ['Speeds', 'Geschwindigkeiten'],
  wheelset: ['Wheelset', 'Radsatz'], train: ['Train', 'Zug'], opposite_contact: ['Contact on the opposite rail', 'Kontakt auf der anderen Schiene'],
  'wheelset.mass': ['mass M', 'Masse M'], 'wheelset.roll_inertia': ['roll inertia J_x', 'Trägheit um x J_x'], 'wheelset.spin_inertia': ['spin inertia J_y', 'Trägheit um die Welle J_y'],
  'wheelset.model': ['model', 'Modell'], 'wheelset.contact_spacing': ['contact spacing 2s', 'Abstand der Kontakte 2s'], 'wheelset.normal_direction': ['direction of the normal force', 'Richtung der Normalkraft'], 'wheelset.opposite_rail': ['opposite rail', 'andere Schiene'], 'wheelset.rail': ['rail under study', 'betrachtete Schiene'],
  'wheelset.suspension': ['Primary suspension, per side', 'Primärfederung, je Seite'], 'wheelset.suspension.spacing': ['spacing', 'Abstand'], 'wheelset.axle': ['Axle', 'Welle'], 'wheelset.discs': ['discs', 'Scheiben'],
  'train.wheels': ['wheels behind the first', 'Räder hinter dem ersten'], 'train.comb': ['comb', 'Kamm'],
  'contact.creepage/table': ['Creepage in any direction', 'Schlupf in beliebiger Richtung'], 'opposite_contact.creepage/table': ['Creepage in any direction', 'Schlupf in beliebiger Richtung'],
  longitudinal: ['longitudinal ξ_x', 'längs ξ_x'], lateral: ['lateral ξ_y', 'quer ξ_y'], spin: ['spin φ', 'Bohrschlupf φ'],
  contact_angle: ['contact angle γ', 'Kontaktwinkel γ'], lateral_offset: ['lateral offset e', 'seitlicher Versatz e'],
  'contact.conformity': ['Contact that moves across the profiles', 'Kontakt, der quer über die Profile wandert'], rail_radius: ['head radius R_c', 'Kopfradius R_c'], cross_slope: ['cross slope of the ripple κ', 'Querneigung der Riffel κ'],
  transverse_radius: ['transverse radius R_r', 'Querradius R_r'], normal_load: ['normal load P₀', 'Radlast P₀'], friction: ['friction μ', 'Reibung μ'], creepage: ['creepage ξ₀', 'Schlupf ξ₀'],
  'rail.torsion_constant': ['torsion constant J', 'Drillwiderstand J'], 'rail.polar_second_moment': ['polar second moment I_p', 'polares Flächenmoment I_p'], 'rail.warping_constant': ['warping constant I_ω', 'Wölbwiderstand I_ω'],
  'rail.centroid_height': ['centroid above shear centre', 'Schwerpunkt über Schubmittelpunkt'], 'rail.head_height': ['head above shear centre h', 'Kopf über Schubmittelpunkt h'], 'rail.foot_depth': ['foot below shear centre d', 'Fuß unter Schubmittelpunkt d'], 'rail.foot_width': ['foot width B', 'Fußbreite B'],
  vertical_stiffness: ['vertical stiffness', 'Steifigkeit senkrecht'], longitudinal_damping: ['longitudinal damping', 'Dämpfung längs'], lateral_damping: ['lateral damping', 'Dämpfung quer'], vertical_damping: ['vertical damping', 'Dämpfung senkrecht'],
  diameter: ['diameter', 'Durchmesser'], length: ['length', 'Länge'], segments: ['segments', 'Abschnitte'], density: ['density ρ', 'Dichte ρ'], youngs_modulus: ["Young's modulus E", 'Elastizitätsmodul E'],
  poisson_ratio: ["Poisson's ratio ν", 'Querkontraktion ν'], shear_coefficient: ['shear coefficient κ', 'Schubbeiwert κ'],
  'track.pad.stiffness/slider': ['pad stiffness k', 'Steifigkeit der Zwischenlage k'],
  longitudinal_radius: ['longitudinal radius', 'Längsradius'], 'contact.from': ['Mean state from a curve', 'Mittlerer Zustand aus einem Bogen'], 'contact.from.curve': ['case file of the curve', 'Falldatei des Bogens'], 'contact.from.patch': ['patch', 'Kontaktfläche'],
  'contact.conformity.rolling_radius': ['rolling radius', 'Rollradius'], rail_roll: ['rail roll', 'Verdrehung der Schiene'],
  curve: ['Curve', 'Bogen'], 'curve.theory': ['theory', 'Theorie'], 'curve.radius': ['radius R', 'Radius R'], 'curve.cant': ['cant', 'Überhöhung'], 'curve.speed': ['speed V', 'Geschwindigkeit V'],
  bogie: ['Bogie', 'Drehgestell'], 'bogie.wheelsets': ['wheelsets', 'Radsätze'], wheelbase: ['wheelbase 2a', 'Achsabstand 2a'], primary_spacing: ['spacing of the axle boxes 2b', 'Abstand der Achslager 2b'],
  primary_longitudinal_stiffness: ['primary stiffness, along', 'Primärsteifigkeit längs'], primary_lateral_stiffness: ['primary stiffness, across', 'Primärsteifigkeit quer'], mass_per_axle: ['mass per axle', 'Masse je Achse'],
  centre_of_mass_height: ['height of the centre of mass', 'Höhe des Schwerpunkts'], frame_yaw_moment: ['yaw moment on the frame', 'Giermoment am Rahmen'], frame_yaw: ['yaw of the frame', 'Gierwinkel des Rahmens'],
  frame_lateral_shift: ['lateral shift of the frame', 'Querversatz des Rahmens'], drive_torque: ['drive torques', 'Antriebsmomente'],
  body: ['Body on two bogies', 'Wagenkasten auf zwei Drehgestellen'], bogie_spacing: ['spacing of the bogies 2l', 'Drehzapfenabstand 2l'], secondary_lateral_stiffness: ['secondary stiffness, across', 'Sekundärsteifigkeit quer'], secondary_yaw_stiffness: ['secondary stiffness, yaw', 'Drehsteifigkeit der Sekundärstufe'],
  profiles: ['Profiles', 'Profile'], 'profiles.rail/table': ['A profile for each rail', 'Ein Profil je Schiene'], 'profiles.rail.left': ['left rail', 'linke Schiene'], 'profiles.rail.right': ['right rail', 'rechte Schiene'],
  'profiles.scatter': ['scatter of the points', 'Streuung der Punkte'], wheel_orientation: ['orientation of the wheel', 'Lage des Radprofils'], rail_orientation: ['orientation of the rail', 'Lage des Schienenprofils'],
  left_wheel: ['profile of the left wheels', 'Profil der linken Räder'],
  gauge: ['gauge', 'Spurweite'], gauge_height: ['depth of the gauge', 'Messtiefe der Spurweite'], inclination: ['inclination of the rails', 'Schienenneigung'], flange_back_distance: ['distance of the flange backs', 'Abstand der Spurkranzrücken'],
  flange_back_position: ['place of the flange back', 'Ort des Spurkranzrückens'], conicity: ['conicity λ', 'Konizität λ'], flange: ['Flange of cones', 'Spurkranz von Kegeln'], clearance: ['clearance', 'Spiel'], slope: ['slope', 'Neigung'],
  shift: ['shift', 'Versatz'], width: ['width', 'Breite'], contact_plane: ['plane of contact', 'Kontaktebene'], contact_shift_moment: ['moment of shifted contacts', 'Moment verschobener Kontakte'],
  preset: ['preset', 'Vorgabe'], stiffness: ['stiffness k', 'Steifigkeit k'], damping: ['damping c', 'Dämpfung c'], loss_factor: ['loss factor η', 'Verlustfaktor η'],
  lateral_stiffness: ['lateral stiffness', 'Steifigkeit quer'], longitudinal_stiffness: ['longitudinal stiffness', 'Steifigkeit längs'], mass: ['mass', 'Masse'],
  min: ['from', 'von'], max: ['to', 'bis'], points: ['points', 'Punkte'],
};

/** Names that several groups have. */
const GENERAL = new Set(['preset', 'model', 'section', 'beam', 'density', 'loss_factor', 'area', 'grid', 'rotation', 'response', 'hertz', 'mass_per_length']);

const known = (language) => language in WORDS;
let language = [localStorage.getItem('riffel-language'), navigator.language?.slice(0, 2)].find((name) => name && known(name)) ?? 'en';

export const currentLanguage = () => language;

export function chooseLanguage(name) {
  if (!known(name)) return;
  language = name;
  localStorage.setItem('riffel-language', name);
  translate();
}

/** A word or, for those that take values, a sentence. */
export function t(key, values) {
  const word = WORDS[language][key] ?? WORDS.en[key] ?? key;
  return typeof word === 'function' ? word(values) : word;
}

/** For words that take two values. */
export const t2 = (key, a, b) => WORDS[language][key](a, b);

/** Name of a key of the case. */
export function nameOf(key) {
  const names = NAMES[key] ?? NAMES[key.split('.').at(-1)];
  return names ? names[language === 'de' ? 1 : 0] : key.split('.').at(-1).replaceAll('_', ' ');
}

/** A key as a sentence names it: with its group where the name alone would not tell, as in "Wavelengths, points". */
export function labelOf(key) {
  const parts = key.split('.');
  const alone = NAMES[key] && !GENERAL.has(parts.at(-1));
  return alone || parts.length < 2 ? nameOf(key) : `${nameOf(parts.slice(0, -1).join('.'))}, ${nameOf(key)}`;
}

/** Keys that are in one language and not in the other. */
export const gaps = () => Object.keys({ ...WORDS.en, ...WORDS.de }).filter((key) => !(key in WORDS.en && key in WORDS.de) || typeof WORDS.en[key] !== typeof WORDS.de[key]);

/** Put the words of the present language into the page: data-t for text, data-t-label for labels. */
export function translate(root = document) {
  document.documentElement.lang = language;
  for (const element of root.querySelectorAll('[data-t]')) element.textContent = t(element.dataset.t);
  for (const element of root.querySelectorAll('[data-t-label]')) element.setAttribute('aria-label', t(element.dataset.tLabel));
  for (const element of root.querySelectorAll('[data-t-title]')) element.title = t(element.dataset.tTitle);
  for (const element of root.querySelectorAll('[data-name]')) element.textContent = nameOf(element.dataset.name);
}

/** A number with so many significant digits, in the manner of the language. */
export function number(value, digits = 3) {
  if (!Number.isFinite(value)) return '–';
  const size = value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value)));
  if (size >= 6 || size < -4) return power(value);
  const decimals = Math.max(0, digits - 1 - size);
  const rounded = Number(value.toPrecision(Math.max(digits, size + 1))) || 0;
  return rounded.toLocaleString(language, { maximumFractionDigits: Math.min(12, decimals), useGrouping: Math.abs(rounded) >= 1e4 }).replace('-', '−');
}

/** A range by its ends as they are written, one where both are written alike. */
export function range([low, high], shown = (value) => number(value)) {
  const [from, to] = [shown(low), shown(high)];
  return from === to ? from : `${from}–${to}`;
}

/** Units of speed with their size in m/s. */
export const SPEED_UNITS = { 'km/h': 1 / 3.6, 'm/s': 1, mph: 0.44704 };
let speedUnit = 'km/h';
export function chooseSpeedUnit(name) {
  if (!(name in SPEED_UNITS)) return;
  speedUnit = name;
  localStorage.setItem('riffel-speed', name);
}
chooseSpeedUnit(localStorage.getItem('riffel-speed'));

/** Unit of speeds and its size in m/s. */
export const unitOfSpeed = () => [speedUnit, SPEED_UNITS[speedUnit]];

/** A speed [m/s] in that unit. */
export const speed = (value) => `${number(value / SPEED_UNITS[speedUnit])} ${speedUnit}`;

/** A piece of what the program says, which has km/h, with its speeds in that unit. */
export function inUnits({ text, speeds_m_per_s: speeds }) {
  return speeds && speedUnit !== 'km/h' ? `${range([speeds[0], speeds.at(-1)], (value) => number(value / SPEED_UNITS[speedUnit]))} ${speedUnit}` : text;
}
export const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}.`;

/** A number as it stands in a case, with the comma of the language. */
export const written = (text) => (language === 'de' ? String(text).replace(/(\d)\.(\d)/g, '$1,$2') : String(text));

const RAISED = { '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };

/** A number with a power of ten. */
export function power(value, digits = 2) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
  const raised = [...String(Number(exponent))].map((c) => RAISED[c]).join('');
  return `${Number(mantissa).toLocaleString(language, { minimumFractionDigits: digits - 1 }).replace('-', '−')}·10${raised}`;
}

/** Size of a file. */
export const fileSize = (bytes) => (bytes < 1000 ? `${bytes} B` : bytes < 100_000 ? `${number(bytes / 1e3)} kB` : `${number(bytes / 1e6)} MB`);

/** A count of passages in words: 4.6 million. */
export function passages(count) {
  if (!Number.isFinite(count)) return '–';
  const [unit, word] = [[1e9, { en: 'billion', de: 'Milliarden' }], [1e6, { en: 'million', de: 'Millionen' }], [1, { en: '', de: '' }]].find(([unit]) => count >= unit) ?? [1, { en: '', de: '' }];
  return `${number(Number((count / unit).toPrecision(2)), 2)} ${word[language]}`.trim();
}
