package org.sami.crw.gui;

import javax.swing.JLabel;
import org.sami.ui.check.WindowRobot;

/** Gives a robot the time that a person takes to read a question: a press that comes sooner answers nothing. */
public final class ReadQuestion {
    private ReadQuestion() {}

    /** Waits until the question that is shown has been there for a while, as it says itself. */
    public static void await(WindowRobot robot) {
        JLabel age = robot.find(JLabel.class, "decision-age");
        robot.until("the question can be read", () -> isPast(age));
    }

    /** Whether its age, as a label of the panel says it, is past that. */
    static boolean isPast(JLabel age) {
        return !age.getText().matches(".*asked [01] s ago");
    }
}
