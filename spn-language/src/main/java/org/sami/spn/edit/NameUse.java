package org.sami.spn.edit;

import org.sami.spn.model.Plan;

/**
 * One place in a plan where a name stands.
 *
 * @param of the plan to which the name belongs: the plan itself, or one that it runs as a sub-mission; empty text of plans, event types and
 *     interrupts, which belong to none
 * @param element id of the vertex, edge, event or sub-mission, or name of the variable or task, in which it stands; empty text where
 *     it stands in none
 * @param where in words, such as {@code field speed}
 */
record NameUse(Kind kind, String name, String of, String element, String where) {
    /** In which words a name stands where the element of that name itself is. */
    static final String ITSELF = "its own name";

    /** What kind of name it is. */
    enum Kind {
        /** The id of a vertex, edge, event or sub-mission. */
        ELEMENT,
        VARIABLE,
        TASK,
        PLAN,
        INTERRUPT,
        EVENT_TYPE
    }

    boolean is(Kind other, String otherName, Plan plan) {
        return kind == other && name.equals(otherName) && of.equals(plan.id());
    }
}
