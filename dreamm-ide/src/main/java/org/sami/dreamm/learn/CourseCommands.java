package org.sami.dreamm.learn;

import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;

/** The commands that lead into the course and out of it. */
public final class CourseCommands {
    private CourseCommands() {}

    /**
     * Adds the one that a window has.
     *
     * @param inCourse whether the window is one of the course
     */
    public static void addTo(CommandRegistry commands, CourseAccess access, boolean inCourse) {
        if (inCourse) {
            commands.add(new Command("learn-leave", "Leave the course", access::leave)
                    .withKey("alt shift Q")
                    .withIcon("close"));
        } else {
            commands.add(new Command("learn-open", "Open the course", access::enter)
                    .withKey("ctrl L")
                    .withIcon("help")
                    .unless(access::whyNot));
        }
    }
}
