package org.sami.dreamm.learn;

import java.util.Optional;

/** The way into the course from a window, and out of it: the window is opened anew. On the event thread. */
public interface CourseAccess {
    /** Why the course cannot be opened, in a sentence; empty where it can. */
    Optional<String> whyNot();

    /** Opens the course in place of what is open, once nothing of that is lost. */
    void enter();

    /** Leaves the course: the window shows the library of plans, with all that it has. */
    void leave();
}
