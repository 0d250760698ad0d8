package org.sami.crw.task;

import org.sami.spn.value.TaskId;

/**
 * One thing that happened to a task (appendix .2.2, Tasks).
 *
 * @param boat the boat that it is about: the new one of a reassigned task, the former one of a released task; empty text where it
 *     is about none
 */
public record TaskNews(Kind kind, TaskId task, String boat) {
    /** What happened, in the order in which news of one moment is published. */
    public enum Kind {
        /** The boat is no longer responsible for it. */
        RELEASED("TaskReleased"),
        /** No boat is. */
        UNASSIGNED("TaskUnassigned"),
        /** Another boat is. */
        REASSIGNED("TaskReassigned"),
        /** It has moved backwards in the queue of its boat. */
        DELAYED("TaskDelayed"),
        /** It is the first in the queue of its boat now. */
        STARTED("TaskStarted");

        private final String event;

        Kind(String event) {
            this.event = event;
        }

        /** The input event of that name. */
        public String event() {
            return event;
        }
    }
}
