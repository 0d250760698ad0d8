package org.sami.dreamm.learn;

import java.util.Optional;
import org.sami.dreamm.help.word.GlossaryAccess;

/** The way into the course from a window, and out of it: the window is opened again. On the event thread. */
public interface CourseAccess extends GlossaryAccess {
    /** Why the course cannot be opened, in a sentence; empty where it can. */
    @Override
    Optional<String> whyNot();

    /** Opens the course in place of what is open, once nothing of that is lost. */
    void enter();

    /** Leaves the course: the window shows the library of plans, with all that it has. */
    void leave();
}
