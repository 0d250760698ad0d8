package org.sami.spn.plannet;

/** How a net follows robots. */
enum RobotView {
    /** A place for each robot in each place of the plan. */
    NAMED,
    /** A place says how many robots stand in a place of the plan. */
    COUNTED,
    /** A place says whether any robot stands in a place of the plan. */
    PRESENT
}
