"""What a goal says about how the test's server behaves."""

(SUCCEED, WAIT, PEND, ABORT, REJECT, TWICE, LOSE_RESULT, TALK, DIE, LATE_GOAL, LATE_RESULT, DEAF,
 DIE_ON_CANCEL) = range(13)
