// A program of thousands of lines, whose trace is at its beginning.

const skill = (i) => `(defsv place_${i} :states (Free Taken Lost) :init Free
  :transitions ((Free Taken) (Taken Free) (Taken Lost)))
(defskill take_${i}
  :precondition (free (place_${i} Free))
  :time_interval [1,3]
  :action (take)
  :success taken
    (:effects (place_${i} Taken))
  :failure missed)
(defskill drop_${i}
  :precondition (taken (place_${i} Taken))
  :time_interval [1,2]
  :action (drop)
  :success dropped
    (:effects (place_${i} Free))
  :failure lost
    (:effects (place_${i} Lost)))
(defskill move_${i}
  :success done
  :body
    ((take_${i})
     (if (place_${i} Taken)
        (drop_${i}))
     (success done)))

`;

const head = (count) => `; Made for the tests: a mission that opens the lid, and then takes and drops many things.
(defsv lid :states (Open Shut) :init Shut :transitions ((Shut Open) (Open Shut)))
(defskill open_lid :time_interval [1,2] :action (open) :success open (:effects (lid Open)))
(defskill mission
  :success done
  :body
    ((move_1)
     (open_lid)
${Array.from({ length: count - 1 }, (_, i) => `     (move_${i + 2})`).join('\n')}
     (success done)))
(defproperty stays_shut (always (lid Shut)))

`;

/** At least this many lines, with the skills in the order of their calls, or the first one last. */
export function largeProgram(lines, order = 'called') {
  const count = Math.max(2, Math.ceil((lines - 10) / 26));
  const skills = Array.from({ length: count }, (_, i) => skill(i + 1));
  return head(count) + (order === 'called' ? skills : skills.reverse()).join('');
}
