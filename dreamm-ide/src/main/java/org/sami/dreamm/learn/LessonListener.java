package org.sami.dreamm.learn;

/** Hears where a learner is, and what is said of answers. */
public interface LessonListener {
    /** Another step of the same lesson is shown. */
    default void stepChanged() {}

    /** A step of another lesson is shown: the window is opened again in the mode of that lesson. */
    default void lessonChanged() {}

    /** Something about the step that is shown has changed. */
    default void changed() {}
}
