// A crane in a workshop, which people or a program may control.
type {
    Float
    Position
}

skillset crane {
    data {
        position: Position period 0.5
    }

    resource {
        control {
            state { People Program }
            initial People
            transition all
        }
        motion {
            state { Idle Moving }
            initial Idle
            transition all
        }
        hook {
            state { Empty Loaded }
            initial Empty
            transition all
        }
        battery {
            state { Good Low Critical }
            initial Good
            transition {
                Good -> Low
                Low -> Critical
                Low -> Good
                Critical -> Good
            }
        }
    }

    event {
        people_take_over {
            guard control != People
            effect control -> People
        }
        program_takes_over {
            guard control == People and motion == Idle
            effect control -> Program
        }
        battery_gets_low {
            guard battery == Good
            effect battery -> Low
        }
        battery_gets_critical {
            guard battery == Low
            effect battery -> Critical
        }
        battery_is_changed {
            guard battery != Good and motion == Idle
            effect battery -> Good
        }
    }

    skill move_to {
        input target: Position
        output distance: Float
        precondition {
            in_control: control == Program
            standing: motion == Idle
            enough_power: battery == Good
        }
        start motion -> Moving
        invariant {
            in_control {
                guard control == Program
                effect motion -> Idle
            }
            power {
                guard battery != Critical
                effect motion -> Idle
            }
        }
        progress {
            period 1 sec
            message distance: Float
        }
        interrupt {
            interrupting true
            effect motion -> Idle
        }
        success arrived {
            effect motion -> Idle
        }
        failure blocked {
            effect motion -> Idle
        }
    }

    skill grab {
        precondition {
            in_control: control == Program
            standing: motion == Idle
            room: hook == Empty
        }
        start motion -> Moving
        invariant in_control {
            guard control == Program
            effect motion -> Idle
        }
        success {
            grabbed {
                effect {
                    motion -> Idle
                    hook -> Loaded
                }
            }
        }
        failure nothing_there {
            effect motion -> Idle
        }
    }

    skill release {
        precondition {
            in_control: control == Program
            standing: motion == Idle
            something: hook == Loaded
        }
        success released {
            effect hook -> Empty
            postcondition hook == Empty
        }
    }
}
