package org.sami.crw.gui.robot;

import java.util.Objects;

/**
 * One thing that is done to the window, and what must hold after it; the act fails where it does not.
 *
 * @param name what is done, as docs/robot-run.md lists it
 * @param holds what must hold after it, in words
 */
record RobotRow(String name, String holds, Act act) {
    /** What the robot does, and looks at. */
    interface Act {
        /** Does it.
         *
         * @throws Exception if the window, its session or a peer does not do what they are there for
         */
        void on(RobotWorld world) throws Exception;
    }

    RobotRow {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(holds, "holds");
        Objects.requireNonNull(act, "act");
    }

    @Override
    public String toString() {
        return name;
    }
}
