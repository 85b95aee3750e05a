"""A program whose names mean something in C, C++ or Python, or in what `proskill stubs` writes."""

STARTS = """x_value x_result skill_x_ Arguments Outcome Result StopResult Robot NotImplementedError Actions makeActions Run class
 lambda string std __init__ __linux__ _ CLOCK_REALTIME alloca register platform platform_of _abc_impl interrupt robot event offsetof""".split()
MISSION = r"""
(defsv stop :states (Stop stop EOF EINTR _ __2) :init Stop :transitions :all)
(defsv read_a :states (x y) :init x)
(defsv a :states (x y) :init x)
(defsv skill_x :states (value result) :init value)
(defsv proskill :states (run boolean) :init run)
(defsv PROSKILL :states (BOOLEAN ABI) :init ABI)
(defsv INT :states (MAX MIN) :init MAX)
(defsv int64 :states (max min) :init max)
(defsv ACTIONS :states (H HPP) :init H)
(defsv robot :states (skill event) :init skill)
(defsv FILE :states (None True) :init None)
(defsv not_implemented_error :states (mro name) :init mro)
(defsv _3 :states (_x_ x) :init x)
(defsv stdin :states (EOF NULL linux) :init NULL)
(defevent report :effects (stop EOF))
(defevent touched :effects (stop Stop))
(defskill Stop :input ($Stop stop $stop stop $std float $proskill string $int64_t int $text string $bool bool)
  :action (x $Stop $stop $std $proskill $int64_t $text $bool) :interrupt ()
  :success (Stop stop Result Arguments Outcome) :failure (INT_MAX EOF None mro NULL stderr))
(defskill halt :input ($stop_value stop $Stop stop $other stop $actions stop $self int $arguments int $count int $run int
                       $Run int $made int $perform_Stop int $HALT_WAS_STOPPED int $FlyResult int)
  :action (x $stop_value $Stop $other $actions $self $arguments $count $run $Run $made $perform_Stop $HALT_WAS_STOPPED $FlyResult))
(defskill b :input ($a read_a $b a $c skill_x $d proskill $e PROSKILL $f INT $g int64 $h ACTIONS $i robot $j FILE
                    $k not_implemented_error $l _3
                    $stdin stdin $errno int)
  :action (x $a $b $c $d $e $f $g $h $i $j $k $l $stdin $errno) :interrupt ())
SKILLS
(defskill mission :success done :body (
  (Stop Stop Stop stop Stop std 1 proskill "a" int64_t 2 text "b" bool true)
  (halt stop_value stop Stop EOF other Stop actions Stop self 1 arguments 1 count 1 run 1 Run 1 made 1 perform_Stop 1
        HALT_WAS_STOPPED 1 FlyResult 1)
  (b a x b x c value d run e ABI f MAX g max h H i skill j None k mro l x stdin EOF errno 1)
  CALLS (success done)))
""".replace("SKILLS", "\n".join(f"(defskill {name} :action (x) :success touched)" for name in STARTS)).replace(
    "CALLS", " ".join(f"({name})" for name in STARTS))
ACTIONS = 3 + len(STARTS)
