package org.sami.spn.model;

/** Whether a transition fires per occurrence or once with all (SEMANTICS, Input events). */
public enum WaitFor {
    EACH,
    ALL
}
