package org.sami.spn.plannet;

import org.sami.spn.flow.TokenType;

/**
 * A token that a net follows.
 *
 * @param name a robot's or a task's name; {@code generic} for the generic one
 * @param taskClass of a task; else empty
 * @param isMade whether it is a task that the mission makes while it runs
 */
record PlanToken(TokenType type, String name, String taskClass, boolean isMade) {
    static final PlanToken GENERIC = new PlanToken(TokenType.GENERIC, "generic", "", false);

    /** Any robot, where they are counted and not named. */
    static final PlanToken ROBOTS = new PlanToken(TokenType.PROXY, "robots", "", false);

    static PlanToken robot(String name) {
        return new PlanToken(TokenType.PROXY, name, "", false);
    }

    static PlanToken task(String name, String taskClass) {
        return new PlanToken(TokenType.TASK, name, taskClass, false);
    }

    static PlanToken madeTask(int number, String taskClass) {
        return new PlanToken(TokenType.TASK, "made-" + number, taskClass, true);
    }

    /** As the net's places and people name it. */
    String label() {
        return type == TokenType.TASK ? "#" + name : name;
    }

    boolean isTask(String nameOrClass) {
        return type == TokenType.TASK && (name.equals(nameOrClass) || taskClass.equals(nameOrClass));
    }
}
