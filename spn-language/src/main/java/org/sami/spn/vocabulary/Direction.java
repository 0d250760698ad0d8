package org.sami.spn.vocabulary;

/** On which kind of vertex an event stands (thesis 3.1, Events). */
public enum Direction {
    /** On a place: a command or request to a robot, the operator or a service. */
    OUTPUT,
    /** On a transition: an answer or news. */
    INPUT
}
